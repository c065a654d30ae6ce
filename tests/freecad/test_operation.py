"""The adaptive operation on good input: faces, sketches, edges, regions, depths, properties."""

import math
import os

import evenload
import FreeCAD
import Part
import pytest
from conftest import check_path, moves_of, reopened
from evenload import materials
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, circle, face_of, floors_of, rectangle, sketch_of


SINKS = 20  # of a plate


def at_floor(face, depth=DEPTH):
    return face.translated(Vector(0, 0, -depth))


def test_a_face_is_cleared(square):
    op = square.done(square.operation())
    check_path(op, [at_floor(face_of(SQUARE))])
    assert 55 < op.MaxEngagement.Value < 62
    assert op.CuttingTime > op.IdealTime > 0
    assert op.UncutArea.Value < 1
    assert op.RemovedVolume.Value == pytest.approx(900 * DEPTH, rel=0.02)
    assert op.Proxy.last.toolpath.report.passes > 0


def test_a_whole_sketch_is_cleared(square):
    chain = rectangle(2, 2, 28, 26)
    op = square.operation(base=[(sketch_of(square.doc, chain), "")])
    check_path(square.done(op), [at_floor(face_of(chain))])


def test_a_sketch_with_an_island_leaves_the_island(square):
    outer, island = rectangle(1, 1, 29, 29), circle(15, 15, 4)
    sketch = sketch_of(square.doc, outer)
    sketch.addGeometry(Part.Circle(Vector(15, 15, 0), Vector(0, 0, 1), 4), False)
    square.doc.recompute()
    op = square.done(square.operation(base=[(sketch, "")]))
    check_path(op, [at_floor(face_of(outer, [island]))])


def test_a_sketch_sets_the_final_depth_to_its_own_plane(square):
    op = square.operation(base=[(sketch_of(square.doc, SQUARE, z=-2.25), "")])
    op.setExpression("FinalDepth", "OpFinalDepth")
    square.done(op)
    assert op.OpFinalDepth.Value == pytest.approx(-2.25)
    assert op.FinalDepth.Value == pytest.approx(-2.25)


def test_a_sketch_is_taken_where_its_body_is(square):
    body = square.doc.addObject("PartDesign::Body", "Body")
    chain = rectangle(0, 0, 20, 16)
    sketch = sketch_of(square.doc, chain)
    body.addObject(sketch)
    body.Placement.Base = Vector(5, 6, 0)
    square.doc.recompute()
    op = square.done(square.operation(base=[(sketch, "")]))
    check_path(op, [at_floor(face_of(rectangle(5, 6, 25, 22)))])


def test_closed_edges_are_cleared(square):
    floor = square.model.Shape.getElement(floors_of(square.model.Shape)[0])
    names = tuple(
        "Edge%d" % n
        for n, edge in enumerate(square.model.Shape.Edges, 1)
        if any(edge.isSame(e) for e in floor.Edges)
    )
    op = square.operation(base=[(square.model, names)])
    check_path(square.done(op), [at_floor(face_of(SQUARE))])


def test_two_faces_that_share_an_edge_are_cleared_as_one(bench):
    shape = block_with(face_of(rectangle(0, 0, 40, 20)))
    shape = shape.cut(Part.makeCylinder(2, 1, Vector(5, 5, -1)))  # keeps the solid one piece
    floor = [f for f in shape.Faces if abs(f.BoundBox.ZMax + DEPTH) < 1e-6][0]
    line = Part.makeLine(Vector(17, -1, -DEPTH), Vector(17, 21, -DEPTH))
    halves = floor.generalFuse([line])[0].Faces
    b = bench(block_with(face_of(rectangle(0, 0, 40, 20))))
    split = b.doc.addObject("Part::Feature", "Split")
    split.Shape = Part.Compound(halves)
    b.doc.recompute()
    op = b.done(b.operation(base=[(split, ("Face1", "Face2"))]))
    assert len(op.Proxy.last.regions) == 1
    check_path(op, [at_floor(face_of(rectangle(0, 0, 40, 20)))])


def test_an_island_of_the_face_stays(bench):
    face = face_of(rectangle(0, 0, 40, 40), [rectangle(15, 15, 25, 25)])
    b = bench(block_with(face))
    check_path(b.done(b.operation()), [at_floor(face)])


