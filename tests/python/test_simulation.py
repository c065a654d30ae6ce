"""evenload.simulate: what it takes, what its arrays and figures mean, what it refuses."""

import json
import math
import subprocess
import sys

import evenload
import numpy
import pytest
from evenload import compiled, machines

core = compiled.core()
RAPID, LINK, ENTRY, CUT = range(4)
RADIUS, DEPTH, FEED, SPEED = 3.0, 3.0, 255.0, 6366.0
BELOW = (-30, -30, 30, 0)  # stock below the line y = 0
AROUND = (-30, -30, 30, 30)
STAR = {"material": "Star test piece", "spindle_speed": SPEED}
UP = (RAPID, -40, 0, 5, 0, 0, 0, 0)


def line_at(y, z=-DEPTH):
    """Moves along the stock from left to right, at `y`."""
    return [UP, (LINK, -40, y, z, 0, 0, 0, 600), (CUT, 40, y, z, 0, 0, 0, FEED)]


def climb(degrees):
    """Moves that cut BELOW at that engagement, the material on the right."""
    return line_at(RADIUS * math.cos(math.radians(degrees)))


def simulated(source, stock=AROUND, **options):
    return evenload.simulate(source, stock, 0, -DEPTH, 2 * RADIUS, **options)


def middle(run):
    """The sample of the cut nearest to x = 0."""
    return int(numpy.argmin(numpy.where(run.kind == CUT, abs(run.x), numpy.inf)))


def written(folder, text, name="path.ngc"):
    path = folder / name
    path.write_text(text)
    return path


def same_load(a, b):
    """Whether two runs have the same samples and loads, bit by bit."""
    names = ("x", "y", "z", "kind", "length", "time_s", "engagement_deg", "removal_rate")
    return all(numpy.array_equal(getattr(a, n), getattr(b, n)) for n in names)


def spiral(moves=400, pitch=2.0):
    path = [(RAPID, 0, 0, 5, 0, 0, 0, 0), (ENTRY, 0, 0, -DEPTH, 0, 0, 0, 100)]
    for k in range(1, moves + 1):
        radius = 20 * math.sqrt(k / moves)
        angle = 2 * math.pi * radius / pitch
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        path.append((CUT, x, y, -DEPTH, 0, 0, 0, FEED))
    return path


# ---- importing ----


def test_importing_evenload_imports_nothing_compiled():
    code = (
        "import sys; before = set(sys.modules); import evenload; print(set(sys.modules) - before)"
    )
    output = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout
    assert output.strip() == "{'evenload'}"


def test_what_the_package_does_not_have_is_an_attribute_error():
    with pytest.raises(AttributeError, match="'simulated'"):
        evenload.simulated


# ---- sources ----


def test_a_file_as_text_or_path_and_a_list_of_moves_give_the_same_load(tmp_path):
    path = written(tmp_path, "G0 X-40 Y1.5 Z5\nG1 Z-3 F600\nG1 X40 F255\n")
    moves = [(RAPID, -40, 1.5, 5, 0, 0, 0, 0)]
    moves += [(CUT, -40, 1.5, -3, 0, 0, 0, 600), (CUT, 40, 1.5, -3, 0, 0, 0, FEED)]
    by_list = simulated(moves, BELOW, infer_kinds=True)
    assert by_list.max_engagement_deg == pytest.approx(60, abs=0.2)
    for source in (str(path), path, tuple(moves), iter(moves), numpy.array(moves)):
        assert same_load(simulated(source, BELOW, infer_kinds=True), by_list)


def test_a_toolpath_of_the_core_runs_as_its_moves_do():
    pocket = [(-15, -10, 0), (15, -10, 0), (15, 10, 0), (-15, 10, 0)]
    path = core.clear_pocket(
        [core.Region(pocket)],
        tool_diameter=2 * RADIUS,
        engagement_angle=math.radians(60),
        feed=FEED,
        plunge_feed=100,
        link_feed=1500,
        maximum_feed=1000,
        levels=[-DEPTH],
        safe_height=2,
        clearance_height=5,
    )
    part = core.Region(
        [(x, y, 0) for x, y in ((-30, -30), (30, -30), (30, 30), (-30, 30))], [pocket]
    )
    run = simulated(path, part=part)
    assert same_load(run, simulated(path.moves, part=part))
    assert run.incidents == [] and run.gouge_mm < 0.01 and run.rest_area < 0.1
    assert run.max_engagement_deg < 65
    assert run.removed_area == pytest.approx(600 - (4 - math.pi) * RADIUS**2, rel=5e-4)
    # Its own kinds are kept.
    assert set(run.kind) == {move[0] for move in path.moves[1:]}


def test_samples_of_a_file_have_its_lines_and_those_of_moves_the_lines_given(tmp_path):
    path = written(tmp_path, "(begin)\nG0 X-40 Y1.5 Z5\n\nG1 Z-3 F600\nG1 X40 F255\n")
    run = simulated(path, BELOW)
    assert list(dict.fromkeys(zip(run.move.tolist(), run.line.tolist()))) == [(1, 4), (2, 5)]
    run = simulated(climb(60), BELOW, lines=[7, 8, 30])
    assert list(dict.fromkeys(zip(run.move.tolist(), run.line.tolist()))) == [(1, 8), (2, 30)]
    assert not simulated(climb(60), BELOW).line.any()


