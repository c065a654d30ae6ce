"""Every text of the window has a translation, with all that stands in the text; and no text gets
into the window beside them.
"""

import ast
import re

import pytest
from evenload.settings import sentences
from evenload.settings.setting import CHOICE
from evenload.settings.table import ALL
from evenload.translation import CONTEXT
from languages import FILES, ROOT, translations

import collect  # noqa: I100
import joined

LANGUAGES = sorted(FILES)
TEXTS = collect.texts()
# What is filled in: of Python, in its order; of numbered texts, in any.
OF_PYTHON, NUMBERED = re.compile(r"%[\d.*]*[a-z]|%%"), re.compile(r"%\d")
ENDS = ".", "…", " "
# What is the same in the language.
SAME = {
    "de": {
        *("Operation", "Simulation", "Zone", "Matrix", "EvenLoad Simulation", "Helix"),
        *("horizontal", "Mode %d: %s", "Radius"),
    },
    "hu": set(),
}


def test_there_are_german_and_hungarian():
    assert {"de", "hu"} <= set(LANGUAGES)


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_text_has_a_finished_translation_and_none_is_of_a_text_that_is_gone(language):
    found = translations(language)
    assert sorted(found) == sorted((context, text) for context, text, _ in TEXTS)
    assert [key for key, told in found.items() if told is None] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_is_no_copy_of_the_english(language):
    copies = {text for (_, text), told in translations(language).items() if told == text}
    assert {text for text in copies if re.search("[a-z]{3}", text)} <= SAME[language]


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_has_the_places_of_its_text(language):
    for (_, text), told in translations(language).items():
        if NUMBERED.search(text):
            assert sorted(NUMBERED.findall(told)) == sorted(NUMBERED.findall(text)), text
        else:
            assert OF_PYTHON.findall(told) == OF_PYTHON.findall(text), text
        assert told.count("\n") == text.count("\n"), text
        assert told.endswith(ENDS) == text.endswith(ENDS), text


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_names_the_properties_of_its_text_in_brackets(language):
    of_several_words = {name for name in sentences.NAMES if re.search("[a-z][A-Z]", name)}
    for (_, text), told in _sentences(language):
        named = set(sentences.PROPERTY.findall(told))
        assert all(re.search(r"\b%s\b" % name, text) for name in named), text
        missing = {name for name in of_several_words - named if re.search(r"\b%s\b" % name, text)}
        assert not missing, (text, missing)
        assert not of_several_words & set(re.findall(r"(?<!\[)\b\w+\b(?!\])", told)), told


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_names_choices_as_the_panel_shows_them(language):
    found = translations(language)
    choices = {choice for row in ALL if row.type == CHOICE for choice in row.value}
    for (_, text), told in _sentences(language):
        for choice in choices & set(re.findall("'([^']*)'", text)):
            assert found[CONTEXT, choice] in told, text


def _sentences(language):
    known = {text for _, text, where in TEXTS if where == "sentences"}
    return [item for item in translations(language).items() if item[0][1] in known]


# ---- what is collected ----


def test_the_patterns_that_the_window_reads_are_those_of_the_code():
    with open(sentences.PATTERNS, encoding="utf-8") as file:
        assert file.read().splitlines() == sorted(collect.patterns())


def _told_by_the_core():
    """The texts of several words in the files of the core that tell the window something."""
    for name in joined.FILES_OF_THE_CORE:
        code = re.sub(r"//.*", "", (ROOT / name).read_text(encoding="utf-8"))
        for found in re.finditer(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', code):
            text = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', found.group()))
            if len(re.findall("[a-z]+ ", text)) > 2:
                yield name, OF_PYTHON.sub("%g", text)


def test_what_the_core_tells_is_known_to_the_window():
    told = [OF_PYTHON.sub("%g", pattern) for pattern in joined.SENTENCES_OF_THE_CORE]
    unknown = [each for each in _told_by_the_core() if not any(each[1] in text for text in told)]
    assert unknown == []


def test_the_window_knows_no_sentence_that_the_core_does_not_tell():
    sources = " ".join(
        re.sub(r'"\s*"', "", path.read_text(encoding="utf-8")) for path in ROOT.glob("src/**/*.cpp")
    )
    for pattern in joined.SENTENCES_OF_THE_CORE:
        for words in re.split(r"%[a-z]|\(|\)| near |: ", pattern):
            assert words.strip(" .,") in sources, pattern


# ---- beside the translations ----

SHOWING = {
    *("setText", "setToolTip", "setWindowTitle", "setTitle", "setPlaceholderText", "setSuffix"),
    *("setSpecialValueText", "setHorizontalHeaderLabels", "setStatusTip", "setWhatsThis"),
    *("addItem", "addTab", "addRow", "drawText", "setItemText", "setLabelText", "addAction"),
    *("QLabel", "QPushButton", "QToolButton", "QCheckBox", "QRadioButton", "QGroupBox", "QAction"),
    *("QDockWidget", "QMessageBox", "QListWidgetItem", "QTableWidgetItem", "getOpenFileName"),
    *("getSaveFileName", "PrintError", "PrintWarning", "PrintMessage", "openTransaction"),
    *("set_xlabel", "set_ylabel", "set_title", "Fold", "information", "warning", "critical"),
}


def _shown_as_they_are(tree):
    """The texts with words that a tree gives to what shows them, without a translation."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and collect.name_of(node.func) in SHOWING:
            for argument in (*node.args, *(each.value for each in node.keywords)):
                yield from (text for text in _untranslated(argument) if not collect.is_silent(text))


def _untranslated(node):
    if collect.is_text(node):
        yield node.value
    elif isinstance(node, ast.JoinedStr):
        yield from (each.value for each in node.values if collect.is_text(each))
    elif isinstance(node, (ast.BinOp, ast.IfExp, ast.BoolOp, ast.List, ast.Tuple)):
        for inner in ast.iter_child_nodes(node):
            yield from _untranslated(inner)


@pytest.mark.parametrize(
    "path", sorted((collect.PACKAGE / "gui").glob("*.py")), ids=lambda p: p.stem
)
def test_the_window_shows_no_text_as_it_is(path):
    assert list(_shown_as_they_are(ast.parse(path.read_text(encoding="utf-8")))) == []


def test_a_text_that_is_shown_as_it_is_would_be_seen():
    for line in (
        'label.setText("Not so")',
        'QtGui.QLabel("Not so %d" % 3)',
        'box.addItem(f"{name} is not so", "value")',
        'console.PrintError("Not so: " + str(error))',
        'label.setToolTip("Not so" if it_is else "")',
    ):
        assert list(_shown_as_they_are(ast.parse(line))) != [], line
    for line in ('label.setText(_translate("EvenLoad", "So"))', 'label.setText("%.1f°" % angle)'):
        assert list(_shown_as_they_are(ast.parse(line))) == [], line
