"""Values known at some places, on all cells of a surface's map."""

import numpy

from evenload import waiting

MOST_PAIRS = 100_000  # of cells and places that are compared at once, in some MB
SAME = 1e-9  # mm


def on_cells(simulation, places, values):
    """For each cell of a SurfaceSimulation that was cut the value at the nearest place, not a
    number elsewhere. places: n x 2, mm.
    """
    result = numpy.full(simulation.part.shape, numpy.nan)
    rows, columns = numpy.nonzero(simulation.is_covered)
    cells = numpy.column_stack([simulation.x[columns], simulation.y[rows]])
    result[rows, columns] = values[_nearest(cells, places)]
    return result


def _nearest(cells, places):
    """For each of n x 2 cells the number of the nearest place. Cells are halved until few places
    come into question for those that lie together, for a table of all distances would be too large.
    """
    result = numpy.empty(len(cells), int)
    open_groups = [(numpy.arange(len(cells)), numpy.arange(len(places)))]
    while open_groups:
        waiting.go_on()
        own, near = open_groups.pop()
        group = cells[own]
        near = near[_may_be_nearest(group, places[near])]
        if len(own) * len(near) <= MOST_PAIRS or len(own) == 1:
            x, y = (numpy.subtract.outer(group[:, k], places[near, k]) for k in (0, 1))
            result[own] = near[(x * x + y * y).argmin(axis=1)]
            continue
        half, wider = len(own) // 2, numpy.ptp(group, axis=0).argmax()
        order = numpy.argpartition(group[:, wider], half)
        open_groups += [(own[order[:half]], near), (own[order[half:]], near)]
    return result


def _may_be_nearest(group, places):
    """Of each place whether it may be the nearest of a cell of a group."""
    centre = (group.min(axis=0) + group.max(axis=0)) / 2
    spread = numpy.hypot(*(group - centre).T).max()
    apart = numpy.hypot(*(places - centre).T)
    return apart <= apart.min() + 2 * spread + SAME
