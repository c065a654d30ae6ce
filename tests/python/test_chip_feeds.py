"""Feeds at a constant chip thickness: chips along finishing paths, computed one by one from the
curvatures of the source's parts themselves, and what stays of the path.
"""

import math

import finishing_cases as cases
import numpy
import pytest
from evenload import compiled, waiting
from evenload.ball_end import chip_feeds, loads, places
from evenload.planar import CUT, LINK, RAPID, as_lines

pytestmark = pytest.mark.core

BALL, STOCK, SPEED, TEETH, PER_TOOTH = 5.0, 0.3, 5100.0, 4, 0.08
FEED = PER_TOOTH * SPEED * TEETH
DEFLECTION = 0.0005
STEPOVER = 0.35
MIXED = 1.2  # mm beside a joint, where a place's surroundings are of two arcs
ASIDE = 2.0  # mm from the part's border, where passes end beside no other
WAYS = (
    dict(),
    dict(angle=math.pi / 2),
    dict(angle=math.pi / 4),
    dict(pattern="contours inwards"),
    dict(pattern="spiral outwards"),
)


def ball():
    none = {"ktc": 1.0, "krc": 0.0, "kte": 0.0, "kre": 0.0}
    return loads.Cutting(2 * BALL, TEETH, SPEED, STOCK, none)


def finished(triangles, **others):
    """(mesh, arguments, the core's Finish)."""
    core = compiled.core()
    mesh = core.surface.FacetMesh(*triangles)
    # Downhill nothing is slower: feeds are the feed control's own.
    arguments = dict(stepover=STEPOVER, feed=FEED, plunge_feed=1e5, allowance=0.0, **others)
    arguments = cases.options(**{**dict(tolerance=0.0045, deflection=DEFLECTION), **arguments})
    return mesh, arguments, core.surface.finish(mesh, **arguments)


def fed(triangles, maximum_feed=2 * FEED, **others):
    mesh, arguments, finish = finished(triangles, **others)
    stepover = max(finish.largest_stepover, STEPOVER)
    found = chip_feeds.fed(finish.toolpath, mesh, arguments, stepover, ball(), maximum_feed)
    return finish, found


