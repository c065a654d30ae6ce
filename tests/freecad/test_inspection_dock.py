"""The dock Inspect, used in FreeCAD's GUI (see gui_inspection_session.py)."""

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_inspection_session.py reports."""
    return in_gui("gui_inspection_session.py", tmp_path_factory.mktemp("inspection"))


def test_the_command_is_in_menu_and_toolbar_and_wants_a_face(session):
    assert "EvenLoad Inspect" in session["actions"]
    assert session["enabled"] == [False, False, True]


def test_points_are_shown_on_the_picked_faces(session):
    faces, told, count = session["samples"]
    assert "of Dome" in faces and told == "49 points" and count == 1
    assert session["off"] < 1e-5  # Coin has single precision
    assert session["cut_off"] == []


def test_points_are_written_in_all_forms(session):
    assert min(session["saved"].values()) > 500, session["saved"]
    assert session["told_after_saving"] == "49 points"
    assert session["documents"] == ["Dome"]


def test_what_cannot_be_sampled_is_told_in_the_dock(session):
    told, can_save = session["no_room"]
    assert "take a smaller one" in told and not can_save


def test_measured_points_are_evaluated_and_shown_in_colours(session):
    zone, told = session["zone"]
    assert 0.015 < zone < 0.0201 and "%.4f mm, of 121 points" % zone in told
    assert session["triangles"] > 1000 and session["colours"] > 100
    told, has_beyond = session["out"]
    assert "exceeds the tolerance of 0.0100 mm" in told and has_beyond
    assert "of 121 points" in session["of_faces"]  # all are of these faces
    aligned, expected = session["aligned"]
    assert aligned == pytest.approx(expected, abs=1e-9)
    assert "keeps the tolerance of 0.0500 mm" in session["in"]
    assert min(session["reports"].values()) > 5000, session["reports"]


def test_points_that_tell_nothing_are_refused_in_the_dock(session):
    told, can_save = session["few"]
    assert "3 points fit any face" in told and not can_save
    assert "mm from the faces" in session["far"]


def test_it_follows_other_faces_and_a_changed_model(session):
    assert "No face is picked" in session["nothing_taken"]
    assert session["taken"].endswith("of Dome") and "," not in session["taken"]
    assert session["changed"] == pytest.approx(2**0.5 * 30, rel=1e-6)


def test_it_ends_with_its_dock_and_its_document(session):
    assert session["closed"] == [0, 0] and session["again"] == 1 and session["gone"] == 0
