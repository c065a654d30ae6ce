"""How few lines the tolerance takes for a path, by a dynamic programme over dense points of its
passes: written anew, so that nothing is shared with what is judged.
"""

import math

import numpy
from evenload import compiled
from evenload.planar import CUT

APART = 0.05  # mm between the points of a piece, about
LEVELS = 13  # heights of corners within the band, at each point
BELOW, ABOVE = 0.1, 1.0  # of the tolerance: into the part and above it, as src/surface/finish.h
SAME = 1e-6  # mm and rad: of lines that go on in plan, and of arcs about one centre
STEEPEST = 10.0  # times that a band across the curve may be as wide upright
AT_ONCE = 48  # points
STOOD = -1e6  # mm: below it there is nothing to stand on


def pieces_of(moves):
    """[(moves, n x 8, the place before them), ...]: cuts that follow each other along one line or
    one circle in plan, on which corners can be left out.
    """
    found, at = [], None
    for move in numpy.array(moves, float):
        if move[0] == CUT:
            if found and found[-1] is not None and _goes_on(*found[-1], move):
                found[-1][0].append(move)
            else:
                found.append(([move], at))
        elif found and found[-1] is not None:
            found.append(None)
        at = move[1:4]
    return [(numpy.array(rows), start) for rows, start in filter(None, found)]


def _goes_on(rows, start, move):
    last = rows[-1]
    if bool(last[4]) != bool(move[4]) or last[4] * move[4] < 0:
        return False
    if last[4]:
        return math.dist(last[5:7], move[5:7]) < SAME
    before = rows[-2][1:3] if len(rows) > 1 else start[:2]
    one, two = last[1:3] - before, move[1:3] - last[1:3]
    turn = math.atan2(one[0] * two[1] - one[1] * two[0], one @ two)
    return abs(turn) < SAME


def lines_demanded(mesh, piece, tolerance, floor, diameter=10.0):
    """The fewest lines (over an arc: helices) of a piece that leave the tool's true height by no
    more than the tolerance; corners may stand over any of its points, its ends among them.
    """
    places, run = _points(*piece)
    heights = compiled.core().surface.contacts(mesh, diameter, diameter / 2, places, floor)[:, 0]
    assert heights.min() > STOOD
    slopes = numpy.gradient(heights, run)
    stretch = numpy.minimum(numpy.sqrt(1 + slopes**2), STEEPEST) * tolerance
    shares = numpy.linspace(-BELOW, ABOVE, LEVELS)
    return _fewest(run, heights[:, None] + stretch[:, None] * shares)


def _points(rows, start):
    """(n x 2, mm along the way in plan from its beginning)."""
    end = rows[-1]
    if not end[4]:
        length = math.dist(start[:2], end[1:3])
        share = numpy.linspace(0, 1, max(2, math.ceil(length / APART) + 1))
        return start[:2] + share[:, None] * (end[1:3] - start[:2]), share * length
    centre, sweep = end[5:7], rows[:, 4].sum()
    arm = start[:2] - centre
    length = abs(sweep) * math.hypot(*arm)
    share = numpy.linspace(0, 1, max(2, math.ceil(length / APART) + 1))
    cosine, sine = numpy.cos(share * sweep), numpy.sin(share * sweep)
    turned = numpy.column_stack([cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]])
    return centre + turned, share * length


def _fewest(run, levels):
    """levels: n x LEVELS, mm, from the lowest to the highest that a line may pass a point at. Layer
    by layer: all corners that one line reaches, those that two do, ...
    """
    is_left = numpy.ones(levels.shape, bool)  # whether no line has come there
    is_left[0] = False
    layer = {0: numpy.arange(LEVELS)}
    for lines in range(1, len(run)):
        reached = numpy.zeros(levels.shape, bool)
        for point, chosen in layer.items():
            _reach(run, levels, point, chosen, reached)
        if reached[-1].any():
            return lines
        reached &= is_left
        is_left &= ~reached
        layer = {n: numpy.flatnonzero(reached[n]) for n in numpy.flatnonzero(reached.any(axis=1))}
    raise AssertionError("Lines from point to point do.")


def _reach(run, levels, point, chosen, reached):
    """Marks the corners that one line from some levels of a point comes to."""
    start = levels[point, chosen]
    low, high = numpy.full((2, len(chosen)), -numpy.inf)
    high = -high
    for first in range(point + 1, len(run), AT_ONCE):
        rows = slice(first, first + AT_ONCE)
        slopes = (levels[rows, None, :] - start[:, None]) / (run[rows] - run[point])[:, None, None]
        lows = numpy.maximum.accumulate(numpy.vstack([low[None], slopes[:, :, 0]]))
        highs = numpy.minimum.accumulate(numpy.vstack([high[None], slopes[:, :, -1]]))
        can = (slopes >= lows[:-1, :, None]) & (slopes <= highs[:-1, :, None])
        reached[rows] |= can.any(axis=1)
        low, high = lows[-1], highs[-1]
        if not (low <= high).any():
            return


def counted(mesh, moves, tolerance, floor, most_pieces, seed=1):
    """(posted moves, those that the tolerance demands) of some of a path's pieces, which are chosen
    by chance.
    """
    pieces = pieces_of(moves)
    chosen = numpy.random.default_rng(seed).permutation(len(pieces))[:most_pieces]
    posted = sum(len(pieces[n][0]) for n in chosen)
    demanded = sum(lines_demanded(mesh, pieces[n], tolerance, floor) for n in chosen)
    return posted, demanded
