"""The choice of a machine profile."""

import os

import FreeCAD
from PySide import QtCore, QtGui

from evenload import machines
from evenload.gui import fields
from evenload.gui.slots import slot

FILE = "\0file"  # another one, which is asked for

_translate = FreeCAD.Qt.translate


class MachineBox(QtGui.QComboBox):
    """A list of machine profiles, whose last entry asks for a file. `taken` is told after that."""

    taken = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._file = ""
        self.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.addItem(_translate("EvenLoad", "None: programmed feeds"), None)
        for name in machines.names():
            self.addItem(name, name)
        self.addItem(_translate("EvenLoad", "File…"), FILE)
        fields.make_room_for_choices(self)
        self.activated.connect(slot(self._ask))

    def machine(self):
        """The name or file of the machine; None without one, '' while its file is asked for."""
        chosen = self.itemData(self.currentIndex())
        return self._file if chosen == FILE else chosen

    def show_machine(self, machine):
        """Shows a name, a file or None, and tells nobody."""
        blocked = self.blockSignals(True)
        index = self.findData(machine)
        if index < 0:
            self._take_file(machine)
            index = self.findData(FILE)
        self.setCurrentIndex(index)
        self.blockSignals(blocked)

    def _ask(self):
        if self.itemData(self.currentIndex()) != FILE:
            return
        title = _translate("EvenLoad", "Open Machine Profile")
        path, _ = QtGui.QFileDialog.getOpenFileName(self, title, self._file, "JSON (*.json)")
        if path:
            self._take_file(path)
        else:
            self.show_machine(None)
        self.taken.emit()

    def _take_file(self, path):
        self._file = path
        self.setItemText(self.findData(FILE), os.path.basename(path))
