"""What docks show can be read in each language and with both units: nothing of it is cut off (see
gui_readable_session.py).
"""

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between

LANGUAGES = "English", "German", "Hungarian"
LEAST_PLOT = 560  # pixels: of two plots beside each other


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_readable_session.py reports."""
    return in_gui("gui_readable_session.py", tmp_path_factory.mktemp("readable"))


def check(figures):
    assert len(figures["seen"]) == 4  # the table and the buttons
    for what, (shown, width) in figures["seen"].items():
        assert shown == width > 0, what
    height, natural = figures["heights"]
    assert height == natural  # no line of the table is wrapped
    assert figures["sideways"] == 0
    assert figures["plot"] >= LEAST_PLOT


@pytest.mark.parametrize("units", ["mm", "inches"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_both_operations_that_are_compared_have_their_figures(session, language, units):
    check(session["compared"][language][units])


def test_long_names_leave_room_for_the_figures(session):
    check(session["long_name"])


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_legend_of_the_load_has_room_for_all_its_colours(session, language):
    seen = session["legends"][language]
    assert seen.pop("width") <= 264 and len(seen) == 6
    assert {key: missing for key, missing in seen.items() if missing} == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_legend_grows_as_it_becomes_narrower(session, language):
    assert session["by_width"][language] == {"600": [], "264": [], "180": []}
