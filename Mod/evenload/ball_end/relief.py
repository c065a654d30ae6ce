"""How the worked surface bends under a path, from the heights of the tool over it.

Of the tool's centres a quadric is fitted to a square of 5 x 5 heights around each place. It is as
wide as two fifths of the ball's radius, about what a chip is, so that it does not heed the
triangles. Needs no FreeCAD.
"""

import numpy

from evenload import compiled, waiting

SHARE = 0.1  # of the ball's radius: the heights' distance
MOST_CELLS = 1 << 24  # of the square about the path; a larger one has wider cells
AROUND = numpy.array([(i, j) for i in range(-2, 3) for j in range(-2, 3)])  # cells
LEAST_HEIGHTS = 9  # of 25, that a quadric is fitted to
RIDGE = 1e-3  # keeps what the heights leave open level: where they lie in two rows
AT_ONCE = 1 << 16  # places, for the memory's sake
_U, _V = AROUND.T.astype(float)
_TERMS = numpy.column_stack([numpy.ones(len(_U)), _U, _V, _U**2 / 2, _U * _V, _V**2 / 2])
_SQUARES = (_TERMS[:, :, None] * _TERMS[:, None, :]).reshape(len(_U), -1)


def slopes_and_bends(mesh, arguments, tips):
    """(slopes, bends): of the tool's height z(x, y) at n x 2 places in plan, its derivatives by x
    and y, n x 2, and by xx, xy and yy, 1/mm, n x 3; not a number off the picked faces.

    mesh: the core's, of the faces; arguments: of the core's finish(). Asks waiting.go_on.
    """
    step, low, counts = _grid(tips, arguments["tool_diameter"] / 2)
    cells = numpy.rint((tips - low) / step).astype(numpy.int64)
    homes, number = numpy.unique(cells @ (counts[1], 1), return_inverse=True)
    homes = numpy.column_stack(numpy.divmod(homes, counts[1]))
    around = (homes[:, None, :] + AROUND) @ (counts[1], 1)
    needed = numpy.unique(around)
    places = low + step * numpy.column_stack(numpy.divmod(needed, counts[1]))
    heights, is_known = _heights(mesh, arguments, places)
    found = numpy.empty((len(homes), 5))
    for start in range(0, len(homes), AT_ONCE):
        waiting.go_on()
        rows = slice(start, start + AT_ONCE)
        which = numpy.searchsorted(needed, around[rows])
        found[rows] = _quadrics(heights[which], is_known[which])
    found /= step * numpy.array([1, 1, step, step, step])
    found = found[number]
    off = tips - low - step * cells
    slopes = found[:, :2] + numpy.column_stack(
        [(found[:, 2:4] * off).sum(axis=1), (found[:, 3:] * off).sum(axis=1)]
    )
    return slopes, found[:, 2:]


def _grid(tips, radius):
    """(mm between heights, the place of the first, how many there are along x and y)."""
    low, high = tips.min(axis=0), tips.max(axis=0)
    step = max(SHARE * radius, float(numpy.sqrt(numpy.prod(high - low) / MOST_CELLS)))
    low = low - 3 * step
    return step, low, numpy.ceil((high - low) / step).astype(numpy.int64) + 4


def _heights(mesh, arguments, places):
    """(mm, whether they are those over the picked faces alone, off their border)."""
    allowance = arguments["allowance"]
    contacts = compiled.core().surface.contacts(
        mesh,
        *(arguments["tool_diameter"] + 2 * allowance, arguments["corner_radius"] + allowance),
        *(places, arguments["floor"] - allowance),
        progress=waiting.answer,
    )
    return contacts[:, 0], (contacts[:, 1] > 0) & (contacts[:, 2] > 0)


def _quadrics(heights, is_known):
    """n x 5: the derivatives of the quadrics through n x 25 heights, by cells."""
    weights = is_known.astype(float)
    squares = (weights @ _SQUARES).reshape(-1, 6, 6)
    squares += RIDGE * numpy.diag([1.0, 0, 0, 1, 1, 1])
    enough = is_known.sum(axis=1) >= LEAST_HEIGHTS
    # Heights over their own middle: the ridge may then hold the quadric's own height as well.
    middles = (weights * heights).sum(axis=1) / numpy.maximum(weights.sum(axis=1), 1)
    above = numpy.where(is_known, heights - middles[:, None], 0.0)
    found = numpy.full((len(heights), 5), numpy.nan)
    solved = numpy.linalg.solve(squares[enough], (above[enough] @ _TERMS)[:, :, None])
    found[enough] = solved[:, 1:, 0]
    return found