def plane(size=30.0):
    corners = [(x, y, z) for z in (0.0, -20.0) for x in (0, size) for y in (0, size)]
    top = [(0, 2, 3), (0, 3, 1)]
    sides = [(0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    picked = numpy.arange(len(top) + len(sides)) < len(top)
    return numpy.array(corners), numpy.array(top + sides, dtype=numpy.uint32), picked


def thickness_along(moves, is_convex, count=600):
    """(h_m in mm, h_max in mm, feeds in mm/min) away from joints and from where passes end."""
    found = places.places_along(moves, count, STEPOVER)
    normals, curvature, off = cases.bends_under(found.tips[:, 1], BALL, is_convex)
    along_x = numpy.tile([1.0, 0, 0], (count, 1))
    felt = loads.loads_at(
        found, loads.Bends(normals, numpy.zeros(count), curvature, along_x), ball()
    )
    aside = cases.HALF - numpy.abs(found.tips[:, :2]).max(axis=1)
    kept = (off > MIXED) & (aside > ASIDE) & (found.uncut != "strip")
    kept = kept[felt.rows]
    return felt.mean_thickness[kept], felt.max_thickness[kept], felt.feeds[kept]


@pytest.mark.parametrize("way", WAYS, ids=str)
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_chips_are_as_thick_as_on_a_plane_all_along(is_convex, way):
    finish, found = fed(cases.triangles(is_convex, DEFLECTION), **way)
    mean, largest, feeds = thickness_along(found.toolpath.moves, is_convex)
    assert len(mean) > 350 and feeds.max() < 2 * FEED
    off = mean / found.thickness - 1
    # At most by what feeds may differ and still be one below, and by the fit above.
    assert numpy.percentile(off, 0.5) > 1 / chip_feeds.CHANGE - 1 - 0.02
    assert numpy.percentile(off, 99.5) < 0.02
    assert largest.std() < 0.07 * largest.mean()
    before, *_ = thickness_along(finish.toolpath.moves, is_convex)
    assert before.std() > 1.4 * mean.std()


def test_on_a_plane_the_feed_is_the_nominal_one_but_in_the_first_pass():
    finish, found = fed(plane())
    first, *others = _passes(found.toolpath.moves)
    assert {feed for cuts in others for feed in cuts} == {FEED}
    assert max(first) < 0.8 * FEED
    assert len(found.toolpath.moves) == len(finish.toolpath.moves)
    # On the mean its chips are as thick as those beside it, which have less of an edge in cut.
    assert found.largest == FEED and found.least == min(first)


def _passes(moves):
    """The feeds of each pass's cuts."""
    found = [[]]
    for kind, *_, feed in moves:
        if kind == CUT:
            found[-1].append(feed)
        elif found[-1]:
            found.append([])
    return [each for each in found if each]


def test_the_maximum_holds_and_the_feed_is_lower_where_chips_are_thick():
    _, found = fed(cases.triangles(False, DEFLECTION), 1.1 * FEED, angle=math.pi / 2)
    assert 1.1 * FEED / chip_feeds.CHANGE < found.largest <= 1.1 * FEED * (1 + 1e-12)
    feeds = numpy.array([move[7] for move in found.toolpath.moves if move[0] == CUT])
    assert feeds.max() == found.largest and (feeds < 0.95 * FEED).any()


def test_places_and_times_of_a_path_stay():
    finish, found = fed(cases.triangles(True, DEFLECTION), angle=math.pi / 4)
    before, after = finish.toolpath, found.toolpath
    corners = {tuple(numpy.round(move[1:4], 9)) for move in after.moves}
    assert {tuple(numpy.round(move[1:4], 9)) for move in before.moves} <= corners
    # A feed may change within a move; most do not.
    assert len(before.moves) < len(after.moves) < 1.2 * len(before.moves)
    assert [m for m in before.moves if m[0] != CUT] == [m for m in after.moves if m[0] != CUT]
    assert after.report.cut_length == before.report.cut_length
    assert after.report.cutting_time == pytest.approx(_seconds(after.moves), rel=1e-6)


def _seconds(moves):
    """s at the moves' feeds; rapids at those of the cases."""
    total = 0.0
    lines = as_lines(moves)
    for (_, *start, _, _, _, _), (kind, *end, _, _, _, feed) in zip(lines[:-1], lines[1:]):
        total += 60 * math.dist(start, end) / (feed if kind != RAPID else 5000.0)
    return total


def test_the_same_path_gets_the_same_feeds():
    triangles = cases.triangles(True, DEFLECTION)
    first, second = (fed(triangles, angle=1.0)[1].toolpath.moves for _ in range(2))
    assert first == second


def test_arcs_are_divided_as_arcs():
    core = compiled.core()
    mesh, arguments, finish = finished(_cone(), pattern="contours inwards")
    arcs = [n for n, move in enumerate(finish.toolpath.moves) if move[4] and move[0] == CUT]
    assert arcs
    pieces = [(n, share, feed) for n in arcs for share, feed in ((0.3, 500.0), (1.0, 900.0))]
    path = core.surface.with_feeds(finish.toolpath, numpy.array(pieces), 1e5)
    moves, before = path.moves, finish.toolpath.moves
    assert len(moves) == len(before) + len(arcs)
    for place, number in enumerate(arcs):
        one, two = moves[number + place : number + place + 2]
        whole, start = before[number], before[number - 1]
        assert (one[7], two[7]) == (500.0, 900.0)
        assert one[4] + two[4] == pytest.approx(whole[4]) and two[1:4] == whole[1:4]
        assert one[4] == pytest.approx(0.3 * whole[4])
        assert one[3] == pytest.approx(start[3] + 0.3 * (whole[3] - start[3]))
        for each in (start, one, two):
            radius = math.dist(each[1:3], whole[5:7])
            assert radius == pytest.approx(math.dist(start[1:3], whole[5:7]), abs=1e-9)


def _cone(sides=720, radius=20.0, height=5.0):
    angles = 2 * math.pi * numpy.arange(sides) / sides
    rim = numpy.column_stack(
        [radius * numpy.cos(angles), radius * numpy.sin(angles), numpy.zeros(sides)]
    )
    ring = numpy.arange(sides)
    faces = numpy.column_stack([ring, (ring + 1) % sides, numpy.full(sides, sides)])
    points = numpy.vstack([rim, [(0, 0, height)]])
    return points, faces.astype(numpy.uint32), numpy.ones(sides, bool)


def test_downhill_a_cut_is_never_faster_than_the_plunge_feed_allows():
    core = compiled.core()
    _, _, finish = finished(cases.triangles(True, DEFLECTION), angle=math.pi / 2)
    cuts = [n for n, move in enumerate(finish.toolpath.moves) if move[0] == CUT]
    pieces = numpy.array([(n, 1.0, 3000.0) for n in cuts])
    moves = core.surface.with_feeds(finish.toolpath, pieces, 600.0).moves
    slowed = 0
    for before, (kind, x, y, z, _, _, _, feed) in zip(moves, moves[1:]):
        if kind == CUT:
            down = (before[3] - z) / math.dist(before[1:4], (x, y, z))
            assert down * feed <= 600.0 * (1 + 1e-9)
            slowed += feed < 3000.0
    assert 0 < slowed < len(cuts)


@pytest.mark.parametrize(
    "pieces, sentence",
    [
        ([(3, 0.5, 100.0)], "ends where the move does"),
        ([(3, 0.5, 100.0), (3, 0.4, 100.0)], "follow each other"),
        ([(3, 1.0, 0.0)], "positive feeds"),
        ([(0, 1.0, 100.0)], "have one"),
        ([(4, 1.0, 100.0), (3, 1.0, 100.0)], "in the order"),
    ],
)
def test_pieces_that_cannot_be_are_refused(pieces, sentence):
    _, _, finish = finished(plane())
    with pytest.raises(ValueError, match=sentence):
        compiled.core().surface.with_feeds(finish.toolpath, numpy.array(pieces), 1e5)


def test_it_can_be_stopped():
    mesh, arguments, finish = finished(cases.triangles(True, DEFLECTION), angle=1.0)
    asked = []

    def watch(share):
        asked.append(share)
        return len(asked) < 5

    with waiting.asking(watch), pytest.raises(waiting.Stopped):
        chip_feeds.fed(finish.toolpath, mesh, arguments, STEPOVER, ball(), 2 * FEED)
    assert len(asked) == 5


def test_a_stepover_that_leaves_no_known_chip_is_refused():
    with pytest.raises(ValueError, match=r"\.$"):
        mesh, arguments, finish = finished(plane())
        arguments["stepover"] = 1e-4
        chip_feeds.fed(finish.toolpath, mesh, arguments, STEPOVER, ball(), 2 * FEED)


# ---- what lies beside a path ----


def _beside(starts, ends, tips, ways, own, reach):
    """The same as the core's earlier_beside, place by place and segment by segment."""
    found = numpy.full((len(tips), 2), numpy.inf)
    for row, (tip, way, last) in enumerate(zip(tips, ways, own)):
        x, y = way / numpy.hypot(*way)
        for start, end in zip(starts[:last] - tip, ends[:last] - tip):
            (u0, v0), (u1, v1) = ((x * p[0] + y * p[1], x * p[1] - y * p[0]) for p in (start, end))
            if (u0 <= 0) == (u1 <= 0):
                continue
            across = v0 - u0 * (v1 - v0) / (u1 - u0)
            side = 0 if across > 0 else 1
            if 0.02 * reach < abs(across) < reach:
                found[row, side] = min(found[row, side], abs(across))
    return found


def test_neighbours_are_those_of_all_earlier_segments():
    chance = numpy.random.default_rng(4)
    starts = chance.uniform(0, 20, (300, 2))
    ends = starts + chance.normal(0, 3, (300, 2))
    own = chance.integers(0, 300, 200)
    tips, ways = starts[own] + 0.4 * (ends - starts)[own], (ends - starts)[own]
    rows = numpy.column_stack([tips, ways, own])
    for threads in (1, 2):
        found = compiled.core().surface.earlier_beside(
            numpy.hstack([starts, ends]), rows, 0.8, threads=threads
        )
        expected = _beside(starts, ends, tips, ways, own, 0.8)
        assert numpy.isfinite(expected).sum() > 100
        assert numpy.allclose(found, expected, rtol=1e-9, atol=1e-12)


def test_links_are_no_earlier_pass():
    moves = [(RAPID, 0, 0, 5, 0, 0, 0, 0), (LINK, 9, 0, 0, 0, 0, 0, 1), (CUT, 9, 9, 0, 0, 0, 0, 1)]
    assert places.places_along(moves, 5, 1.0).uncut.tolist() == ["slot"] * 5