def test_a_file_s_notes_and_spindle_speed_are_taken(tmp_path):
    text = "T1 M6\nS3000 M3\nG0 X-40 Y1.5 Z5 A2\nG1 Z-3 F600\nS4000\nT2 M6\nG1 X40 F400\n"
    run = simulated(written(tmp_path, text), BELOW, teeth=2)
    assert run.feed_per_tooth[middle(run)] == pytest.approx(400 / 3000 / 2)  # the lowest speed
    assert run.notes == [
        "Line 3: 'A2' is not simulated.",
        "The program has several spindle speeds: the lowest, 3000 rev/min, was taken.",
        "The program changes tools: all of it was simulated with one.",
    ]
    own = simulated(tmp_path / "path.ngc", BELOW, teeth=2, cutting={"spindle_speed": 8000})
    assert own.feed_per_tooth[middle(own)] == pytest.approx(400 / 8000 / 2)


def test_kinds_are_told_from_what_moves_do_in_files_only_unless_asked(tmp_path):
    # Down beside the stock, through it, on faster beside it, and back up.
    path = written(tmp_path, "G0 X-40 Y0 Z5\nG1 Z-3 F600\nX40 F255\nY50 F900\nZ5\nG0 X0\n")
    told = [(1, ENTRY), (2, CUT), (3, LINK), (4, LINK), (5, RAPID)]
    plain = [(1, ENTRY), (2, CUT), (3, CUT), (4, CUT), (5, RAPID)]  # a plunge is no cut
    moves = core.read_gcode(path.read_text()).moves
    for source, asked, expected in (
        (path, None, told),
        (path, False, plain),
        (moves, None, plain),
        (moves, True, told),
    ):
        run = simulated(source, infer_kinds=asked)
        assert list(dict.fromkeys(zip(run.move.tolist(), run.kind.tolist()))) == expected


# ---- stock, part and fixtures ----

BOX_CHAIN = [(-30, -30, 0), (30, -30, 0), (30, 0, 0), (-30, 0, 0)]


@pytest.mark.parametrize(
    "stock",
    (
        list(BELOW),
        numpy.array(BELOW),
        core.Region(BOX_CHAIN),
        BOX_CHAIN,
        [point[:2] for point in BOX_CHAIN],
        core.Region(BOX_CHAIN).outer,
        numpy.array(BOX_CHAIN),
        [BELOW],
        (BELOW, 0),
        [(core.Region(BOX_CHAIN), 0.0)],
        [(-30, -30, -5, 0), (-5, -30, 30, 0)],
        [(-30, -30, -5, 0), [(-5, -30), (30, -30), (30, 0), (-5, 0)]],
    ),
    ids=lambda stock: type(stock).__name__,
)
def test_stock_is_the_same_in_all_its_words(stock):
    run = simulated(climb(60), stock)
    assert run.removed_volume_total == pytest.approx(60 * 1.5 * DEPTH, rel=1e-3)
    assert run.engagement_deg[middle(run)] == pytest.approx(60, abs=0.2)
    assert run.stock.volume == pytest.approx((60 * 30 - 60 * 1.5) * DEPTH, rel=1e-6)
    assert sum(region.area for region in run.stock_regions) == pytest.approx(60 * 30)


def test_a_chain_with_bulges_is_a_disc():
    run = simulated(line_at(20), [(-10, 0, 1), (10, 0, 1)])
    assert run.stock.area == pytest.approx(100 * math.pi, rel=1e-4)
    assert run.removed_volume_total == 0 and run.max_engagement_at is None


def test_stock_has_the_heights_that_are_given_with_it():
    run = simulated(line_at(0), [((-30, -10, 0, 10), -1), (0, -10, 30, 10)])
    at = [int(numpy.argmin(abs(run.x - x))) for x in (-15, 15)]
    assert run.axial_depth[at] == pytest.approx([2, 3])
    assert run.stock.height_at(-15, 8) == -1 and run.stock.height_at(15, 8) == 0
    assert run.top == 0 and run.bottom == -DEPTH


def test_what_a_simulation_left_is_stock_for_another_and_stays_as_it_was():
    first = simulated(line_at(0))
    volume = first.stock.volume
    again = simulated(line_at(0), first)
    assert again.removed_volume_total == 0 and again.engagement_deg.max() == 0
    assert again.air_mm == pytest.approx(again.cut_mm) == pytest.approx(80)
    beside = simulated(line_at(4.5), first)
    assert beside.engagement_deg[middle(beside)] == pytest.approx(
        math.degrees(math.acos(-0.5)), abs=0.2
    )
    assert first.stock.volume == volume
    assert (beside.top, beside.bottom, beside.stock_regions) == (0, -DEPTH, [])


def test_what_was_cut_earlier_is_gone(tmp_path):
    first = simulated(line_at(0))
    expected = simulated(line_at(4.5), first)
    path = written(tmp_path, "G0 X-40 Y0 Z5\nG1 Z-3 F600\nX40\n")
    for source in (line_at(0), path, str(path)):
        run = simulated(line_at(4.5), earlier=[(source, 2 * RADIUS)])
        assert same_load(run, expected)
    # A hole of 10 mm, drilled: the tool of 6 mm goes down in it freely.
    down = [(RAPID, 0, 0, 5, 0, 0, 0, 0), (ENTRY, 0, 0, -DEPTH, 0, 0, 0, 100)]
    assert simulated(down).plunge_in_material_mm == pytest.approx(DEPTH, abs=0.1)
    assert simulated(down, earlier=[(down, 10)]).plunge_in_material_mm == 0


GOUGED = (-30, -30, 30, -1.45)  # its border is 0.05 mm within the tool at y = 1.5
GOUGED_CHAIN = [(-30, -30, 0), (30, -30, 0), (30, -1.45, 0), (-30, -1.45, 0)]


