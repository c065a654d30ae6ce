"""The check of a computed path against the job: its models, its stock, what was cut before.

It knows nothing of floors and regions, nor of how a path was made: the path is read back from its
own G-code, models are points of their surface, the stock is its height over the plane. What the
operation is told to cut of a model is read from the base geometry itself.
"""

import math
from dataclasses import dataclass

import numpy
import Part

from evenload import body, compiled, host
from evenload import tool as tools
from evenload.floor import inside, points_of
from evenload.operations.settings import HOLE_ENTRIES

CHECKED = "Checked against the model."
UNCHECKED = "Not checked against the model: Check is off."
# mm that a gouge may be deeper than the tolerance before it counts: what points, 1 per SPACING of
# the tool, leave uncertain on curves, and the rounding of posts.
BEYOND_TOLERANCE = 0.01
SPACING = 0.05  # tool diameters between points of edges and sections
RASTER = 0.25  # tool diameters between points of upper sides
MOST_PER_SIDE = 400  # of that raster
ABOVE_LEVEL = 2e-3  # mm: sections are made so far above a path's levels
MOST_SECTIONS = 40  # levels at which a model that leans is cut; what lies between is seen at edges
DEEPER = 1e-3  # mm below a face, from which on the operation is meant to cut into it
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
    outline = drawn.outline(SPACING * tool.diameter, stock)
    labels += [drawn.name] * len(outline)
    points = numpy.vstack([NO_POINTS, *points, outline])
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
        found = core.faults_of(path, earlier=earlier(job, operation), **options)
    worst = {}
    for fault in found:
        if fault[0] not in worst or fault[1] > worst[fault[0]][1]:
            worst[fault[0]] = fault
    return [_fault(*fault, points, labels) for fault in worst.values()]


def operation_tolerance(operation):
    """mm by which an operation's path may leave the exact one."""
    tolerance = getattr(host.operation_under(operation), "Tolerance", None)
    return tolerance.Value if tolerance is not None else 0.0


def earlier(job, operation):
    """[(path, diameter, corner radius in mm), ...] of the job's active operations before one, and
    of the holes drilled for them.
    """
    result = []
    inner = host.operation_under(operation)
    for other in host.operations(job):
        result += _hole(host.operation_under(other), job)
        if host.operation_under(other) is inner:
            break
        controller = host.controller_of(other)
        if not host.is_active(other) or controller is None or not controller.Tool:
            continue
        diameter = tools.diameter(controller)
        if diameter > 0 and other.Path.Commands:
            corner = tools.corner_radius(controller)
            if not tools.other_shape(controller):
                result.append((_program(other), diameter, corner))
            elif tools.is_drill(controller):
                moves = _program(other).moves
                for above, width in tools.discs(controller):
                    result.append(([(*m[:3], m[3] + above, *m[4:]) for m in moves], width, 0.0))
    return result


def _program(operation):
    """A path as the core reads it back."""
    try:
        return compiled.core().read_gcode(FIRST_LINES + operation.Path.toGCode())
    except ValueError as error:
        raise ValueError(
            "The path of '%s' cannot be checked: %s" % (operation.Label, error)
        ) from None


