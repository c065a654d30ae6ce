# A mould-like part of 300 x 200 mm: pockets and bosses with draft and fillets, round cores, and a
# freeform patch; about 200 faces.
import math

import Part
from FreeCAD import Vector

LENGTH, WIDTH, TOP = 300.0, 200.0, 40.0  # mm
DRAFT = math.radians(5)
# x, y, length, width, corner's radius, its floor or top, fillet there.
POCKETS = [
    (45, 45, 70, 60, 12, 22, 6.5),
    (125, 40, 50, 50, 14, 28, 6.0),
    (45, 150, 60, 70, 16, 15, 8.0),
    (120, 155, 60, 50, 12, 30, 7.0),
    (195, 165, 40, 40, 11, 25, 6.0),
]
BOSSES = [
    (195, 40, 40, 50, 8, 55, 3.0),
    (255, 165, 50, 40, 10, 50, 4.0),
    (265, 30, 40, 30, 6, 48, 2),
]
ISLANDS = [(45, 45, 24, 20, 7, 34, 3.0), (45, 150, 22, 28, 8, 30, 3.0)]  # within pockets
CORES = [
    (100, 100, 10, 58),
    (20, 100, 8, 52),
    (60, 98, 9, 54),
    (285, 75, 8, 50),
]  # x, y, radius, top
PATCH = (140, 80, 120, 50)  # x, y, length, width of the freeform patch
FOOT = 6.0  # mm, fillets around the feet of the cores


def part():
    """The part as a solid, its lower corner at the origin."""
    solid = Part.makeBox(LENGTH, WIDTH, TOP)
    for x, y, length, width, radius, floor, fillet in POCKETS:
        solid = solid.cut(_drafted((x, y), (length, width), radius, (TOP, floor), fillet))
    floors = {(x, y): floor for x, y, *_, floor, _ in POCKETS}
    for x, y, length, width, radius, top, fillet in BOSSES + ISLANDS:
        foot = floors.get((x, y), TOP)
        solid = solid.fuse(_drafted((x, y), (length, width), radius, (foot, top), fillet))
    for x, y, radius, top in CORES:
        solid = solid.fuse(_core(x, y, radius, top))
    solid = solid.fuse(_patch()).removeSplitter()
    solid = _feet_filleted(solid)
    assert solid.isValid() and len(solid.Solids) == 1
    return solid.Solids[0]


def _drafted(middle, sizes, radius, heights, fillet):
    """A block with round corners whose sides lean to its narrow end, the second of its heights."""
    narrow = abs(heights[1] - heights[0]) * math.tan(DRAFT)
    wires = [
        _rounded(middle, [size - 2 * less for size in sizes], radius - less, height)
        for height, less in zip(heights, (0, narrow))
    ]
    block = Part.makeLoft(wires, True, True)
    end = [e for e in block.Edges if all(abs(v.Z - heights[1]) < 1e-6 for v in e.Vertexes)]
    return block.makeFillet(fillet, end)


def _rounded(middle, sizes, radius, z):
    """A wire of lines and quarters of circles."""
    x, y = (size / 2 - radius for size in sizes)
    corners, edges = [(x, y), (-x, y), (-x, -y), (x, -y)], []
    centre = Vector(*middle, z)
    for quarter, (u, v) in enumerate(corners):
        at = [
            centre + Vector(u + radius * math.cos(turn), v + radius * math.sin(turn))
            for turn in (math.pi / 2 * (quarter + share) for share in (0, 0.5, 1))
        ]
        edges.append(Part.Arc(*at).toShape())
    ends = [
        (each.Vertexes[-1].Point, following.Vertexes[0].Point)
        for each, following in zip(edges, edges[1:] + edges[:1])
    ]
    lines = [Part.makeLine(*each) for each in ends]
    return Part.Wire([edge for pair in zip(edges, lines) for edge in pair])


def _core(x, y, radius, top):
    """A cone with a rounded end."""
    less = (top - TOP) * math.tan(DRAFT)
    cone = Part.makeCone(radius, radius - less, top - TOP, Vector(x, y, TOP))
    end = [e for e in cone.Edges if all(abs(v.Z - top) < 1e-6 for v in e.Vertexes)]
    return cone.makeFillet(0.6 * (radius - less), end)


def _patch():
    """A block whose upper side is a spline surface."""
    x0, y0, length, width = PATCH
    wires = []
    for share, heights in (
        (0, (3, 7, 4, 6)),
        (0.4, (5, 3, 8, 3)),
        (0.7, (8, 6, 3, 7)),
        (1, (4, 6, 5, 3)),
    ):
        x = x0 + share * length
        points = [Vector(x, y0 + k * width / 3, TOP + z) for k, z in enumerate(heights)]
        curve = Part.BSplineCurve()
        curve.interpolate(points)
        corners = [points[-1], Vector(x, y0 + width, TOP - 5), Vector(x, y0, TOP - 5), points[0]]
        lines = [Part.makeLine(a, b) for a, b in zip(corners, corners[1:])]
        wires.append(Part.Wire([curve.toShape(), *lines]))
    return Part.makeLoft(wires, True)


def _feet_filleted(solid):
    """Fillets around the feet of the cores, as wide as the tool needs them."""
    feet = [
        edge
        for edge in solid.Edges
        if isinstance(edge.Curve, Part.Circle)
        and any(
            math.hypot(edge.Curve.Center.x - x, edge.Curve.Center.y - y) < 1e-6
            and abs(edge.Curve.Center.z - TOP) < 1e-6
            for x, y, *_ in CORES
        )
    ]
    return solid.makeFillet(FOOT, feet)