@pytest.mark.parametrize(
    "part",
    (
        GOUGED,
        core.Region(GOUGED_CHAIN),
        GOUGED_CHAIN,
        [GOUGED],
        (GOUGED, 0),
        [(GOUGED_CHAIN, -1.5)],
        [(-30, -30, -20, -1.45), (core.Region(GOUGED_CHAIN), -0.5)],
    ),
    ids=lambda part: type(part).__name__,
)
def test_a_part_is_gouged_in_all_its_words(part):
    run = simulated(climb(60), BELOW, part=part, lines=[1, 2, 30])
    assert run.gouge_mm == pytest.approx(0.05, abs=1e-6)
    assert run.gouge_at[1:] == pytest.approx((1.5, -DEPTH))
    ((what, x, y, z, move, line, amount),) = run.incidents
    assert (what, (x, y, z), move, line, amount) == ("gouge", run.gouge_at, 2, 30, run.gouge_mm)
    assert run.gouge[middle(run)] == pytest.approx(0.05, abs=1e-6)
    assert run.gouge[0] == 0


def test_without_a_part_nothing_must_stay():
    for part in (None, [], ()):
        run = simulated(climb(60), BELOW, part=part, fixtures=part)
        assert run.gouge_mm == 0 and run.gouge_at is None
        assert run.fixture_mm == (None if part is None else 0)
        assert run.rest_area == pytest.approx(run.stock.area) == pytest.approx(60 * 28.5)


def test_a_floor_is_part_up_to_its_height():
    run = simulated(line_at(0, z=-2), part=(AROUND, -1.9))
    assert run.gouge_mm == pytest.approx(0.1)
    run = simulated(line_at(0, z=-2), part=(AROUND, -2))
    assert run.gouge_mm == 0 and run.axial_depth[middle(run)] == pytest.approx(2)
    assert run.rest_depth == pytest.approx(2)


def test_a_fixture_is_found_where_it_stands_also_above_the_stock():
    clamp = ((20, -2, 25, 2), 10)
    over = [UP, (RAPID, 40, 0, 5, 0, 0, 0, 0)]
    run = simulated(over, fixtures=clamp)
    assert run.fixture_mm == pytest.approx(RADIUS + 2) and run.gouge_mm == 0
    ((what, x, y, z, move, _, amount),) = run.incidents
    assert (what, (x, y, z), move, amount) == ("fixture", run.fixture_at, 1, run.fixture_mm)
    assert 20 <= x <= 25 and (y, z) == (0, 5)
    clear = [UP, (RAPID, 40, 0, 10, 0, 0, 0, 0)]
    assert simulated(clear, fixtures=clamp, part=(20, -2, 25, 2)).fixture_mm > 0
    above = [(RAPID, -40, 0, 11, 0, 0, 0, 0), (RAPID, 40, 0, 11, 0, 0, 0, 0)]
    assert simulated(above, fixtures=clamp).incidents == []


def test_a_corner_that_the_tool_cannot_reach_is_no_rest():
    moves = [UP]
    for y in range(3, 34, 5):
        moves += [(LINK, -40, y, -DEPTH, 0, 0, 0, 600), (CUT, -3, y, -DEPTH, 0, 0, 0, FEED)]
        moves.append((LINK, -40, y, -DEPTH, 0, 0, 0, 600))
    moves += [(LINK, -3, 3, -DEPTH, 0, 0, 0, 600), (CUT, -3, 40, -DEPTH, 0, 0, 0, FEED)]
    run = simulated(moves, part=[(0, -30, 30, 30), (-30, -30, 0, 0)])
    assert run.unreachable_area == pytest.approx((1 - math.pi / 4) * RADIUS**2, rel=0.01)
    assert run.rest_area == 0 and run.rest_at is None and run.rests == run.rest_outlines == []
    assert run.gouge_mm < 1e-9


def test_patches_of_rest_have_their_areas_places_and_outlines():
    away = [UP, (RAPID, 40, 0, 5, 0, 0, 0, 0)]
    run = simulated(away, part=[(-10, -30, 30, 0), (0, 0, 30, 30), (-30, -30, -10, -20)])
    # Left are 30 x 30 mm above and, apart but for an edge, 20 x 20 mm below: one patch.
    corners = 2 * (1 - math.pi / 4) * RADIUS**2
    assert run.rest_area == pytest.approx(1300 - corners, abs=1)
    assert run.unreachable_area == pytest.approx(corners, abs=1)
    ((area, x, y, depth),) = run.rests
    assert (area, depth) == (pytest.approx(run.rest_area), DEPTH) and run.rest_at == (x, y)
    assert x == pytest.approx(-15, abs=0.1) and 0 <= y <= 30
    tiles = sum(abs(_area(outline)) for outline in run.rest_outlines)
    assert tiles == pytest.approx(run.rest_area, rel=0.01)
    run = simulated(away, part=[(-10, -30, 30, 30), (-30, -5, -10, 0)])
    areas, places = zip(*((patch[0], patch[1:3]) for patch in run.rests))
    assert areas == pytest.approx((600 - corners / 2, 500 - corners / 2), abs=1)
    assert places[0][1] > 0 > places[1][1] and run.rest_at == places[0]


def _area(points):
    pairs = zip(points, points[1:] + points[:1])
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2


# ---- the record ----


def test_all_arrays_have_one_length():
    run = simulated(climb(60), BELOW, cutting=STAR, machine="linuxcnc_mill")
    size = len(run.x)
    arrays = {k: v for k, v in vars(run).items() if isinstance(v, numpy.ndarray)}
    assert len(arrays) == 27
    assert arrays.pop("arcs").shape == (run.first_arc[-1], 3)
    assert arrays.pop("first_arc").shape == (size + 1,)
    assert {v.shape for v in arrays.values()} == {(size,)}
    assert not any(numpy.isnan(v).any() for v in arrays.values())
    assert run.length[abs(run.x) < 30].max() <= 0.1 + 1e-9  # beside the stock it is one step
    assert len(simulated(climb(60), BELOW, step=1.0).x) < size / 3