@pytest.mark.parametrize("step, levels", [(3.0, [-3]), (1.5, [-1.5, -3]), (2.0, [-2, -3])])
def test_the_last_depth_is_always_reached(square, step, levels):
    op = square.done(square.operation(StepDown=step))
    seen = {round(end[2], 6) for _, _, end, *_ in moves_of(op) if end[2] is not None}
    assert set(levels) <= seen and min(seen) == -3
    check_path(op, [at_floor(face_of(SQUARE))])


def test_a_deep_final_depth_is_met_exactly_though_the_step_does_not_divide_it(bench):
    b = bench(block_with(face_of(SQUARE), depth=7.3))
    op = b.operation(base=[(b.model, tuple(floors_of(b.model.Shape, -7.3)))])
    b.set(op, FinalDepth=-7.3, StepDown=2.5)
    b.done(op)
    seen = {end[2] for _, _, end, *_ in moves_of(op) if end[2] is not None}
    assert {-2.5, -5.0, -7.3} <= seen and min(seen) == -7.3


@pytest.mark.parametrize(
    "step, levels",
    [(3.0, [-2.8]), (1.4, [-1.4, -2.8]), (1.0, [-1, -2, -2.8]), (0.9, [-0.9, -1.8, -2.7, -2.8])],
)
def test_the_axial_stock_to_leave_stays_above_the_final_depth(square, step, levels):
    op = square.done(square.operation(StepDown=step, StockToLeaveAxial=0.2))
    cuts = {round(start[2], 6) for name, start, end, *_ in moves_of(op) if end[2] == start[2] < 0}
    assert sorted(cuts, reverse=True) == levels
    assert min(end[2] for _, _, end, *_ in moves_of(op)) == pytest.approx(-2.8)
    assert op.RemovedVolume.Value == pytest.approx(900 * 2.8, rel=0.02)
    assert "FinalDepth" not in op.Report  # it is the floor's, as it should be


def test_depths_that_miss_the_floor_are_reported(square):
    op = square.done(square.operation())
    assert "FinalDepth" not in op.Report
    op.FinalDepth = -2
    assert "Final Depth lies 1 mm above Face" in square.done(op).Report
    op.FinalDepth = -3.5
    assert "Final Depth lies 0.5 mm below Face" in square.done(op).Report


def test_arcs_can_be_switched_off(square):
    op = square.done(square.operation(Arcs=False))
    assert {name for name, *_ in moves_of(op)} == {"G0", "G1"}
    check_path(op, [at_floor(face_of(SQUARE))])


@pytest.mark.parametrize("entry", ["Automatic", "Helix", "Ramp"])
def test_entries_descend_slowly_and_never_straight_down(square, entry):
    op = square.done(square.operation(Entry=entry, HelixAngle=4))
    steepest = 0.0
    for name, start, end, centre, feed in moves_of(op):
        if name == "G0" or None in start or end[2] > start[2] - 1e-6 or start[2] > 1e-6:
            continue
        flat = math.dist(start[:2], end[:2])
        if centre:
            radius = math.dist(start[:2], centre)
            flat = 2 * radius * math.asin(min(1.0, flat / (2 * radius)))
        assert flat > 0
        steepest = max(steepest, math.degrees(math.atan2(start[2] - end[2], flat)))
        assert feed <= 255.1
    assert 0 < steepest < 4.5


def test_a_predrilled_hole_is_entered_straight_and_without_helix(square):
    op = square.operation(Entry="Predrilled hole", HoleDiameter=8, EntryPoint=Vector(10, 12, 0))
    square.done(op)
    descents = [
        (start, end)
        for name, start, end, *_ in moves_of(op)
        if None not in start and end[2] < start[2] and start[2] <= 0.6
    ]
    first = descents[0][1]
    assert first[:2] == (10, 12) and first[2] == -DEPTH
    check_path(op, [at_floor(face_of(SQUARE))])


# ---- properties ----


