"""Places that Report names are places of the part, whichever way round the tool cuts."""

import math
import re

import pytest
from conftest import points_of
from FreeCAD import Vector
from models import block_with, face_of, rectangle

ROUND = math.tan(math.pi / 8)  # bulge of a quarter of a circle
# 30 mm square with one sharp corner, at (40, 70).
DROP = [
    (40, 70, 0),
    (64, 70, ROUND),
    (70, 76, 0),
    (70, 94, ROUND),
    (64, 100, 0),
    (46, 100, ROUND),
    (40, 94, 0),
]
MODES = ["Climb", "Conventional"]


def place_in(report, words):
    """The (x, y) of the line of a report that has the words."""
    (line,) = [line for line in report.splitlines() if words in line]
    x, y = re.search(r"near \((-?[\d.]+), (-?[\d.]+)\)", line).groups()
    return float(x), float(y)


@pytest.mark.parametrize("mode", MODES)
def test_what_is_left_uncut_is_where_the_report_says(bench, mode):
    face = face_of(DROP)
    b = bench(block_with(face))
    op = b.done(b.operation(CutMode=mode, WallPass=False, RollRadius=2, MinimumRadius=2))
    place = place_in(op.Report, "Left uncut")
    assert face.isInside(Vector(*place, 0), 1e-6, True)
    assert min(math.dist(p[:2], place) for p in points_of(op)) > 3 - 0.05
    # In the corner, between the circles that touch both of its walls.
    assert max(abs(place[0] - 40), abs(place[1] - 70)) < 3


@pytest.mark.parametrize("mode", MODES)
def test_the_tightest_turn_is_where_the_report_says(bench, mode):
    b = bench(block_with(face_of(DROP)))
    op = b.done(b.operation(CutMode=mode, MinimumRadius=50))  # so that all is too narrow
    place = place_in(op.Report, "Turned more tightly")
    assert min(math.dist(p[:2], place) for p in points_of(op)) < 0.02


@pytest.mark.parametrize("mode", MODES)
def test_a_hole_too_near_to_a_wall_is_named_where_it_is(bench, mode):
    b = bench(block_with(face_of(rectangle(40, 70, 70, 90))))
    op = b.operation(CutMode=mode, Entry="Predrilled hole", HoleDiameter=8)
    op.EntryPoint = Vector(69, 80, 0)
    assert "EntryPoint" in b.refused(op)
    op.EntryPoint = Vector(100, 80, 0)
    assert "Hole at (EntryPoint) is (100, 80), outside" in b.refused(op)
    op.EntryPoint = Vector(62, 76, 0)
    first = next(p for p in points_of(b.done(op)) if p[2] < 0)
    assert first[:2] == (62, 76)
