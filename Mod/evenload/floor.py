"""A floor: one region of an operation's base geometry, as chains of (x, y, bulge, open)."""

import math
from dataclasses import dataclass, field

import FreeCAD
import numpy
import Part

from evenload import compiled
from evenload.planar import DEFLECTION, flattened

UP = FreeCAD.Vector(0, 0, 1)
SAME_HEIGHT = 1e-5  # mm: faces nearer than this are at one height
LEAST_OVERLAP = 1e-4  # mm2: less of two floors that touch is rounding
ABOVE_FLOOR = (
    0.01  # mm: walls are looked for this far above a face; finds the foot of a fillet, too
)


@dataclass
class Floor:
    """One region and where it comes from."""

    name: str  # such as 'Face7 of Model'
    z: float  # mm
    outer: list  # of (x, y, bulge, open)
    islands: list
    is_face: bool  # a floor of the model; else an outline drawn at any height
    enclosed: bool = False  # by upright walls of the model, all round
    slack: float = 0.0  # mm, by which the chains may leave the geometry, to either side
    notes: list = field(default_factory=list)

    def region(self):
        """The core's Region. Raises ValueError, naming the geometry, for one that is crossed or
        outside out.
        """
        try:
            return compiled.core().Region(self.outer, self.islands)
        except ValueError as error:
            raise ValueError("%s: %s" % (self.name, error)) from None

    def contains(self, x, y):
        """True for points in mm inside of the outer boundary and of no island."""
        polygons = [flattened(chain) for chain in [self.outer, *self.islands]]
        return bool(inside(numpy.array([[x, y]]), polygons)[0])


def face_of(floor):
    """A floor as a face of FreeCAD's."""
    face = Part.Face(wire_of(floor.outer, floor.z))
    holes = [Part.Face(wire_of(island, floor.z)) for island in floor.islands]
    return face.cut(holes) if holes else face


def wire_of(chain, z):
    edges = []
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        start, end = FreeCAD.Vector(x0, y0, z), FreeCAD.Vector(x1, y1, z)
        middle = (start + end) / 2 + FreeCAD.Vector(y1 - y0, x0 - x1, 0) * (bulge / 2)
        edges.append(Part.Arc(start, middle, end).toShape() if bulge else Part.makeLine(start, end))
    return Part.Wire(edges)


def oriented(chain, counter_clockwise):
    """The chain in the wished sense of rotation."""
    area = 0.0
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        area += 0.5 * (x0 * y1 - x1 * y0)
        if bulge:
            sweep = 4 * math.atan(bulge)
            radius = 0.5 * math.hypot(x1 - x0, y1 - y0) / math.sin(0.5 * sweep)
            area += 0.5 * radius**2 * (sweep - math.sin(sweep))
    if (area > 0) == counter_clockwise:
        return list(chain)
    turned = list(reversed(chain))
    pieces = turned[1:] + turned[:1]
    return [(x, y, -piece[2], piece[3]) for (x, y, *_), piece in zip(turned, pieces)]


def points_of(wire):
    return numpy.array([(p.x, p.y) for p in wire.discretize(Deflection=DEFLECTION)])


def inside(points, polygons):
    """Even-odd: for each point, whether it lies inside nested polygons."""
    result = numpy.zeros(len(points), bool)
    px, py = points[:, 0], points[:, 1]
    for polygon in polygons:
        x0, y0 = polygon[:, 0][:, None], polygon[:, 1][:, None]
        x1, y1 = numpy.roll(x0, -1, 0), numpy.roll(y0, -1, 0)
        across = (y0 > py) != (y1 > py)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            left = px < (x1 - x0) * (py - y0) / (y1 - y0) + x0
        result ^= (across & left).sum(axis=0) % 2 == 1
    return result
