"""Sentences in the user's language: recognised by what they were made from, whatever they name."""

import re

import pytest
from evenload import findings, refusals, translation
from evenload.settings import notes, sentences
from evenload.settings.labels import told
from languages import FILES, translator
from test_findings import NUMBERS
from test_refusals import NUMBERS as OF_REFUSALS

import collect  # noqa: I100

pytestmark = pytest.mark.core  # texts alone, which no FreeCAD and no Python reads otherwise

LANGUAGES = sorted(FILES)
FILLED = "17.25", "Kind"  # a number and a name that stand in no pattern
REFUSAL = "Maximum feed is 10 mm/min: it must not be below the tool controller's horizontal feed "
REFUSAL += "of 255 mm/min."


@pytest.fixture
def speak(monkeypatch):
    """Has what is shown in a language."""
    return lambda language: monkeypatch.setattr(translation, "translator", translator(language))


def test_without_a_window_sentences_stay_as_they_are():
    assert sentences.shown(REFUSAL) == REFUSAL
    assert translation.translate("Cut mode") == "Cut mode"
    assert "".join(piece.text for piece in notes.shown_pieces(REFUSAL)) == REFUSAL


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("code", sorted(findings.SENTENCES))
def test_each_finding_is_shown_in_the_language_with_all_that_it_tells(code, language, speak):
    _is_shown(told(findings.sentence(code, (1.5, -2.25), NUMBERS.get(code, ()))), speak, language)


@pytest.mark.parametrize("is_one_of_several", [False, True])
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", sorted(refusals.SENTENCES))
def test_each_refusal_is_shown_in_the_language(kind, language, is_one_of_several, speak):
    given = kind, (1.5, -2.25), OF_REFUSALS.get(kind, ()), is_one_of_several
    _is_shown(told(refusals.sentence(*given)), speak, language)


def _is_shown(said, speak, language):
    """A sentence is shown in a language, with all that it tells."""
    speak(language)
    shown = sentences.shown(said)
    assert shown != said and not re.search(r"\b(the|near|is|where)\b", shown), shown
    assert re.findall(r"\([\d., -]+\)", shown) == re.findall(r"\([\d., -]+\)", said)
    assert sorted(re.findall(r"\d+\.\d+", shown)) == sorted(re.findall(r"\d+\.\d+", said))
    assert not re.search(r"\[[A-Z]|%\d", shown), shown


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("pattern", collect.patterns())
def test_each_pattern_is_known_by_what_it_becomes(pattern, language, speak):
    """No pattern takes another's sentences."""
    text, values = _example(pattern)
    speak(language)
    if translation.length(pattern) < sentences.LEAST:
        assert sentences.marked(text) is None  # a part of sentences only
        return
    own = translation.translate(translation.numbered(pattern))
    expected = translation.filled(own, values)
    assert sentences.marked(text) == (None if expected == text else expected)


def _example(pattern):
    """(what a pattern becomes, with what it is filled)"""
    values = []

    def fill(place):
        if place.group() == "%%":
            return "%"
        values.append(FILLED[place.group().endswith(("s", "r", "{place}"))])
        return values[-1]

    return re.sub(r"%%|%[-+ #0]*[\d.]*[a-z]|\{[^}]*\}", fill, pattern), values


