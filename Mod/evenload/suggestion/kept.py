"""What a tool stands, which FreeCAD does not ask for: suggested, and kept with the tool controller
where the user knows better.
"""

import json

from evenload import materials

GROUP = "EvenLoad"
PROPERTY = "CuttingLimits"
DOC = "What the tool stands, for suggested feeds and speeds: JSON, see docs/optimisation.md"
OUTPUT = 8  # FreeCAD's property attribute for what changes without putting operations out of date
CHIP_SHARE = 0.006  # of the diameter: the largest chip thickness where nobody tells
LENGTH_SHARE = 2.0  # of the diameter: the cutting length where the tool bit does not tell
# m/min: of tools without a spindle speed; else from so much of what is set up to that.
SURFACE_SPEED, LEAST_SHARE = (100.0, 200.0), 0.75
SPEEDS = ("least_speed", "most_speed")  # suggested by what is set, and kept once that is changed
KEYS = ("max_chip_thickness", *SPEEDS, "cutting_length", "teeth")


def suggested(cut):
    """{one of KEYS: mm, m/min} for the tool of a Cut."""
    tool, now = cut.tool, cut.surface_speed
    least, most = (LEAST_SHARE * now, now) if now > 0 else SURFACE_SPEED
    return {
        "max_chip_thickness": cut.chip_load or CHIP_SHARE * tool.diameter,
        "least_speed": least,
        "most_speed": most,
        "cutting_length": tool.cutting_length or LENGTH_SHARE * tool.diameter,
        "teeth": tool.teeth,
    }


def of(controller, cut):
    """The same, with what is kept of the tool in place of what is suggested. Raises ValueError with
    a sentence for what somebody wrote into the property.
    """
    return {**suggested(cut), **_read(controller)}


def changed(controller, cut, limits, always=()):
    """Those of the limits that differ from what was suggested or kept. always: the keys of those
    that are to be kept in any case.
    """
    before, there = of(controller, cut), _read(controller)
    return {
        key: limits[key]
        for key in KEYS
        if limits[key] != before[key] or (key in always and key not in there)
    }


def keep(controller, cut, limits, always=()):
    """Keeps what was changed; nothing is touched where nothing was."""
    found = changed(controller, cut, limits, always)
    if not found:
        return
    if not hasattr(controller, PROPERTY):
        controller.addProperty("App::PropertyString", PROPERTY, GROUP, DOC, OUTPUT)
    setattr(controller, PROPERTY, json.dumps({**_read(controller), **found}))


def _read(controller):
    text = getattr(controller, PROPERTY, "")
    if not text.strip():
        return {}
    try:
        found = json.loads(text)
    except ValueError:
        found = None
    is_usable = isinstance(found, dict) and all(
        key in KEYS and materials.number(value) and value > 0 for key, value in found.items()
    )
    if not is_usable:
        raise ValueError(
            "%s of the tool controller '%s' cannot be read: empty it."
            % (PROPERTY, controller.Label)
        )
    return found
