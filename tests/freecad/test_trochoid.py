"""The trochoid operation: slots from faces and centrelines, patterns, results, refusals."""

import math

import Part
import pytest
from conftest import check_path, moves_of, points_of, reopened
from FreeCAD import Vector
from models import block_with, face_of, floors_of, rectangle, sketch_of

PATTERNS = ("Constant engagement", "Circular", "Cycloid")
LENGTH, WIDTH = 60.0, 10.0  # mm
SLOT = rectangle(0, 0, LENGTH, WIDTH)
ROUND_SLOT = [(5, 0, 0), (55, 0, 1), (55, 10, 0), (5, 10, 1)]
LINE = [(10, 5, 0), (50, 5, 0)]


@pytest.fixture
def slot(bench):
    return bench(block_with(face_of(SLOT)))


def trochoid(bench, base=None, **properties):
    return bench.operation(base, kind="trochoid", **properties)


def on_line(bench, chain=LINE, **properties):
    """A trochoid on an open sketch."""
    sketch = sketch_of(bench.doc, chain, closed=False)
    return trochoid(bench, [(sketch, "")], **properties)


@pytest.mark.parametrize("pattern", PATTERNS)
@pytest.mark.parametrize("outline", [SLOT, ROUND_SLOT], ids=["square ends", "round ends"])
def test_a_slot_is_cut_to_its_ends_and_walls(bench, outline, pattern):
    face = face_of(outline)
    b = bench(block_with(face))
    op = b.done(trochoid(b, Pattern=pattern))
    check_path(op, [face])
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)
    assert op.MaxEngagement.Value < 61
    assert "uncut" not in op.Report


def test_the_results_tell_of_one_turn(slot):
    op = slot.done(trochoid(slot, FeedControl="Constant removal rate"))
    assert 0.3 < op.TrochoidalStep.Value < 1.5
    assert 2 <= op.Iterations <= 50
    # One turn removes step x width x depth; its time counts the way back.
    nominal = 1.5 * 3 * 255
    assert 0.5 * nominal < op.RemovalRate < nominal


def test_constant_engagement_steps_further_and_removes_more_than_the_other_patterns(slot):
    found = {}
    for pattern in PATTERNS:
        op = slot.done(trochoid(slot, Pattern=pattern, LinkFeed="1500 mm/min"))
        found[pattern] = op.TrochoidalStep.Value, op.RemovalRate
        slot.doc.removeObject(op.Name)
    step, rate = found.pop("Constant engagement")
    for other_step, other_rate in found.values():
        assert step > 1.1 * other_step
        assert rate > 1.1 * other_rate


def test_conventional_milling_turns_the_other_way(slot):
    sweeps = {}
    for mode in ("Climb", "Conventional"):
        op = slot.done(trochoid(slot, CutMode=mode))
        sweeps[mode] = sum({"G2": -1, "G3": 1}.get(name, 0) for name, _, _, _, feed in moves_of(op))
        slot.doc.removeObject(op.Name)
    assert sweeps["Climb"] > 10 and sweeps["Conventional"] < -10


def test_a_hole_at_the_end_is_the_way_in(slot):
    op = slot.done(
        trochoid(slot, Entry="Predrilled hole", EntryPoint=Vector(5, 5, 0), HoleDiameter=9.5)
    )
    x, y, _, _ = points_of(op)[0]
    assert math.hypot(x - 5, y - 5) < 2
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)


SIDE = WIDTH / 2 - 3  # mm: how far the tool's centre may go from the middle
# With the largest distance of the tool's centre from the middle; where lines meet there is more
# room on the inside.
CENTRELINES = {
    "line": (LINE, SIDE),
    "arc": ([(5, 5, math.tan(math.pi / 8)), (45, 45, 0)], SIDE),
    "lines that meet": ([(0, 0, 0), (40, 0, 0), (40, 40, 0)], WIDTH / 2 - 3 / math.sqrt(2)),
    "s": ([(0, 0, 0.5), (30, 0, -0.5), (60, 0, 0)], SIDE),
}


