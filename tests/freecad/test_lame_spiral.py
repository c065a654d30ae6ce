"""The Lamé spiral operation: fitted shapes, set values, rest, islands, refusals."""

import math

import Part
import pytest
from conftest import check_path, moves_of, reopened
from FreeCAD import Vector
from models import block_with, case_model, circle, corpus_case, face_of, floors_of, rectangle

from evenload import simulation
from evenload.operations import lame_spiral
from evenload.settings.labels import told

EVEN = "Constant removal rate"
SQUARE35 = rectangle(-17.5, -17.5, 17.5, 17.5)


def polygon(corners, radius, turn=0.0):
    angles = [turn + 2 * math.pi * k / corners for k in range(corners)]
    return [(radius * math.cos(a), radius * math.sin(a), 0) for a in angles]


@pytest.fixture
def pocket(bench):
    return bench(block_with(face_of(SQUARE35)))


def spiral(bench, base=None, **properties):
    return bench.operation(base, kind="lame_spiral", **properties)


@pytest.mark.parametrize(
    "outline, segments",
    [
        (SQUARE35, 4),
        (rectangle(0, 0, 50, 30), 4),
        (polygon(6, 25), 6),
        (polygon(8, 25, 0.3), 8),
        (polygon(3, 35), 3),
        (circle(5, 5, 20), None),
    ],
    ids=["square", "rectangle", "hexagon", "octagon", "triangle", "circle"],
)
def test_the_spiral_is_fitted_and_the_rest_cleared(bench, outline, segments):
    face = face_of(outline)
    b = bench(block_with(face))
    op = b.done(spiral(b, FeedControl=EVEN))
    check_path(op, [face])
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)
    assert op.MaxEngagement.Value < 61
    if segments:
        assert op.Segments == segments
    assert 0.7 < op.ClearedShare <= 1
    assert op.OwnValues == []
    assert op.SemiAxisA.Value > 5 and op.Pitch.Value > 0.2
    centre = face.CenterOfMass
    assert (op.Centre - Vector(centre.x, centre.y, op.Centre.z)).Length < 0.1


def test_a_value_that_is_set_stays_and_the_others_are_fitted_to_it(pocket):
    fitted = pocket.done(spiral(pocket, FeedControl=EVEN))
    a, n = fitted.SemiAxisA.Value, fitted.ExponentEnd
    op = pocket.done(spiral(pocket, FeedControl=EVEN, ExponentEnd=1.0))
    assert op.OwnValues == ["ExponentEnd"]
    assert op.ExponentEnd == 1.0 and n < 0.9
    assert op.ClearedShare < fitted.ClearedShare
    op.Proxy.follow_tool(op, again=op.Proxy.fitted)
    pocket.done(op)
    assert op.ExponentEnd == pytest.approx(n) and op.SemiAxisA.Value == pytest.approx(a)


def test_a_rotated_pocket_is_found_rotated(bench):
    b = bench(block_with(face_of(polygon(4, 25, math.radians(20)))))
    op = b.done(spiral(b))
    assert op.Segments == 4
    turn = (op.Rotation.Value - 20) % 90
    assert min(turn, 90 - turn) == pytest.approx(45, abs=0.5) or min(turn, 90 - turn) < 0.5


def test_the_rest_can_be_left(pocket):
    op = pocket.done(spiral(pocket, Rest="Leave"))
    assert op.UncutArea.Value > 0.1
    assert "left" in op.Report.lower()
    assert op.Links == 0 and op.Retracts == 0


@pytest.mark.parametrize("name", ["boss_open"])
def test_an_island_is_cut_from_outside_in(bench, name):
    case = corpus_case(name)
    b = bench(case_model(case))
    op = b.done(spiral(b, [(b.model, tuple(floors_of(b.model.Shape)))]))
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)
    assert op.MaxEngagement.Value < 61


def test_without_a_spiral_the_fitted_properties_stay_and_the_report_says_so(bench):
    rooms = [(0, 0), (40, 0), (40, 17), (50, 17), (50, 0), (90, 0)]
    rooms += [(90, 40), (50, 40), (50, 23.4), (40, 23.4), (40, 40), (0, 40)]
    b = bench(block_with(face_of([(x, y, 0) for x, y in rooms])))
    op = spiral(b)
    before = [op.Segments, op.SemiAxisA.Value, op.Pitch.Value]
    op.NarrowPassages = "Cut at reduced feed"
    b.done(op)
    assert "No spiral was made" in op.Report
    assert op.ClearedShare == 0
    assert [op.Segments, op.SemiAxisA.Value, op.Pitch.Value] == before


