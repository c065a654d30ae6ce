"""Parts to measure, and points as they are measured on them."""

import math

import numpy
import Part
from FreeCAD import Vector

from evenload import face_inspection, inspection

SIDE = numpy.linspace(-38, 38, 21)
X, Y = (grid.ravel() for grid in numpy.meshgrid(SIDE, SIDE))
BELOW = 30.0  # mm of the dome's block


def dome(part):
    """The solid of the source's test part, 80 mm long."""
    edges = []
    pieces = zip(part.starts, part.starts[1:], part.leans, part.leans[1:], part.curvatures)
    for start, end, lean, after, curvature in pieces:
        if not curvature:
            edges.append(Part.makeLine(Vector(-40, *start), Vector(-40, *end)))
            continue
        half = 0.5 * (lean + after)
        way = numpy.array([math.sin(half) - math.sin(lean), math.cos(half) - math.cos(lean)])
        places = [Vector(-40, *place) for place in (start, start + way / curvature, end)]
        edges.append(Part.Arc(*places).toShape())
    (y0, z0), (y1, z1) = part.starts[0], part.starts[-1]
    corners = [(y1, z1), (y1, z0 - BELOW), (y0, z0 - BELOW), (y0, z0)]
    edges += [Part.makeLine(Vector(-40, *a), Vector(-40, *b)) for a, b in zip(corners, corners[1:])]
    return Part.Face(Part.Wire(edges)).extrude(Vector(80, 0, 0))


def faces_of(doc, shape, names):
    """PickedFaces of a new object with a shape."""
    obj = doc.addObject("Part::Feature", "Part")
    obj.Shape = shape
    doc.recompute()
    return face_inspection.picked([(obj, names)])


def upper_faces(shape):
    """Names of the faces that look up."""
    return [
        "Face%d" % number
        for number, face in enumerate(shape.Faces, 1)
        if face.normalAt(*face.Surface.parameter(face.CenterOfMass)).z > 0.1
    ]


def as_measured(points):
    """MeasuredPoints that are numbered from 1."""
    return face_inspection.MeasuredPoints(
        ["%d" % (number + 1) for number in range(len(points))], numpy.asarray(points, dtype=float)
    )


def bores_of(shape):
    """Names of the cylindrical faces."""
    return [
        "Face%d" % n for n, f in enumerate(shape.Faces, 1) if isinstance(f.Surface, Part.Cylinder)
    ]


def wall_points(count, deviations):
    """Points of a bore's wall, all around and over its height; positive deviations are outside."""
    turns = 2 * math.pi * numpy.arange(count) / count
    radii = 8 + numpy.asarray(deviations)
    heights = numpy.where(numpy.arange(count) % 2, 18.0, 2.0)
    return numpy.stack(
        [25 + radii * numpy.cos(turns), 25 + radii * numpy.sin(turns), heights], axis=1
    )


def dome_faces(doc):
    """The picked upper faces of the test part CX."""
    solid = dome(inspection.test_part("CX"))
    return faces_of(doc, solid, upper_faces(solid))


def bore_faces(doc):
    """The picked wall of a bore of 8 mm radius through a block of 20 mm."""
    shape = Part.makeBox(50, 50, 20).cut(Part.makeCylinder(8, 40, Vector(25, 25, -5)))
    return faces_of(doc, shape, bores_of(shape))
