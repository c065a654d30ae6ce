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


def is_rounded(kind):
    """Whether the fields of a kind of quantity are such ones now."""
    is_coarse = fields.decimals() < DECIMALS
    return kind in (LENGTH, POINT) and is_coarse and fields.shows_decimal_inches()


def _coarse():
    """mm: a step that FreeCAD's decimals show, and that no rounding is taken for."""
    return INCH * 10 ** (1 - fields.decimals())


class RoundedLength:
    """One of FreeCAD's fields for lengths, and what was done in it since it was shown; mm.

    Its arrows, keys and wheel add steps that FreeCAD's decimals can show: how many of them is what
    they say, each is STEP. What is typed counts as it is typed, before FreeCAD rounds it.
    """

    def __init__(self, box, limits, evaluate):
        """limits: a Range, or None; evaluate: what an expression that is typed comes to."""
        self._box, self._edit, self._evaluate = box, fields.edit_of(box), evaluate
        low, high = (limits.low, limits.high) if limits is not None else (None, None)
        self._least = -math.inf if low is None else float(low)
        self._most = math.inf if high is None else float(high)
        self._shown, self._typed = 0.0, None  # what FreeCAD's field holds; a length

    def show(self, length, is_rounded_now):
        """To be called when FreeCAD has written a length into the field."""
        self._shown, self._typed = self._box.property("rawValue"), None
        beyond = BEYOND if is_rounded_now else 0.0
        for name, limit, sign in (("minimum", self._least, -1), ("maximum", self._most, 1)):
            if math.isfinite(limit):
                self._box.setProperty(name, limit + sign * beyond)
        if is_rounded_now:
            self._box.setProperty("singleStep", _coarse() / INCH)
            self._write(length)

    def look(self, length):
        """To be called when its text is another: one that is being typed, or FreeCAD's. length:
        what was shown.
        """
        if self._edit.isModified():
            typed = _length_in(self._edit.text(), self._evaluate)
            is_one = typed is not None and self._least <= typed <= self._most
            self._typed = typed if is_one else None
            self._shown = self._box.property("rawValue") if typed is None else typed
            return
        # A thousandth would be nothing in what FreeCAD has written. What it has not written from
        # this length is stepped.
        length = length if self._typed is None else self._typed
        if self._edit.text() == FreeCAD.Units.Quantity(length, FreeCAD.Units.Length).UserString:
            self._write(length)

    @property
    def is_edited(self):
        """Whether something was typed or stepped since it was shown."""
        return self._typed is not None or self._steps != 0

    def edited(self, length):
        """What a length becomes by what was typed and stepped. One that was not edited stays, also
        beyond the limits.
        """
        if not self.is_edited:
            return length
        if self._typed is not None:
            length = self._typed
        return min(max(length + self._steps * STEP, self._least), self._most)

    @property
    def _steps(self):
        return round((self._box.property("rawValue") - self._shown) / _coarse())

    def _write(self, length):
        locale = QtCore.QLocale()
        locale.setNumberOptions(QtCore.QLocale.OmitGroupSeparator)
        blocked = self._edit.blockSignals(True)  # the value stays
        self._edit.setText(locale.toString(length / INCH, "f", DECIMALS) + " in")
        self._edit.blockSignals(blocked)


def _length_in(text, evaluate):
    """The length in a text, mm, where a bare number is inches; None where there is none. An
    expression has at least one digit: a unit that was left alone is none.
    """
    if not any(map(str.isdigit, text)):
        return None
    try:
        found = evaluate(text.replace(",", "."))
    except (ArithmeticError, RuntimeError, ValueError):  # it cannot be read, or not yet
        return None
    if isinstance(found, (int, float)):
        return found * INCH
    is_length = getattr(found, "Unit", None) == FreeCAD.Units.Length
    return found.Value if is_length else None
