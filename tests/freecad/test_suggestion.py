"""Suggested feeds and speeds without a window: what is read from an operation, what is found, what
is kept with the tool, and what is taken into operation and tool controller.
"""

import math

import pytest
from evenload.stability import taking
from evenload.suggestion import cut as cuts
from evenload.suggestion import kept, search
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, case_model, corpus_case, face_of, floors_of, rectangle

FAST = {"angles": (60.0,), "levels": 2}


@pytest.fixture
def op(square):
    return square.done(square.operation(LinkFeed="1500 mm/min"))


def asked_of(op, **changes):
    limits = kept.of(op.ToolController, cuts.read(op))
    return search.Asked(**{**limits, "material": "Al7075-T6", "machine": None, **FAST, **changes})


def state(op):
    controller = op.ToolController
    return {
        "angle": op.EngagementAngle.Value,
        "step": op.StepDown.Value,
        "speed": controller.SpindleSpeed,
        "feed": 60 * controller.HorizFeed.Value,
        "plunge": 60 * controller.VertFeed.Value,
        "most": 60 * op.MaximumFeed.Value,
        "bound": sorted(path for path, _ in op.ExpressionEngine),
    }


def test_an_operation_is_read_as_it_is_set(square, op):
    square.set(op, EngagementAngle=50, StepDown=0.4 * DEPTH, HoleDiameter=8, CutMode="Conventional")
    op.EntryPoint = (2, 3, 0)
    square.controller.VertFeed = "102 mm/min"
    found = cuts.read(op)
    assert (found.engagement_deg, found.spindle_speed) == (pytest.approx(50), 6366)
    assert (found.depth, found.levels) == (pytest.approx(DEPTH), 3)
    assert found.step_down == pytest.approx(0.4 * DEPTH)
    assert found.feed == pytest.approx(255) and found.hole == (2, 3, 8)
    assert found.surface_speed == pytest.approx(120, rel=1e-3)
    assert found.options == {
        "cut_mode": "conventional",
        "feed_control": "constant feed",
        "maximum_feed": pytest.approx(2),
        "entry_feed": pytest.approx(0.4),
        "link_feed": pytest.approx(1500),
        "roll_radius": pytest.approx(0.15),
    }
    assert found.notes == [] and found.modes is None


def test_reading_touches_nothing_and_needs_no_computed_path(square):
    op = square.operation()
    op.Document.recompute()
    op.Proxy.last = None  # as in a document that was opened
    before = [(each.Name, tuple(each.State)) for each in op.Document.Objects]
    assert sum(region.area for region in cuts.read(op).regions) == pytest.approx(900)
    assert [(each.Name, tuple(each.State)) for each in op.Document.Objects] == before


def test_what_is_set_now_has_the_times_of_its_path(op):
    found = search.now(cuts.read(op), asked_of(op))
    assert found.time_s == pytest.approx(op.CuttingTime, rel=0.02)
    assert (found.feed, found.spindle_speed) == (pytest.approx(255), 6366)
    assert found.force_peak_n > 0 and found.power_w > 0 and found.h_max_mm > 0
    assert found.bound_by == ""


def test_what_is_set_now_is_told_even_beyond_the_limits(op):
    machine = {"max_feed_mm_min": 200, "acceleration_mm_s2": 500, "spindle_speed_rev_min": 3000}
    beyond = {"most_speed": 20.0, "least_speed": 10.0, "cutting_length": 0.5 * DEPTH}
    found = search.now(cuts.read(op), asked_of(op, machine=machine, **beyond))
    assert found.feed == pytest.approx(255) and found.axial_depth == pytest.approx(DEPTH)
    assert found.machine_time_s > found.time_s and found.spindle_speed == 6366


def test_uneven_levels_are_judged_by_the_deepest(square, op):
    square.set(op, StepDown=0.7 * DEPTH)
    uneven = search.now(cuts.read(op), asked_of(op))
    assert (uneven.levels, uneven.axial_depth) == (2, pytest.approx(0.7 * DEPTH))


def test_without_a_spindle_speed_there_is_a_suggestion_but_nothing_beside_it(square, op):
    square.controller.SpindleSpeed = 0
    found = cuts.read(op)
    assert search.now(found, asked_of(op)) is None
    assert kept.suggested(found)["least_speed"] == 100
    best = search.suggested(found, asked_of(op)).best
    assert 100 <= best.surface_speed <= 200


