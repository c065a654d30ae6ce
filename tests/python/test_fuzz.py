"""The fuzz driver: its cases, and that it sees what is wrong."""

import json
import math
import random
import sys
from pathlib import Path

import numpy
import pytest

ROOT = Path(__file__).resolve().parents[2]
CHOSEN = ROOT / "tests" / "corpus" / "chosen"
sys.path[:0] = [str(ROOT / "tests" / "fuzz"), str(ROOT / "bench")]
import choices  # noqa: E402
import figures  # noqa: E402
import fuzz  # noqa: E402
import kinds  # noqa: E402
import posted  # noqa: E402
import random_cases  # noqa: E402
import shapes  # noqa: E402
from evenload import planar  # noqa: E402

pytestmark = pytest.mark.core

FINE = {**{name: 0.0 for name in fuzz.LIMITS}, "climb": 1.0, "ratio": 1.1}


def faults(figures, case=None, compute=1.0, findings=()):
    answer = {"figures": {**FINE, **figures}, "compute": compute, "findings": list(findings)}
    return fuzz.faults(case or {}, answer)


def first_cases(count, seed=1):
    found = random_cases.cases(seed, 0)
    return [next(found) for _ in range(count)]


def test_a_case_depends_on_its_seed_and_number_alone():
    all_of_them = first_cases(20)
    number, case = all_of_them[9]
    assert next(random_cases.cases(1, number)) == (number, case)
    assert next(random_cases.cases(2, number))[1] != case
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
    answer = fuzz.judge(case, twice=True)
    assert set(answer["figures"]) == set(fuzz.LIMITS) | {"climb", "ratio"}
    assert 1.0 < answer["figures"]["ratio"] < 3 and 0 < answer["compute"] < 60


def test_every_figure_above_its_limit_is_a_fault():
    assert faults({}) == []
    for name, limit in fuzz.LIMITS.items():
        (fault,) = faults({name: limit + 1})
        assert fault.startswith(name + " ")
        assert len(faults({name: float("nan")})) == 1
    assert faults({"climb": 0.9}) == ["climb 0.9 below 0.995"]
    assert faults({}, compute=61.0) == ["took 61 s"]
    assert fuzz.faults({}, {"refused": "too narrow"}) == []
    crashed = {"wrong": "crashed with code -11"}
    assert fuzz.faults({}, crashed) == ["crashed with code -11"]


def test_figures_that_do_not_apply_to_a_choice_are_not_judged():
    high = {"rate": 9.0, "rest": 9.0}
    assert len(faults(high)) == 2
    (fault,) = faults(high, {"choices": {"feed_control": "constant force"}})
    assert fault.startswith("rest")
    (fault,) = faults(high, {"choices": {"narrow_passages": "skip and report"}})
    assert fault.startswith("rate")
    (fault,) = faults(high, {}, findings=[choices.NO_HOLE])
    assert fault.startswith("rate")


def test_each_second_case_has_choices_and_all_of_them_come_up():
    cases = first_cases(400)
    assert not any("choices" in case for number, case in cases if number % 2 == 0)
    chosen = set().union(*(case.get("choices", {}) for _, case in cases))
    assert chosen >= {"cut_mode", "feed_control", "entry", "stock_to_leave", "minimum_radius"}
    assert chosen >= {"link_lift", "narrow_passages", "arcs", "least_load"}
    for key in ("hole", "open_edges", "rest_of"):
        assert any(key in case for _, case in cases)


def with_choices(**given):
    """A square of 40 mm with an island."""
    (_, case) = first_cases(1)[0]
    corners = [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 40.0, 0.0], [0.0, 40.0, 0.0]]
    island = [[25.0, 20.0, 1.0], [15.0, 20.0, 1.0]]
    plain = {key: case[key] for key in case if key not in ("choices", "open")}
    return {**plain, "outer": corners, "islands": [island], "engagement_deg": 60.0, **given}


@pytest.mark.parametrize(
    "given",
    (
        {"choices": {"stock_to_leave": 0.4}},
        {"choices": {"cut_mode": "conventional", "entry": "ramp", "arcs": False}},
        {
            "choices": {
                "feed_control": "constant force",
                "force_coefficients": choices.FORCE,
                **choices.SPINDLE,
            }
        },
        {"open_edges": [1, 2]},
        {"hole": [7.0, 7.0, 8.0]},
        {"rest_of": 16.0},
    ),
    ids=lambda given: "_".join(given) + "_" + "_".join(given.get("choices", {})),
)
def test_what_was_chosen_is_cleared_and_judged(given):
    case = with_choices(**given)
    if not case.get("choices", {}).get("arcs", True):
        case["choices"]["tolerance"] = choices.CHORD
    answer = fuzz.judge(case, False)
    assert fuzz.faults(case, answer) == []
    assert answer["figures"]["ratio"] > 0.9