def test_samples_lie_along_the_path_from_each_move_s_start_to_its_end():
    run = simulated(climb(60), BELOW)
    for number, before, to in ((1, climb(60)[0], climb(60)[1]), (2, *climb(60)[1:])):
        own = run.move == number
        places = numpy.stack([run.x, run.y, run.z], axis=1)[own]
        assert places[0] == pytest.approx(before[1:4]) and places[-1] == pytest.approx(to[1:4])
        assert run.length[own][0] == 0
        steps = numpy.linalg.norm(numpy.diff(places, axis=0), axis=1)
        assert run.length[own][1:] == pytest.approx(steps)
        assert set(run.feed[own]) == {to[7]} and set(run.kind[own]) == {to[0]}


@pytest.mark.parametrize("degrees", range(10, 171, 20))
def test_a_straight_cut_touches_one_arc_on_its_right(degrees):
    run = simulated(climb(degrees), BELOW)
    i = middle(run)
    assert run.engagement_deg[i] == pytest.approx(degrees, abs=0.2)
    ((right, left, depth),) = run.arcs_at(i)
    assert right == -90 and left == pytest.approx(degrees - 90, abs=0.2)
    assert depth == run.axial_depth[i] == DEPTH
    assert run.max_engagement_deg == pytest.approx(degrees, abs=0.2)


def test_conventional_milling_touches_the_left():
    backwards = [UP, (LINK, 40, 1.5, -DEPTH, 0, 0, 0, 600), (CUT, -40, 1.5, -DEPTH, 0, 0, 0, FEED)]
    run = simulated([(*UP[:1], 40, 0, 5, 0, 0, 0, 0), *backwards[1:]], BELOW)
    ((right, left, _),) = run.arcs_at(middle(run))
    assert right == pytest.approx(30, abs=0.2) and left == 90


def test_a_slot_is_one_arc_and_contact_on_both_sides_two():
    run = simulated(line_at(0))
    ((right, left, _),) = run.arcs_at(middle(run))
    assert (right, left) == pytest.approx((-90, 90), abs=0.01)
    run = simulated(line_at(0), [(-30, 2.5, 30, 30), (-30, -30, 30, -2.5)])
    theta = math.degrees(math.acos(2.5 / RADIUS))
    right, left = run.arcs_at(middle(run))
    assert right == pytest.approx([-90, theta - 90, DEPTH], abs=0.2)
    assert left == pytest.approx([90 - theta, 90, DEPTH], abs=0.2)
    assert run.engagement_deg[middle(run)] == pytest.approx(2 * theta, abs=0.2)


@pytest.mark.parametrize("degrees", (20, 60, 90, 130, 180))
@pytest.mark.parametrize("teeth", (1, 3))
def test_chips_are_as_thick_as_their_closed_forms_say(degrees, teeth):
    run = simulated(climb(degrees), BELOW, teeth=teeth, cutting={"spindle_speed": SPEED})
    i, theta, per_tooth = middle(run), math.radians(degrees), FEED / SPEED / teeth
    assert run.feed_per_tooth[i] == pytest.approx(per_tooth, rel=1e-12)
    # [Jacsó 2021]; 0.2 degrees of engagement are 2 % of the thickness at 20 degrees.
    thickest = per_tooth * math.sin(min(theta, math.pi / 2))
    mean = per_tooth * (1 - math.cos(theta)) / theta
    assert run.h_max[i] == pytest.approx(thickest, rel=0.01)
    assert run.h_mean[i] == pytest.approx(mean, rel=0.01)
    assert run.force_peak is run.force_peak_max is run.torque_peak is None


def test_without_a_spindle_speed_there_are_no_chips():
    run = simulated(climb(60), BELOW)
    for values in (run.h_max, run.h_mean, run.feed_per_tooth):
        assert len(values) == len(run.x) and numpy.isnan(values).all()


@pytest.mark.parametrize("width", (0.5, 1.5, 3.0, 6.0))
def test_the_removal_rate_is_width_times_depth_times_feed(width):
    run = simulated(line_at(RADIUS - width), BELOW)
    expected = width * DEPTH * FEED
    assert run.removal_rate[middle(run)] == pytest.approx(expected, rel=5e-3)
    # Where the tool leaves the stock's corner, dexels are less exact.
    assert run.removal_rate_peak == pytest.approx(expected, rel=0.01)
    x, y, z = run.removal_rate_peak_at
    assert -33 <= x <= 33 and (y, z) == (RADIUS - width, -DEPTH)


def test_removal_rates_add_up_to_the_volume_removed():
    run = simulated(spiral())
    minutes = numpy.diff(run.time_s) / 60
    by_rate = ((run.removal_rate[1:] + run.removal_rate[:-1]) / 2 * minutes)[run.kind[1:] == CUT]
    cut = run.removed_volume_total - run.removed_volume[run.kind == ENTRY][-1]
    assert by_rate.sum() == pytest.approx(cut, rel=0.01)
    assert (numpy.diff(run.removed_volume) >= 0).all()
    assert run.removed_volume[-1] == run.removed_volume_total
    assert run.removed_volume_total == pytest.approx(DEPTH * run.removed_area, rel=1e-3)
    assert run.stock.volume == pytest.approx(3600 * DEPTH - run.removed_volume_total, rel=1e-6)


