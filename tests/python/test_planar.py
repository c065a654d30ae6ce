"""Moves as lines and as places to draw: planar.py."""

import math

import numpy
from evenload import planar

# A rapid to (10, 0), half a turn about the origin that rises by 2 mm, and a line.
MOVES = [
    (planar.RAPID, 10.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0),
    (planar.CUT, -10.0, 0.0, 7.0, math.pi, 0.0, 0.0, 800.0),
    (planar.LINK, -10.0, 30.0, 7.0, 0.0, 0.0, 0.0, 900.0),
]


def test_lines_in_place_of_an_arc_keep_to_it_and_to_its_kind_and_feed():
    lines = planar.as_lines(MOVES)
    assert not lines[:, 4].any()
    arc = lines[lines[:, 0] == planar.CUT]
    assert numpy.allclose(numpy.hypot(arc[:, 1], arc[:, 2]), 10.0)
    assert set(arc[:, 7]) == {800.0} and arc[-1, 3] == 7.0
    chord = numpy.hypot(*numpy.diff(arc[:, 1:3], axis=0).T).max()
    assert 10 - math.sqrt(100 - (chord / 2) ** 2) < 0.002
    assert numpy.allclose(lines[-1], MOVES[-1])


def test_places_to_draw_tell_the_kind_of_their_move():
    points, kinds = planar.drawn(MOVES)
    assert kinds[0] == planar.RAPID and kinds[-1] == planar.LINK
    assert points[kinds == planar.CUT][:, 1].max() > 9.9
