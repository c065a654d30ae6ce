"""Base geometry of an operation -> regions of the core.

Faces parallel to XY, whole sketches and closed edges become regions. A face's edges that have no
wall above them, and nothing of the stock beyond them, are marked open: there the tool may come in
from outside.
"""

from dataclasses import dataclass, replace

import Part

from evenload import compiled
from evenload.geometry import body, covered, open_edges, stock_beyond
from evenload.geometry.floor import (
    ABOVE_FLOOR,
    CURVE_SHARE,
    LEAST_OVERLAP,
    SAME_HEIGHT,
    UP,
    Floor,
    face_of,
    is_exact,
    wire_of,
)
from evenload.words import in_order, listed, name_of


def floors(base, models, stock, tool_diameter, tolerance, slot=None, partly_open=True, depth=None):
    """The floors that `base` ([(object, sub-element names), ...]) describes, in its order.

    models: shapes of the job's model, stock: shape of its stock or None, both in place;
    tool_diameter and tolerance in mm. slot: callable(chain, closed, name of the geometry) -> the
    core's Region of the slot round a sketch's or edges' curve, or None where it is an outline;
    slots that meet are one floor. Without it open curves are refused. partly_open: False for
    operations that cannot take an outline that is open beside walls; where stock stands beyond a
    floor's sides, it goes on by no more than it must then, and has no open edge. depth: z in mm
    down to which all is cut, where sides must be open to count as such; None: down to each face, or
    to where outlines are drawn. Ground that the model covers is left out of its faces. Raises
    ValueError with a sentence that names the geometry.
    """
    found, slots = [], []
    for item in _items(base, models):
        read = _slots(item, tolerance, slot) if slot and not item.is_face else []
        slots += read
        if read:
            continue
        read = _read(item, tolerance)
        if item.is_face and open_edges.enclosed(item.shape, models):
            for floor in read:
                floor.enclosed = True
        found += read
    for united in _united(slots):
        found += _within_stock(united, stock, united.z if depth is None else depth)
    if not found:
        raise ValueError("The operation has no base geometry: pick a face or a sketch for it.")
    _refuse_overlaps(found)
    found = [
        part for floor in found for part in _uncovered(floor, models, tool_diameter, tolerance)
    ]
    for floor in found:
        floor.cut_to = floor.z if depth is None else min(floor.z, depth)
    walls = open_edges.Walls(models, stock)
    for floor in found:
        if floor.is_face:
            open_edges.drop_holes(floor, walls)
    before = [replace(floor) for floor in found]
    for floor in found:
        if floor.is_face:
            others = [other for other in before if not _may_join(floor, other)]
            open_edges.extend(floor, walls, others, tool_diameter, tolerance, partly_open)
    found = _joined_grown(_apart(found, before), tolerance)
    for floor in found:
        if floor.is_face and (partly_open or not floor.grown):
            open_edges.mark(floor, walls, tool_diameter)
        note = stock_beyond.note_of(floor, found, tool_diameter) if floor.grown else None
        floor.notes += [note] if note else []
    return found


def _uncovered(floor, models, tool_diameter, tolerance):
    if not floor.of_solid:  # drawn by itself, it may well lie in the model
        return [floor]
    return covered.uncovered(floor, models, tool_diameter, tolerance)


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
    of_solid: bool = False  # faces of a body

    @property
    def name(self):
        return name_of(self.parts)


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


def _items(base, models):
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
                _refuse_downward(part, shape, "%s of %s" % (name, label))
                result.append(_Item([(label, name)], part, True, _is_of_body(shape, models)))
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


def _is_of_body(shape, models):
    """Whether a shape is a body, or a model that is none, such as a shell: not drawn by itself."""
    return bool(shape.Solids) or any(shape.isSame(model) for model in models)


def _refuse_downward(face, shape, name):
    """Raises ValueError for a level face of a body that has its material above it."""
    if shape.Solids and face.BoundBox.ZLength < SAME_HEIGHT and face.normalAt(0, 0).z < 0:
        raise ValueError("%s looks down: pick a face that looks up." % name)


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
    parts, of_solid = [part for each in group for part in each.parts], group[0].of_solid
    return _Item(parts, Part.Compound(fused.Faces), True, of_solid)


