"""Our texts can be read in all themes that FreeCAD brings along (see gui_themes_session.py)."""

import pytest
from conftest import in_gui

pytestmark = pytest.mark.core  # FreeCAD 1.1 fills its one style sheet itself, as it starts

LEAST = 4.5  # contrast of a text [WCAG 2, 1.4.3]
ALIKE = 0.95  # of the theme's own contrast: edges of letters are not all drawn alike


@pytest.fixture(scope="module")
def themes(tmp_path_factory):
    """What gui_themes_session.py reports of each theme."""
    return in_gui("gui_themes_session.py", tmp_path_factory.mktemp("themes"))["themes"]


def test_light_and_dark_themes_were_looked_at(themes):
    assert len(themes) > 2
    for seen, bare in themes.values():
        assert sum(own is not None for *_, own in seen) > 2, "nothing of ours had a colour"
        assert len(bare) == 4


def test_the_colours_that_we_choose_can_be_read_in_each_theme(themes):
    faint = [
        (theme, text, round(own, 2))
        for theme, (seen, _) in themes.items()
        for _, text, _, own in seen
        if own is not None and own < LEAST
    ]
    assert faint == []


def test_all_of_the_page_can_be_read_as_well_as_what_is_the_theme_s_own(themes):
    faint = [
        (theme, text, round(drawn, 2), round(bare[kind], 2))
        for theme, (seen, bare) in themes.items()
        for kind, text, drawn, _ in seen
        if drawn < min(LEAST, ALIKE * bare[kind])
    ]
    assert faint == []
