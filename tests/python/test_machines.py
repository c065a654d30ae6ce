"""Machine profiles: ours, the user's, what is refused, and what the core makes of them."""
import json
import math

import pytest
from evenload import compiled, machines

CORE_WORDS = [
    "name",
    "max_feed",
    "max_accel",
    "max_jerk",
    "centripetal_accel",
    "junction_deviation",
    "block_rate",
    "look_ahead",
    "rapid_feed",
]
RAPID, CUT = 0, 3


def cut(x, y, feed):
    return (CUT, x, y, 0.0, 0.0, 0.0, 0.0, feed)


def start(x, y):
    return (RAPID, x, y, 0.0, 0.0, 0.0, 0.0, 0.0)


def total(moves, profile):
    core = compiled.core()
    times = core.machine_time(moves, core.MachineProfile(**profile))
    return times[-1][0] + times[-1][1]


def test_our_profiles_load_by_their_names_into_the_core_s_words():
    assert machines.names() == ["hobby_router_grbl", "linuxcnc_mill", "machining_centre"]
    for name in machines.names():
        profile = machines.load(name)
        assert list(profile) == CORE_WORDS
        assert profile["name"]
        compiled.core().MachineProfile(**profile)


def test_a_better_machine_is_faster_on_a_path_of_short_lines():
    moves = [start(10, 0)]
    for i in range(1, 721):
        angle = math.radians(i)
        moves.append(cut(10 * math.cos(angle), 10 * math.sin(angle), 6000))
    times = [total(moves, machines.load(name)) for name in machines.names()]
    programmed = compiled.core().programmed_time(moves, 5000)
    assert times[0] > times[1] > times[2] > programmed


def test_one_line_takes_length_over_speed_plus_speed_over_acceleration():
    profile = machines.load({"max_feed_mm_min": 6000, "acceleration_mm_s2": 500})
    assert total([start(0, 0), cut(200, 0, 6000)], profile) == pytest.approx(2.2, rel=1e-12)


def test_a_dictionary_needs_feeds_and_accelerations_alone():
    profile = machines.load({"max_feed_mm_min": [6000, 5000, 4000], "acceleration_mm_s2": 500})
    assert profile == {
        "name": "the user's machine",
        "max_feed": (6000.0, 5000.0, 4000.0),
        "max_accel": (500.0, 500.0, 500.0),
        "max_jerk": 0.0,
        "centripetal_accel": 0.0,
        "junction_deviation": 0.0,
        "block_rate": 0.0,
        "look_ahead": 0,
        "rapid_feed": 6000.0,
    }
    assert isinstance(profile["look_ahead"], int)


def test_a_file_of_the_user_s_is_a_profile(tmp_path):
    path = tmp_path / "mine.json"
    values = {"max_feed_mm_min": 3000, "acceleration_mm_s2": 200, "jerk_mm_s3": 5000}
    path.write_text(json.dumps(values))
    assert machines.load(path)["name"] == "mine"
    assert machines.load(str(path))["max_jerk"] == 5000
    path.write_text(json.dumps(dict(values, name="Mine", rapid_feed_mm_min=2000, note="new")))
    assert machines.load(path)["name"] == "Mine"
    assert machines.load(path)["rapid_feed"] == 2000


GOOD = {"name": "m", "max_feed_mm_min": 6000, "acceleration_mm_s2": 500}


@pytest.mark.parametrize(
    "given, sentence",
    [
        ("lathe", "There is no machine 'lathe': choose one of 'hobby_router_grbl', "),
        (7, "A machine is a name, a JSON file or a dictionary of limits, not 7."),
        ({"max_feed_mm_min": 1}, "The machine 'the user's machine' has no acceleration_mm_s2: "),
        (dict(GOOD, max_feed_mm_min=[1, 2]), "max_feed_mm_min of the machine 'm' must be one"),
        (dict(GOOD, max_feed_mm_min=[1, 2, 0]), "max_feed_mm_min of the machine 'm' must be one"),
        (dict(GOOD, acceleration_mm_s2="1"), "acceleration_mm_s2 of the machine 'm' must be one"),
        (dict(GOOD, jerk_mm_s3=-1), "jerk_mm_s3 of the machine 'm' must be a number of 0 or more"),
        (dict(GOOD, block_rate_per_s=math.nan), "block_rate_per_s of the machine 'm' must be a"),
        (dict(GOOD, look_ahead_blocks=1.5), "look_ahead_blocks of the machine 'm' must be a whole"),
        (dict(GOOD, rapid_feed_mm_min=0), "rapid_feed_mm_min of the machine 'm' must be a number"),
        (dict(GOOD, jerk=1), "The machine 'm' has the unknown key 'jerk': its keys are "),
    ],
)
def test_what_is_no_machine_is_refused_with_a_sentence(given, sentence):
    with pytest.raises(ValueError) as caught:
        machines.load(given)
    assert sentence in str(caught.value)
    assert str(caught.value).endswith(".")


def test_a_file_that_cannot_be_used_is_named(tmp_path):
    with pytest.raises(ValueError, match="the machine cannot be read: No such file or directory"):
        machines.load(tmp_path / "none.json")


def test_a_move_without_a_feed_is_named_by_its_index():
    profile = machines.load(GOOD)
    with pytest.raises(ValueError, match="Move 1 has no feed above 0 mm/min"):
        total([start(0, 0), cut(1, 0, 0)], profile)


# ---- spindles ----


def test_our_machines_have_spindles():
    for name in machines.names():
        spindle = machines.spindle(name)
        assert 0 < spindle["speeds"][0] < spindle["speeds"][1] < math.inf
        assert 0 < spindle["power"] < math.inf


def test_what_a_profile_does_not_tell_of_its_spindle_is_without_limit():
    bare = {"max_feed_mm_min": 1000, "acceleration_mm_s2": 100}
    assert machines.spindle(bare) == {
        "speeds": (0.0, math.inf),
        "power": math.inf,
        "torque": math.inf,
    }
    told = {**bare, "spindle_speed_rev_min": 9000, "spindle_power_w": 800, "spindle_torque_nm": 2}
    assert machines.spindle(told) == {"speeds": (0.0, 9000.0), "power": 800.0, "torque": 2.0}
    assert machines.load(told) == machines.load(bare)


@pytest.mark.parametrize(
    "given, sentence",
    [
        ({"spindle_power_w": 0}, "spindle_power_w of the machine 'a' must be a number above 0, "),
        ({"spindle_torque_nm": math.nan}, "spindle_torque_nm of the machine 'a' must be a number"),
        ({"spindle_speed_rev_min": [9, 1]}, "must be the largest, or the least and the largest"),
        ({"spindle_speed_rev_min": 0}, "must be the largest, or the least and the largest, not 0."),
        ({"max_feed_mm_min": 0}, "max_feed_mm_min of the machine 'a' must be one number above 0"),
    ],
)
def test_what_is_no_spindle_is_refused_with_a_sentence(given, sentence):
    with pytest.raises(ValueError) as caught:
        machines.spindle({"max_feed_mm_min": 9, "acceleration_mm_s2": 9, "name": "a", **given})
    assert sentence in str(caught.value)
