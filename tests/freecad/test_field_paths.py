"""What failed in users' hands in the paths themselves."""

import math

import Part
import pytest
from conftest import moves_of
from evenload import host, job_simulation
from FreeCAD import Vector
from models import floors_of, rectangle, sketch_of, with_rectangle


def on_floor(bench, z, kind="adaptive", **properties):
    """An operation on the floor at z, in one step from the model's top."""
    top = bench.model.Shape.BoundBox.ZMax
    depths = {"StartDepth": top, "FinalDepth": z, "StepDown": top - z}
    floor = [(bench.model, tuple(floors_of(bench.model.Shape, z)))]
    return bench.operation(floor, kind, **{**depths, **properties})


@pytest.mark.parametrize("kind", ["adaptive", "trochoid", "lame_spiral"])
def test_freecads_dogbone_of_a_pocket_has_numbers_as_they_should_be(bench, kind):
    b = bench(with_rectangle(60, 50, 12, 35, 30, 5, margin=10))
    op = b.done(on_floor(b, 7.0, kind))
    dressed = host.dressup("Dogbone").Create(op)
    b.doc.recompute()
    words = [(k, v) for c in dressed.Path.Commands for k, v in c.Parameters.items() if k in "XYZIJ"]
    assert len(words) > 100
    assert [(k, v) for k, v in words if not abs(v) < 1e3] == []


@pytest.mark.parametrize("kind", ["adaptive", "trochoid", "lame_spiral"])
def test_no_line_goes_straight_back_on_the_one_before(bench, kind):
    b = bench(with_rectangle(60, 50, 12, 35, 30, 5, margin=10))
    moves = moves_of(b.done(on_floor(b, 7.0, kind)))
    for (first, a, p, *_), (second, _, c, *_) in zip(moves, moves[1:]):
        if first != "G1" or second != "G1" or None in a:
            continue
        before = math.atan2(p[1] - a[1], p[0] - a[0]) if a[:2] != p[:2] else None
        after = math.atan2(c[1] - p[1], c[0] - p[0]) if p[:2] != c[:2] else None
        if before is not None and after is not None:
            turn = abs(math.remainder(after - before, 2 * math.pi))
            assert turn < math.radians(179), (a, p, c)


def test_in_a_wide_pocket_turns_are_as_wide_as_wished_and_nothing_is_noted(bench):
    b = bench(with_rectangle(60, 40, 15, 40, 20, 6, margin=10))
    op = b.done(on_floor(b, 9.0))
    corners = [(x, y) for x in (13, 47) for y in (13, 27)]
    for name, start, end, centre, _ in moves_of(op):
        if not centre or math.dist(start[:2], centre) >= 0.4:
            continue
        x, y = end[:2]
        to_wall = min(x - 13, 47 - x, y - 13, 27 - y)
        assert to_wall < 0.5 or min(math.dist((x, y), c) for c in corners) < 5, (x, y)
    assert "Turned more tightly" not in op.Report


def test_after_a_bored_ring_the_removed_volume_is_what_the_path_removes(bench):
    b = bench(with_rectangle(60, 45, 20, 44, 30, 10, margin=8))
    lines = ["G0 Z25", "G0 X34 Y22.5", "G0 Z20.5"]
    for middle, end in [(19.5 - k, 19 - k) for k in range(10)] + [(10, 10)]:
        lines.append("G3 X26 Y22.5 Z%g I-4 J0 F600" % middle)
        lines.append("G3 X34 Y22.5 Z%g I4 J0 F600" % end)
    before = host.freecads("Custom", "Bore", b.job, b.controller)
    before.Gcode = [*lines, "G0 Z25"]
    op = b.done(on_floor(b, 10.0, UseRestMachining=True))
    removed = job_simulation.read(op).simulate().removed_volume_total
    assert op.RemovedVolume.Value == pytest.approx(removed, rel=0.02)
    feed = op.ToolController.HorizFeed.Value
    ideal = removed / (10.0 * op.SideStep.Value * feed)
    assert op.IdealTime == pytest.approx(ideal, rel=0.03)


def test_along_a_closed_frame_trochoids_are_repeated(bench):
    b = bench(Part.makeBox(120, 80, 10, Vector(0, 0, -10)))
    frame = sketch_of(b.doc, rectangle(25, 20, 95, 60), z=-4)
    op = b.operation([(frame, "")], "trochoid", SlotWidth=10, FinalDepth=-4, StepDown=4)
    b.done(op)
    assert op.TrochoidalStep.Value > 0 and "No trochoid was repeated" not in op.Report
    # Without repeated trochoids it is 1.54; corners are cleared pass by pass.
    assert op.CuttingTime < 1.45 * op.IdealTime
