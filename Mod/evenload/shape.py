"""Base geometry of an operation -> regions of the core.

Faces parallel to XY, whole sketches and closed edges become regions. A face's edges that have no
wall above them, and nothing of the stock beyond them, are marked open: there the tool may come in
from outside.
"""

import math
from dataclasses import dataclass, field

import FreeCAD
import numpy
import Part

from evenload import compiled
from evenload.planar import DEFLECTION, flattened

UP = FreeCAD.Vector(0, 0, 1)
SAME_HEIGHT = 1e-5  # mm: faces nearer than this are at one height
ABOVE_FLOOR = (
    0.01  # mm: walls are looked for this far above a face; finds the foot of a fillet, too
)
# Share of the tolerance within which arcs follow an ellipse or a spline. They leave it to both
# sides, and the tool keeps as far away from them: together that is half of the tolerance, and the
# output has the rest.
CURVE_SHARE = 0.25
BESIDE = 0.02  # mm: nearest distance from an edge where a wall is looked for; more than DEFLECTION
REACH = 2.5  # tool diameters: no wall may stand nearer to an open edge, for the tool travels there
MOST_BLOCKED_NOTES = 4  # open sides of a floor that get a note each where stock stands beyond them
MOST_HEIGHTS = 16  # heights at which walls are looked for above an edge that has none at its foot
LEAST_OVERLAP = 1e-4  # mm2: less of two floors that touch is rounding
UPRIGHT = 1e-9  # of unit vectors: what rises in a right angle
ACROSS = 10  # rows of points on the ground up to there
FAN = (-80, -50, -25, 0, 25, 50, 80)  # degrees from an edge's normal, at its ends


@dataclass
class Floor:
    """One region and where it comes from."""

    name: str  # such as 'Face7 of Model'
    z: float  # mm
    outer: list  # of (x, y, bulge, open)
    islands: list
    is_face: bool  # a floor of the model; else an outline drawn at any height
    enclosed: bool = False  # by upright walls of the model, all round
    slack: float = 0.0  # mm, by which the chains may leave the geometry, to either side
    notes: list = field(default_factory=list)

    def region(self):
        """The core's Region. Raises ValueError, naming the geometry, for one that is crossed or
        outside out.
        """
        try:
            return compiled.core().Region(self.outer, self.islands)
        except ValueError as error:
            raise ValueError("%s: %s" % (self.name, error)) from None

    def contains(self, x, y):
        """True for points in mm inside of the outer boundary and of no island."""
        polygons = [flattened(chain) for chain in [self.outer, *self.islands]]
        return bool(_inside(numpy.array([[x, y]]), polygons)[0])


def floors(base, models, stock, tool_diameter, tolerance, slot=None):
    """The floors that `base` ([(object, sub-element names), ...]) describes, in its order.

    models: shapes of the job's model, stock: shape of its stock or None, both in place;
    tool_diameter and tolerance in mm. slot: callable(chain, closed, name of the geometry) -> the
    core's Region of the slot round a sketch's or edges' curve, or None where it is an outline;
    slots that meet are one floor. Without it open curves are refused. Raises ValueError with a
    sentence that names the geometry.
    """
    found, slots = [], []
    for item in _items(base):
        read = _slots(item, tolerance, slot) if slot and not item.is_face else []
        slots += read
        if read:
            continue
        read = _read(item, tolerance)
        if item.is_face and _enclosed(item.shape, models):
            for floor in read:
                floor.enclosed = True
        found += read
    for united in _united(slots):
        found += _within_stock(united, stock)
    if not found:
        raise ValueError("The operation has no base geometry: pick a face or a sketch for it.")
    _refuse_overlaps(found)
    walls = _Walls(models, stock)
    for floor in found:
        if floor.is_face:
            _judge_edges(floor, walls, tool_diameter, tolerance)
    return found


def heights(base):
    """The z in mm of everything in `base` that is there and parallel to XY."""
    result = []
    for obj, names in base:
        shape = _placed(obj)
        if shape is None:
            continue
        for name in names or ("",):
            part = _element(shape, name)
            if part is not None and part.Vertexes:
                z = [v.Z for v in part.Vertexes]
                if max(z) - min(z) < SAME_HEIGHT and part.BoundBox.ZLength < SAME_HEIGHT:
                    result.append(z[0])
    return result


# ---- reading ----


