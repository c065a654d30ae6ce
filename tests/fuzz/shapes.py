"""Random pockets as cases of tests/corpus: blobs, unions of rectangles, polygons, slots, rings,
gears and stars, with up to three islands, walled or open all round.

Needs shapely to unite and round shapes and to see what fits.
"""

import math

from shapely import affinity
from shapely.geometry import MultiPolygon, Point, Polygon, box
from shapely.ops import unary_union

TOOL, DEPTH, FEED, LINK_FEED, MAX_FEED, ROLL_RADIUS = 6.0, 3.0, 255.0, 1500.0, 1000.0, 1.0
SLOT = (6.2, 24.0)  # mm, for a tool of TOOL
ANGLES = (15.0, 110.0)  # degrees
ROUND_ANGLES = (15, 20, 30, 45, 60, 60, 75, 90, 110)
MOST_ISLANDS = 3
WALL = 0.5  # mm: islands are no nearer to walls or to each other
SMALLEST = 40.0  # mm2: of a pocket


def chain(points):
    return [[round(x, 6), round(y, 6), 0.0] for x, y in points]


def ring_of(polygon):
    """The chain of a polygon's outside, counter-clockwise; an empty one of an empty polygon."""
    if polygon.is_empty:
        return []
    points = list(polygon.exterior.coords)[:-1]
    return chain(points if polygon.exterior.is_ccw else points[::-1])


def circle(x, y, radius):
    return [[x + radius, y, 1.0], [x - radius, y, 1.0]]


def largest(shape):
    shape = shape.buffer(0)
    return max(shape.geoms, key=lambda g: g.area) if isinstance(shape, MultiPolygon) else shape


def polar(steps):
    """A polygon of (angle, radius)."""
    return Polygon([(r * math.cos(a), r * math.sin(a)) for a, r in steps])


# ---- kinds: each returns (outer chain, islands, polygon for further islands or None) ----


def blob(pick):
    size, points = pick.uniform(12, 40), pick.choice((40, 90, 240))
    waves = [(pick.uniform(0, 0.2 / k**0.5), pick.uniform(0, 7), k + 1) for k in range(1, 6)]

    def radius(angle):
        return size * (1 + sum(a * math.cos(k * angle + p) for a, p, k in waves))

    angles = [2 * math.pi * k / points for k in range(points)]
    shape = polar([(angle, radius(angle)) for angle in angles])
    return ring_of(shape), [], shape


def rectangles(pick):
    parts = []
    for _ in range(pick.randint(2, 5)):
        x, y = pick.uniform(-25, 25), pick.uniform(-25, 25)
        w, h = pick.uniform(7, 45), pick.uniform(7, 45)
        part = box(x - w / 2, y - h / 2, x + w / 2, y + h / 2)
        turn = pick.choice((0, 0, 0, 45, pick.uniform(0, 90)))
        parts.append(affinity.rotate(part, turn))
    shape = largest(unary_union(parts))
    holes = [Polygon(hole) for hole in shape.interiors]
    islands = [ring_of(hole) for hole in holes if hole.area > 0.5]
    return ring_of(shape), islands, shape if len(islands) < MOST_ISLANDS else None


def polygon(pick):
    count, size = pick.randint(3, 9), pick.uniform(15, 40)
    angles = sorted(pick.uniform(0, 2 * math.pi) for _ in range(count))
    shape = largest(polar([(a, size * pick.uniform(0.5, 1)) for a in angles]))
    if pick.random() < 0.4:
        radius = pick.uniform(0.3, 4)
        shape = largest(shape.buffer(-radius).buffer(radius, 24))
    return ring_of(shape), [], shape


def slot(pick):
    length = pick.uniform(20, 90)
    width = pick.choice((6.2, 6.5, 7, 7.5, 8, 9, 10, 12, 15, 18, 24, pick.uniform(*SLOT)))
    turn = pick.uniform(0, math.pi)
    ends = pick.choice((0.0, 1.0))  # square or round
    corners = [(0, 0), (length, 0), (length, width), (0, width)]
    points = [
        [
            x * math.cos(turn) - y * math.sin(turn),
            x * math.sin(turn) + y * math.cos(turn),
            ends if n in (1, 3) else 0.0,
        ]
        for n, (x, y) in enumerate(corners)
    ]
    return points, [], None


