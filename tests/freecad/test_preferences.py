"""Our page of FreeCAD's preferences (see gui_preferences_session.py)."""

import pytest
from conftest import in_gui
from evenload.gui import load_colours
from evenload.settings.table import SETTINGS


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_preferences_session.py reports."""
    return in_gui("gui_preferences_session.py", tmp_path_factory.mktemp("preferences"))


def own(name):
    (row,) = (each for each in SETTINGS if each.name == name)
    return row.value[0] if isinstance(row.value, list) else row.value


def test_freecads_dialog_shows_the_page_with_units(session):
    angle, length = session["texts"]
    assert angle.replace(" ", "") == "60.00°" and length.replace(",", ".") == "0.0000 in"
    assert session["titles"] == ["New operations begin with", "Windows"]


def test_what_is_set_is_kept_and_what_is_as_ever_is_not(session):
    assert session["kept_at_first"] == []
    assert session["again"] == session["preferred"]
    assert session["windows"] == [False, "Blue to white", "hobby_router_grbl", "Star test piece"]
    assert session["cleared"] == []


def test_operations_made_in_the_window_begin_with_it(session):
    made, preferred = session["made"], session["preferred"]
    assert len(made) > len(preferred)
    for name, value in made.items():
        assert value == preferred.get(name, own(name)), name


def test_the_setup_sheet_of_a_job_comes_first(session):
    assert session["with_setup_sheet"] == 75


def test_scripts_do_the_same_for_everyone(session):
    assert session["scripted"] == {name: own(name) for name in session["made"]}


def test_windows_begin_with_it(session):
    last = load_colours.SCALES["Blue to white"][-1]
    assert session["legend"] == pytest.approx(last, abs=0.03)
    assert session["machine_shown"] == "hobby_router_grbl"


def test_what_can_no_longer_be_is_as_if_nothing_was_preferred(session):
    assert session["spoiled"] == [load_colours.names()[0], None, "Climb", 60]
