"""What the proof of a path takes: paths and their extent, points, heights, distances."""

import math

import numpy
import pytest
from evenload import compiled

core = compiled.core()
DOWN = [(0, 20, 0, 5, 0, 0, 0, 0), (3, 20, 0, -1, 0, 0, 0, 600)]
RING = [*DOWN, (3, -20, 0, -1, math.pi, 0, 0, 600), (3, 20, 0, -1, math.pi, 0, 0, 600)]
SQUARE = numpy.array([(0, 0, 2), (10, 0, 2), (10, 10, 2), (0, 10, 2)], float)
FACES = numpy.array([(0, 1, 2), (0, 2, 3)])


def test_arcs_reach_as_far_as_they_bulge():
    low, high, levels = core.extent_of(RING)
    assert low == pytest.approx((-20, -20, -1)) and high == pytest.approx((20, 20, 5))
    assert levels == pytest.approx([-1])


def test_a_program_has_the_extent_of_its_moves_and_none_without_any():
    program = core.read_gcode("G21 G90\nG0 Z5\nG0 X0 Y0\nG1 Z-2 F100\nG1 X30\nG1 Z-3\nG1 X0\n")
    low, high, levels = core.extent_of(program)
    assert (low, high) == ((0, 0, -3), (30, 0, 5)) and levels == pytest.approx([-2, -3])
    assert core.extent_of(core.read_gcode("G21\n")) == (None, None, [])


def test_a_gouge_in_the_middle_of_an_arc_is_found():
    stock = core.HeightMap(SQUARE, FACES)
    wall = numpy.array([(0.0, 23.0 - 0.1, 0.0)])
    (fault,) = core.faults_of(RING, tool_diameter=6, bodies=wall, stock=stock)
    assert fault[0] == "gouge" and fault[1] == pytest.approx(0.1) and fault[3] == 2


def test_no_more_than_the_rim_of_a_tool_may_touch_what_stands():
    # The square is 2 mm high; the tool goes down beside it, 0.025 mm within its edge x = 10.
    path = [(0, 12.975, 5, 5, 0, 0, 0, 0), (3, 12.975, 5, 0, 0, 0, 0, 600)]
    stock = core.HeightMap(SQUARE, FACES)
    options = {"tool_diameter": 6, "bodies": numpy.zeros((0, 3)), "stock": stock}
    ((kind, amount, *_),) = core.faults_of(path, rim=0.02, **options)
    assert kind == "plunge" and amount == pytest.approx(2)
    assert core.faults_of(path, rim=0.03, **options) == []


def test_distances_are_to_the_nearest_line():
    points = numpy.array([(0, 0), (5, 3), (20, 4)], float)
    starts, ends = numpy.array([(0, 1), (9, 9)], float), numpy.array([(10, 1), (9, 20)], float)
    found = core.distances(points, starts, ends)
    assert found == pytest.approx([1, 2, math.hypot(10, 3)])
    none = numpy.zeros((0, 2))
    assert (core.distances(points, none, none) == math.inf).all()


@pytest.mark.parametrize(
    "call",
    [
        lambda: core.HeightMap(SQUARE[:, :2], FACES),
        lambda: core.HeightMap(SQUARE, numpy.array([(0, 1, 4)])),
        lambda: core.HeightMap(SQUARE * math.nan, FACES),
        lambda: core.HeightMap(SQUARE, FACES).raster(0, 0, 1, 1, 0),
        lambda: core.distances(SQUARE, SQUARE[:, :2], SQUARE[:, :2]),
        lambda: core.distances(SQUARE[:, :2], SQUARE[:1, :2], SQUARE[:, :2]),
        lambda: core.faults_of(
            RING, tool_diameter=0, bodies=SQUARE, stock=core.HeightMap(SQUARE, FACES)
        ),
    ],
)
def test_what_cannot_be_taken_is_a_value_error(call):
    with pytest.raises(ValueError):
        call()


def test_outlines_of_many_polygons_are_one():
    squares = [[(i, 0), (i + 1, 0), (i + 1, 1), (i, 1)] for i in range(3)]
    (outline,) = core.united(squares, 1e-4)
    assert sorted(map(tuple, numpy.round(outline, 6))) == [(0, 0), (0, 1), (3, 0), (3, 1)]