@pytest.mark.parametrize("name", sorted(path.stem for path in CHOSEN.glob("*.json")))
def test_what_fuzzing_found_stays_mended(name):
    case = json.loads((CHOSEN / (name + ".json")).read_text())
    assert case["name"] == name
    answer = fuzz.judge(case, False)
    assert "figures" in answer and fuzz.faults(case, answer) == []


def test_places_cut_at_a_reduced_feed_may_exceed_the_angle_but_not_the_rate():
    limits = {"over": 2, "rate": 1.05, "rest": 0.05}
    code = "passage_reduced_too_narrow"
    assert choices.limits_for({}, [code], limits) == {"rate": 1.05, "rest": 0.05}
    assert choices.limits_for({}, ["tight_turns"], limits) == limits
    assert not faults({"climb": 0.9}, findings=[code])
    assert faults({"climb": 0.9}, findings=["tight_turns"])


def test_rooms_joined_by_passages_at_a_reduced_feed_may_have_an_entry_each():
    code = "passage_reduced"
    assert choices.limits_for({}, [], {"entry": 2.0}) == {"entry": 2.0}
    assert choices.limits_for({}, [code] * 3, {"entry": 2.0}) == {"entry": 8.0}
    assert faults({"entry": 2.01})
    assert not faults({"entry": 2.01}, findings=[code])


def test_corners_of_the_centres_are_counted_where_walls_have_them_and_between_islands():
    square = with_choices()
    assert figures.corners_of_centres({**square, "islands": []}) == 4
    assert figures.corners_of_centres(square) == 4  # a round island has none
    near = [[29.0, 20.0, 1.0], [27.0, 20.0, 1.0]]  # two discs' borders cross in two corners
    assert figures.corners_of_centres({**square, "islands": [*square["islands"], near]}) == 6
    rounded = [[10.0, 0.0, 0.0], [30.0, 0.0, 1.0], [30.0, 20.0, 0.0], [10.0, 20.0, 1.0]]
    assert figures.corners_of_centres({**square, "outer": rounded, "islands": []}) == 0
    # Without walls around it: the border that is assumed far away has its own four.
    assert figures.corners_of_centres({**square, "islands": [], "open": True}) == 4


def test_what_is_posted_is_judged():
    tight = (3, 0.05, 0.05, -1.0, math.pi / 2, 0.0, 0.05, 100.0)
    wide = (3, 5.05, 5.05, -1.0, math.pi / 2, 0.05, 5.05, 100.0)
    start = [(0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0), (2, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 50.0)]
    moves = posted.posted([*start, tight, wide])
    assert [move[0] for move in moves[-2:]] == [3, 3]
    assert moves[-1][1:4] == pytest.approx(wide[1:4], abs=1e-4)
    assert moves[-1][4] == pytest.approx(math.pi / 2, abs=1e-3)
    lines = [move for move in moves if move[0] == 3 and move[4] == 0]
    assert len(lines) > 1 and lines[-1][1:4] == pytest.approx(tight[1:4], abs=1e-4)
    assert {move[7] for move in moves if move[0] == 3} == {100.0}


def test_a_tip_may_be_cut_on_the_wrong_side_but_no_more():
    class Run:  # a straight cut of 10 mm, `wrong` mm of it on the left
        def __init__(self, wrong):
            self.length = numpy.array([10.0 - wrong, wrong])
            self.kind = numpy.array([figures.CUT] * 2)
            self.engagement_deg = numpy.array([30.0, 30.0])
            self.first_arc = numpy.array([0, 1, 2])
            self.arcs = numpy.array([[-90.0, -60.0], [60.0, 90.0]])

    assert figures.climb_share({}, Run(0.5)) == 1
    assert figures.climb_share({}, Run(1.6)) == pytest.approx(0.9)
    conventional = {"choices": {"cut_mode": "conventional"}}
    assert figures.climb_share(conventional, Run(1.6)) == pytest.approx(0.22)