@pytest.mark.parametrize("margin", [1, 5, 30])
def test_a_step_with_stock_beyond_its_open_sides_is_cleared_as_a_pocket(bench, margin):
    step = Part.makeBox(40, 30, 10).cut(Part.makeBox(40, 20, 3, Vector(0, 0, 7)))
    step.translate(Vector(0, 0, -10))
    b = bench(step)
    for side in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos"):
        setattr(b.job.Stock, side, margin)
    op = b.done(spiral(b))
    (floor,) = op.Proxy.last.floors
    assert not any(vertex[3] for vertex in floor.outer)
    run = simulation.of(op)
    # Beside the wall, outside of the floor, a corner stays.
    assert run.gouge_mm == 0 and (run.rest_area == 0 or run.rest_at[0] < 0 or run.rest_at[0] > 40)


def test_a_ring_is_cut_between_both_walls(bench):
    face = face_of(circle(0, 0, 25), [circle(0, 0, 8)])
    b = bench(block_with(face))
    op = b.done(spiral(b))
    check_path(op, [face])
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)


def test_a_shape_that_no_lame_curve_resembles_names_the_adaptive_operation(bench):
    ell = [(0, 0, 0), (80, 0, 0), (80, 12, 0), (12, 12, 0), (12, 80, 0), (0, 80, 0)]
    b = bench(block_with(face_of(ell)))
    assert "adaptive" in b.refused(spiral(b)).lower()


def test_a_centre_outside_is_refused(pocket):
    assert "Centre" in pocket.refused(spiral(pocket, Centre=Vector(200, 0, 0)))


@pytest.mark.parametrize(
    "name, value", [("Segments", 1), ("ExponentEnd", 0.0), ("ExponentStart", 7.0), ("Pitch", 0.0)]
)
def test_values_out_of_range_are_refused_by_name(pocket, name, value):
    assert name in pocket.refused(spiral(pocket, **{name: value}))


COURSES = ("SemiAxisACourse", "SemiAxisBCourse", "ExponentCourse")


@pytest.mark.parametrize("name", COURSES)
def test_a_course_makes_another_path_until_it_is_empty_again(pocket, name):
    op = spiral(pocket, FeedControl=EVEN)
    assert getattr(op, name) == []
    even = pocket.done(op).Path.toGCode()
    setattr(op, name, [0, 0.1, 0.4, 1])
    assert pocket.done(op).Path.toGCode() != even
    assert op.MaxEngagement.Value < 61 and op.OwnValues == []
    assert getattr(op, name) == [0, 0.1, 0.4, 1]  # it is no result
    setattr(op, name, [])
    assert pocket.done(op).Path.toGCode() == even


@pytest.mark.parametrize("name", COURSES)
def test_a_course_that_falls_or_does_not_lead_to_the_end_is_refused_by_name(pocket, name):
    for values in ([0.0, 0.5], [0.0, 0.6, 0.5, 1.0], [1.0]):
        assert pocket.refused(spiral(pocket, **{name: values})).startswith(told(name) + " must be")


def test_courses_survive_saving_and_can_be_undone(pocket, tmp_path):
    doc = pocket.doc
    op = pocket.done(spiral(pocket, ExponentCourse=[0, 0.1, 1]))
    before, name = op.Path.toGCode(), op.Name
    doc.UndoMode = 1
    doc.openTransaction("Course")
    op.ExponentCourse = [0, 0.9, 1]
    op.SemiAxisACourse = [0, 0.2, 1]
    doc.commitTransaction()
    assert pocket.done(op).Path.toGCode() != before
    doc.undo()
    assert op.ExponentCourse == [0, 0.1, 1] and op.SemiAxisACourse == []
    assert pocket.done(op).Path.toGCode() == before
    with reopened(doc, tmp_path / "saved.FCStd") as doc:
        op = doc.getObject(name)
        assert op.ExponentCourse == [0, 0.1, 1] and op.SemiAxisACourse == []
        op.touch()
        doc.recompute()
        assert op.isValid() and op.Path.toGCode() == before


def test_conventional_milling_turns_the_other_way(pocket):
    sweeps = {}
    for mode in ("Climb", "Conventional"):
        op = pocket.done(spiral(pocket, CutMode=mode))
        sweeps[mode] = sum({"G2": -1, "G3": 1}.get(move[0], 0) for move in moves_of(op))
        pocket.doc.removeObject(op.Name)
    assert sweeps["Climb"] * sweeps["Conventional"] < 0


def test_it_survives_saving_and_recomputes_the_same(pocket, tmp_path):
    op = spiral(pocket, Segments=4)
    before = pocket.done(op).Path.toGCode()
    name = op.Name
    with reopened(pocket.doc, tmp_path / "saved.FCStd") as doc:
        op = doc.getObject(name)
        assert type(op.Proxy) is lame_spiral.LameSpiral
        assert op.OwnValues == ["Segments"]
        op.touch()
        doc.recompute()
        assert op.isValid() and op.Path.toGCode() == before


def test_the_posted_program_runs(pocket, rs274, tmp_path):
    from evenload import host

    pocket.done(spiral(pocket))
    text = host.post(pocket.job, "linuxcnc", "--no-show-editor --precision 4")
    assert rs274(text, tmp_path).count("ARC_FEED") > 20
