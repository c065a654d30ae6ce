"""Moves become commands that survive rounding: directions, radii, lengths, feeds."""

import math
import random

import pytest
from evenload import commands

RAPID, LINK, ENTRY, CUT = range(4)
START = (0.0, 0.0, -3.0)


def arc_move(start, centre, sweep, z=-3.0, feed=300.0):
    x, y = start[0] - centre[0], start[1] - centre[1]
    c, s = math.cos(sweep), math.sin(sweep)
    return (
        CUT,
        centre[0] + c * x - s * y,
        centre[1] + s * x + c * y,
        z,
        sweep,
        *centre,
        feed,
    )


def geometry(made, start=START):
    """[(name, start, end, centre, sweep)] of commands, as a controller reads them."""
    result, at = [], start
    for command in made:
        p = command.Parameters
        end = tuple(p.get(axis, before) for axis, before in zip("XYZ", at))
        centre = sweep = None
        if command.Name in ("G2", "G3"):
            centre = at[0] + p["I"], at[1] + p["J"]
            sweep = math.atan2(end[1] - centre[1], end[0] - centre[0])
            sweep -= math.atan2(at[1] - centre[1], at[0] - centre[0])
            sweep %= 2 * math.pi
            sweep = sweep or 2 * math.pi
            if command.Name == "G2":
                sweep -= 2 * math.pi
        result.append((command.Name, at, end, centre, sweep))
        at = end
    return result


def posted(value, decimals=3):
    return float("%.*f" % (decimals, value))


def random_arcs(count, seed):
    source = random.Random(seed)
    at = START[:2]
    for _ in range(count):
        radius = 10 ** source.uniform(-1, 3.5)
        chord_sweep = min(2 * math.pi * 0.99, 10 ** source.uniform(-2.5, 1) / radius)
        sweep = chord_sweep * source.choice((-1, 1))
        angle = source.uniform(0, 2 * math.pi)
        centre = at[0] + radius * math.cos(angle), at[1] + radius * math.sin(angle)
        move = arc_move(at, centre, sweep)
        yield move
        at = move[1:3]


def test_a_line_carries_its_feed_in_mm_per_second():
    (line,) = commands.from_moves([(CUT, 10, 5, -3, 0, 0, 0, 300)], START)
    assert line.Name == "G1"
    assert line.Parameters == {"X": 10, "Y": 5, "Z": -3, "F": 5}


@pytest.mark.parametrize("sweep, name", [(1.2, "G3"), (-1.2, "G2"), (3.1, "G3"), (-3.1, "G2")])
def test_arcs_turn_the_way_of_their_sweep(sweep, name):
    (arc,) = geometry(commands.from_moves([arc_move(START, (7, 0), sweep)], START))
    assert arc[0] == name
    assert arc[4] == pytest.approx(sweep, abs=1e-3)


@pytest.mark.parametrize("sweep", [3.3, 4.5, 6.2, -3.3, -4.5, -6.2])
def test_arcs_of_more_than_half_a_turn_are_halved(sweep):
    made = geometry(commands.from_moves([arc_move(START, (7, 0), sweep)], START))
    assert [m[0] for m in made] == ["G3" if sweep > 0 else "G2"] * 2
    assert [m[4] for m in made] == pytest.approx([sweep / 2] * 2, abs=2e-3)


@pytest.mark.parametrize("radius", [0.02, 0.032, 0.052, 0.07])
@pytest.mark.parametrize("degrees", [5, 45, 90, 92, 95])
def test_freecad_takes_every_arc_for_what_it_is(radius, degrees):
    """FreeCAD's own reading of commands, which its simulator and dressups use; it is rough."""
    for sense in (1, -1):
        made = commands.from_moves(
            [arc_move(START, (radius, 0), math.radians(degrees) * sense)], START
        )
        assert read_by_freecad(made) == pytest.approx(
            math.radians(degrees) * radius, rel=0.03, abs=0.0015
        )


