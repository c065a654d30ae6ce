"""Each property does to the path what it promises, in mm, degrees and mm/min."""

import math

import Part
import pytest
from conftest import check_path, moves_of, points_of, sweep_of
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, circle, face_of, rectangle

CUT, LINK, PLUNGE = 255, 1500, 100  # mm/min: feeds that tell the kinds of moves apart
ROUNDING = 0.0015  # mm: what the grid of the output can do to a distance


@pytest.fixture
def pocket(bench):
    """Makes a Bench with one pocket, or several, whose moves are told by their feeds."""

    def make(*faces):
        b = bench(block_with(*faces), feed=CUT)
        b.controller.VertFeed = "%g mm/min" % PLUNGE
        return b

    return make


def cleared(b, **properties):
    return b.done(b.operation(LinkFeed="%g mm/min" % LINK, **properties))


def of_feed(op, feed):
    return [move for move in moves_of(op) if move[0] != "G0" and move[4] == pytest.approx(feed)]


def radius_of(move):
    _, start, _, centre, _ = move
    return math.dist(start[:2], centre)


def arcs(moves, name=None):
    return [m for m in moves if m[3] and name in (None, m[0])]


def length_of(move):
    name, start, end, centre, _ = move
    if not centre:
        return math.dist(start, end)
    return math.hypot(radius_of(move) * sweep_of(*move[:4]), end[2] - start[2])


ROUND = face_of(circle(0, 0, 20))  # nothing in it asks for a radius tighter than the wished ones


# ---- engagement ----


@pytest.mark.parametrize("step, angle", [(0.6, 36.87), (1.5, 60), (3.0, 90)])
def test_the_side_step_sets_the_engagement_and_the_length_of_the_path(pocket, step, angle):
    op = cleared(pocket(ROUND), SideStep=step)
    assert angle - 3 < op.MaxEngagement.Value < angle + 1.3
    # What the helix has left, in strips one side step wide. Only the first time round and the
    # last, along the wall, can be narrower.
    area = math.pi * (20**2 - (2.7 + 3) ** 2)
    length = sum(map(length_of, of_feed(op, CUT)))
    assert area / step < length < area / step + 2 * math.pi * 17


@pytest.mark.parametrize("mode, side", [("Climb", 1), ("Conventional", -1)])
def test_the_cut_mode_decides_on_which_side_the_wall_lies(pocket, mode, side):
    op = cleared(pocket(ROUND), CutMode=mode)
    check_path(op, [ROUND.translated(Vector(0, 0, -DEPTH))])
    along_wall = [
        m
        for m in arcs(of_feed(op, CUT))
        if radius_of(m) == pytest.approx(17, abs=2e-3) and math.hypot(*m[3]) < 0.01
    ]
    assert sum(map(length_of, along_wall)) > 2 * math.pi * 16.9  # all the way round
    for move in along_wall:
        assert side * sweep_of(*move[:4]) > 0  # counter-clockwise: the wall lies to the right


# ---- radii ----


@pytest.mark.parametrize("wish", [0.9, 2.0])
def test_no_turn_is_tighter_than_the_minimum_radius_where_there_is_room(pocket, wish):
    op = cleared(pocket(ROUND), MinimumRadius=wish, RollRadius=0.3)
    tightest = min(radius_of(m) for m in arcs(of_feed(op, CUT)))
    assert 0.97 * wish < tightest < 1.1 * wish
    assert "Turned more tightly" not in op.Report


@pytest.mark.parametrize("wish", [0.9, 2.0])
def test_no_turn_into_the_material_is_tighter_than_the_roll_radius(pocket, wish):
    op = cleared(pocket(ROUND), RollRadius=wish, MinimumRadius=0.3)
    tightest = min(radius_of(m) for m in arcs(of_feed(op, CUT), "G3"))
    # The shortest turns are of a few hundredths, whose radius the output's grid changes.
    assert 0.95 * wish < tightest < 1.1 * wish
    assert "Turned more tightly" not in op.Report


def test_a_wished_radius_that_corners_do_not_allow_shrinks(pocket):
    op = cleared(pocket(face_of(SQUARE)), MinimumRadius=2)
    check_path(op, [face_of(SQUARE).translated(Vector(0, 0, -DEPTH))])
    assert "Turned more tightly" not in op.Report  # of corners nobody needs to be told
    assert min(radius_of(m) for m in arcs(of_feed(op, CUT))) < 1


