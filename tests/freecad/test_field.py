"""What failed in users' hands: sentences that named another cause, or named it too late; what tool
controllers and programs say, passed over in silence.
"""

import evenload
import Part
import pytest
from evenload import job_simulation, simulation, simulation_pictures
from evenload.settings.labels import LABELS, told
from evenload.words import name_of
from FreeCAD import Vector
from models import (
    block_with,
    face_of,
    floors_of,
    rectangle,
    ring_of_lines,
    with_rectangle,
    zigzag_stroke,
)

pytestmark = pytest.mark.between

KINDS = ["adaptive", "trochoid", "lame_spiral"]


# ---- the first cause first ----


@pytest.fixture
def pocket(bench):
    """A Bench whose block stands on z = 0: what is picked wrongly there has depths of its own."""
    return bench(with_rectangle(60, 40, 20, 40, 25, 6))


def as_picked(bench, base, kind="adaptive", **properties):
    """An operation with the depths that FreeCAD gives it for its base geometry."""
    from importlib import import_module

    module = import_module("evenload.operations." + kind)
    op = module.Create("Operation", parentJob=bench.job, toolController=bench.controller)
    op.Base = base
    bench.set(op, **properties)
    return op


@pytest.mark.parametrize("kind", KINDS)
def test_a_wall_picked_for_a_floor_is_named_as_one(pocket, kind):
    faces = pocket.model.Shape.Faces
    wall = next("Face%d" % n for n, f in enumerate(faces, 1) if f.BoundBox.ZLength > 1)
    sentence = pocket.refused(as_picked(pocket, [(pocket.model, (wall,))], kind))
    assert (
        sentence.startswith(wall + " of ") and "is tilted: pick a face parallel to XY" in sentence
    )


@pytest.mark.parametrize("kind", KINDS)
def test_a_face_that_is_gone_is_named_as_gone(pocket, kind):
    sentence = pocket.refused(as_picked(pocket, [(pocket.model, ("Face99",))], kind))
    assert sentence.startswith("There is no Face99 on ")


@pytest.mark.parametrize(
    "properties",
    [
        {"SafeHeight": -100.0},
        {"StartDepth": -50.0},
        {"EngagementAngle": 200.0},
        {"StockToLeaveAxial": 90.0},
        {"Entry": "Predrilled hole"},
    ],
    ids=lambda properties: "".join(properties),
)
def test_geometry_that_is_gone_comes_before_settings_that_are_wrong(pocket, properties):
    op = as_picked(pocket, [(pocket.model, ("Face99",))], **properties)
    assert pocket.refused(op).startswith("There is no Face99 on ")


def test_no_geometry_at_all_comes_before_settings_that_are_wrong(pocket):
    op = as_picked(pocket, [], SafeHeight=-100.0)
    assert "no base geometry" in pocket.refused(op)


# ---- reasons, and at most three names ----


def test_of_many_edges_their_number_is_named_and_the_reason_is_near(bench):
    b = bench(Part.makeBox(60, 60, 10, Vector(0, 0, -10)), tool=3.0)
    outline = b.doc.addObject("Part::Feature", "Outline")
    outline.Shape = ring_of_lines(200, gap=0.2)
    edges = tuple("Edge%d" % n for n in range(1, 201))
    sentence = b.refused(b.operation(base=[(outline, edges)], FinalDepth=-2, StepDown=2))
    assert sentence.startswith("200 edges of Outline: The outline is open at ")
    assert len(sentence) < 150


@pytest.mark.parametrize(
    "parts, name",
    [
        ([("Part", "Face3")], "Face3 of Part"),
        ([("Part", "Face%d" % n) for n in (3, 5, 9)], "Face3, Face5, Face9 of Part"),
        (
            [("Part", "Face%d" % n) for n in range(3, 10)],
            "Face3, Face4, Face5 and 4 more of Part",
        ),
        ([("Part", "Edge1"), ("Part", "Edge2")], "Edge1, Edge2 of Part"),
        ([("Part", "Edge%d" % n) for n in range(9)], "9 edges of Part"),
        ([("Sketch", "")], "Sketch"),
        ([("A", "Face1"), ("B", "")], "Face1 of A and B"),
        ([("Sketch%d" % n, "") for n in range(12)], "Sketch0 and Sketch1 and Sketch2 and 9 others"),
        ([("Plate 10 mm", "Face7")], "Face7 of 'Plate 10 mm'"),
        ([("Body (1, 2)", ""), ("Plate 10", "")], "'Body (1, 2)' and Plate 10"),
        ([("x" * 300, "Face1")], "Face1 of %s\u2026" % ("x" * 39)),
    ],
)
def test_names_are_short(parts, name):
    assert name_of(parts) == name


def test_many_floors_beside_the_final_depth_make_one_note(bench):
    faces = [face_of(rectangle(15 * k, 0, 15 * k + 10, 10)) for k in range(8)]
    b = bench(block_with(*faces))
    op = b.done(b.operation(FinalDepth=-2.0, StepDown=2.0))
    lines = [line for line in op.Report.splitlines() if line.startswith("Final Depth lies")]
    assert len(lines) == 1 and " and 5 more of " in lines[0] and len(lines[0]) < 120


# ---- in the words of the panel ----


def test_every_setting_has_the_label_of_its_panel():
    from importlib import import_module

    for kind in KINDS:
        module = import_module("evenload.operations." + kind)
        (proxy,) = [
            value
            for value in vars(module).values()
            if isinstance(value, type) and value.__module__ == module.__name__
        ]
        assert {setting.name for setting in proxy.settings} <= set(LABELS)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("EngagementAngle is 0", "Engagement angle is 0"),
        ("StockToLeaveAxial is 9 mm", "Stock at the floor (StockToLeaveAxial) is 9 mm"),
        ("StockToLeave is -1 mm", "Stock to leave is -1 mm"),
        ("Centre, Pitch and Entry", "Centre, Pitch and Entry"),
        ("Arcs are lines", "Arcs are lines"),
        ("raise StartDepth", "raise Start Depth"),
        ("SideStepper", "SideStepper"),
    ],
)
def test_a_sentence_has_the_labels_of_what_it_names(text, expected):
    assert told(text) == expected


