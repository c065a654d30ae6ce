"""Which edges of a floor are open: those with no wall above what is cut, and nothing of the stock
beyond them. There the tool may come in from outside.
"""

import math

import numpy
import Part

from evenload import compiled
from evenload.geometry import body, stock_beyond
from evenload.geometry.body_face import is_upright
from evenload.geometry.floor import (
    ABOVE_FLOOR,
    CURVE_SHARE,
    SAME_HEIGHT,
    inside,
    is_exact,
    oriented,
)
from evenload.planar import flattened

BESIDE = 0.02  # mm: nearest distance from an edge where a wall is looked for; more than DEFLECTION
REACH = 2.5  # tool diameters: no wall may stand nearer to an open edge, for the tool travels there
ACROSS = 10  # rows of points on the ground up to there
FAN = (-80, -50, -25, 0, 25, 50, 80)  # degrees from an edge's normal, at its ends


def enclosed(floor, models):
    """Whether `floor` is a face of a solid with its upright walls along every edge. That is what
    `judge` would find, too, but sections of the model take much longer.
    """
    bare = {edge.hashCode(): edge for edge in floor.Edges}
    if floor.ShapeType != "Face" or len(bare) < len(floor.Edges) or floor.normalAt(0, 0).z < 0:
        return False
    z = floor.BoundBox.ZMax
    for face in [f for model in models for solid in model.Solids for f in solid.Faces]:
        shared = [e for e in face.Edges if e.hashCode() in bare]
        if shared and _rises(face, z):
            for edge in shared:
                if bare.get(edge.hashCode(), floor).isSame(edge):
                    del bare[edge.hashCode()]
    return not bare


def _rises(face, z):
    """Whether a face stands upright on the height z."""
    box = face.BoundBox
    return (
        is_upright(face.Surface) and box.ZMin > z - SAME_HEIGHT and box.ZMax > z + 2 * ABOVE_FLOOR
    )


class Walls:
    """The ground over which the model and the stock stand higher than any height."""

    def __init__(self, models, stock):
        self._models = [body.of(model) for model in models]
        self._stock = [body.of(stock)] if stock else []

    def model_above(self, z):
        """Of each model its outlines as nested polygons."""
        return [each.outlines(z)[1] for each in self._models]

    def stock_above(self, z):
        return [each.outlines(z)[1] for each in self._stock]

    def model_outlines(self, z, at):
        """[(closed wires in the plane z = `at`, the same as polygons)] of each model."""
        return [each.outlines(z, at) for each in self._models]

    def stock_outlines(self, z, at):
        return [each.outlines(z, at) for each in self._stock]

    @staticmethod
    def any_inside(points, sections):
        """For each point, whether it lies inside one of the sections (lists of nested polygons)."""
        result = numpy.zeros(len(points), bool)
        for polygons in sections:
            if polygons:
                result |= inside(points, polygons)
        return result


def drop_holes(floor, walls):
    """Drops islands that are holes in the floor with the stock still in them. Chains have the right
    sense of rotation then.
    """
    floor.outer = oriented(floor.outer, counter_clockwise=True)
    floor.islands = [oriented(island, counter_clockwise=False) for island in floor.islands]
    if floor.enclosed:
        return
    z = floor.cut_to + ABOVE_FLOOR
    kept = []
    for island in floor.islands:
        if not any(_walled(island, walls, z)):
            within = _beside(island)[0]
            if walls.any_inside(within, walls.stock_above(z)).any():
                continue  # a hole in the floor: its stock is cut with the rest
        kept.append(island)
    floor.islands = kept


def extend(floor, walls, others, over_lower, tool_diameter, tolerance, partly_open=True):
    """Has a floor go on where stock stands beyond sides without a wall; see stock_beyond.py.
    others: Floors where it must not go; over_lower: as for stock_beyond.continued; partly_open: as
    for shape.floors.
    """
    if floor.enclosed:
        return
    outer, z = floor.outer, floor.cut_to + ABOVE_FLOOR
    # A boss on the floor itself does not close a side near it, nor a wall that goes on past it.
    near = 0.5 * tool_diameter
    walled = _walled(outer, walls, z, near, off_floor=[flattened(outer)], fan=())
    blocked = _touching(outer, walls.stock_above(z), walls) & ~walled
    if not blocked.any():
        return
    sides = numpy.flatnonzero(blocked)
    places = [outer[i][:2] for i in sides]
    try:
        if not walled.any() and _open_all_round(floor, walls, z, others, tolerance):
            floor.beyond = [stock_beyond.Beyond(outer, places, [])]
            return
        growth = stock_beyond.continued(
            floor,
            list(walled),
            walls,
            z,
            others,
            over_lower,
            tool_diameter,
            tolerance,
            partly_open,
        )
    except (ValueError, Part.OCCError) as error:  # of the geometry there; the floor needs none
        floor.notes.append(
            "%s: it is not cleared, for the ground there could not be found (%s)."
            % (stock_beyond.sides_of(floor.name, places), str(error).rstrip("."))
        )
        return
    if growth is None:
        floor.notes.append(stock_beyond.note_of_nothing(floor.name, places))
        return
    left = [] if growth.to_the_edge else _left(outer, sides, walls, z, growth.distance)
    floor.beyond = [stock_beyond.Beyond(outer, places, left, growth.distance)]
    floor.outer, floor.islands = growth.outer, growth.islands
    floor.slack, floor.grown = growth.slack, True


