"""The include arrows of src/ go one way, and foreign headers stay where they belong."""
import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.core

SOURCE = Path(__file__).resolve().parents[2] / "src"

# What each folder may include besides itself. Strategy and simulate never see each other: the
# simulator is the judge.
ARROWS = {
    "support": set(),
    "geometry": {"support"},
    "cutting": {"support", "geometry"},
    "toolpath": {"support", "geometry", "cutting"},
    "strategy": {"support", "geometry", "cutting", "toolpath", "feed"},
    "feed": {"support", "geometry", "cutting", "toolpath"},
    "simulate": {"support", "geometry", "cutting", "toolpath"},
    "dynamics": {"support"},
    "ball_end": {"support"},
    "inspection": {"support"},
    "surface": {"support", "geometry", "toolpath"},
    "occt": {"support", "geometry"},
    "python": {
        "support",
        "geometry",
        "cutting",
        "toolpath",
        "strategy",
        "feed",
        "simulate",
        "dynamics",
        "ball_end",
        "inspection",
        "surface",
    },
}
# The rooms of src/strategy, each of which may include those above it.
STRATEGY = (
    "places",
    "moves",
    "task",
    "steer",
    "reach",
    "plan",
    "choose",
    "trochoid",
    "slots",
    "passage",
    "pocket",
    "lame",
)
MOST_UNITS = 10  # in a room
# Plain values that any folder may include, support/errors.h among them: of the standard library's
# kind, they include nothing of ours.
PLAIN_VALUES = {"geometry/vec2.h", "surface/cutter.h"}

FILES = sorted(path for path in SOURCE.rglob("*") if path.suffix in (".h", ".cpp"))


def name(path):
    return path.relative_to(SOURCE).as_posix()


def own_includes(path):
    return re.findall(r'^\s*#\s*include\s+"([^"]+)"', path.read_text(), re.MULTILINE)


def foreign_includes(path):
    return re.findall(r"^\s*#\s*include\s+<([^>]+)>", path.read_text(), re.MULTILINE)


@pytest.mark.parametrize("path", FILES, ids=name)
def test_includes_follow_the_arrows(path):
    folder = name(path).split("/")[0]
    assert folder in ARROWS, "a folder without an arrow: say what it may include"
    for include in own_includes(path):
        assert (SOURCE / include).is_file(), "%s is not written from src/ on" % include
        allowed = ARROWS[folder] | {folder}
        assert (
            include in PLAIN_VALUES or include.split("/")[0] in allowed
        ), "%s may not include %s" % (folder, include)


@pytest.mark.parametrize("room", STRATEGY)
def test_rooms_of_the_strategy_include_those_above_them(room):
    above = STRATEGY[: STRATEGY.index(room) + 1]
    for path in sorted((SOURCE / "strategy" / room).iterdir()):
        for include in own_includes(path):
            if include.startswith("strategy/"):
                assert include.split("/")[1] in above, "%s: %s" % (path.name, include)


def test_rooms_of_the_strategy_are_small_and_all_of_it():
    folders = sorted((SOURCE / "strategy").iterdir())
    assert sorted(STRATEGY) == [folder.name for folder in folders]
    for folder in folders:
        assert len({path.stem for path in folder.iterdir()}) <= MOST_UNITS, folder.name


@pytest.mark.parametrize("header", sorted(PLAIN_VALUES))
def test_plain_values_include_nothing_of_ours(header):
    assert own_includes(SOURCE / header) == []


@pytest.mark.parametrize("path", FILES, ids=name)
def test_foreign_headers_stay_where_they_belong(path):
    folder = name(path).split("/")[0]
    for include in foreign_includes(path):
        if include.endswith(".hxx"):
            assert folder == "occt", "OpenCASCADE belongs to occt/: %s" % include
        if include.startswith(("pybind11/", "Python.h")):
            assert folder in ("occt", "python"), "Python belongs to the bindings: %s" % include
        if path.suffix == ".h":
            assert not include.endswith(".hxx") and not include.startswith("boost/"), (
                "keep %s out of headers" % include
            )


def test_the_arrows_have_no_circle():
    done = set()
    while len(done) < len(ARROWS):
        ready = {folder for folder, sees in ARROWS.items() if folder not in done and sees <= done}
        assert ready
        done |= ready


CLASS = re.compile(r"^( *)(?:class|struct) (\w+)[^;{]*\{$", re.MULTILINE)
LONGEST_CLASS = 250  # lines


@pytest.mark.parametrize("path", FILES, ids=name)
def test_classes_can_be_read_in_one_sitting(path):
    text = path.read_text()
    for begin in CLASS.finditer(text):
        body = text[begin.start() : text.index("\n%s};" % begin[1], begin.start())]
        assert body.count("\n") + 2 <= LONGEST_CLASS, begin[2]
