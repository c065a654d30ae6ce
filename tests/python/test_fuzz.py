"""The fuzz driver: its cases, and that it sees what is wrong."""

import json
import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
import fuzz_adaptive  # noqa: E402
import shapes  # noqa: E402

FINE = {**{name: 0.0 for name in fuzz_adaptive.LIMITS}, "ratio": 1.1}


def first_cases(count, seed=1):
    found = fuzz_adaptive.cases(seed, 0)
    return [next(found) for _ in range(count)]


def test_a_case_depends_on_its_seed_and_number_alone():
    all_of_them = first_cases(20)
    number, case = all_of_them[9]
    assert next(fuzz_adaptive.cases(1, number)) == (number, case)
    assert next(fuzz_adaptive.cases(2, number))[1] != case
    assert len({case["name"] for _, case in all_of_them}) == 20


def test_all_kinds_come_up_with_all_numbers_of_islands_and_angles_in_range():
    cases = [case for _, case in first_cases(140)]
    kinds = {case["name"].split("_")[1] for case in cases}
    assert kinds == {kind.__name__ for kind in shapes.KINDS}
    assert {len(case["islands"]) for case in cases} >= {0, 1, 2, 3}
    low, high = shapes.ANGLES
    assert all(low <= case["engagement_deg"] <= high for case in cases)
    assert any(case.get("open") for case in cases)


@pytest.mark.parametrize("kind", shapes.KINDS)
def test_every_kind_makes_outlines_the_core_takes(kind):
    from evenload import _core

    for number in range(5):
        pick = random.Random(number)
        outer, islands, _ = kind(pick)
        region = _core.Region(outer, islands)
        assert region.area > 0


def test_a_case_is_cleared_and_judged():
    (_, case), *_ = [pair for pair in first_cases(7) if "slot" in pair[1]["name"]]
    case["engagement_deg"] = 60.0
    answer = fuzz_adaptive.judge(case, twice=True)
    assert set(answer["figures"]) == set(fuzz_adaptive.LIMITS) | {"ratio"}
    assert 1.0 < answer["figures"]["ratio"] < 3 and 0 < answer["compute"] < 60


def test_every_figure_above_its_limit_is_a_fault():
    assert fuzz_adaptive.faults({"figures": FINE, "compute": 1.0}) == []
    for name, limit in fuzz_adaptive.LIMITS.items():
        (fault,) = fuzz_adaptive.faults({"figures": {**FINE, name: limit + 1}, "compute": 1.0})
        assert fault.startswith(name + " ")
        bad = {**FINE, name: float("nan")}
        assert len(fuzz_adaptive.faults({"figures": bad, "compute": 1.0})) == 1
    assert fuzz_adaptive.faults({"figures": FINE, "compute": 61.0}) == ["took 61 s"]
    assert fuzz_adaptive.faults({"refused": "too narrow"}) == []
    assert fuzz_adaptive.faults({"wrong": "crashed with code -11"}) == ["crashed with code -11"]


def test_a_core_s_error_is_a_fault_and_a_pocket_too_narrow_is_none():
    _, case = first_cases(1)[0]
    assert "wrong" in fuzz_adaptive.judge({**case, "feed": -1.0}, False)
    narrow = {**case, "tool": 500.0}
    assert "does not fit" in fuzz_adaptive.judge(narrow, False)["refused"]


def test_failing_cases_are_written_as_corpus_cases(tmp_path, monkeypatch):
    monkeypatch.setitem(fuzz_adaptive.LIMITS, "over", -200.0)
    summary = fuzz_adaptive.fuzz(1.0, 1, 7, 1, tmp_path)
    (path,) = tmp_path.iterdir()
    case = json.loads(path.read_text())
    assert case["name"] == path.stem and "over" in case["note"]
    assert summary.failed == summary.cases == 1
    assert list(summary.lines())[0] == "1 cases, 1 failed, 0 too narrow"
