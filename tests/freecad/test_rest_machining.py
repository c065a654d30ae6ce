"""Rest machining: what earlier operations of the job left, nothing twice, and no air."""

import math

import evenload
import pytest
from conftest import moves_of, reopened, saved_copy
from evenload import compiled, host, job_simulation
from evenload.pictures import path_picture
from evenload.simulation import earlier
from FreeCAD import Vector
from models import DEPTH, block_with, case_model, circle, corpus_case, face_of, floors_of, rectangle

pytestmark = pytest.mark.between

FLAT_CORNER = 1 - math.pi / 4  # of a square of side 1 about a quarter circle of radius 1


def after(bench, diameter, base=None, **properties):
    """An operation with a tool of its own, which clears what is left for it."""
    before, bench.controller = bench.controller, host.cam().controller.Create("Tool%g" % diameter)
    mine = bench.controller
    mine.Tool = host.create_tool("endmill", {"Diameter": diameter, "Flutes": 1})
    mine.HorizFeed = mine.VertFeed = "255 mm/min"
    host.set_rapid_feed(mine, 5000.0)
    mine.SpindleSpeed, mine.ToolNumber = 6366.0, len(bench.job.Tools.Group) + 1
    bench.job.Proxy.addToolController(mine)
    try:
        return bench.operation(base, UseRestMachining=True, **properties)
    finally:
        bench.controller = before


def contact(op):
    """The share of the cuts' length on which the tool touches material."""
    setup = job_simulation.read(op)
    found = evenload.simulate(
        op.Proxy.last.toolpath,  # whose links are known
        setup.stock,
        setup.top,
        setup.bottom,
        setup.tool.diameter,
        part=setup.part,
        earlier=setup.earlier,
        infer_kinds=False,
    )
    assert found.link_engagement_deg < 2
    return 1 - found.air_mm / found.cut_mm


def heights_of_cuts(op):
    """The heights at which the tool travels."""
    return sorted(
        {
            round(end[2], 3)
            for _, start, end, *_ in moves_of(op)
            if None not in start and start[:2] != end[:2] and end[2] < 0
        }
    )


def check(op, limit=62):
    found = evenload.simulation.of(op)
    assert found.max_engagement_deg <= limit, found.max_engagement_at
    assert found.gouge_mm < 0.002 and found.incidents == []
    assert found.rest_area < 0.01
    assert contact(op) >= 0.8
    return found


def test_a_smaller_tool_clears_just_the_corners_that_a_larger_one_left(bench):
    square = bench(block_with(face_of(rectangle(0, 0, 60, 60))), tool=12.0)
    square.done(square.operation())
    op = square.done(after(square, 6.0))
    found = check(op)
    left = 4 * FLAT_CORNER * (6**2 - 3**2) * DEPTH
    assert found.removed_volume_total == pytest.approx(left, rel=0.01)
    assert op.RemovedVolume.Value == pytest.approx(left, rel=0.01)
    assert found.entry_mm == 0  # it comes down beside the material
    assert op.UncutArea.Value == 0


@pytest.fixture
def room(bench):
    """A Bench with a square pocket of 60 mm and a tool of 12 mm."""
    return bench(block_with(face_of(rectangle(0, 0, 60, 60))), tool=12.0)


def test_after_the_same_tool_nothing_is_left(room):
    room.done(room.operation())
    op = after(room, 12.0)
    room.doc.recompute()
    assert op.isValid() and op.Path.Commands == []
    assert "Nothing was left to cut" in op.Report
    assert op.RemovedVolume.Value == 0 and op.UncutArea.Value == 0


def test_nothing_left_can_be_posted(room):
    room.done(room.operation())
    after(room, 12.0)
    room.doc.recompute()
    text = host.post(room.job, "linuxcnc", "--no-show-editor")
    assert text.count("G1 ") + text.count("G2 ") + text.count("G3 ") > 100


def test_without_earlier_operations_all_is_left(room):
    op = room.done(after(room, 6.0))
    found = check(op)
    assert found.removed_volume_total == pytest.approx(
        (3600 - 4 * FLAT_CORNER * 9) * DEPTH, rel=1e-3
    )
    assert found.entry_mm > 10  # a helix: there is no cleared ground


def test_films_in_flat_corners_are_seen_whole(bench):
    corners = [math.radians(11.25 + 20 * k) for k in range(18)]
    chain = [(30 * math.cos(a), 30 * math.sin(a), 0) for a in corners]
    b = bench(block_with(face_of(chain)), tool=10.3)
    b.done(b.operation(EngagementAngle=30.0))
    held = dict(FeedControl="Constant removal rate", MaximumFeed="1000 mm/min")
    op = b.done(after(b, 6.0, EngagementAngle=30.0, **held))
    found = evenload.simulation.of(op, resolution=0.01, step=0.01)
    assert found.removal_rate_peak <= 1.05 * op.SideStep.Value * DEPTH * 255.0
    assert found.removed_volume_total > 0.5 and found.rest_area < 0.01