def test_the_star_s_straight_cut_needs_the_99_newtons_measured():
    run = simulated(climb(60), BELOW, cutting=STAR)
    i = middle(run)
    assert run.force_peak[i] == pytest.approx(99, abs=1)
    assert run.force_peak_max == run.force_peak[run.kind == CUT].max()
    assert run.force_peak_max == pytest.approx(99, abs=1) and len(run.force_peak_max_at) == 3
    assert run.power_mean[i] == pytest.approx(run.torque_mean[i] * SPEED * 2 * math.pi / 60)
    # The mean power is the tangential force times the cutting speed: K_tc times the removal rate.
    assert run.power_mean[i] == pytest.approx(1169.3 * run.removal_rate[i] / 60 / 1000, rel=1e-3)
    assert 0 < run.force_mean[i] < run.force_peak[i]
    assert max(run.force_x_peak[i], run.force_y_peak[i]) <= run.force_peak[i]
    assert not run.force_peak[run.engagement_deg == 0].any()


def test_forces_are_in_the_machine_s_axes():
    turned = [(k, -y, x, z, s, cx, cy, f) for k, x, y, z, s, cx, cy, f in climb(60)]
    along_x = simulated(climb(60), BELOW, cutting=STAR)
    along_y = simulated(turned, (0, -30, 30, 30), cutting=STAR)
    i, j = middle(along_x), int(numpy.argmin(abs(along_y.y) + 99 * (along_y.kind != CUT)))
    assert along_x.force_x_peak[i] == pytest.approx(along_y.force_y_peak[j], rel=1e-3)
    assert along_x.force_y_peak[i] == pytest.approx(along_y.force_x_peak[j], rel=1e-3)
    assert abs(along_x.force_x_peak[i] - along_x.force_y_peak[i]) > 1


def test_a_material_may_be_a_dictionary_and_twice_as_hard():
    soft, hard = ({"ktc": k, "krc": k / 3} for k in (500, 1000))
    runs = [simulated(climb(60), BELOW, cutting={**STAR, "material": m}) for m in (soft, hard)]
    assert runs[1].force_peak == pytest.approx(2 * runs[0].force_peak)
    straight = simulated(climb(60), BELOW, cutting={**STAR, "helix_angle_deg": 0})
    assert straight.force_peak_max > simulated(climb(60), BELOW, cutting=STAR).force_peak_max


# ---- times and lengths ----


def test_dwells_count_in_the_total_times(tmp_path):
    text = "S3000 M3\nG0 X-40 Y1.5 Z5\nG1 Z-3 F600\nG4 P30\nX40 F400\n"
    run = simulated(written(tmp_path, text), BELOW, machine="linuxcnc_mill")
    assert run.time_total_s == pytest.approx(run.time_s[-1] + 30)
    assert run.machine_time_total_s == pytest.approx(run.machine_time_s[-1] + 30)
    assert "Dwells of 30 s" in run.notes[-1]


def test_the_machine_is_never_faster_than_the_program():
    moves = [*line_at(0), (RAPID, 40, 0, 5, 0, 0, 0, 0), (RAPID, -40, 0, 5, 0, 0, 0, 0)]
    for cutting in ({"rapid_feed": 1000}, {"rapid_feed": 20000}, {}):
        run = simulated(moves, cutting=cutting, machine="machining_centre")
        assert run.machine_time_total_s >= run.time_total_s


def test_a_part_beside_its_stock_is_refused_within_the_stock_s_box_too():
    ell = [(0, 0, 0), (30, 0, 0), (30, 10, 0), (10, 10, 0), (10, 20, 0), (0, 20, 0)]
    with pytest.raises(ValueError, match="does not contain the part: 48 mm2"):
        simulated(climb(60), ell, part=(20, 12, 28, 18))
    with pytest.raises(ValueError, match="does not contain the part"):
        simulated(climb(60), ell, part=(5, 5, 15, 18))
    simulated(climb(60), ell, part=[ell])


def test_the_programmed_time_is_the_sum_of_lengths_over_feeds():
    moves = [*line_at(0), (RAPID, 40, 0, 5, 0, 0, 0, 0), (RAPID, -40, 0, 5, 0, 0, 0, 0)]
    run = simulated(moves, cutting={"rapid_feed": 4000})
    assert run.time_total_s == pytest.approx(60 * (8 / 600 + 80 / FEED + (8 + 80) / 4000))
    assert run.time_s[-1] == run.time_total_s
    assert numpy.diff(run.time_s) == pytest.approx(60 * run.length[1:] / run.feed[1:])
    assert (run.link_mm, run.cut_mm, run.rapid_mm) == pytest.approx((8, 80, 88))
    assert run.air_mm == pytest.approx(80 - 60 - RADIUS, abs=0.2)
    assert run.entry_mm == 0 and run.machine_time_s is run.machine_time_total_s is None
    # Without a rapid feed: 5000 mm/min, or the machine's.
    assert simulated(moves).feed.max() == 5000
    machine = "machining_centre"
    assert simulated(moves, machine=machine).feed.max() == machines.load(machine)["rapid_feed"]


def test_an_arc_is_as_long_as_it_turns():
    start = [(RAPID, 10, 0, 5, 0, 0, 0, 0)]
    run = simulated([*start, (ENTRY, -10, 0, 0, math.pi, 0, 0, 300)])
    assert run.entry_mm == pytest.approx(math.hypot(10 * math.pi, 5))
    half = int(numpy.argmin(abs(run.x)))
    assert run.y[half] == pytest.approx(10, abs=0.01) and run.z[half] == pytest.approx(
        2.5, abs=0.05
    )


@pytest.mark.parametrize("name", machines.names())
def test_the_machine_is_never_faster_than_programmed(name):
    run = simulated(spiral(), machine=name)
    assert len(run.machine_time_s) == len(run.time_s)
    assert (numpy.diff(run.machine_time_s) > -1e-9).all()
    assert (run.machine_time_s >= run.time_s - 1e-9).all()
    assert run.machine_time_total_s == run.machine_time_s[-1] > run.time_total_s


