"""docs/messages.md: all sentences that the window may show, what each means, and up to date."""

import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
import messages_page  # noqa: E402
from messages_explained import MEANT  # noqa: E402
from messages_meant import FAMILIES, PLACED  # noqa: E402

pytestmark = pytest.mark.core

SENTENCES = [each for found in messages_page.sentences().values() for each in found]


def test_the_page_is_up_to_date():
    page = (ROOT / "docs" / "messages.md").read_text(encoding="utf-8")
    assert page == messages_page.page(), "write it anew by ./run messages-page"


def test_every_sentence_has_its_meaning():
    assert len(SENTENCES) > 300
    assert [each for each in SENTENCES if not messages_page.meant(each)] == []


def test_no_meaning_and_no_place_is_of_a_sentence_that_is_gone():
    for begin in (*MEANT, *PLACED):
        assert any(each.startswith(begin) for each in SENTENCES), begin
    for looked_for, _ in FAMILIES:
        assert any(re.search(looked_for, each) for each in SENTENCES), looked_for


def test_a_sentence_of_each_room_is_there():
    groups = messages_page.sentences()
    assert all(groups.values())
    for part in (
        "Nothing was left to cut",
        "The path plunges into",
        "SafeHeight (\u2026 mm) lies below StartDepth",
        "The outline is open at (\u2026, \u2026)",
        "The tool touches none of the picked faces",
    ):
        assert any(part in each for each in SENTENCES), part


def test_what_a_sentence_tells_to_do_is_divided_from_what_it_states():
    text = "SafeHeight (\u2026 mm) lies below StartDepth (\u2026 mm): raise it."
    stated, told = messages_page.divided(text)
    assert (stated, told) == (
        "SafeHeight (\u2026 mm) lies below StartDepth (\u2026 mm).",
        "Raise it.",
    )
    assert messages_page.divided("The path cuts.") == ("The path cuts.", "")