def _left(outer, sides, walls, z, distance):
    """[(start of a piece, place beyond its middle or beside that, both (x, y))] of those of the
    `sides`, numbers of pieces, beyond which stock stands outside of the model `distance` mm away.
    """
    result = []
    for i in sides:
        points = numpy.array(_beside_piece(outer, i, 0.0, distance + BESIDE, ()))
        stands = walls.any_inside(points, walls.stock_above(z))
        stands &= ~walls.any_inside(points, walls.model_above(z))
        result += [(outer[i][:2], tuple(point)) for point in points[stands][:1]]
    return result


def mark(floor, walls, tool_diameter):
    """Marks the open edges of a floor."""
    outer = floor.outer
    if floor.enclosed or all(vertex[3] for vertex in outer):
        return
    z, reach = floor.cut_to + ABOVE_FLOOR, REACH * tool_diameter
    free = ~_walled(outer, walls, z, reach)
    free &= ~_touching(outer, walls.stock_above(z), walls, reach)
    for i in numpy.flatnonzero(free):
        outer[i] = (*outer[i][:3], True)


def _open_all_round(floor, walls, z, others, tolerance):
    """Has a floor without walls, beyond which stock stands, reach to the edge of the stock, open
    all round, if nothing else of the model stands there, nor any of the `others`; tells whether it
    does.
    """
    within = _beside(floor.outer, nearest=-BESIDE)[0]
    around = [
        wire
        for wires, polygons in walls.stock_outlines(z, floor.z)
        for wire, polygon in zip(wires, polygons)
        if inside(within, [polygon]).all()
    ]
    outline = [flattened(floor.outer)]
    standing = [polygon for polygons in walls.model_above(z) for polygon in polygons]
    standing += [flattened(other.outer) for other in others]
    if len(around) != 1 or not all(inside(polygon, outline).all() for polygon in standing):
        return False
    curve_tolerance = CURVE_SHARE * tolerance
    ((_, chain, _),) = compiled.occt().regions_from_brep(
        around[0].exportBrepToString(), curve_tolerance
    )
    chain = oriented(list(chain), counter_clockwise=True)
    floor.outer = [(x, y, bulge, True) for x, y, bulge, _ in chain]
    floor.grown = True
    if not is_exact(around[0]):
        floor.slack = max(floor.slack, curve_tolerance)
    return True


def _walled(chain, walls, z, reach=0.0, off_floor=(), fan=FAN):
    """For each piece of a chain, whether a wall of the model stands beside it, at any height above
    z; only off the floor within nested polygons. reach and fan as for _beside.
    """
    standing = walls.model_above(z)
    result = _touching(chain, standing, walls)
    points, piece = _beside(chain, reach, fan=fan)
    if off_floor:
        off = ~inside(points, off_floor)
        points, piece = points[off], piece[off]
    result[piece[walls.any_inside(points, standing)]] = True
    return result


def _touching(chain, sections, walls, reach=0.0):
    """For each piece of a chain, whether one of the sections lies beside it."""
    points, piece = _beside(chain, reach)
    result = numpy.zeros(len(chain), bool)
    result[piece[walls.any_inside(points, sections)]] = True
    return result


def _beside(chain, reach=0.0, nearest=BESIDE, fan=FAN):
    """(points, the number of the piece of each) to the right of a chain's pieces: `nearest` mm away
    along them and, with a reach in mm, all the ground up to there. fan: degrees from the normals in
    which the ground at a piece's ends is looked at; without any, its ends are left out.
    """
    points = [_beside_piece(chain, i, reach, nearest, fan) for i in range(len(chain))]
    piece = numpy.repeat(numpy.arange(len(chain)), [len(each) for each in points])
    return numpy.array([point for each in points for point in each]), piece


def _beside_piece(chain, i, reach, nearest, fan):
    """The points of _beside at one piece."""
    (x0, y0, bulge, *_), (x1, y1, *_) = chain[i], chain[(i + 1) % len(chain)]
    dx, dy = x1 - x0, y1 - y0
    chord = math.hypot(dx, dy)
    half = 2 * math.atan(bulge)  # rad: half of the sweep
    start = math.atan2(dy, dx) - half  # rad: direction at the start
    distances = [nearest]
    steps = 4
    if reach:
        distances += [reach * k / ACROSS for k in range(1, ACROSS + 1)]
        steps = max(steps, math.ceil(chord * ACROSS / reach))
    points = []
    for k in range(steps + 1):
        t = k / steps
        at_end = k in (0, steps)
        if at_end and not reach:
            continue
        direction = start + 2 * half * t
        if bulge:
            radius = 0.5 * chord / math.sin(half)
            x = x0 + radius * (math.sin(direction) - math.sin(start))
            y = y0 - radius * (math.cos(direction) - math.cos(start))
        else:
            x, y = x0 + t * dx, y0 + t * dy
        for degrees in fan if at_end else (0,):
            normal = direction - 0.5 * math.pi + math.radians(degrees)
            u, v = math.cos(normal), math.sin(normal)
            points += [(x + d * u, y + d * v) for d in distances]
    return points