def test_a_machine_may_be_a_name_a_file_or_a_dictionary(tmp_path):
    slow = {"max_feed_mm_min": 120, "acceleration_mm_s2": 50}
    path = written(tmp_path, json.dumps(slow), "slow.json")
    for machine in (slow, path, str(path)):
        run = simulated(line_at(0), machine=machine)
        # Two lines at 2 mm/s, each from rest to rest or slower.
        assert run.machine_time_total_s == pytest.approx((8 + 80) / 2 + 2 * 2 / 50, rel=1e-6)


# ---- progress ----


def test_progress_grows_up_to_one():
    shares = []
    run = simulated(spiral(), progress=lambda share: shares.append(share) or True)
    assert shares == sorted(shares) and len(shares) > 4 and shares[-1] == 1
    assert 0 < shares[0] < 0.3 and not run.cancelled
    assert same_load(run, simulated(spiral()))


def test_a_cancelled_run_ends_where_it_was_stopped():
    whole = simulated(spiral(), cutting=STAR, machine="linuxcnc_mill")
    stopped = simulated(
        spiral(), cutting=STAR, machine="linuxcnc_mill", progress=lambda share: share < 0.5
    )
    size = len(stopped.x)
    assert stopped.cancelled and not whole.cancelled
    assert 0.2 * len(whole.x) < size < 0.8 * len(whole.x)
    for name in ("x", "engagement_deg", "force_peak", "machine_time_s", "h_mean"):
        assert numpy.array_equal(getattr(stopped, name), getattr(whole, name)[:size]), name
    assert math.isnan(stopped.rest_area) and stopped.rests == []
    assert stopped.figures()["rest_area_mm2"] is None and stopped.figures()["cancelled"]
    assert stopped.removed_volume_total == stopped.removed_volume[-1]
    assert stopped.time_total_s == whole.time_s[size - 1]


def test_what_progress_raises_comes_through():
    with pytest.raises(ZeroDivisionError):
        simulated(spiral(), progress=lambda share: 1 / 0)


# ---- figures ----


@pytest.mark.parametrize(
    "options",
    ({}, {"cutting": STAR, "machine": "hobby_router_grbl", "part": GOUGED}),
    ids=("bare", "full"),
)
@pytest.mark.parametrize("moves", (climb(60), line_at(50), [UP, UP]), ids=("cut", "air", "nothing"))
def test_figures_are_plain_numbers_for_json(moves, options):
    run = simulated(moves, BELOW, **options)
    figures = run.figures()
    assert json.loads(json.dumps(figures, allow_nan=False)) == figures
    assert figures.pop("cancelled") is False
    assert {type(value) for value in figures.values()} <= {float, type(None)}
    other = [run.incidents, run.rests, run.rest_outlines, run.rest_at, run.gouge_at, run.notes]
    other += [run.max_engagement_at, run.removal_rate_peak_at, run.force_peak_max_at]
    json.dumps(other, allow_nan=False)
    empty = moves == [UP, UP]
    forceless = {k for k, v in figures.items() if v is None}
    if "cutting" not in options:
        assert forceless == {
            "h_max_mm",
            "force_peak_max_n",
            "torque_peak_nm",
            "power_mean_max_w",
            "machine_time_s",
            "fixture_mm",
        }
    elif not empty:
        assert forceless == {"fixture_mm"}


def test_figures_are_those_of_the_run():
    figures = simulated(climb(60), BELOW, cutting=STAR, part=GOUGED).figures()
    assert figures["max_engagement_deg"] == pytest.approx(60, abs=0.2)
    assert figures["removal_rate_peak_mm3_min"] == pytest.approx(1147.5, rel=5e-3)
    assert figures["h_max_mm"] == pytest.approx(FEED / SPEED * math.sin(math.pi / 3), rel=0.01)
    assert figures["force_peak_max_n"] == pytest.approx(99, abs=1)
    assert figures["gouge_mm"] == pytest.approx(0.05, abs=1e-6)
    assert figures["cut_mm"] == pytest.approx(80)
    assert figures["removed_volume_mm3"] == pytest.approx(270, rel=1e-3)
    assert figures["time_s"] == pytest.approx(60 * (math.hypot(8, 1.5) / 600 + 80 / FEED))


# ---- one program with one fault of each kind ----

RIB = 1.0  # mm wide, between the rows at y = 20 and y = 27
# Half of what a disc covers of the rib beyond its centre, mm2
COVERED = RIB / 2 * math.sqrt(RADIUS**2 - RIB**2 / 4) + RADIUS**2 * math.asin(
    RIB / 2 / RADIUS
)
GAP = 1.0 + 2 * COVERED  # mm between the ends of the two cuts along the rib: 1 mm2 stays of it


def faulty_program():
    """All of (0, 0, 50, 40) above the wall y < 5 is cleared, but for four faults."""
    text = ["G21 G90 G17", "S6366 M3", "G0 X-10 Y34 Z5", "G0 Z-1", "G0 X60 (the rapid)", "G0 Z5"]
    text += ["G0 X25 Y14", "G1 Z-3 F100 (the plunge)", "G0 Z5"]

    def row(y, *words):
        text.extend(["G0 X-10 Y%g" % y, "G0 Z-3", *words, "G0 Z5"])

    row(8, "G1 X30 F255", "G3 X32 Y8 I1 J9.975 (the gouge)", "G1 X60")
    for y in (12, 16, 20, 27, 31, 35, 39):
        row(y, "G1 X60 F255")
    row(23.5, "G1 X%.6f F255" % (25 - GAP / 2))
    text += ["G0 X60", "G0 Z-3", "G1 X%.6f" % (25 + GAP / 2), "G0 Z5", "M30"]
    return text


