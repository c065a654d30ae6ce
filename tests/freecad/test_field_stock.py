"""What failed in users' hands where part and stock were not as operations took them to be."""

import math

import Part
import pytest
from conftest import moves_of, solid_in_tool
from evenload import host, job_simulation
from FreeCAD import Placement, Rotation, Vector
from models import floors_of, rectangle, sketch_of, wire, with_rectangle


def upward_floors(shape, z):
    return tuple(n for n in floors_of(shape, z) if shape.getElement(n).normalAt(0, 0).z > 0.9)


# ---- sides that are open at the top only ----


def test_an_outline_on_the_stocks_top_is_the_limit_down_to_the_final_depth(bench):
    b = bench(Part.makeBox(60, 40, 20))
    outline = b.doc.addObject("Part::Feature", "Rectangle")
    outline.Shape = Part.Face(wire(rectangle(12, 12, 42, 27))).translated(Vector(0, 0, 20))
    op = b.operation([(outline, "")], StartDepth=20, FinalDepth=15, StepDown=5)
    b.done(op)
    found = job_simulation.read(op).simulate()
    assert found.plunge_in_material_mm < 0.01
    for x, y, z in zip(found.x, found.y, found.z):
        assert z > 19.99 or (14.99 < x < 39.01 and 14.99 < y < 24.01), (x, y, z)


# ---- what stands above a floor ----


@pytest.mark.parametrize("askew", [0, 1e-8])
def test_the_lips_over_a_t_slots_floor_stay(bench, askew):
    slot = Part.makeBox(80, 10, 20, Vector(0, 20, 6)).fuse(
        Part.makeBox(80, 20, 5, Vector(0, 15, 6))
    )
    part = Part.makeBox(80, 50, 20).cut(slot)
    part.rotate(Vector(), Vector(1, 1, 0), math.degrees(askew))
    b = bench(part)
    op = b.operation([(b.model, upward_floors(b.model.Shape, 6))], StartDepth=21, FinalDepth=6)
    b.set(op, StepDown=15)
    volume, at = solid_in_tool(b.done(op), b.model.Shape, 6, 20)
    assert volume < 0.1, at
    assert "lies partly under the model" in op.Report


def test_a_pin_of_another_model_in_a_pocket_stays(bench):
    b = bench(with_rectangle(80, 50, 20, 60, 30, 8, margin=10))
    pin = b.doc.addObject("Part::Feature", "Pin")
    pin.Shape = Part.makeCylinder(6, 8, Vector(40, 25, 12))
    b.job, b.controller = host.create_job(b.doc, [b.part, pin], 6.0, 255, 6366, 1)
    b.model = b.job.Model.Group[0]
    op = b.operation([(b.model, upward_floors(b.model.Shape, 12))], StartDepth=20, FinalDepth=12)
    b.set(op, StepDown=8)
    volume, at = solid_in_tool(b.done(op), pin.Shape, 6, 20)
    assert volume < 0.1, at
    assert "lies partly under the model" in op.Report


# ---- stock as it stands ----


def test_in_a_blank_with_a_recess_no_rapid_goes_into_what_stands_under_it(bench):
    b = bench(with_rectangle(60, 40, 20, 50, 30, 18, margin=5))
    blank = Part.makeBox(60, 40, 20).cut(Part.makeBox(30, 20, 15, Vector(15, 10, 5)))
    b.set_stock(blank)
    floor = [(b.model, upward_floors(b.model.Shape, 2))]
    op = b.operation(floor, StartDepth=20, FinalDepth=2, StepDown=9, UseRestMachining=True)
    b.done(op)
    under = 5 - 1e-6  # the recess ends there; before the first cut below nothing of it is gone
    for name, start, end, *_ in moves_of(op):
        if None in start or min(start[2], end[2]) >= under:
            continue
        if name == "G0":
            tool = Part.makeCylinder(2.9, 5 - end[2], Vector(*end))
            assert tool.common(blank).Volume < 0.1, end
        break
    else:
        pytest.fail("nothing was cut under the recess")


def test_a_centreline_on_the_stocks_top_is_cut_from_start_to_final_depth(bench):
    b = bench(Part.makeBox(100, 60, 10, Vector(0, 0, -10)))
    line = sketch_of(b.doc, [(15, 30, 0), (85, 30, 0)], z=0, closed=False)
    slot = {"SlotWidth": 10, "FinalDepth": -4, "StepDown": 4}
    op = b.done(b.operation([(line, "")], kind="trochoid", **slot))
    assert min(end[2] for _, _, end, *_ in moves_of(op) if end[2] is not None) == -4


def test_a_floor_below_the_stock_is_told(bench):
    b = bench(Part.makeBox(60, 15, 40).cut(Part.makeBox(40, 6, 20, Vector(10, 0, 10))))
    stock = b.job.Stock.Shape.copy()
    b.model.Placement = Placement(Vector(), Rotation(Vector(1, 0, 0), -90))
    b.set_stock(stock)  # where it was, as FreeCAD 0.20 leaves it
    op = b.operation([(b.model, upward_floors(b.model.Shape, -6))], FinalDepth=-6, StepDown=6)
    assert "lies 6 mm below the underside of the stock" in b.refused(op)
