"""Several regions in one operation: all of them are cleared, one after the other, with a retract
between them.
"""

import math
import re

import pytest
from conftest import check_path, moves_of
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, circle, face_of, floors_of, sketch_of

pytestmark = pytest.mark.core

FACES = [face_of(SQUARE), face_of(circle(60, 15, 12))]
AT_FLOOR = [face.translated(Vector(0, 0, -DEPTH)) for face in FACES]
SPLIT = 40  # mm: x between the two
HOLE = {"HoleDiameter": 8, "EntryPoint": Vector(15, 15, 0)}


@pytest.fixture
def two(bench):
    """A Bench with two pockets."""
    return bench(block_with(*FACES))


def order_of(op, levels):
    """[(which region, level), ...] in the order in which the path works there."""
    result = []
    for name, _, end, *_ in moves_of(op):
        if name != "G0" and any(abs(end[2] - level) < 1e-6 for level in levels):
            visit = int(end[0] > SPLIT), round(end[2], 6)
            if not result or result[-1] != visit:
                result.append(visit)
    return result


def check_crossings(op):
    """Every way from one region to another runs above everything, in rapids."""
    crossings = 0
    for name, start, end, *_ in moves_of(op):
        if start[0] is not None and (start[0] > SPLIT) != (end[0] > SPLIT):
            crossings += 1
            assert name == "G0" and start[2] == end[2] == op.ClearanceHeight.Value
    return crossings


@pytest.mark.parametrize("step, levels", [(3.0, [-3.0]), (1.5, [-1.5, -3.0])])
@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize("kind", ["faces", "sketches"])
def test_regions_are_finished_one_by_one_in_the_order_of_the_base(two, kind, first, step, levels):
    if kind == "faces":
        shape = two.model.Shape
        names = sorted(floors_of(shape), key=lambda name: shape.getElement(name).CenterOfMass.x)
        base = [(two.model, (names[k],)) for k in (first, 1 - first)]
    else:
        chains = [SQUARE, circle(60, 15, 12)]
        sketches = [sketch_of(two.doc, chain) for chain in chains]
        base = [(sketches[k], "") for k in (first, 1 - first)]
    op = two.done(two.operation(base=base, StepDown=step))
    check_path(op, AT_FLOOR)
    assert order_of(op, levels) == [(k, level) for k in (first, 1 - first) for level in levels]
    assert check_crossings(op) == 1
    assert op.UncutArea.Value == 0
    assert op.RemovedVolume.Value == pytest.approx(
        DEPTH * sum(face.Area for face in FACES), rel=0.03
    )


def test_a_hole_serves_its_region_and_the_other_gets_an_entry_of_its_own(two):
    op = two.done(two.operation(StepDown=1.5, **HOLE))
    check_path(op, AT_FLOOR)
    descents = [
        (name, start, end)
        for name, start, end, *_ in moves_of(op)
        if name != "G0" and end[2] < start[2] - 1e-6
    ]
    in_hole = [d for d in descents if d[2][0] < SPLIT]
    beside = [d for d in descents if d[2][0] > SPLIT]
    assert [end for _, _, end in in_hole] == [(15, 15, -1.5), (15, 15, -3)]
    straight = [end[2] for name, _, end in beside if name == "G1"]
    assert straight == pytest.approx([0.05, -1.45])  # in the air, to just above each level's top
    assert {name for name, *_ in beside} == {"G1", "G3"}
    assert all(math.dist(end[:2], (60, 15)) < 3 for _, _, end in beside)
    assert check_crossings(op) == 1


def test_with_the_hole_as_the_only_entry_the_other_region_is_left_and_reported(two):
    op = two.done(two.operation(Entry="Predrilled hole", **HOLE))
    check_path(op, AT_FLOOR[:1])
    assert all(x is None or x < SPLIT for _, _, (x, _, _), *_ in moves_of(op))
    place = re.search(r"The region near \((\S+), (\S+)\), which does not hold", op.Report)
    assert math.dist([float(v) for v in place.groups()], (60, 15)) < 12
    assert op.UncutArea.Value == pytest.approx(math.pi * 12**2, rel=0.01)


def test_a_region_that_the_tool_does_not_fit_is_skipped_and_reported(bench):
    b = bench(block_with(face_of(SQUARE), face_of(circle(60, 15, 2.5))))
    op = b.done(b.operation())
    check_path(op, AT_FLOOR[:1])
    assert "The pocket near (60.00, 15.00) was skipped." in op.Report
    assert "largest tool that fits has 4.99" in op.Report
