"""Fields for lengths in a dock, which stays while the user chooses other units."""

import FreeCAD
from PySide import QtCore

from evenload import units
from evenload.gui import fields
from evenload.gui.slots import slot
from evenload.settings.setting import LENGTH


class LengthBox(fields.FineBox):
    """A field whose values are mm, shown in the user's unit."""

    digits, steps = (3, 5), (0.5, 0.02 * fields.INCH)

    def __init__(self, most, value=0.0, least=0.0, unset=""):
        """All in mm; unset: shown in place of the least."""
        super().__init__(most)
        self._least = least
        self.setKeyboardTracking(False)
        if unset:
            self.setSpecialValueText(FreeCAD.Qt.translate("EvenLoad", unset))
        self.setMinimum(least / self._factor)
        self.set_mm(value)

    def set_mm(self, value):
        super().set_mm(value)
        # What was rounded to be shown is still what was set.
        self._set, self._shown = value, self.value()

    def mm(self):
        return self._set if self.value() == self._shown else super().mm()

    def rounded(self, length):
        """A length in mm as it would be shown."""
        return round(length / self._factor, self.decimals()) * self._factor

    def follow_units(self):
        """Shows its length in the units that the user has chosen by now; tells nobody."""
        length = self.mm()
        blocked = self.blockSignals(True)
        self.setMinimum(0)
        self.show_units()
        self.setMinimum(self._least / self._factor)
        self.set_mm(length)
        self.blockSignals(blocked)


class FineLengthBox(LengthBox):
    """The same for tolerances and feeds per tooth."""

    digits, steps = fields.FINE_DECIMALS, (0.005, 0.0002 * fields.INCH)


class SettingBox(LengthBox):
    """The same for lengths as operations have them."""

    digits, steps = (2, 4), fields.STEPS[LENGTH]


class RoughnessBox(LengthBox):
    """The same for roughness, in thousandths of a mm or millionths of an inch."""

    names, factors = units.ROUGHNESS.names, units.ROUGHNESS.sizes
    digits, steps = (2, 1), (1e-4, 4e-6 * fields.INCH)


class UnitsWatch:
    """Calls a method when the user has chosen other units, until end()."""

    def __init__(self, parent, changed):
        # FreeCAD stores what the user chose before it takes it.
        self._timer = QtCore.QTimer(parent)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(slot(changed))
        self._group = FreeCAD.ParamGet(fields.UNITS)
        self._group.Attach(self)

    def onChange(self, *_):
        """FreeCAD calls this with the group and the name of what was changed."""
        self._timer.start()

    def end(self):
        self._group.Detach(self)