@dataclass
class _Item:
    parts: list  # of (label of the object, sub-element or '' for a whole object)
    shape: object
    is_face: bool

    @property
    def name(self):
        """Such as 'Face7, Face9 of Model'."""
        labels = list(dict.fromkeys(label for label, _ in self.parts))
        names = [", ".join(n for other, n in self.parts if other == label) for label in labels]
        return " and ".join("%s of %s" % (n, k) if n else k for n, k in zip(names, labels))


def _placed(obj):
    """An object's shape where it is in the world, None where it has none."""
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        return None
    container = obj.getGlobalPlacement() * obj.Placement.inverse()  # such as a sketch's body
    if not container.isIdentity():
        shape = shape.copy()
        shape.Placement = container * shape.Placement
    return shape


def _element(shape, name):
    if not name:
        return shape
    try:
        return shape.getElement(name)
    except (ValueError, IndexError, AttributeError, Part.OCCError):
        return None


def _items(base):
    """What to read one by one: faces, those that adjoin each other as one; each object's edges
    together; whole objects.
    """
    names_of = {}
    for obj, names in base:
        names_of.setdefault(obj, []).extend(names or ("",))
    result = []
    for obj, names in names_of.items():
        label = obj.Label
        shape = _placed(obj)
        if shape is None:
            raise ValueError("'%s' has no shape: pick a face or a sketch." % label)
        edges = []
        for name in names:
            part = _element(shape, name)
            if part is None:
                raise ValueError("There is no %s on %s: pick the geometry anew." % (name, label))
            if part.ShapeType == "Face":
                result.append(_Item([(label, name)], part, True))
            elif name and part.ShapeType in ("Edge", "Wire"):
                edges.append((name, part))
            elif name:
                raise ValueError(
                    "%s of %s is no face and no edge: pick a face or a sketch." % (name, label)
                )
            elif part.Solids or part.Shells:
                raise ValueError("%s is a solid: pick faces of it, or a sketch." % label)
            else:
                result.append(_Item([(label, "")], part, bool(part.Faces)))
        if edges:
            shapes = Part.Compound([edge for _, edge in edges])
            result.append(_Item([(label, name) for name, _ in edges], shapes, False))
    return _merged(result)


def _merged(items):
    """The items, with faces at one height that have edges in common as one. It is the same shape
    whichever of them was picked first; its place among the items is that of the first.
    """
    groups = []
    for item in items:
        touched = [g for g in groups if any(_adjoin(item.shape, other.shape) for other in g)]
        if not touched:
            groups.append([item])
            continue
        touched[0] += [other for group in touched[1:] for other in group] + [item]
        groups = [g for g in groups if not any(g is gone for gone in touched[1:])]
    return [_joined(group) for group in groups]


def _adjoin(a, b):
    """Whether two shapes are level faces at one height with an edge in common, or that overlap."""
    if a.ShapeType != "Face" or b.ShapeType != "Face":
        return False
    if max(a.BoundBox.ZLength, b.BoundBox.ZLength) > SAME_HEIGHT:
        return False
    if abs(a.BoundBox.ZMax - b.BoundBox.ZMax) > SAME_HEIGHT or not a.BoundBox.intersect(b.BoundBox):
        return False
    return len(a.fuse(b).removeSplitter().Faces) == 1


def _joined(group):
    if len(group) == 1:
        return group[0]
    group = sorted(group, key=lambda item: [(k, len(n), n) for k, n in item.parts])  # Face9, Face10
    fused = group[0].shape.fuse([item.shape for item in group[1:]]).removeSplitter()
    return _Item([part for item in group for part in item.parts], Part.Compound(fused.Faces), True)


def _read(item, tolerance):
    occt = compiled.occt()
    within = CURVE_SHARE * tolerance
    try:
        found = occt.regions_from_brep(item.shape.exportBrepToString(), within)
    except occt.ShapeError as error:
        raise ValueError(_sentence(item, error)) from None
    slack = _slack(item, within)
    return [
        Floor(item.name, z, list(outer), [list(i) for i in islands], item.is_face, slack=slack)
        for z, outer, islands in found
    ]


def _slots(item, tolerance, slot):
    """The floors of slots round an item's curves; none where they are outlines."""
    within = CURVE_SHARE * tolerance
    occt = compiled.occt()
    try:
        curves = occt.curves_from_brep(item.shape.exportBrepToString(), within)
    except occt.ShapeError as error:
        raise ValueError(_sentence(item, error)) from None
    slack, result = _slack(item, within), []
    for z, chain, closed in curves:
        region = slot(chain, closed, item.name)
        if region is not None:
            outer, islands = list(region.outer), [list(island) for island in region.islands]
            result.append(Floor(item.name, z, outer, islands, False, slack=slack))
    return result