# ---- the tool ----


def test_what_freecad_does_not_tell_is_suggested(square, op):
    bit = square.controller.Tool
    bit.CuttingEdgeHeight = 17
    assert kept.suggested(cuts.read(op)) == {
        "max_chip_thickness": pytest.approx(0.036),
        "least_speed": pytest.approx(90, rel=1e-3),
        "most_speed": pytest.approx(120, rel=1e-3),
        "cutting_length": 17,
        "teeth": 1,
    }
    bit.Chipload, bit.Flutes, bit.CuttingEdgeHeight = 0.05, 3, 0
    told = kept.suggested(cuts.read(op))
    assert (told["max_chip_thickness"], told["teeth"]) == (pytest.approx(0.05), 3)
    assert told["cutting_length"] == 12


def test_what_the_user_changes_is_kept_with_the_tool(square, op):
    controller, found = square.controller, cuts.read(op)
    limits = kept.of(controller, found)
    kept.keep(controller, found, limits)
    assert not hasattr(controller, kept.PROPERTY), "what is suggested is not kept"
    kept.keep(controller, found, {**limits, "most_speed": 180.0, "teeth": 2})
    assert kept.of(controller, found) == {**limits, "most_speed": 180.0, "teeth": 2}
    # What was not changed follows the tool.
    square.controller.Tool.CuttingEdgeHeight = 9
    again = cuts.read(op)
    assert kept.of(controller, again)["cutting_length"] == 9
    kept.keep(controller, again, {**kept.of(controller, again), "teeth": 3})
    assert kept.of(controller, again)["most_speed"] == 180 and "3" in controller.CuttingLimits


def test_keeping_limits_puts_no_operation_out_of_date(square, op):
    found = cuts.read(op)
    for teeth in (2, 3):
        kept.keep(square.controller, found, {**kept.suggested(found), "teeth": teeth})
        assert not any("Touched" in each.State for each in (op, square.controller))


def test_speeds_that_were_suggested_by_what_was_set_can_be_kept(square, op):
    controller, found = square.controller, cuts.read(op)
    limits = kept.suggested(found)
    kept.keep(controller, found, limits, always=kept.SPEEDS)
    controller.SpindleSpeed = 3000
    assert kept.of(controller, cuts.read(op)) == limits


@pytest.mark.parametrize("text", ["{", "[]", '{"teeth": "2"}', '{"teeth": 0}', '{"flutes": 2}'])
def test_what_cannot_be_read_of_a_tool_is_told(square, op, text):
    found = cuts.read(op)
    kept.keep(square.controller, found, {**kept.suggested(found), "teeth": 2})
    square.controller.CuttingLimits = text
    with pytest.raises(ValueError, match="CuttingLimits of the tool controller .* empty it"):
        kept.of(square.controller, found)


# ---- what is found ----


def test_a_suggestion_keeps_the_limits_at_whole_speeds_and_feeds(op):
    found = search.suggested(
        cuts.read(op), asked_of(op, most_speed=150.0, max_force=120, angles=(45.0, 70.0))
    )
    assert {c.engagement_deg for c in found.candidates} == {45, 70}
    assert {c.levels for c in found.candidates} == {1, 2}
    best = found.best
    assert best.force_peak_n <= 120 and best.h_max_mm <= 0.036 * (1 + 1e-9)
    assert best.spindle_speed == round(best.spindle_speed) and best.surface_speed <= 150
    assert search.feed_of(best) == math.floor(best.feed)


def test_angle_and_step_down_can_stay(square, op):
    square.set(op, EngagementAngle=52, StepDown=0.7 * DEPTH)
    found = search.suggested(cuts.read(op), asked_of(op, keeps_angle=True, keeps_depth=True))
    for candidate in found.candidates:
        assert candidate.engagement_deg == pytest.approx(52)
        assert candidate.axial_depth == pytest.approx(0.7 * DEPTH)
    assert len({c.spindle_speed for c in found.candidates}) == 5


def test_limits_that_refuse_all_are_told(op):
    found = search.suggested(cuts.read(op), asked_of(op, max_force=1))
    assert found.best is None and "the force refuses most" in found.why


