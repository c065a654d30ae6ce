"""Random cases for the operations that clear certain shapes only: slots for the trochoid; round,
square and many-sided pockets, rings, and islands in open ground for the Lamé spiral.

Each kind returns (outer chain, islands, whether the outline is the stock's edge).
"""

import math

from shapely import affinity
from shapely.geometry import LineString, Point, Polygon, box
from shapely.ops import unary_union
from shapes import TOOL, circle, largest, polar, ring_of, slot

WIDTHS = (1.2, 3.2)  # of the tool's diameter
FINE = 64  # corners of a quarter circle
STRAIGHT = 6  # mm: least length beyond the width


def width(pick):
    return TOOL * pick.choice((1.25, 1.5, 2.0, 2.5, 3.0, pick.uniform(*WIDTHS)))


def turned(pick, shape):
    return affinity.rotate(shape, pick.choice((0, 90, pick.uniform(0, 360))), origin=(0, 0))


def closed(shape):
    shape = largest(shape)
    return ring_of(shape), [], False


# ---- slots ----


def straight(pick):
    outer, islands, _ = slot(pick)
    return outer, islands, False


def bow(pick):
    """A slot about an arc, with exact arcs for walls and round or flat ends."""
    wide, sweep = width(pick), math.radians(pick.uniform(30, 200))
    middle = pick.uniform(wide / 2 + 2, 40)
    low, high, bulge = middle - wide / 2, middle + wide / 2, math.tan(sweep / 4)
    end, start = (math.cos(sweep), math.sin(sweep)), (1.0, 0.0)
    cap = pick.choice((0.0, 1.0))
    outer = [
        [high * start[0], high * start[1], bulge],
        [high * end[0], high * end[1], cap],
        [low * end[0], low * end[1], -bulge],
        [low * start[0], low * start[1], cap],
    ]
    return outer, [], False


def bent(pick):
    """A slot about a few lines that meet at blunt angles."""
    wide, x, y, heading = width(pick), 0.0, 0.0, 0.0
    points = [(x, y)]
    for _ in range(pick.randint(2, 4)):
        length = wide + pick.uniform(STRAIGHT, 40)
        x, y = x + length * math.cos(heading), y + length * math.sin(heading)
        points.append((x, y))
        heading += math.radians(pick.uniform(-80, 80))
    line = LineString(points).buffer(wide / 2, FINE, cap_style=pick.choice((1, 2)))
    return closed(turned(pick, line))


def tee(pick):
    """Two slots that meet or cross."""
    first, second = width(pick), width(pick)
    length, branch = pick.uniform(40, 90), pick.uniform(25, 60)
    at, below = pick.uniform(-0.3, 0.3) * length, pick.choice((0.0, branch))
    along = box(-length / 2, -first / 2, length / 2, first / 2)
    across = box(at - second / 2, -below, at + second / 2, branch)
    return closed(turned(pick, unary_union([along, across])))


def taper(pick):
    length, first, second = pick.uniform(30, 90), width(pick), width(pick)
    corners = [(0, -first / 2), (length, -second / 2), (length, second / 2), (0, first / 2)]
    return closed(turned(pick, Polygon(corners)))


# ---- for Lamé spirals ----


def regular(pick):
    corners, size = pick.choice((3, 4, 5, 6, 8, 12)), pick.uniform(14, 50)
    shape = polar([(2 * math.pi * k / corners, size) for k in range(corners)])
    if pick.random() < 0.5:
        radius = pick.uniform(1, 0.4 * size * math.cos(math.pi / corners))
        shape = largest(shape.buffer(-radius).buffer(radius, FINE))
    return closed(turned(pick, shape))


def rectangle(pick):
    size, share = pick.uniform(8, 30), pick.uniform(1, 2.5)
    shape = box(-share * size, -size, share * size, size)
    if pick.random() < 0.5:
        radius = pick.uniform(1, 0.9 * size)
        shape = largest(shape.buffer(-radius).buffer(radius, FINE))
    return closed(turned(pick, shape))


def ellipse(pick):
    size, share = pick.uniform(10, 30), pick.uniform(1, 2)
    shape = affinity.scale(Point(0, 0).buffer(1, FINE), share * size, size, origin=(0, 0))
    return closed(turned(pick, shape))


def island(pick):
    """An island in the middle of a square stock without walls."""
    outer, _, _ = pick.choice((regular, rectangle, ellipse))(pick)
    reach = max(math.hypot(x, y) for x, y, _ in outer) + pick.uniform(6, 20)
    stock = ring_of(box(-reach, -reach, reach, reach))
    return stock, [outer], True


def ring(pick):
    inside = pick.uniform(5, 20)
    return circle(0, 0, inside + pick.uniform(2, 6) * TOOL), [circle(0, 0, inside)], False


KINDS = {
    "trochoid": (straight, bow, bent, tee, taper),
    "lame_spiral": (regular, rectangle, ellipse, island, ring),
}
