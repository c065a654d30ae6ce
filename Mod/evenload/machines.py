"""Machine profiles: how fast a machine changes its speed, from JSON files with units in their keys.

Ours lie in Resources/machines/; docs/force_and_time.md says what the keys mean. Needs neither
FreeCAD nor the core.
"""

import math
import os

from evenload import materials

FOLDER = os.path.join(materials.ADDON, "Resources", "machines")
# (key of the file, key of the core) of values per axis, and of single values with their defaults
AXES = (("max_feed_mm_min", "max_feed"), ("acceleration_mm_s2", "max_accel"))
SINGLE = (
    ("jerk_mm_s3", "max_jerk", 0.0),
    ("centripetal_acceleration_mm_s2", "centripetal_accel", 0.0),
    ("junction_deviation_mm", "junction_deviation", 0.0),
    ("block_rate_per_s", "block_rate", 0.0),
    ("look_ahead_blocks", "look_ahead", 0),
)
RAPID = "rapid_feed_mm_min"
# (key of the file, what `spindle` calls it)
SPINDLE = (("spindle_power_w", "power"), ("spindle_torque_nm", "torque"))
SPEEDS = "spindle_speed_rev_min"
MODES = "modes"  # of vibration at the tip, as dynamics.vibration has them
KEYS = (
    tuple(k for k, _ in AXES)
    + tuple(k for k, _, _ in SINGLE)
    + tuple(k for k, _ in SPINDLE)
    + (RAPID, SPEEDS, MODES, "name", "note")
)


def names():
    """The names under which our profiles are loaded, sorted."""
    return sorted(name[:-5] for name in os.listdir(FOLDER) if name.endswith(".json"))


def load(machine):
    """A profile in the core's words and units: name; max_feed (mm/min) and max_accel (mm/s2), both
    (x, y, z); max_jerk, centripetal_accel, junction_deviation, block_rate, look_ahead, rapid_feed.

    machine: one of names(), the path of a JSON file, or a dictionary with the keys of such a file.
    Raises ValueError with a sentence for what cannot be used.
    """
    return _checked(*_profile(machine))


def profile(machine):
    """The dictionary of a machine, as in a file, with its name. machine: as for `load`. Raises
    ValueError with a sentence for what cannot be used.
    """
    found, name = _profile(machine)
    _checked(found, name)
    return {**found, "name": name}


def spindle(machine):
    """{"speeds": (least, largest) in rev/min, "power": W, "torque": N m} of a machine's spindle;
    what its profile does not tell is without limit.

    machine: as for `load`. Raises ValueError with a sentence for what cannot be used.
    """
    profile, name = _profile(machine)
    _checked(profile, name)
    result = {"speeds": (0.0, math.inf)}
    for key, word in SPINDLE:
        value = profile.get(key, math.inf)
        if key in profile and not (materials.number(value) and value > 0):
            raise ValueError(
                "%s of the machine '%s' must be a number above 0, not %r." % (key, name, value)
            )
        result[word] = float(value)
    if SPEEDS in profile:
        result["speeds"] = _speeds(profile[SPEEDS], name)
    return result


def modes(machine):
    """{"name", "modes"} of a machine's modes of vibration, as dynamics.vibration.load takes them;
    None where its profile has none. machine: as for `load`.
    """
    profile, name = _profile(machine)
    _checked(profile, name)
    return {"name": name, "modes": profile[MODES]} if MODES in profile else None


def _speeds(value, name):
    values = [0.0, value] if materials.number(value) else value
    if (
        not isinstance(values, (list, tuple))
        or len(values) != 2
        or not all(materials.number(v) for v in values)
        or not 0 <= values[0] <= values[1]
        or not values[1] > 0
    ):
        raise ValueError(
            "%s of the machine '%s' must be the largest, or the least and the largest, not %r."
            % (SPEEDS, name, value)
        )
    return float(values[0]), float(values[1])


def _profile(machine):
    """(dictionary as in a file, name) of what `load` takes."""
    if isinstance(machine, dict):
        return machine, str(machine.get("name") or "the user's machine")
    if not isinstance(machine, (str, os.PathLike)):
        raise ValueError(
            "A machine is a name, a JSON file or a dictionary of limits, not %r." % (machine,)
        )
    path = os.fspath(machine)
    if path in names():
        path = os.path.join(FOLDER, path + ".json")
    elif not path.lower().endswith(".json"):
        raise ValueError(
            "There is no machine '%s': choose one of %s, or give a JSON file or a dictionary of"
            " limits." % (path, ", ".join("'%s'" % name for name in names()))
        )
    profile = materials.read_object(path, "machine")
    return profile, str(profile.get("name") or os.path.splitext(os.path.basename(path))[0])


def _checked(profile, name):
    unknown = sorted(str(key) for key in profile if key not in KEYS)
    if unknown:
        raise ValueError(
            "The machine '%s' has the unknown key '%s': its keys are %s."
            % (name, unknown[0], ", ".join(KEYS))
        )
    result = {"name": name}
    for key, word in AXES:
        result[word] = _per_axis(profile, name, key)
    for key, word, default in SINGLE:
        value = profile.get(key, default)
        if not materials.number(value) or value < 0:
            raise ValueError(
                "%s of the machine '%s' must be a number of 0 or more, not %r." % (key, name, value)
            )
        if isinstance(default, int) and value != int(value):
            raise ValueError(
                "%s of the machine '%s' must be a whole number, not %r." % (key, name, value)
            )
        result[word] = type(default)(value)
    rapid = profile.get(RAPID, max(result["max_feed"]))
    if not materials.number(rapid) or rapid <= 0:
        raise ValueError(
            "%s of the machine '%s' must be a number above 0, not %r." % (RAPID, name, rapid)
        )
    result["rapid_feed"] = float(rapid)
    return result


def _per_axis(profile, name, key):
    if key not in profile:
        raise ValueError(
            "The machine '%s' has no %s: give it one number, or one each for x, y and z."
            % (name, key)
        )
    value = profile[key]
    values = [value] * 3 if materials.number(value) else value
    if (
        not isinstance(values, (list, tuple))
        or len(values) != 3
        or not all(materials.number(v) and v > 0 for v in values)
    ):
        raise ValueError(
            "%s of the machine '%s' must be one number above 0, or one each for x, y and z, not %r."
            % (key, name, value)
        )
    return tuple(float(v) for v in values)
