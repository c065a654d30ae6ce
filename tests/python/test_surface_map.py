"""The map of what a tool leaves, by the core: what it is asked with, and what it answers."""

import math

import numpy
import pytest

from evenload import compiled

pytestmark = pytest.mark.core

core = compiled.core()
BALL, STEP = 5.0, 0.4
POINTS = numpy.array([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], float)
TRIANGLES = [(0, 1, 2), (0, 2, 3)]
RAPID, CUT = 0, 3


def passes():
    """Along x, there and back, on z = 0."""
    ends = [(way * (-1) ** k * 12, k * STEP) for k in range(-10, 11) for way in (1, -1)]
    moves = [(CUT, x, y, 0, 0, 0, 0, 1600) for x, y in ends]
    return [(RAPID, *moves[0][1:7], 0), *moves[1:]]


def mapped(picked=(True, True), moves=None, **changes):
    arguments = dict(tool_diameter=2 * BALL, corner_radius=BALL, first=(-2.0, -1.0), spacing=0.1)
    arguments.update(cells=(40, 20), stock=0.3, **changes)
    part = core.HeightMap(POINTS, TRIANGLES)
    return core.surface_map(part, picked, passes() if moves is None else moves, **arguments)


def test_arrays_have_a_row_for_each_y():
    found = mapped()
    assert all(values.shape == (20, 40) for values in found.values())
    assert (found["part"] == 0).all() and (found["lean"] == 1).all()
    assert found["is_picked"].all() and (found["move"] > 0).all()
    cusps = found["cusp"][numpy.isfinite(found["cusp"])]
    assert len(cusps) > 100
    assert cusps == pytest.approx(BALL - math.sqrt(BALL**2 - STEP**2 / 4), abs=1e-9)


def test_a_toolpath_s_first_move_only_says_where_the_tool_is():
    found = mapped(moves=[(CUT, 0, 0, 0, 0, 0, 0, 0), (RAPID, 0, 0, 30, 0, 0, 0, 0)])
    # Up from there, the ball has been at its place.
    assert found["above"].min() == pytest.approx(0, abs=1e-3)
    assert set(numpy.unique(found["move"])) == {-1, 1}


def test_what_is_picked_is_told_for_each_triangle():
    assert not mapped(picked=(False, False))["is_picked"].any()
    with pytest.raises(ValueError, match="For each triangle"):
        mapped(picked=(True,))


def test_teeth_need_feeds():
    moves = passes()
    moves[5] = (*moves[5][:7], 0.0)
    with pytest.raises(ValueError, match="Move 5 has no feed"):
        mapped(moves=moves, teeth_per_minute=20000.0)


def test_unknown_words_and_wrong_types_are_refused():
    with pytest.raises(TypeError, match="knows no argument 'depth'"):
        mapped(depth=1.0)
    with pytest.raises(TypeError, match="'threads' has the wrong type"):
        mapped(threads="two")


def test_it_stops_when_asked():
    with pytest.raises(core.dynamics.Cancelled):
        mapped(progress=lambda share: False)
