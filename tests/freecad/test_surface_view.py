"""The surface of an operation as colours on its faces (see gui_surface_session.py)."""

import math

import pytest
from conftest import in_gui

pytestmark = pytest.mark.between

BALL = 5.0


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_surface_session.py reports."""
    return in_gui("gui_surface_session.py", tmp_path_factory.mktemp("surface"))


def test_nothing_of_it_exists_until_it_is_asked_for(session):
    assert session["before"] == [0, 0]


def test_the_command_simulates_in_a_thread_and_shows_one_node_and_its_dock(session):
    assert session["busy"] and session["bar_gone"]
    assert session["shown"] == [1, 1]


def test_each_measure_colours_all_vertices(session):
    assert list(session["seen"]) == [
        *("cusp", "rest", "gouge", "h_m", "tip_share", "rz_along", "rz_across")
    ]
    for key, seen in session["seen"].items():
        assert seen["colours"] == session["vertices"] > 10_000
        assert seen["kinds"] > 5 or key == "gouge"
        assert seen["scale"][0] == 0 < seen["scale"][1]


def test_vertices_have_the_colours_of_the_values_at_their_places(session):
    for key, seen in session["seen"].items():
        assert len(seen["some"]) == 20
        for colour, wanted in seen["some"]:
            assert colour == pytest.approx(wanted, abs=1e-6)
        assert key == "gouge" or len({tuple(wanted) for _, wanted in seen["some"]}) > 3


def test_fly_to_the_worst_looks_at_the_largest_value(session):
    aim, place, height = session["flown"]
    assert aim == pytest.approx(place, abs=1e-2)  # the scene has floats
    assert height <= 12 * 2 * BALL


def test_inches_and_decimal_commas_are_the_user_s(session):
    mean, scale = session["mean_cusp"], session["seen"]["cusp"]["scale"][1]
    figures, unit, largest = session["units"]["inches"]
    assert "%.1f µin" % (mean / 25.4e-6) in figures and "µm" not in figures
    assert "%.4f in²" % (session["uncovered"] / 25.4**2) in figures
    assert unit == "µin" and largest == pytest.approx(scale * 1e-3 / 25.4e-6)
    figures, unit, largest = session["units"]["comma"]
    assert ("%.2f µm" % (1e3 * mean)).replace(".", ",") in figures
    assert unit == "µm" and largest == pytest.approx(scale)


def test_the_scales_are_those_of_the_values(session):
    seen = session["seen"]
    flat = 1e3 * (BALL - math.sqrt(BALL**2 - 0.8**2 / 4))
    assert 0.8 * flat < seen["cusp"]["scale"][1] < 4 * flat  # on the fillets they are higher
    assert seen["gouge"]["largest"] == 0
    assert 50 < seen["tip_share"]["scale"][1] <= 100
    assert 1 < seen["h_m"]["scale"][1] < 50


@pytest.mark.parametrize("key", ["rz_along", "rz_across"])
def test_roughness_is_that_of_the_surface_simulation(session, key):
    seen, known = session["seen"][key], session["rough"][key]
    assert seen["largest"] == pytest.approx(max(known), rel=1e-12)
    assert 0 < seen["scale"][1] <= 1e3 * max(known) * (1 + 1e-9)


def test_the_figures_tell_the_mean_cusp(session):
    assert "%.2f µm" % (1e3 * session["mean_cusp"]) in session["figures"]


def test_a_picture_of_each_measure_is_written(session):
    assert session["pictures"] == 7 * [b"\x89PNG".hex()]


def test_a_changed_path_is_simulated_anew(session):
    assert session["follows"]


def test_cancel_keeps_what_is_known(session):
    assert session["cancelled"] == "The simulation was cancelled."
    assert session["after_cancel"] == [False, True, 1]


def test_what_cannot_be_simulated_takes_the_colours_away_and_says_why(session):
    sentence, nodes, choices = session["refused"]
    assert "V bit" in sentence and (nodes, choices) == (0, 0)


def test_a_view_that_is_gone_reads_nothing(session):
    assert session["waiting"] == [True, False]


def test_it_goes_with_the_command_its_dock_and_its_document(session):
    assert session["closed"] == session["dock_closed"] == [0, 0, 0]
    assert session["document_closed"] == [0, 0]
