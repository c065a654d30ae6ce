"""evenload.simulate: the faults of a program that it finds, and what it refuses."""

import math

import evenload
import pytest
from simulated_paths import AROUND, BOX_CHAIN, CUT, DEPTH, LINK, RADIUS, STAR, UP
from simulated_paths import climb, core, line_at, simulated, written

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
