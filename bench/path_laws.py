# What a path does that no worst load tells: corners in material, the side that is cut, entries and
# plunges. `run`: evenload.simulate's answer for `moves`.
import math

import numpy

RAPID, ENTRY, CUT = 0, 2, 3  # kinds of moves
IN_MATERIAL = 1.0  # degrees of engagement
KINK = math.radians(1)
OUTLIERS = 0.02  # mm of path: rapids and plunges shorter than this touch by rounding
DECIMALS = 4  # of heights in posted programs that are worth looking at
ON_FLOOR = 1e-3  # mm
MINIMUM_RADIUS = 0.15  # of the tool's diameter: the operation's own MinimumRadius


def wrong_side(run, conventional):
    """Share of the length in material on which most of it lies on the side not asked for."""
    left, right = numpy.radians(run.arcs[:, 1]), numpy.radians(run.arcs[:, 0])
    sides = numpy.concatenate([[0.0], numpy.cumsum(numpy.cos(right) - numpy.cos(left))])
    side = numpy.diff(sides[run.first_arc])  # the left counts positive
    cut = (run.kind == CUT) & (run.engagement_deg > IN_MATERIAL)
    wrong = cut & ((side < 0) if conventional else (side > 0))
    return float(run.length[wrong].sum() / max(run.length[cut].sum(), 1e-9))


def entry_share(run, case):
    """What entries clear, over pi D^2."""
    volume = numpy.diff(run.removed_volume, prepend=0.0)[run.kind == ENTRY].sum()
    return float(volume) / case["axial_depth"] / (math.pi * case["tool"] ** 2)


def beyond_rounding(length):
    """The mm of rapids or plunges in material, 0 where rounding alone may touch it."""
    return length if length > OUTLIERS else 0.0


def kinks(run, moves):
    """How often cuts turn by more than a degree between moves, with material on both sides."""
    starts = numpy.searchsorted(run.move, range(len(moves) + 1))
    count = 0
    for i in range(2, len(moves)):
        last, first = starts[i] - 1, starts[i]
        if first == starts[i + 1] or last < starts[i - 1]:
            continue  # without a sample: a move of no length
        sides = (last, first)
        if any(run.kind[k] != CUT or run.engagement_deg[k] <= IN_MATERIAL for k in sides):
            continue
        before = _heading(moves[i - 2], moves[i - 1], True)
        after = _heading(moves[i - 1], moves[i], False)
        if before is not None and after is not None and abs(_wrapped(after - before)) > KINK:
            count += 1
    return count


def blocks_per_metre(run, moves):
    """Of cuts and links; rapids do not count."""
    return 1000 * sum(move[0] != RAPID for move in moves) / (run.cut_mm + run.link_mm)


def level_entries(moves, top, floor):
    """How many moves of entries do not descend between the stock's top and the floor, in mm: level
    in the middle of material.
    """
    count = 0
    for before, move in zip(moves, moves[1:]):
        goes = math.dist(before[1:3], move[1:3]) > 10**-DECIMALS
        descends = round(move[3], DECIMALS) < round(before[3], DECIMALS)
        between = floor + ON_FLOOR < move[3] < top - ON_FLOOR
        count += move[0] == ENTRY and before[0] == ENTRY and between and goes and not descends
    return count


def sharp_corners(case):
    """Concave corners of the walls in which the tool's centre turns more tightly than at the
    operation's MinimumRadius.
    """
    least = (0.5 + MINIMUM_RADIUS) * case["tool"]
    outlines = [_oriented(case["outer"], 1)] if not case.get("open") else []
    outlines += [_oriented(island, -1) for island in case["islands"]]
    return sum(_sharp_corners_of(outline, least) for outline in outlines)


def _sharp_corners_of(outline, least):
    count = 0
    for i, (x, y, bulge) in enumerate(outline):
        before, after = outline[i - 1], outline[(i + 1) % len(outline)]
        chord = math.hypot(after[0] - x, after[1] - y)
        # Pieces turn from their chord by half their angle at either end.
        arriving = math.atan2(y - before[1], x - before[0]) + 2 * math.atan(before[2])
        leaving = math.atan2(after[1] - y, after[0] - x) - 2 * math.atan(bulge)
        count += _wrapped(leaving - arriving) > KINK
        count += bulge > 0 and chord * (1 + bulge * bulge) / (4 * bulge) < least
    return count


def _oriented(outline, sense):
    """The same outline with the material on its right: counter-clockwise where sense is 1."""
    area = 0.0
    for (x0, y0, bulge), (x1, y1, _) in zip(outline, outline[1:] + outline[:1]):
        angle = 4 * math.atan(bulge)
        area += 0.5 * (x0 * y1 - x1 * y0)
        if bulge:
            radius = math.hypot(x1 - x0, y1 - y0) / (2 * math.sin(0.5 * angle))
            area += 0.5 * radius**2 * (angle - math.sin(angle))
    if sense * area > 0:
        return outline
    return [
        (x, y, -before[2])
        for (x, y, _), before in zip(outline[::-1], outline[-2::-1] + outline[-1:])
    ]


def _heading(start, move, at_end):
    """rad, in the plane, where a move begins or ends; None for one straight up or down."""
    x0, y0 = start[1:3]
    x1, y1, _, sweep, cx, cy = move[1:7]
    if sweep:
        x, y = (x1, y1) if at_end else (x0, y0)
        return math.atan2(y - cy, x - cx) + math.copysign(0.5 * math.pi, sweep)
    return math.atan2(y1 - y0, x1 - x0) if (x0, y0) != (x1, y1) else None


def _wrapped(angle):
    return math.remainder(angle, 2 * math.pi)
