"""The status on top of panels, what they fold, and how their fields behave (see
gui_panel_session.py).
"""

import re

import pytest
from conftest import in_gui
from evenload.settings import notes


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    """What gui_panel_session.py reports."""
    return in_gui("gui_panel_session.py", tmp_path_factory.mktemp("panel"))


def test_panels_fit_into_freecads_narrow_dock(session):
    widths = [int(name.split()[2]) for name in session["wide"]]
    assert widths.count(264) == widths.count(300) == 16
    assert {name: found for name, found in session["wide"].items() if found} == {}


def test_an_arrow_adds_a_sensible_step(session):
    for schema, length, feed in (("6", 0.05, 10 / 60), ("3", 0.002 * 25.4, 0.5 * 25.4 / 60)):
        steps = session["fields"]["steps"][schema]
        assert steps["EngagementAngle"] == pytest.approx(1)
        # FreeCAD rounds what it shows to two decimals.
        assert steps["SideStep"] == pytest.approx(length, abs=0.13 if schema == "3" else 0.006)
        assert steps["MaximumFeed"] == pytest.approx(feed, rel=0.02)


def test_a_press_of_an_arrow_adds_two_thousandths_of_an_inch_and_they_are_seen(session):
    seen = session["fields"]["stepped"]
    for name in ("RollRadius", "StockToLeave"):
        lengths = [length / 25.4 for _, length in seen[name]]
        added = [after - before for before, after in zip(lengths, lengths[1:])]
        assert added == pytest.approx(3 * [0.002], rel=1e-6), name
        shown = [float(text.replace(",", ".").split()[0]) for text, _ in seen[name] if text]
        assert shown == pytest.approx(lengths[len(lengths) - len(shown) :], abs=5.1e-5), name


def test_what_is_typed_and_stepped_in_inches_counts_as_it_is_typed(session):
    struck, tenth_mm = session["fields"]["stepped"]["struck"], 0.1 / 25.4
    wanted = {"a thousandth": 0.002, "then an arrow": 0.005, "and left": 0.003, "down": 0}
    wanted.update({"up again": 0.002, "mm": tenth_mm, "none": 0})
    kept = ("nothing", "backspaces", "number only", "sum", "below", "words")
    kept = dict.fromkeys(kept, tenth_mm)
    for name, length in {**wanted, **kept}.items():
        text, found = struck[name]
        assert found == pytest.approx(length, abs=1e-9), name
        assert text.replace(",", ".") == "%.4f in" % length, name


def test_a_length_in_inches_stays_where_units_change_or_it_is_set_elsewhere(session):
    in_mm, in_inches, elsewhere = session["fields"]["stepped"]["other_units"]
    assert in_mm[0].replace(",", ".") == "0.05 mm" and in_mm[2] == 0
    assert in_inches[0].replace(",", ".") == "0.0020 in"
    assert in_mm[1] == in_inches[1] == pytest.approx(0.0508) and elsewhere == 0.3


def test_an_expression_that_is_entered_in_the_open_panel_counts_at_once(session):
    seen = session["fields"]["bound_while_open"]
    step, angle, is_enabled, is_dirty, value, is_enabled_again = seen
    assert step.startswith(("1.80", "1,80")) and angle.startswith(("66.42", "66,42"))
    assert not is_enabled and is_dirty and value == pytest.approx(1.8) and is_enabled_again


def test_a_length_that_is_shown_finely_has_the_users_unit(session):
    assert session["fields"]["tolerance 6"].replace(",", ".") == "0.0050 mm"
    assert session["fields"]["tolerance 3"].replace(",", ".") == "0.000197 in"


def test_what_is_not_set_looks_so_and_keeps_what_needs_it_shut(session):
    seen = session["fields"]
    assert seen["unset"] == ["none", "none", "no limit"]
    assert seen["hole"] == 9 and seen["hole_enabled"] == [False, True]
    assert seen["unset_again"] == ""


def test_what_is_changed_elsewhere_stays_at_ok(session):
    assert session["changed_elsewhere"] == "Conventional"


def test_a_field_takes_nothing_beyond_its_limits_and_shows_what_holds(session):
    radius, radius_text, angle, angle_text = session["fields"]["beyond"]
    assert radius == pytest.approx(0.9) and radius_text.startswith(("0.90", "0,90"))
    assert angle == pytest.approx(60) and angle_text.startswith("60")


def test_a_share_of_the_diameter_is_the_side_step_too(session):
    step, angle = session["fields"]["share"]
    assert step == pytest.approx(3) and angle == pytest.approx(90)


def test_what_an_expression_sets_is_not_edited_nor_what_follows_it(session):
    seen = session["fields"]["bound"]
    angle, step, tolerance = (seen[n] for n in ("EngagementAngle", "SideStep", "Tolerance"))
    assert not angle["SideStep"] and not angle["share"] and angle["Tolerance"]
    assert angle["tips"][1] == "Set by the expression of 'Engagement angle'"
    assert not step["EngagementAngle"] and not step["share"]
    assert step["tips"][0] == "Set by the expression of 'Side step'"
    assert not tolerance["Tolerance"] and tolerance["SideStep"] and tolerance["share"]
    assert all(each["RollRadius"] and "expression" not in each["tips"][3] for each in (angle, step))
    assert all(seen["after"])


