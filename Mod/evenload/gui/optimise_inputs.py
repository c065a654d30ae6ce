"""What the dock Optimise asks for: machine and limits, the tool, what to try."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import materials
from evenload.gui import fields, preferences
from evenload.gui.length_box import FineLengthBox, LengthBox
from evenload.gui.machine_box import MachineBox
from evenload.gui.slots import slot
from evenload.gui.stability_inputs import Rows, combo, number
from evenload.optimisation import inputs
from evenload.suggestion import search

_translate = FreeCAD.Qt.translate

KEPT_IN = preferences.KEPT_IN + "/Optimise"
MOST_LEVELS, MOST_TEETH = 12, 40
MOST_ANGLE = 180.0  # degrees, which itself is too much
KEPT = ("max_force", "max_torque", "max_power")


class SurfaceSpeedBox(LengthBox):
    """The same for surface speeds: what they call mm are m/min."""

    names, factors = ("m/min", "ft/min"), (1.0, 0.3048)
    digits, steps = (1, 1), (5.0, 15 * 0.3048)


def limits_box():
    """What machine and workpiece allow."""
    group = FreeCAD.ParamGet(KEPT_IN)
    none = _translate("EvenLoad", "none")
    rows = Rows(
        _translate("EvenLoad", "Limits"),
        (
            (
                "machine",
                _translate("EvenLoad", "Machine"),
                _translate("EvenLoad", "Its times, largest feed and spindle"),
                MachineBox(),
            ),
            (
                "material",
                _translate("EvenLoad", "Material"),
                _translate("EvenLoad", "Its force coefficients"),
                combo((name, name) for name in materials.names()),
            ),
            (
                "max_force",
                _translate("EvenLoad", "Force"),
                _translate("EvenLoad", "Largest cutting force that tool and clamping stand"),
                number(0, 1e6, 0, 10, "N", none),
            ),
            (
                "max_torque",
                _translate("EvenLoad", "Torque"),
                _translate("EvenLoad", "Largest torque; the machine's own holds besides"),
                number(0, 1e5, 2, 0.1, "N m", none),
            ),
            (
                "max_power",
                _translate("EvenLoad", "Power"),
                _translate("EvenLoad", "Largest power; the machine's own holds besides"),
                number(0, 1e6, 0, 50, "W", none),
            ),
        ),
    )
    rows.show_values(**{name: group.GetFloat(name, 0.0) for name in KEPT})
    return rows


def tool_box():
    """What the tool stands; named as search.Asked has it."""
    teeth = QtGui.QSpinBox()
    teeth.setRange(1, MOST_TEETH)
    return Rows(
        _translate("EvenLoad", "Tool"),
        (
            (
                "max_chip_thickness",
                _translate("EvenLoad", "Chip thickness"),
                _translate("EvenLoad", "The largest that its edges stand"),
                FineLengthBox(fields.FINE_MOST, least=1e-4),
            ),
            (
                "least_speed",
                _translate("EvenLoad", "Surface speed from"),
                _translate("EvenLoad", "The least of the tool in this material"),
                SurfaceSpeedBox(1e4, least=0.1),
            ),
            (
                "most_speed",
                _translate("EvenLoad", "to"),
                _translate("EvenLoad", "The largest of the tool in this material"),
                SurfaceSpeedBox(1e4, least=0.1),
            ),
            (
                "cutting_length",
                _translate("EvenLoad", "Cutting length"),
                _translate("EvenLoad", "No level is deeper"),
                LengthBox(1e3, least=0.01),
            ),
            (
                "teeth",
                _translate("EvenLoad", "Teeth"),
                _translate("EvenLoad", "How many cutting edges it has around"),
                teeth,
            ),
        ),
    )


class TryBox(QtGui.QGroupBox):
    """The angles and numbers of levels to try; `changed` is told when they are others."""

    changed = QtCore.Signal()

    def __init__(self):
        super().__init__(_translate("EvenLoad", "To try"))
        group = FreeCAD.ParamGet(KEPT_IN)
        self.angles = QtGui.QLineEdit(group.GetString("angles", _listed(search.ANGLES)))
        self.angles.setToolTip(_translate("EvenLoad", "Engagement angles in degrees"))
        self.levels = QtGui.QSpinBox()
        self.levels.setRange(1, MOST_LEVELS)
        self.levels.setValue(group.GetInt("levels", inputs.LEVELS))
        self.levels.setToolTip(
            _translate("EvenLoad", "How many numbers of levels, from the fewest possible on")
        )
        self.keeps_angle = QtGui.QCheckBox(_translate("EvenLoad", "Keep the angle"))
        self.keeps_depth = QtGui.QCheckBox(_translate("EvenLoad", "Keep the step down"))
        for box, name in ((self.keeps_angle, "keeps_angle"), (self.keeps_depth, "keeps_depth")):
            box.setToolTip(_translate("EvenLoad", "Fewer paths are computed, which is quicker"))
            box.setChecked(group.GetBool(name, False))
            box.toggled.connect(slot(self._tell))
        layout = QtGui.QFormLayout(self)
        layout.addRow(_translate("EvenLoad", "Angles, °"), self.angles)
        layout.addRow(self.keeps_angle)
        layout.addRow(_translate("EvenLoad", "Numbers of levels"), self.levels)
        layout.addRow(self.keeps_depth)
        self.angles.textEdited.connect(slot(self._tell))
        self.levels.valueChanged.connect(slot(self._tell))
        self._enable()

    def values(self):
        """Those of search.Asked. Raises ValueError with a sentence for angles that cannot be."""
        angles = fields.values_in(self.angles.text())
        if not self.keeps_angle.isChecked() and not (
            angles and all(0 < angle < MOST_ANGLE for angle in angles)
        ):
            raise ValueError(
                _translate("EvenLoad", "Angles are numbers between 0 and 180, as 45; 60; 75.")
            )
        return {
            "angles": tuple(dict.fromkeys(angles or search.ANGLES)),
            "levels": self.levels.value(),
            "keeps_angle": self.keeps_angle.isChecked(),
            "keeps_depth": self.keeps_depth.isChecked(),
        }

    def keep(self):
        """Has the next dock begin with what is set here."""
        group = FreeCAD.ParamGet(KEPT_IN)
        group.SetString("angles", self.angles.text())
        group.SetInt("levels", self.levels.value())
        group.SetBool("keeps_angle", self.keeps_angle.isChecked())
        group.SetBool("keeps_depth", self.keeps_depth.isChecked())

    def _tell(self):
        self._enable()
        self.changed.emit()

    def _enable(self):
        self.angles.setEnabled(not self.keeps_angle.isChecked())
        self.levels.setEnabled(not self.keeps_depth.isChecked())


def keep_limits(rows):
    """Has the next dock begin with these forces, torques and powers."""
    group = FreeCAD.ParamGet(KEPT_IN)
    for name in KEPT:
        group.SetFloat(name, getattr(rows, name).value())


def tool_of(rows):
    """{name: value} of the tool as it is shown."""
    return {name: rows.value_of(name) for name in rows.names}


def _listed(numbers):
    return "; ".join("%g" % each for each in numbers)
