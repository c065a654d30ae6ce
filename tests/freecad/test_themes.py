"""Our texts can be read in all themes that FreeCAD brings along (see gui_themes_session.py)."""

import pytest
from conftest import in_gui

LEAST = 4.5  # contrast of a text [WCAG 2, 1.4.3]


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_themes_session.py reports."""
    return in_gui("gui_themes_session.py", tmp_path_factory.mktemp("themes"))


def test_light_and_dark_themes_were_looked_at(session):
    assert len(session["themes"]) > 2 and session["notes"]
    for seen in session["themes"].values():
        assert sum(own is not None for _, own in seen.values()) > 2, "nothing of ours had a colour"


def test_the_colours_that_we_choose_can_be_read_in_each_theme(session):
    faint = [
        (theme, text, round(own, 2))
        for theme, seen in session["themes"].items()
        for text, (_, own) in seen.items()
        if own is not None and own < LEAST
    ]
    assert faint == []


def test_all_of_the_page_can_be_read_in_each_theme(session):
    faint = [
        (theme, text, round(drawn, 2))
        for theme, seen in session["themes"].items()
        for text, (drawn, _) in seen.items()
        if drawn < LEAST
    ]
    assert faint == []
