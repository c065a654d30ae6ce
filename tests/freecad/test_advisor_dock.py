"""The dock Finishing Advisor, used in FreeCAD's GUI (see gui_advisor_session.py)."""

import math

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_advisor_session.py reports."""
    return in_gui("gui_advisor_session.py", tmp_path_factory.mktemp("advisor"))


def test_the_command_stands_beside_finishing_and_wants_faces_in_a_job_or_an_operation(session):
    actions = session["actions"]
    place = actions.index("EvenLoad Finishing")
    assert actions[place + 1] == "EvenLoad Finishing Advisor"
    # No job; nothing; an edge; faces; later an operation.
    assert session["enabled"] == [False, False, False, True, True]
    assert session["without_faces"]


def test_it_can_be_cancelled_on_its_way_and_keeps_what_is_known(session):
    assert session["busy"] == [True, True]
    is_busy, rows, told, bar = session["cancelled"]
    assert not is_busy and 1 <= rows < 10 and "cancelled" in told and not bar


def test_stepover_and_cusp_height_follow_each_other(session):
    before, after = session["cusp_of_stepover"]
    assert before == pytest.approx(5 - math.sqrt(25 - 0.25**2), abs=5e-5)
    assert after == pytest.approx(5 - math.sqrt(24), abs=5e-5)
    assert session["stepover_of_cusp"] == pytest.approx(2 * math.sqrt(0.2 * 9.8), abs=5e-5)


def test_all_strategies_are_rows_and_every_column_sorts_by_numbers(session):
    assert len(set(session["names"])) == 10 and "Zig-zag 22.5°" in session["names"]
    for column in range(1, 11):
        up, down = (session["sorted"]["%d %s" % (column, way)] for way in ("up", "down"))
        assert up == sorted(up) and down == sorted(up, reverse=True), column
        assert len(up) == 10 and all(isinstance(value, (int, float)) for value in up)


def test_a_strategy_that_does_not_fit_comes_last_with_its_reason(session):
    refused = session["refused"]
    for way in ("up", "down"):
        assert refused[way] == [None, "It does not fit.", "\u2013"]
    assert not refused["can_make"]


def test_the_best_of_each_column_is_marked_and_its_unit_told(session):
    marked = dict(zip(session["headers"], session["marked"]))
    assert marked["Strategy"] == marked["Remark"] == 0

    def of(beginning):
        (found,) = (each for title, each in marked.items() if title.startswith(beginning))
        return found

    assert of("Mean\nthickness") == 0  # neither thin nor thick chips are best
    # Lengths in mm or µm, as FreeCAD has them.
    for title in ("Time", "Scatter", "Highest\ncusp", "Tip\nshare\n%", "Impulse\nN·s"):
        assert 1 <= of(title) < 10, title
    assert session["cut_off"] == []


def test_one_click_makes_the_operation_in_one_undoable_step(session):
    assert session["can_make"] == [False, True]
    made = session["made"]
    strategy, angle, spacing, stepover = made["settings"]
    assert (strategy, angle, spacing) == ("Zig-zag", 67.5, "Constant stepover")
    assert stepover == pytest.approx(2 * math.sqrt(0.2 * 9.8), abs=5e-5)
    assert made["valid"] and len(made["faces"][0]) == 5
    assert made["seconds"][0] == pytest.approx(made["seconds"][1], rel=1e-6)
    assert "Zig-zag 67.5°" in made["told"] and made["still"] == [10, False]
    assert made["tolerance"] == pytest.approx(0.02), "as new operations are preferred"
    assert session["undone"] == [] and len(session["redone"]) == 1


def test_a_tool_without_a_ball_is_refused_in_the_dock(session):
    told, rows, is_busy, can_make = session["flat"]
    assert "has no ball end" in told and rows == 0 and not is_busy and not can_make
    assert session["flat_cusp"] == 0


def test_the_selected_operation_is_compared_and_set(session):
    name, label, button = session["of_operation"]
    assert name == label and button == "Set Operation"
    strategy, is_valid, count = session["set"]
    assert (strategy, is_valid, count) == ("Contours inwards", True, 1)
    assert session["set_undone"] == "Zig-zag"


def test_beside_an_open_panel_only_its_own_operation_is_set(session):
    """FreeCAD would close the panel's transaction, and Cancel could not restore."""
    assert session["other_panel"] == [[], "Close the open panel first."]
    own = session["own_panel"]
    assert own["set"] == ["Contours outwards"] * 2 and own["told"] == "Taken into the panel."
    assert own["after"] == own["before"]


def test_units_are_those_that_freecad_prefers(session):
    headers, stepover = session["inches"]
    assert stepover.endswith(" in")
    units = dict(header.rsplit("\n", 1) for header in headers if "\n" in header)
    assert units["Scatter"] not in ("", "mm", "µm")
    assert units["Least\nspeed"] not in ("mm/s", "mm/min")
    headers, stepover = session["mm_again"]
    assert stepover.endswith(" mm") and {"Scatter\nmm", "Scatter\nµm"} & set(headers)


def test_it_follows_what_is_compared_and_ends_with_its_dock_and_document(session):
    assert session["again"] == [True] * 6
    lengths, stepover, cusp_height = session["lengths"]
    assert lengths["Stepover"] == pytest.approx(stepover) == 1.5
    assert lengths["CuspHeight"] == pytest.approx(cusp_height, abs=5e-5)
    assert session["not_again"] == [False, 1.0]
    assert [session[key] for key in ("closed", "opened", "gone")] == [0, 1, 0]
