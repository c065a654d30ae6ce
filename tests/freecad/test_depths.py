"""Floors at several heights in one operation: each is cut to its own depth."""

import json
import re

import Part
import pytest
from conftest import moves_of
from evenload import batch, simulation
from FreeCAD import Vector
from models import BLOCK, face_of, floors_of, rectangle, sketch_of
from occt_judge import collisions, gouges
from occt_judge import moves_of as solid_moves

pytestmark = pytest.mark.between

TOOL = 6.0


def plate(*pockets, width=80, length=40):
    """A plate with its top at z = 0 and rectangular pockets (x0, y0, x1, y1, depth) in it."""
    solid = Part.makeBox(width + 20, length + 20, BLOCK, Vector(-10, -10, -BLOCK))
    for *corners, depth in pockets:
        solid = solid.cut(face_of(rectangle(*corners)).extrude(Vector(0, 0, -depth)))
    return solid


def floors_at(model, *heights):
    return [(model, tuple(name for z in heights for name in floors_of(model.Shape, z)))]


def of_floors(bench, solid, *heights, kind="adaptive", **properties):
    """(Bench, an operation on the floors at some heights), with FreeCAD's own depths."""
    on = bench(solid, tool=TOOL)
    op = on.operation(floors_at(on.model, *heights), kind=kind, StepDown=20.0)
    op.setExpression("FinalDepth", "OpFinalDepth")
    on.set(op, **properties)
    return on, op


def judged(on, op, can_reach_all=True):
    """No gouge and no collision by OpenCASCADE's booleans, and nothing left by the simulator."""
    moves = solid_moves(op.Path.Commands)
    assert gouges(moves, [on.model.Shape], TOOL / 2, op.Tolerance.Value) == []
    assert collisions(moves, on.job.Stock.Shape, TOOL / 2) == []
    found = simulation.of(op)
    assert found.gouge_mm < 0.006
    assert found.rapid_in_material_mm == 0 and found.plunge_in_material_mm == 0
    assert found.rest_area < 0.5 or not can_reach_all, found.rests[:3]
    assert found.max_engagement_deg < op.EngagementAngle.Value + 3
    return found


def lowest(op, x0, x1):
    """z of the lowest place of a path between two abscissas."""
    return min(end[2] for _, _, end, *_ in moves_of(op) if None not in end and x0 <= end[0] <= x1)


PAIR = plate((0, 0, 30, 30, 3), (40, 0, 70, 30, 6))


@pytest.mark.parametrize("kind", ["adaptive", "trochoid", "lame_spiral"])
def test_each_of_two_pockets_is_cut_to_its_own_floor(bench, kind):
    on, op = of_floors(bench, PAIR, -3, -6, kind=kind)
    on.done(op)
    assert op.FinalDepth.Value == pytest.approx(-6)
    assert lowest(op, 0, 30) == pytest.approx(-3) and lowest(op, 40, 70) == pytest.approx(-6)
    higher, lower = (floors_of(on.model.Shape, z)[0] for z in (-3, -6))
    assert "%s of %s: cut down to -3 mm." % (higher, on.model.Label) in op.Report
    assert "%s of %s: cut down to -6 mm." % (lower, on.model.Label) in op.Report
    assert "Checked against the model." in op.Report
    judged(on, op)


def test_what_two_cuts_tell_is_told_as_one(bench):
    on, op = of_floors(bench, PAIR, -3, -6)
    on.done(op)
    singles = []
    for z in (-3, -6):
        single = on.operation(floors_at(on.model, z), FinalDepth=z, StepDown=20.0)
        singles.append(on.done(single))
    for name in ("CuttingTime", "IdealTime", "Passes", "Links"):
        assert getattr(op, name) == pytest.approx(sum(getattr(s, name) for s in singles)), name
    assert op.Retracts == sum(s.Retracts for s in singles) + 1
    removed = sum(s.RemovedVolume.Value for s in singles)
    assert op.RemovedVolume.Value == pytest.approx(removed) and removed > 8000


def test_levels_are_step_down_apart_from_the_top_to_each_floor(bench):
    on, op = of_floors(bench, PAIR, -3, -6, StepDown=2.0)
    on.done(op)

    def levels(x0, x1):
        cuts = [m for m in moves_of(op) if m[0] != "G0" and None not in m[1]]
        level = [e[2] for _, s, e, *_ in cuts if s[2] == e[2] < 0 and x0 <= e[0] <= x1]
        return sorted({round(z, 4) for z in level}, reverse=True)

    assert levels(0, 30) == [-2, -3] and levels(40, 70) == [-2, -4, -6]
    judged(on, op)


def test_a_pocket_in_the_floor_of_another_begins_where_that_ends(bench):
    nested = plate((0, 0, 60, 40, 4), (10, 8, 40, 32, 9))
    on, op = of_floors(bench, nested, -4, -9)
    on.done(op)
    found = judged(on, op)
    # Nothing is cut twice: hardly any of the cuts meets air.
    assert found.air_mm < 0.05 * found.cut_mm
    volume = 60 * 40 * 4 + 30 * 24 * 5
    assert op.RemovedVolume.Value == pytest.approx(volume, rel=0.02)