@pytest.mark.parametrize("name", CENTRELINES)
def test_an_open_sketch_is_the_centreline_of_a_slot(bench, name):
    b = bench(block_with(face_of(rectangle(-20, -40, 80, 60))))
    chain, side = CENTRELINES[name]
    op = b.done(on_line(b, chain, SlotWidth=WIDTH))
    line = op.Base[0][0].Shape
    at_floor = [p for p in points_of(op) if p[2] < -2.999]
    farthest = max(
        line.distToShape(Part.Vertex(Vector(x, y, -3)))[0] for x, y, _, _ in at_floor[::5]
    )
    assert farthest <= side + 1e-3 and farthest == pytest.approx(side, abs=0.15)
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)


def test_an_edge_is_a_centreline_too(slot):
    edges = slot.part.Shape.Edges
    (name,) = [
        "Edge%d" % n
        for n, e in enumerate(edges, 1)
        if e.BoundBox.ZMax < -2.9 and e.BoundBox.ZMin > -3.1 and e.BoundBox.YMax < 0.1
        if e.BoundBox.YMin > -0.1 and e.BoundBox.XLength > 50
    ]
    op = slot.done(trochoid(slot, [(slot.part, (name,))], SlotWidth=8.0))
    ys = [y for _, y, z, _ in points_of(op) if z < -2.999]
    assert max(ys) == pytest.approx(1, abs=0.01) and min(ys) == pytest.approx(-1, abs=0.01)


def test_an_open_sketch_without_slot_width_is_refused(slot):
    assert "set Slot width" in slot.refused(on_line(slot))


def test_a_slot_width_below_the_tool_is_refused(slot):
    sentence = slot.refused(on_line(slot, SlotWidth=5.0))
    assert "Slot width (5 mm)" in sentence and "6 mm" in sentence


def test_a_slot_narrower_than_the_tool_is_refused_with_the_largest_tool(bench):
    b = bench(block_with(face_of(rectangle(0, 0, 40, 5))))
    sentence = b.refused(trochoid(b))
    assert "does not fit" in sentence and "4.99" in sentence


REFUSED = {
    "crosses itself": [(0, 0, 0), (40, 0, 0), (40, 30, 0), (20, -20, 0)],
    "bends": [(0, 0, 0), (30, 0, 1), (30, 6, 0), (0, 6, 0)],
}


@pytest.mark.parametrize("word", REFUSED)
def test_a_centreline_that_gives_no_slot_is_refused(slot, word):
    sentence = slot.refused(on_line(slot, REFUSED[word], SlotWidth=WIDTH))
    assert word in sentence and "Sketch" in sentence


def centres_on(op, points):
    """For each (x, y), whether the tool's centre comes by at the floor."""
    at_floor = [(x, y) for x, y, z, _ in points_of(op) if z < -2.999]
    return [min(math.dist(p, q) for q in at_floor) < 1.5 for p in points]


@pytest.mark.parametrize("together", [True, False], ids=["one sketch", "two sketches"])
def test_centrelines_that_cross_are_one_slot(bench, together):
    b = bench(block_with(face_of(rectangle(-20, -40, 80, 60))))
    across = [(30, -25, 0), (30, 35, 0)]
    first = sketch_of(b.doc, LINE, closed=False)
    if together:
        first.addGeometry(Part.LineSegment(Vector(30, -25, 0), Vector(30, 35, 0)), False)
        base = [(first, "")]
    else:
        base = [(first, ""), (sketch_of(b.doc, across, closed=False), "")]
    b.doc.recompute()
    op = b.done(trochoid(b, base, SlotWidth=WIDTH))
    assert all(centres_on(op, [(10, 5), (50, 5), (30, -25), (30, 35)]))
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)
    area = 2 * (40 + 60) * WIDTH / 2 + 2 * math.pi * 25 - WIDTH**2
    assert op.RemovedVolume.Value == pytest.approx(3 * area, rel=0.01)


