"""Solids to be finished: the source's test parts, and one with a spline surface."""

import math

import Part
from FreeCAD import Vector

HALF, DOME, FILLET, FLAT = 40.0, 45.0, 10.0, 10.0  # mm [Varga 2023, 3.1]
LEAN = math.asin((HALF - FLAT) / (DOME + FILLET))
CENTRE = (DOME + FILLET) * math.cos(LEAN)


def part(is_convex):
    """The part of 80 mm as a solid, its upper side centred on x = y = 0."""
    sign = 1 if is_convex else -1

    def at(y, z):
        return Vector(-HALF, y, sign * z)

    def on(radius, centre, lean, way):
        return at(centre[0] + way * radius * math.sin(lean), centre[1] + radius * math.cos(lean))

    def fillet(side, lean):
        return at(side * (HALF - FLAT - FILLET * math.sin(lean)), CENTRE - FILLET * math.cos(lean))

    level, bottom = CENTRE - FILLET, 20.0 if is_convex else 60.0
    edges = [
        Part.makeLine(at(-HALF, bottom), at(-HALF, level)),
        Part.makeLine(at(-HALF, level), fillet(-1, 0)),
        Part.Arc(fillet(-1, 0), fillet(-1, LEAN / 2), fillet(-1, LEAN)).toShape(),
        Part.Arc(fillet(-1, LEAN), at(0, DOME), fillet(1, LEAN)).toShape(),
        Part.Arc(fillet(1, LEAN), fillet(1, LEAN / 2), fillet(1, 0)).toShape(),
        Part.makeLine(fillet(1, 0), at(HALF, level)),
        Part.makeLine(at(HALF, level), at(HALF, bottom)),
        Part.makeLine(at(HALF, bottom), at(-HALF, bottom)),
    ]
    solid = Part.Face(Part.Wire(edges)).extrude(Vector(2 * HALF, 0, 0))
    assert solid.isValid()
    return solid


def upper(shape, least=0.1):
    """The names of the faces of a part's upper side, whose normals in the middle have a z above
    `least`.
    """
    found = []
    for number, face in enumerate(shape.Faces, 1):
        u0, u1, v0, v1 = face.ParameterRange
        if face.normalAt((u0 + u1) / 2, (v0 + v1) / 2).z > least:
            found.append("Face%d" % number)
    return tuple(found)


def cone():
    """A frustum of 20 and 5 mm and a height of 8 mm about the Z axis, round and level above."""
    return Part.makeCone(20, 5, 8)


def lofted():
    """A solid whose upper side is a spline surface."""
    wires = []
    for x, heights in ((0, (10, 18, 9, 14)), (20, (14, 9, 17, 8)), (45, (9, 12, 10, 16))):
        curve = Part.BSplineCurve()
        curve.interpolate([Vector(x, 12 * k, z) for k, z in enumerate(heights)])
        ends = [Vector(x, 0, heights[0]), Vector(x, 36, heights[-1])]
        corners = [ends[1], Vector(x, 36, 0), Vector(x, 0, 0), ends[0]]
        lines = [Part.makeLine(a, b) for a, b in zip(corners, corners[1:])]
        wires.append(Part.Wire([curve.toShape(), *lines]))
    return Part.makeLoft(wires, True)
