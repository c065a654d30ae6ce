"""Settings and results as properties of FreeCAD's document objects."""

import FreeCAD

from evenload.settings.setting import ANGLE, BOOL, CHOICE, GROUP, LENGTH

OUTPUT = 8  # FreeCAD's property attribute for results
UNITS = {ANGLE: FreeCAD.Units.Angle, LENGTH: FreeCAD.Units.Length}


def add(obj, row):
    """Gives a document object the property of a row, with its default, unless it has it; then only
    the choices are brought up to date.
    """
    if hasattr(obj, row.name):
        if row.type == CHOICE:
            _renew_choices(obj, row)
        return
    # Results are outputs: they change without making the document's other objects out of date.
    attribute = 0 if row.group == GROUP else OUTPUT
    obj.addProperty(row.type, row.name, row.group, row.doc, attribute)
    if row.value is not None:
        setattr(obj, row.name, row.value)


def _renew_choices(obj, row):
    value = getattr(obj, row.name)
    # A choice that is no longer there stays, to be refused.
    setattr(obj, row.name, row.value if value in row.value else [*row.value, value])
    setattr(obj, row.name, value)


def add_to_prototype(obj, row):
    """The same for FreeCAD's stand-in for an operation, which the SetupSheet asks."""
    obj.addProperty(row.type, row.name, row.group, row.doc)
    unit = UNITS.get(row.type)
    value = row.value if unit is None else FreeCAD.Units.Quantity(row.value, unit)
    setattr(obj, row.name, value)
    if row.type == CHOICE:  # so far it only has its choices
        setattr(obj, row.name, row.value[0])
    if row.type == BOOL:
        obj.getProperty(row.name).valueFromString = _is_yes


def _is_yes(text):
    """What a job's template says of a yes or no; FreeCAD itself takes every text for a yes."""
    return text.strip().lower() in ("true", "1")


def is_ours(obj):
    """Whether a document object is one of our operations that clear floors; all of ours have a
    FormatVersion.
    """
    return hasattr(obj, "FormatVersion") and hasattr(obj, "SideStep")
