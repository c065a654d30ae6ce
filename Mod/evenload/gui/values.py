"""Values as docks and panels tell them."""

from PySide import QtCore


def told(quantity, value):
    """A value with its unit, both as the user has chosen."""
    unit = quantity.shown
    name = unit.name if unit.name == "°" else " " + unit.name
    locale = QtCore.QLocale()  # FreeCAD's: the decimal sign is the user's
    locale.setNumberOptions(QtCore.QLocale.OmitGroupSeparator)
    return locale.toString(float(value) / unit.size, "f", unit.digits) + name
