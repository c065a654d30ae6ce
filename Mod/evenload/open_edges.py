"""Which edges of a floor are open: those with no wall above them, and nothing of the stock beyond
them. There the tool may come in from outside.
"""

import math

import numpy
import Part

from evenload import compiled, stock_beyond
from evenload.floor import ABOVE_FLOOR, SAME_HEIGHT, UP, inside, oriented, points_of
from evenload.planar import flattened

BESIDE = 0.02  # mm: nearest distance from an edge where a wall is looked for; more than DEFLECTION
REACH = 2.5  # tool diameters: no wall may stand nearer to an open edge, for the tool travels there
MOST_HEIGHTS = 16  # heights at which walls are looked for above an edge that has none at its foot
UPRIGHT = 1e-9  # of unit vectors: what rises in a right angle
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
    surface = face.Surface
    if isinstance(surface, Part.Plane):
        upright = abs(surface.Axis.z) < UPRIGHT
    elif isinstance(surface, Part.Cylinder):
        upright = abs(surface.Axis.z) > 1 - UPRIGHT
    else:
        extruded = isinstance(surface, Part.SurfaceOfExtrusion)
        upright = extruded and abs(surface.Direction.z) > 1 - UPRIGHT
    box = face.BoundBox
    return upright and box.ZMin > z - SAME_HEIGHT and box.ZMax > z + 2 * ABOVE_FLOOR


class Walls:
    """The model's and the stock's outlines at any height, made when they are asked for."""

    def __init__(self, models, stock):
        self.models = models
        self.stock = stock
        self.top = max((m.BoundBox.ZMax for m in models), default=-math.inf)
        self._sections = {}

    def model_at(self, z):
        return self._section("model", self.models, z)

    def stock_at(self, z):
        return self._section("stock", [self.stock] if self.stock else [], z)

    def _section(self, what, shapes, z):
        key = what, round(z, 6)
        if key not in self._sections:
            polygons = []
            for shape in shapes:
                if shape.BoundBox.ZMin < z < shape.BoundBox.ZMax:
                    polygons.append(
                        [points_of(wire) for wire in shape.slice(UP, z) if wire.isClosed()]
                    )
            self._sections[key] = polygons
        return self._sections[key]

    def model_faces(self, height, z):
        """What the model covers at a height, as faces at the height z."""
        return _section_faces(self.models, height, z)

    def stock_faces(self, height, z):
        return _section_faces([self.stock] if self.stock else [], height, z)

    def heights_above(self, z):
        """Heights, one between each two at which the model has a vertex."""
        levels = {round(v.Z, 4) for m in self.models for v in m.Vertexes if v.Z > z + ABOVE_FLOOR}
        levels = [z + ABOVE_FLOOR] + sorted(levels)
        between = [0.5 * (a + b) for a, b in zip(levels, levels[1:]) if b - a > 2 * ABOVE_FLOOR]
        step = max(1, math.ceil(len(between) / MOST_HEIGHTS))
        return between[::step]

    @staticmethod
    def any_inside(points, sections):
        """For each point, whether it lies inside one of the sections (lists of nested polygons)."""
        result = numpy.zeros(len(points), bool)
        for polygons in sections:
            if polygons:
                result |= inside(points, polygons)
        return result


