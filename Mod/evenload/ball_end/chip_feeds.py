"""Feeds along a finishing path at which the mean thickness of its chips stays the same.

Needs no FreeCAD.
"""

from dataclasses import dataclass

import numpy

from evenload import compiled
from evenload.ball_end import thickness
from evenload.ball_end.chips import chip
from evenload.ball_end.places import earlier_beside
from evenload.ball_end.relief import slopes_and_bends
from evenload.planar import CUT, numbered_lines

APART = 0.2  # of the ball's radius: places of a path, at the most
LEAST_FEED = 0.1  # of the nominal one: the lowest that is looked for
NARROWEST = 0.4  # of the nominal stepover: what is nearer beside is taken for as far
CHANGE = 1.05  # feeds of places one after the other that differ less are one
SAME = 0.01  # of the nominal feed: what differs less is that
LEVEL = 1e-9  # of a way's part in plan: steeper ones are upright


@dataclass(frozen=True)
class Fed:
    """A path at the feeds that were found. toolpath: the core's; least, largest: mm/min, of its
    cuts; thickness: mm, the mean of the chips that all cuts were to take.
    """

    toolpath: object
    least: float
    largest: float
    thickness: float


def fed(toolpath, mesh, arguments, stepover, ball, maximum_feed):
    """The Fed of a finishing path.

    toolpath, mesh: the core's; arguments: of the core's finish(), in mm and mm/min; stepover: the
    largest of the path, mm; ball: a loads.Cutting; maximum_feed: mm/min. Each place of a path gets
    the feed at which its chip's mean thickness is that of the straight pass on a plane at the
    nominal feed and stepover, up to the maximum; where the tool is not on the picked faces, and off
    the path's cuts, feeds stay. Asks waiting.go_on. Raises ValueError where that pass has no chip
    that is known, waiting.Stopped.
    """
    nominal = arguments["feed"]
    per_tooth = 1 / (ball.speed * ball.teeth)
    wanted = chip(
        ("plane",), ball.diameter, nominal * per_tooth, arguments["stepover"], ball.stock, 0
    ).mean_thickness
    places = _places_of(toolpath.moves, APART * ball.diameter / 2)
    slopes, bends = slopes_and_bends(mesh, arguments, places.tips)
    is_known = ~numpy.isnan(bends).any(axis=1) & (numpy.hypot(*places.ways.T) > LEVEL)
    left, right = earlier_beside(
        *(places.starts, places.ends, places.tips[is_known], places.ways[is_known]),
        *(places.own[is_known], stepover),
    )
    limits = LEAST_FEED * nominal * per_tooth, max(maximum_feed, nominal) * per_tooth
    wishes = numpy.full(len(places.tips), nominal)
    wishes[is_known] = (
        _wishes(
            *(slopes[is_known], bends[is_known], places.ways[is_known], left, right),
            *(arguments["stepover"], ball, wanted, limits),
        )
        / per_tooth
    )
    pieces = _pieces(places, wishes, nominal)
    path = compiled.core().surface.with_feeds(toolpath, pieces, arguments["plunge_feed"])
    feeds = [move[7] for move in path.moves if move[0] == CUT]
    return Fed(path, min(feeds), max(feeds), wanted)


@dataclass(frozen=True)
class _Places:
    """n places on a path's cuts. tips, ways: n x 2, in plan, the ways along the feed; own: of which
    line each is part, whose starts and ends in plan are m x 2; moves: of which move; until: the
    share of it up to which the place stands for it, 1 for the last.
    """

    tips: numpy.ndarray
    ways: numpy.ndarray
    own: numpy.ndarray
    starts: numpy.ndarray
    ends: numpy.ndarray
    moves: numpy.ndarray
    until: numpy.ndarray


def _places_of(moves, apart):
    rows, which = numbered_lines(moves)
    counts = numpy.bincount(which)
    first = numpy.cumsum(counts) - counts
    is_cut = numpy.flatnonzero(rows[1:, 0] == CUT)
    starts, ends, which = rows[is_cut, 1:4], rows[is_cut + 1, 1:4], which[is_cut + 1]
    number = is_cut + 1 - first[which]  # of the line in its move
    several = numpy.ceil(numpy.linalg.norm(ends - starts, axis=1) / apart).astype(int)
    several = numpy.maximum(several, 1)
    own = numpy.repeat(numpy.arange(len(starts)), several)
    within = numpy.arange(len(own)) - numpy.repeat(numpy.cumsum(several) - several, several)
    share = (within + 0.5) / several[own]
    ways = (ends - starts)[own, :2]
    of = which[own]
    until = (number[own] + (within + 1) / several[own]) / counts[of]
    is_last = numpy.append(of[1:] != of[:-1], True)
    return _Places(
        *(starts[own, :2] + share[:, None] * ways, ways, own, starts[:, :2], ends[:, :2], of),
        numpy.where(is_last, 1.0, until),
    )


