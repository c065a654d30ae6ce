"""Makes examples/star.FCStd: a five-pointed star pocket, 3 mm deep in a block.

    freecadcmd examples/make_star.py

The star's corners lie at 23.9 mm from its middle and at half of that; the outer ones are rounded
with 3.2 mm, the inner ones with 1 mm. It is the pocket of the experiments in [Jacsó 2021].
"""

import math
import os
import sys

import FreeCAD
import Part
from FreeCAD import Vector

POINT = 23.922436975676842  # mm from the middle to the sharp points, before they are rounded
POINT_RADIUS, CORNER_RADIUS = 3.2, 1.0  # mm
DEPTH, BLOCK, MARGIN = 3.0, 10.0, 10.0  # mm


def rounded(before, corner, after, radius):
    """The arc that rounds a corner: (start, middle, end)."""
    to_before = (before - corner).normalize()
    to_after = (after - corner).normalize()
    half = 0.5 * to_before.getAngle(to_after)
    inwards = (to_before + to_after).normalize()
    centre = corner + inwards * (radius / math.sin(half))
    reach = radius / math.tan(half)
    return corner + to_before * reach, centre - inwards * radius, corner + to_after * reach


def star():
    corners = []
    for k in range(10):
        angle = math.radians(90 + 36 * k)
        distance = POINT if k % 2 == 0 else 0.5 * POINT
        corners.append(Vector(distance * math.cos(angle), distance * math.sin(angle), 0))
    arcs = []
    for k, corner in enumerate(corners):
        radius = POINT_RADIUS if k % 2 == 0 else CORNER_RADIUS
        arcs.append(rounded(corners[k - 1], corner, corners[(k + 1) % 10], radius))
    edges = []
    for arc, following in zip(arcs, arcs[1:] + arcs[:1]):
        edges.append(Part.Arc(*arc).toShape())
        edges.append(Part.makeLine(arc[2], following[0]))
    return Part.Face(Part.Wire(edges))


def make(path):
    face = star()
    box = face.BoundBox
    block = Part.makeBox(
        box.XLength + 2 * MARGIN,
        box.YLength + 2 * MARGIN,
        BLOCK,
        Vector(box.XMin - MARGIN, box.YMin - MARGIN, -BLOCK),
    )
    doc = FreeCAD.newDocument("star")
    doc.addObject("Part::Feature", "Model").Shape = block.cut(face.extrude(Vector(0, 0, -DEPTH)))
    doc.recompute()
    floor = [
        "Face%d" % number
        for number, f in enumerate(doc.Model.Shape.Faces, 1)
        if f.BoundBox.ZLength < 1e-6 and abs(f.BoundBox.ZMin + DEPTH) < 1e-6
    ]
    doc.saveAs(path)
    print("%s: the pocket's floor is %s" % (path, ", ".join(floor)))


make(os.path.join(os.path.dirname(os.path.abspath(__file__)), "star.FCStd"))
sys.stdout.flush()
os._exit(0)
