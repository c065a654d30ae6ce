"""Where a Simulation leaves rest and where it gouges, as areas in space. mm."""

import numpy
from matplotlib.path import Path

from evenload import planar

DIRECTIONS = 360  # around the tool in which it is looked whether there it is in the part
MOST = 500  # places of gouges: of more, evenly chosen ones stand for all
LEAST = 1e-3  # mm: less of a gouge, or below a part's top, is rounding


def rest_areas(simulation):
    """[n x 3 points, ...]: polygons on top of what is left that the tool could have reached."""
    result = []
    for outline in simulation.rest_outlines:
        points = numpy.asarray(outline, float)
        # An outline goes up along the ends of rows and down along their beginnings.
        row = len(points) // 4
        x, y = 0.5 * (points[row] + points[-1 - row])
        z = simulation.stock.height_at(x, y)
        z = z if numpy.isfinite(z) else simulation.bottom
        result.append(numpy.column_stack([points, numpy.full(len(points), z)]))
    return result


def gouge_areas(simulation):
    """[n x 3 points, ...]: what the tool has in the part at the samples that gouge, on top of the
    part, where the cut is open. They overlap; a border of the part within the tool counts as
    straight.
    """
    numbers = numpy.flatnonzero(simulation.gouge > LEAST)
    numbers = numbers[:: max(1, -(-len(numbers) // MOST))]
    angles = numpy.linspace(0, 2 * numpy.pi, DIRECTIONS, endpoint=False)
    around = 0.5 * simulation.tool_diameter * numpy.stack([numpy.cos(angles), numpy.sin(angles)], 1)
    prisms = [(_loops(region), top) for region, top in simulation.part]
    result = []
    for number in numbers:
        z = float(simulation.z[number])
        rim = around + (simulation.x[number], simulation.y[number])
        for loops, top in prisms:
            pieces = _runs(rim, _in(loops, rim)) if top > z + LEAST else []
            result += [numpy.column_stack([p, numpy.full(len(p), top)]) for p in pieces]
    return result


def _loops(region):
    return [Path(planar.flattened(chain)) for chain in (region.outer, *region.islands)]


def _in(loops, points):
    outer, *islands = loops
    found = outer.contains_points(points)
    for island in islands:
        found &= ~island.contains_points(points)
    return found


def _runs(rim, inside):
    """The pieces of a rim that are inside, each of three points at least."""
    if inside.all():
        return [rim]
    first = int(numpy.argmin(inside))  # begins outside, so that no piece is cut in two
    rim, inside = numpy.roll(rim, -first, axis=0), numpy.roll(inside, -first)
    ends = numpy.flatnonzero(numpy.diff(numpy.r_[False, inside, False].astype(int)))
    return [rim[a:b] for a, b in zip(ends[::2], ends[1::2]) if b - a > 2]