def _hole(operation, job):
    """The pre-drilled hole of an operation as the way of its drill."""
    diameter = getattr(operation, "HoleDiameter", None)
    if diameter is None or not diameter.Value > 0 or operation.Entry not in HOLE_ENTRIES:
        return []
    at, top = operation.EntryPoint, job.Stock.Shape.BoundBox.ZMax + 1.0
    ends = ((0, top, 0.0), (3, operation.FinalDepth.Value, 1.0))
    moves = [(kind, at.x, at.y, z, 0.0, 0.0, 0.0, feed) for kind, z, feed in ends]
    return [(moves, diameter.Value, 0.0)]


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
    centrelines, and faces down to below them. Its borders must not be passed, whatever stands
    there.
    """

    def __init__(self, operation):
        self.name = ""
        self.depth = operation.FinalDepth.Value
        self._polygons, self._edges, self._curves = [], [], []
        self._width = getattr(getattr(operation, "SlotWidth", None), "Value", 0.0)
        labels = []
        for obj, names in operation.Base:
            shape = Part.getShape(obj)
            container = obj.getGlobalPlacement() * obj.Placement.inverse()
            shape = shape.copy()
            shape.Placement = container * shape.Placement
            edges = []
            for name in names or ("",):
                part = shape.getElement(name) if name else shape
                if part.ShapeType in ("Edge", "Wire"):
                    edges += part.Edges
                    labels.append(obj.Label)
                elif part.Faces and self._is_to_be_cut(part, shape):
                    self._add_faces(part.Faces)
                    labels.append(obj.Label)
                elif not part.Faces:
                    edges += part.Edges
                    labels.append(obj.Label)
            self._add_edges(edges)
        self.name = ", ".join(dict.fromkeys(labels))

    def _is_to_be_cut(self, part, shape):
        """Whether faces are outlines drawn by themselves, or lie higher than what is cut."""
        return not shape.Solids or part.BoundBox.ZMin > self.depth + DEEPER

    def _add_faces(self, faces):
        for face in faces:
            self._polygons.append([points_of(wire) for wire in face.Wires])
            self._edges += face.Edges

    def _add_edges(self, edges):
        wires = [Part.Wire(each) for each in Part.sortEdges(edges)] if edges else []
        if self._width > 0:
            self._curves += [edge for wire in wires for edge in wire.Edges]
            return
        closed = [wire for wire in wires if wire.isClosed()]
        if closed:
            self._polygons.append([points_of(wire) for wire in closed])
            self._edges += [edge for wire in closed for edge in wire.Edges]

    def left(self, points):
        """Those of the points, n x 3, that must stay nevertheless."""
        if not self.name or not len(points):
            return points
        stays = numpy.ones(len(points), bool)
        flat = numpy.ascontiguousarray(points[:, :2])
        for polygons in self._polygons:
            stays &= ~inside(flat, polygons)
        for samples in self._samples(0.1 * self._width):
            for x, y in samples:
                stays &= numpy.hypot(flat[:, 0] - x, flat[:, 1] - y) > 0.5 * self._width
        return points[stays | (points[:, 2] < self.depth)]

    def outline(self, spacing, stock):
        """Points of the borders at the height of the stock there, n x 3."""
        found = [
            (p.x, p.y) for edge in self._edges for p in _along(edge, spacing)
        ] + self._slot_border(spacing)
        tops = ((x, y, stock.top_at(x, y)) for x, y in found)
        points = [point for point in tops if math.isfinite(point[2])]
        return numpy.array(points).reshape(-1, 3)

    def _samples(self, spacing):
        return [[(p.x, p.y) for p in _along(edge, spacing)] for edge in self._curves]

    def _slot_border(self, spacing):
        """(x, y) half the slot's width beside its centrelines, to both sides, where no other part
        of them is nearer.
        """
        if not self._curves:
            return []
        own = numpy.array([p for each in self._samples(spacing) for p in each])
        found = []
        for edge in self._curves:
            count = max(2, math.ceil(edge.Length / spacing) + 1)
            first, last = edge.ParameterRange
            for k in range(count):
                u = first + k / (count - 1) * (last - first)
                p, t = edge.valueAt(u), edge.tangentAt(u)
                for side in (0.5 * self._width, -0.5 * self._width):
                    x, y = p.x - side * t.y, p.y + side * t.x
                    away = numpy.hypot(own[:, 0] - x, own[:, 1] - y).min()
                    if away > 0.5 * self._width - 1e-3:
                        found.append((x, y))
        return found


def _along(edge, spacing):
    return edge.discretize(Number=max(9, math.ceil(edge.Length / max(spacing, 1e-3)) + 1))


def _fault(kind, amount, at, move, points, labels):
    place = "near (%.3f, %.3f, %.3f)" % at
    if kind == "gouge":
        nearest = int(numpy.abs(points - numpy.array(at)).sum(axis=1).argmin())
        sentence = (
            "The path cuts %.3f mm into '%s' %s: change the depths, or what is picked."
            % (amount, labels[nearest], place)
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
