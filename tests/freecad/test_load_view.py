"""The load of operations in the 3D view (see gui_load_session.py)."""

import math
from types import SimpleNamespace

import numpy
import pytest
from conftest import in_gui
from evenload.gui import load_colours
from evenload.planar import CUT, LINK

pytestmark = pytest.mark.between

LEAST_LIGHTNESS_APART = 17
SHOWN, HIDDEN = -3, -1  # of a Coin switch


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_load_session.py reports."""
    return in_gui("gui_load_session.py", tmp_path_factory.mktemp("load"))


def test_nothing_of_it_exists_until_it_is_asked_for(session):
    assert session["before"] == 0


@pytest.mark.parametrize("which", ["ours", "theirs"])
def test_the_command_shows_one_node_and_its_dock(session, which):
    assert session[which + "_shown"] == [1, 1]


def test_the_colours_lie_over_the_path_s_own_line(session):
    before, shown = session["own_line"]
    assert before > 1000
    assert shown < 0.02 * before


@pytest.mark.parametrize("which", ["ours", "theirs"])
def test_the_vertices_are_the_simulators_samples(session, which):
    seen = session[which]
    assert seen["samples"] > 1000
    assert seen["vertices"] == seen["colours"] == seen["samples"]
    assert seen["counts"] == [seen["samples"]]
    assert seen["off"] < 1e-4  # Coin has single precision


@pytest.mark.parametrize("which", ["ours", "theirs"])
def test_the_colours_are_those_of_the_simulators_values(session, which):
    measures = session[which]["measures"]
    keys = {"engagement_deg", "removal_rate", "feed", "h_max", "force_peak", "kind"}
    assert set(measures) == keys
    for key, seen in measures.items():
        measure = next(each for each in load_colours.MEASURES if each.key == key)
        least, largest = seen["range"]
        assert key == "kind" or largest == pytest.approx(seen["worst"], rel=1e-6)
        for colour, value, kind, mean in zip(
            seen["colours"], seen["values"], seen["kinds"], seen["means"]
        ):
            wanted = load_colours.KINDS[kind]
            is_loaded = kind in measure.loaded and value > 0
            if (kind in measure.kinds or is_loaded) and math.isfinite(value):
                wanted = load_colours.on_scale((value - least) / (largest - least))
                if seen["limit"] is not None and mean > seen["limit"] and kind == CUT:
                    wanted = load_colours.BEYOND
            assert colour == pytest.approx(list(wanted), abs=1e-6), key


@pytest.mark.parametrize("which", ["ours", "theirs"])
def test_cuts_along_walls_are_a_kind_of_moves(session, which):
    seen = session[which]
    swatches = seen["measures"]["kind"]["swatches"]
    assert swatches == ["cut", "cut along a wall", "entry", "link", "rapid"]
    # Once round the square of 30 mm less the tool's radius, and what else ends at a wall.
    assert 4 * 24 <= seen["at_walls"] < 2 * 4 * 24


def test_only_ours_have_a_limit_of_engagement(session):
    assert session["ours"]["measures"]["engagement_deg"]["limit"] == pytest.approx(62)
    assert session["theirs"]["measures"]["engagement_deg"]["limit"] is None


def test_the_legend_tells_of_the_limit_and_of_what_is_not_on_the_scale(session):
    title, is_visible, swatches = session["legend"]
    assert title == "Load of Ours" and is_visible
    assert swatches == ["cut above 62.0°", "entry", "link", "rapid"]


@pytest.mark.core
def test_links_that_meet_nothing_are_told_from_cuts_that_do():
    kinds, degrees = numpy.array([CUT, CUT, LINK, LINK]), numpy.array([0.0, 50.0, 0.0, 50.0])
    found = SimpleNamespace(x=kinds, kind=kinds, engagement_deg=degrees, length=0.1 * kinds)
    colours = load_colours.colours_of(load_colours.MEASURES[0], found, 0.0, 50.0)
    assert colours[2].tolist() == list(load_colours.KINDS[LINK])
    assert colours[0].tolist() == load_colours.on_scale(0.0).tolist() != colours[2].tolist()
    assert colours[3].tolist() == colours[1].tolist()


def test_the_slider_moves_the_tool_along_the_path(session):
    seen = session["cursor"]
    x, y, z = seen["place"]
    above = 1.5 * seen["diameter"]  # the tool's middle
    assert seen["tool"] == pytest.approx([x, y, z + above], abs=0.01)
    assert "°" in seen["told"] and "mm/min" in seen["told"] and " N" in seen["told"]


def test_fly_to_the_worst_goes_where_the_value_is_largest(session):
    seen = session["cursor"]
    assert seen["middle"] == pytest.approx(seen["worst"], abs=0.01)
    assert seen["largest"][0] == pytest.approx(seen["largest"][1], rel=1e-6)
    assert seen["largest"][0] < 63  # of the operation at 60 degrees


def test_the_open_dock_follows_the_units_that_the_user_chooses(session):
    seen = session["units"]
    rate, feed, chip, force = seen["values"]
    assert rate > 100 and chip > 1e-3
    told = dict(zip(seen["inches"][::2], seen["inches"][1::2]))
    assert told["Removal rate"] == "%.4f in³/min" % (rate / 25.4**3)
    assert told["Feed"] == "%.1f in/min" % (feed / 25.4)
    assert told["Chip thickness"] == "%.5f in" % (chip / 25.4)
    assert told["Force"] == "%.0f N" % force
    told = dict(zip(seen["mm"][::2], seen["mm"][1::2]))
    assert told["Removal rate"] == "%.0f mm³/min" % rate
    assert told["Chip thickness"] == "%.4f mm" % chip


def test_it_follows_each_computation(session):
    degrees, nodes, docks = session["followed"]
    assert 35 < degrees < 45 and nodes == docks == 1 and session["same_view"]


def test_it_stands_back_while_a_preview_shows_another_path(session):
    told = "The preview is shown; Apply or Cancel brings the load back."
    *load_first, hidden, told_first, shown, is_told = session["beside_a_preview"]
    assert load_first == [42, SHOWN, 42, HIDDEN, told, 42, SHOWN, False]
    assert [hidden, told_first, shown, is_told] == [HIDDEN, told, SHOWN, False]


def test_all_of_a_panel_s_status_is_seen_in_a_low_window(session):
    height, needed = session["status_room"]
    assert height >= needed


def test_an_operation_out_of_its_job_is_told_so_and_a_new_name_is_followed(session):
    told, is_gone, *again, index, title = session["out_of_its_job"]
    assert told == "'Ours' belongs to no job: put it into one." and is_gone
    assert again == [False, False] and index == 2 and title == "Load of Renamed"


def test_a_path_that_is_no_operation_s_is_refused_in_a_sentence(session):
    assert session["plain"] == [0, 0]


def test_cancel_of_the_first_simulation_leaves_nothing(session):
    assert session["first_stopped"] == [0, 0]


def test_it_follows_what_is_cut_before_its_operation(session):
    alone, after = session["after_earlier"]
    assert alone > 1000 and after < 0.05 * alone


def test_an_operation_that_loses_its_path_is_told_so_until_it_has_one_again(session):
    told, has_slider, nodes, *again = session["no_path"]
    assert told == "'Theirs' is not active: activate it first."
    assert not has_slider and nodes == 0
    assert again == [False, True, 1]


def test_cancel_stops_it_and_colours_of_another_path_are_gone(session):
    told = "The simulation was cancelled."
    assert session["stopped"] == [HIDDEN, True, True, False, False, told, 0]


def test_it_goes_with_its_command_its_dock_its_operation_and_its_document(session):
    assert session["ours_hidden"] == [0, 0]
    assert session["deleted"] == [0, 0]
    assert session["dock_closed"] == [0, 0]
    assert session["document_closed"] == 0


def test_a_hundred_thousand_samples_are_there_in_half_a_second(session):
    assert session["seconds"] < 0.5


def lightness(colour):
    """CIE L* of a colour of sRGB, 0 to 100."""
    linear = [
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in map(float, colour)
    ]
    y = sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), linear))
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


@pytest.mark.core
def test_the_scale_and_the_kinds_of_moves_can_be_told_apart_in_greyscale():
    scale = [lightness(colour) for colour in load_colours.on_scale(numpy.linspace(0, 1, 50))]
    assert all(after > before for before, after in zip(scale, scale[1:]))
    kinds = sorted(lightness(colour) for colour in load_colours.KINDS.values())
    apart = [after - before for before, after in zip(kinds, kinds[1:])]
    assert min(apart) >= LEAST_LIGHTNESS_APART
    assert load_colours.KINDS[CUT] == min(load_colours.KINDS.values(), key=lightness)