def read_by_freecad(made, start=START):
    """Length of commands as FreeCAD sees them."""
    import FreeCAD

    try:
        import Path.Geom as geom
    except ImportError:
        import PathScripts.PathGeom as geom
    at, total = FreeCAD.Vector(*start), 0.0
    for command in made:
        edge = geom.edgeForCmd(command, at)
        total += edge.Length if edge else 0.0
        at = geom.commandEndPoint(command, at)
    return total


def test_freecad_reads_random_arcs_as_they_are():
    at = START[:2]
    for move in random_arcs(1000, 4):
        start = (round(at[0], 3), round(at[1], 3), -3.0)
        exact = math.dist(at, move[5:7]) * abs(move[4])
        made = commands.from_moves([move], start)
        assert read_by_freecad(made, start) == pytest.approx(exact, rel=0.02, abs=0.002)
        at = move[1:3]


@pytest.mark.parametrize("decimals, mismatch", [(3, 0.003), (4, 0.00015)])
def test_radii_agree_after_posting(decimals, mismatch):
    made = commands.from_moves(list(random_arcs(3000, 1)), START)
    arcs = 0
    for name, start, end, centre, _ in geometry(made):
        if centre is None:
            continue
        arcs += 1
        i, j = (posted(c - s, decimals) for c, s in zip(centre, start))
        sx, sy, ex, ey = (posted(v, decimals) for v in (*start[:2], *end[:2]))
        assert abs(math.hypot(i, j) - math.hypot(ex - sx - i, ey - sy - j)) <= mismatch
        assert math.hypot(ex - sx, ey - sy) >= 0.002
    assert arcs > 2000


def tangents(made):
    """[(direction at the start, direction at the end)] of geometry(), rad."""
    result = []
    for _, start, end, centre, sweep in made:
        if centre is None:
            along = math.atan2(end[1] - start[1], end[0] - start[0])
            result.append((along, along))
        else:
            quarter = math.copysign(math.pi / 2, sweep)
            result.append(
                tuple(
                    math.atan2(p[1] - centre[1], p[0] - centre[0]) + quarter for p in (start, end)
                )
            )
    return result


def test_short_tangent_arcs_stay_tangent():
    source = random.Random(5)
    x, y, heading, moves = *START[:2], 0.3, []
    for k in range(600):
        radius = 10 ** source.uniform(-0.5, 1) * source.choice((-1, 1))
        length = source.uniform(0.03, 0.1) if k % 2 else source.uniform(0.3, 0.9)
        centre = x - radius * math.sin(heading), y + radius * math.cos(heading)
        moves.append(arc_move((x, y), centre, length / radius))
        x, y, heading = *moves[-1][1:3], heading + length / radius
    made = tangents(geometry(commands.from_moves(moves, START)))
    assert len(made) == len(moves)
    for (_, before), (after, _) in zip(made, made[1:]):
        assert abs(math.remainder(after - before, 2 * math.pi)) < math.radians(0.6)


def test_rounded_arcs_stay_near_the_exact_ones():
    at = START[:2]
    for move in random_arcs(2000, 2):
        made = geometry(
            commands.from_moves([move], (round(at[0], 3), round(at[1], 3), -3)),
            (round(at[0], 3), round(at[1], 3), -3),
        )
        assert len(made) >= 1 or math.dist(at, move[1:3]) < 0.0015
        centre, sweep = move[5:7], move[4]
        radius = math.dist(at, centre)
        for name, start, end, c, s in made:
            for k in range(5):
                if c is None:
                    p = [a + k / 4 * (b - a) for a, b in zip(start[:2], end[:2])]
                else:
                    first = math.atan2(start[1] - c[1], start[0] - c[0]) + s * k / 4
                    r = math.dist(start[:2], c)
                    p = c[0] + r * math.cos(first), c[1] + r * math.sin(first)
                assert abs(math.dist(p, centre) - radius) < 0.003
        if made and len(made) == 1 and made[0][3]:
            assert made[0][4] == pytest.approx(sweep, abs=0.5)
        at = move[1:3]


