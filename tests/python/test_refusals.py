"""What the core cannot work on is said in words, each kind of refusal, and never by the core."""

import math
import pickle
import re
from pathlib import Path

import pytest
from evenload import refusals
from test_lame_spiral import ENOUGH, core

SUPPORT = Path(__file__).resolve().parents[2] / "src" / "support"
NUMBERS = {  # kind -> numbers as refusal.h tells of them
    "curve_not_finite": (0,),
    "curve_not_closed": (1, 3, 4),
    "curve_without_area": (2,),
    "island_crosses_itself": (1,),
    "outline_crosses_island": (1,),
    "islands_cross": (1, 2),
    "island_outside_outline": (1,),
    "island_inside_another": (2, 1),
    "tool_fits_nowhere": (6, 4.996),
    "spiral_too_small": (0.456,),
    "spiral_too_small_at_centre": (0.456,),
    "spiral_too_small_as_set": (0.456,),
}
SAID = {  # at (1.5, -2)
    "curve_not_finite": "The outline has a coordinate that is not a number, after the point near "
    "(1.5, -2): draw this piece again.",
    "curve_not_closed": "An island is not closed: it ends near (1.5, -2): join this end to its "
    "start at (3, 4) in the sketch.",
    "curve_without_area": "An island encloses no area near (1.5, -2): draw it as a closed curve of "
    "at least two pieces.",
    "outline_crosses_itself": "The outline crosses or touches itself near (1.5, -2): remove the "
    "crossing in the sketch.",
    "island_crosses_itself": "An island crosses or touches itself near (1.5, -2): remove the "
    "crossing in the sketch.",
    "outline_crosses_island": "The outline and an island cross or touch near (1.5, -2): move them "
    "apart in the sketch, or join them into one curve.",
    "islands_cross": "Two islands cross or touch near (1.5, -2): move them apart in the sketch, or "
    "join them into one curve.",
    "island_outside_outline": "An island lies outside the outline near (1.5, -2): move it inside "
    "or remove it.",
    "island_inside_another": "An island lies inside another island near (1.5, -2): remove the "
    "inner one, or make it a pocket of its own.",
    "tool_fits_nowhere": "The tool of 6 mm does not fit into the pocket: the largest tool that "
    "fits has 4.996 mm.",
    "spiral_too_small": "A Lamé spiral would clear only 46 % of this pocket: take the operation "
    "Adaptive.",
    "spiral_too_small_at_centre": "With this Centre the largest spiral would clear 46 % of this "
    "pocket: move Centre towards the middle, leave it unset, or take the operation Adaptive.",
    "spiral_too_small_as_set": "With the set Segments, ExponentEnd or Rotation the largest spiral "
    "would clear 46 % of this pocket: leave them unset, or take the operation Adaptive.",
}
# By a piece of each, those that tell nothing but what they are.
PIECES = {
    "middle_not_finite": "must have finite coordinates",
    "middle_without_length": "has no length",
    "middle_crosses_itself": "crosses itself",
    "middle_bends_too_tightly": "bends more tightly",
    "slot_sides_meet": "sides meet each other",
    "no_room_to_descend": "no room to descend",
    "hole_out_of_reach": "move EntryPoint into the pocket",
    "hole_in_skipped_passage": "lies in a narrow passage that is skipped",
    "hole_too_tight": "too tight to start from",
    "hole_outside_pocket": "lies outside this pocket",
    "hole_too_tight_for_spiral": "too tight to start a spiral from",
    "hole_off_middle": "from the pre-drilled hole to the pocket's walls",
    "hole_beside_channel": "drill the hole there",
    "hole_at_island": "comes from outside",
    "not_for_spirals": "an outline that is all wall or all open",
    "centre_outside": "Centre lies outside",
    "no_curve_as_set": "keeps clear of the walls",
    "no_curve": "resembles this pocket",
    "set_size_too_small": "SemiAxisA and SemiAxisB leave no room",
    "no_room_for_spiral": "too little room",
    "no_growth": "from one outline of this pocket to the other",
    "no_growth_by_courses": "from its first turn to its last",
    "no_load": "keeps to the engagement angle in this pocket",
    "no_load_by_courses": "more even",
    "two_courses": "have two courses",
}


def kinds():
    """[(as C++ writes it, in Python's way of writing), ...] of all that the core has."""
    header = (SUPPORT / "refusal.h").read_text(encoding="utf-8")
    body = re.search(r"enum class Refusal \{(.*?)\};", header, re.S).group(1)
    names = re.findall(r"^  k(\w+),", body, re.M)
    return [(name, re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower()) for name in names]


def said(kind):
    return refusals.sentence(kind, (1.5, -2.0), NUMBERS.get(kind, ()))


