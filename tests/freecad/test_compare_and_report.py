"""The commands Compare and Report, used in FreeCAD's GUI (see gui_compare_session.py)."""

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("compare")


@pytest.fixture(scope="module")
def session(folder):
    """What gui_compare_session.py reports."""
    return in_gui("gui_compare_session.py", folder)


def test_the_commands_are_in_the_toolbar_with_their_icons(session):
    assert session["toolbar"] == [1, 1]
    assert session["icons"] == [True, True]


@pytest.mark.parametrize(
    "selected, compare, report",
    [
        ("without a document", False, False),
        ("nothing", False, True),
        ("job", False, True),
        ("one", True, True),
        ("two", True, True),
        ("operation_and_job", False, True),
        ("model", False, True),
        ("the only one", False, True),
        ("without a path", False, False),
    ],
)
def test_they_can_be_used_where_they_work(session, selected, compare, report):
    assert session["enabled"][selected] == [compare, report]


def test_two_selected_operations_are_compared_on_one_scale(session):
    seen = session["two"]
    assert seen["runs"] == seen["asked"] == ["Theirs", "Ours"]
    first, second = seen["scales"]
    assert first == second


def test_beside_one_the_other_is_asked_for(session):
    assert session["one"] == {"titles": ["EvenLoad Compare"], "offered": ["Theirs"], "windows": 1}


def test_who_names_no_other_gets_no_window(session):
    assert session["cancelled"]["windows"] == 0


def test_the_report_is_written_and_opened_in_the_browser(session, folder):
    assert session["written"]["dialogs"] == [True]
    assert session["written"]["opened"] == [str(folder / "job.html")]
    assert min(session["written"]["waits"]) > 24 * 3600e3  # ms
    assert session["written"]["in_windows_thread"] == [False]
    text = (folder / "job.html").read_text()
    assert text.count("<h2>Ours</h2>") == text.count("<h2>Theirs</h2>") == 1
    assert "Not simulated" not in text


def test_without_a_file_nothing_is_computed(session):
    seen = session["no_file"]
    assert seen == {"dialogs": [], "opened": [], "waits": [], "in_windows_thread": []}


def test_a_file_that_cannot_be_written_is_told_and_not_opened(session):
    assert session["missing"]["opened"] == []


def test_cancel_stops_a_report_of_which_no_file_comes(session, folder):
    assert session["stopped"] == [False, False]
    assert not (folder / "cancelled.html").exists()
