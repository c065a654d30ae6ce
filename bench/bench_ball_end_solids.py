# Chips of ball-end tools beside the same chips as solids of OpenCASCADE's: the source's 1260, on
# all cores. How far the model is from the solids, how many of these are flagged, and why.
import itertools
import sys
import time
from collections import Counter

import numpy
from evenload import ball_end
from evenload.ball_end import solids, source

PLACES = 10  # on each side of the middle, a pitch apart: 21 [Varga 2023, 4.1]
# Each figure's name in the table, and what may be the worst deviation of the two.
ALLOWED = {
    "volume": "0.3 %",
    "previous_face": "0.5 %",
    "tool_face": "0.5 %",
    "mean_thickness": "0.5 %",
    "max_thickness": "",
}
WORDS = "surface tool_diameter feed_per_tooth stepover axial_depth feed_direction position uncut"


def cases():
    """The arguments of 1260 chips, of which every other one lies left of its pass."""
    grid = itertools.product(
        ("CX", "CV"), range(-PLACES, PLACES + 1), source.DIRECTIONS, source.PAIRS
    )
    for number, (part, place, direction, (feed, stepover)) in enumerate(grid):
        row = (
            *(("test part", part), source.DIAMETER, feed, stepover, source.ALLOWANCE),
            *(direction, source.PITCH * place, ("right", "left")[number % 2]),
        )
        yield dict(zip(WORDS.split(), row))


class Progress:
    """Tells each further percent."""

    told = -1

    def __call__(self, share):
        if int(100 * share) > self.told:
            self.told = int(100 * share)
            print("%3d %% of the solids" % self.told, end="\r", file=sys.stderr, flush=True)
        return True


def figures():
    rows = list(cases())
    start = time.perf_counter()
    found = solids.chips(rows, Progress())
    yield "ball_end.solids.seconds", time.perf_counter() - start, "s"
    yield "ball_end.solids.chips", len(rows), ""
    reasons = Counter(solid.flagged for solid in found if solid.flagged)
    yield "ball_end.solids.flagged", sum(reasons.values()), ""
    for reason, count in reasons.items():
        yield "ball_end.solids.flagged: %s" % reason, count, ""
    pairs = [
        (solid, ball_end.chip(**row), row) for solid, row in zip(found, rows) if not solid.flagged
    ]
    for name in ALLOWED:
        off = 100 * numpy.array(
            [abs(getattr(chip, name) / getattr(solid, name) - 1) for solid, chip, _ in pairs]
        )
        yield "ball_end.solids.%s.worst" % name, off.max(), "%"
        yield "ball_end.solids.%s.95_percent" % name, numpy.percentile(off, 95), "%"
        worst = pairs[int(off.argmax())][2]
        print("%s is furthest off at %s" % (name, worst), file=sys.stderr)


def table(values):
    """The table of docs/chip_model.md."""
    name = "ball_end.solids.%s"
    counts = [values[name % each] for each in ("chips", "flagged")]
    yield "%d chips as OpenCASCADE's solids, %d of them flagged:" % tuple(counts)
    yield ""
    yield "| deviation of the chip model | required | worst | 95 % of chips below |"
    yield "|---|---|---|---|"
    for figure, allowed in ALLOWED.items():
        ends = [values[name % ("%s.%s" % (figure, end))] for end in ("worst", "95_percent")]
        yield "| %s | %s | %.3f %% | %.3f %% |" % (figure.replace("_", " "), allowed, *ends)
