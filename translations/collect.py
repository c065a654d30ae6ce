"""What is to be translated: every text that a user sees in FreeCAD's window.

Texts of the window stand in Mod/evenload/gui and in tables of other rooms; sentences, which are
recognised by their patterns when they are shown, wherever they are made (docs/languages.md). Needs
neither FreeCAD nor the compiled modules, but Mod on Python's path.
"""

import ast
import re
from pathlib import Path

from evenload.settings.labels import FREECADS
from evenload.settings.results import (
    HIDDEN_SETTINGS,
    RESULT_SETTINGS,
    RESULTS_OF_FINISHING,
    RESULTS_OF_LAME_SPIRAL,
    RESULTS_OF_TROCHOID,
)
from evenload.settings.setting import CHOICE
from evenload.settings.table import ALL, BOXES, FINISHING
from evenload.translation import CONTEXT, numbered
from joined import SENTENCES_OF_SEVERAL_PIECES, SENTENCES_OF_THE_CORE
from silent import NOT_TOLD, OF_FILES, SILENT_CALLS, TELLING, is_silent

PACKAGE = Path(__file__).resolve().parents[1] / "Mod" / "evenload"
PROPERTIES = "App::Property"  # the context in which FreeCAD looks for the tooltips of properties
TRANSLATE = ("translate", "_translate")  # what a text is given to that is shown as it stands
# Tables of texts beside the window: all that their rows have of words.
TABLES = {
    "dynamics/pictures.py": ("FIT_PARTS",),
    "face_inspection/html_report.py": ("CERTIFICATE",),
    "gui/load_colours.py": ("SCALES",),
    "pictures/job_report.py": ("HEAD", "INCIDENT_HEAD", "KINDS"),
    "pictures/load_rows.py": ("ROWS",),
    "pictures/over_time.py": ("KINDS",),
    "pictures/simulation_pictures.py": ("LABELS",),
}
NO_WORDS = re.compile(r"[a-z]+_\w+|#.*")  # in these


def texts():
    """[(context, text, where), ...] of all that is to be translated, each once."""
    found = {}
    for part in (_window, _commands, _settings, _tables, _sentences):
        for context, text, where in part():
            found.setdefault((context, text), where)
    return [(*key, where) for key, where in found.items()]


def patterns():
    """The patterns of sentences, as they stand in the code, in a fixed order."""
    told = {path for name in TELLING for path in PACKAGE.glob(name)}
    found = [text for path in sorted(told) for text in _told_in(path)]
    found += [*SENTENCES_OF_SEVERAL_PIECES, *SENTENCES_OF_THE_CORE]
    return list(dict.fromkeys(found))


# ---- the window ----


def _window():
    for path in sorted(PACKAGE.glob("gui/*.py")):
        if path.name not in ("command.py", "view3d.py"):
            for text in shown_in(path):
                yield CONTEXT, text, "gui/" + path.name
    for path in sorted(PACKAGE.glob("operations/*.py")):
        for text in _of_tables(path, ("NAME",)):
            yield CONTEXT, text, "operations/" + path.name


def shown_in(path):
    """The texts of a file of the window."""
    tree = _tree(path)
    silent = _silent_nodes(tree)
    for node in ast.walk(tree):
        if is_text(node) and id(node) not in silent and not is_silent(node.value):
            yield node.value


def _silent_nodes(tree):
    """The ids of docstrings, keys, and arguments of calls that show nothing."""
    silent = _docstrings(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript):
            silent.add(id(node.slice))
        elif isinstance(node, ast.Dict):
            silent.update(id(key) for key in node.keys)
        elif isinstance(node, ast.Call) and name_of(node.func) in SILENT_CALLS:
            silent.update(id(inner) for each in node.args for inner in _untranslated(each))
        elif isinstance(node, ast.Call) and name_of(node.func) in TRANSLATE:
            silent.update(id(each) for each in node.args if is_text(each) and each.value == CONTEXT)
    return silent


def _untranslated(node):
    """A node and all in it but what is translated there."""
    if isinstance(node, ast.Call) and name_of(node.func) in TRANSLATE:
        return
    yield node
    for each in ast.iter_child_nodes(node):
        yield from _untranslated(each)


def _commands():
    """What FreeCAD itself translates: a command's texts, in a context of the command's name."""
    for node in ast.walk(_tree(PACKAGE / "gui" / "command.py")):
        if isinstance(node, ast.Dict) and node.keys and isinstance(node.values[0], ast.Call):
            for name, made in zip(node.keys, node.values):
                for text in made.args[2:4]:
                    yield name.value, text.value, "gui/command.py"


# ---- tables ----


def _settings():
    rows = (*ALL, *FINISHING)
    for text in (*BOXES, *FREECADS.values()):
        yield CONTEXT, text, "settings"
    for row in rows:
        # The names of materials are what a file calls them.
        choices = row.value if row.type == CHOICE and row.name != "Material" else ()
        for text in (row.label, *choices, row.unset, row.doc):
            if text:
                yield CONTEXT, text, row.name
    results = (*RESULT_SETTINGS, *RESULTS_OF_TROCHOID, *RESULTS_OF_LAME_SPIRAL)
    for row in (*rows, *results, *RESULTS_OF_FINISHING, *HIDDEN_SETTINGS):
        yield PROPERTIES, row.doc, row.name


def _tables():
    for name in sorted(TABLES):
        for text in _of_tables(PACKAGE / name, TABLES[name]):
            if not NO_WORDS.fullmatch(text):
                yield CONTEXT, text, name
    for path in sorted(PACKAGE.rglob("*.py")):
        if path.parent.name != "gui":
            for text in _marked_in(path):
                yield CONTEXT, text, str(path.relative_to(PACKAGE))


def _of_tables(path, names):
    """The texts of a file's constants of these names."""
    for node in _tree(path).body:
        if isinstance(node, ast.Assign) and name_of(node.targets[0]) in names:
            yield from (inner.value for inner in ast.walk(node.value) if is_text(inner))


def _marked_in(path):
    """The texts of a file that are given to translate()."""
    for node in ast.walk(_tree(path)):
        if isinstance(node, ast.Call) and name_of(node.func) in TRANSLATE:
            for inner in (inner for each in node.args for inner in ast.walk(each)):
                if is_text(inner) and inner.value != CONTEXT:
                    yield inner.value


# ---- sentences ----


def _sentences():
    for pattern in patterns():
        yield CONTEXT, numbered(pattern), "sentences"


def _told_in(path):
    """The patterns in a file: all its texts of several words."""
    tree = _tree(path)
    silent = _docstrings(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and name_of(node.func) in TRANSLATE:
            silent.update(id(inner) for each in node.args for inner in ast.walk(each))
        if isinstance(node, ast.Assign) and name_of(node.targets[0]) == "NAME":
            silent.add(id(node.value))
    for node in ast.walk(tree):
        if is_text(node) and id(node) not in silent and _is_told(node.value, path):
            yield node.value


def _is_told(text, path):
    if text in NOT_TOLD or ("%r" in text and path.name not in OF_FILES):
        return False
    return " " in text.strip() and re.search("[a-z]{2}", text) is not None


# ---- Python's trees ----


def is_text(node):
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def name_of(node):
    """The name of a function, or of what is assigned to."""
    return getattr(node, "attr", getattr(node, "id", ""))


def _tree(path):
    return ast.parse(path.read_text(encoding="utf-8"))


def _docstrings(tree):
    owners = ast.Module, ast.ClassDef, ast.FunctionDef
    return {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, owners) and node.body and isinstance(node.body[0], ast.Expr)
    }
