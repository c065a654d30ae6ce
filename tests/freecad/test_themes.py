"""Our texts can be read in all themes that FreeCAD brings along (see gui_themes_session.py)."""

import pytest
from conftest import in_gui
from evenload.gui import colours

pytestmark = pytest.mark.between

LEAST = 4.5  # contrast of a text [WCAG 2, 1.4.3]
ALIKE = 0.85  # of the theme's own contrast: letters have edges, and the ground of buttons fades


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    return in_gui("gui_themes_session.py", tmp_path_factory.mktemp("themes"))


@pytest.fixture(scope="module")
def themes(session):
    """What gui_themes_session.py reports of each theme."""
    return session["themes"]


@pytest.mark.core
def test_contrasts_are_those_of_wcag():
    assert colours.contrast("#000000", "#ffffff") == pytest.approx(21)
    # The grey that is known for missing 4.5 on white, and its neighbour, that does not.
    assert colours.contrast("#777777", "#ffffff") == pytest.approx(4.478, abs=1e-3)
    assert colours.contrast("#767676", "#ffffff") == pytest.approx(4.542, abs=1e-3)


@pytest.mark.core
@pytest.mark.parametrize("name", ["GOOD", "CAUTION", "BAD", "LINK", "QUIET"])
def test_both_shades_of_a_colour_can_be_read_on_the_ground_that_they_are_for(name):
    on_light, on_dark = getattr(colours, name)
    assert colours.contrast(on_light, "#f0f0f0") > LEAST
    assert colours.contrast(on_dark, "#333333") > LEAST


def test_light_and_dark_themes_were_looked_at(themes):
    assert len(themes) > 2
    for places in themes.values():
        assert len(places) == 6
        for place, (seen, bare) in places.items():
            assert len(seen) > 3 and len(bare) == 6, (place, seen, bare)
        seen, _ = places["page_of"]
        assert sum(own is not None for *_, own in seen) > 2, "nothing of ours had a colour"


def _faint(themes, of):
    """What cannot be read as well as the theme's own texts in the same place, and not well. of: the
    contrast that counts, of (drawn, own); None where there is none.
    """
    return [
        (theme, place, text, round(of(drawn, own), 2), round(bare[kind], 2))
        for theme, places in themes.items()
        for place, (seen, bare) in places.items()
        for kind, text, drawn, own in seen
        if of(drawn, own) is not None and of(drawn, own) < ALIKE * min(LEAST, bare[kind])
    ]


def test_the_colours_that_we_choose_can_be_read_in_each_theme(themes):
    assert _faint(themes, lambda drawn, own: own) == []


def test_all_that_we_show_can_be_read_as_well_as_what_is_the_theme_s_own(themes):
    assert _faint(themes, lambda drawn, own: drawn) == []


def test_the_ground_of_plots_goes_with_the_texts_of_the_theme(session):
    charts = session["charts"]
    assert len({ground for _, ground, _ in charts}) == 2, charts
    for theme, ground, text in charts:
        assert colours.contrast(ground, text) > LEAST, theme