def test_one_fault_of_each_kind_is_found_with_its_place(tmp_path):
    text = faulty_program()
    path = written(tmp_path, "\n".join(text))
    wall = (0, 0, 50, 5)
    run = evenload.simulate(path, (0, 0, 50, 40), 0, -3, 6, part=wall, resolution=0.05)
    found = {what: (x, y, z, amount) for what, x, y, z, _, _, amount in run.incidents}
    lines = {what: line for what, *_, line, _ in run.incidents}
    assert len(run.incidents) == 3
    assert lines == {
        "rapid in material": text.index("G0 X60 (the rapid)") + 1,
        "plunge in material": text.index("G1 Z-3 F100 (the plunge)") + 1,
        "gouge": [line.endswith("(the gouge)") for line in text].index(True) + 1,
    }
    assert found["rapid in material"] == pytest.approx((-3, 34, -1, 50 + RADIUS), abs=0.2)
    assert run.rapid_in_material_mm == found["rapid in material"][3]
    assert run.rapid_in_material_at == found["rapid in material"][:3]
    assert found["plunge in material"] == pytest.approx((25, 14, 0, 3), abs=0.1)
    assert run.plunge_in_material_mm == found["plunge in material"][3]
    assert run.plunge_in_material_at == found["plunge in material"][:3]
    assert found["gouge"] == pytest.approx((31, 7.95, -3, 0.05), abs=1e-4)
    assert run.gouge_mm == found["gouge"][3] and run.gouge_at == found["gouge"][:3]
    ((area, x, y, depth),) = run.rests
    assert area == pytest.approx(1, abs=0.01) and run.rest_area == pytest.approx(area)
    assert (x, y, depth) == pytest.approx((25, 23.5, 3), abs=0.5)
    assert run.rest_at == (x, y) and run.rest_depth == depth == 3
    assert run.notes == []
    move = [move for what, _, _, _, move, _, _ in run.incidents if what == "gouge"][0]
    assert set(run.line[run.move == move]) == {lines["gouge"]}
    assert run.gouge[run.move == move].max() == pytest.approx(0.05, abs=1e-3)


def test_the_same_program_without_its_faults_has_none(tmp_path):
    text = [
        line.replace("G3 X32 Y8 I1 J9.975", "G1 X32")
        .replace("G0 X60 (the rapid)", "G1 X60 F900")
        .replace("G1 Z-3 F100 (the plunge)", "")
        .replace("X%.6f" % (25 + GAP / 2), "X-10")
        for line in faulty_program()
    ]
    path = written(tmp_path, "\n".join(text))
    run = evenload.simulate(path, (0, 0, 50, 40), 0, -3, 6, part=(0, 0, 50, 5))
    assert run.incidents == [] and run.rests == [] and run.rest_area == 0
    assert run.gouge_mm < 1e-9 and run.unreachable_area == 0
    assert run.removed_volume_total == pytest.approx(50 * 35 * 3, rel=5e-4)


# ---- bad input ----


def refused(match, source=None, stock=AROUND, top=0, bottom=-DEPTH, tool_diameter=6, **options):
    with pytest.raises(ValueError, match=match) as caught:
        path = climb(60) if source is None else source
        evenload.simulate(path, stock, top, bottom, tool_diameter, **options)
    return caught.value


def with_move(*move):
    return [*line_at(0), move]


@pytest.mark.parametrize(
    "match, source",
    (
        ("^The source is 5: give the path of a G-code file, a Toolpath or a list", 5),
        ("^The source is <evenload._core.Region", core.Region(BOX_CHAIN)),
        ("^The path has no moves", []),
        ("^The path has no moves", [UP]),
        ("^Move 1 must be .kind, x, y, z", [UP, UP[:7]]),
        ("^Move 3 must be .kind, x, y, z", with_move(4, 0, 0, 0, 0, 0, 0, 1)),
        ("^Move 3 must be .kind, x, y, z", with_move(2.5, 0, 0, 0, 0, 0, 0, 1)),
        ("^Move 3 must be .kind, x, y, z", with_move(CUT, "a", 0, 0, 0, 0, 0, 1)),
        ("^Move 0 is no sequence", [None, UP]),
        ("^Move 3 has a number that is not finite", with_move(CUT, math.nan, 0, 0, 0, 0, 0, 1)),
        ("^Move 3 has a number that is not finite", with_move(CUT, 0, 0, math.inf, 0, 0, 0, 1)),
        ("^Move 3 has no feed: give it one in mm/min", with_move(CUT, 0, 0, 0, 0, 0, 0, 0)),
        ("^Move 3 has no feed", with_move(LINK, 0, 0, 0, 0, 0, 0, -5)),
        (
            "^Move 3 is an arc that starts 40.0* mm from its centre and ends 30.0* mm",
            with_move(CUT, 0, 30, -3, math.pi / 2, 0, 0, 100),
        ),
        ("^Move 3 is an arc without radius", with_move(CUT, 40, 0, -3, 1, 40, 0, 100)),
    ),
)
def test_a_bad_path_is_refused_with_its_move(match, source):
    refused(match, source=source)


@pytest.mark.parametrize(
    "match, text",
    (
        ("^The G-code file '.*path.ngc' has no moves", ""),
        ("^The G-code file '.*path.ngc' has no moves", "G21\n(nothing)\nM30\n"),
        ("^The G-code file '.*path.ngc' has no moves", "G0 X0 Y0 Z5\n"),
        ("^Line 2: a feed move has no feed", "G0 X0 Y0 Z5\nG1 X5\n"),
        ("^Line 3: the arc's centre is 3.* mm from its start", "G0 X0 Y0 Z5\nF9\nG2 X9 I3\n"),
        ("^Line 2: X has no number", "G0 X0 Y0 Z5\nG1 XNAN F9\n"),
        ("^Line 2: parameters and expressions", "G0 X0 Y0 Z5\nG1 X#1 F9\n"),
    ),
)
def test_a_bad_file_is_refused_with_its_line(tmp_path, match, text):
    refused(match, source=written(tmp_path, text))
    refused(match, earlier=[(str(tmp_path / "path.ngc"), 6)])


