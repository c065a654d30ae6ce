"""The window in German and Hungarian (see gui_language_session.py): all texts are translated, fit
into narrow docks, and what is stored stays English.
"""

import re
import sys
from pathlib import Path

import pytest
from conftest import in_gui
from evenload.settings.setting import CHOICE
from evenload.settings.table import ALL
from PySide import QtCore

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
from languages import FILES, translations  # noqa: E402

pytestmark = pytest.mark.between

NAMES = {"de": "German", "hu": "Hungarian"}  # as FreeCAD has them
COMMANDS = (
    *("Adaptive", "Trochoid", "LameSpiral", "Finishing", "ShowLoad", "Simulation", "Compare"),
    *("Report", "StabilityChart", "Optimise", "Inspect", "FinishingAdvisor", "ShowSurface"),
)
CONTEXT = "EvenLoad"
ENGLISH = re.compile(r"\b(the|of|and|with|from|which|shows?|its)\b")
# Forces are in N with each unit schema, and so is what is measured by them.
METRIC = re.compile(r"\b(mm|m/min)\b|[mc]m[²³]|(?<!N/)µm")
# With FreeCAD set to a language, as its preferences keep it.
CONFIGURATION = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp">
<FCParamGroup Name="Preferences"><FCParamGroup Name="General"><FCText Name="Language">%s</FCText>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def test_all_languages_are_looked_at():
    assert sorted(NAMES) == sorted(FILES)


# One language on each: what differs between them is seen by tests of the files, what differs
# between FreeCADs in either.
ONE_EACH = [
    pytest.param("de", marks=pytest.mark.elsewhere),
    pytest.param("hu", marks=pytest.mark.core),
]


@pytest.fixture(scope="module", params=ONE_EACH)
def language(request):
    return request.param


@pytest.fixture(scope="module")
def known(language):
    """{(context, text): translation}"""
    return translations(language)


@pytest.fixture(scope="module")
def panels(language, tmp_path_factory):
    """What the session tells of a FreeCAD that starts in the language."""
    folder = tmp_path_factory.mktemp("panels_" + language)
    settings = folder / "user.cfg"
    settings.write_text(CONFIGURATION % NAMES[language], encoding="utf-8")
    return _session(folder, language, "panels", "--user-cfg", str(settings))


@pytest.fixture(scope="module")
def docks(language, tmp_path_factory):
    """The same where the user takes the language while FreeCAD runs."""
    return _session(tmp_path_factory.mktemp("docks_" + language), language, "docks")


def _session(folder, language, look_at, *arguments):
    return in_gui(
        *("gui_language_session.py", folder, *arguments),
        EVENLOAD_LANGUAGE=NAMES[language],
        EVENLOAD_LOOK_AT=look_at,
    )


def _in_english(texts, known):
    """Those of the texts that have another translation, or words that only English has."""
    originals = {text.strip() for (_, text), told in known.items() if told != text}
    told = {told.strip() for told in known.values()}
    return [t for t in texts if (t in originals and t not in told) or ENGLISH.search(t)]


@pytest.mark.parametrize("kind", ["panels", "docks"])
def test_commands_have_their_names_in_the_language(kind, known, request):
    seen = request.getfixturevalue(kind)["toolbar"]
    names = ["EvenLoad_" + name for name in COMMANDS]
    for name in names:
        assert any(told in seen for (context, _), told in known.items() if context == name), name
    assert len(seen) == len(names)


@pytest.mark.parametrize("units", ["mm", "inches"])
def test_panels_fit_into_freecads_narrow_dock(panels, units):
    found = panels if units == "mm" else panels["in_inches"]
    fits = {k: v for seen in found["panels"].values() for k, v in seen["fit"].items()}
    widths = [int(name.split()[1]) for name in fits]
    assert widths.count(264) == widths.count(300) == 8
    assert {name: found for name, found in fits.items() if found} == {}


def test_panels_have_no_english_texts(panels, known):
    for command, seen in panels["panels"].items():
        assert len(seen["texts"]) > 40, command
        texts = set(seen["texts"]) - {"None"}  # in FreeCAD's own list, of coolants
        assert _in_english([*texts, *seen["status"].splitlines()], known) == [], command
    assert all("erstellen" in n or "létrehozása" in n for n in panels["undo"] if "EvenLoad" in n)


def test_docks_have_no_english_texts(docks, known):
    assert len(docks["docks"]) == 8
    for name, texts in docks["docks"].items():
        assert len(texts) > 10 and _in_english(texts, known) == [], name


def test_docks_show_no_metric_unit_in_inches(docks):
    for name, texts in docks["docks_in_inches"].items():
        assert [text for text in texts if METRIC.search(text)] == [], name
        # What is seen is not the same for want of anything to convert.
        has_metric = any(METRIC.search(text) for text in docks["docks"][name])
        assert has_metric == (texts != docks["docks"][name])


def test_panels_show_no_metric_unit_in_inches(panels):
    found = panels["in_inches"]
    for command, seen in found["panels"].items():
        texts = [*seen["texts"], *seen["status"].splitlines()]
        assert [text for text in texts if METRIC.search(text)] == [], command
        tips = [text for text in texts if "0.00394 in" in text]  # the mean over 0.1 mm
        assert len(tips) == (command != "EvenLoad_Finishing")
    assert "10.04 in/min" in found["refused"]["status"]
    assert not METRIC.search(found["refused"]["status"])


def test_notes_are_in_inches_and_are_kept_in_mm(panels):
    (status, report), (_, before) = panels["in_inches"]["notes"], panels["notes"]
    assert report == before and "0.0354 in" in status and not METRIC.search(status)
    x, y = map(float, re.search(r"\((\d+\.\d+), (\d+\.\d+)\)", report).groups())
    assert "(%.4f, %.4f)" % (x / 25.4, y / 25.4) in status


def test_choices_are_shown_in_the_language_and_stored_in_english(panels, known):
    rows = {row.name: row for row in ALL if row.type == CHOICE}
    seen = panels["panels"]["EvenLoad_Adaptive"]["choices"]
    assert {"CutMode", "Entry", "FeedControl", "Material"} <= set(seen)
    for name, entries in seen.items():
        assert [stored for _, stored in entries] == list(rows[name].value)
        if name != "Material":
            assert [shown for shown, _ in entries] == [known[CONTEXT, s] for _, s in entries]


def test_a_refusal_is_shown_in_the_language_and_leads_to_its_field(panels, known):
    seen = panels["refused"]
    assert seen["in_english"].startswith("Maximum feed is 10 mm/min: it must not be below the tool")
    assert seen["status"].startswith("\u2716 " + known[CONTEXT, "Maximum feed"])
    assert not ENGLISH.search(seen["status"]) and "255 mm/min" in seen["status"]
    assert seen["fields"] == ["MaximumFeed"] and seen["is_marked"]


def test_notes_are_shown_in_the_language_and_kept_in_english(panels):
    status, report = panels["notes"]
    assert report.startswith("Turned more tightly than the wished 0.900 mm in narrow places")
    assert not ENGLISH.search(status)
    assert re.search(r"\(\d+\.\d+, \d+\.\d+\)", report)[0] in status


def test_what_freecad_loads_is_made_of_the_translations(language, known):
    translator = QtCore.QTranslator()
    assert translator.load(str(FILES[language].with_suffix(".qm")))
    for (context, text), told in known.items():
        assert translator.translate(context, text) == told
