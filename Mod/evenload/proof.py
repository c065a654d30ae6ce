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

from evenload import body, compiled, host, job_simulation
from evenload import tool as tools
from evenload.floor import UP, inside, points_of

CHECKED = "Checked against the model."
UNCHECKED = "Not checked against the model: Check is off."
# mm that a gouge may be deeper than the tolerance before it counts: what points, 1 per SPACING of
# the tool, leave uncertain on curves, and the rounding of posts.
BEYOND_TOLERANCE = 0.01
SPACING = 0.03  # tool diameters between points of edges and sections
RASTER = 0.25  # tool diameters between points of upper sides
MOST_PER_SIDE = 400  # of that raster
ABOVE_LEVEL = 2e-3  # mm: sections are made so far above a path's levels
MOST_SECTIONS = 40  # levels at which a model that leans is cut; what lies between is seen at edges
DEEPER = 1e-3  # mm below a face, from which on the operation is meant to cut into it
BESIDE = 0.05  # mm beside a face's edge, where a model is looked for that its border keeps off
AROUND = [(math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)) for k in range(8)]
FEWEST = 9  # points along an edge
ON_BORDER = 0.01  # mm: points so near to a border are on it; polygons leave it by half of that
SLOT_SAMPLES = 0.02  # slot widths between places of a centreline, of what the slot covers
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
    models = [(m.Label, body.of(m.Shape)) for m in job.Model.Group if not m.Shape.isNull()]
    labels, points = [], []
    drawn = _Drawn(host.operation_under(operation))
    for label, each in models:
        found = drawn.left(_points(each, low, high, levels, tool.diameter))
        labels += [label] * len(found)
        points.append(found)
    stock = body.of(job.Stock.Shape).map
    borders = drawn.borders(SPACING * tool.diameter, stock, [each.map for _, each in models])
    labels += [drawn.name] * len(borders)
    points = numpy.vstack([NO_POINTS, *points, borders])
    options = {
        "tool_diameter": tool.diameter,
        "corner_radius": tools.corner_radius(host.controller_of(operation)),
        "bodies": points,
        "stock": stock,
        "gouge_limit": operation_tolerance(operation) + BEYOND_TOLERANCE,
    }
    found = core.faults_of(path, **options)
    if any(kind != "gouge" for kind, *_ in found):
        # Only then it matters what has been cut before.
        before = [(*cut, 0.0) for cut in job_simulation.cut_before(operation, [])]
        found = core.faults_of(path, earlier=before, **options)
    worst = {}
    for fault in found:
        if fault[0] not in worst or fault[1] > worst[fault[0]][1]:
            worst[fault[0]] = fault
    return [_fault(*fault, points, labels) for fault in worst.values()]


def operation_tolerance(operation):
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
    """Points, n x 3, of a body that the tool might meet between two corners of its path."""
    reach = 0.5 * diameter
    if each.box.ZMax <= low[2] or not _meet(each.box, low, high, reach):
        return NO_POINTS
    spacing = SPACING * diameter
    found = [each.edge_points(spacing)]
    if not each.is_prismatic(low[2]):
        heights = levels[:: max(1, math.ceil(len(levels) / MOST_SECTIONS))]
        found += [each.section_points(z + ABOVE_LEVEL, spacing) for z in heights]
    found.append(_upper_side(each, low, high, reach, RASTER * diameter))
    points = numpy.vstack(found)
    near = points[:, 2] > low[2]
    for axis in (0, 1):
        near &= points[:, axis] > low[axis] - reach
        near &= points[:, axis] < high[axis] + reach
    return points[near]


def _upper_side(each, low, high, reach, step):
    box = each.box
    x0, x1 = max(low[0] - reach, box.XMin), min(high[0] + reach, box.XMax)
    y0, y1 = max(low[1] - reach, box.YMin), min(high[1] + reach, box.YMax)
    step = max(step, (x1 - x0) / MOST_PER_SIDE, (y1 - y0) / MOST_PER_SIDE)
    return each.map.raster(x0, y0, x1, y1, step)


def _meet(box, low, high, reach):
    return (
        box.XMin < high[0] + reach
        and box.XMax > low[0] - reach
        and box.YMin < high[1] + reach
        and box.YMax > low[1] - reach
    )