def judge(floor, walls, tool_diameter, tolerance):
    """Marks the open edges of a floor; drops islands that are holes in the floor with the stock
    still in them.
    """
    outer = floor.outer = oriented(floor.outer, counter_clockwise=True)
    floor.islands = [oriented(island, counter_clockwise=False) for island in floor.islands]
    if floor.enclosed:
        return
    z = floor.z + ABOVE_FLOOR
    kept = []
    for island in floor.islands:
        if not any(_walled(island, i, walls, z, 0.0) for i in range(len(island))):
            within = numpy.vstack([_beside(island, i) for i in range(len(island))])
            if walls.any_inside(within, walls.stock_at(z)).any():
                continue  # a hole in the floor: its stock is cut with the rest
        kept.append(island)
    floor.islands = kept

    reach = REACH * tool_diameter
    free = [not _walled(outer, i, walls, z, reach) for i in range(len(outer))]
    # A boss on the floor itself does not close a side near it.
    off_floor = [flattened(outer)]
    near = 0.5 * tool_diameter
    bare = [
        f or not _walled(outer, i, walls, z, near, off_floor=off_floor) for i, f in enumerate(free)
    ]
    if all(bare) and _open_all_round(floor, walls, z, all(free), tolerance):
        return
    blocked = [
        i
        for i, is_bare in enumerate(bare)
        if is_bare and walls.any_inside(_beside(outer, i), walls.stock_at(z)).any()
    ]
    if blocked:
        heights = [z, *walls.heights_above(z)]
        walled = [not is_bare for is_bare in bare]
        grown = stock_beyond.continued(floor, walled, walls, heights, tool_diameter)
        floor.notes.append(_note_beyond(floor.name, [outer[i][:2] for i in blocked], bool(grown)))
        if grown:
            outer, floor.islands = grown
            floor.outer = outer
            free = [not _walled(outer, i, walls, z, reach) for i in range(len(outer))]
    for i, is_free in enumerate(free):
        if is_free and not walls.any_inside(_beside(outer, i, reach), walls.stock_at(z)).any():
            outer[i] = (*outer[i][:3], True)


def _note_beyond(name, places, is_cleared):
    """Of a floor with stock beyond the sides that begin in `places`."""
    sides = "its open side near (%.3f, %.3f)" % places[0]
    if len(places) > 1:
        sides = "%d of its open sides, the first near (%.3f, %.3f)" % (len(places), *places[0])
    what = "cleared beyond" if is_cleared else "cleared no further than"
    return "%s has stock beyond %s: it is %s %s." % (
        name,
        sides,
        what,
        "them" if len(places) > 1 else "it",
    )


def _open_all_round(floor, walls, z, is_free, tolerance):
    """Whether a floor without walls is open all round: it reaches to the edge of the stock, if
    nothing else of the model stands there. `is_free`: nothing does within REACH of the floor.
    """
    pieces = range(len(floor.outer))
    beside = numpy.vstack([_beside(floor.outer, i) for i in pieces])
    if walls.any_inside(beside, walls.stock_at(z)).any():
        within = numpy.vstack([_beside(floor.outer, i, nearest=-BESIDE) for i in pieces])
        wires = [w for w in walls.stock.slice(UP, z) if w.isClosed()]
        around = [w for w in wires if inside(within, [points_of(w)]).all()]
        outline = [flattened(floor.outer)]
        others = [
            polygon
            for height in [z, *walls.heights_above(z)]
            for polygons in walls.model_at(height)
            for polygon in polygons
            if not inside(polygon, outline).all()
        ]
        if len(around) != 1 or others:
            return False
        is_free = True
        ((_, chain, _),) = compiled.occt().regions_from_brep(
            around[0].exportBrepToString(), tolerance
        )
        floor.outer = oriented(list(chain), counter_clockwise=True)
    if is_free:
        floor.outer = [(x, y, bulge, True) for x, y, bulge, _ in floor.outer]
    return is_free


def _section_faces(shapes, height, z):
    faces = []
    for shape in shapes:
        if shape.BoundBox.ZMin < height < shape.BoundBox.ZMax:
            wires = [wire for wire in shape.slice(UP, height) if wire.isClosed()]
            if wires:
                faces += Part.makeFace(wires, "Part::FaceMakerBullseye").Faces
    for face in faces:
        face.translate(UP * (z - height))
    return faces


def _walled(chain, i, walls, z, reach, off_floor=()):
    """Whether a wall of the model stands beside piece i of a chain, at any height above z; only off
    the floor within nested polygons.
    """
    if walls.any_inside(_beside(chain, i), walls.model_at(z)).any():
        return True
    beside = _beside(chain, i, reach)
    if off_floor:
        beside = beside[~inside(beside, off_floor)]
    return any(
        walls.any_inside(beside, walls.model_at(height)).any()
        for height in [z, *walls.heights_above(z)]
    )


def _beside(chain, i, reach=0.0, nearest=BESIDE):
    """Points to the right of piece i of a chain: `nearest` mm away along it and, with a reach, all
    the ground up to there.
    """
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
        for degrees in FAN if at_end else (0,):
            normal = direction - 0.5 * math.pi + math.radians(degrees)
            u, v = math.cos(normal), math.sin(normal)
            points += [(x + d * u, y + d * v) for d in distances]
    return numpy.array(points)