def test_defaults_are_those_of_the_contract(square):
    op = square.operation()
    expected = {
        "EngagementAngle": 60,
        "SideStep": 1.5,
        "MaximumFeed": 2 * 255 / 60,
        "LinkFeed": 5000 / 60,
        "LinkLift": 0,
        "HelixAngle": 3,
        "HelixDiameter": 5.4,
        "HoleDiameter": 0,
        "RollRadius": 0.9,
        "MinimumRadius": 0.9,
        "StockToLeave": 0,
        "StockToLeaveAxial": 0,
        "Tolerance": 0.005,
    }
    for name, value in expected.items():
        assert getattr(op, name).Value == pytest.approx(value), name
    assert op.CutMode == "Climb" and op.FeedControl == "Constant feed" and op.Entry == "Automatic"
    assert op.WallPass is True and op.Arcs is True
    assert op.getEnumerationsOfProperty("Entry") == [
        "Automatic",
        "Helix",
        "Ramp",
        "Predrilled hole",
    ]
    assert op.getEnumerationsOfProperty("FeedControl") == [
        "Constant feed",
        "Constant removal rate",
        "Constant chip thickness",
        "Constant force",
    ]
    assert op.getEnumerationsOfProperty("Material") == materials.names()
    assert op.getEnumerationsOfProperty("OrderBy") == ["Region", "Depth"]
    assert op.getEnumerationsOfProperty("NarrowPassages") == [
        "Trochoid with smaller radius",
        "Cut at reduced feed",
        "Skip and report",
    ]


def test_angle_and_side_step_follow_each_other(square):
    op = square.operation()
    op.EngagementAngle = 90
    assert op.SideStep.Value == pytest.approx(3.0)
    op.SideStep = "0.6 mm"
    assert op.EngagementAngle.Value == pytest.approx(math.degrees(math.acos(0.8)))
    op.SideStep = 4.5
    assert op.EngagementAngle.Value == pytest.approx(120)


def test_the_angle_is_kept_when_the_tool_changes(square):
    op = square.done(square.operation(SideStep=1.5))
    square.controller.Tool.Diameter = 4
    square.done(op)
    assert op.EngagementAngle.Value == pytest.approx(60)
    assert op.SideStep.Value == pytest.approx(1.0)


def test_the_angle_follows_a_side_step_under_an_expression(square):
    op = square.operation(EngagementAngle=35)
    # FreeCAD 0.20 may leave out an expression that names nothing, beside others that do.
    op.setExpression("SideStep", "OpToolDiameter * 0 + 1.5 mm")
    square.done(op)
    assert op.EngagementAngle.Value == pytest.approx(60)
    square.controller.Tool.Diameter = 4
    square.done(op)
    assert op.SideStep.Value == pytest.approx(1.5)
    assert op.EngagementAngle.Value == pytest.approx(math.degrees(math.acos(0.25)))
    assert op.MaxEngagement.Value < op.EngagementAngle.Value + 2


def test_an_angle_under_an_expression_stays_whatever_side_step_is_set(square):
    op = square.operation()
    op.setExpression("EngagementAngle", "OpToolDiameter / 6 mm * 40 deg")
    square.done(op)
    op.SideStep = 2.5
    square.done(op)
    assert op.EngagementAngle.Value == pytest.approx(40)
    assert op.SideStep.Value == pytest.approx(3 * (1 - math.cos(math.radians(40))))


def test_expressions_for_both_angle_and_side_step_are_refused(square):
    op = square.operation()
    op.setExpression("EngagementAngle", "40 deg")
    op.setExpression("SideStep", "1 mm")
    square.doc.recompute()
    assert not op.isValid() and "both have an expression" in op.Report
    op.setExpression("EngagementAngle", None)
    assert square.done(op).isValid()


def test_lengths_and_feeds_follow_the_tool_until_they_are_set(square):
    op = square.operation()
    op.RollRadius = 0.5
    square.controller.Tool.Diameter = 4
    square.controller.HorizFeed = "300 mm/min"
    square.done(op)
    assert op.MinimumRadius.Value == pytest.approx(0.6)
    assert op.HelixDiameter.Value == pytest.approx(3.6)
    assert op.MaximumFeed.Value == pytest.approx(10)
    assert op.RollRadius.Value == pytest.approx(0.5)
    op.Proxy.follow_tool(op, again=["RollRadius"])
    assert op.RollRadius.Value == pytest.approx(0.6)


def test_a_second_operation_gets_the_tool_controller_that_it_is_given(square):
    from evenload import host
    from evenload.operations import adaptive

    other = host.cam().controller.Create("TC: other")
    square.job.Proxy.addToolController(other)
    other.HorizFeed = other.VertFeed = "100 mm/min"
    first = adaptive.Create("First", parentJob=square.job, toolController=square.controller)
    second = adaptive.Create("Second", parentJob=square.job, toolController=other)
    assert first.ToolController is square.controller and second.ToolController is other
    assert second.MaximumFeed.Value == pytest.approx(200 / 60)