@pytest.mark.parametrize("mode", ["Climb", "Conventional"])
def test_between_a_boss_and_a_wall_it_clears_what_was_too_narrow(bench, mode):
    islands = [rectangle(24, 20, 34, 40), circle(46, 10, 4)]
    b = bench(block_with(face_of(rectangle(0, 0, 60, 60), islands)), tool=16.0)
    b.done(b.operation())
    op = b.done(after(b, 6.0, CutMode=mode))
    assert check(op).removed_volume_total > 60 * DEPTH


def test_a_room_that_the_larger_tool_could_not_enter_gets_an_entry_of_its_own(bench):
    chain = [(0, 0), (30, 0), (30, 11), (36, 11), (36, 0), (66, 0), (66, 30), (36, 30), (36, 19)]
    chain = [(x, y, 0) for x, y in [*chain, (30, 19), (30, 30), (0, 30)]]
    b = bench(block_with(face_of(chain)), tool=12.0)
    hole = dict(Entry="Predrilled hole", EntryPoint=Vector(15, 15, 0), HoleDiameter=13.0)
    first = b.done(b.operation(**hole))
    assert "left uncut" in first.Report
    op = b.done(after(b, 5.0))
    found = check(op)
    assert found.removed_volume_total > 900 * DEPTH
    assert op.UncutArea.Value == 0


def test_each_depth_has_a_stock_of_its_own(bench):
    deep = bench(case_model({**corpus_case("square60"), "axial_depth": 9}), tool=12.0)
    floors = [(deep.model, tuple(floors_of(deep.model.Shape, -9.0)))]
    deep.done(deep.operation(floors, FinalDepth=-3.0, StepDown=3.0))
    op = deep.done(after(deep, 6.0, floors, FinalDepth=-9.0, StepDown=3.0))
    found = check(op)
    corners, all_of_it = 4 * FLAT_CORNER * 27, 3600 - 4 * FLAT_CORNER * 9
    assert found.removed_volume_total == pytest.approx(3 * corners + 6 * all_of_it, rel=1e-3)
    assert op.RemovedVolume.Value == pytest.approx(found.removed_volume_total, rel=2e-3)
    # Down to where the larger tool went it comes down beside the corners, below by a helix.
    entries = found.z[(found.kind == 2) & (found.length > 0)]
    assert len(entries) and entries.max() < -2.4


def test_a_depth_at_which_nothing_stands_is_left_out(bench):
    deep = bench(case_model({**corpus_case("square60"), "axial_depth": 9}), tool=6.0)
    floors = [(deep.model, tuple(floors_of(deep.model.Shape, -9.0)))]
    deep.done(deep.operation(floors, FinalDepth=-6.0, StepDown=3.0))
    op = deep.done(after(deep, 6.0, floors, FinalDepth=-9.0, StepDown=3.0))
    check(op)
    assert not {-3.0, -6.0} & set(heights_of_cuts(op)) and heights_of_cuts(op)[0] == -9


def test_an_open_pocket_s_corners_are_reached_over_its_floor(bench):
    solid = block_with(face_of(rectangle(0, 0, 60, 60)))
    slot = face_of(rectangle(20, -10, 40, 40)).extrude(Vector(0, 0, -DEPTH))
    b = bench(solid.fuse(block_with(face_of(rectangle(0, 0, 60, 60)))).cut(slot), tool=12.0)
    import Part

    b.part.Shape = Part.makeBox(80, 80, 12, Vector(-10, -10, -12)).cut(slot)
    b.doc.recompute()
    b.done(b.operation([(b.model, tuple(floors_of(b.model.Shape)))]))
    op = b.done(after(b, 5.0, [(b.model, tuple(floors_of(b.model.Shape)))]))
    found = check(op)
    left = 2 * FLAT_CORNER * (6**2 - 2.5**2) * DEPTH
    assert found.removed_volume_total == pytest.approx(left, rel=0.01)
    assert found.entry_mm == 0


def test_what_freecads_own_operation_left_is_cleared(room):
    theirs = host.freecads_adaptive("Theirs", room.job, room.controller)
    theirs.Base = [(room.model, tuple(floors_of(room.model.Shape)))]
    theirs.UseOutline, theirs.StepOver = False, 25
    theirs.setExpression("FinalDepth", None)
    theirs.FinalDepth = -DEPTH
    room.doc.recompute()
    op = room.done(after(room, 6.0))
    found = evenload.simulation.of(op)
    assert found.max_engagement_deg <= 62 and found.rest_area < 0.1 and found.gouge_mm < 0.002
    left = 4 * FLAT_CORNER * 27 * DEPTH
    assert left * 0.9 < found.removed_volume_total < 4 * left