def test_a_wished_radius_that_the_width_does_not_allow_shrinks_and_is_reported(pocket):
    op = cleared(pocket(face_of(SQUARE)), MinimumRadius=50)
    assert "Turned more tightly than the wished 50.000 mm" in op.Report


# ---- walls ----


def test_the_wall_pass_takes_what_is_left_in_the_corners(pocket):
    corners = [(0, 0), (40, 0), (5, 15)]
    b = pocket(face_of([(x, y, 0) for x, y in corners]))
    with_pass, without = cleared(b, WallPass=True), cleared(b, WallPass=False)
    for k, corner in enumerate(corners):
        a, c = (Vector(*corners[k - n], 0) - Vector(*corner, 0) for n in (1, 2))
        half = math.sin(a.getAngle(c) / 2)

        def from_wall(op):
            """mm between the tool and the corner's walls when it is deepest in the corner."""
            return min(math.dist(p[:2], corner) for p in points_of(op)) * half - 3

        assert -ROUNDING < from_wall(with_pass) < ROUNDING
        assert from_wall(without) > from_wall(with_pass) + 0.5e-3
    assert with_pass.RemovedVolume > without.RemovedVolume
    assert "Left uncut" not in with_pass.Report


@pytest.mark.parametrize("stock", [0.0, 0.25, 1.0])
def test_stock_to_leave_is_what_stays_at_walls_and_islands(pocket, stock):
    island = circle(15, 15, 4)
    b = pocket(face_of(SQUARE, [island]))
    points = points_of(cleared(b, StockToLeave=stock))
    at_wall = min(min(x, y, 30 - x, 30 - y) for x, y, *_ in points) - 3
    at_island = min(math.dist(p[:2], (15, 15)) for p in points) - 4 - 3
    assert at_wall == pytest.approx(stock, abs=0.002) and at_wall > stock - ROUNDING
    assert at_island == pytest.approx(stock, abs=0.002) and at_island > stock - ROUNDING


# ---- feeds ----


def test_constant_feed_is_the_controllers_horizontal_feed(pocket):
    op = cleared(pocket(face_of(SQUARE)), FeedControl="Constant feed")
    feeds = {round(move[4], 6) for move in moves_of(op) if move[0] != "G0"}
    assert feeds == {CUT, LINK, PLUNGE}


@pytest.mark.parametrize("cap", [300, 450, 900])
def test_constant_removal_rate_raises_the_feed_up_to_the_maximum(pocket, cap):
    op = cleared(
        pocket(face_of(SQUARE)),
        FeedControl="Constant removal rate",
        MaximumFeed="%g mm/min" % cap,
    )
    feeds = [m[4] for m in moves_of(op) if m[0] != "G0" and m[4] not in (LINK, PLUNGE)]
    assert max(feeds) <= cap + 1e-6
    assert max(feeds) > 0.99 * cap  # rolling in, there is next to nothing to remove
    # Where the engagement is at its target, the nominal feed must not be passed.
    assert min(feeds) < 1.05 * CUT


def test_a_higher_maximum_feed_saves_time_and_a_constant_feed_none(pocket):
    b = pocket(face_of(SQUARE))
    times = [cleared(b, FeedControl="Constant feed").CuttingTime]
    for cap in (300, 450, 900):
        op = b.operation(FeedControl="Constant removal rate", LinkFeed="%g mm/min" % LINK)
        op.MaximumFeed = "%g mm/min" % cap
        times.append(b.done(op).CuttingTime)
    assert times == sorted(times, reverse=True) and times[-1] < 0.95 * times[0]


@pytest.mark.parametrize("feed", [700, 2000])
def test_links_run_at_the_link_feed(pocket, feed):
    b = pocket(face_of(SQUARE))
    op = cleared(b)
    length = sum(map(length_of, of_feed(op, LINK)))
    op.LinkFeed = "%g mm/min" % feed
    b.done(op)
    assert length > 50 and of_feed(op, LINK) == []
    # The links' way may change with the feed: a retract is chosen where it is quicker.
    assert sum(map(length_of, of_feed(op, feed))) > 30


# ---- links ----


def links_of(op):
    """Runs of moves at the link feed: [[move, ...], ...]."""
    runs, before = [], None
    for move in moves_of(op):
        is_link = move[0] != "G0" and move[4] == pytest.approx(LINK) and move[1][:2] != move[2][:2]
        if is_link and before:
            runs[-1].append(move)
        elif is_link:
            runs.append([move])
        before = is_link
    return runs


