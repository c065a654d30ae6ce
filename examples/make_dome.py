"""Makes examples/dome.step: a block of 80 x 80 mm with a dome on it, for examples/dome.json.

    freecadcmd examples/make_dome.py

The dome has a radius of 45 mm and is joined to flats 10 mm wide by fillets of 10 mm: the convex
test part CX of [Varga 2023].
"""

import math
import os
import sys

import Part
from FreeCAD import Vector

HALF, FLAT, DOME, FILLET, BLOCK = 40.0, 10.0, 45.0, 10.0, 20.0  # mm
LEAN = math.asin((HALF - FLAT) / (DOME + FILLET))  # of the surface where the arcs meet


def section():
    """The part's section across x, its flats at z = 0."""
    axis = FILLET - (DOME + FILLET) * math.cos(LEAN)  # of the dome

    def fillet(side, lean):
        y = HALF - FLAT - FILLET * math.sin(lean)
        return Vector(-HALF, side * y, FILLET - FILLET * math.cos(lean))

    def corner(side, z):
        return Vector(-HALF, side * HALF, z)

    edges = [
        Part.makeLine(corner(-1, -BLOCK), corner(-1, 0)),
        Part.makeLine(corner(-1, 0), fillet(-1, 0)),
        Part.Arc(*(fillet(-1, share * LEAN) for share in (0, 0.5, 1))).toShape(),
        Part.Arc(fillet(-1, LEAN), Vector(-HALF, 0, axis + DOME), fillet(1, LEAN)).toShape(),
        Part.Arc(*(fillet(1, share * LEAN) for share in (1, 0.5, 0))).toShape(),
        Part.makeLine(fillet(1, 0), corner(1, 0)),
        Part.makeLine(corner(1, 0), corner(1, -BLOCK)),
        Part.makeLine(corner(1, -BLOCK), corner(-1, -BLOCK)),
    ]
    return Part.Face(Part.Wire(edges))


def make(path):
    section().extrude(Vector(2 * HALF, 0, 0)).exportStep(path)


make(os.path.join(os.path.dirname(os.path.abspath(__file__)), "dome.step"))
sys.stdout.flush()
os._exit(0)
