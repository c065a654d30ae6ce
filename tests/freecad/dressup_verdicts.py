"""What becomes of a path in one of FreeCAD's dressups, in the words of docs/dressups.md."""

import math

import pytest
from models import DEPTH

from evenload import simulation
from evenload.operations import dressed

TOOL, MAP_RADIUS = 6.0, 45.0  # mm: of the tool; AxisMap's as FreeCAD's command has it
BONE = TOOL / 2 * (1 - math.sqrt(0.5))  # mm: what a dogbone in a square corner takes of a wall
MARGIN = 0.01
WORKS, LOSES_FEEDS, PLUNGES, GOUGES, NO_PATH = (
    "works",
    "loses feeds",
    "plunges",
    "gouges",
    "no path",
)


def slope(x, y):
    """mm: what was probed."""
    return 0.01 * x + 0.02 * y


def feed_moves(commands):
    """[((x, y, z) before, after, {word: value}, name) of the feed moves], as mm."""
    at, moves = (None, None, None), []
    for command in commands:
        name = command.Name.replace("G0", "G") if len(command.Name) == 3 else command.Name
        if name not in ("G0", "G1", "G2", "G3"):
            continue
        words = command.Parameters
        end = tuple(words.get(axis, before) for axis, before in zip("XYZ", at))
        if name != "G0":
            moves.append((at, end, words, name))
        at = end
    return moves


def feeds_at(moves):
    """{end: feeds in mm/s} of feed moves below the stock's top; 0 where there is none."""
    found = {}
    for start, end, words, _ in moves:
        if None not in end and min(start[2], end[2]) < -MARGIN:
            place = tuple(round(value, 2) for value in end)
            found.setdefault(place, set()).add(round(words.get("F", 0.0), 3))
    return found


def loses_feeds(op, dressup, turned_back=lambda words: words):
    before = feeds_at(feed_moves(op.Path.Commands))
    after = feeds_at(
        [(s, e, turned_back(w), n) for s, e, w, n in feed_moves(dressup.Path.Commands)]
    )
    changed = [place for place in after if place in before and not before[place] & after[place]]
    return bool(changed) or any(0.0 in feeds for feeds in after.values())


def check_far(dressup):
    """No word of a dressed path is that of a place beyond 10 m."""
    for command in dressup.Path.Commands:
        for word, value in command.Parameters.items():
            assert abs(value) < dressed.FARTHEST, command


def check_numbers(dressup):
    """What holds of each dressed path, whatever the page says of it."""
    check_far(dressup)
    for start, end, words, name in feed_moves(dressup.Path.Commands):
        assert end[2] is None or end[2] > -DEPTH - MARGIN, words
        if name in ("G2", "G3"):
            centre = start[0] + words["I"], start[1] + words["J"]
            before, after = math.dist(start[:2], centre), math.dist(end[:2], centre)
            assert before > 1e-3 and abs(before - after) < 0.005, words


def verdict(op, dressup, name):
    """What has become of a path, in the page's words."""
    if not dressup.isValid() or not dressup.Path.Commands:
        return {NO_PATH}
    check_numbers(dressup)
    if name == "AxisMap":
        return {LOSES_FEEDS} if is_wrong_on_its_axis(op, dressup) else {WORKS}
    said = {LOSES_FEEDS} if loses_feeds(op, dressup) else set()
    if name == "ZCorrect":
        check_heights(op, dressup)
        return said or {WORKS}
    found = simulation.of(dressup)
    if found.plunge_in_material_mm > MARGIN:
        said.add(PLUNGES)
    if found.gouge_mm > (BONE if name == "Dogbone" else 0) + MARGIN:
        said.add(GOUGES)
    if not said:
        assert found.rapid_in_material_mm == 0 and found.rest_area < 0.5
        if name == "Dogbone":
            assert found.gouge_mm == pytest.approx(BONE, abs=MARGIN)
    return said or {WORKS}


def is_wrong_on_its_axis(op, dressup):
    """Whether feeds are lost on the cylinder; places must not be."""
    degrees = 360 / (2 * math.pi * MAP_RADIUS)
    moves, angles = feed_moves(dressup.Path.Commands), set()
    for _, _, words, _ in moves:
        assert "Y" not in words
        angles.add(words.get("A", 0.0))
    places = [end for _, end, _, _ in feed_moves(op.Path.Commands)]
    assert max(angles) == pytest.approx(degrees * max(y for _, y, _ in places), abs=0.1)
    return any(not words.get("F") for _, _, words, _ in moves)


def check_heights(op, dressup):
    """Each place of a corrected path lies as much higher as was probed there."""
    levels = {round(end[2], 3) for _, end, _, _ in feed_moves(op.Path.Commands)}
    lowest = min(levels)
    flat = [end[2] - slope(*end[:2]) for _, end, _, _ in feed_moves(dressup.Path.Commands)]
    assert min(flat) == pytest.approx(lowest, abs=0.005)
    at_floor = sum(abs(z - lowest) < 0.005 for z in flat)
    assert at_floor > 0.7 * len(flat)
