"""Lengths in FreeCAD's fields while these show inches with few decimals, two by default: they round
away the thousandths that machinists type and step by.
"""

import math

import FreeCAD
from PySide import QtCore

from evenload.gui import fields
from evenload.settings.setting import LENGTH, POINT
from evenload.units import INCH

DECIMALS = 4
STEP = fields.STEPS[LENGTH][True]  # mm
BEYOND = 1e6  # mm past the limits, where FreeCAD's field would not step on
NO_UNIT = FreeCAD.Units.Unit()


def is_rounded(kind):
    """Whether the fields of a kind of quantity are such ones now."""
    return kind in (LENGTH, POINT) and fields.shows_decimal_inches() and _decimals() < DECIMALS


def _decimals():
    return FreeCAD.ParamGet(fields.UNITS).GetInt("Decimals", 2)


def _coarse():
    """mm: a step that FreeCAD's decimals show, and that no rounding is taken for."""
    return INCH * 10 ** (1 - _decimals())


class RoundedLength:
    """One of FreeCAD's fields for lengths, and the length in mm that it stands for.

    Its arrows, keys and wheel add steps that FreeCAD's decimals can show: how many of them is what
    they say, each is STEP. What is typed counts as it is typed, before FreeCAD rounds it.
    """

    def __init__(self, box, limits):
        """limits: a Range, or None."""
        self._box, self._edit = box, fields.edit_of(box)
        low, high = (limits.low, limits.high) if limits is not None else (None, None)
        self._least = -math.inf if low is None else float(low)
        self._most = math.inf if high is None else float(high)
        # mm: what FreeCAD's field holds, what that stands for, and what it stood for when shown.
        self._shown = self._value = self._before = 0.0

    def show(self, value, is_rounded_now):
        """From now on the field, into which FreeCAD has written a length in mm, stands for it."""
        self._shown, self._value, self._before = self._box.property("rawValue"), value, value
        beyond = BEYOND if is_rounded_now else 0.0
        for name, limit, sign in (("minimum", self._least, -1), ("maximum", self._most, 1)):
            if math.isfinite(limit):
                self._box.setProperty(name, limit + sign * beyond)
        if is_rounded_now:
            self._box.setProperty("singleStep", _coarse() / INCH)
            self._write()

    def look(self):
        """To be called when its text is another: one that is being typed, or FreeCAD's."""
        if not self._edit.isModified():
            # A thousandth would be nothing in what FreeCAD has written. What it has not written
            # from this length is stepped.
            quantity = FreeCAD.Units.Quantity(self._value, FreeCAD.Units.Length)
            if self._edit.text() == quantity.UserString:
                self._write()
            return
        typed = _length_in(self._edit.text())
        is_one = typed is not None and self._least <= typed <= self._most
        self._shown = self._box.property("rawValue") if typed is None else typed
        self._value = typed if is_one else self._before

    @property
    def steps(self):
        """How many steps were added since it was shown or typed in."""
        return round((self._box.property("rawValue") - self._shown) / _coarse())

    def value(self):
        """mm: what was shown or typed, and the steps."""
        return min(max(self._value + self.steps * STEP, self._least), self._most)

    def _write(self):
        locale = QtCore.QLocale()
        locale.setNumberOptions(QtCore.QLocale.OmitGroupSeparator)
        blocked = self._edit.blockSignals(True)  # the value stays
        self._edit.setText(locale.toString(self._value / INCH, "f", DECIMALS) + " in")
        self._edit.blockSignals(blocked)


def _length_in(text):
    """The length in a text, mm, where a bare number is inches; None where there is none."""
    try:
        found = FreeCAD.Units.Quantity(text.replace(",", "."))
    except ValueError:
        return None
    if found.Unit == FreeCAD.Units.Length:
        return found.Value
    is_bare = found.Unit == NO_UNIT and any(map(str.isdigit, text))
    return found.Value * INCH if is_bare else None
