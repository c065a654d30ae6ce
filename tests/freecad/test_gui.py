"""The command and the panel, used in FreeCAD's GUI on a virtual screen (see gui_session.py)."""

import pytest
from conftest import headless_document, in_gui
from evenload import materials
from evenload.operations.adaptive import Adaptive


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_session.py reports."""
    folder = tmp_path_factory.mktemp("gui")
    return in_gui("gui_session.py", folder, EVENLOAD_GUI_DOCUMENT=headless_document(folder))


def test_the_command_is_in_menu_and_toolbar_with_its_icon(session):
    assert "EvenLoad Adaptive" in session["menu"] and session["icon"]
    assert "EvenLoad Adaptive" in session["toolbar"]


@pytest.mark.parametrize("place", ["menu", "toolbar"])
def test_all_of_our_commands_stand_beside_freecad_s_adaptive(session, place):
    shown = session[place]
    ours = [k for k, text in enumerate(shown) if text.startswith("EvenLoad")]
    assert len(ours) == ours[-1] - ours[0] + 1 > 3
    assert shown.index("Adaptive") in (ours[0] - 1, ours[-1] + 1)


def test_the_command_takes_the_selected_face(session):
    assert session["base"] == [["Face11"]]
    assert len(session["base_list"]) == 1 and session["base_list"][0].endswith(".Face11")
    assert session["view"] == session["job_view"] == "ViewProvider"


def test_the_command_takes_a_whole_sketch(session):
    assert session["sketch_base"] == [["Outline", [""]]]
    assert session["cancelled_is_gone"]


def test_the_panel_shows_seven_settings_at_first_and_every_one_unfolded(session):
    assert sorted(session["first"]) == sorted(
        "EngagementAngle SideStep CutMode Entry FeedControl StockToLeave UseRestMachining".split()
    )
    assert sorted(session["shown"]) == sorted(setting.name for setting in Adaptive.settings)


@pytest.mark.parametrize("command", ["EvenLoad_Trochoid", "EvenLoad_LameSpiral"])
def test_every_operation_has_its_command_panel_and_icon(session, command):
    seen = session["others"][command]
    assert seen["view"] == command.replace("EvenLoad_", "") + "ViewProvider" and seen["icon"]
    assert len(seen["first"]) <= 7
    assert sorted(seen["shown"]) == sorted(seen["settings"])
    assert seen["valid"] and seen["commands"] > 10 and "Time" in seen["results"]
    assert seen["own_after_apply"] == []


def test_the_list_of_tool_controllers_makes_new_ones_where_freecad_does(session):
    seen = session["controllers"]
    (label,) = seen["labels"]
    assert seen["items"][0] == label
    if not seen["makes"]:
        assert seen["items"] == [label] and seen["chosen"] == []
        return
    copied, made = seen["chosen"]
    assert copied[0] and copied[1].startswith(label) and copied[2] == 2
    # FreeCAD lets the user choose a tool bit in a dialog, which is cancelled.
    assert made[0] and made[1] == copied[1] and made[2] == 2


def test_what_is_edited_in_the_panel_is_fitted_no_more_until_it_is_asked_for(session):
    seen = session["others"]["EvenLoad_LameSpiral"]
    shown, value = seen["fitted"]
    assert shown == pytest.approx(value, abs=6e-5) and value > 0
    assert seen["set"] == 0.9 and seen["own_after_edit"] == ["ExponentEnd"]
    assert seen["own_after_again"] == []


def test_a_course_is_edited_as_a_row_of_numbers(session):
    assert session["others"]["EvenLoad_LameSpiral"]["courses"] == [
        ["", []],
        ["0; 0.25; 1", [0, 0.25, 1]],
        ["0; 0.5; 1", [0, 0.5, 1]],
        ["0; 0.5; 1", [0, 0.5, 1]],  # what is no number is not taken
        ["", []],
    ]


def test_the_panel_sets_properties_and_computes(session):
    assert session["side_step_property"] == pytest.approx(3)
    assert session["side_step_widget"] == pytest.approx(3)
    assert session["angle_property"] == pytest.approx(60)
    assert session["angle_after_apply"] == pytest.approx(60)
    assert session["feed_control"] == "Constant removal rate"
    assert len(session["feed_controls"]) == 4 and "Constant force" in session["feed_controls"]
    assert session["materials"] == materials.names()
    assert session["material"] == materials.names()[2]
    assert session["material_enabled"] == [False, True]
    assert session["entry_point"] == [12, 0, 0]
    assert session["arcs"] is False
    assert session["tolerance_text"] in ("0.0050 mm", "0,0050 mm")
    assert session["valid"] and session["commands"] > 10
    assert session["results_text"].startswith("\u2714 Valid, checked against the model\nTime 0:0")
    assert session["closed"]


def test_cancel_stops_the_computation_and_leaves_nothing_that_passes_for_whole(session):
    seen = session["cancel"]
    assert len(seen["dialogs"]) == 1, "the dialog shows once, and one click is enough"
    assert seen["dialogs"][0]["title"] == "EvenLoadAdaptive" and seen["dialogs"][0]["modal"]
    assert seen["report"].startswith("Cancelled") and session["after_cancel"]
    assert not seen["valid"] and seen["uncut"] > 100
    assert seen["path"].split() == "(Cancelled: nothing is cut here)".split()
    whole_report, whole_commands = session["whole"]
    assert "Cancelled" not in whole_report and whole_commands > 10


def test_the_dialog_is_there_within_half_a_second_and_cancel_is_answered_within_a_third(session):
    seen = session["waited"]
    clock, work = seen["shown"]
    assert clock > 0.2 and work < 0.5, "what takes no time shows no dialog"
    assert seen["answered"][1] < 0.3
    assert not seen["asked_again"] and seen["left"] == 0


@pytest.mark.parametrize("number", [0, 1], ids=["job", "tool controller"])
def test_cancel_where_freecad_asks_for_job_or_tool_makes_nothing(session, number):
    assert session["choices"][number] == {"asked": 1, "same": True, "panel": False}


def test_an_error_shows_its_sentence(session):
    assert not session["error_valid"]
    assert session["error"].startswith("Engagement angle is 200 degrees")


def test_an_operation_made_without_a_gui_has_icon_and_panel_when_opened_in_it(session):
    assert session["reopened_view"] == session["reopened_job_view"] == "ViewProvider"
    assert session["reopened_icon"] and session["reopened_panel"] and session["reopened_kept"]
