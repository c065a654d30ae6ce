"""What was cut beforehand, taken out of a stock: its loads are not looked at. Needs no FreeCAD."""

import numpy

from evenload import compiled, planar

# Share of a tool's diameter between looks at its load where that does not matter; what it sweeps is
# exact at any.
COARSE = 0.25


def take(stock, cuts, going):
    """Takes out of a DexelStock what [(moves, tool diameter in mm), ...] cut. Gives whether that
    was all of it.

    going: callable(share of the cuts' length that is done) -> whether to go on.
    """
    core, answers = compiled.core(), [True]
    ends = numpy.cumsum([0.0, *(length_of(moves) for moves, _ in cuts)])
    ends /= max(ends[-1], 1e-9)
    for (moves, diameter), begin, end in zip(cuts, ends, ends[1:]):

        def ask(share, begin=begin, end=end):
            answers.append(going(float(begin + share * (end - begin))))
            return answers[-1]

        step = COARSE * diameter
        core.simulate(
            moves, stock, tool_diameter=diameter, step=step, find_rest=False, progress=ask
        )
        if not all(answers):
            return False
    return True


def length_of(moves):
    """mm along moves, rapids too: a list of them, or a Toolpath."""
    points, _ = planar.drawn(listed(moves))
    return float(numpy.linalg.norm(numpy.diff(points, axis=0), axis=1).sum())


def listed(moves):
    """Moves as a list: they may be a Toolpath's."""
    return getattr(moves, "moves", moves)