def test_a_core_s_error_is_a_fault_and_a_pocket_too_narrow_is_none():
    _, case = first_cases(1)[0]
    assert "wrong" in fuzz.judge({**case, "feed": -1.0}, False)
    narrow = {**case, "tool": 500.0}
    assert "does not fit" in fuzz.judge(narrow, False)["refused"]


def test_failing_cases_are_written_as_corpus_cases(tmp_path, monkeypatch):
    monkeypatch.setitem(fuzz.LIMITS, "gouge", -1.0)  # a figure that is not looked at twice
    summary = fuzz.fuzz(1.0, 1, 7, 1, tmp_path)
    (path,) = tmp_path.iterdir()
    case = json.loads(path.read_text())
    assert case["name"] == path.stem and "gouge" in case["note"]
    assert summary.failed == summary.cases == 1
    assert list(summary.lines())[0] == "1 cases, 1 failed, 0 too narrow"


@pytest.mark.parametrize("name", fuzz.LIMITS)
def test_a_mean_above_its_limit_is_looked_at_more_closely(name, monkeypatch):
    steps = []

    def look(case, path, scene, step=figures.STEP):
        steps.append((step, scene["resolution"]))
        return {**FINE, name: fuzz.LIMITS[name] + (1 if len(steps) == 1 else 0)}

    monkeypatch.setattr(fuzz, "figures_of", look)
    case = json.loads((ROOT / "tests" / "corpus" / "circle12.json").read_text())
    answer = fuzz.judge(case, False)
    assert steps[0] == (figures.STEP, figures.RESOLUTION)
    closer = [(figures.CLOSE_STEP, figures.FINEST)] if name in figures.MEANS else []
    assert steps[1:] == closer
    assert bool(fuzz.faults(case, answer)) == (name not in figures.MEANS)


# ---- operations that clear certain shapes only ----


@pytest.mark.parametrize("operation", kinds.KINDS)
def test_an_operation_gets_all_of_its_kinds(operation):
    found = random_cases.cases(1, 0, operation)
    several = [next(found)[1] for _ in range(20)]
    names = {case["name"].split("_")[2] for case in several}
    assert names == {kind.__name__ for kind in kinds.KINDS[operation]}
    assert {case["operation"] for case in several} == {operation}
    assert not any("rest_of" in case for case in several)


@pytest.mark.parametrize(
    "kind",
    [kind for of_kinds in kinds.KINDS.values() for kind in of_kinds],
    ids=lambda k: k.__name__,
)
def test_every_kind_of_an_operation_makes_outlines_the_core_takes(kind):
    from evenload import _core

    for seed in range(12):
        outer, islands, is_open = kind(random.Random(seed))
        region = _core.Region(outer, islands)
        assert region.area > 20 and len(region.islands) == len(islands)
        assert is_open == (kind is kinds.island)


def test_an_operations_own_limits_are_stricter():
    found = faults({"over": 1.5}, {"operation": "trochoid"})
    assert found == ["over 1.5 above 1"]
    assert faults({"over": 1.5}) == []


@pytest.mark.parametrize("operation", kinds.KINDS)
def test_a_case_of_an_operation_is_cleared_and_judged(operation):
    _, case = next(random_cases.cases(1, 10, operation))
    answer = fuzz.judge(case, twice=True)
    assert fuzz.faults(case, answer) == [] and "figures" in answer


@pytest.mark.parametrize("helix_angle", (0.3, 1.0, 3.0))
@pytest.mark.parametrize("name", ("tiny_room_with_fillets", "tiny_room_with_a_chamfer"))
def test_every_line_of_a_posted_ramp_descends(name, helix_angle):
    import pocket_case

    case = json.loads((ROOT / "tests" / "corpus" / (name + ".json")).read_text())
    path = pocket_case.path_of(case, helix_angle=math.radians(helix_angle))
    moves = posted.posted(path.moves)
    ramps = [move for move in moves if move[0] == planar.ENTRY and move[4] == 0]
    assert len(ramps) > 50
    assert figures.level_entries(moves, 0.0, -case["axial_depth"]) == 0


def test_a_level_line_of_a_ramp_is_seen():
    def entry(x, z):
        return (planar.ENTRY, x, 0.0, z, 0.0, 0.0, 0.0, 255.0)

    above = (planar.RAPID, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    moves = [above, entry(1, -0.5), entry(1.01, -0.50003), entry(2, -1), entry(3, -1)]
    assert figures.level_entries(moves, 0.0, -1.0) == 1
    assert faults({"level": 1}) == ["level 1 above 0"]