def test_a_panel_opens_with_expressions_of_one_number_of_a_place_and_with_failing_ones(session):
    of_a_number, failing = session["fields"]["bound_before"]
    assert "Preview: Apply checks and stores the path" in of_a_number
    assert "cannot be evaluated: mend it." in failing and "Stock to leave" in failing


def test_what_is_unfolded_stays_so(session):
    assert session["remembered"]["Feeds"] is True
    assert [open_ for title, open_ in session["remembered"].items() if title != "Feeds"] == [
        False
    ] * (len(session["remembered"]) - 1)


def test_the_status_stands_on_top_and_tells_what_a_path_takes(session):
    seen = session["status"]
    assert seen["on_top"]
    lines = seen["valid"].splitlines()
    assert lines[0] == "\u2714 Valid, checked against the model"
    time = re.match(r"Time (\d:\d\d:\d\d) \(1\.\d\d of the ideal\)", lines[1])[1]
    assert time == seen["cycle_time"]
    assert re.match(r"Engagement up to 6\d\.\d°", lines[2])
    assert lines[3].startswith("Uncut 0") and lines[4] == "Retracts 0"
    assert seen["changed"].startswith("\u25cf Changed")


def test_the_job_sums_up_our_times(session):
    hours, minutes, seconds = map(int, session["job_time"].split(":"))
    total = 3600 * hours + 60 * minutes + seconds
    assert total == pytest.approx(sum(session["times"]), abs=len(session["times"]))


def test_ok_refuses_a_value_that_cannot_be_and_marks_its_field(session):
    seen = session["status"]
    assert seen["open"] and seen["path"] > 10
    assert seen["refused"].startswith("\u2716 Maximum feed is 10 mm/min: it must not be below")
    *is_shown, text = seen["field"]
    assert is_shown == [True, True, True] and text in ("10.", "10,")
    assert seen["closed"]


def test_a_failed_apply_says_why_in_the_words_of_the_labels(session):
    is_valid, text = session["status"]["failed"]
    assert not is_valid and text.startswith("\u2716 Maximum feed is 10 mm/min")
    assert session["status"]["mended"].startswith("\u2714 Valid") and session["status"]["unmarked"]


def test_a_refusal_leads_to_freecads_own_page_of_depths(session):
    assert session["status"]["depth"].startswith("\u2716 Start Depth (0 mm) does not lie above")
    assert session["status"]["depth_page"]


def test_a_click_on_a_place_in_a_note_flies_there_and_wishes_are_folded(session):
    seen = session["notes"]
    assert "Turned more tightly than the wished 0.900 mm" in seen["text"]
    assert seen["warnings"] == "" and seen["remarks_folded"] and seen["remarks_unfolded"]
    x, y, _ = seen["place"]
    assert seen["middle"] == pytest.approx([x, y, -3.0], abs=0.01)


def test_a_click_on_a_place_that_is_told_in_inches_flies_to_the_same(session):
    seen, in_mm = session["notes in inches"], session["notes"]
    assert "Turned more tightly than the wished 0.0354 in" in seen["text"]
    assert not re.search(r"\bmm\b|mm²", seen["text"])
    assert seen["place"] == in_mm["place"]
    assert seen["middle"] == pytest.approx(in_mm["middle"], abs=1e-3)


WISH = "Turned more tightly than the wished 0.900 mm in corners, down to 0.1 mm near (3.000, 4.5)."


@pytest.mark.parametrize(
    "sentence, kind",
    [
        (WISH, notes.WISH),
        ("Helix diameter 9 mm was taken as 5.88 mm: a wider helix would leave a post.", notes.WISH),
        ("Pitch is smaller than set in some turns, down to 1 mm: ...", notes.WISH),
        ("Checked against the model.", notes.FACT),
        ("Face3 of Part: cut down to -3 mm.", notes.FACT),
        ("Not checked against the model: Check is off.", notes.WARNING),
        ("The spindle of 'TC' does not turn: set its Spindle (SpindleDir).", notes.WARNING),
        ("The spindle of 'TC' turns counter-clockwise, as its Spindle says: ...", notes.FACT),
        ("Left uncut: 3.0 mm2 near (1, 2).", notes.WARNING),
    ],
)
def test_wishes_and_facts_are_told_from_warnings(sentence, kind):
    assert notes.kind_of(sentence) == kind


@pytest.mark.core
def test_a_sentence_names_places_and_fields():
    places = [piece.place for piece in notes.pieces_of(WISH) if piece.place]
    assert places == [(3.0, 4.5, None)]
    assert "".join(piece.text for piece in notes.pieces_of(WISH)) == WISH
    cut = "The path cuts 0.3 mm into 'Part' near (1, 2, -3): change the depths."
    assert [piece.place for piece in notes.pieces_of(cut) if piece.place] == [(1, 2, -3)]
    refusal = "Start Depth (0 mm) does not lie above Final Depth (4 mm): raise Start Depth."
    assert notes.fields_of(refusal) == ["StartDepth", "FinalDepth", "StartDepth"]
    # Words of English are fields only where they begin what is said of them.
    assert notes.fields_of("Material stands above Start Depth (2 mm): raise it.") == ["StartDepth"]
    assert notes.fields_of("Rest is 'None': ...") == ["Rest"]
