"""The window Simulation, used in FreeCAD's GUI (see gui_simulation_session.py)."""

import csv
import re

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("simulation")


@pytest.fixture(scope="module")
def session(folder):
    """What gui_simulation_session.py reports."""
    return in_gui("gui_simulation_session.py", folder)


def test_the_command_is_in_the_toolbar_and_opens_one_window(session):
    assert session["actions"] == 1
    assert session["shown"] == [1, 1]


def test_the_limits_are_those_of_the_operation(session):
    degrees, rate = session["nominal"]
    assert session["limits"] == {
        "engagement_deg": pytest.approx(degrees),
        "removal_rate": pytest.approx(rate, rel=1e-3),
        "force_peak": None,
    }


def test_the_time_is_that_of_the_operation(session):
    shown, told = session["time"]
    assert shown == pytest.approx(told, rel=0.01)


@pytest.mark.parametrize("which", ["from_plot", "from_both"])
def test_a_click_into_a_plot_moves_the_tool_in_the_view(session, which):
    assert len(session[which]) == (3 if which == "from_plot" else 6)
    for seen in session[which]:
        assert abs(seen["off"]) <= 1.5  # pixels
        assert seen["active"] == seen["run"]
        assert seen["tool"] == pytest.approx(seen["cursor"], abs=0.01)
    assert len({tuple(seen["tool"]) for seen in session[which]}) == len(session[which])


def test_a_click_into_the_view_moves_the_cursor_in_the_plots(session):
    for seen in session["from_view"]:
        assert seen["focal"] == pytest.approx(seen["clicked"][:2], abs=0.2)  # a pixel
        assert seen["tool"] == pytest.approx(seen["cursor"], abs=0.01)
        assert seen["tool"] == pytest.approx(seen["clicked"], abs=0.3)


def test_the_slider_moves_both(session):
    assert session["slid"]["tool"] == pytest.approx(session["slid"]["cursor"], abs=0.01)


def test_the_wheel_zooms_about_the_mouse_and_a_button_shows_all(session):
    before, after, under_mouse, again = session["zoom"]
    assert again == before
    assert after[1] - after[0] == pytest.approx((before[1] - before[0]) / 1.25**4, rel=1e-6)
    assert under_mouse == pytest.approx(0.5 * before[1], rel=0.01)


def test_two_operations_stand_beside_each_other_on_one_scale(session):
    assert session["names"] == ["Ours", "Theirs"]
    ours, theirs = session["scale"]
    assert ours == theirs
    assert len({tuple(each[2:]) for each in ours}) == 3  # a scale for each row


def test_what_is_compared_is_cut_from_the_same_stock(session):
    ours, theirs = session["removed"]
    assert theirs == pytest.approx(ours, rel=0.01)


def test_a_machine_takes_its_time(session):
    for programmed, on_machine in zip(*session["machine"]):
        assert on_machine > 1.01 * programmed


def test_plots_and_samples_are_written(session, folder):
    assert (folder / "plots.png").read_bytes().startswith(b"\x89PNG")
    text = (folder / "plots.svg").read_text()
    for words in ("Ours", "Theirs", "Engagement", "Removal rate", "Peak force", "on the machine"):
        assert words in text
    rows = list(csv.DictReader((folder / "samples.csv").open()))
    assert len(rows) == session["samples"]
    assert {row["Operation"] for row in rows} == {"Ours", "Theirs"}
    assert {"cut", "entry", "rapid"} <= {row["Move"] for row in rows}
    cuts = [float(row["Peak force, N"]) for row in rows if row["Move"] == "cut"]
    assert max(cuts) > 10
    assert "cannot be written" in session["refused"]


def test_the_report_of_the_job_has_its_operations_times_and_pictures(session, folder):
    assert session["reported"] == "The report is written."
    text = (folder / "report.html").read_text()
    assert text.count("<h2>Ours</h2>") == text.count("<h2>Theirs</h2>") == 1
    assert text.count("data:image/png;base64,") == 6
    assert "hobby_router_grbl" in text and "No incidents" in text


def test_it_follows_the_units_that_the_user_chooses(session):
    inches, mm = session["inches"], session["mm"]
    assert inches["limits"] == mm["limits"]
    limit, name = inches["limit"]
    assert name == " in³/min" and limit == pytest.approx(mm["limit"][0] * 1e3 / 25.4**3, abs=1e-4)
    assert mm["limit"][1] == " cm³/min"
    rate, rest, force = inches["found"]
    figures = {each: inches["totals"][k + 1] for k, each in enumerate(inches["totals"][:-1])}
    assert figures["Removal rate, in³/min"] == "%.3g" % (rate / 25.4**3)
    assert figures["\u25a0 Rest, in²"] == "%.3g" % (rest / 25.4**2)
    assert figures["Force, N"] == "%.0f" % force
    assert "\u25a0 Gouge, in" in figures and " in/min" in inches["values"]
    (label, top), (metric_label, metric_top) = inches["axis"], mm["axis"]
    assert "in³/min" in label and "cm³/min" in metric_label
    assert top == pytest.approx(metric_top * 1e3 / 25.4**3)


def test_files_for_people_are_in_their_units_and_those_for_programs_in_mm(session, folder):
    assert "in³/min" in (folder / "plots.svg").read_text()
    text = (folder / "report.html").read_text()
    assert "<th>Removal rate, in³/min</th>" in text and "<th>Rest, in²</th>" in text
    assert "\u00d8 0.23622 in" in text
    told = re.sub('<style>.*?</style>|base64,[^"]*', "", text, flags=re.S)
    assert re.search(r"\bmm\b|cm³|mm²", told) is None
    head = next(csv.reader((folder / "samples.csv").open()))
    assert {"x, mm", "Feed, mm/min"} <= set(head)
    assert not any(re.search(r"\bin\b", each) for each in head)


def test_it_follows_each_computation_and_can_be_cancelled(session):
    assert 35 < session["followed"] < 45
    told, runs, is_busy = session["cancelled"]
    assert "simulated before" in told and runs == 2 and not is_busy


def test_rest_is_an_area_in_the_view(session):
    seen = session["areas"]
    assert seen["area"] > 0.1 and seen["in_scene"] == 1
    counts, outlines = seen["counts"]
    assert counts == outlines and len(counts) > 0
    for (x, y, z), (u, v) in zip(*seen["corners"]):
        assert (x, y) == pytest.approx((u, v), abs=1e-4)
        assert -3.0 < z <= 0.06


def test_a_gouge_is_an_area_in_the_view_and_has_its_mark(session):
    seen = session["gouge"]
    assert seen["marks"] == seen["incidents"] > 0
    xs = [x for x, _, _ in seen["points"]]
    assert 18 <= min(xs) < max(xs) == pytest.approx(20, abs=1e-3)


def test_it_goes_with_its_operation_its_dock_and_its_document(session):
    assert session["deleted"] == [0, 0]
    assert session["closed"] == [0, 0]
    assert session["document_closed"] == 0
