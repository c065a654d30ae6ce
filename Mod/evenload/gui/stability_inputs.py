"""The numbers of the window Stability chart: the cut, the chart's ends, limits of the best."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import materials, units
from evenload.gui import fields
from evenload.gui.length_box import LengthBox
from evenload.gui.slots import slot

_translate = FreeCAD.Qt.translate

CUT_MODES = (("Climb", "climb"), ("Conventional", "conventional"))
NO_LIMIT = "no limit"
# Half of the last digit that the boxes show.
SHOWN = {"speed": 0.5, "depth": 5e-4, "engagement_deg": 0.05}


def differs(name, before, after):
    """Whether a value of a Cut is another than before, and not only rounded as it is shown."""
    return before != after if isinstance(after, str) else abs(before - after) > SHOWN[name]


def number(low, high, decimals, step, suffix, when_low=""):
    """A box for a number; `when_low` is shown in place of the least one."""
    box = QtGui.QDoubleSpinBox()
    box.setDecimals(decimals)
    box.setRange(low, high)
    box.setSingleStep(step)
    box.setSuffix(suffix and " " + _translate("EvenLoad", suffix))
    box.setKeyboardTracking(False)
    if when_low:
        box.setSpecialValueText(_translate("EvenLoad", when_low))
    return box


class Rows(QtGui.QGroupBox):
    """A box with a row for each value; `changed` is told when the user changes one."""

    changed = QtCore.Signal()

    def __init__(self, title, rows, parent=None):
        """rows: of (name, title, tooltip, widget); a widget is an attribute under its name."""
        super().__init__(_translate("EvenLoad", title), parent)
        self.names = [name for name, *_ in rows]
        layout = QtGui.QFormLayout(self)
        layout.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        for name, label, tip, widget in rows:
            setattr(self, name, widget)
            widget.setToolTip(_translate("EvenLoad", tip))
            layout.addRow(_translate("EvenLoad", label), widget)
            is_list = isinstance(widget, QtGui.QComboBox)
            signal = widget.currentIndexChanged if is_list else widget.valueChanged
            signal.connect(slot(self._tell))

    def _tell(self):
        self.changed.emit()

    def show_values(self, **values):
        """Shows values by their names, and tells nobody."""
        for name, value in values.items():
            widget = getattr(self, name)
            blocked = widget.blockSignals(True)
            if isinstance(widget, QtGui.QComboBox):
                widget.setCurrentIndex(widget.findData(value))
            elif isinstance(widget, LengthBox):
                widget.set_mm(value)
            else:
                widget.setValue(value)
            widget.blockSignals(blocked)

    def value_of(self, name):
        """The value of a row with a number, lengths in mm."""
        widget = getattr(self, name)
        return widget.mm() if isinstance(widget, LengthBox) else widget.value()

    def follow_units(self):
        """Shows lengths in the units that the user has chosen by now; tells nobody."""
        for name in self.names:
            if isinstance(getattr(self, name), LengthBox):
                getattr(self, name).follow_units()


class DepthBox(LengthBox):
    """A field for depths of a cut."""

    steps = 0.05, 0.002 * units.INCH


class ErrorBox(LengthBox):
    """A field for errors of a place, in thousandths of a mm or in inches."""

    names, factors = units.ERROR.names, units.ERROR.sizes
    digits, steps = (0, 5), (0.005, 0.0002 * units.INCH)


def combo(rows):
    """A list of (title, value)."""
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    for title, value in rows:
        box.addItem(_translate("EvenLoad", title), value)
    fields.make_room_for_choices(box)
    return box


def cut_box():
    """The cut that is judged: what a click into the chart chooses, and what the chart is of."""
    named = combo((name, name) for name in materials.names())
    return Rows(
        "Cut",
        (
            ("speed", "Spindle speed", "As a click into the chart sets it", _speed()),
            ("depth", "Step down", "As a click into the chart sets it", _depth()),
            ("cut_mode", "Cut mode", "The chart is that of this cut mode", combo(CUT_MODES)),
            (
                "engagement",
                "Engagement angle",
                "How much of the tool's side cuts",
                number(1, 180, 1, 1, "°"),
            ),
            ("material", "Material", "Its force coefficients", named),
            (
                "damping",
                "Process damping",
                "Of the tool's flank on the wall it has cut; some 100 kN/m, more with a worn edge",
                number(0, 5000, 0, 20, "kN/m", "none"),
            ),
        ),
    )


def chart_box():
    """The ends of the chart."""
    return Rows(
        "Chart",
        (
            ("from_speed", "From", "The chart's least spindle speed", _speed()),
            ("to_speed", "To", "The chart's largest spindle speed", _speed()),
            ("to_depth", "Down to", "The chart's largest depth", _depth()),
        ),
    )


def limits_box():
    """What the best cut has to keep."""
    return Rows(
        "Best cut",
        (
            (
                "margin",
                "Margin",
                "How far the largest multiplier stays below 1",
                number(0, 90, 0, 1, "%"),
            ),
            (
                "error",
                "Location error",
                "Largest error of the wall's place",
                ErrorBox(1.0, unset=NO_LIMIT),
            ),
            (
                "force",
                "Force",
                "Largest cutting force in the plane",
                number(0, 1e5, 0, 50, "N", NO_LIMIT),
            ),
        ),
    )


def _speed():
    return number(1, 200000, 0, 50, "rev/min")


def _depth():
    return DepthBox(500.0, least=0.001)