def ring(pick):
    inside = pick.uniform(4, 20)
    outside = inside + pick.uniform(6.3, 22)
    off = pick.uniform(0, max(0.0, outside - inside - 6.3))
    return circle(0, 0, outside), [circle(off, 0, inside)], None


def gear(pick):
    teeth, size = pick.randint(6, 14), pick.uniform(20, 40)
    root, share = size * pick.uniform(0.6, 0.85), pick.uniform(0.35, 0.6)
    steps = []
    for k in range(teeth):
        middle, half = 2 * math.pi * k / teeth, math.pi / teeth * share
        steps += [(middle - 1.1 * half, root), (middle - 0.9 * half, size)]
        steps += [(middle + 0.9 * half, size), (middle + 1.1 * half, root)]
    shape = largest(polar(steps))
    return ring_of(shape), [], shape


def star(pick):
    points, size = pick.randint(4, 8), pick.uniform(18, 40)
    root = size * pick.uniform(0.4, 0.75)
    shape = polar([(math.pi * k / points, root if k % 2 else size) for k in range(2 * points)])
    tip, valley = pick.choice((0, 0, 1, 3.2, 4)), pick.choice((0, 0.5, 1, 2))
    if tip:
        shape = largest(shape.buffer(-tip).buffer(tip, 24))
    if valley:
        shape = largest(shape.buffer(valley).buffer(-valley, 24))
    return ring_of(shape), [], shape


KINDS = (blob, rectangles, polygon, slot, ring, gear, star)


def island_in(pick, room):
    """The chain and the polygon of an island that lies in `room`; None where none was found."""
    x0, y0, x1, y1 = room.bounds
    for _ in range(20):
        x, y, size = pick.uniform(x0, x1), pick.uniform(y0, y1), pick.uniform(1, 8)
        if pick.random() < 0.5:
            outline, shape = circle(x, y, size), Point(x, y).buffer(size, 32)
        else:
            corners = pick.randint(3, 6)
            turn = pick.uniform(0, 7)
            shape = polar([(turn + 2 * math.pi * k / corners, size) for k in range(corners)])
            shape = affinity.translate(shape, x, y)
            outline = ring_of(shape)
        if room.contains(shape):
            return outline, shape
    return None


def case(pick, number):
    """A case in the words of tests/corpus; None where the shape came out unusable."""
    kind = KINDS[number % len(KINDS)]
    outer, islands, shape = kind(pick)
    if shape is not None:
        if shape.area < SMALLEST or not shape.is_valid:
            return None
        room = shape.buffer(-WALL)
        for _ in range(pick.randint(0, MOST_ISLANDS - len(islands))):
            found = island_in(pick, room)
            if found:
                islands.append(found[0])
                room = room.difference(found[1].buffer(WALL))
    result = case_of("fuzz_%s_%05d" % (kind.__name__, number), outer, islands, pick)
    if pick.random() < 0.1 and kind is not slot:
        result["open"] = True
    return result


def case_of(name, outer, islands, pick):
    """The shape with an engagement angle and the usual feeds."""
    angle = pick.choice((pick.choice(ROUND_ANGLES), round(pick.uniform(*ANGLES), 1)))
    return {
        "name": name,
        "tool": TOOL,
        "outer": outer,
        "islands": islands,
        "engagement_deg": float(angle),
        "axial_depth": DEPTH,
        "feed": FEED,
        "link_feed": LINK_FEED,
        "max_feed": MAX_FEED,
        "roll_radius": ROLL_RADIUS,
        "note": "Found by tests/fuzz/fuzz.py.",
    }


def cut_width(case):
    """mm2 per mm of path at the engagement angle."""
    return 0.5 * case["tool"] * (1 - math.cos(math.radians(case["engagement_deg"])))