def test_without_a_user_to_ask_the_first_tool_controller_is_taken(square):
    from evenload import host
    from evenload.operations import adaptive

    square.job.Proxy.addToolController(host.cam().controller.Create("TC: other"))
    op = adaptive.Create("Operation", parentJob=square.job)
    assert op.ToolController is square.controller


def test_the_setup_sheet_gives_defaults(square):
    from evenload import host
    from evenload.operations import adaptive

    sheet = square.job.SetupSheet
    sheet.addProperty("App::PropertyAngle", "EvenLoadAdaptiveEngagementAngle")
    sheet.EvenLoadAdaptiveEngagementAngle = 45
    op = adaptive.Create("Operation", parentJob=square.job, toolController=square.controller)
    assert op.EngagementAngle.Value == pytest.approx(45)
    assert op.SideStep.Value == pytest.approx(3 * (1 - math.cos(math.pi / 4)))
    prototype = host.cam().setup_sheet._RegisteredOps[adaptive.NAME].prototype(adaptive.NAME)
    assert prototype.getProperty("CutMode").getEnumValues() == ["Climb", "Conventional"]


def test_a_material_that_is_no_longer_there_is_kept_and_refused_where_it_counts(square, tmp_path):
    op = square.operation(FeedControl="Constant force", Material="Al7075-T6")
    square.done(op)
    op.Material = [*materials.names(), "Unobtainium"]
    op.Material = "Unobtainium"
    with reopened(square.doc, tmp_path / "job.FCStd") as again:
        op = again.getObject("Operation")
        assert op.Material == "Unobtainium"
        op.touch()
        again.recompute()
        assert not op.isValid()
        assert "no material 'Unobtainium'" in op.Report and "'Al7075-T6'" in op.Report
        op.FeedControl = "Constant chip thickness"
        again.recompute()
        assert op.isValid() and len(op.Path.Commands) > 10


def test_an_inactive_operation_makes_no_path(square):
    op = square.done(square.operation())
    op.Active = False
    square.doc.recompute()
    assert not [c for c in op.Path.Commands if c.Name.startswith("G")]
    assert op.CuttingTime == 0


def test_a_recompute_gives_the_same_path(square):
    op = square.done(square.operation())
    first = op.Path.toGCode()
    assert square.done(op).Path.toGCode() == first


def test_nothing_is_recomputed_without_need(square):
    square.done(square.operation())
    assert square.doc.recompute() == 0


def test_a_cancelled_operation_is_empty_until_it_is_computed_again(square):
    whole = len(square.done(square.operation()).Path.Commands)
    op = square.operation()
    asked = []

    def stop_at_the_third(share):  # once a pass is cut
        if share > 0:
            asked.append(share)
        return len(asked) < 3

    op.Proxy.progress = stop_at_the_third
    op.touch()
    square.doc.recompute()
    assert len(asked) == 3 and 0 < asked[0] <= asked[1] <= asked[2] < 1
    assert not op.isValid() and op.Report.startswith("Cancelled")
    assert not [c for c in op.Path.Commands if c.Name.startswith("G")]
    op.Proxy.progress = None
    square.done(op)
    assert "Cancelled" not in op.Report and len(op.Path.Commands) == whole


