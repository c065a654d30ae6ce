"""evenload.simulate: the paths, stocks, parts and fixtures that it takes."""

import math
import subprocess
import sys

import evenload
import numpy
import pytest
from simulated_paths import AROUND, BELOW, BOX_CHAIN, CUT, DEPTH, ENTRY, FEED, GOUGED, GOUGED_CHAIN
from simulated_paths import LINK, RADIUS, RAPID, UP
from simulated_paths import climb, core, line_at, middle, same_load, simulated, written

# ---- importing ----


def test_importing_evenload_imports_nothing_compiled():
    code = (
        "import sys; before = set(sys.modules); import evenload; new = set(sys.modules) - before; "
        "print({name for name in new if name.split('.')[0] not in sys.stdlib_module_names})"
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
    text = "T1 M6\nG21 S3000 M3\nG0 X-40 Y1.5 Z5 A2\nG1 Z-3 F600\nS4000\nT2 M6\nG1 X40 F400\n"
    run = simulated(written(tmp_path, text), BELOW, teeth=2)
    assert run.feed_per_tooth[middle(run)] == pytest.approx(400 / 3000 / 2)  # the lowest speed
    assert run.notes == [
        "Line 3: 'A2' is not simulated.",
        "The program has several spindle speeds: the lowest, 3000 rev/min, was taken.",
        "The program changes tools: all of it was simulated with one.",
    ]
    own = simulated(tmp_path / "path.ngc", BELOW, teeth=2, cutting={"spindle_speed": 8000})
    assert own.feed_per_tooth[middle(own)] == pytest.approx(400 / 8000 / 2)


def test_notes_of_a_file_that_was_cut_before_are_taken_too(tmp_path):
    before = [(written(tmp_path, "G0 X-40 Y9 Z5\nG1 Z-3 F600\nX40\n"), 2 * RADIUS)]
    (note,) = simulated(climb(60), BELOW, earlier=before).notes
    assert note.startswith("Earlier cut: Line 1: The program moves before it names its units")


def test_kinds_are_told_from_what_moves_do_in_files_only_unless_asked(tmp_path):
    # Down beside the stock, through it, on faster beside it, and back up.
    path = written(tmp_path, "G0 X-40 Y0 Z5\nG1 Z-3 F600\nX40 F255\nY50 F900\nZ5\nG0 X0\n")
    told = [(1, LINK), (2, CUT), (3, LINK), (4, LINK), (5, RAPID)]
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
