"""The check of a computed path against the job: its models, its stock, what was cut before.

It knows nothing of floors and regions, nor of how a path was made: the path is read back from its
own G-code, models are points of their surface, the stock is its height over the plane. What the
operation is told to cut of a model is read from the base geometry itself.
"""

import math
from dataclasses import dataclass

import numpy
import Part
from FreeCAD import Vector

from evenload import compiled, host
from evenload import tool as tools
from evenload.geometry import body
from evenload.geometry.floor import UP, inside, points_of
from evenload.simulation import earlier

CHECKED = "Checked against the model."
UNCHECKED = "Not checked against the model: Check is off."
# mm that a gouge may be deeper than the tolerance before it counts: what points, 1 per SPACING of
# the tool, leave uncertain on curves, and the rounding of posts.
BEYOND_TOLERANCE = 0.01
RIM = 0.02  # mm of the tool's rim that may touch what stands
SPACING = 0.03  # tool diameters between points of edges and sections
RASTER = 0.25  # tool diameters between points of upper sides
MOST_PER_SIDE = 400  # of that raster
ABOVE_LEVEL = 2e-3  # mm: sections are made so far above a path's levels
MOST_SECTIONS = 40  # levels at which a model that leans is cut; what lies between is seen at edges
DEEPER = 1e-3  # mm below a face, from which on the operation is meant to cut into it
BESIDE = 0.05  # mm beside a face's edge, where a model is looked for that its border keeps off
FEWEST = 9  # points along an edge
ON_BORDER = 0.01  # mm: points so near to a border are on it; polygons leave it by half of that
NEARER = 1e-3  # mm by which a centreline may come nearer to a slot's border than half its width
FIRST_LINES = "G21 G90\nF600\n"  # for the reader of G-code: FreeCAD's paths are always in mm
NO_POINTS = numpy.zeros((0, 3))


@dataclass
class Fault:
    """What a path may not do, and where."""

    kind: str  # gouge, rapid or plunge
    amount: float  # mm
    at: tuple  # (x, y, z)
    move: int  # its number among the path's moves, from 1
    sentence: str


def check(operation):
    """The Faults of an operation's path, the worst of each kind. Raises ValueError with a sentence
    where its path, or an earlier one's, cannot be followed.
    """
    job, core = host.parent_job(operation), compiled.core()
    tool, _ = tools.read(host.controller_of(operation))
    path = _program(operation)
    low, high, levels = core.extent_of(path)
    if not low:
        return []
    models = body.models_of(job)
    labels, points = [], []
    drawn = _Drawn(host.operation_under(operation), list(job.Model.Group))
    for label, each in models:
        found = drawn.left(_points(each, low, high, levels, tool.diameter))
        labels += [label] * len(found)
        points.append(found)
    stock = body.of(job.Stock.Shape).map
    borders = drawn.borders(SPACING * tool.diameter, stock, [each for _, each in models])
    labels += [drawn.name] * len(borders)
    points = numpy.vstack([NO_POINTS, *points, borders])
    options = {
        "tool_diameter": tool.diameter,
        "corner_radius": tools.corner_radius(host.controller_of(operation)),
        "bodies": points,
        "stock": stock,
        "gouge_limit": _tolerance(operation) + BEYOND_TOLERANCE,
        "rim": RIM,
    }
    found = core.faults_of(path, **options)
    if any(kind != "gouge" for kind, *_ in found):
        # Only then it matters what has been cut before.
        before = [(*cut, 0.0) for cut in earlier.cut_before(operation, [])]
        found = core.faults_of(path, earlier=before, **options)
    worst = {}
    for fault in found:
        if fault[0] not in worst or fault[1] > worst[fault[0]][1]:
            worst[fault[0]] = fault
    return [_fault(*fault, points, labels) for fault in worst.values()]


def _tolerance(operation):
    """mm by which an operation's path may leave the exact one."""
    tolerance = getattr(host.operation_under(operation), "Tolerance", None)
    return tolerance.Value if tolerance is not None else 0.0


def _program(operation):
    """A path as the core reads it back."""
    try:
        return compiled.core().read_gcode(FIRST_LINES + operation.Path.toGCode())
    except ValueError as error:
        raise ValueError(
            "The path of '%s' cannot be checked: %s" % (operation.Label, error)
        ) from None


def _points(each, low, high, levels, diameter):
    """Points, n x 3, of a body that the tool might meet on a path between two corners."""
    reach = 0.5 * diameter
    low = (low[0] - reach, low[1] - reach, low[2])
    high = (high[0] + reach, high[1] + reach, high[2])
    spacing = SPACING * diameter
    heights = [z + ABOVE_LEVEL for z in levels[:: math.ceil(len(levels) / MOST_SECTIONS) or 1]]
    points = numpy.vstack(
        [
            each.edge_points(low, high, spacing),
            each.section_points(heights, low, high, spacing),
            _upper_side(each, low, high, RASTER * diameter),
        ]
    )
    near = points[:, 2] > low[2]
    for axis in (0, 1):
        near &= (points[:, axis] > low[axis]) & (points[:, axis] < high[axis])
    return points[near]