def _united(slots):
    """The slots, those at one height that overlap as one floor."""
    result = []
    for z in dict.fromkeys(round(slot.z, 5) for slot in slots):
        level = [slot for slot in slots if round(slot.z, 5) == z]
        if len(level) == 1:
            result += level
            continue
        faces = [_face_of(slot) for slot in level]
        fused = Part.Compound(faces[0].fuse(faces[1:]).removeSplitter().Faces)
        name = " and ".join(dict.fromkeys(slot.name for slot in level))
        slack = max(slot.slack for slot in level)
        result += [
            Floor(name, z, list(outer), [list(island) for island in islands], False, slack=slack)
            for _, outer, islands in compiled.occt().regions_from_brep(
                fused.exportBrepToString(), SAME_HEIGHT
            )
        ]
    return result


def _within_stock(slot, stock):
    """The floors that the stock leaves of a slot, open where it runs out of the stock."""
    if stock is None:
        return [slot]
    outlines = [wire for wire in stock.slice(UP, slot.z + ABOVE_FLOOR) if wire.isClosed()]
    face, ground = _face_of(slot), [Part.Face(outline) for outline in outlines]
    for each in ground:
        each.translate(UP * -ABOVE_FLOOR)
    inside = face.common(ground) if ground else Part.Shape()
    if not inside.Faces:
        raise ValueError(
            "%s lies outside the stock: move it, or make the stock larger." % slot.name
        )
    if inside.Area > face.Area - LEAST_OVERLAP:
        return [slot]
    border = Part.Compound([wire for each in ground for wire in each.Wires])
    result = []
    for _, outer, islands in compiled.occt().regions_from_brep(
        Part.Compound(inside.removeSplitter().Faces).exportBrepToString(), SAME_HEIGHT
    ):
        edges = _wire_of(outer, slot.z).OrderedEdges
        middles = [edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter)) for edge in edges]
        outside = [border.distToShape(Part.Vertex(p))[0] < SAME_HEIGHT for p in middles]
        chain = [(*vertex[:3], is_open) for vertex, is_open in zip(outer, outside)]
        islands = [list(island) for island in islands]
        result.append(Floor(slot.name, slot.z, chain, islands, False, slack=slot.slack))
    return result


def _refuse_overlaps(found):
    """Raises ValueError where two floors at one height overlap, which would be cut as one."""
    for i, floor in enumerate(found):
        for other in found[:i]:
            if abs(floor.z - other.z) > SAME_HEIGHT:
                continue
            a, b = _face_of(floor), _face_of(other)
            if a.BoundBox.intersect(b.BoundBox) and a.common(b).Area > LEAST_OVERLAP:
                raise ValueError(
                    "%s and %s overlap: draw what they enclose together as one, or use two "
                    "operations." % (other.name, floor.name)
                )


def _face_of(floor):
    """A floor as a face of FreeCAD's."""
    face = Part.Face(_wire_of(floor.outer, floor.z))
    holes = [Part.Face(_wire_of(island, floor.z)) for island in floor.islands]
    return face.cut(holes) if holes else face


def _wire_of(chain, z):
    edges = []
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        start, end = FreeCAD.Vector(x0, y0, z), FreeCAD.Vector(x1, y1, z)
        middle = (start + end) / 2 + FreeCAD.Vector(y1 - y0, x0 - x1, 0) * (bulge / 2)
        edges.append(Part.Arc(start, middle, end).toShape() if bulge else Part.makeLine(start, end))
    return Part.Wire(edges)


def _slack(item, within):
    """mm, by which chains made to `within` mm may leave the item's curves."""
    exact = all(isinstance(edge.Curve, (Part.Line, Part.Circle)) for edge in item.shape.Edges)
    return 0.0 if exact else within


def _sentence(item, error):
    if item.is_face and error.reason == "tilted":
        return "%s is tilted: pick a face parallel to XY." % item.name
    if item.is_face and error.reason == "not planar":
        return "%s is not flat: pick a flat face parallel to XY." % item.name
    return "%s: %s" % (item.name, error)


# ---- open edges ----