def test_what_a_bull_nosed_tool_left_at_the_walls_feet_is_cleared(room):
    corner = 2.0
    room.controller.Tool = host.create_tool("bullnose", {"Diameter": 12.0})
    bit = room.controller.Tool
    if hasattr(bit, "CornerRadius"):
        bit.CornerRadius = corner
    else:
        bit.FlatRadius = 6.0 - corner  # of the flat in the middle of the bottom
    room.done(room.operation())
    op = room.done(after(room, 6.0))
    # A band along the walls, as wide as the corner, less where that reaches round corners.
    assert op.RemovedVolume.Value == pytest.approx(4 * 56 * corner * DEPTH, rel=0.15)
    assert op.UncutArea.Value == 0


def custom(bench, *lines, name="Custom", controller=None):
    """One of FreeCAD's own operations, of these lines of G-code."""
    op = host.freecads("Custom", name, bench.job, controller or bench.controller)
    op.Gcode = list(lines)
    bench.doc.recompute()
    return op


def test_a_bored_hole_before_it_is_no_material(room):
    whole = room.done(after(room, 6.0)).RemovedVolume.Value
    room.job.Operations.Group = []
    custom(room, "G0 Z15", "G0 X30 Y30", "G85 X30 Y30 Z-3 R1 F100", "G80")
    op = room.done(after(room, 6.0))
    assert op.RemovedVolume.Value == pytest.approx(whole - math.pi * 36 * DEPTH, rel=0.02)
    assert evenload.simulation.of(op).rapid_in_material_mm == 0


def test_beside_a_drills_point_material_stands(room):
    drill = host.cam().controller.Create("Drill")
    room.job.Proxy.addToolController(drill)
    drill.Tool = host.create_tool("drill", {"Diameter": 12.0, "TipAngle": 90})
    drill.HorizFeed = drill.VertFeed = "100 mm/min"
    # 5 mm below the floor the tip is: at the floor the hole is 10 mm wide.
    custom(room, "G0 Z15", "G0 X30 Y30", "G81 X30 Y30 Z-8 R1 F100", "G80", controller=drill)
    op = after(room, 6.0)
    room.done(op)
    stock = earlier.before(op).stock(0.05)
    hole = face_of(circle(30, 30, 9))
    region = compiled.core().Region(circle(30, 30, 9))
    for height in (-1.0, -2.5, -DEPTH, -5.0):
        standing = sum(r.area for r in stock.standing(height + 0.01, [region]))
        open_area = hole.Area - standing
        true = min(6.0, height + 8.0)
        assert open_area <= math.pi * true**2 + 0.5
        assert open_area >= math.pi * (true - 1.6) ** 2 - 0.5


def with_array(bench, op, offset, copies):
    """FreeCAD's array of an operation, in its job."""
    array = host.array(op)
    array.Offset, array.Copies = offset, copies
    bench.job.Proxy.addOperation(array)
    bench.doc.recompute()
    return array


def test_each_copy_of_an_array_before_it_counts(room):
    whole = room.done(after(room, 6.0)).RemovedVolume.Value
    room.job.Operations.Group = []
    first = custom(room, "G0 Z15", "G0 X12 Y30", "G81 X12 Y30 Z-3 R1 F100", "G80", "G0 Z15")
    array = with_array(room, first, Vector(18, 0, 0), 2)
    op = room.done(after(room, 6.0))
    assert op.EarlierOperations == [first, array]
    assert op.RemovedVolume.Value == pytest.approx(whole - 3 * math.pi * 36 * DEPTH, rel=0.02)
    found = evenload.simulation.of(op)
    assert found.gouge_mm < 0.002 and found.incidents == []


def test_where_the_job_has_only_its_array_the_array_does_not_come_before_it(room):
    first = custom(room, "G0 Z15", "G0 X12 Y30", "G81 X12 Y30 Z-3 R1 F100", "G80", "G0 Z15")
    op = room.done(after(room, 6.0))
    whole = op.RemovedVolume.Value
    array = with_array(room, op, Vector(100, 0, 0), 1)
    room.job.Operations.Group = [first, array]
    assert room.done(op).RemovedVolume.Value == pytest.approx(whole)
    assert op.EarlierOperations == [first]
    assert len(earlier.cut_before(op, [])) == 1


def test_it_is_emptied_when_what_an_array_before_it_repeats_fails(room):
    first = room.done(room.operation())
    array = with_array(room, first, Vector(100, 0, 0), 1)
    room.job.Operations.Group = [array]  # which is all that is left of the first
    op = room.done(after(room, 6.0))
    assert op.EarlierOperations == [array]
    first.EngagementAngle = 0.0
    room.doc.recompute()
    assert not first.isValid() and op.Path.Commands == array.Path.Commands == []


