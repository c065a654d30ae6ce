"""The stability of operations in their job: what is read of them, reports, job files."""

import json
import math

import numpy
import pytest
from conftest import reopened
from evenload import batch, host, job_stability, materials
from evenload.dynamics import Milling, directions, vibration
from evenload.job_files import report
from models import DEPTH, case_model, corpus_case, floors_of

pytestmark = pytest.mark.between

# Weak in X, as a long tool in a slender spindle nose.
MODES = [
    {"stiffness_n_per_um": 1.0, "frequency_hz": 700, "damping_ratio": 0.02},
    {"stiffness_n_per_um": 2.0, "frequency_hz": 1000, "damping_ratio": 0.02, "direction_deg": 90},
]
STIFF = [{**row, "stiffness_n_per_um": 100.0} for row in MODES]


def test_the_star_s_worst_direction_is_that_of_all_directions(bench):
    star = bench(case_model(corpus_case("star")))
    op = star.done(star.operation(Entry="Predrilled hole", HoleDiameter=11))
    cut = job_stability.read(op, MODES)
    assert cut.directions.tolist() == directions.ALL.tolist()
    verdict = job_stability.of(op, MODES)
    row = materials.load(op.Material)
    milling = Milling(
        vibration.load(MODES).modes,
        1,
        row["ktc"],
        row["krc"],
        cut_mode="climb",
        engagement_angle=60,
        diameter=6,
        helix_angle=30,
    )
    radii = [
        milling.changed(feed_direction=float(d)).spectral_radius(6366, DEPTH) for d in range(180)
    ]
    assert verdict.spectral_radius == pytest.approx(max(radii), rel=1e-9)
    assert verdict.feed_direction == numpy.argmax(radii)


def test_what_is_read_of_an_operation(square):
    square.controller.Tool.Flutes = 3
    op = square.done(square.operation(EngagementAngle=45, CutMode="Conventional", StepDown=2.0))
    cut = job_stability.read(op, MODES, process_damping=1e5)
    assert (cut.teeth, cut.diameter, cut.helix_angle) == (3, 6, 30)
    assert cut.engagement_deg == pytest.approx(45) and cut.cut_mode == "conventional"
    assert cut.depth == pytest.approx(2.0) and cut.speed == 6366
    assert cut.feed_per_tooth == pytest.approx(255 / 6366 / 3, rel=1e-3)
    assert cut.process_damping == 1e5 and cut.milling().process_damping == 1e5
    assert cut.material["name"] == op.Material
    assert cut.flute_length == op.ToolController.Tool.CuttingEdgeHeight.Value


def test_an_operation_of_freecad_is_judged_by_what_the_simulator_finds(square):
    op = host.freecads("PocketShape", "Pocket", square.job, square.controller)
    op.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    square.set(op, StartDepth=0.0, FinalDepth=-DEPTH, StepDown=DEPTH)
    square.doc.recompute()
    cut = job_stability.read(op, MODES, material="Al7075-T6")
    assert cut.engagement_deg > 100  # it cuts at full width somewhere
    assert {0.0, 90.0} <= set(cut.directions)
    assert not job_stability.of(op, MODES, "Al7075-T6").is_stable
    assert job_stability.of(op, STIFF, "Al7075-T6", engagement_deg=20).is_stable


def test_modes_are_kept_with_the_tool_controller(square, tmp_path):
    op = square.done(square.operation())
    with pytest.raises(ValueError, match="has no modes"):
        job_stability.of(op)
    job_stability.keep(op.ToolController, vibration.load({"name": "mine", "modes": MODES}))
    first, op_name = job_stability.of(op), op.Name
    with reopened(square.doc, tmp_path / "kept.FCStd") as doc:
        again = next(o for o in doc.Objects if o.Name == op_name)
        assert job_stability.kept(again.ToolController).name == "mine"
        assert job_stability.of(again).spectral_radius == pytest.approx(first.spectral_radius)
        job_stability.keep(again.ToolController, None)
        assert job_stability.kept(again.ToolController) is None


