"""Picking a hole in the 3D view (see gui_hole_session.py)."""

import FreeCAD
import Part
import pytest
from conftest import in_gui
from evenload.gui.hole_pick import hole_of

UP, ASLANT = FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(0, 1, 1)


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_hole_session.py reports."""
    return in_gui("gui_hole_session.py", tmp_path_factory.mktemp("hole"))


def test_a_click_on_a_rim_takes_the_hole(session):
    for where in ("rim", "seam"):
        assert session[where] == pytest.approx([9, 21, 8.5, False]), where
    assert session["fields"] == ["8.50 mm", "9.00 mm", "21.00 mm"]


def test_a_click_elsewhere_takes_the_place_alone(session):
    x, y, diameter, is_on = session["floor"]
    assert [x, y] == pytest.approx([20, 5], abs=0.2) and diameter == 8.5 and not is_on


def test_clicks_count_only_while_one_is_asked_for(session):
    assert session["asks"] == [True, 1]
    assert session["not_asked"] == [0, 0, 0, False]
    assert session["nothing"] == [0, 0, 0, True]
    assert session["ended"] == session["rim"]
    assert session["base"] and not session["helix"]


def test_a_click_takes_the_place_near_an_open_side(session):
    assert session["side_offered"] == [False, True]
    x, y, is_chosen, is_on = session["side"]
    assert [x, y] == pytest.approx([20, 5], abs=0.2) and is_chosen and not is_on
    assert session["side_fields"] == ["%.2f mm" % value for value in (x, y)]


def test_it_ends_with_its_panel(session):
    assert session["left"] == 0 and session["cancelled"] == [0, 0]


@pytest.mark.parametrize("axis", [UP, -UP])
def test_upright_circles_and_cylinders_are_holes(axis):
    centre = FreeCAD.Vector(3, -4, 7)
    circle = Part.Circle(centre, axis, 2.5)
    quarter = Part.ArcOfCircle(circle, 0.2, 1.7).toShape()
    wall = Part.makeCylinder(2.5, 9, centre, axis).Faces[0]
    for shape in (circle.toShape(), quarter, wall):
        assert hole_of(shape) == pytest.approx((3, -4, 5))


def test_others_are_none():
    ball = Part.makeSphere(4).Faces[0]
    line = Part.makeLine(FreeCAD.Vector(), UP)
    slanting = Part.Circle(FreeCAD.Vector(), ASLANT, 2).toShape()
    for shape in (ball, line, slanting, Part.makeBox(1, 1, 1), None):
        assert hole_of(shape) is None
