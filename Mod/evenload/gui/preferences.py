"""What a user prefers in every document: FreeCAD keeps it among its parameters."""

import FreeCAD

from evenload import machines, materials
from evenload.gui import load_colours
from evenload.settings.setting import BOOL, CHOICE
from evenload.settings.table import SETTINGS

KEPT_IN = "User parameter:BaseApp/Preferences/Mod/EvenLoad"
LIVE_PREVIEW, MACHINE, SCALE = "LivePreview", "Machine", "ColourScale"
# Settings whose values at first a user may choose: those of the cut and the controller, not of one
# pocket.
OFFERED = (
    *("EngagementAngle", "CutMode", "StockToLeave", "StockToLeaveAxial", "FeedControl", "Material"),
    *("Entry", "HelixAngle", "NarrowPassages", "Tolerance", "Arcs", "Check"),
)
ROWS = tuple(row for row in SETTINGS if row.name in OFFERED)


def _group(name=""):
    return FreeCAD.ParamGet(KEPT_IN + name)


def live_preview():
    """Whether the user wants the path to be shown while values change."""
    return _group().GetBool(LIVE_PREVIEW, True)


def keep_live_preview(is_wanted):
    _group().SetBool(LIVE_PREVIEW, is_wanted)


def machine():
    """The name or file of the machine that windows begin with; None for none."""
    kept = _group().GetString(MACHINE, "")
    return kept if kept in machines.names() or kept.lower().endswith(".json") else None


def keep_machine(machine):
    _group().SetString(MACHINE, machine or "")


def scale():
    """The name of the colours of values in the 3D view, one of load_colours.SCALES."""
    kept = _group().GetString(SCALE, "")
    return kept if kept in load_colours.SCALES else load_colours.names()[0]


def keep_scale(name):
    _group().SetString(SCALE, name)


def material():
    """The material of what says none itself."""
    (row,) = (each for each in ROWS if each.name == "Material")
    return default_of(row) or materials.names()[0]


# ---- what operations begin with ----


def own_default(row):
    """A setting's value at first where the user prefers no other."""
    return row.value[0] if row.type == CHOICE else row.value


def default_of(row):
    """What the user prefers a setting's value to be at first; None where he prefers nothing, or
    what it can no longer be.
    """
    group = _group("/Defaults")
    if row.type == CHOICE:
        kept = group.GetString(row.name, "")
        return kept if kept in row.value else None
    if row.type == BOOL:
        return group.GetBool(row.name) if row.name in group.GetBools() else None
    if row.name not in group.GetFloats():
        return None
    kept = group.GetFloat(row.name)
    return kept if row.range is None or row.range.refusal(kept) is None else None


def keep_default(row, value):
    """Keeps what the user prefers a setting's value to be at first."""
    group = _group("/Defaults")
    for remove in (group.RemString, group.RemBool, group.RemFloat):
        remove(row.name)
    if value == own_default(row):
        return
    if row.type == CHOICE:
        group.SetString(row.name, value)
    elif row.type == BOOL:
        group.SetBool(row.name, value)
    else:
        group.SetFloat(row.name, value)


def set_defaults(operation):
    """Sets what the user prefers of an operation that was made in the window. What the job's
    SetupSheet has set differs from the settings' own values, and stays.
    """
    own = {row.name for row in operation.Proxy.settings}
    for row in ROWS:
        kept = default_of(row)
        if kept is not None and row.name in own and row.of(operation) == own_default(row):
            setattr(operation, row.name, kept)