def test_a_sentence_of_the_core_has_the_labels_too(square):
    op = square.operation(kind="lame_spiral")
    square.set(op, Segments=3, SemiAxisA=8.0, SemiAxisB=9.0)
    assert square.refused(op).startswith("Semi-axes of two lengths need Segments 4")
    square.set(op, Segments=4, ExponentStart=7.0)
    assert square.refused(op).startswith("First exponent (ExponentStart) and Last exponent (")


def test_a_refusal_is_one_line_in_the_report_view(square, capfd):
    op = square.done(square.operation())
    op.EngagementAngle = 200
    capfd.readouterr()
    sentence = square.refused(op)
    told_so = [line for line in capfd.readouterr().err.splitlines() if line.strip()]
    assert told_so[0].endswith(": " + sentence) and "Traceback" not in "".join(told_so)
    assert len(told_so) <= 2  # FreeCAD adds that a recompute failed


def test_a_fault_of_our_own_keeps_its_traceback(square, capfd, monkeypatch):
    op = square.done(square.operation())
    monkeypatch.setattr(type(op.Proxy), "generate", lambda *arguments: {}["missing"])
    op.touch()
    square.doc.recompute()
    assert "Traceback" in capfd.readouterr().err


# ---- programs ----


@pytest.mark.parametrize("units", ["", "G20 ", "G21 "])
def test_a_program_that_does_not_name_its_units_gives_a_note(tmp_path, units):
    path = tmp_path / "path.ngc"
    path.write_text(units + "G90 G17\nM3 S8000\nG0 X.5 Y.5 Z.2\nG1 Z-.1 F5\nX1.5 F20\nG0 Z.2\n")
    run = evenload.simulate(str(path), (0, 0, 60, 40), 0, -5, tool_diameter=6.35)
    told_so = [note for note in run.notes if "units" in note and "G21" in note]
    assert len(told_so) == (not units)
    assert not told_so or told_so[0].startswith("Line 3: ")


@pytest.mark.parametrize(
    "stock, part",
    [
        ((0, 0, 60, 40), [((0, 0, 60, 40), -2)]),
        ([((0, 0, 60, 40), 0)], ((0, 0, 60, 40), -2)),
        ([(0, 0), (60, 0), (60, 40), (0, 40)], [(0, 0, 60, 10)]),
        ([(0, 0, 30, 40), (30, 0, 60, 40)], None),
    ],
)
def test_the_sheet_takes_stock_and_part_in_the_words_of_the_simulator(tmp_path, stock, part):
    path = tmp_path / "path.ngc"
    path.write_text("G21 G90\nG0 X-5 Y20 Z5\nG0 Z-2\nG1 X65 F400\nG0 Z5\n")
    run = evenload.simulate(str(path), stock, 0, -5, tool_diameter=6, part=part)
    simulation_pictures.sheet(run, str(tmp_path / "sheet.png"), stock, part)
    simulation_pictures.rest(run, str(tmp_path / "rest.png"), run, run.part)
    assert (tmp_path / "sheet.png").stat().st_size > 5000
    assert (tmp_path / "rest.png").stat().st_size > 5000
    with pytest.raises(ValueError, match="The stock is 7: give a Region"):
        simulation_pictures.sheet(run, None, 7, part)


# ---- small tools ----


def test_a_small_tool_is_simulated_as_finely_as_it_needs(bench):
    b = bench(zigzag_stroke(0.6), tool=0.5)
    floor = [(b.model, tuple(floors_of(b.model.Shape, -1.0)))]
    setup = job_simulation.read(b.done(b.operation(floor, FinalDepth=-1.0, StepDown=1.0)))
    default, fine = setup.simulate(), setup.simulate(resolution=0.01)
    assert abs(default.max_engagement_deg - fine.max_engagement_deg) < 1
    assert default.air_mm == pytest.approx(fine.air_mm, abs=3)
    assert setup.simulate(resolution=0.05).max_engagement_deg > fine.max_engagement_deg + 3


def test_usual_tools_keep_their_resolution():
    found = [simulation.default_resolution(d) for d in (20, 6, 2.5, 1, 0.5, 0.1)]
    assert found == pytest.approx([0.05, 0.05, 0.05, 0.02, 0.01, 0.005])


# ---- the spindle's direction ----


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("mode", ["Climb", "Conventional"])
def test_a_spindle_that_turns_the_other_way_takes_the_path_the_other_way(square, kind, mode):
    op = square.done(square.operation(kind=kind, CutMode=mode))
    forward, quiet = ways(op), "spindle" not in op.Report.lower()
    op.CutMode = "Conventional" if mode == "Climb" else "Climb"
    opposite = ways(square.done(op))
    square.controller.SpindleDir, op.CutMode = "Reverse", mode
    assert ways(square.done(op)) == opposite != forward and quiet
    assert "counter-clockwise, as its Spindle (SpindleDir) says" in op.Report
    assert "so that it cuts as %s." % mode.lower() in op.Report
    assert any("counter-clockwise" in note for note in job_simulation.read(op).notes)


def ways(op):
    return [command.toGCode() for command in op.Path.Commands[1:]]


def test_a_spindle_that_does_not_turn_is_noted(square):
    square.controller.SpindleDir = "None"
    assert "does not turn: set its Spindle (SpindleDir)" in square.done(square.operation()).Report