def test_whoever_waits_is_asked_while_a_model_is_turned_into_heights(bench):
    plate = block_with(face_of(SQUARE))
    for k in range(SINKS):
        place = FreeCAD.Vector(plate.BoundBox.XMin + 1 + 0.3 * k, plate.BoundBox.YMin + 1, 0)
        plate = plate.cut(Part.makeCone(0.04, 0.1, 0.1, place - FreeCAD.Vector(0, 0, 0.1)))
    on = bench(plate)
    op = on.operation()
    asked = []

    def count(share):
        asked.append(share)
        return True

    op.Proxy.progress = count
    on.done(op)
    before_the_core = next(k for k, share in enumerate(asked) if share > 0)
    assert before_the_core > SINKS
    for last in (1, before_the_core // 2):  # asked so often before it is stopped
        asked.clear()
        op.Proxy.progress = lambda share: count(share) and len(asked) < last
        op.touch()
        on.doc.recompute()
        assert not op.isValid() and op.Report.startswith("Cancelled") and op.UncutArea.Value > 0
        assert len(asked) == last


# ---- open edges ----


def open_sides(op):
    return [v[3] for floor in op.Proxy.last.floors for v in floor.outer]


def test_a_closed_pocket_has_no_open_side(square):
    assert not any(open_sides(square.done(square.operation())))


def test_a_pocket_at_the_side_of_the_block_is_open_there(bench):
    shape = Part.makeBox(40, 30, 10, Vector(0, 0, -10))
    shape = shape.cut(Part.makeBox(30, 20, 3, Vector(10, 5, -3)))
    b = bench(shape)
    op = b.done(b.operation())
    (floor,) = op.Proxy.last.floors
    ((x, y, _, _),) = [v for v in floor.outer if v[3]]
    assert x == pytest.approx(40)
    assert min(y, 25) in (5, 25)


def test_a_wall_beyond_an_open_side_closes_it(bench):
    shape = Part.makeBox(60, 30, 10, Vector(0, 0, -10))
    shape = shape.cut(Part.makeBox(30, 20, 3, Vector(10, 5, -3)))
    shape = shape.cut(Part.makeBox(8, 20, 6, Vector(40, 5, -6)))  # a groove, then a wall
    b = bench(shape)
    assert not any(open_sides(b.done(b.operation())))


def test_a_boss_without_walls_is_open_all_round(bench):
    shape = Part.makeBox(60, 60, 10, Vector(0, 0, -13)).fuse(
        Part.makeBox(20, 20, 3, Vector(20, 20, -3))
    )
    b = bench(shape.removeSplitter())
    op = b.done(b.operation())
    assert open_sides(op) == [True] * 4
    assert not any(v[3] for v in op.Proxy.last.floors[0].islands[0])


def test_a_boss_in_larger_stock_is_cleared_to_the_edge_of_the_stock(bench):
    from evenload import host

    shape = Part.makeBox(60, 60, 10, Vector(0, 0, -13)).fuse(
        Part.makeBox(20, 20, 3, Vector(20, 20, -3))
    )
    b = bench(shape.removeSplitter())
    host.set_stock_margin(b.job, 4.0)
    b.doc.recompute()
    op = b.operation(StartDepth=4.0, StepDown=7.0)
    b.done(op)
    assert {abs(c) for v in op.Proxy.last.floors[0].outer for c in v[:2]} == {4.0, 64.0}
    assert open_sides(op) == [True] * 4


def test_a_hole_in_the_floor_is_no_island_while_the_stock_fills_it(bench):
    shape = block_with(face_of(SQUARE)).cut(Part.makeCylinder(5, 20, Vector(15, 15, -15)))
    b = bench(shape)
    op = b.done(b.operation())
    assert op.Proxy.last.floors[0].islands == []
    assert op.Proxy.last.regions[0].area == pytest.approx(900)


# ---- saving ----


def test_it_survives_saving_and_recomputes_the_same(square, tmp_path):
    op = square.operation(
        EngagementAngle=50, Entry="Helix", RollRadius=0.7, FeedControl="Constant removal rate"
    )
    before = square.done(op).Path.toGCode()
    name = op.Name
    with reopened(square.doc, tmp_path / "saved.FCStd") as doc:
        op = doc.getObject(name)
        assert type(op.Proxy).__name__ == "Adaptive"
        assert type(op.Proxy).__module__ == "evenload.operations.adaptive"
        assert op.Path.toGCode() == before
        assert op.EngagementAngle.Value == pytest.approx(50) and op.Entry == "Helix"
        assert op.SideStep.Value == pytest.approx(3 * (1 - math.cos(math.radians(50))))
        assert "RollRadius" in op.OwnValues and "LinkFeed" not in op.OwnValues
        op.touch()
        doc.recompute()
        assert op.isValid() and op.Path.toGCode() == before
        op.EngagementAngle = 90
        assert op.SideStep.Value == pytest.approx(3)


def test_a_document_without_newer_properties_gets_them(square, tmp_path):
    op = square.done(square.operation())
    name = op.Name
    op.removeProperty("LinkLift")
    with reopened(square.doc, tmp_path / "old.FCStd") as doc:
        assert doc.getObject(name).LinkLift.Value == 0
        assert "LinkLift" not in doc.getObject(name).OwnValues


def test_the_addon_manager_can_read_the_package():
    folder = os.path.dirname(os.path.abspath(evenload.__file__))
    package = FreeCAD.Metadata(os.path.join(folder, "..", "..", "package.xml"))
    assert package.Name == "EvenLoad"
    assert [w.Name for w in package.Content["workbench"]] == ["EvenLoad"]
    assert os.path.isfile(os.path.join(folder, "..", "..", package.Icon))