def test_the_report_warns_of_an_unstable_operation(square):
    op = square.done(square.operation())
    assert "unstable" not in op.Report
    job_stability.keep(op.ToolController, vibration.load(MODES))
    square.done(op)
    verdict = job_stability.of(op)
    assert not verdict.is_stable and op.Report.startswith(verdict.sentence)
    job_stability.keep(op.ToolController, vibration.load(STIFF))
    square.done(op)
    assert "stable" not in op.Report


def test_modes_that_cannot_be_read_are_told_and_hinder_nothing(square):
    op = square.operation()
    job_stability.keep(op.ToolController, vibration.load(MODES))
    setattr(op.ToolController, job_stability.PROPERTY, '{"modes": []}')
    square.done(op)
    assert "not known" in op.Report and "has no mode" in op.Report


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"engagement_deg": 0.0}, "must lie above 0"),
        ({"engagement_deg": 181.0}, "at most at 180"),
        ({"material": "Cheese"}, "no material 'Cheese'"),
        ({"machine": "lathe"}, "no machine 'lathe'"),
        ({"modes": [{**MODES[0], "damping_ratio": -1}]}, "damping"),
        ({"modes": "nowhere.json"}, "cannot be read"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(square, options, sentence):
    op = square.done(square.operation())
    with pytest.raises(ValueError, match=sentence):
        job_stability.of(op, **{"modes": MODES, **options})


def test_an_operation_without_a_path_is_refused(square):
    with pytest.raises(ValueError, match="no path: recompute it first"):
        job_stability.of(square.operation(), MODES)


# ---- a cut is taken ----


def test_a_cut_goes_into_controller_and_operation_as_one_step(square):
    square.doc.UndoMode = 1
    op = square.done(square.operation())
    controller = op.ToolController
    feeds = controller.HorizFeed.Value, controller.VertFeed.Value
    job_stability.take(op, speed=2 * 6366, depth=1.25, cut_mode="conventional", engagement_deg=50)
    assert controller.SpindleSpeed == pytest.approx(2 * 6366)
    after = controller.HorizFeed.Value, controller.VertFeed.Value
    assert after == pytest.approx([2 * feed for feed in feeds])
    assert (op.StepDown.Value, op.CutMode) == (1.25, "Conventional")
    assert op.EngagementAngle.Value == pytest.approx(50) and op.isValid()
    assert job_stability.read(op, MODES).depth == pytest.approx(1.25)
    square.doc.undo()
    assert controller.SpindleSpeed == 6366
    assert (controller.HorizFeed.Value, controller.VertFeed.Value) == feeds
    assert (op.StepDown.Value, op.CutMode) == (DEPTH, "Climb")


def test_an_angle_is_taken_where_an_expression_has_set_the_side_step(square):
    op = square.operation()
    op.setExpression("SideStep", "OpToolDiameter * 0.3")
    square.done(op)
    job_stability.take(op, engagement_deg=50)
    assert op.EngagementAngle.Value == pytest.approx(50)
    assert op.SideStep.Value == pytest.approx(3 * (1 - math.cos(math.radians(50))))
    assert "SideStep" not in dict(op.ExpressionEngine)


def test_what_is_not_named_stays(square):
    op = square.done(square.operation(StepDown=2.0))
    job_stability.take(op, depth=1.5)
    assert (op.StepDown.Value, op.CutMode) == (1.5, "Climb")
    assert op.ToolController.SpindleSpeed == 6366
    job_stability.take(op, speed=7000)
    assert op.StepDown.Value == 1.5


def test_a_step_down_under_an_expression_is_set_all_the_same(square):
    op = square.done(square.operation())
    op.setExpression("StepDown", "2 mm")
    job_stability.take(op, depth=1.0)
    assert op.StepDown.Value == 1.0


def test_no_step_is_deeper_than_the_pocket(square):
    op = square.done(square.operation(StepDown=1.0))
    job_stability.take(op, depth=50.0)
    assert op.StepDown.Value == DEPTH


@pytest.mark.parametrize("numbers", [{"speed": 0}, {"depth": -1.0}])
def test_speeds_and_depths_that_cannot_be_change_nothing(square, numbers):
    op = square.done(square.operation())
    with pytest.raises(ValueError, match="must be above 0"):
        job_stability.take(op, **{"cut_mode": "conventional", **numbers})
    assert (op.CutMode, op.ToolController.SpindleSpeed) == ("Climb", 6366)


# ---- job files ----


def run(tmp_path, stability):
    case_model(corpus_case("star")).exportBrep(str(tmp_path / "star.brep"))
    (floor,) = floors_of(case_model(corpus_case("star")))
    job = {
        "name": "star",
        "model": "star.brep",
        "base": [floor],
        "tool": {"diameter": 6, "flutes": 2},
        "cutting": {"feed": 255, "spindle_speed": 6366},
        "operation": {
            "type": "adaptive",
            "parameters": {"StartDepth": 0, "FinalDepth": -DEPTH, "StepDown": DEPTH},
        },
        "stability": stability,
        "output": {"gcode": "star.ngc"},
    }
    path = tmp_path / "jobs.json"
    path.write_text(json.dumps({"jobs": [job], "report": "report.json"}))
    said = []
    result = batch.run_file(str(path), said.append)
    assert json.loads((tmp_path / "report.json").read_text()) == result
    return result["jobs"][0], result


def test_a_job_file_warns_of_an_unstable_operation(tmp_path):
    (tmp_path / "spindle.json").write_text(json.dumps({"modes": MODES}))
    job, result = run(
        tmp_path,
        {
            "modes": "spindle.json",
            "material": "Al7075-T6",
            "machine": "linuxcnc_mill",
            "picture": "chart.png",
        },
    )
    assert job["ok"], job["error"]
    figures = job["figures"]
    assert not figures["stable"] and figures["stability_spectral_radius"] > 1
    assert figures["stability_limit_depth_mm"] < DEPTH
    assert figures["stability"].startswith("The cut is unstable")
    assert (tmp_path / "chart.png").stat().st_size > 10000
    assert job["output"]["stability_picture"].endswith("chart.png")
    table = report.table(result["jobs"])
    assert "star: The cut is unstable" in table and "depth at the limit" in table


def test_a_job_file_tells_of_a_stable_operation(tmp_path):
    job, _ = run(tmp_path, {"modes": STIFF, "material": "Al7075-T6"})
    assert job["ok"] and job["figures"]["stable"]
    assert all(math.isfinite(v) for v in job["figures"].values() if isinstance(v, float))
    assert "stability_stable_speed_rev_min" not in job["figures"]


def test_a_job_file_takes_the_modes_of_its_machine(tmp_path):
    mill = {"max_feed_mm_min": 6000, "acceleration_mm_s2": 800, "modes": STIFF}
    job, _ = run(tmp_path, {"machine": mill})
    assert job["ok"] and job["figures"]["stable"]


@pytest.mark.parametrize(
    "stability, sentence",
    [
        ({}, "has no modes"),
        ({"modes": 7}, "'modes' must be a file, a list or an object"),
        ({"modes": MODES, "immersion": 0.5}, "unknown key 'immersion'"),
        ({"modes": MODES, "process_damping": -1}, "0 or more"),
        ({"modes": MODES, "picture": "star.ngc"}, "would overwrite"),
        ({"modes": []}, "has no mode"),
    ],
)
def test_a_section_that_cannot_be_fails_its_job(tmp_path, stability, sentence):
    job, _ = run(tmp_path, stability)
    assert not job["ok"] and sentence in job["error"]
