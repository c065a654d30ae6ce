"""Lamé spirals through the core's Python function."""

import math

import pytest
from evenload import compiled

core = compiled.core()
SQUARE = core.Region([(0, 0, 0), (40, 0, 0), (40, 40, 0), (0, 40, 0)])
ENOUGH = {
    "tool_diameter": 6,
    "engagement_angle": math.radians(60),
    "feed": 255,
    "plunge_feed": 255,
    "link_feed": 1500,
    "maximum_feed": 1000,
    "levels": [-3],
    "safe_height": 3,
    "clearance_height": 5,
}


def clear(**more):
    return core.clear_with_lame_spiral([SQUARE], **{**ENOUGH, **more})


def test_a_square_is_cleared_nearly_all_by_the_spiral():
    path = clear(feed_control="constant removal rate")
    assert path.report.termination == "complete"
    assert 0.9 < path.cleared_share < 1
    assert path.report.max_engagement < math.radians(61)


def test_the_same_input_gives_the_same_moves():
    assert clear().moves == clear().moves


def test_what_is_set_is_kept_and_the_rest_left():
    path = clear(
        segments=5,
        semi_axis_a=10.0,
        exponent_start=0.9,
        exponent_end=0.8,
        rotation=0.2,
        pitch=0.6,
        centre=(19.0, 21.0),
        rest="leave",
    )
    end = [move for move in path.moves if move[0] == 3][-1]
    assert math.dist(end[1:3], (19, 21)) == pytest.approx(10, abs=1)
    assert path.report.termination == "incomplete"


def test_none_is_as_good_as_nothing():
    unset = {"segments": None, "semi_axis_a": None, "rotation": None, "centre": None, "pitch": None}
    assert clear(**unset).moves == clear().moves
    unset = {"semi_axis_a_course": [], "semi_axis_b_course": None, "exponent_course": ()}
    assert clear(**unset).moves == clear().moves


@pytest.mark.parametrize("name", ["semi_axis_a_course", "semi_axis_b_course", "exponent_course"])
def test_a_course_makes_another_path_within_the_limit(name):
    path = clear(**{name: [0, 0.1, 0.4, 1]}, feed_control="constant removal rate")
    assert path.moves != clear(feed_control="constant removal rate").moves
    assert path.report.termination == "complete"
    assert path.report.max_engagement < math.radians(61)


def test_several_levels_repeat_the_spiral():
    assert clear(levels=[-1, -2]).report.passes == 2 * clear().report.passes


@pytest.mark.parametrize(
    "given, sentence",
    [
        ({"segments": 1}, "Segments must lie between 3 and 12"),
        ({"exponent_end": 2.0}, "ExponentEnd must lie between 0.05 and 1"),
        ({"rest": "keep"}, "rest must be one of"),
        ({"semi_axis_a": 30.0}, "keeps clear of the walls"),
        ({"semi_axis_a_course": [0]}, "SemiAxisACourse must be 2 to 20 values"),
        ({"semi_axis_b_course": [0, 0.7, 0.6, 1]}, "SemiAxisBCourse .* never fall"),
        ({"exponent_course": [0.1, 1]}, "ExponentCourse .* begin with 0, end with 1"),
    ],
)
def test_what_cannot_be_is_refused_with_a_remedy(given, sentence):
    with pytest.raises(ValueError, match=sentence):
        clear(**given)


def test_a_pocket_like_no_lame_curve_names_the_other_operation():
    corner = [(0, 0, 0), (60, 0, 0), (60, 15, 0), (15, 15, 0), (15, 60, 0), (0, 60, 0)]
    with pytest.raises(core.GeometryError, match="take the operation Adaptive") as caught:
        core.clear_with_lame_spiral([core.Region(corner)], **ENOUGH)
    assert caught.value.code == "no lame curve"


def test_without_a_spiral_there_are_no_figures_of_one():
    rooms = [(0, 0), (40, 0), (40, 17), (50, 17), (50, 0), (90, 0)]
    rooms += [(90, 40), (50, 40), (50, 23.4), (40, 23.4), (40, 40), (0, 40)]
    two = core.Region([(x, y, 0) for x, y in rooms])
    more = {**ENOUGH, "narrow_passages": "cut at reduced feed"}
    path = core.clear_with_lame_spiral([two], **more)
    assert path.figures is None
    assert path.cleared_share == 0
    assert "no_spiral" in [code for code, _, _ in path.report.findings]