def test_a_pocket_within_another_that_was_not_cleared_begins_at_the_top(bench):
    # The tool skips the passage, so that not all of the upper floor is cleared.
    solid = plate((0, 0, 30, 40, 4), (30, 16, 40, 22.4, 4), (40, 0, 70, 40, 4), (45, 8, 65, 32, 9))
    on, op = of_floors(bench, solid, -4, -9, NarrowPassages="Skip and report")
    on.done(op)
    assert op.UncutArea.Value > 10
    judged(on, op, can_reach_all=False)


def test_a_step_without_a_wall_is_cleared_up_to_its_edge(bench):
    stepped = plate((0, 0, 30, 40, 4), (30, 0, 60, 40, 8))
    on, op = of_floors(bench, stepped, -4, -8)
    on.done(op)
    assert "belongs to another" not in op.Report
    judged(on, op)
    assert lowest(op, 0, 30 - TOOL / 2 - 0.01) == pytest.approx(-4)


def test_a_final_depth_between_two_floors_stops_the_lower_one(bench):
    on, op = of_floors(bench, PAIR, -3, -6, FinalDepth=-5.0)
    on.done(op)
    assert lowest(op, 0, 30) == pytest.approx(-3) and lowest(op, 40, 70) == pytest.approx(-5)
    assert "1 mm above" in op.Report
    judged(on, op)


def test_a_final_depth_below_all_floors_takes_the_lowest_with_it(bench):
    on, op = of_floors(bench, PAIR, -3, -6, FinalDepth=-6.5)
    on.done(op)
    assert lowest(op, 0, 30) == pytest.approx(-3) and lowest(op, 40, 70) == pytest.approx(-6.5)
    assert "0.5 mm below" in op.Report


def test_stock_stays_on_every_floor(bench):
    on, op = of_floors(bench, PAIR, -3, -6, StockToLeaveAxial=0.5)
    on.done(op)
    assert lowest(op, 0, 30) == pytest.approx(-2.5) and lowest(op, 40, 70) == pytest.approx(-5.5)
    judged(on, op)


def test_an_outline_at_the_top_is_cut_to_final_depth_beside_a_floor(bench):
    on, op = of_floors(bench, plate((40, 0, 70, 30, 6)), -6)
    sketch = sketch_of(on.doc, rectangle(0, 0, 30, 30), z=0.0)
    op.Base = [*op.Base, (sketch, "")]
    on.done(op)
    assert lowest(op, 0, 30) == lowest(op, 40, 70) == pytest.approx(-6)


def test_outlines_at_several_heights_are_cut_to_their_own_planes_until_a_depth_is_set(bench):
    on, op = of_floors(bench, plate())
    high = sketch_of(on.doc, rectangle(0, 0, 30, 30), z=-2.0, name="High")
    low = sketch_of(on.doc, rectangle(40, 0, 70, 30), z=-5.0, name="Low")
    op.Base = [(high, ""), (low, "")]
    on.done(op)
    assert lowest(op, 0, 30) == pytest.approx(-2) and lowest(op, 40, 70) == pytest.approx(-5)
    on.set(op, FinalDepth=-4.0)
    on.done(op)
    assert lowest(op, 0, 30) == lowest(op, 40, 70) == pytest.approx(-4)


def test_a_floor_with_nothing_above_it_to_cut_is_named(bench):
    on, op = of_floors(bench, PAIR, -3, -6)
    top = floors_of(on.model.Shape, 0)[0]
    op.Base = [(on.model, (*op.Base[0][1], top))]
    sentence = on.refused(op)
    assert sentence.startswith("%s of %s: nothing is to be cut" % (top, on.model.Label))


def test_rest_machining_knows_what_the_higher_floor_took(bench):
    nested = plate((0, 0, 60, 40, 4), (10, 8, 40, 32, 9))
    on, op = of_floors(bench, nested, -4, -9, UseRestMachining=True)
    on.done(op)
    assert judged(on, op).air_mm < 0.1 * op.CuttingTime * 255 / 60


def test_cancelling_the_second_cut_cancels_the_operation(bench):
    on, op = of_floors(bench, PAIR, -3, -6)
    shares = []

    def stop_late(share):
        shares.append(share)
        return share < 0.7

    op.Proxy.progress = stop_late
    op.touch()
    on.doc.recompute()
    assert not op.isValid() and op.Report.startswith("Cancelled")
    assert max(shares) >= 0.7 and shares == sorted(shares)


def test_a_job_file_that_names_no_depth_has_each_floor_cut_to_its_own(tmp_path):
    PAIR.exportBrep(str(tmp_path / "pair.brep"))
    job = {
        "name": "pair",
        "model": "pair.brep",
        "base": [floors_of(PAIR, z)[0] for z in (-3, -6)],
        "tool": {"diameter": TOOL},
        "cutting": {"feed": 255, "spindle_speed": 6366},
        "operation": {"type": "adaptive", "parameters": {"StepDown": 20}},
        "output": {"gcode": "pair.ngc", "picture": "pair.png"},
        "simulation": {},
    }
    (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [job]}))
    (made,) = batch.run_file(str(tmp_path / "jobs.json"), lambda line: None)["jobs"]
    assert made["ok"], made["error"]
    assert made["figures"]["simulated_rest_area_mm2"] < 0.5
    assert made["figures"]["simulated_gouge_mm"] < 0.006
    depths = set(re.findall(r"Z(-[0-9.]+)", (tmp_path / "pair.ngc").read_text()))
    assert min(map(float, depths)) == -6 and "-3" in {d.rstrip("0").rstrip(".") for d in depths}
    assert (tmp_path / "pair.png").stat().st_size > 10_000
