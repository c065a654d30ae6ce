"""The window Stability chart, used in FreeCAD's GUI (see gui_stability_session.py)."""

import re

import numpy
import pytest
from conftest import in_gui
from evenload.dynamics import Frf, Mode

pytestmark = pytest.mark.between

MODE = Mode.from_stiffness(3.0, 780, 0.022)


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_stability_session.py reports."""
    folder = tmp_path_factory.mktemp("stability")
    frf = Frf.of_modes([MODE], numpy.arange(300, 1600, 2.0))
    noise = numpy.random.default_rng(1).normal(size=(2, len(frf.xx))) * 0.01 * abs(frf.xx).max()
    values = 1e6 * (frf.xx + noise[0] + 1j * noise[1])
    rows = ["%g,%g,%g" % (f, v.real, v.imag) for f, v in zip(frf.frequencies, values)]
    (folder / "tap.csv").write_text("frequency,real,imag\n" + "\n".join(rows))  # without a unit
    return in_gui("gui_stability_session.py", folder, EVENLOAD_TAP_TEST=str(folder / "tap.csv"))


def test_the_command_is_in_menu_and_toolbar(session):
    assert "EvenLoad Stability Chart" in session["actions"]


def test_without_modes_the_window_says_what_to_do(session):
    assert "tap test" in session["empty"]


def test_a_tap_test_is_fitted_and_kept_with_the_tool_controller(session):
    tap = session["tap"]
    assert "unit" in tap["asks"] and not tap["ok_before"]
    assert tap["ok"] and tap["fitted"].startswith("7")
    assert session["rows"] == 1
    assert session["kept"] == [pytest.approx(MODE.frequency, rel=1e-3)]


def test_the_verdict_is_told_and_shown(session):
    assert session["verdict"].startswith("The cut is unstable") and session["stable"] is False
    assert session["cut_off"] == []
    assert "Pocket: the same tool controller." in session["verdict"]


def test_it_follows_quickly_and_the_window_stays_alive(session):
    # By what the same takes without a window, for other work may hold the machine up.
    first, whole = session["alone"]
    assert session["first"] < 2 * first + 0.3 and session["all"] < 2 * whole + 0.5
    assert session["gap"] < 1e3 * (0.5 * whole + 0.3)  # ms; a picture takes 0.06 s
    assert session["cancel"][len(session["cancel"]) // 2] < 0.05


def test_nothing_is_taken_beside_an_open_panel(session):
    assert session["beside_panel"] == ["Close the open panel first.", True]


def test_a_click_chooses_a_cut_and_changes_nothing_yet(session):
    speed, depth, wanted_speed, wanted_depth = session["clicked"]
    assert speed == pytest.approx(wanted_speed, rel=0.01)
    assert depth == pytest.approx(wanted_depth, rel=0.03)
    assert session["boxes"] == [pytest.approx(speed, abs=0.5), pytest.approx(depth, abs=5e-4)]
    assert session["between"] == session["before"]


def test_apply_keeps_the_feed_per_tooth_and_is_one_step_to_undo(session):
    before, after = session["before"], session["after"]
    speed, depth = session["boxes"]
    assert after["speed"] == pytest.approx(speed) and after["valid"]
    assert after["step"] == pytest.approx(min(depth, 3.0))
    for feed in ("feed", "plunge"):
        assert after[feed] / after["speed"] == pytest.approx(before[feed] / before["speed"])
    assert session["after_verdict"].startswith("The cut is stable")
    assert session["undone"] == before and session["redone"] == after


def test_it_follows_the_units_that_the_user_chooses(session):
    seen, metric = session["units"]["inches"], session["units"]["mm"]
    depth, rate, error, now = session["units"]["best"]
    assert seen["is_same"] and metric["is_same"]
    assert seen["boxes"][0] == "%.5f in" % (depth / 25.4) and seen["error"] == " in"
    verdict, best = seen["told"]
    shown = float(re.search(r"rev/min and ([\d.]+) in", verdict)[1])
    assert shown == pytest.approx(depth / 25.4, rel=5e-3)  # three digits in mm
    assert best.startswith("Removes %.3g in³/min, now %.3g" % (rate / 25.4**3, now / 25.4**3))
    assert "location error %.4f in," % (error / 25.4) in best
    assert not re.search(r"\bmm\b|cm³|µm", verdict + best)
    assert seen["axis"] == "axial depth, in" and metric["axis"] == "axial depth, mm"
    ticks = [float(each) for each in seen["ticks"]]
    assert len(ticks) > 2 and max(ticks) < 2 * float(seen["boxes"][1].split()[0])
    assert metric["boxes"][0] == "%.3f mm" % depth and "cm³/min" in metric["told"][1]


def test_the_best_cut_is_shown_and_taken(session):
    speed, depth, cut_mode, radius = session["best"]
    assert radius <= 0.85 + 1e-6
    assert session["best_boxes"][:2] == [
        pytest.approx(speed, abs=0.5),
        pytest.approx(depth, abs=5e-4),
    ]
    assert session["best_boxes"][2] == cut_mode and "Removes" in session["best_text"]
    taken = session["best_taken"]
    assert taken["speed"] == pytest.approx(speed, abs=0.5)
    assert taken["step"] == pytest.approx(min(depth, 3.0), abs=5e-4)
    assert taken["mode"].lower() == cut_mode and taken["valid"]
    assert session["best_verdict"].startswith("The cut is stable")


def test_a_double_click_takes_a_cut_at_once(session):
    speed, depth, taken_speed, taken_depth = session["double"]
    assert taken_speed == pytest.approx(speed, rel=0.01)
    assert taken_depth == pytest.approx(depth, rel=0.05)


def test_a_mode_that_cannot_be_is_told_in_a_sentence(session):
    assert session["wrong"].startswith("Mode 1:") and "damping" in session["wrong"]
    assert session["mended"].startswith("The cut is")


def test_an_operation_of_freecad_has_a_chart_too(session):
    told, engagement = session["pocket"]
    assert told.startswith("The cut is") and engagement > 90


def test_the_window_reads_what_is_kept_and_closes_with_its_document(session):
    assert session["closed"] and session["again"] == 1 and session["gone"]


def test_the_best_cut_of_another_operation_is_not_told(session):
    assert session["best_of_another"] == [True, True, ""]
