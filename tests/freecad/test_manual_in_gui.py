"""What's This and F1 open the page of a command, panel or dock; shortcuts clash with none of
FreeCAD's (see gui_manual_session.py).
"""

import pytest
from conftest import in_gui

PAGES = {
    "EvenLoad Adaptive": "adaptive_operation",
    "EvenLoad Trochoid": "trochoid_operation",
    "EvenLoad Lamé Spiral": "lame_spiral_operation",
    "EvenLoad Show Load": "load_view",
    "EvenLoad Show Surface": "surface_view",
    "EvenLoad Simulation": "simulation_window",
    "EvenLoad Compare": "simulation_window",
    "EvenLoad Report": "simulation_window",
    "EvenLoad Finishing": "finishing_operation",
    "EvenLoad Finishing Advisor": "finishing_advisor",
    "EvenLoad Stability Chart": "stability_chart",
    "EvenLoad Optimise": "optimisation",
    "EvenLoad Inspect": "inspect",
}


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_manual_session.py reports."""
    return in_gui("gui_manual_session.py", tmp_path_factory.mktemp("manual"))


@pytest.mark.parametrize("command", PAGES)
def test_whats_this_on_a_command_opens_its_page(session, command):
    assert session["commands"][command] == [PAGES[command]]


def test_every_command_in_the_toolbar_is_looked_at(session):
    assert sorted(session["commands"]) == sorted(PAGES)


DOCKS = ("load_view", "surface_view", "simulation_window", "optimisation", "inspect")


@pytest.mark.parametrize("page", [*DOCKS, "stability_chart"])
def test_f1_and_whats_this_in_a_dock_open_its_page(session, page):
    assert session["docks"][page]["f1"] == [page]
    assert session["docks"][page]["whats_this"][-1:] == [page]


def test_f1_and_whats_this_in_a_panel_open_the_page_of_its_operation(session):
    assert session["page"] == "adaptive_operation"
    assert session["panel"] == {"f1": ["adaptive_operation"], "whats_this": ["adaptive_operation"]}


def keys_of(shortcut):
    return [key.strip().upper() for key in shortcut.split(",")]


def test_no_shortcut_of_ours_is_one_of_freecads_or_begins_one(session):
    loaded, written = session["shortcuts"]
    ours = {name: keys_of(keys) for name, keys in loaded.items() if name.startswith("EvenLoad_")}
    theirs = [keys_of(keys) for name, keys in loaded.items() if name not in ours]
    assert len(theirs) > 50
    theirs += [keys_of(keys) for found in written.values() for keys in found]
    assert len(ours) == len(PAGES) == len({tuple(keys) for keys in ours.values()})
    for name, keys in ours.items():
        assert len(keys) == 2 and all(len(key) == 1 for key in keys), name
        for other in theirs:
            shared = min(len(keys), len(other))
            assert keys[:shared] != other[:shared], (name, other)


def test_the_shortcuts_of_freecads_own_operations_are_seen(session):
    written = [keys for found in session["shortcuts"][1].values() for keys in found]
    assert "P, J" in written and "P, T" in written
