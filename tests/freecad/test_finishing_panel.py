"""The finishing operation's command and panel in FreeCAD's GUI (see gui_finishing_session.py)."""

import math

import pytest
from conftest import in_gui


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_finishing_session.py reports."""
    return in_gui("gui_finishing_session.py", tmp_path_factory.mktemp("finishing"))


def test_the_command_takes_the_selected_faces(session):
    assert session["icon"] and session["view"] == "FinishingViewProvider"
    assert sum(map(len, session["base"])) == 5


def test_the_button_beside_the_status_shows_the_surface_and_ends_that(session):
    assert session["surface"] == [True, 1, 0]


def test_the_panel_shows_seven_settings_at_first_and_every_one_unfolded(session):
    assert len(session["first"]) == 7 and "Stepover" in session["first"]
    assert sorted(session["shown"]) == sorted(session["settings"])


def test_stepover_and_cusp_height_follow_each_other_in_the_panel(session):
    stepover, cusp = session["at_first"]
    assert stepover == 0.5 and cusp == pytest.approx(5 - math.sqrt(25 - 0.25**2))
    height, shown = session["cusp_of_stepover"]
    assert height == pytest.approx(5 - math.sqrt(25 - 1.5**2)) == pytest.approx(shown, abs=5e-5)
    stepover, shown = session["stepover_of_cusp"]
    assert stepover == pytest.approx(2 * math.sqrt(0.1 * 9.9)) == pytest.approx(shown, abs=0.005)


def test_the_panel_fits_into_freecads_narrow_dock(session):
    assert session["too_wide"] == []


def test_apply_computes_the_path_and_tells_its_time(session):
    assert session["valid"] and session["commands"] > 1000
    assert (
        session["results"].startswith("\u2714 Valid\nTime 0:0") and "Passes 4" in session["results"]
    )


def test_a_button_takes_what_is_selected_as_fixtures(session):
    assert session["fixtures"] == [
        [[], "none", False],
        [["Clamp", "Vice"], "Clamp, Vice", True],
        [["Clamp"], "Clamp", True],
    ]


def test_walls_cannot_be_picked_edges_can(session):
    assert session["picked"] == session["wanted"]
