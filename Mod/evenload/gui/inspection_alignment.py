"""What a profile evaluation may move: the datum plane, and the motions that are left free."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import fields
from evenload.gui.inspection_rows import offer
from evenload.gui.slots import slot
from evenload.gui.stability_inputs import Rows, combo
from evenload.gui.stability_layout import button
from evenload.inspection.profiles import IN_DATUM, MOTIONS

_translate = FreeCAD.Qt.translate

NO_DATUM = ""
ALL, NONE, CHOSEN = "all", "none", "chosen"
FREE = (("All", ALL), ("None, as aligned", NONE), ("Chosen…", CHOSEN))
TIPS = {
    "tx": "Shift along x",
    "ty": "Shift along y",
    "tz": "Shift along z",
    "rx": "Turn about x",
    "ry": "Turn about y",
    "rz": "Turn about z",
}
IN_A_ROW = 3


class Alignment(Rows):
    """The rows of a profile's alignment. pick: called by the button that takes what is selected."""

    def __init__(self, pick):
        super().__init__(
            "Alignment",
            (
                ("datum", "Datum", "The plane in which the points were aligned", DatumBox(pick)),
                ("free", "Free motions", "That make the zone narrowest", combo(FREE)),
                ("motions", "", "", MotionBoxes()),
            ),
        )
        # A narrow dock has no room for the list and its button beside their label.
        self.layout().setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        # Before those who evaluate: with a datum nothing is free, as in Python and in job files.
        self.datum.chosen.connect(slot(self._datum_chosen))
        self.free.currentIndexChanged.connect(slot(self.show_motions))
        self.show_motions()

    def value(self):
        """(names of the free motions, name of the datum or NO_DATUM)."""
        may_be = IN_DATUM if self.datum.name() != NO_DATUM else MOTIONS
        free = self.free.currentData()
        if free == CHOSEN:
            may_be = [name for name in may_be if self.motions.boxes[name].isChecked()]
        return (() if free == NONE else tuple(may_be)), self.datum.name()

    def _datum_chosen(self):
        if self.datum.name() != NO_DATUM:
            self.show_values(free=NONE)
        self.show_motions()

    def show_motions(self):
        """Shows which motions may be free with the datum that is chosen."""
        self.motions.setVisible(self.free.currentData() == CHOSEN)
        self.motions.allow(IN_DATUM if self.datum.name() != NO_DATUM else MOTIONS)


class DatumBox(QtGui.QWidget):
    """A list of planes and a button that takes one from the 3D view."""

    chosen, valueChanged = QtCore.Signal(), QtCore.Signal()

    def __init__(self, pick):
        super().__init__()
        self.list = fields.combo_box()
        self.list.addItem(_translate("EvenLoad", "None"), NO_DATUM)
        self.pick = button("Pick", "Takes the plane face or datum plane that is selected", pick)
        # Buttons ask for more room than a short word needs.
        self.pick.setMinimumWidth(fields.width_of(self.pick, self.pick.text()) + fields.AROUND)
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.list, 1)
        row.addWidget(self.pick)
        self.list.currentIndexChanged.connect(slot(self._tell))

    def name(self):
        """The name of the plane, as offer() has it; NO_DATUM where none is chosen."""
        return self.list.currentData()

    def offer(self, planes):
        """Lists planes, [(text, name), ...]; what is chosen stays if it is among them, and nobody
        is told.
        """
        offer(self.list, planes)

    def choose(self, name):
        """Chooses a plane that is listed."""
        self.list.setCurrentIndex(self.list.findData(name))

    def _tell(self):
        self.chosen.emit()
        self.valueChanged.emit()


class MotionBoxes(QtGui.QWidget):
    """A box to be ticked for each motion: `boxes` by their names."""

    valueChanged = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.boxes = {}
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        for number, name in enumerate(MOTIONS):
            box = self.boxes[name] = QtGui.QCheckBox(name)
            box.setToolTip(_translate("EvenLoad", TIPS[name]))
            box.toggled.connect(slot(self._tell))
            grid.addWidget(box, number // IN_A_ROW, number % IN_A_ROW)

    def allow(self, names):
        """Leaves only these to be ticked; the others are fixed."""
        for name, box in self.boxes.items():
            box.setEnabled(name in names)

    def _tell(self):
        self.valueChanged.emit()
