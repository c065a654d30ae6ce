"""Makes examples/finishing.FCStd: the test parts of [Varga 2023], for examples/finishing.json.

    freecadcmd examples/make_finishing.py

Both are blocks of 80 x 80 mm: CX with a dome on it, CV with a trough in it, which have a radius of
45 mm and are joined to flats 10 mm wide by fillets of 10 mm.
"""

import math
import os
import sys

import FreeCAD
import Part
from FreeCAD import Vector

HALF, FLAT, DOME, FILLET = 40.0, 10.0, 45.0, 10.0  # mm
BLOCKS = {"CX": 20.0, "CV": 40.0}  # mm below the flats
LEAN = math.asin((HALF - FLAT) / (DOME + FILLET))  # of the surface where the arcs meet


def section(name):
    """The section of a part across x, its flats at z = 0."""
    sign = 1 if name == "CX" else -1
    axis = FILLET - (DOME + FILLET) * math.cos(LEAN)  # of the dome

    def at(y, z):
        return Vector(-HALF, y, z)

    def fillet(side, lean):
        y = HALF - FLAT - FILLET * math.sin(lean)
        return at(side * y, sign * (FILLET - FILLET * math.cos(lean)))

    bottom = -BLOCKS[name]
    edges = [
        Part.makeLine(at(-HALF, bottom), at(-HALF, 0)),
        Part.makeLine(at(-HALF, 0), fillet(-1, 0)),
        Part.Arc(*(fillet(-1, share * LEAN) for share in (0, 0.5, 1))).toShape(),
        Part.Arc(fillet(-1, LEAN), at(0, sign * (axis + DOME)), fillet(1, LEAN)).toShape(),
        Part.Arc(*(fillet(1, share * LEAN) for share in (1, 0.5, 0))).toShape(),
        Part.makeLine(fillet(1, 0), at(HALF, 0)),
        Part.makeLine(at(HALF, 0), at(HALF, bottom)),
        Part.makeLine(at(HALF, bottom), at(-HALF, bottom)),
    ]
    return Part.Face(Part.Wire(edges))


def make(path):
    doc = FreeCAD.newDocument("finishing")
    for name in BLOCKS:
        shape = section(name).extrude(Vector(2 * HALF, 0, 0))
        doc.addObject("Part::Feature", name).Shape = shape
    doc.recompute()
    doc.saveAs(path)


make(os.path.join(os.path.dirname(os.path.abspath(__file__)), "finishing.FCStd"))
sys.stdout.flush()
os._exit(0)