@pytest.mark.parametrize("lift", [0.0, 0.2, 0.5])
def test_links_rise_by_exactly_the_lift_where_they_are_long_enough(pocket, lift):
    op = cleared(pocket(face_of(rectangle(0, 0, 50, 22))), LinkLift=lift)
    links = links_of(op)
    highest = [max(end[2] for _, _, end, *_ in run) + DEPTH for run in links]
    assert max(highest) == pytest.approx(lift, abs=1e-6)
    for run, height in zip(links, highest):
        assert run[0][1][2] == run[-1][2][2] == -DEPTH  # they begin and end at depth
        length = sum(map(length_of, run))
        if lift and length > 20 * lift:
            assert height == pytest.approx(lift, abs=1e-6)
        for move in run:
            assert abs(move[2][2] - move[1][2]) <= 0.35 * length_of(move) + 1e-3


def test_lifted_links_stay_below_the_top_of_their_level(pocket):
    op = cleared(pocket(face_of(SQUARE)), LinkLift=50, StepDown=1.5)
    seen = set()
    for run in links_of(op):
        level = run[0][1][2]
        seen.add(level)
        assert max(end[2] for _, _, end, *_ in run) <= level + 1.5 + 1e-6
    assert seen == {-1.5, -3.0}


# ---- entries ----


def descents(op):
    """The moves at the plunge feed, without the straight ones in the air above the top."""
    return [m for m in of_feed(op, PLUNGE) if m[2][2] < 0]


@pytest.mark.parametrize("diameter", [2.0, 5.4])
def test_the_helix_has_its_diameter(pocket, diameter):
    op = cleared(pocket(face_of(SQUARE)), Entry="Helix", HelixDiameter=diameter)
    helix = arcs(descents(op))
    assert helix and len(helix) == len(descents(op))
    for move in helix:
        assert 2 * radius_of(move) == pytest.approx(diameter, abs=0.003)
        assert move[3] == pytest.approx((15, 15), abs=0.003)


def test_a_helix_that_does_not_fit_shrinks(pocket):
    face = face_of(circle(0, 0, 4))
    op = cleared(pocket(face), HelixDiameter=5.4)
    assert all(0.5 < radius_of(m) < 1 for m in arcs(of_feed(op, PLUNGE)))
    assert max(math.hypot(x, y) for x, y, *_ in points_of(op)) < 1 + ROUNDING


@pytest.mark.parametrize("entry", ["Helix", "Ramp"])
@pytest.mark.parametrize("angle", [1.0, 3.0, 6.0])
def test_helix_and_ramp_descend_at_the_helix_angle(pocket, entry, angle):
    op = cleared(pocket(face_of(SQUARE)), Entry=entry, HelixAngle=angle)
    down = [m for m in descents(op) if m[2][2] < m[1][2]]
    slopes = [math.degrees(math.asin((m[1][2] - m[2][2]) / length_of(m))) for m in down]
    # Turns and legs are whole ones, so it is a little less than the angle.
    assert 0.8 * angle < min(slopes) and max(slopes) < 1.001 * angle
    assert sum(m[1][2] - m[2][2] for m in down) == pytest.approx(down[0][1][2] + DEPTH)


def test_helix_and_ramp_are_what_they_are_called(pocket):
    b = pocket(face_of(SQUARE))
    assert {m[0] for m in descents(cleared(b, Entry="Helix"))} == {"G3"}
    ramp = descents(cleared(b, Entry="Ramp"))
    assert {m[0] for m in ramp} == {"G1"}
    assert len({m[2][:2] for m in ramp}) == 2  # to and fro between two places


def first_descent(op):
    """The moves of `descents` that go down."""
    return [m for m in descents(op) if m[2][2] < m[1][2]]


def test_the_automatic_entry_takes_an_open_side_then_a_hole_then_a_helix_then_a_ramp(bench, pocket):
    block = Part.makeBox(40, 30, 10, Vector(0, 0, -10))
    b = bench(block.cut(Part.makeBox(30, 20, 3, Vector(10, 5, -3))))
    b.controller.VertFeed = "%g mm/min" % PLUNGE
    hole = {"HoleDiameter": 8, "EntryPoint": Vector(20, 15, 0)}
    (down,) = first_descent(cleared(b, **hole))
    assert down[2][0] > 43 and down[1][:2] == down[2][:2]  # beside the block
    (down,) = first_descent(cleared(b, Entry="Predrilled hole", **hole))
    assert down[1][:2] == down[2][:2] == (20, 15)
    b = pocket(face_of(SQUARE))
    (down,) = first_descent(cleared(b, **hole))
    assert down[1][:2] == down[2][:2] == (20, 15)
    # A helix that is stretched, so that it removes as much as a cut.
    assert {m[0] for m in first_descent(cleared(b))} == {"G1", "G3"}
    ramp = first_descent(cleared(pocket(face_of(rectangle(0, 0, 30, 6.1)))))
    assert {m[0] for m in ramp} == {"G1"} and all(m[1][:2] != m[2][:2] for m in ramp)