def _wishes(slopes, bends, ways, left, right, nominal_stepover, ball, wanted, limits):
    """mm per tooth for each place."""
    frame, rise, lean = _frames(slopes, ways)
    bent = _of_surface(_seen_from(frame, bends, lean), ball.diameter / 2)
    is_left, is_right = numpy.isfinite(left), numpy.isfinite(right)
    # Between two passes there is less to cut than beside the further one alone.
    beside = numpy.where(is_left & is_right, numpy.maximum(left, right), numpy.minimum(left, right))
    # Along the surface of the centres: steps in plan by both slopes, as loads.steps_across has it.
    beside = numpy.maximum(beside, NARROWEST * nominal_stepover) * lean / rise
    # What stands on the left is the mirror image of what stands on the right.
    sign = numpy.where(is_right & ~is_left, -1.0, 1.0)
    bent[:, 0, 1] *= sign
    bent[:, 1, 0] *= sign
    found = numpy.empty(len(slopes))
    for uncut, rows in (("right", is_left | is_right), ("slot", ~(is_left | is_right))):
        if rows.any():
            around = thickness.Surroundings(bent[rows], beside[rows], uncut)
            found[rows] = thickness.feeds_for(wanted, around, ball, limits)
    return found


def _frames(slopes, ways):
    """(n x 2 x 2: the parts in plan of the directions along the feed and to its left, both of
    length 1 on the surface of the centres; how much longer ways are there than in plan; how much
    longer its normal is than upright).
    """
    along = ways / numpy.hypot(*ways.T)[:, None]
    steep = (slopes * along).sum(axis=1)
    rise, lean = numpy.sqrt(1 + steep**2), numpy.sqrt(1 + (slopes**2).sum(axis=1))
    normals = numpy.column_stack([-slopes, numpy.ones(len(slopes))]) / lean[:, None]
    feed = numpy.column_stack([along, steep]) / rise[:, None]
    aside = numpy.cross(normals, feed)
    return numpy.stack([feed[:, :2], aside[:, :2]], axis=2), rise, lean


def _seen_from(frame, bends, lean):
    """n x 2 x 2: curvatures of the surface of the centres in a frame, > 0 convex."""
    xx, xy, yy = bends.T
    second = numpy.stack([numpy.stack([xx, xy], 1), numpy.stack([xy, yy], 1)], 1)
    return -numpy.einsum("nki,nkl,nlj->nij", frame, second, frame) / lean[:, None, None]


def _of_surface(centres, radius):
    """The same of the surface that the ball touches, a radius further in; a ball that rolls round
    an edge has the sharpest that thickness knows.
    """
    values, vectors = numpy.linalg.eigh(centres * radius)
    low, high = (each / (1 + each) for each in (thickness.HOLLOW, thickness.SHARP))
    values = numpy.clip(values, low, high)
    return numpy.einsum("nik,nk,njk->nij", vectors, values / (1 - values) / radius, vectors)


def _pieces(places, wishes, nominal):
    """Rows for the core's with_feeds: of places that follow each other the least wish, as long as
    it lies within CHANGE of the largest.
    """
    groups, group, least, largest = [], 0, wishes[0], wishes[0]
    feeds = []
    for wish in wishes.tolist():
        low, high = min(least, wish), max(largest, wish)
        if high > CHANGE * low:
            feeds.append(least)
            group, low, high = group + 1, wish, wish
        least, largest = low, high
        groups.append(group)
    feeds = numpy.array([*feeds, least])
    feeds = numpy.where(numpy.abs(feeds / nominal - 1) < SAME, nominal, feeds)
    groups = numpy.array(groups)
    ends = numpy.append((groups[1:] != groups[:-1]) | (places.moves[1:] != places.moves[:-1]), True)
    return numpy.column_stack([places.moves, places.until, feeds[groups]])[ends]