def test_no_command_repeats_a_position():
    source = random.Random(3)
    moves, x, y = [], 0.0, 0.0
    for _ in range(2000):
        x, y = x + source.uniform(-0.002, 0.002), y + source.uniform(-0.002, 0.002)
        moves.append((CUT, x, y, -3.0, 0.0, 0.0, 0.0, 300.0))
    made = geometry(commands.from_moves(moves, START))
    assert all(math.dist(start, end) >= 5e-4 for _, start, end, *_ in made)
    assert made[-1][2][:2] == pytest.approx((x, y), abs=0.0006)


def test_a_full_circle_becomes_two_half_circles():
    made = geometry(commands.from_moves([arc_move(START, (4, 0), 2 * math.pi)], START))
    assert [m[0] for m in made] == ["G3", "G3"]
    assert sum(m[4] for m in made) == pytest.approx(2 * math.pi, abs=1e-3)
    assert made[-1][2][:2] == START[:2]


def test_a_helix_of_many_turns_descends_evenly():
    start = (2.0, 0.0, 0.0)
    move = (ENTRY, 2.0, 0.0, -3.0, 12 * math.pi, 0.0, 0.0, 100.0)
    made = geometry(commands.from_moves([move], start), start)
    assert len(made) == 12 and all(m[0] == "G3" for m in made)
    assert [m[2][2] for m in made] == pytest.approx([-0.25 * k for k in range(1, 13)])
    assert made[-1][2] == pytest.approx((2, 0, -3))


@pytest.mark.parametrize("chord", [0.0004, 0.0011, 0.002, 0.0045])
def test_tiny_arcs_become_lines(chord):
    sweep = 2 * math.asin(chord / 2 / 3)
    made = commands.from_moves([arc_move(START, (3, 0), sweep)], START)
    assert all(command.Name == "G1" for command in made)


def test_arcs_that_are_nearly_straight_become_lines():
    (made,) = commands.from_moves([arc_move(START, (0, 2e4), 1e-3)], START)
    assert made.Name == "G1"


def test_the_first_rapid_rises_before_it_travels():
    made = commands.from_moves([(RAPID, 5, 6, 10, 0, 0, 0, 0), (RAPID, 5, 6, 2, 0, 0, 0, 0)])
    assert [(c.Name, c.Parameters) for c in made] == [
        ("G0", {"Z": 10}),
        ("G0", {"X": 5, "Y": 6}),
        ("G0", {"Z": 2}),
    ]


def test_a_rapid_never_cuts_a_corner():
    made = commands.from_moves([(RAPID, 9, 9, 5, 0, 0, 0, 0), (RAPID, 1, 1, 2, 0, 0, 0, 0)], START)
    assert [sorted(c.Parameters) for c in made] == [["Z"], ["X", "Y"], ["X", "Y"], ["Z"]]


@pytest.mark.parametrize("place", range(1, 8))
@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_numbers_that_are_not_finite_are_refused(place, value):
    move = [CUT, 1.0, 2.0, -3.0, 0.5, 0.0, 0.0, 300.0]
    move[place] = value
    with pytest.raises(ValueError, match="Move 0 of the toolpath is not finite"):
        commands.from_moves([tuple(move)], START)


@pytest.mark.parametrize("feed", [0, -1])
def test_a_cut_without_feed_is_refused(feed):
    with pytest.raises(ValueError, match="no feed"):
        commands.from_moves([(CUT, 1, 2, -3, 0, 0, 0, feed)], START)


def test_length_follows_arcs_and_helices():
    moves = [
        (CUT, 10.0, 0.0, -3.0, 0.0, 0.0, 0.0, 300.0),
        arc_move((10, 0), (10, 5), math.pi / 2),
    ]
    start = commands.from_moves([(RAPID, 0, 0, -3, 0, 0, 0, 0)])
    made = start + commands.from_moves(moves, START)
    assert commands.length(made) == pytest.approx(10 + 2.5 * math.pi, abs=1e-3)
