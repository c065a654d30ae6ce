"""Whether a random job's operations are right: each has a path without fault, or a sentence."""

from dataclasses import dataclass

from evenload import tool as tools
from evenload.geometry import shape
from occt_judge import collisions, gouges, moves_of

# How sentences of the check begin. They are exact, but a path that the product makes by itself must
# not have to be refused.
FAULTS = ("The path cuts", "The path has a rapid", "The path plunges", "The path of")


@dataclass
class Verdict:
    is_right: bool
    words: str


def judged(made):
    """A Verdict on each operation of a random_jobs.Job, which has been recomputed."""
    result, earlier = [], list(made.earlier)
    for op in made.operations:
        if not op.isValid() or len(op.Path.Commands) < 3:
            said = op.Report
            is_right = bool(said) and not said.startswith(("EvenLoad failed", *FAULTS))
            result.append(Verdict(is_right, "%s refused: %s" % (op.Proxy.name, said)))
            continue
        radius = tools.diameter(op.ToolController) / 2
        moves = moves_of(op.Path.Commands)
        found = (
            [] if _cuts_the_model(op) else gouges(moves, made.models, radius, op.Tolerance.Value)
        )
        words = ["gouge of %.4f mm3 at %s" % (volume, move.end) for volume, move in found[:1]]
        met = collisions(moves, made.stock, radius, earlier)
        words += ["%.4f mm3 in the way to %s" % (volume, move.end) for volume, move in met[:1]]
        earlier.append((moves, radius))
        name = "%s, %d moves" % (op.Proxy.name, len(moves))
        result.append(Verdict(not words, ", ".join([name, *words])))
    return result


def _cuts_the_model(op):
    """Whether an operation is told to: by a sketch, or by a depth below all faces."""
    is_drawn = any(not obj.Shape.Solids for obj, _ in op.Base)
    return is_drawn or op.FinalDepth.Value < min(shape.heights(op.Base)) - 1e-3
