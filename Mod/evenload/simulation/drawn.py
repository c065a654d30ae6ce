"""What an operation is told to cut although the model stands there, for the check of its path.

It is read from the base geometry itself, and knows nothing of floors and regions.
"""

import math

import numpy
import Part
from FreeCAD import Vector

from evenload import compiled
from evenload.geometry.depths import depth_of
from evenload.geometry.floor import UP, inside, points_of
from evenload.settings.properties import is_ours

DEEPER = 1e-3  # mm below a face, from which on the operation is meant to cut into it
BESIDE = 0.05  # mm beside a face's edge, where a model is looked for that its border keeps off
FEWEST = 9  # points along an edge
ON_BORDER = 0.01  # mm: points so near to a border are on it; polygons leave it by half of that
NEARER = 1e-3  # mm by which a centreline may come nearer to a slot's border than half its width
HEIGHT_DIGITS = 4  # of mm: outlines whose heights are the same to these are at one height


class Drawn:
    """What an operation is told to clear although the model stands there: outlines, slots round
    centrelines, and faces down to below them. It must not pass their borders: those of outlines
    and slots nowhere, those of faces where a model stands beyond.
    """

    def __init__(self, operation, models):
        self._models = models
        self.name = ""
        self._operation = operation
        self._start = getattr(getattr(operation, "StartDepth", None), "Value", math.inf)
        # (up to which height it is cut, its own height, down to where, nested polygons)
        self._grounds = []
        self._outlines, self._faces, self._curves = [], [], []  # edges
        self._lines = {}  # the curves as points, [n x 2, ...], by the depth of their slots
        self._width = getattr(getattr(operation, "SlotWidth", None), "Value", 0.0)
        labels = []
        base = getattr(operation, "Base", None) or []
        for obj, names in base if isinstance(base, list) else []:
            if not hasattr(obj, "Shape"):
                continue  # of an array: an operation
            shape = _placed(obj)
            parts = [shape.getElement(name) if name else shape for name in names or ("",)]
            faces_of = [
                [face for face in part.Faces if self._is_to_be_cut(face, obj)] for part in parts
            ]
            faces_of = [faces for faces in faces_of if faces]
            edges = [edge for part in parts if not part.Faces for edge in part.Edges]
            # Drawn faces that adjoin each other are one; those of a model may lie at any heights.
            groups = faces_of if self._of_model(obj) else [sum(faces_of, [])]
            for group in groups:
                self._add_faces(group, self._of_model(obj))
            self._add_edges(edges)
            labels += [obj.Label] if faces_of or edges else []
        self.name = ", ".join(dict.fromkeys(labels))

    def _is_to_be_cut(self, face, obj):
        """Whether a face was drawn by itself, or lies higher than what is cut."""
        z = face.BoundBox.ZMin
        return not self._of_model(obj) or z > self._depth(z, True) + DEEPER

    def _depth(self, z, is_face):
        """z in mm down to which the operation cuts what lies at a height; FreeCAD's own operations
        cut all to one depth.
        """
        if is_ours(self._operation):
            return depth_of(self._operation, z, is_face)
        return getattr(getattr(self._operation, "FinalDepth", None), "Value", math.inf)

    def _of_model(self, obj):
        return bool(obj.Shape.Solids) or obj in self._models

    def _add_faces(self, faces, of_model):
        level = [face.translated(UP * -face.BoundBox.ZMax) for face in faces]
        if len(level) > 1:  # what two of them share is no border
            level = level[0].fuse(level[1:]).removeSplitter().Faces
        height = max((face.BoundBox.ZMax for face in faces), default=-math.inf)
        top, depth = height + DEEPER if of_model else math.inf, self._depth(height, True)
        for face in level:
            self._grounds.append((top, height, depth, _closed(face.Wires)))
            self._faces += face.Edges

    def _add_edges(self, edges):
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        if self._width > 0:
            for edge in [edge for wire in wires for edge in wire.Edges]:
                depth = self._depth(edge.BoundBox.ZMax, False)
                self._curves.append(edge)
                self._lines.setdefault(depth, []).append(points_of(edge))
            return
        closed = [wire for wire in wires if wire.isClosed()]
        by_height = {}
        for wire in closed:
            by_height.setdefault(round(wire.BoundBox.ZMax, HEIGHT_DIGITS), []).append(wire)
        for z, level in by_height.items():
            self._grounds.append((math.inf, -math.inf, self._depth(z, False), _closed(level)))
            self._outlines += [edge for wire in level for edge in wire.Edges]

    def _within(self, flat, margin, z=None):
        """For each of some points, n x 2, whether it lies on a ground that is to be cut, so many mm
        off its border; z: their heights, at which it must be to be cut, too.
        """
        result = numpy.zeros(len(flat), bool)
        for top, _, depth, polygons in self._grounds:
            away = _away(flat, polygons)
            signed = numpy.where(inside(flat, polygons), away, -away)
            found = signed > margin
            result |= found if z is None else found & (z < top) & (z >= depth)
        for depth, lines in self._lines.items():
            found = _away(flat, lines) < 0.5 * self._width - margin
            result |= found if z is None else found & (z >= depth)
        return result

    def left(self, points):
        """Those of the points, n x 3, that must stay nevertheless."""
        if not self.name or not len(points):
            return points
        flat, z = numpy.ascontiguousarray(points[:, :2]), points[:, 2]
        goes = self._within(flat, ON_BORDER, z)
        # A face's own edge goes with it; what rises from there stays.
        for _, height, depth, polygons in self._grounds:
            on_border = _away(flat, polygons) < ON_BORDER
            goes |= on_border & (z < height + DEEPER) & (z >= depth)
        return points[~goes]

    def borders(self, spacing, stock, models):
        """Points of what must not be passed, n x 3, as high as what stands there, but no higher
        than where the operation starts. stock: a HeightMap; models: Bodies.
        """
        found = [(p.x, p.y) for edge in self._outlines for p in _along(edge, spacing)]
        found += self._slot_border(spacing)
        points = [(x, y, min(stock.top_at(x, y), self._start)) for x, y in found]
        for edge in self._faces:
            for p, side in _beside(edge, spacing):
                beyond = numpy.array(
                    [(p.x + s * side.x, p.y + s * side.y) for s in (BESIDE, -BESIDE)]
                )
                for x, y in beyond[~self._within(beyond, ON_BORDER)]:
                    top = max((each.map.top_at(x, y) for each in models), default=-math.inf)
                    points.append((p.x, p.y, top))
        points = [point for point in points if math.isfinite(point[2])]
        return numpy.array(points).reshape(-1, 3)

    def _slot_border(self, spacing):
        """(x, y) half the slot's width beside its centrelines, to both sides, where no other part
        of them is nearer.
        """
        half = 0.5 * self._width
        points = [
            (p.x + s * side.x, p.y + s * side.y)
            for edge in self._curves
            for p, side in _beside(edge, spacing)
            for s in (half, -half)
        ]
        points = numpy.array(points).reshape(-1, 2)
        lines = [line for each in self._lines.values() for line in each]
        return [tuple(p) for p in points[_away(points, lines) > half - NEARER]]


