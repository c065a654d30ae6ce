"""FreeCAD's Job panel beside our operations, in a window: as a new user has it, with a document
that is opened again, and with one that was made without a GUI (see gui_job_session.py).
"""

import math
import os
import pathlib
import shutil

import pytest
from conftest import headless_document, in_gui
from evenload.operations.adaptive import Adaptive

ROWS = sorted(setting.name for setting in Adaptive.settings if setting.in_setup_sheet())


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    """A FreeCAD home with nothing but the addon."""
    import evenload

    addon = os.path.dirname(os.path.dirname(os.path.dirname(evenload.__file__)))
    folder = tmp_path_factory.mktemp("home")
    shutil.copytree(addon, folder / "Mod" / "EvenLoad")
    return folder


@pytest.fixture(scope="module")
def fresh(home, tmp_path_factory):
    """A user's first session."""
    folder = tmp_path_factory.mktemp("fresh")
    seen = in_gui(
        "gui_job_session.py", folder, FREECAD_USER_HOME=str(home), EVENLOAD_GUI_STAGE="fresh"
    )
    seen["document"] = folder / "job.FCStd"
    return seen


def opened_again(document, home, stage="again"):
    return in_gui(
        "gui_job_session.py",
        pathlib.Path(document).parent,
        FREECAD_USER_HOME=str(home),
        EVENLOAD_GUI_STAGE=stage,
        EVENLOAD_GUI_DOCUMENT=str(document),
    )


@pytest.fixture(scope="module")
def panel(fresh, home):
    """The Job panel of the first session's document, in another process."""
    return opened_again(fresh["document"], home, "panel")["panel"]


@pytest.fixture(scope="module")
def defaults(fresh, panel, home):
    """Defaults that are set in that document's Job panel, in a third process."""
    return opened_again(fresh["document"], home, "defaults")


@pytest.fixture(scope="module")
def second(fresh, defaults, home):
    """A second operation in that document, in a fourth process."""
    return opened_again(fresh["document"], home, "second")


@pytest.fixture(scope="module")
def again(fresh, second, home):
    """That document in a fifth process."""
    return opened_again(fresh["document"], home)


@pytest.fixture(scope="module")
def headless(home, tmp_path_factory):
    """A document that was made without a GUI."""
    return opened_again(headless_document(tmp_path_factory.mktemp("headless")), home)


def check_panel(panel):
    assert panel["active"]
    assert len(panel["pages"]) == 6 and "Op Defaults" in panel["pages"]
    assert sorted(panel["rows"]) == ROWS and len(ROWS) >= 10
    assert panel["kept"]


def test_a_job_is_made_by_its_dialog(fresh):
    # FreeCAD warns first: 1.0 that there are no tools yet, 1.1 of units without minutes.
    titles = [title for title in fresh["job_dialogs"] if not title.startswith("Warning")]
    assert len(titles) == 1
    assert fresh["new_job_panel"] and len(fresh["new_job_pages"]) == 6


def test_a_face_that_is_clicked_on_a_body_is_taken_from_the_jobs_model(fresh):
    ((clicked, names),) = fresh["clicked"]
    assert clicked == "Pocket" and len(names) == 1, "what FreeCAD selects is the body's feature"
    assert fresh["base"] == [[fresh["model"], names]] and len(fresh["base_list"]) == 1
    assert fresh["valid"] and fresh["commands"] > 100


def test_the_path_follows_the_jobs_model(fresh):
    there, moved = fresh["boxes"]
    assert moved == pytest.approx([a + b for a, b in zip(there, [200, 0, 0] * 2)], abs=1e-3)


def test_the_job_panel_opens_with_our_defaults_and_cancel_loses_nothing(panel):
    check_panel(panel)
    rows = panel["rows"]
    assert not any(is_set for is_set, _ in rows.values())
    assert rows["EngagementAngle"][1].startswith("60")
    assert rows["CutMode"][1] == "Climb"
    assert panel["valid"] == [True]


def test_every_default_has_its_editor(defaults):
    assert sorted(defaults["editors"]) == ROWS
    assert set(defaults["editors"].values()) == {"QLineEdit", "QComboBox"}


def test_freecads_operations_keep_their_own_defaults(defaults):
    rows = defaults["freecads_rows"]
    assert rows and "EngagementAngle" not in rows
    assert "HelixAngle" in rows and "StepOver" in rows


def test_a_default_reaches_new_operations_and_only_those(fresh, second):
    made = second["second"]
    assert second["clicked"] == fresh["clicked"]
    assert made["new"] and made["valid"]
    assert made["EngagementAngle"] == pytest.approx(45)
    step = made["diameter"] / 2 * (1 - math.cos(math.pi / 4))
    assert made["SideStep"] == pytest.approx(step)
    assert made["StockToLeave"] == pytest.approx(0.4)
    assert made["CutMode"] == "Conventional" and made["Arcs"] is False
    assert second["first_kept"] == [pytest.approx(60), "Climb"]


def test_the_job_panel_of_a_document_that_is_opened_again(again):
    check_panel(again["panel"])
    rows = again["panel"]["rows"]
    assert rows["EngagementAngle"][0] and rows["EngagementAngle"][1].startswith("45")
    assert not rows["OrderBy"][0]
    assert again["all_valid"] == [True, True]


def test_a_cancelled_operation_passes_for_whole_nowhere(second, again):
    for state in (second["cancelled"], again["states"][1]):
        assert not state["valid"] and state["report"].startswith("Cancelled")
        assert state["uncut"] > 600, "the pocket has 720 mm2"
        assert " ".join(state["path"]) == "(Cancelled: nothing is cut here)"
    assert again["states"][0]["valid"] and again["states"][0]["uncut"] == 0
    assert "(Cancelled: nothing is cut here)" in again["posted"]


def test_the_job_panel_of_a_document_made_without_a_gui(headless):
    check_panel(headless["panel"])
    assert headless["panel"]["valid"] == headless["all_valid"] == [True]
