# Contour-parallel milling, to compare with: rings one side step apart along the walls, at one feed.
# A pocket is cut from its innermost ring outwards, after a helix in the middle; stock round an
# island from its edge inwards. Rings are joined by straight lines at the same feed.
import math

from evenload import _core

RAPID, ENTRY, CUT = 0, 2, 3
SAFE, HELIX_ANGLE = 3.0, math.radians(3)  # mm
GAP = 1e-3  # mm: from the walls


def rings(regions, first, step):
    """[[chains of ring 0], [of ring 1], ...] inside the regions, the outermost at `first` mm."""
    result = []
    while True:
        inside = _core.offset(regions, -(first + len(result) * step))
        if not inside:
            return result
        result.append([chain for r in inside for chain in (r.outer, *r.islands)])


def from_nearest(chain, place):
    """The closed chain begun at the vertex nearest to `place`."""
    k = min(range(len(chain)), key=lambda i: math.dist(chain[i][:2], place)) if place else 0
    return chain[k:] + chain[:k]


def moves_of(case, feed):
    """(kind, x, y, z, sweep, cx, cy, feed), as the core's."""
    radius, depth = case["tool"] / 2, case["axial_depth"]
    step = radius * (1 - math.cos(math.radians(case["engagement_deg"])))
    outer = [tuple(v) for v in case["outer"]]
    islands = [[tuple(v) for v in island] for island in case["islands"]]
    if case.get("open"):
        # As much outside of the stock that the first ring takes one side step of it.
        grown = _core.offset([_core.Region(outer)], 2 * radius - step)[0].outer
        found = rings([_core.Region(grown, islands)], radius + GAP, step)
        order = [ring[0] for ring in found] + [c for ring in found[::-1] for c in ring[1:]]
    else:
        found = rings([_core.Region(outer, islands)], radius + GAP, step)
        order = [chain for ring in found[::-1] for chain in ring]
    moves, place = [(RAPID, *order[0][0][:2], SAFE, 0, 0, 0, 0)], None
    for chain in order:
        chain = from_nearest(chain, place)
        x, y = chain[0][:2]
        if place is None:
            moves += descent(x, y, case)
        else:
            moves.append((CUT, x, y, -depth, 0, 0, 0, feed))
        for (ax, ay, bulge, *_), (bx, by, *_) in zip(chain, chain[1:] + chain[:1]):
            moves.append(piece(ax, ay, bx, by, bulge, -depth, feed))
        place = chain[0][:2]
    moves.append((RAPID, *place, SAFE, 0, 0, 0, 0))
    return moves


def piece(ax, ay, bx, by, bulge, z, feed):
    if not bulge:
        return (CUT, bx, by, z, 0, 0, 0, feed)
    k = (1 - bulge * bulge) / (4 * bulge)
    cx, cy = (ax + bx) / 2 - k * (by - ay), (ay + by) / 2 + k * (bx - ax)
    return (CUT, bx, by, z, 4 * math.atan(bulge), cx, cy, feed)


def descent(x, y, case):
    """Outside of open stock straight down; else a helix of nearly the tool's radius beside it."""
    depth, feed, radius = case["axial_depth"], case["feed"], 0.45 * case["tool"]
    if case.get("open"):
        return [(ENTRY, x, y, -depth, 0, 0, 0, feed)]
    moves, z = [(ENTRY, x, y, 0, 0, 0, 0, feed)], 0.0
    cx, half = x - radius, math.pi * radius * math.tan(HELIX_ANGLE)
    side = 1
    while z > -depth:
        z, side = max(-depth, z - half), -side
        moves.append((ENTRY, cx + side * radius, y, z, math.pi, cx, y, feed))
    moves.append((ENTRY, cx - side * radius, y, z, math.pi, cx, y, feed))
    moves.append((ENTRY, cx + side * radius, y, z, math.pi, cx, y, feed))
    if side < 0:
        moves.append((ENTRY, x, y, z, math.pi, cx, y, feed))
    return moves