def _closed(wires):
    """Closed wires as polygons whose first point is repeated."""
    polygons = [points_of(wire) for wire in wires]
    return [numpy.vstack([polygon, polygon[:1]]) for polygon in polygons]


def _away(points, lines):
    """mm from points, n x 2, to the nearest of lines through points, each m x 2; inf without."""
    starts = numpy.vstack([numpy.zeros((0, 2)), *(line[:-1] for line in lines)])
    ends = numpy.vstack([numpy.zeros((0, 2)), *(line[1:] for line in lines)])
    return compiled.core().distances(points, starts, ends)


def _placed(obj):
    """An object's shape where it is in the world."""
    shape = obj.Shape.copy()
    shape.Placement = obj.getGlobalPlacement() * obj.Placement.inverse() * shape.Placement
    return shape


def _along(edge, spacing):
    return edge.discretize(Number=max(FEWEST, math.ceil(edge.Length / spacing) + 1))


def _beside(edge, spacing):
    """[(a point of an edge, the level unit vector across it), ...]"""
    count = max(FEWEST, math.ceil(edge.Length / spacing) + 1)
    first, last = edge.ParameterRange
    result = []
    for k in range(count):
        at = first + k / (count - 1) * (last - first)
        along = edge.tangentAt(at)
        result.append((edge.valueAt(at), Vector(-along.y, along.x, 0)))
    return result
