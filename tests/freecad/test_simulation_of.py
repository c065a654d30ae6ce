"""Operations of a job through the simulator itself: what it finds on good and on bad paths."""

import evenload
import pytest
from evenload import host, simulation_pictures
from FreeCAD import Vector
from models import DEPTH, SQUARE, case_model, corpus_case, floors_of, sketch_of
from test_batch import a_job, folder, run  # noqa: F401: folder is a fixture

pytestmark = pytest.mark.core

POCKET = 900 - (4 - 3.14159265) * 9  # mm2 that a tool of 6 mm reaches of a square of 30 mm


def test_our_own_path_is_even_gouges_nothing_and_leaves_nothing(square):
    op = square.done(square.operation(FeedControl="Constant removal rate"))
    found = evenload.simulation.of(op, material="Star test piece", machine="linuxcnc_mill")
    assert found.max_engagement_deg == pytest.approx(60, abs=1.5)
    assert found.max_engagement_deg == pytest.approx(op.MaxEngagement.Value, abs=1)
    assert found.gouge_mm < 0.002 and found.rest_area < 0.1 and found.incidents == []
    assert found.removed_volume_total == pytest.approx(POCKET * DEPTH, rel=1e-3)
    assert found.link_engagement_deg < 2
    assert found.time_total_s == pytest.approx(op.CuttingTime, rel=0.02)
    assert found.machine_time_total_s > found.time_total_s
    assert found.force_peak_max > 50


def test_freecads_adaptive_meets_more_in_corners_and_leaves_a_rest(square):
    ours = evenload.simulation.of(square.done(square.operation()))
    theirs = host.freecads_adaptive("Theirs", square.job, square.controller)
    theirs.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    theirs.UseOutline, theirs.StepOver = False, 25
    square.doc.recompute()
    found = evenload.simulation.of(theirs, after_earlier=False)
    assert found.max_engagement_deg > ours.max_engagement_deg + 5
    assert found.removed_volume_total == pytest.approx(ours.removed_volume_total, rel=0.01)
    # After ours it cuts next to nothing.
    again = evenload.simulation.of(theirs)
    assert again.removed_volume_total < 0.005 * found.removed_volume_total


def test_several_depths_are_each_cut_at_their_own(bench):
    deep = bench(case_model({**corpus_case("square60"), "axial_depth": 9}))
    floors = [(deep.model, tuple(floors_of(deep.model.Shape, -9.0)))]
    op = deep.done(deep.operation(floors, FinalDepth=-9.0, StepDown=3.0))
    found = evenload.simulation.of(op, resolution=0.1)
    # Where a move begins, the tool may graze the micrometre that stays at the walls.
    cuts = (found.kind == 3) & (found.length > 0)
    assert found.axial_depth[cuts].max() == pytest.approx(3, abs=0.01)
    assert found.rest_area < 0.5 and found.gouge_mm < 0.002


def test_a_hole_that_was_drilled_is_no_material(bench):
    star = bench(case_model(corpus_case("star")))
    op = star.operation(Entry="Predrilled hole", EntryPoint=Vector(0, 0, 0), HoleDiameter=11.0)
    found = evenload.simulation.of(star.done(op))
    assert found.plunge_in_material_mm == 0 and found.entry_mm == 0 < found.link_mm
    assert found.removed_volume_total == pytest.approx(2098, rel=2e-3)


def test_a_sketch_on_a_plain_block_says_itself_what_is_cleared(square):
    sketch = sketch_of(square.doc, [(x + 3, y, b) for x, y, b in SQUARE], name="Beside")
    op = square.operation()
    op.Base = [(sketch, "")]
    found = evenload.simulation.of(square.done(op))
    assert found.gouge_mm < 0.002 and found.rest_area < 0.1


def test_what_the_stock_lost_before_can_be_gone_on_with(square):
    op = square.done(square.operation())
    first = evenload.simulation.of(op)
    moves = [(0, 15, 15, 5, 0, 0, 0, 0), (3, 15, 15, -DEPTH, 0, 0, 0, 600)]
    second = evenload.simulate(moves, first, 0, -DEPTH, 6)
    assert second.removed_volume_total == 0 and second.plunge_in_material_mm == 0


def test_fixtures_are_given_to_an_operation_s_simulation(square):
    op = square.done(square.operation())
    found = evenload.simulation.of(op, fixtures=[((14, 14, 16, 16), 20.0)])
    assert found.fixture_mm > 1 and found.incidents[0][0] == "fixture"


def test_its_sheet_is_drawn(square, tmp_path):
    op = square.done(square.operation())
    found = evenload.simulation.of(op, material="Al7075-T6")
    for name in ("sheet.png", "sheet.svg"):
        simulation_pictures.sheet(found, str(tmp_path / name))
        assert (tmp_path / name).stat().st_size > 20000


def test_a_batch_job_reports_what_the_simulator_finds(folder):  # noqa: F811
    job = a_job(folder, simulation={"material": "Al7075-T6", "machine": "hobby_router_grbl"})
    report, _ = run(folder, job)
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    figures = report["jobs"][0]["figures"]
    assert figures["simulated_engagement_deg"] == pytest.approx(
        figures["max_engagement_deg"], abs=1.5
    )
    assert figures["simulated_gouge_mm"] < 0.002 and figures["simulated_rest_area_mm2"] < 0.1
    assert figures["simulated_force_n"] > 0
    assert figures["simulated_machine_time_s"] > figures["simulated_time_s"]


def test_an_operation_of_no_path_is_refused(square):
    op = square.operation()
    with pytest.raises(ValueError, match="has no path to simulate"):
        evenload.simulation.of(op)
