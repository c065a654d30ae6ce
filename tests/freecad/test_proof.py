"""The check of computed paths against the job: what it finds, and what it does with it."""

import math

import faulty_paths
import FreeCAD
import Part
import Path
import pytest
import random_jobs
from evenload import host, proof
from evenload import tool as tools
from evenload.settings.notes import CHECKED
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, face_of, rectangle, sketch_of

pytestmark = pytest.mark.between

SEEDS = (0, 1, 2, 13)  # of jobs of all kinds
OTHERS = (3, 5, 6, 10, 16, 18, 23, 26)


@pytest.fixture(
    scope="module",
    params=[*SEEDS, *(pytest.param(seed, marks=pytest.mark.core) for seed in OTHERS)],
)
def computed(request):
    """The Job of a seed with its operations computed."""
    doc = FreeCAD.newDocument("Faults")
    made = random_jobs.make(doc, request.param)
    doc.recompute()
    yield made
    FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("kind", faulty_paths.KINDS)
def test_a_fault_that_is_put_into_a_path_is_found_with_its_place(computed, kind):
    for op in computed.operations:
        if not op.isValid() or len(op.Path.Commands) < 3:
            continue
        radius = tools.diameter(op.ToolController) / 2
        whole = op.Path
        found = faulty_paths.with_fault(
            whole.Commands, kind, computed.models, computed.stock, radius
        )
        if found is None:
            continue
        commands, place = found
        op.Path = Path.Path(commands)
        try:
            faults = proof.check(op)
        finally:
            op.Path = whole
        assert faults, (kind, place)
        near = [f for f in faults if math.dist(f.at[:2], place[:2]) < 2 * radius + 1]
        assert near and (kind == "gouge" or any(f.kind == kind for f in near)), (faults, place)
        assert all("%.3f" % f.at[0] in f.sentence for f in faults)


def test_a_path_with_a_fault_makes_the_operation_invalid(bench, monkeypatch):
    on = bench(block_with(face_of(SQUARE)))
    op = on.operation()
    fault = proof.Fault("gouge", 1.0, (1.0, 2.0, 3.0), 7, "The path cuts 1.000 mm into 'Part'.")
    monkeypatch.setattr(proof, "check", lambda operation: [fault])
    op.touch()
    on.doc.recompute()
    assert not op.isValid() and op.Path.Commands == [] and op.Report == fault.sentence


def test_the_report_says_whether_a_path_was_checked(bench):
    on = bench(block_with(face_of(SQUARE)))
    op = on.done(on.operation())
    assert op.Report.splitlines()[-1] == CHECKED
    op.Check = False
    assert on.done(op).Report.splitlines()[-1] == "Not checked against the model: %s is off." % (
        "Check"
    )


def test_what_the_model_has_in_the_way_of_an_outline_may_be_cut(bench):
    on = bench(block_with(face_of(rectangle(60, 60, 70, 70))))
    sketch = sketch_of(on.doc, SQUARE, z=0.0)
    on.done(on.operation([(sketch, "")]))


def test_beyond_an_outline_nothing_may_be_cut(bench):
    on = bench(block_with(face_of(SQUARE)))
    sketch = sketch_of(on.doc, rectangle(5, 5, 25, 25), z=0.0)
    op = on.done(on.operation([(sketch, "")]))
    out = [Path.Command("G1", {"X": 15.0, "Y": y, "F": 5.0}) for y in (8.06 - 0.12, 15.0)]
    last = max(i for i, c in enumerate(op.Path.Commands) if c.Name != "G0")
    commands = op.Path.Commands
    down = [Path.Command("G1", {"X": 15.0, "Y": 15.0, "Z": -DEPTH, "F": 5.0})]
    op.Path = Path.Path([*commands[: last + 1], *down, *out, *commands[last + 1 :]])
    (fault,) = proof.check(op)
    assert fault.kind == "gouge" and fault.amount == pytest.approx(0.06, abs=3e-3)
    assert fault.at[:2] == pytest.approx((15, 5), abs=0.3)


def test_a_coarse_tolerance_hides_no_plunge_at_the_edge_of_the_stock(bench):
    on = bench(block_with(face_of(SQUARE)))
    op = on.done(on.operation(Tolerance=0.2))
    x = on.job.Stock.Shape.BoundBox.XMin - 3.0 + 0.1  # the rim of the tool of 6 mm is over it
    op.Path = Path.Path(
        [
            Path.Command("G0", {"X": x, "Y": 15.0, "Z": 5.0}),
            Path.Command("G1", {"X": x, "Y": 15.0, "Z": -DEPTH, "F": 5.0}),
        ]
    )
    (fault,) = proof.check(op)
    assert fault.kind == "plunge" and fault.amount == pytest.approx(DEPTH, abs=0.03)


def test_both_sides_of_a_slot_are_its_border(bench):
    on = bench(Part.makeBox(100, 60, 10, Vector(0, 0, -10)))
    line = sketch_of(on.doc, [(15, 30, 0), (85, 30, 0)], z=0.0, closed=False)
    op = on.done(on.operation([(line, "")], kind="trochoid", SlotWidth=10))
    assert proof.check(op) == []
    op.SlotWidth = 9.9  # the path is the one of 10 mm still
    (fault,) = proof.check(op)
    assert fault.kind == "gouge" and fault.amount == pytest.approx(0.05, abs=0.01)


def test_earlier_operations_have_cut_before(bench):
    on = bench(block_with(face_of(SQUARE)), tool=6.0)
    on.done(on.operation())
    second = on.done(on.operation(Entry="Ramp"))
    down = [
        Path.Command("G0", {"X": 15.0, "Y": 15.0, "Z": 5.0}),
        Path.Command("G0", {"X": 15.0, "Y": 15.0, "Z": -DEPTH}),
        Path.Command("G0", {"X": 15.0, "Y": 15.0, "Z": 5.0}),
    ]
    second.Path = Path.Path(down)
    assert proof.check(second) == []
    on.job.Operations.Group = list(reversed(on.job.Operations.Group))
    (fault,) = proof.check(second)
    assert fault.kind == "rapid" and fault.amount == pytest.approx(DEPTH, abs=1e-3)


def test_stock_above_the_start_depth_is_named_or_cut_before(bench):
    on = bench(block_with(face_of(SQUARE)))
    host.set_stock_margin(on.job, 2.0)
    op = on.operation(StartDepth=0.0)
    on.refused(op)
    assert "Material stands up to 2 mm, above Start Depth (0 mm)" in op.Report
    first = on.operation(StartDepth=2.0, FinalDepth=0.0, StepDown=2.0)
    on.job.Operations.Group = [first, op]
    on.done(first)
    assert CHECKED in on.done(op).Report


def test_faces_under_the_stock_are_refused(bench):
    on = bench(block_with(face_of(SQUARE)))
    on.job.Stock.Placement.Base = Vector(0, 0, 100)
    on.doc.recompute()
    op = on.operation(StartDepth=100.0, FinalDepth=-DEPTH)
    if on.job.Stock.Shape.BoundBox.ZMin > 0:
        on.refused(op)
        assert "below the underside of the stock" in op.Report