def test_speeds_that_tool_and_machine_have_not_in_common_are_told(op):
    machine = {"max_feed_mm_min": 2000, "acceleration_mm_s2": 500, "spindle_speed_rev_min": 3000}
    found = search.suggested(cuts.read(op), asked_of(op, machine=machine))
    assert found.best is None and "the spindle speed refuses most" in found.why


def test_floors_at_several_depths_and_tools_without_a_diameter_are_refused(bench, doc):
    deeper = face_of(rectangle(50, 0, 70, 20)).extrude(Vector(0, 0, -2 * DEPTH))
    shape = block_with(face_of(SQUARE), face_of(rectangle(50, 0, 70, 20))).cut(deeper)
    several = bench(shape)
    floors = (*floors_of(shape), *floors_of(shape, -2 * DEPTH))
    op = several.operation([(several.model, floors)])
    op.setExpression("FinalDepth", "OpFinalDepth")
    doc.recompute()
    with pytest.raises(ValueError, match="lie at several depths"):
        cuts.read(op)
    several.controller.Tool.Diameter = 0
    with pytest.raises(ValueError, match="diameter of the tool .* is 0 mm: set it"):
        cuts.read(op)


def test_it_says_what_does_not_enter_the_figures(square):
    square.done(square.operation())
    op = square.operation(StockToLeave=0.3, UseRestMachining=True)
    notes = cuts.read(op).notes
    assert notes == [
        "All figures are of whole floors, as if nothing had been cut before.",
        "All figures are without the stock to leave at the walls.",
    ]


def test_of_a_trochoid_and_of_a_constant_force_it_says_what_the_figures_are(bench):
    slot = bench(case_model(corpus_case("slot62")))
    op = slot.operation(kind="trochoid", FeedControl="Constant force")
    found = cuts.read(op)
    assert "those of EvenLoad Adaptive" in found.notes[0]
    assert "a constant force does not scale" in found.notes[1]
    assert found.options["feed_control"] == "constant feed"


# ---- what is taken ----


def test_taking_is_one_step_to_undo_and_keeps_the_shares_of_feeds(square, op):
    doc = op.Document
    doc.UndoMode = 1
    square.controller.VertFeed = "102 mm/min"
    op.MaximumFeed = "306 mm/min"
    doc.recompute()
    before, undone = state(op), doc.UndoCount
    numbers = {"speed": 7000, "depth": 0.5 * DEPTH, "engagement_deg": 47, "feed": 510}
    taking.take(op, **numbers, step="Optimise")
    after = state(op)
    assert op.isValid(), op.Report
    assert after == {
        "angle": pytest.approx(47),
        "step": pytest.approx(0.5 * DEPTH),
        "speed": 7000,
        "feed": pytest.approx(510),
        "plunge": pytest.approx(204),
        "most": pytest.approx(612),
        "bound": [name for name in before["bound"] if name != "StepDown"],
    }
    assert doc.UndoCount == undone + 1 and doc.UndoNames[0] == "Optimise"
    doc.undo()
    assert state(op) == before
    doc.redo()
    assert state(op) == after


def test_what_is_taken_is_what_was_told(op):
    best = search.suggested(cuts.read(op), asked_of(op, most_speed=150.0)).best
    taking.take(
        op,
        speed=best.spindle_speed,
        depth=best.axial_depth,
        engagement_deg=best.engagement_deg,
        feed=best.feed,
    )
    assert op.isValid(), op.Report
    now = search.now(cuts.read(op), asked_of(op))
    assert (now.levels, now.spindle_speed) == (best.levels, best.spindle_speed)
    for name in ("time_s", "force_peak_n", "power_w", "h_max_mm"):
        assert getattr(now, name) == pytest.approx(getattr(best, name), rel=0.01), name
    assert now.time_s == pytest.approx(op.CuttingTime, rel=0.02)


def test_an_operation_without_a_controller_takes_a_depth(square, op):
    op.ToolController = None
    taking.take(op, depth=0.5 * DEPTH)
    assert op.StepDown.Value == pytest.approx(0.5 * DEPTH)


def test_a_feed_that_cannot_be_is_refused_and_changes_nothing(op):
    before = state(op)
    with pytest.raises(ValueError, match="The feed must be above 0, not 0."):
        taking.take(op, speed=7000, feed=0)
    assert state(op) == before