def _read(item, tolerance):
    occt = compiled.occt()
    within = CURVE_SHARE * tolerance
    try:
        found = occt.regions_from_brep(item.shape.exportBrepToString(), within)
    except occt.ShapeError as error:
        raise ValueError(_sentence(item, error)) from None
    slack = _slack(item, within)
    return [
        Floor(
            item.name,
            z,
            list(outer),
            [list(i) for i in islands],
            item.is_face,
            of_solid=item.of_solid,
            slack=slack,
            parts=item.parts,
        )
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
        faces = [face_of(slot) for slot in level]
        fused = Part.Compound(faces[0].fuse(faces[1:]).removeSplitter().Faces)
        name = listed([slot.name for slot in level], " and ", "others")
        slack = max(slot.slack for slot in level)
        result += [
            Floor(name, z, list(outer), [list(island) for island in islands], False, slack=slack)
            for _, outer, islands in compiled.occt().regions_from_brep(
                fused.exportBrepToString(), SAME_HEIGHT
            )
        ]
    return result


def _within_stock(slot, stock, depth):
    """The floors that the stock above `depth`, mm, leaves of a slot, open where it runs out of the
    stock.
    """
    if stock is None:
        return [slot]
    standing = body.of(stock).standing(depth + ABOVE_FLOOR)
    face, ground = face_of(slot), [each.translated(UP * slot.z) for each in standing]
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
        edges = wire_of(outer, slot.z).OrderedEdges
        middles = [edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter)) for edge in edges]
        outside = [border.distToShape(Part.Vertex(p))[0] < SAME_HEIGHT for p in middles]
        chain = [(*vertex[:3], is_open) for vertex, is_open in zip(outer, outside)]
        islands = [list(island) for island in islands]
        result.append(Floor(slot.name, slot.z, chain, islands, False, slack=slot.slack))
    return result


def _may_join(floor, other):
    """Whether two floors may become one when they grow; a sketch's outline is the limit of what it
    encloses.
    """
    return floor.is_face and other.is_face and abs(floor.z - other.z) <= SAME_HEIGHT


def _apart(found, before):
    """The floors, those as they were before they grew which overlap now with one before them that
    they cannot join.
    """
    result = []
    for floor, own in zip(found, before):
        blockers = (o for o in result if not _may_join(floor, o) and _overlap(floor, o))
        other = next(blockers, None) if floor.grown else None
        if other is not None:
            places = [place for beyond in floor.beyond for place in beyond.places]
            own.notes = [
                "%s: it is not cleared there, for it would meet what is cleared beyond %s."
                % (stock_beyond.sides_of(floor.name, places), other.name)
            ]
            floor = own
        result.append(floor)
    return result


def _joined_grown(found, tolerance):
    """The floors, each that has grown as one with those faces at its height that it overlaps or
    touches now, in the place of the first.
    """
    groups = []
    for floor in found:
        met = [group for group in groups if any(_met(floor, other) for other in group)]
        if not met:
            groups.append([floor])
            continue
        met[0] += [other for group in met[1:] for other in group] + [floor]
        groups = [group for group in groups if not any(group is gone for gone in met[1:])]
    return [joined for group in groups for joined in _union(group, tolerance)]


def _met(floor, other):
    """Whether two floors, one of which has grown, are one now."""
    if not (_may_join(floor, other) and (floor.grown or other.grown)):
        return False
    a, b = face_of(floor), face_of(other)
    return a.BoundBox.intersect(b.BoundBox) and len(a.fuse(b).removeSplitter().Faces) == 1


def _union(group, tolerance):
    """The floors of a group as one."""
    if len(group) == 1:
        return group
    faces = [face_of(floor) for floor in group]
    fused = Part.Compound(faces[0].fuse(faces[1:]).removeSplitter().Faces)
    parts = in_order(dict.fromkeys(part for floor in group for part in floor.parts))
    within = CURVE_SHARE * tolerance
    slack = max([floor.slack for floor in group] + ([] if is_exact(fused) else [within]))
    notes = list(dict.fromkeys(note for floor in group for note in floor.notes))
    try:
        found = compiled.occt().regions_from_brep(fused.exportBrepToString(), within)
    except compiled.occt().ShapeError as error:
        raise ValueError("%s: %s" % (name_of(parts), error)) from None
    return [
        Floor(
            name_of(parts),
            group[0].z,
            list(outer),
            [list(island) for island in islands],
            True,
            of_solid=group[0].of_solid,
            cut_to=group[0].cut_to,
            slack=slack,
            notes=notes,
            parts=parts,
            grown=True,
            beyond=[beyond for floor in group for beyond in floor.beyond],
        )
        for _, outer, islands in found
    ]


def _overlap(a, b):
    """Whether two floors have more in common than an edge, seen from above."""
    a, b = face_of(a), face_of(replace(b, z=a.z))
    return a.BoundBox.intersect(b.BoundBox) and a.common(b).Area > LEAST_OVERLAP


def _refuse_overlaps(found):
    """Raises ValueError where two floors at one height overlap, which would be cut as one."""
    for i, floor in enumerate(found):
        for other in found[:i]:
            if abs(floor.z - other.z) <= SAME_HEIGHT and _overlap(floor, other):
                raise ValueError(
                    "%s and %s overlap: draw what they enclose together as one, or use two "
                    "operations." % (other.name, floor.name)
                )


def _slack(item, within):
    """mm, by which chains made to `within` mm may leave the item's curves."""
    return 0.0 if is_exact(item.shape) else within


def _sentence(item, error):
    if item.is_face and error.reason == "tilted":
        return "%s is tilted: pick a face parallel to XY." % item.name
    if item.is_face and error.reason == "not planar":
        return "%s is not flat: pick a flat face parallel to XY." % item.name
    return "%s: %s" % (item.name, error)
