"""The dock Optimise, used in FreeCAD's GUI (see gui_optimise_session.py)."""

import math

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_optimise_session.py reports."""
    return in_gui("gui_optimise_session.py", tmp_path_factory.mktemp("optimise"))


def same(numbers, reported):
    """Whether what is set is what was told; feeds are whole ones."""
    feed = math.floor(numbers["feed"]) if numbers["feed"] >= 100 else numbers["feed"]
    wanted = {**{key: numbers[key] for key in ("angle", "step", "speed")}, "feed": feed}
    return {key: reported[key] for key in wanted} == pytest.approx(wanted)


def test_the_command_is_for_operations_of_ours_and_dressups_of_them(session):
    assert session["actions"] == 1
    assert session["active"] == [False, True, False, True, False]
    assert session["under"] and session["shown"] == 1


def test_it_asks_for_what_freecad_does_not_tell_of_the_tool(session):
    assert session["tool"] == {
        "max_chip_thickness": pytest.approx(0.036),
        "least_speed": pytest.approx(90, rel=1e-3),
        "most_speed": pytest.approx(120, rel=1e-3),
        "cutting_length": pytest.approx(30),
        "teeth": 1,
    }


def test_what_is_set_now_stands_beside_the_suggestion(session):
    now, op, seconds = session["now"]
    assert same(now, op)
    assert seconds == pytest.approx(op["time"], rel=0.02)
    text = session["compared"]
    best, row = session["best"]
    assert "Now" in text and "Suggested" in text and row == 0
    for number in ("%.0f" % now["speed"], "%.0f" % now["force"], "%.0f" % best["force"]):
        assert ">%s<" % number in text
    assert "Chatter is not looked at" in session["told"]


def test_candidates_are_listed_and_sorted_by_their_numbers(session):
    assert session["titles"][0] == "Angle, °"
    assert "On the machine" not in session["titles"]
    assert len(session["cells"]) == 10
    bound = session["titles"].index("Limited by")
    assert {row[bound] for row in session["cells"]} == {"chip thickness"}
    up, down = session["force"]
    assert up == sorted(up) and down == up[::-1] and len(set(up)) > 1
    assert session["kept_row"]


def test_a_click_compares_another_candidate(session):
    assert session["clicked"] and session["compared_after"] != session["compared"]


def test_take_sets_what_was_told_in_one_step_to_undo(session):
    taken = session["taken"]
    assert same(taken["wanted"], taken["after"]) and taken["after"]["valid"]
    assert taken["steps"] == 1 and taken["told"].startswith("Taken") and taken["still"] == 10
    settings = ("angle", "step", "speed", "feed")
    assert [taken["undone"][key] for key in settings] == [taken["before"][key] for key in settings]
    assert [taken["redone"][key] for key in settings] == [taken["after"][key] for key in settings]
    assert taken["cleared"] == 0 and taken["asks"].startswith("Suggest")


def test_beside_another_s_open_panel_nothing_is_taken(session):
    """FreeCAD would close the panel's transaction, and Cancel could not restore."""
    before, after, told = session["other_panel"]
    assert after == before and told == "Close the open panel first."


def test_limits_that_refuse_all_are_told(session):
    told, can_be_taken, rows = session["refused"]
    assert told.startswith("No candidate is within the limits: the force refuses most")
    assert not can_be_taken and rows == []


def test_with_a_machine_its_times_are_told(session):
    assert "On the machine" in session["machine"]


def test_it_follows_the_user_s_units(session):
    titles, suffix, tool = session["inches"]
    assert suffix == " in" and "Step down, in" in titles and "Feed, in/min" in titles
    assert tool == pytest.approx(session["tool"])
    best = session["rows"]
    shown = dict(zip(titles, session["inch_cells"]))
    assert float(shown["Step down, in"]) == pytest.approx(best["step"] / 25.4, abs=1e-4)
    feed = math.floor(best["feed"])
    assert float(shown["Feed, in/min"]) == pytest.approx(feed / 25.4, abs=0.06)


def test_what_cannot_be_is_told_in_one_sentence(session):
    assert session["angles"] == "Angles are numbers between 0 and 180, as 45; 60; 75."
    told, is_busy = session["no_diameter"]
    assert "diameter of the tool" in told and "is 0 mm: set it." in told and not is_busy


def test_without_a_path_the_command_is_grey_and_the_dock_tells_what_is_missing(session):
    is_active, told, can_be_taken, again, is_busy, docks = session["empty"]
    assert not is_active and "base geometry" in told.lower() and not can_be_taken
    assert again == told and not is_busy
    assert docks == 0, "it goes with its operation"


def test_cancel_stops_it(session):
    assert session["busy"] == [True, True]
    assert session["cancelled"] == [False, "The suggestion was cancelled.", False]


def test_what_was_asked_is_kept(session):
    speed, force, angles = session["kept"]
    assert (speed, force, angles) == (pytest.approx(135), 120, "50; 70")


def test_a_suggestion_goes_with_what_it_was_made_for(session):
    rows, told = session["changed"]
    assert rows == [] and told.startswith("Suggest")


def test_a_suggestion_goes_with_all_that_it_came_from(session):
    """Settings, the tool bit, the machine's file, the base geometry."""
    assert len(session["followed"]) == 6
    for told, before, after in session["followed"]:
        assert before > 0 and after == 0, told


def test_what_is_taken_in_an_open_panel_is_a_part_of_its_edit(session):
    panel = session["panel"]
    settings = ("angle", "step", "speed", "feed")
    before = [panel["before"][key] for key in settings]
    for name in ("cancelled", "accepted"):
        seen = panel[name]
        assert seen["open"] and same(seen["wanted"], seen["set"])
        assert seen["shown"] == pytest.approx(seen["wanted"]["angle"])
        assert seen["told"] == "Taken into the panel."
    assert [panel["cancelled"]["left"][key] for key in settings] == before
    assert panel["cancelled"]["steps"] == 0
    left = panel["accepted"]["left"]
    assert same(panel["accepted"]["wanted"], left) and left["valid"]
    assert panel["accepted"]["steps"] == 1
    assert [panel["undone"][key] for key in settings] == before


def test_it_goes_with_its_user_s_wish_and_with_the_document(session):
    assert session["closed"] == 0
    assert session["busy_at_close"] and session["document_closed"] == 0
