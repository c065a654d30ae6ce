"""Edges and faces seen from above: as they lie in the plane z = 0."""

import math

import FreeCAD
import numpy
import Part

from evenload import compiled, waiting
from evenload.geometry.floor import UP, faces_within

LEVEL = 1e-9  # of unit vectors: what is as level, or as upright, as this is so exactly
FLAT = 1e-9  # mm: edges that rise by less lie in a level plane
DEFLECTION = 0.005  # mm: triangles leave round surfaces by this at the most
TURN = 0.5  # rad between neighbouring triangles, at the most
SAME_PARAMETER = 1e-6  # of surfaces
PROJECTED = 0.001  # mm: points on edges that are drawn anew in the plane lie as near as that
POINTS = 9  # the fewest of these on a curve
SHORTEST = 1e-7  # mm: edges that come out shorter have become points


def is_seam(edge, face):
    """Whether a face lies to both sides of an edge, where its surface closes. OpenCASCADE calls an
    edge that lies there a seam also where the face ends at it.
    """
    if edge.Degenerated or not edge.isSeam(face):
        return False
    surface = face.Surface
    middle = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
    u, v = surface.parameter(middle)
    u0, u1, v0, v1 = face.ParameterRange
    whole_u0, whole_u1, whole_v0, whole_v1 = surface.bounds()
    for at, low, high, whole, closes in (
        (u, u0, u1, whole_u1 - whole_u0, surface.isUClosed()),
        (v, v0, v1, whole_v1 - whole_v0, surface.isVClosed()),
    ):
        is_at_end = min(abs(at - low), abs(at - high)) < SAME_PARAMETER
        if closes and is_at_end and high - low > whole - SAME_PARAMETER:
            return True
    return False


def under_triangles(faces):
    """The faces in the plane that lie under any of some faces, as near as triangles are."""
    corners = []
    for face in faces:
        waiting.go_on()
        points, triangles = triangles_of(face, DEFLECTION)
        corners += [[(points[k].x, points[k].y) for k in triangle] for triangle in triangles]
    wires = []
    for outline in compiled.core().united(corners, DEFLECTION / 2):
        points = [FreeCAD.Vector(x, y, 0) for x, y in outline]
        wires.append(Part.makePolygon([*points, points[0]]))
    return faces_within(wires)


def triangles_of(shape, deflection):
    """(points, triangles as three of their numbers each) within `deflection` mm of a shape's faces.

    Shape.tessellate() turns by no more than 5 `deflection` rad from one triangle to the next, which
    made 13 000 of a countersink, and seconds of a dozen. For flat faces it is as good, and needs no
    module that takes 0.2 s to load.
    """
    if all(isinstance(face.Surface, Part.Plane) for face in shape.Faces):
        return shape.tessellate(deflection)
    import MeshPart  # here, since it is slow to load

    return MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=deflection, AngularDeflection=TURN, Relative=False
    ).Topology


def drawn_in_plane(edge):
    if edge.Degenerated:  # a pole, which has no curve
        return None
    box = edge.BoundBox
    if isinstance(edge.Curve, Part.Line):
        ends = [edge.valueAt(parameter) for parameter in edge.ParameterRange]
        start, end = (FreeCAD.Vector(p.x, p.y, 0) for p in ends)
        return Part.makeLine(start, end) if (end - start).Length > SHORTEST else None
    if max(box.XLength, box.YLength) < SHORTEST:
        return None
    if box.ZLength < FLAT or _is_level_curve(edge.Curve):
        return edge.translated(UP * -edge.valueAt(edge.FirstParameter).z)
    if isinstance(edge.Curve, Part.Circle) and abs(edge.Curve.Axis.z) > 1 - LEVEL:
        return _flattened_arc(edge)
    points = edge.discretize(Deflection=PROJECTED)
    if len(points) < POINTS:
        points = edge.discretize(Number=POINTS)
    points = [FreeCAD.Vector(p.x, p.y, 0) for p in points]
    if _is_straight(points):
        return Part.makeLine(points[0], points[-1])
    curve = Part.BSplineCurve()
    if (points[0] - points[-1]).Length > SHORTEST:
        curve.interpolate(points)
    else:
        curve.interpolate(points[:-1], PeriodicFlag=True)
    return curve.toShape()


def _is_level_curve(curve):
    if not isinstance(curve, (Part.Circle, Part.Ellipse)):
        return False
    return math.hypot(curve.Axis.x, curve.Axis.y) < LEVEL


def _flattened_arc(edge):
    """An arc that lies askew by no more than level faces may, in the plane z = 0."""
    first, last = edge.ParameterRange
    ends = [edge.valueAt(first + share * (last - first)) for share in (0, 0.5, 1)]
    start, middle, end = (FreeCAD.Vector(p.x, p.y, 0) for p in ends)
    if (end - start).Length > SHORTEST:
        return Part.Arc(start, middle, end).toShape()
    centre = edge.Curve.Center
    return Part.makeCircle(edge.Curve.Radius, FreeCAD.Vector(centre.x, centre.y, 0))


def _is_straight(points):
    along = points[-1] - points[0]
    if along.Length < SHORTEST:
        return False
    return all(p.distanceToLine(points[0], along) < SHORTEST for p in points)


def points_along(edge, spacing):
    """Points of an edge, n x 3; of an upright line only its upper end, which is what stands."""
    if isinstance(edge.Curve, Part.Line):
        a, b = (edge.valueAt(parameter) for parameter in edge.ParameterRange)
        if math.hypot(b.x - a.x, b.y - a.y) < SHORTEST:
            return numpy.array([tuple(max(a, b, key=lambda p: p.z))])
        share = numpy.linspace(0, 1, max(2, math.ceil((b - a).Length / spacing) + 1))[:, None]
        return numpy.array([tuple(a)]) * (1 - share) + numpy.array([tuple(b)]) * share
    count = max(POINTS, math.ceil(edge.Length / spacing) + 1)
    return numpy.array([tuple(p) for p in edge.discretize(Number=count)])