def test_a_t_of_centrelines_is_one_slot(bench):
    b = bench(block_with(face_of(rectangle(-20, -40, 80, 60))))
    sketch = sketch_of(b.doc, [(0, 0, 0), (30, 0, 0)], closed=False)
    for end in (Vector(60, 0, 0), Vector(30, 40, 0)):
        sketch.addGeometry(Part.LineSegment(Vector(30, 0, 0), end), False)
    b.doc.recompute()
    op = b.done(trochoid(b, [(sketch, "")], SlotWidth=WIDTH))
    assert all(centres_on(op, [(0, 0), (60, 0), (30, 40)]))
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)


def test_a_closed_centreline_gives_a_ring(bench):
    b = bench(block_with(face_of(rectangle(-40, -40, 40, 40))))
    sketch = b.doc.addObject("Sketcher::SketchObject", "Ring")
    sketch.addGeometry(Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 20), False)
    sketch.Placement.Base = Vector(0, 0, -3)
    b.doc.recompute()
    op = b.done(trochoid(b, [(sketch, "")], SlotWidth=WIDTH))
    radii = [math.hypot(x, y) for x, y, z, _ in points_of(op) if z < -2.999]
    assert min(radii) == pytest.approx(18, abs=0.01) and max(radii) == pytest.approx(22, abs=0.01)
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)


def test_a_slot_that_runs_out_of_the_stock_is_entered_from_outside(bench):
    b = bench(Part.makeBox(60, 40, 12, Vector(0, 0, -12)))
    sketch = sketch_of(b.doc, [(-20, 20, 0), (45, 20, 0)], closed=False)
    op = b.done(trochoid(b, [(sketch, "")], SlotWidth=WIDTH))
    at_floor = [(x, y) for x, y, z, _ in points_of(op) if z < -2.999]
    assert at_floor[0][0] < -3 and -12 < min(x for x, _ in at_floor)
    assert max(x for x, _ in at_floor) == pytest.approx(47, abs=0.01)
    assert op.UncutArea.Value == pytest.approx(0, abs=1e-3)
    area = 45 * WIDTH + math.pi * 25 / 2
    assert op.RemovedVolume.Value == pytest.approx(3 * area, rel=0.01)


def test_a_slot_outside_the_stock_is_refused(bench):
    b = bench(Part.makeBox(60, 40, 12, Vector(0, 0, -12)))
    sketch = sketch_of(b.doc, [(-80, 20, 0), (-45, 20, 0)], closed=False)
    assert "outside the stock" in b.refused(trochoid(b, [(sketch, "")], SlotWidth=WIDTH))


def test_a_slot_width_that_a_face_does_not_need_is_told(slot):
    op = slot.done(trochoid(slot, SlotWidth=8.0))
    assert "Slot width was not used for Face" in op.Report


def test_a_face_and_a_slot_that_overlap_are_refused(slot):
    (floor,) = floors_of(slot.model.Shape)
    sketch = sketch_of(slot.doc, [(30, 5, 0), (30, 40, 0)], closed=False)
    op = trochoid(slot, [(slot.model, (floor,)), (sketch, "")], SlotWidth=8.0)
    assert "overlap" in slot.refused(op)


def test_several_depths_reach_the_last(slot):
    op = slot.done(trochoid(slot, StepDown=1.25))
    levels = {round(z, 4) for _, _, z, _ in points_of(op)}
    assert {-1.25, -2.5, -3.0} <= levels


def test_it_survives_saving_and_recomputes_the_same(slot, tmp_path):
    op = on_line(slot, SlotWidth=9.0, Pattern="Circular")
    before = slot.done(op).Path.toGCode()
    name = op.Name
    with reopened(slot.doc, tmp_path / "saved.FCStd") as doc:
        op = doc.getObject(name)
        assert type(op.Proxy).__name__ == "Trochoid"
        assert type(op.Proxy).__module__ == "evenload.operations.trochoid"
        assert op.Pattern == "Circular" and op.SlotWidth.Value == pytest.approx(9)
        op.touch()
        doc.recompute()
        assert op.isValid() and op.Path.toGCode() == before


def test_the_posted_program_runs(slot, rs274, tmp_path):
    from evenload import host

    slot.done(trochoid(slot))
    text = host.post(slot.job, "linuxcnc", "--no-show-editor --precision 4")
    assert rs274(text, tmp_path).count("ARC_FEED") > 50
