"""The check of a computed path against the job: its models, its stock, what was cut before.

It knows nothing of floors and regions, nor of how a path was made: the path is read back from its
own G-code, models are points of their surface, the stock is its height over the plane. What the
operation is told to cut of a model is read from the base geometry itself.
"""

import math
from dataclasses import dataclass

import numpy

from evenload import compiled, host
from evenload import tool as tools
from evenload.geometry import body
from evenload.simulation import earlier
from evenload.simulation.drawn import Drawn

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
    drawn = Drawn(host.operation_under(operation), list(job.Model.Group))
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