@pytest.mark.parametrize("kind", ["adaptive", "trochoid"])
def test_the_tool_comes_in_over_the_open_side_that_is_nearest_to_a_place(bench, kind):
    block = Part.makeBox(40, 30, 10, Vector(0, 0, -10))
    b = bench(block.cut(Part.makeBox(40, 20, 3, Vector(0, 5, -3))))
    b.controller.VertFeed = "%g mm/min" % PLUNGE
    for wish, side in (((-4, 15), -1), ((44, 12), 1), ((1, 24), -1)):
        op = cleared(b, kind=kind, ChooseOpenSide=True, OpenSideAt=Vector(*wish, 7))
        down = first_descent(op)[0][2]
        assert (down[0] < -3) if side < 0 else (down[0] > 43)
        assert 5 < down[1] < 25
        assert op.UncutArea.Value < 0.01


def test_a_lame_spiral_has_no_open_side(pocket):
    op = pocket(face_of(SQUARE)).operation(kind="lame_spiral")
    assert not hasattr(op, "ChooseOpenSide") and not hasattr(op, "OpenSideAt")


def test_a_hole_in_one_pocket_leaves_the_others_their_own_entry(pocket):
    b = pocket(face_of(SQUARE), face_of(rectangle(40, 0, 70, 30)))
    op = cleared(b, HoleDiameter=8, EntryPoint=Vector(15, 15, 0))
    down = first_descent(op)
    assert {m[0] for m in down if m[2][0] < 35} == {"G1"}
    assert "G3" in {m[0] for m in down if m[2][0] > 35}
    assert "does not hold the pre-drilled hole" in op.Report


def test_a_helix_wider_than_the_tool_is_narrowed_and_reported(pocket):
    op = cleared(pocket(face_of(SQUARE)), HelixDiameter=8)
    assert "Helix diameter 8 mm was taken as 5.88 mm" in op.Report
    assert max(2 * radius_of(m) for m in arcs(of_feed(op, PLUNGE))) < 5.9


# ---- order ----


@pytest.mark.parametrize("control", ["Constant feed", "Constant removal rate"])
@pytest.mark.parametrize(
    "order, places",
    [
        ("Region", [(0, -1.5), (0, -3), (1, -1.5), (1, -3)]),
        ("Depth", [(0, -1.5), (1, -1.5), (0, -3), (1, -3)]),
    ],
)
def test_several_pockets_are_cut_one_by_one_or_level_by_level(pocket, control, order, places):
    floors = [face_of(SQUARE), face_of(rectangle(40, 0, 70, 30))]
    op = cleared(pocket(*floors), OrderBy=order, StepDown=1.5, FeedControl=control)
    check_path(op, [floor.translated(Vector(0, 0, -DEPTH)) for floor in floors])
    seen = []
    for name, start, end, _, feed in moves_of(op):
        if name == "G0":
            if None not in start and (start[0] < 35) != (end[0] < 35):
                assert min(start[2], end[2]) >= op.ClearanceHeight.Value
        elif feed not in (LINK, PLUNGE) and end[2] == start[2]:
            place = (int(end[0] > 35), end[2])
            if place not in seen[-1:]:
                seen.append(place)
    assert seen == places
    # Every region has its own descent at every level.
    assert (
        len(
            {(m[2][0] > 35, m[2][2]) for m in first_descent(op)}
            & set((x, z) for x in (False, True) for z in (-1.5, -3))
        )
        == 4
    )


# ---- narrow passages ----

# Two rooms of 20 mm, joined by a neck of 6.3 mm.
ROOMS = face_of(
    [
        (x, y, 0)
        for x, y in (
            *((0, 0), (20, 0), (20, 7), (32, 7), (32, 0), (52, 0)),
            *((52, 20), (32, 20), (32, 13.3), (20, 13.3), (20, 20), (0, 20)),
        )
    ]
)


def test_narrow_passages_are_cut_by_trochoids_unless_told_otherwise(pocket):
    op = cleared(pocket(ROOMS))
    assert op.NarrowPassages == "Trochoid with smaller radius"
    assert op.MaxEngagement.Value < 62 and "passage" not in op.Report
    check_path(op, [ROOMS.translated(Vector(0, 0, -DEPTH))])


