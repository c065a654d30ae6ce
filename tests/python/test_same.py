"""`./run same`: what it compares and tells, and two pockets cleared by two processes."""

import os
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/same", "tests/fuzz", "bench")]
import clearing  # noqa: E402
import comparison  # noqa: E402
import judging  # noqa: E402
import same  # noqa: E402
import same_cases  # noqa: E402
import table  # noqa: E402

pytestmark = pytest.mark.core

PATH = {"program": ["G0 Z5.0000", "G1 X1.0000"], "exact": "a"}


def test_what_differs_in_a_byte_or_in_how_it_ends_differs():
    def verdict(former, present):
        return comparison.verdict({**former}, {**present})

    assert verdict(PATH, PATH) == ("equal", None)
    found, how = verdict(PATH, {**PATH, "exact": "b"})
    assert found == "different" and "as posted" in how
    found, how = verdict(PATH, {"program": ["G0 Z5.0000", "G1 X1.0001"], "exact": "b"})
    assert found == "different" and how == "from block 2 of 2, now of 2"
    found, how = verdict(PATH, {"program": PATH["program"][:1], "exact": "b"})
    assert found == "different" and how == "2 blocks, now 1"
    error, other, late, crash = {"error": "E: a"}, {"error": "E: b"}, {"late": "c"}, {"crash": "d"}
    assert verdict(error, error) == ("equal", "E: a")
    assert verdict(error, other) == ("different", "E: a; now: E: b")
    assert verdict(PATH, late) == ("different", "a path; now: c")
    assert verdict(error, crash)[0] == "different"
    assert (
        verdict(late, late)[0] == verdict(crash, crash)[0] == verdict(late, crash)[0] == "unknown"
    )


def figures(**given):
    usual = {"ratio": 1.1, "over": 0.5, "rest": 0.0, "link": 0.0, "gouge": 0.0}
    return {**usual, "kinks": -4, "retracts": 2, "blocks": 800.0, "seconds": 0.5, **given}


ROWS = [
    table.Row("star, adaptive", "adaptive", figures(), figures(over=1.5, kinks=2)),
    table.Row("ring, adaptive", "adaptive", figures(ratio=1.3), figures(ratio=1.2)),
    table.Row("slot, trochoid", "trochoid", figures(rest=0.001), {}),
]


def test_figures_stand_side_by_side_for_each_operation_and_for_all():
    text = list(table.lines(ROWS, "abc1234", same_cases.OPERATIONS))
    former, present = text[1].split(), text[2].split()
    assert former[:4] == ["adaptive", "abc1234", "2", "1.200"]
    assert present[:4] == ["this", "tree", "2", "1.150"] and present[4:6] == ["1.200", "1.50"]
    assert text[2].endswith("star, adaptive")
    assert former[9:] == ["0", "4", "800", "1.0", "star,", "adaptive"]
    assert present[9] == "2"  # kinks: what a case has less makes up for none of another
    assert text[3].split()[0] == "trochoid" and "0.100" in text[3] and " - " in text[4]
    assert text[5].split()[:3] == ["all", "abc1234", "3"]


def test_the_cases_that_changed_most_are_named():
    text = list(table.changed_most(ROWS))
    assert [line.split()[0] for line in text] == ["time/ideal", "over,", "kinks"]
    assert text[0].endswith("-0.1  ring, adaptive")
    many = [table.Row("c%d" % i, "rest", figures(), figures(over=i)) for i in range(9)]
    assert [line.split()[-1] for line in table.changed_most(many)] == ["c8", "c7", "c6", "c5"]


def test_the_last_line_counts_and_what_does_not_apply_counts_as_neither():
    task = same_cases.Task("adaptive", {"name": "star"})
    found = [
        same.Answer(task, "equal", seconds=(1.0, 2.0)),
        same.Answer(task, "equal", "ValueError: no"),
        same.Answer(task, "different", "2 blocks, now 1", row=ROWS[0]),
        same.Answer(task, "unknown", "took more than 9 s with both"),
        same.Answer(task, refused="nothing is left"),
    ]
    text = list(same.summary(found, "abc1234"))
    assert text[-1] == "2 equal, 1 differ"
    assert text[-2].startswith("1 crash or take too long")
    assert text[-3].endswith("abc1234 1.0, this tree 2.0")
    assert text[-4] == "1 do not apply; 1 end with the same error in both"
    assert text[1] == "figures of the 1 that differ:"
    said = [same.told(each) for each in found]
    assert [bool(each) for each in said] == [False, False, True, True, False]
    assert said[2] == "different: star, adaptive: 2 blocks, now 1"


def test_a_tool_retracts_as_often_as_it_comes_back():
    def at(*heights):
        return [(0, 0.0, 0.0, z, 0.0, 0.0, 0.0, 0.0) for z in heights]

    assert judging.retracts(at(5, -3, -2.8, -3, 3, 5)) == 0
    assert judging.retracts(at(5, -3, 3, -3, 0.0, 5, -3, 5)) == 2
    assert judging.retracts(at(5)) == 0


def test_a_parameter_goes_by_the_name_that_the_docs_have(monkeypatch):
    monkeypatch.setitem(clearing.FORMER_NAMES, "least_turn", "minimum_radius")
    called = clearing.as_it_calls(lambda *regions, **given: given, "takes minimum_radius, feed")
    assert called([], least_turn=1, feed=2) == {"minimum_radius": 1, "feed": 2}
    called = clearing.as_it_calls(lambda *regions, **given: given, "takes least_turn, feed")
    assert called([], least_turn=1, feed=2) == {"least_turn": 1, "feed": 2}


def test_the_cases_are_the_same_each_time_and_cover_all_operations():
    first, again = (list(same_cases.of_seed(same_cases.SEED, 12)) for _ in range(2))
    assert first == again
    assert [
        task.operation for task in first[:4]
    ] == "adaptive trochoid lame_spiral adaptive".split()
    corpus = list(same_cases.of_corpus())
    assert {task.operation for task in corpus} == set(same_cases.OPERATIONS)
    assert len({task.name for task in corpus}) == len(corpus)
    names = {task.case["name"] for task in corpus}
    assert names == {path.stem for path in same_cases.CORPUS.rglob("*.json")}
    assert {task.operation for task in same_cases.tasks("corpus", "rest")} == {"rest"}


def test_two_cores_clear_alike_in_processes_of_their_own(tmp_path):
    from evenload import _core

    shutil.copy(_core.__file__, tmp_path)
    present = os.path.dirname(_core.__file__)
    pair = same.Pair(str(tmp_path), present, 60)
    assert [os.path.dirname(file) for file in pair.core_files()] == [str(tmp_path), present]
    wanted = ("lame_square35, rest", "circle12, lame_spiral")
    tasks = [task for task in same_cases.of_corpus() if task.name in wanted]
    found = list(same.answers(tasks, [pair], True))
    assert [each.verdict for each in found] == ["equal"] * 2
    for each in found:
        assert min(each.seconds) > 0
        assert 1 < each.row.former["ratio"] < 4 and each.row.former["gouge"] < 0.005
        assert {**each.row.former, "seconds": 0} == {**each.row.present, "seconds": 0}