def _upper_side(each, low, high, step):
    box = each.box
    x0, x1 = max(low[0], box.XMin), min(high[0], box.XMax)
    y0, y1 = max(low[1], box.YMin), min(high[1], box.YMax)
    if box.ZMax <= low[2] or x0 > x1 or y0 > y1:
        return NO_POINTS
    step = max(step, (x1 - x0) / MOST_PER_SIDE, (y1 - y0) / MOST_PER_SIDE)
    return each.map.raster(x0, y0, x1, y1, step)


class _Drawn:
    """What an operation is told to clear although the model stands there: outlines, slots round
    centrelines, and faces down to below them. It must not pass their borders: those of outlines
    and slots nowhere, those of faces where a model stands beyond.
    """

    def __init__(self, operation, models):
        self._models = models
        self.name = ""
        self.depth = getattr(getattr(operation, "FinalDepth", None), "Value", math.inf)
        self._start = getattr(getattr(operation, "StartDepth", None), "Value", math.inf)
        self._grounds = []  # (up to which height it is cut, its own height, nested polygons)
        self._outlines, self._faces, self._curves = [], [], []  # edges
        self._lines = []  # the curves as points, each n x 2
        self._width = getattr(getattr(operation, "SlotWidth", None), "Value", 0.0)
        labels = []
        base = getattr(operation, "Base", None) or []
        for obj, names in base if isinstance(base, list) else []:
            if not hasattr(obj, "Shape"):
                continue  # of an array: an operation
            shape = _placed(obj)
            parts = [shape.getElement(name) if name else shape for name in names or ("",)]
            faces = [part for part in parts if part.Faces and self._is_to_be_cut(part, obj)]
            edges = [edge for part in parts if not part.Faces for edge in part.Edges]
            faces_of = [part.Faces for part in faces]
            # Drawn faces that adjoin each other are one; those of a model may lie at any heights.
            groups = faces_of if self._of_model(obj) else [sum(faces_of, [])]
            for group in groups:
                self._add_faces(group, self._of_model(obj))
            self._add_edges(edges)
            labels += [obj.Label] if faces or edges else []
        self.name = ", ".join(dict.fromkeys(labels))

    def _is_to_be_cut(self, part, obj):
        """Whether faces were drawn by themselves, or lie higher than what is cut."""
        return not self._of_model(obj) or part.BoundBox.ZMin > self.depth + DEEPER

    def _of_model(self, obj):
        return bool(obj.Shape.Solids) or obj in self._models

    def _add_faces(self, faces, of_model):
        level = [face.translated(UP * -face.BoundBox.ZMax) for face in faces]
        if len(level) > 1:  # what two of them share is no border
            level = level[0].fuse(level[1:]).removeSplitter().Faces
        height = max((face.BoundBox.ZMax for face in faces), default=-math.inf)
        top = height + DEEPER if of_model else math.inf
        for face in level:
            self._grounds.append((top, height, _closed(face.Wires)))
            self._faces += face.Edges

    def _add_edges(self, edges):
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        if self._width > 0:
            self._curves += [edge for wire in wires for edge in wire.Edges]
            self._lines += [points_of(edge) for wire in wires for edge in wire.Edges]
            return
        closed = [wire for wire in wires if wire.isClosed()]
        if closed:
            self._grounds.append((math.inf, -math.inf, _closed(closed)))
            self._outlines += [edge for wire in closed for edge in wire.Edges]

    def _within(self, flat, margin, z=-math.inf):
        """For each of some points, n x 2 at the heights z, whether it lies on a ground that is to
        be cut, so many mm off its border.
        """
        result = numpy.zeros(len(flat), bool)
        for top, _, polygons in self._grounds:
            away = _away(flat, polygons)
            signed = numpy.where(inside(flat, polygons), away, -away)
            result |= (signed > margin) & (z < top)
        if self._lines:
            result |= _away(flat, self._lines) < 0.5 * self._width - margin
        return result

    def left(self, points):
        """Those of the points, n x 3, that must stay nevertheless."""
        if not self.name or not len(points):
            return points
        flat, z = numpy.ascontiguousarray(points[:, :2]), points[:, 2]
        goes = self._within(flat, ON_BORDER, z)
        # A face's own edge goes with it; what rises from there stays.
        for _, height, polygons in self._grounds:
            goes |= (_away(flat, polygons) < ON_BORDER) & (z < height + DEEPER)
        return points[~goes | (z < self.depth)]

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
        return [tuple(p) for p in points[_away(points, self._lines) > half - NEARER]]


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


def _fault(kind, amount, at, move, points, labels):
    place = "near (%.3f, %.3f, %.3f)" % at
    if kind == "gouge":
        nearest = int(numpy.abs(points - numpy.array(at)).sum(axis=1).argmin())
        sentence = "The path cuts %.3f mm into '%s' %s: change the depths, or what is picked." % (
            amount,
            labels[nearest],
            place,
        )
    elif kind == "rapid":
        sentence = (
            "The path has a rapid through %.3f mm of material %s: raise StartDepth and SafeHeight "
            "above what stands there, or clear it before." % (amount, place)
        )
    else:
        sentence = (
            "The path plunges into %.3f mm of material %s: raise StartDepth above what stands "
            "there, clear it before, or choose another Entry." % (amount, place)
        )
    return Fault(kind, amount, at, move, sentence)