def _enclosed(floor, models):
    """Whether `floor` is a face of a solid with its upright walls along every edge. That is what
    `_judge_edges` would find, too, but sections of the model take much longer.
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


class _Walls:
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
                        [_points(wire) for wire in shape.slice(UP, z) if wire.isClosed()]
                    )
            self._sections[key] = polygons
        return self._sections[key]

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
                result |= _inside(points, polygons)
        return result


def _judge_edges(floor, walls, tool_diameter, tolerance):
    """Marks the open edges of a floor; drops islands that are holes in the floor with the stock
    still in them.
    """
    outer = floor.outer = _oriented(floor.outer, counter_clockwise=True)
    floor.islands = [_oriented(island, counter_clockwise=False) for island in floor.islands]
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
    if all(free):
        _open_all_round(floor, walls, z, tolerance)
        return
    blocked = []
    for i, is_free in enumerate(free):
        if not is_free:
            continue
        if walls.any_inside(_beside(outer, i, reach), walls.stock_at(z)).any():
            blocked.append(outer[i][:2])
        else:
            outer[i] = (*outer[i][:3], True)
    floor.notes += _blocked_notes(floor.name, blocked)


def _blocked_notes(name, places):
    """One for each of a few open sides with stock beyond; one for all of the many short sides that
    a curve may be drawn as.
    """
    if len(places) > MOST_BLOCKED_NOTES:
        return [
            "%s has stock beyond %d of its open sides, the first near (%.3f, %.3f): they are "
            "treated as walls." % (name, len(places), *places[0])
        ]
    return [
        "%s has stock beyond its open side near (%.3f, %.3f): it is treated as a wall."
        % (name, *place)
        for place in places
    ]


def _open_all_round(floor, walls, z, tolerance):
    """A floor without walls reaches to the edge of the stock."""
    pieces = range(len(floor.outer))
    beside = numpy.vstack([_beside(floor.outer, i) for i in pieces])
    if walls.any_inside(beside, walls.stock_at(z)).any():
        within = numpy.vstack([_beside(floor.outer, i, nearest=-BESIDE) for i in pieces])
        wires = [w for w in walls.stock.slice(UP, z) if w.isClosed()]
        around = [w for w in wires if _inside(within, [_points(w)]).all()]
        outline = [flattened(floor.outer)]
        others = [
            polygon
            for height in [z, *walls.heights_above(z)]
            for polygons in walls.model_at(height)
            for polygon in polygons
            if not _inside(polygon, outline).all()
        ]
        if len(around) != 1 or others:
            floor.notes.append(
                "%s has stock beyond its open sides: they are treated as walls." % floor.name
            )
            return
        ((_, chain, _),) = compiled.occt().regions_from_brep(
            around[0].exportBrepToString(), tolerance
        )
        floor.outer = _oriented(list(chain), counter_clockwise=True)
    floor.outer = [(x, y, bulge, True) for x, y, bulge, _ in floor.outer]


def _walled(chain, i, walls, z, reach):
    """Whether a wall of the model stands beside piece i of a chain, at any height above z."""
    if walls.any_inside(_beside(chain, i), walls.model_at(z)).any():
        return True
    beside = _beside(chain, i, reach)
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


def _oriented(chain, counter_clockwise):
    """The chain in the wished sense of rotation."""
    area = 0.0
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        area += 0.5 * (x0 * y1 - x1 * y0)
        if bulge:
            sweep = 4 * math.atan(bulge)
            radius = 0.5 * math.hypot(x1 - x0, y1 - y0) / math.sin(0.5 * sweep)
            area += 0.5 * radius**2 * (sweep - math.sin(sweep))
    if (area > 0) == counter_clockwise:
        return list(chain)
    turned = list(reversed(chain))
    pieces = turned[1:] + turned[:1]
    return [(x, y, -piece[2], piece[3]) for (x, y, *_), piece in zip(turned, pieces)]


def _points(wire):
    return numpy.array([(p.x, p.y) for p in wire.discretize(Deflection=DEFLECTION)])


def _inside(points, polygons):
    """Even-odd: for each point, whether it lies inside nested polygons."""
    result = numpy.zeros(len(points), bool)
    px, py = points[:, 0], points[:, 1]
    for polygon in polygons:
        x0, y0 = polygon[:, 0][:, None], polygon[:, 1][:, None]
        x1, y1 = numpy.roll(x0, -1, 0), numpy.roll(y0, -1, 0)
        across = (y0 > py) != (y1 > py)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            left = px < (x1 - x0) * (py - y0) / (y1 - y0) + x0
        result ^= (across & left).sum(axis=0) % 2 == 1
    return result
