"""What is told in metric units is shown in inches to who has chosen them."""

import re

import pytest
from evenload import translation, units
from evenload.settings import notes, sentences
from evenload.units import INCH, in_users_unit
from languages import FILES, translations

METRIC = re.compile(r"\b(mm|cm|m/min)\b|[mc]m[²³]|(?<!N/)µm")


@pytest.fixture
def inches(monkeypatch):
    monkeypatch.setattr(units, "shows_inches", lambda: True)


def test_sentences_are_as_they_were_with_metric_units():
    sentence = "Left uncut: 1.20 mm² near (12.345, 6.700), where the tool has too little room."
    assert in_users_unit(sentence) == sentences.shown(sentence) == sentence


@pytest.mark.parametrize(
    "metric, imperial",
    [
        ("wished 0.750 mm in narrow places", "wished 0.0295 in in narrow places"),
        ("SideStep is 30 mm: it must", "SideStep is 1.1811 in: it must"),
        ("down to -12.7 mm.", "down to -0.5 in."),
        ("1.20 mm² stay uncut", "0.00186 in² stay uncut"),
        ("it is 645.16 mm2 of it", "it is 1 in² of it"),
        ("a feed of 255 mm/min at", "a feed of 10.04 in/min at"),
        ("removes 16387.064 mm³/min", "removes 1 in³/min"),
        ("removes 16.387064 cm³/min", "removes 1 in³/min"),
        ("a cutting speed of 100 m/min.", "a cutting speed of 328.1 ft/min."),
        ("a mean thickness of 3.21 µm.", "a mean thickness of 126.4 µin."),
        ("more than 10 m beyond the stock", "more than 32.8 ft beyond the stock"),
        ("a tolerance of 1e-05 mm", "a tolerance of 0.000000394 in"),
        ("it is 0 mm: it must", "it is 0 in: it must"),
        ("an inch, 25,4 mm lang", "an inch, 1 in lang"),
        ("25,5 mm lang", "1,0039 in lang"),
        ("Feeds: 254 to 508 mm/min, for", "Feeds: 10 to 20 in/min, for"),
        ("Vorschübe: 254 bis 508 mm/min", "Vorschübe: 10 bis 20 in/min"),
        ("előtolásai: 254 – 508 mm/min", "előtolásai: 10 – 20 in/min"),
        ("Radien 2.54 und 25.4 mm an", "Radien 0.1 und 1 in an"),
        ("a square of 25.4 × 50.8 mm", "a square of 1 × 2 in"),
        ("near (25.4, -2.54): clear it", "near (1, -0.1): clear it"),
        ("near (25.4, -2.54, 0.000)", "near (1, -0.1, 0)"),
        ("at (12.345, 6.700) mm, or", "at (0.486, 0.2638) in, or"),
        ("két 25.4 mm-es lap", "két 1 in-es lap"),
    ],
)
def test_values_and_places_are_told_in_inches(inches, metric, imperial):
    assert in_users_unit(metric) == imperial


@pytest.mark.parametrize(
    "sentence",
    [
        "The tool '6 mm end mill' does not cut at its centre.",
        "The tool 'Bob's 6 mm mill' is a drill.",
        "Das Werkzeug „6 mm Fräser“ schneidet nicht.",
        "A(z) „6 mm maró” szerszám nem vág.",
        "The material needs kc1 in N/mm2, as 700.",
        "The stiffness is 10 N/µm at 12 Hz.",
        "Face7 and 3 others of Block mm",
        "The file mixes mm and inch: write it anew in one unit.",
        "The curvature is 2 1/mm.",
        "It lies between 0 and 180, as 45; 60; 75.",
    ],
)
def test_names_and_what_is_no_length_stay(inches, sentence):
    assert in_users_unit(sentence) == sentence


def test_a_place_that_is_shown_in_inches_leads_to_where_it_is_in_mm(inches):
    sentence = "Left uncut: 1.20 mm² near (25.400, -12.700), near '(1, 2) mm' of 3 mm."
    pieces = notes.shown_pieces(sentence)
    assert [(p.text, p.place) for p in pieces if p.place][0] == ("(1, -0.5)", (25.4, -12.7, None))
    assert "".join(p.text for p in pieces) == in_users_unit(sentence)
    assert notes.pieces_of(sentence)[1].text == "(25.400, -12.700)"


def _filled(pattern):
    """A pattern with a number in each place that numbers have, and text in the others."""
    values = {"s": " near Face", "r": "Face", "d": 3}
    text = re.sub(
        r"%[-+ #0]*\d*(?:\.\d+)?([a-z])|\{\w*(?::([^}]+))?\}",
        lambda place: str(values.get(place[1], 12.5 if place[1] or place[2] else "Face")),
        pattern,
    )
    return text.replace("%%", "%")


@pytest.mark.parametrize("language", [None, *FILES])
def test_each_sentence_with_metric_values_has_none_in_inches(inches, monkeypatch, language):
    if language:
        known = translations(language)
        told = lambda context, text: known.get((context, text), text)  # noqa: E731
        monkeypatch.setattr(translation, "translator", told)
    with open(sentences.PATTERNS, encoding="utf-8") as file:
        made = [_filled(line) for line in file.read().splitlines()]
    metric = [each for each in made if re.search(r"12\.5 (mm|µm)", each)]
    assert len(metric) > 70
    for sentence in metric:
        shown = sentences.shown(sentence)
        assert not METRIC.search(shown), shown
        # Of several with one unit none stays as it was.
        assert not re.search(r"(?<![\w.])12\.5[^\w°]+\w{0,4}\W*0\.49", shown), shown


def test_quantities_have_the_unit_of_the_moment(monkeypatch):
    assert units.RATE.shown.told(2000.0) == "2000 mm³/min"
    monkeypatch.setattr(units, "shows_inches", lambda: True)
    assert units.RATE.shown.told(INCH**3) == "1.0000 in³/min"
    assert units.FEED.shown.told(254.0) == "10.0 in/min"
    assert units.CHIP.shown.told(0.0254) == "0.00100 in"
    assert units.ERROR.shown.told(0.0254) == "0.0010 in"
    assert units.ROUGHNESS.shown.told(0.00254) == "100.0 µin"
    assert units.same("N", 0).shown.told(12.4) == "12 N"
