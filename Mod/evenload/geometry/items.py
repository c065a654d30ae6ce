"""What base geometry names: faces, edges and whole objects, as shapes to be read one by one."""

from dataclasses import dataclass

import Part

from evenload.geometry.floor import SAME_HEIGHT, is_exact
from evenload.words import name_of


@dataclass
class Item:
    parts: list  # of (label of the object, sub-element or '' for a whole object)
    shape: object
    is_face: bool
    of_solid: bool = False  # faces of a body

    @property
    def name(self):
        return name_of(self.parts)


def placed(obj):
    """An object's shape where it is in the world, None where it has none."""
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        return None
    container = obj.getGlobalPlacement() * obj.Placement.inverse()  # such as a sketch's body
    if not container.isIdentity():
        shape = shape.copy()
        shape.Placement = container * shape.Placement
    return shape


def element_of(shape, name):
    if not name:
        return shape
    try:
        return shape.getElement(name)
    except (ValueError, IndexError, AttributeError, Part.OCCError):
        return None


def items_of(base, models):
    """What to read one by one: faces, those that adjoin each other as one; each object's edges
    together; whole objects.
    """
    names_of = {}
    for obj, names in base:
        names_of.setdefault(obj, []).extend(names or ("",))
    result = []
    for obj, names in names_of.items():
        label = obj.Label
        shape = placed(obj)
        if shape is None:
            raise ValueError("'%s' has no shape: pick a face or a sketch." % label)
        edges = []
        for name in names:
            part = element_of(shape, name)
            if part is None:
                raise ValueError("There is no %s on %s: pick the geometry anew." % (name, label))
            if part.ShapeType == "Face":
                _refuse_downward(part, shape, "%s of %s" % (name, label))
                result.append(Item([(label, name)], part, True, _is_of_body(shape, models)))
            elif name and part.ShapeType in ("Edge", "Wire"):
                edges.append((name, part))
            elif name:
                raise ValueError(
                    "%s of %s is no face and no edge: pick a face or a sketch." % (name, label)
                )
            elif part.Solids or part.Shells:
                raise ValueError("%s is a solid: pick faces of it, or a sketch." % label)
            else:
                result.append(Item([(label, "")], part, bool(part.Faces)))
        if edges:
            shapes = Part.Compound([edge for _, edge in edges])
            result.append(Item([(label, name) for name, _ in edges], shapes, False))
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
    return Item(parts, Part.Compound(fused.Faces), True, of_solid)


def slack_of(item, within):
    """mm, by which chains made to `within` mm may leave the item's curves."""
    return 0.0 if is_exact(item.shape) else within


def sentence_of(item, error):
    if item.is_face and error.reason == "tilted":
        return "%s is tilted: pick a face parallel to XY." % item.name
    if item.is_face and error.reason == "not planar":
        return "%s is not flat: pick a flat face parallel to XY." % item.name
    return "%s: %s" % (item.name, error)
