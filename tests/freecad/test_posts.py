"""Posted programs: linuxcnc and grbl, and what LinuxCNC's own interpreter makes of them."""

import math
import re

import pytest
from conftest import moves_of
from FreeCAD import Vector
from models import SQUARE, block_with, circle, face_of, rectangle

POSTS = [
    ("linuxcnc", "--no-show-editor"),
    ("linuxcnc", "--no-show-editor --precision 4"),
    ("grbl", "--no-show-editor"),
]


def motions(text):
    """[(G, {letter: number})] of the motion blocks."""
    result = []
    for line in text.splitlines():
        line = re.sub(r"\(.*?\)|;.*", "", line).strip()
        words = re.findall(r"([A-Z])(-?[\d.]+)", line)
        if words and words[0][0] == "G" and float(words[0][1]) in (0, 1, 2, 3):
            result.append((int(float(words[0][1])), {k: float(v) for k, v in words[1:]}))
    return result


@pytest.fixture
def round_pocket(bench):
    b = bench(block_with(face_of(rectangle(0, 0, 40, 30), [circle(20, 15, 5)])))
    return b, b.done(b.operation(FeedControl="Constant removal rate", StepDown=1.6))


@pytest.mark.parametrize("processor, arguments", POSTS)
def test_posted_arcs_are_accepted_by_strict_controllers(round_pocket, processor, arguments):
    from evenload import host

    b, op = round_pocket
    text = host.post(b.job, processor, arguments)
    assert "922337" not in text and "nan" not in text.lower()
    x = y = z = None
    arcs = 0
    for g, words in motions(text):
        nx, ny, nz = words.get("X", x), words.get("Y", y), words.get("Z", z)
        if g in (2, 3):
            arcs += 1
            i, j = words["I"], words["J"]
            mismatch = abs(math.hypot(i, j) - math.hypot(nx - x - i, ny - y - j))
            assert mismatch <= 0.003
            assert math.hypot(nx - x, ny - y) >= 0.002
        if g and "F" in words:
            assert words["F"] > 0
        x, y, z = nx, ny, nz
    assert arcs > 50
    assert len(motions(text)) >= len(moves_of(op))


def test_unknown_processors_and_arguments_are_refused(round_pocket):
    from evenload import host

    b, _ = round_pocket
    with pytest.raises(ValueError, match="There is no post-processor 'nonsense': .*linuxcnc"):
        host.post(b.job, "nonsense", "")
    with pytest.raises(ValueError, match="'linuxcnc' refuses the arguments '--nonsense'"):
        host.post(b.job, "linuxcnc", "--nonsense")


def test_arguments_of_one_call_do_not_stay_for_the_next(round_pocket):
    from evenload import host

    b, _ = round_pocket
    first = host.post(b.job, "linuxcnc", "--no-show-editor --no-header --no-comments")
    second = host.post(b.job, "linuxcnc", "--no-show-editor")
    assert "(Exported by" not in first and "(Exported by" in second


CANONICAL = re.compile(r"(STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED)\(([^)]*)\)")


@pytest.mark.parametrize("processor, arguments", POSTS[:2])
def test_linuxcnc_moves_as_the_path_does(round_pocket, rs274, tmp_path, processor, arguments):
    from evenload import host

    b, op = round_pocket
    output = rs274(host.post(b.job, processor, arguments), tmp_path)
    found = [(m[1], [float(v) for v in m[2].split(",")]) for m in CANONICAL.finditer(output)]
    ours = [m for m in moves_of(op) if m[0] != "G0"]
    theirs = [m for m in found if m[0] != "STRAIGHT_TRAVERSE"]
    assert len(theirs) == len(ours)
    for (name, _, end, centre, _), (canonical, numbers) in zip(ours, theirs):
        if centre is None:
            assert canonical == "STRAIGHT_FEED"
            assert numbers[:3] == pytest.approx(end, abs=0.0006)
            continue
        assert canonical == "ARC_FEED"
        x, y, cx, cy, turns, z = numbers[:6]
        assert (x, y, z) == pytest.approx(end, abs=0.0006)
        assert (cx, cy) == pytest.approx(centre, abs=0.0012)
        assert turns == (1 if name == "G3" else -1)


def test_linuxcnc_takes_every_entry(bench, rs274, tmp_path):
    from evenload import host

    b = bench(block_with(face_of(SQUARE)))
    for entry in ("Helix", "Ramp"):
        b.done(b.operation(Entry=entry))
    b.done(b.operation(Entry="Predrilled hole", HoleDiameter=8, EntryPoint=Vector(15, 15, 0)))
    output = rs274(host.post(b.job, "linuxcnc", "--no-show-editor"), tmp_path)
    assert len(CANONICAL.findall(output)) > 300


@pytest.mark.parametrize("feed", [0.5, 7.5])
def test_low_feeds_reach_the_program(bench, rs274, tmp_path, feed):
    from evenload import host

    b = bench(block_with(face_of(SQUARE)), feed=feed)
    op = b.done(b.operation())
    assert {round(m[4], 6) for m in moves_of(op) if m[0] != "G0"} == {feed, 5000}
    for processor, arguments in POSTS:
        text = host.post(b.job, processor, arguments)
        assert {w["F"] for _, w in motions(text) if "F" in w} == {feed, 5000}
        if processor == "linuxcnc":
            rs274(text, tmp_path)


def test_the_interpreter_refuses_a_bad_program(rs274, tmp_path):
    with pytest.raises(AssertionError):
        rs274("G21 G17 G90\nF100\nG0 X0 Y0 Z0\nG2 X10 Y0 I1 J0\nM2\n", tmp_path)


@pytest.mark.parametrize("name", ["Boundary", "Tags"])
def test_stock_dressups_take_the_path(round_pocket, name):
    from evenload import host

    b, op = round_pocket
    dressed = host.dressup(name).Create(op)
    b.doc.recompute()
    assert dressed.isValid()
    assert len(dressed.Path.Commands) > 0.5 * len(op.Path.Commands)