class _Drawn:
    """What an operation is told to clear although the model stands there: outlines, slots round
    centrelines, and faces down to below them. It must not pass their borders: those of outlines
    and slots nowhere, those of faces where a model stands beyond.
    """

    def __init__(self, operation):
        self.name = ""
        self.depth = operation.FinalDepth.Value
        self._grounds = []  # (height of a face, nested polygons); no height for outlines
        self._outlines, self._faces, self._curves = [], [], []  # edges
        self._width = getattr(getattr(operation, "SlotWidth", None), "Value", 0.0)
        labels = []
        for obj, names in operation.Base:
            shape = _placed(obj)
            parts = [shape.getElement(name) if name else shape for name in names or ("",)]
            faces = [part for part in parts if part.Faces and self._is_to_be_cut(part, shape)]
            edges = [edge for part in parts if not part.Faces for edge in part.Edges]
            self._add_faces([face for part in faces for face in part.Faces])
            self._add_edges(edges)
            labels += [obj.Label] if faces or edges else []
        self.name = ", ".join(dict.fromkeys(labels))

    def _is_to_be_cut(self, part, shape):
        """Whether faces were drawn by themselves, or lie higher than what is cut."""
        return not shape.Solids or part.BoundBox.ZMin > self.depth + DEEPER

    def _add_faces(self, faces):
        level = [face.translated(UP * -face.BoundBox.ZMax) for face in faces]
        if len(level) > 1:  # what two of them share is no border
            level = level[0].fuse(level[1:]).removeSplitter().Faces
        height = max((face.BoundBox.ZMax for face in faces), default=-math.inf)
        for face in level:
            self._grounds.append((height, [points_of(wire) for wire in face.Wires]))
            self._faces += face.Edges

    def _add_edges(self, edges):
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        if self._width > 0:
            self._curves += [edge for wire in wires for edge in wire.Edges]
            return
        closed = [wire for wire in wires if wire.isClosed()]
        if closed:
            self._grounds.append((-math.inf, [points_of(wire) for wire in closed]))
            self._outlines += [edge for wire in closed for edge in wire.Edges]

    def _within(self, flat, margin):
        """For each of some points, n x 2, whether it lies on a ground that is to be cut, and so
        many mm off its border; with a negative margin whether it lies so near to one.
        """
        around = [flat + margin * numpy.array(side) for side in AROUND]
        result = numpy.zeros(len(flat), bool)
        for _, polygons in self._grounds:
            found = [inside(moved, polygons) for moved in around]
            result |= numpy.all(found, axis=0) if margin > 0 else numpy.any(found, axis=0)
        away = numpy.full(len(flat), math.inf)
        for x, y in self._samples(SLOT_SAMPLES * self._width):
            away = numpy.minimum(away, numpy.hypot(flat[:, 0] - x, flat[:, 1] - y))
        return result | (away < 0.5 * self._width - margin)

    def left(self, points):
        """Those of the points, n x 3, that must stay nevertheless."""
        if not self.name or not len(points):
            return points
        flat = numpy.ascontiguousarray(points[:, :2])
        goes = self._within(flat, ON_BORDER)
        # A face's own edge goes with it; what rises from there stays.
        height = max((height for height, _ in self._grounds), default=-math.inf)
        goes |= self._within(flat, -ON_BORDER) & (points[:, 2] < height + DEEPER)
        return points[~goes | (points[:, 2] < self.depth)]

    def borders(self, spacing, stock, models):
        """Points of what must not be passed, n x 3, as high as what stands there. stock and
        models: HeightMaps.
        """
        found = [(p.x, p.y) for edge in self._outlines for p in _along(edge, spacing)]
        found += self._slot_border(spacing)
        points = [(x, y, stock.top_at(x, y)) for x, y in found]
        for edge in self._faces:
            for p, side in _beside(edge, spacing):
                beyond = numpy.array(
                    [(p.x + s * side.x, p.y + s * side.y) for s in (BESIDE, -BESIDE)]
                )
                for x, y in beyond[~self._within(beyond, ON_BORDER)]:
                    top = max((model.top_at(x, y) for model in models), default=-math.inf)
                    points.append((p.x, p.y, top))
        points = [point for point in points if math.isfinite(point[2])]
        return numpy.array(points).reshape(-1, 3)

    def _samples(self, spacing):
        return [(p.x, p.y) for edge in self._curves for p in _along(edge, spacing)]

    def _slot_border(self, spacing):
        """(x, y) half the slot's width beside its centrelines, to both sides, where no other part
        of them is nearer.
        """
        own = numpy.array(self._samples(spacing)).reshape(-1, 2)
        half, found = 0.5 * self._width, []
        for edge in self._curves:
            for p, side in _beside(edge, spacing):
                for x, y in ((p.x + s * side.x, p.y + s * side.y) for s in (half, -half)):
                    if numpy.hypot(own[:, 0] - x, own[:, 1] - y).min() > half - NEARER:
                        found.append((x, y))
        return found


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