CASES = [
    (
        REFUSAL,
        "Größter Vorschub ist 10 mm/min: darf nicht unter dem horizontalen Vorschub der "
        "Werkzeugsteuerung von 255 mm/min liegen.",
    ),
    # A text of a macro, which names the property.
    ("HelixAngle is 95 degrees: it must lie between 0 and 90 degrees.", None),
    (
        "Helix angle is 95 degrees: it must lie between 0 and 90 degrees.",
        "Helixwinkel ist 95 Grad: muss zwischen 0 und 90 Grad liegen.",
    ),
    (
        "Start Depth (0 mm) does not lie above Final Depth (4 mm): raise Start Depth or lower "
        "Final Depth.",
        "Starttiefe (0 mm) liegt nicht über Endtiefe (4 mm): Starttiefe erhöhen oder Endtiefe "
        "senken.",
    ),
    (
        "Face7, Face9 and 4 more of Side and top: cut down to -3 mm.",
        "Face7, Face9 und 4 weitere von Side and top: bis -3 mm geschnitten.",
    ),
    (
        "Face7 of Model and Face3 of Other looks down: pick a face that looks up.",
        "Face7 von Model und Face3 von Other zeigt nach unten: eine Fläche wählen, die nach oben "
        "zeigt.",
    ),
    (
        "The tool 'Drill near the end' is a drill: choose a flat or bull-nosed end mill.",
        "Das Werkzeug „Drill near the end“ ist ein Bohrer: einen Fräser wählen, flach oder mit "
        "Eckenradius.",
    ),
    (
        "Spacing is 'Constant cusp height', but the tool 'T1' has a flat end, which leaves steps: "
        "take a ball end mill, or another Spacing.",
        "Aufteilung ist „Konstante Rillenhöhe“, aber das Werkzeug „T1“ hat ein flaches Ende, das "
        "Stufen lässt: einen Kugelfräser nehmen, oder Aufteilung anders wählen.",
    ),
    (
        "Command 3 of the path, G43, is not known to the simulator: leave it out.",
        "Befehl 3 der Bahn, G43, ist dem Simulator nicht bekannt: weglassen.",
    ),
    (
        "Whether the cut is stable is not known: 'Op' has no spindle speed: set the tool "
        "controller's.",
        "Ob der Schnitt stabil ist, ist nicht bekannt: „Op“ hat keine Spindeldrehzahl: die der "
        "Werkzeugsteuerung setzen.",
    ),
    (
        "Face1 of Part has stock beyond 2 sides without a wall, the first near (1.000, 2.000): it "
        "is cleared up to 3 mm from the face, and what lies further out stays.",
        "Face1 von Part hat Rohteil jenseits von 2 Seiten ohne Wand, die erste bei (1.000, "
        "2.000): bis zu 3 mm von der Fläche wird ausgeräumt, und was weiter außen liegt, bleibt "
        "stehen.",
    ),
    (
        "Outside of what the source measured, a guess: stepover 0.2, not 0.15 mm; spindle speed "
        "8000 rev/min, not 5100; passes One way, not Zig-zag.",
        "Außerhalb dessen, was die Quelle gemessen hat, eine Schätzung: Bahnabstand 0.2, nicht "
        "0.15 mm; Spindeldrehzahl 8000 U/min, nicht 5100; Bahnen Eine Richtung, nicht Zickzack.",
    ),
    (
        "No candidate is within the limits: the tools' cutting length refuses most, 20 of 25, as "
        "in: 12 mm is deeper than the cutting length of T; 1, 9 mm.",
        "Kein Kandidat hält die Grenzen ein: die Schneidenlänge verhindert die meisten, 20 von "
        "25, etwa so: 12 mm ist tiefer als die Schneidenlänge von T; 1, 9 mm.",
    ),
    (
        "No candidate is within the limits: the force refuses most, 5 of 5, as in: At the least "
        "chip of 0.012 mm the force of the tool of 10 mm at 90°, 5 mm deep, is above 20 N.",
        "Kein Kandidat hält die Grenzen ein: die Kraft verhindert die meisten, 5 von 5, etwa so: "
        "Bei der kleinsten Spandicke von 0.012 mm liegt die Kraft über 20 N (Werkzeug von 10 mm "
        "bei 90°, 5 mm tief).",
    ),
    (
        "The profile of a surface is 0.0123 mm, of 49 points.",
        "Profil einer Fläche: 0.0123 mm, aus 49 Punkten.",
    ),
    (
        "The cylindricity is 0.000484 in, of 49 points, at a radius of 0.3937 in.",
        "Zylindrizität: 0.000484 in, aus 49 Punkten, bei einem Radius von 0.3937 in.",
    ),
    # Nothing of ours, and several lines.
    ("Somebody else's sentence of 3 words and more.", "Somebody else's sentence of 3 words and "),
    ("Checked against the model.\nCancelled before everything was cut.", "Gegen das Modell "),
]


@pytest.mark.parametrize("said, expected", CASES)
def test_sentences_are_shown_in_german(said, expected, speak):
    speak("de")
    shown = sentences.shown(said)
    assert shown.startswith(expected if expected else "Helixwinkel ist 95 Grad: muss zwischen 0")
    assert shown.count("\n") == said.count("\n") and "Cancelled" not in shown


def test_a_shown_sentence_keeps_its_places_and_fields(speak):
    speak("hu")
    said = told("EntryPoint is (1.5, -2), outside Face3 of Part: move it inside.")
    pieces = notes.shown_pieces(said)
    assert [piece.field for piece in pieces if piece.field] == ["EntryPoint"]
    assert [piece.place for piece in pieces if piece.place] == [(1.5, -2.0, None)]
    assert "".join(piece.text for piece in pieces) == (
        "Furat helye: (1.5, -2), ezen kívül: Part: Face3: helyezze belülre."
    )


def test_freecads_own_labels_are_as_freecad_shows_them(monkeypatch):
    known = {("Form", "Start Depth"): "Anfang", ("EvenLoad", "Final Depth"): "Ende"}
    monkeypatch.setattr(translation, "translator", lambda *key: known.get(key) or key[1])
    assert sentences.label_of("StartDepth") == "Anfang"
    assert sentences.label_of("FinalDepth") == "Ende"
