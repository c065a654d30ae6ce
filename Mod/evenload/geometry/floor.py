"""A floor: one region of an operation's base geometry, as chains of (x, y, bulge, open)."""

import math
from dataclasses import dataclass, field, replace

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
# Share of the tolerance within which arcs follow an ellipse or a spline. They leave it to both
# sides, and the tool keeps as far away from them: together that is half of the tolerance, and the
# output has the rest.
CURVE_SHARE = 0.25
LEAST_POINTS = 9  # on a curve: chords leave it by a 64th of its own height then
AT_ONCE = 1 << 20  # pairs of a point and an edge that are looked at together: 100 MB


@dataclass
class Floor:
    """One region and where it comes from."""

    name: str  # such as 'Face7 of Model'
    z: float  # mm
    outer: list  # of (x, y, bulge, open)
    islands: list
    is_face: bool  # a floor of the model; else an outline drawn at any height
    of_solid: bool = False  # a face of a body, not one that was drawn by itself
    depth: float = None  # mm: z down to which it is cut; its own height where nobody says
    enclosed: bool = False  # by upright walls of the model, all round
    slack: float = 0.0  # mm, by which the chains may leave the geometry, to either side
    notes: list = field(default_factory=list)
    parts: list = field(default_factory=list)  # of (label, sub-element) of faces, as for name_of
    grown: bool = False  # it goes on beyond its geometry, where stock stands
    beyond: list = field(default_factory=list)  # of stock_beyond.Beyond, where it does

    def __post_init__(self):
        if self.depth is None:
            self.depth = self.z

    @property
    def cut_to(self):
        """mm: the height above which its sides must be free to count as open."""
        return min(self.z, self.depth)

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


def with_chains(floor, outer, islands):
    """A floor with other chains."""
    return replace(floor, outer=list(outer), islands=[list(island) for island in islands])


def is_exact(shape):
    """Whether chains have all of a shape's curves exactly, not within a tolerance."""
    return all(isinstance(edge.Curve, (Part.Line, Part.Circle)) for edge in shape.Edges)


def face_of(floor):
    """A floor as a face of FreeCAD's."""
    face = Part.Face(wire_of(floor.outer, floor.z))
    holes = [Part.Face(wire_of(island, floor.z)) for island in floor.islands]
    return face.cut(holes) if holes else face


def faces_within(wires):
    """Faces that nested level wires enclose; those in others are their holes, and so on."""
    return Part.makeFace(wires, "Part::FaceMakerBullseye").Faces if wires else []


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


def edge_points(edge):
    """Points (x, y) in mm along an edge, the same way for curves however short: slivers between
    these and their chords would be lost otherwise.
    """
    points = edge.discretize(Deflection=DEFLECTION)
    if len(points) < LEAST_POINTS and not isinstance(edge.Curve, Part.Line):
        points = edge.discretize(Number=LEAST_POINTS)
    return numpy.array([(p.x, p.y) for p in points])


def inside(points, polygons):
    """Even-odd: for each point, whether it lies inside nested polygons."""
    result = numpy.zeros(len(points), bool)
    for polygon in polygons:
        result ^= _crossed(points, polygon) % 2 == 1
    return result


def _crossed(points, polygon):
    """For each point, how many edges of the polygon a ray from it crosses.

    Each edge is held against the points beside it only, found by sorting; where that are many, rays
    go along x or along y, whichever meets fewer.
    """
    start, end = polygon, numpy.roll(polygon, -1, 0)
    spans = _beside_edges(points, start, end, 1)
    across = 1
    if spans[2].sum() > AT_ONCE:
        others = _beside_edges(points, start, end, 0)
        if others[2].sum() < spans[2].sum():
            spans, across = others, 0
    order, first, count = spans
    result = numpy.zeros(len(points), int)
    total = numpy.cumsum(count)
    done = 0
    while done < len(polygon):
        before = total[done - 1] if done else 0
        upto = max(done + 1, int(numpy.searchsorted(total, before + AT_ONCE, "right")))
        n = count[done:upto]
        edge = numpy.repeat(numpy.arange(done, upto), n)
        within = numpy.arange(len(edge)) - numpy.repeat(numpy.cumsum(n) - n, n)
        point = order[numpy.repeat(first[done:upto], n) + within]
        u, v = points[point, 1 - across], points[point, across]
        u0, v0 = start[edge, 1 - across], start[edge, across]
        u1, v1 = end[edge, 1 - across], end[edge, across]
        left = u < (u1 - u0) * (v - v0) / (v1 - v0) + u0
        result += numpy.bincount(point[left], minlength=len(points))
        done = upto
    return result


def _beside_edges(points, start, end, axis):
    """(order of the points along an axis, index in it of the first one beside each edge, how many
    are)
    """
    order = numpy.argsort(points[:, axis], kind="stable")
    at = points[order, axis]
    first = numpy.searchsorted(at, numpy.minimum(start[:, axis], end[:, axis]))
    last = numpy.searchsorted(at, numpy.maximum(start[:, axis], end[:, axis]))
    return order, first, last - first
