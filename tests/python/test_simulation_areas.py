"""Rest and gouges as areas in space."""

import math

import numpy
import pytest
from evenload.pictures import areas
from simulated_paths import AROUND, GOUGED, RADIUS, line_at, simulated


def area_of(polygon):
    x, y = polygon[:, 0], polygon[:, 1]
    return 0.5 * abs(numpy.dot(x, numpy.roll(y, -1)) - numpy.dot(y, numpy.roll(x, -1)))


def test_rest_lies_on_what_is_left_and_has_its_area():
    run = simulated(line_at(1.5), part=[GOUGED])
    found = areas.rest_areas(run)
    assert sum(map(area_of, found)) == pytest.approx(run.rest_area, rel=0.01)
    assert all((polygon[:, 2] == 0).all() for polygon in found)  # the stock's top


def test_rest_on_a_step_lies_at_its_height():
    run = simulated(line_at(1.5, z=-1.0), stock=AROUND)
    heights = {round(float(p[0, 2]), 6) for p in areas.rest_areas(run)}
    assert -1.0 in heights and heights <= {0.0, -1.0}


def test_a_gouge_is_the_segment_of_the_tool_beyond_the_wall():
    run = simulated(line_at(1.5), part=[GOUGED])
    found = areas.gouge_areas(run)
    half = math.acos((RADIUS - 0.05) / RADIUS)
    segment = RADIUS**2 * (half - math.sin(half) * math.cos(half))
    middle = [p for p in found if abs(p[:, 0].mean()) < 20]
    assert len(middle) > 100
    for polygon in middle:
        assert area_of(polygon) == pytest.approx(segment, rel=0.15)
        assert polygon[:, 1].max() < -1.45 and polygon[:, 1].min() == pytest.approx(-1.5, abs=1e-3)
        assert (polygon[:, 2] == 0).all()  # the wall's top, where it can be seen


def test_in_the_floor_a_gouge_is_all_of_the_tool():
    run = simulated(line_at(1.5), part=[(AROUND, -2.9)])
    middle = [p for p in areas.gouge_areas(run) if abs(p[:, 0].mean()) < 20]
    assert middle
    for polygon in middle:
        assert area_of(polygon) == pytest.approx(math.pi * RADIUS**2, rel=1e-3)
        assert (polygon[:, 2] == -2.9).all()


def test_a_path_without_faults_has_no_areas():
    run = simulated(line_at(1.5), part=[(-30, -30, 30, -1.5), (-30, 4.5, 30, 30)])
    assert areas.gouge_areas(run) == [] and areas.rest_areas(run) == []