def test_there_is_a_sentence_for_each_kind_and_for_nothing_else():
    found = sorted(kind for _, kind in kinds())
    assert found == sorted(refusals.SENTENCES)
    assert found == sorted([*SAID, *PIECES])


def test_the_core_gives_each_kind_its_own_name():
    rows = re.findall(
        r'\{Refusal::k(\w+), [\w:]+, "(\w+)"\}',
        (SUPPORT / "refusal.cpp").read_text(encoding="utf-8"),
    )
    assert rows == kinds()


@pytest.mark.parametrize("kind", sorted(SAID))
def test_sentences(kind):
    assert said(kind) == SAID[kind]


@pytest.mark.parametrize("kind", sorted(PIECES))
def test_a_sentence_without_numbers_tells_what_is_wrong_and_what_to_do(kind):
    assert PIECES[kind] in said(kind)
    assert re.fullmatch("[A-Z].*[.]", said(kind)) and "%" not in said(kind)
    others = [each for each in PIECES if each != kind and PIECES[kind] in said(each)]
    assert not others


@pytest.mark.parametrize("kind", sorted(each for each in NUMBERS if "island" not in each))
def test_no_sentence_that_tells_numbers_is_said_without_them(kind):
    with pytest.raises(TypeError):
        refusals.sentence(kind, (1.5, -2.0))


def test_where_no_tool_fits_the_sentence_says_what_else_to_do():
    told = refusals.sentence("tool_fits_nowhere", (0, 0), (6, 0))
    assert told == (
        "The tool of 6 mm does not fit into the pocket: no tool does, lower StockToLeave."
    )


def test_of_several_regions_the_refused_one_is_named():
    told = refusals.sentence("no_curve", (1.234, -2), (), True)
    assert told == "The region near (1.23, -2.00): " + said("no_curve")


# ---- as the core raises them ----

HOOK = [(0, 0, 0), (40, 0, 0), (40, 20, 0), (20, 20, 0), (20, 9, 0)]  # its end is near its start


def square(x, y, side):
    return [(x, y, 0), (x + side, y, 0), (x + side, y + side, 0), (x, y + side, 0)]


def test_an_error_of_the_core_has_a_sentence_and_all_that_it_is_made_of():
    with pytest.raises(core.GeometryError) as caught:
        core.Region(square(0, 0, 20), [square(2, 2, 4), square(30, 5, 4)])
    error = caught.value
    assert (error.code, error.kind) == ("island outside", "island_outside_outline")
    assert error.where == pytest.approx((30, 5), abs=4)
    assert error.numbers == (2,)
    assert str(error) == refusals.sentence(error.kind, error.where, error.numbers)
    assert isinstance(error, ValueError)


def test_an_error_of_the_core_goes_from_one_process_to_another():
    with pytest.raises(core.GeometryError) as caught:
        core.clear_pocket([core.Region(square(0, 0, 5))], **ENOUGH)
    kept = pickle.loads(pickle.dumps(caught.value))
    assert type(kept) is core.GeometryError and str(kept) == str(caught.value)
    assert (kept.code, kept.kind) == ("tool too large", "tool_fits_nowhere")
    assert kept.numbers == (ENOUGH["tool_diameter"], pytest.approx(5, abs=0.01))
    assert str(kept).startswith("The tool of 6 mm does not fit into the pocket: the largest tool ")


def test_of_several_regions_the_core_names_the_one_without_a_spiral():
    slot = core.Region([(100, 0, 0), (190, 0, 0), (190, 9, 0), (100, 9, 0)])
    with pytest.raises(core.GeometryError, match=r"^The region near \(1\d\d\.\d\d, ") as caught:
        core.clear_with_lame_spiral([core.Region(square(0, 0, 40)), slot], **ENOUGH)
    assert caught.value.code == "no lame curve"


@pytest.mark.parametrize(
    "middle, kind, code",
    [
        ([(0, 0, 0), (math.nan, 0, 0)], "middle_not_finite", "not finite"),
        ([(1, 1, 0), (1, 1, 0)], "middle_without_length", "too few points"),
        (
            [(0, 0, 0), (40, 0, 0), (40, 9, 0), (0, 9, 0)],
            "middle_bends_too_tightly",
            "self-crossing",
        ),
        (HOOK, "slot_sides_meet", "self-crossing"),
    ],
)
def test_codes_are_those_that_scripts_know(middle, kind, code):
    with pytest.raises(core.GeometryError) as caught:
        core.slot_around(middle, width=10.0, closed=False, ends="round")
    assert (caught.value.kind, caught.value.code) == (kind, code)
    assert PIECES[kind] in str(caught.value)
