"""What the core finds is said in words, each of its codes, by the numbers that come with it."""

import math
import re
from pathlib import Path

import pytest
from evenload import findings
from evenload.settings import labels, notes
from test_lame_spiral import ENOUGH, core

HEADER = Path(__file__).resolve().parents[2] / "src" / "toolpath" / "finding.h"
NUMBERS = {  # code -> numbers as the header tells of them
    "left_uncut": (1.234,),
    "left_without_wall_pass": (1.234,),
    "left_beside_spiral": (1.26,),
    "pocket_skipped": (6, 5.2),
    "helix_narrowed": (7, 5.88),
    "tight_turns": (0.5, 1, 2),
    "thick_chips": (1.5,),
    "passage_skipped": (6.1, 2.5),
    "passage_skipped_too_narrow": (6.1, 2.5),
    "passage_reduced": (6.1, 0, math.pi, 63.75),
    "passage_reduced_too_narrow": (6.1, 2.5, math.pi, 63.75),
    "spiral_of_set_size": (0.456,),
    "spiral_after_channel": (0.456,),
    "small_pitch": (0.25,),
    "tight_spiral": (0.125,),
    "no_pattern_after_cuts": (0,),
    "no_pattern_between_walls": (1,),
    "no_pattern_so_wide": (2,),
    "no_pattern_so_short": (0,),
    "no_pattern_without_room": (1,),
    "no_pattern_without_start": (2,),
    "advance_unsettled": (20, 0.0125),
}


def codes():
    """As the core has them, in Python's way of writing."""
    body = re.search(r"enum class FindingCode \{(.*?)\};", HEADER.read_text(), re.S).group(1)
    names = re.findall(r"^  k(\w+),", body, re.M)
    return [re.sub(r"(?<!^)([A-Z])", r"_\1", name).lower() for name in names]


def test_there_is_a_sentence_for_each_code_and_for_nothing_else():
    assert sorted(codes()) == sorted(findings.SENTENCES)


@pytest.mark.parametrize("code", sorted(findings.SENTENCES))
def test_a_sentence_has_all_that_comes_with_its_code(code):
    said = findings.sentence(code, (1.5, -0.001), NUMBERS.get(code, ()))
    assert said.endswith(".") and "{" not in said and "%s" not in said and "  " not in said
    assert ("near (1.50, 0.00)" in said) == ("near" in said)


@pytest.mark.parametrize("code", sorted(NUMBERS))
def test_no_sentence_is_said_without_its_numbers(code):
    with pytest.raises((IndexError, TypeError)):
        findings.sentence(code, (1, 2), ())


@pytest.mark.parametrize(
    "code, where, numbers, said",
    [
        (
            "tight_turns",
            (3, 4),
            (0.5, 1, 1),
            "Turned more tightly than the wished 1.000 mm in narrow places, down to 0.500 mm near "
            "(3.00, 4.00).",
        ),
        (
            "tight_turns",
            (3, 4),
            (0.5, 1, 2),
            "Turned more tightly than the wished 1.000 mm in narrow places of 2 rooms, down to "
            "0.500 mm near (3.00, 4.00).",
        ),
        (
            "passage_reduced_too_narrow",
            (26, 0),
            (6.1, 2.5, math.pi, 63.75),
            "Cut at reduced feed, too narrow for trochoids: the passage near (26.00, 0.00), 6.10 "
            "mm wide at its narrowest, with up to 180° engaged, down to 63.8 mm/min; 2.50 mm² "
            "stay uncut there.",
        ),
        (
            "passage_skipped",
            (26, 0),
            (6.5, 0),
            "Skipped: the passage near (26.00, 0.00), 6.50 mm wide at its narrowest.",
        ),
        (
            "pocket_skipped",
            (1, 2),
            (6, 0),
            "The pocket near (1.00, 2.00) was skipped. The tool of 6 mm does not fit into the "
            "pocket: no tool does, lower StockToLeave.",
        ),
        (
            "no_pattern_so_short",
            (2, 0),
            (2,),
            "No trochoid was repeated near (2.00, 0.00), where the slot is too short for a few "
            "periods: this region was cleared pass by pass, Pattern Cycloid was not used.",
        ),
        (
            "spiral_of_set_size",
            None,
            (0.456,),
            "The spiral clears only 46 % of this pocket, for SemiAxisA or SemiAxisB is set.",
        ),
    ],
)
def test_sentences(code, where, numbers, said):
    assert findings.sentence(code, where, numbers) == said


WISHES = ("helix_for_ramp", "helix_for_spiral", "helix_narrowed", "ramp_for_helix", "small_pitch")
WISHES += ("tight_spiral", "tight_turns")


@pytest.mark.parametrize("code", sorted(findings.SENTENCES))
def test_panels_tell_what_became_of_wishes_from_warnings(code):
    said = labels.told(findings.sentence(code, (1, 2), NUMBERS.get(code, ())))
    assert notes.kind_of(said) == (notes.WISH if code in WISHES else notes.WARNING)


def test_a_path_says_what_and_where_in_the_user_s_picture():
    slot = core.Region([(0, 0, 0), (40, 0, 0), (40, 6.5, 0), (0, 6.5, 0)])
    given = {**ENOUGH, "narrow_passages": "skip and report"}
    for mode in ("climb", "conventional"):
        path = core.clear_pocket([slot], **given, cut_mode=mode)
        ((code, where, numbers),) = path.report.findings
        assert code == "passage_skipped"
        assert where == pytest.approx((20, 3.25), abs=0.5)
        assert numbers == pytest.approx((6.5, path.report.uncut_area), abs=0.01)
        assert findings.sentences(path.report.findings)[0].startswith("Skipped: the passage near (")