def test_a_file_that_cannot_be_read_is_named(tmp_path):
    refused("'.*gone.ngc' cannot be read: No such file", source=tmp_path / "gone.ngc")
    refused("cannot be read: Is a directory", source=str(tmp_path))


@pytest.mark.parametrize("shape", (None, 5, "box", {}, [], [None], ["ab"], [[(0, 0), (1, "a")]]))
def test_stock_that_is_no_shape_is_refused(shape):
    assert "a box" in str(refused("^The stock (is|has the item) ", stock=shape))


@pytest.mark.parametrize(
    "match, shape",
    (
        ("^The %s is no box: a box is .xmin, ymin, xmax, ymax.", (0, 0, 5)),
        ("^The %s is an empty box", (0, 0, 0, 5)),
        ("^The %s is an empty box", (5, 0, 0, 5)),
        ("^The %s is an empty box", (0, 0, math.nan, 5)),
        ("^The %s has the item ", [(0, 0, 5, 5), "a"]),
        ("^The %s has the item ", [((0, 0, 5, 5), "a")]),
        ("a coordinate that is not a number", [(0, 0, 0), (5, 0, 0), (math.nan, 5, 0)]),
        ("closed curve", [(0, 0, 0), (5, 5, 0)]),
        ("^The %s's top ", ((0, 0, 5, 5), math.nan)),
    ),
)
def test_bad_shapes_are_refused_by_what_they_are_for(match, shape):
    for name in ("stock", "part", "fixtures"):
        word = name.removesuffix("s")
        refused(match % word if "%s" in match else match, **{name: shape})


def test_a_part_outside_of_its_stock_is_refused():
    refused("^The stock does not contain the part: it reaches out by 5.0*", part=(0, 0, 35, 5))
    refused("^The stock does not contain the part", part=((0, 0, 5, 5), 1))
    left = simulated(line_at(0))
    refused("^The stock does not contain the part", stock=left, part=(0, 0, 35, 5))
    simulated(line_at(0), fixtures=((50, 0, 60, 5), 20))


@pytest.mark.parametrize(
    "match, options",
    (
        ("^The tool's diameter must be positive", {"tool_diameter": 0}),
        ("^The tool's diameter must be positive", {"tool_diameter": -6}),
        ("^The tool's diameter must be positive", {"tool_diameter": math.nan}),
        ("^tool_diameter must be a number, not '6'", {"tool_diameter": "6"}),
        ("^The tool must have at least one tooth", {"teeth": 0}),
        ("^teeth must be a whole number, not 1.5", {"teeth": 1.5}),
        ("^The stock's top must lie above its bottom", {"bottom": 0}),
        ("^The stock's top and bottom must be numbers", {"top": math.nan}),
        ("^The stock's top and bottom must be numbers", {"bottom": -math.inf}),
        ("^top must be a number, not None", {"top": None}),
        ("^The resolution must be positive", {"resolution": 0}),
        ("^The resolution must be positive", {"resolution": math.nan}),
        ("coarser resolution", {"resolution": 1e-6}),
        ("^The step must be positive", {"step": 0}),
        ("^The step must be positive", {"step": math.nan}),
        ("^There are 2 lines for 3 moves: give one for each", {"lines": [1, 2]}),
        ("^earlier must be a list of .source, tool diameter", {"earlier": 5}),
        ("^earlier must be a list of .source, tool diameter", {"earlier": [climb(60)]}),
        ("^The tool diameter of an earlier cut must be a number", {"earlier": [(climb(60), None)]}),
        ("^The tool's diameter must be positive", {"earlier": [(climb(60), 0)]}),
        ("^There is no machine 'lathe': choose one of", {"machine": "lathe"}),
        ("has no acceleration_mm_s2", {"machine": {"max_feed_mm_min": 100}}),
    ),
)
def test_bad_options_are_refused_by_their_name(match, options):
    refused(match, **options)


@pytest.mark.parametrize(
    "match, cutting",
    (
        ("^The cutting data are 'Al': give a dictionary", "Al"),
        ("unknown key 'speed': they are material, spindle_speed, helix", {"speed": 9000}),
        ("needs the spindle speed: give 'spindle_speed'", {"material": "Star test piece"}),
        ("^There is no material 'Lead': choose one of", {**STAR, "material": "Lead"}),
        ("has no krc", {**STAR, "material": {"ktc": 100}}),
        ("^The spindle speed must not be negative", {"spindle_speed": -1}),
        ("^The spindle speed must not be negative", {"spindle_speed": math.nan}),
        ("^'spindle_speed' of the cutting data must be a number", {"spindle_speed": "fast"}),
        ("^The rapid feed must be positive", {"rapid_feed": -1}),
        ("helix angle", {**STAR, "helix_angle_deg": 90}),
        ("helix angle", {**STAR, "helix_angle_deg": math.nan}),
    ),
)
def test_bad_cutting_data_are_refused_by_their_key(match, cutting):
    refused(match, cutting=cutting)


def test_lines_are_for_moves_only(tmp_path):
    path = written(tmp_path, "G0 X0 Y0 Z5\nG1 Z-3 F9\n")
    refused("^A G-code file has lines of its own", source=path, lines=[1, 2])