def test_a_dressup_of_a_failed_operation_keeps_no_path_that_could_be_posted(room):
    first = room.done(room.operation())
    dressed = host.dressup("Boundary").Create(first)
    again = host.dressup("Boundary").Create(dressed)
    room.doc.recompute()
    assert len(again.Path.Commands) > 100
    first.EngagementAngle = 0.0
    room.doc.recompute()
    assert not first.isValid()
    assert dressed.Path.Commands == again.Path.Commands == []
    assert "Touched" in dressed.State and "Touched" in again.State
    first.EngagementAngle = 60.0
    room.doc.recompute()
    assert len(again.Path.Commands) > 100


def test_a_dressup_before_it_counts_as_what_it_makes_of_the_path(room):
    first = room.done(room.operation())
    dressed = host.dressup("Boundary").Create(first)
    half = room.doc.addObject("Part::Box", "Half")
    half.Length, half.Width, half.Height = 40, 80, 30
    half.Placement.Base = Vector(-10, -10, -12)
    stock = dressed.Stock
    dressed.Stock = half
    if stock is not None:
        room.doc.removeObject(stock.Name)
    room.doc.recompute()
    op = room.done(after(room, 6.0))
    assert op.EarlierOperations == [dressed]
    # What the boundary keeps of the path is within x = 30: all beyond the tool's radius is left.
    assert 60 * 24 * DEPTH < op.RemovedVolume.Value < 60 * 34 * DEPTH
    assert evenload.simulation.of(op).gouge_mm < 0.002


def test_an_inactive_earlier_operation_cuts_nothing(room):
    first = room.operation()
    first.Active = False
    op = room.done(after(room, 6.0))
    assert op.RemovedVolume.Value > 3500 * DEPTH


def test_it_follows_when_an_earlier_operation_changes(room):
    first = room.done(room.operation())
    op = room.done(after(room, 6.0))
    before = op.RemovedVolume.Value
    first.StockToLeave = 1.0
    room.doc.recompute()
    assert op.isValid()
    assert op.RemovedVolume.Value > before + 200 * DEPTH
    op.UseRestMachining = False
    assert op.EarlierOperations == []


def test_it_is_emptied_when_an_earlier_operation_fails(room, tmp_path):
    first = room.done(room.operation())
    op = room.done(after(room, 6.0))
    first.EngagementAngle = 0.0
    room.doc.recompute()
    assert not first.isValid()
    sentence = "'%s', which comes before '%s', failed: mend it and recompute." % (
        first.Label,
        op.Label,
    )

    def is_empty(op):
        assert op.Path.Commands == [] and op.Report == sentence and op.CycleTime == ""
        assert op.RemovedVolume.Value == op.CuttingTime == op.MaxEngagement.Value == 0
        assert "Touched" in op.State or not op.isValid()
        return True

    assert is_empty(op)
    with saved_copy(room.doc, tmp_path / "failed.FCStd") as copy:
        assert is_empty(copy.getObject(op.Name))
    first.EngagementAngle = 60.0
    room.doc.recompute()
    assert op.isValid() and op.RemovedVolume.Value > 60


def test_it_waits_for_an_earlier_operation_that_is_not_up_to_date(room):
    first = room.done(room.operation())
    op = room.done(after(room, 6.0))
    first.touch()
    with pytest.raises(ValueError, match="which comes before .* recompute the document once more"):
        op.Proxy.execute(op)
    assert op.Path.Commands == []


def test_operations_may_change_places(room):
    first = room.operation(UseRestMachining=True)
    second = after(room, 6.0)
    room.doc.recompute()
    assert first.EarlierOperations == [] and second.EarlierOperations == [first]
    room.job.Operations.Group = [second, first]
    room.done(second)
    assert second.EarlierOperations == [] and first.EarlierOperations == [second]
    first.touch()
    room.doc.recompute()
    assert "Nothing was left to cut" in first.Report


def test_it_survives_saving_and_opening(room, tmp_path):
    room.done(room.operation())
    op = room.done(after(room, 6.0))
    name, volume = op.Name, op.RemovedVolume.Value
    with reopened(room.doc, tmp_path / "rest.FCStd") as doc:
        again = doc.getObject(name)
        assert again.UseRestMachining and len(again.EarlierOperations) == 1
        again.touch()
        doc.recompute()
        assert again.isValid() and again.RemovedVolume.Value == pytest.approx(volume, rel=1e-6)


def test_its_picture_shows_the_engagement_with_what_was_left(room, tmp_path):
    room.done(room.operation())
    op = room.done(after(room, 6.0))
    path_picture.picture(op, str(tmp_path / "rest.png"))
    assert (tmp_path / "rest.png").stat().st_size > 5000
    assert op.MaxEngagement.Value < 62
