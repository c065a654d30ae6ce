"""The keys of a job file, and the sentences for those that are wrong."""

import math

NUMBER = (int, float)
NAME_OR_VALUES = (str, dict)
NAME_LIST_OR_VALUES = (str, list, dict)
REQUIRED, OPTIONAL = True, False
FILE_KEYS = {"jobs": (list, REQUIRED), "report": (str, OPTIONAL)}
JOB_KEYS = {
    "name": (str, OPTIONAL),
    "model": (str, REQUIRED),
    "object": (str, OPTIONAL),
    "base": (list, REQUIRED),
    "stock": (dict, OPTIONAL),
    "tool": (dict, REQUIRED),
    "cutting": (dict, REQUIRED),
    "operation": (dict, REQUIRED),
    "simulation": (dict, OPTIONAL),
    "stability": (dict, OPTIONAL),
    "inspection": (dict, OPTIONAL),
    "post": (dict, OPTIONAL),
    "output": (dict, REQUIRED),
}
SECTION_KEYS = {
    "stock": {"margin": (NUMBER, OPTIONAL)},
    "tool": {
        "diameter": (NUMBER, REQUIRED),
        "shape": (str, OPTIONAL),
        "corner_radius": (NUMBER, OPTIONAL),
        "flutes": (int, OPTIONAL),
        "cutting_length": (NUMBER, OPTIONAL),
    },
    "cutting": {
        "feed": (NUMBER, REQUIRED),
        "plunge_feed": (NUMBER, OPTIONAL),
        "rapid_feed": (NUMBER, OPTIONAL),
        "spindle_speed": (NUMBER, REQUIRED),
    },
    "operation": {"type": (str, REQUIRED), "parameters": (dict, OPTIONAL)},
    "simulation": {
        "resolution": (NUMBER, OPTIONAL),
        "step": (NUMBER, OPTIONAL),
        "material": (NAME_OR_VALUES, OPTIONAL),
        "machine": (NAME_OR_VALUES, OPTIONAL),
        "picture": (str, OPTIONAL),
    },
    "stability": {
        "modes": (NAME_LIST_OR_VALUES, OPTIONAL),
        "material": (NAME_OR_VALUES, OPTIONAL),
        "machine": (NAME_OR_VALUES, OPTIONAL),
        "process_damping": (NUMBER, OPTIONAL),
        "picture": (str, OPTIONAL),
    },
    "inspection": {
        "faces": (list, OPTIONAL),
        "points": (int, OPTIONAL),
        "pattern": (str, OPTIONAL),
        "spacing": (str, OPTIONAL),
        "margin": (NUMBER, OPTIONAL),
        "csv": (str, OPTIONAL),
        "dmis": (str, OPTIONAL),
        "picture": (str, OPTIONAL),
        "probing": (str, OPTIONAL),
        "probe": (dict, OPTIONAL),
        "measured": (str, OPTIONAL),
        "ball_radius": (NUMBER, OPTIONAL),
        "points_of": (str, OPTIONAL),
        "feature": (str, OPTIONAL),
        "free": (list, OPTIONAL),
        "datum": (str, OPTIONAL),
        "tolerance": (NUMBER, OPTIONAL),
        "map": (str, OPTIONAL),
        "report": (str, OPTIONAL),
    },
    "post": {"processor": (str, OPTIONAL), "arguments": (str, OPTIONAL)},
    "output": {
        "gcode": (str, REQUIRED),
        "picture": (str, OPTIONAL),
        "document": (str, OPTIONAL),
    },
}
PROBE_KEYS = {
    "diameter": (NUMBER, OPTIONAL),
    "clearance": (NUMBER, OPTIONAL),
    "overshoot": (NUMBER, OPTIONAL),
    "rapid_feed": (NUMBER, OPTIONAL),
    "feed": (NUMBER, OPTIONAL),
}
MAY_BE_ZERO = ("margin", "process_damping", "ball_radius")
KINDS = {
    str: "text",
    list: "a list",
    dict: "an object",
    int: "a whole number",
    NUMBER: "a number",
    NAME_OR_VALUES: "a name or an object",
    NAME_LIST_OR_VALUES: "a file, a list or an object",
}


def check_keys(content, keys, where):
    if not isinstance(content, dict):
        raise ValueError("%s must be an object with the keys %s." % (where, ", ".join(keys)))
    for key in content:
        if key not in keys:
            raise ValueError(
                "%s: unknown key '%s'; known keys are %s." % (where, key, ", ".join(keys))
            )
    for key, (kind, required) in keys.items():
        if key not in content:
            if required:
                raise ValueError("%s: the key '%s' is missing." % (where, key))
        elif not isinstance(content[key], kind) or isinstance(content[key], bool):
            raise ValueError("%s: '%s' must be %s." % (where, key, KINDS[kind]))
        elif isinstance(content[key], NUMBER):
            _check_size(content[key], key, where)


def _check_size(value, key, where):
    """No number in a job file outside of `parameters` makes sense below zero."""
    least = "0 or more" if key in MAY_BE_ZERO else "more than 0"
    if not math.isfinite(value) or value < 0 or (value == 0 and key not in MAY_BE_ZERO):
        raise ValueError("%s: '%s' is %g: it must be %s." % (where, key, value, least))
