"""What is told of each strategy: times, chips, cusps and force along the path that it makes."""

import dataclasses
from copy import copy

import numpy

from evenload import compiled, waiting
from evenload.advisor import bent_faces
from evenload.advisor.reading import read
from evenload.advisor.strategies import STRATEGIES
from evenload.ball_end import loads, places
from evenload.operations import finishing
from evenload.operations.refusal import Cancelled
from evenload.settings.labels import told
from evenload.tool import ASSUMED_RAPID, on_teeth

PLACES = 400  # along each path
PATH_SHARE = 0.7  # of a strategy's time that its path takes, about
SECONDS_PER_MINUTE = 60.0


@dataclasses.dataclass(frozen=True)
class Advice:
    """One strategy on the faces; what is unknown is None, and all of it where there is a refusal.

    strategy: a Strategy. seconds: of the path at its feeds; machine_seconds: within a machine's
    limits. mean_thickness, scatter: mean and standard deviation of the source's h_m along the
    path, mm; max_thickness: the largest h_max, mm. mean_cusp, max_cusp: mm. tip_share: the largest
    share of a chip that the tip cuts, 0 to 1; least_speed: the least cutting speed of the working
    edge, m/min. impulse: of the force, N s. refusal: a sentence why there is no such path;
    notes: sentences on what is not counted.
    """

    strategy: object
    seconds: float = None
    machine_seconds: float = None
    mean_thickness: float = None
    scatter: float = None
    max_thickness: float = None
    mean_cusp: float = None
    max_cusp: float = None
    tip_share: float = None
    least_speed: float = None
    impulse: float = None
    refusal: str = ""
    notes: tuple = ()


def advice(owner, faces=None, strategies=STRATEGIES, **asked):
    """[Advice, ...], one for each strategy; see reading.read for the other arguments.

    Asks waiting.go_on all along and raises waiting.Stopped where it shall not go on.
    """
    return list(answers(read(owner, faces, **asked), strategies))


def answers(question, strategies=STRATEGIES):
    """Yields the Advice on a Question's faces for one strategy after the other; any thread may do
    it. Raises ValueError with a sentence where the faces can be finished by none.
    """
    question.facets  # once and here: what is wrong with them is no strategy's own
    for number, strategy in enumerate(strategies):
        yield _answer(question, strategy, number, len(strategies))


def _answer(question, strategy, number, count):
    try:
        return advice_on(question, strategy, _watch(number, count))
    except Cancelled:
        raise waiting.Stopped() from None
    except ValueError as error:
        return Advice(strategy, refusal=told(str(error)))


def _watch(number, count):
    """Who is asked while one of several strategies is under way, with the share of all."""
    asked = waiting.asked()
    return asked and (lambda share: asked((number + share) / count))


def advice_on(question, strategy, watch=None):
    """The Advice on one strategy. watch: callable(share) -> whether to go on. Raises ValueError
    with a sentence where it has no path, or no chip, Cancelled or waiting.Stopped where it was
    stopped.
    """
    settings = copy(question.settings)
    for name, value in strategy.settings.items():
        setattr(settings, name, value)
    finishing.check(settings, question.tool)
    arguments = finishing.arguments_of(settings, question.tool, question.data, question.facets)
    task = finishing.Task(question.facets, settings, question.tool, question.data, arguments, [])
    made = task.run(watch and (lambda share: watch(PATH_SHARE * share)))
    with waiting.asking(watch and (lambda share: watch(PATH_SHARE + (1 - PATH_SHARE) * share))):
        felt, length = _loads(question, arguments, made)
    return _told(question, strategy, made, felt, length)


def _loads(question, arguments, made):
    """(Loads at those of PLACES that lie on the faces, mm of cuts) along a Computation's path."""
    stepover = max(made.finish.largest_stepover, arguments["stepover"])
    found, felt = loads_along(
        question, question.facets.mesh, arguments, made.toolpath.moves, stepover, PLACES
    )
    return felt, found.length


def loads_along(question, mesh, arguments, moves, stepover, count):
    """(Places, Loads) at those of `count` places along a path that lie on a Question's faces.

    mesh: the core's, of the faces; arguments: of the core's finish(); moves: as the core has them;
    stepover: mm in plan, the largest. Raises ValueError with a sentence where there is none.
    """
    found = places.places_along(moves, count, stepover)
    allowance = arguments["allowance"]
    contacts = compiled.core().surface.contacts(
        mesh,
        *(arguments["tool_diameter"] + 2 * allowance, arguments["corner_radius"] + allowance),
        *(found.tips[:, :2], arguments["floor"] - allowance),
    )
    touches = (contacts[:, 1] > 0) & (contacts[:, 2] > 0)
    if not touches.any():
        raise ValueError("The tool touches the faces nowhere but at their borders.")
    found, contacts = found.only(touches), contacts[touches]
    bends, is_face = bent_faces.bends_at(
        question.faces, contacts[:, 3:6], contacts[:, 6:9], allowance
    )
    if not is_face.any():
        raise ValueError("The tool touches the faces nowhere but at edges.")
    found, bends = found.only(is_face), bends.only(is_face)
    felt = loads.loads_at(found, bends, question.cutting)
    return found.only(felt.rows), felt


def _told(question, strategy, made, felt, length):
    """The Advice of what was felt; places are as far from each other along the path, so that each
    weighs the same. The force impulse is the integral of the force over the time of the cuts
    [Varga 2023, 7, formula 10].
    """
    known = len(felt.mean_thickness)
    per_newton = SECONDS_PER_MINUTE * length / known / felt.feeds
    cusps = felt.cusp[numpy.isfinite(felt.cusp)]
    notes = [*felt.refusals, *on_teeth(question.tool)]
    if known < PLACES:
        notes.insert(
            0,
            "%d of %d places along the path are not counted: the tool is at an edge or border "
            "there, or takes no chip that is known." % (PLACES - known, PLACES),
        )
    return Advice(
        strategy,
        seconds=made.toolpath.report.cutting_time,
        machine_seconds=_machine_seconds(question, made.toolpath),
        mean_thickness=float(felt.mean_thickness.mean()),
        scatter=float(felt.mean_thickness.std()),
        max_thickness=float(felt.max_thickness.max()),
        mean_cusp=float(cusps.mean()) if len(cusps) else None,
        max_cusp=float(cusps.max()) if len(cusps) else None,
        tip_share=float(felt.tip_share.max()),
        least_speed=float(felt.least_speed.min()),
        impulse=float((felt.force * per_newton).sum()),
        notes=tuple(notes),
    )


def _machine_seconds(question, toolpath):
    """s within the limits of the machine, as the simulator has them; None without a machine."""
    if question.machine is None:
        return None
    core = compiled.core()
    limits = dict(question.machine)
    rapid = question.data.rapid_feed or ASSUMED_RAPID
    limits["rapid_feed"] = min(limits["rapid_feed"], rapid)
    start, duration, *_ = core.machine_time(toolpath.moves, core.MachineProfile(**limits))[-1]
    return start + duration