@pytest.mark.parametrize("control", ["Constant feed", "Constant removal rate"])
def test_narrow_passages_can_be_cut_at_a_reduced_feed(pocket, control):
    op = cleared(pocket(ROOMS), NarrowPassages="Cut at reduced feed", FeedControl=control)
    check_path(op, [ROOMS.translated(Vector(0, 0, -DEPTH))])
    assert "Cut at reduced feed: the passage near" in op.Report and op.UncutArea.Value == 0
    assert op.MaxEngagement.Value == pytest.approx(180, abs=1)
    slow = [m for m in moves_of(op) if m[0] != "G0" and m[4] < 0.3 * CUT]
    # A constant removal rate may be some percent above the nominal one.
    assert slow and min(m[4] for m in slow) == pytest.approx(CUT / 4, rel=0.045)
    for _, start, end, *_ in slow:
        assert 17 < start[0] < 35 and 17 < end[0] < 35
    assert sum(map(length_of, slow)) > 10


def test_narrow_passages_can_be_skipped_and_are_reported(pocket):
    op = cleared(pocket(ROOMS), NarrowPassages="Skip and report")
    assert "Skipped: the passage near (26" in op.Report and "6.30 mm wide" in op.Report
    assert 0.5 * 12 * 6.3 < op.UncutArea.Value < 12 * 6.3
    assert op.MaxEngagement.Value < 62
    assert not [p for p in points_of(op) if 21 < p[0] < 31 and p[2] < 0]
    entered = {m[2][0] > 26 for m in first_descent(op)}
    assert entered == {False, True}


def test_a_slot_hardly_wider_than_the_tool_is_cut_at_a_reduced_feed_at_once(pocket):
    slot = face_of(rectangle(0, 0, 40, 6.02))
    op = cleared(pocket(slot), NarrowPassages="Cut at reduced feed")
    check_path(op, [slot.translated(Vector(0, 0, -DEPTH))])
    assert op.UncutArea.Value == 0 and len(op.Path.Commands) < 100
    ramp = first_descent(op)
    assert {m[0] for m in ramp} == {"G1"}
    assert max(length_of(m) for m in ramp) > 8.9  # along the slot


# ---- output ----


@pytest.mark.parametrize("tolerance", [0.005, 0.02])
def test_lines_in_place_of_arcs_keep_to_the_tolerance_and_off_the_wall(pocket, tolerance):
    op = cleared(pocket(ROUND), Arcs=False, Tolerance=tolerance)
    assert {name for name, *_ in moves_of(op)} == {"G0", "G1"}
    assert max(math.hypot(x, y) for x, y, *_ in points_of(op)) < 17 + ROUNDING / 2
    along_wall = [
        (start, end)
        for _, start, end, *_ in of_feed(op, CUT)
        if min(math.hypot(*start[:2]), math.hypot(*end[:2])) > 17 - 0.002
    ]
    deepest = max(17 - math.hypot(*((a[0] + b[0]), (a[1] + b[1]))) / 2 for a, b in along_wall)
    assert 0.7 * tolerance < deepest < tolerance + ROUNDING


def test_a_larger_tolerance_needs_fewer_lines(pocket):
    b = pocket(ROUND)
    counts = [len(of_feed(cleared(b, Arcs=False, Tolerance=t), CUT)) for t in (0.002, 0.008, 0.032)]
    # Chords grow with the root of what they may leave the arc by.
    assert counts[0] > 1.4 * counts[1] > 1.4**2 * counts[2]


@pytest.mark.parametrize("with_arcs", [True, False])
@pytest.mark.parametrize("tolerance", [0.002, 0.005, 0.05, 0.2])
def test_at_a_wall_that_is_no_arc_the_tolerance_is_kept_inwards(pocket, tolerance, with_arcs):
    face = Part.Face(Part.Wire(Part.Ellipse(Vector(), 25, 14).toShape()))
    op = cleared(pocket(face), Tolerance=tolerance, Arcs=with_arcs)
    wall = face.OuterWire
    gaps = [
        wall.distToShape(Part.Vertex(x, y, 0))[0] - 3
        for x, y, z, _ in points_of(op, step=0.2)
        if z == -DEPTH and (x / 22.2) ** 2 + (y / 11.2) ** 2 > 0.93
    ]
    assert len(gaps) > 300
    assert min(gaps) > -ROUNDING / 2
    # All along: of the last time round, the furthest away from the wall.
    near = [gap for gap in gaps if gap < tolerance + ROUNDING]
    assert len(near) > 300
