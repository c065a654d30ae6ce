"""The adaptive benchmark's goals, and the laws of paths that it judges."""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import adaptive_goals  # noqa: E402
import path_laws  # noqa: E402

CUT = 3
SQUARE = [[0, 0, 0.0], [20, 0, 0.0], [20, 20, 0.0], [0, 20, 0.0]]


def verdict(value, sign="<=", required=1.18, wished=1.1):
    values = {"star.ratio": value, "star.freecad_ratio": 2.5}
    line = adaptive_goals.goal_line(values, "star", "star.%sratio", sign, required, wished, "1.22")
    assert line.split()[:2] == ["star", "2.5"] and " 1.22  " in line
    return line.rsplit("  ", 1)[1]


@pytest.mark.parametrize(
    "value, said", [(1.1, "as wished"), (1.18, "as required"), (1.181, "MISSED")]
)
def test_a_line_says_how_far_a_figure_is_below_its_limits(value, said):
    assert verdict(value) == said


@pytest.mark.parametrize("value, said", [(0.9, "as wished"), (0.7, "as required"), (0.6, "MISSED")])
def test_a_line_says_how_far_a_figure_is_above_its_limits(value, said):
    assert verdict(value, ">=", 0.7, 0.85) == said


def test_a_figure_that_is_missing_is_not_measured():
    line = adaptive_goals.goal_line({}, "star", "star.%sratio", "<=", 2, 1)
    assert line.endswith("-  not measured") and "MISSED" not in line


def test_every_goal_has_its_line_below_a_head_for_every_column():
    lines = list(adaptive_goals.table({}))
    head = next(i for i, line in enumerate(lines) if line.startswith("of all cases"))
    assert lines[head].endswith("published best  EvenLoad is")
    assert len(lines) == head + 1 + len(adaptive_goals.GOALS) + 1
    for line, goal in zip(lines[head + 1 :], adaptive_goals.GOALS):
        assert line.startswith(goal[0]) and line.index("  not measured") == lines[head].index(
            "  EvenLoad is"
        )


def test_a_kink_is_a_turn_of_more_than_a_degree_with_material_on_both_sides():
    moves = [(0, 0, 0, -1, 0, 0, 0, 0)]
    moves += [(CUT, x, y, -1, 0, 0, 0, 100) for x, y in ((10, 0), (20, 0), (30, 0.1), (30, 10))]
    run = SimpleNamespace(
        move=numpy.array([1, 1, 2, 2, 3, 3, 4, 4]),
        kind=numpy.full(8, CUT),
        engagement_deg=numpy.array([60, 60, 60, 60, 60, 60, 60, 60.0]),
    )
    assert path_laws.kinks(run, moves) == 1  # the second turns by half a degree
    run.engagement_deg[6] = 0.5
    assert path_laws.kinks(run, moves) == 0


@pytest.mark.parametrize("backwards", [False, True])
def test_corners_are_sharp_where_the_tool_turns_below_the_minimum_radius(backwards):
    def corners(outer=(), islands=()):
        turned = [list(o[::-1]) if backwards else list(o) for o in (outer, *islands)]
        return path_laws.sharp_corners({"tool": 6.0, "outer": turned[0], "islands": turned[1:]})

    island = [[5, 5, 0.0], [9, 5, 0.0], [9, 9, 0.0], [5, 9, 0.0]]
    notched = [[5, 5, 0.0], [9, 5, 0.0], [7, 7, 0.0], [9, 9, 0.0], [5, 9, 0.0]]
    assert corners(SQUARE) == 4
    assert corners(SQUARE, [island]) == 4
    assert corners(SQUARE, [notched]) == 5


def test_rounded_corners_are_sharp_below_the_tool_and_its_minimum_radius():
    def rounded(radius):
        b, far = 2**0.5 - 1, 20 - radius
        outer = [[radius, 0, 0.0], [far, 0, b], [20, radius, 0.0], [20, far, b]]
        outer += [[far, 20, 0.0], [radius, 20, b], [0, far, 0.0], [0, radius, b]]
        return path_laws.sharp_corners({"tool": 6.0, "outer": outer, "islands": []})

    assert rounded(3.8) == 4
    assert rounded(4.0) == 0
