"""What Show Surface computes, in a thread: the map of the surface, then the chips and the roughness
on it.
"""

from dataclasses import dataclass

from evenload import surface_simulation, waiting
from evenload.gui.surface_measures import CHIPS, MAP, MEASURES, ROUGHNESS

# Of the time, about: what has been done at the end of the map and of the chips.
MAP_SHARE, CHIPS_SHARE = 0.3, 0.6


@dataclass(frozen=True)
class Known:
    """A SurfaceSimulation and what is known of it by now: the cells' values by the measures' keys;
    refusals: sentences why others are not.
    """

    found: object
    values: dict
    refusals: tuple = ()


def results(question, told):
    """Yields what is Known of the surface of a Question: without the chips, with them, and with the
    roughness. told: called with the share that is done, in the thread of the task.
    """
    with _telling(told, 0.0, MAP_SHARE):
        found = surface_simulation.simulated(question)
    known = Known(found, _values(found, MAP))
    yield known
    for step, begin, end in ((CHIPS, MAP_SHARE, CHIPS_SHARE), (ROUGHNESS, CHIPS_SHARE, 1.0)):
        told(begin)
        with _telling(told, begin, end):
            known = _with(known, step)
        yield known


def _with(known, step):
    """The Known with the values of a further step, or the sentence why there are none."""
    try:
        values = {**known.values, **_values(known.found, step)}
    except ValueError as error:
        return Known(known.found, known.values, (*known.refusals, str(error)))
    notes = known.found.roughness_map.notes if step == ROUGHNESS else ()
    return Known(known.found, values, (*known.refusals, *notes))


def _values(found, step):
    return {each.key: each.of(found) for each in MEASURES if each.step == step}


def _telling(told, begin, end):
    """While this lasts shares of a step are told as those of all, and never less than before."""
    asked, done = waiting.asked(), begin

    def watch(share):
        nonlocal done
        done = max(done, begin + (end - begin) * share)
        told(done)
        return asked(share)

    return waiting.asking(watch)
