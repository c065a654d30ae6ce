# Reading regions from shapes: many edges, many outlines, curves that become arcs.
import math

import Part
from evenload import compiled
from FreeCAD import Vector
from timing import best_time

_occt = compiled.occt()
TOLERANCE = 0.005  # mm


def saw_face(teeth):
    points = []
    for i in range(2 * teeth):
        angle, radius = math.pi * i / teeth, 50 + 5 * (i % 2)
        points.append(Vector(radius * math.cos(angle), radius * math.sin(angle), 0))
    return Part.Face(Part.makePolygon(points + points[:1]))


def circles(rows):
    places = [Vector(x, y, 0) for x in range(rows) for y in range(rows)]
    return Part.Compound([Part.makeCircle(0.4, place) for place in places])


def ellipse():
    return Part.Ellipse(Vector(0, 0, 0), 40, 15).toShape()


def figures():
    shapes = {"saw_2000_edges": saw_face(1000), "circles_1600": circles(40), "ellipse": ellipse()}
    for name, shape in shapes.items():
        text = shape.exportBrepToString()
        yield "occt.%s.export" % name, 1e3 * best_time(shape.exportBrepToString), "ms"
        yield "occt.%s.read" % name, 1e3 * best_time(
            lambda: _occt.regions_from_brep(text, TOLERANCE)
        ), "ms"
    ((_, outer, _),) = _occt.regions_from_brep(ellipse().exportBrepToString(), TOLERANCE)
    yield "occt.ellipse.arcs", len(outer), "arcs"
