"""The box with what vibrates at the tool's tip: a table of modes, files, tap tests."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.dynamics import Mode, vibration
from evenload.gui.slots import slot
from evenload.gui.stability_layout import button
from evenload.gui.stability_tap import TapTestDialog
from evenload.settings.sentences import shown

_translate = FreeCAD.Qt.translate

COLUMNS = ("At, °", "Hz", "Damping, %", "N/µm")
TIPS = (
    "Direction of the vibration, counter-clockwise from machine X",
    "Natural frequency",
    "Damping ratio",
    "Stiffness of the mode",
)
NEW = 10.0, 1000.0, 0.03, 0.0  # N/um, Hz, ratio, degrees of a mode that is added
WIDEST = 2  # of the columns
# Row, column, rows and columns of the buttons below the table.
PLACES = (0, 0, 1, 2), (0, 2, 1, 1), (0, 3, 1, 1), (1, 0, 1, 2), (1, 2, 1, 2)
ROWS = 3  # that show without scrolling
WRONG = QtGui.QColor(217, 48, 37, 50)  # over the ground of any theme


class ModesBox(QtGui.QGroupBox):
    """`changed` is told when the modes are others, which `modes` are then; `notes` are sentences on
    what is doubtful about them, `problem` is one on what cannot be, or empty.
    """

    changed = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(_translate("EvenLoad", "Vibration at the tool's tip"), parent)
        self.modes, self.notes, self.problem, self.name = [], [], "", ""
        self.table = QtGui.QTableWidget(0, len(COLUMNS))
        self.table.setHorizontalHeaderLabels([_translate("EvenLoad", c) for c in COLUMNS])
        for column, tip in enumerate(TIPS):
            self.table.horizontalHeaderItem(column).setToolTip(_translate("EvenLoad", tip))
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QtGui.QHeaderView.Stretch)
        header.setSectionResizeMode(WIDEST, QtGui.QHeaderView.ResizeToContents)
        self.table.verticalHeader().hide()
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        height = self.table.verticalHeader().defaultSectionSize()
        self.table.setFixedHeight(height * (ROWS + 1) + 6)
        self.table.itemChanged.connect(slot(self._edited))
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.table)
        grid = QtGui.QGridLayout()
        layout.addLayout(grid)
        for place, (title, tip, action) in enumerate(
            (
                ("Tap test...", "Fits modes to a measured frequency response", self._tap),
                ("Add", "Adds a mode", self._add),
                ("Remove", "Removes the selected modes", self._remove),
                ("Open...", "Reads modes from a file", self._open),
                ("Save...", "Writes the modes to a file, for other tools and jobs", self._save),
            )
        ):
            grid.addWidget(button(title, tip, action), *PLACES[place])

    def show_modes(self, modes, notes=(), name=""):
        """Shows modes, and tells nobody."""
        self.modes, self.notes, self.problem, self.name = list(modes), list(notes), "", name
        blocked = self.table.blockSignals(True)
        self.table.setRowCount(len(self.modes))
        for row, mode in enumerate(self.modes):
            numbers = mode.direction, mode.frequency, 100 * mode.damping_ratio, mode.stiffness
            for column, number in enumerate(numbers):
                item = QtGui.QTableWidgetItem("%.5g" % number)
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                self.table.setItem(row, column, item)
        self.table.blockSignals(blocked)

    def vibration(self):
        """The Vibration that is shown; None without a mode."""
        if not self.modes:
            return None
        name = self.name or _translate("EvenLoad", "From the window Stability chart")
        return vibration.Vibration(name, list(self.modes))

    def take(self, modes, notes=(), name=""):
        """Shows other modes, and tells of it."""
        self.show_modes(modes, notes, name)
        self.changed.emit()

    def take_tap_test(self, fitted, notes):
        """Modes that were fitted take the place of those along the same axes."""
        axes = {mode.direction for mode in fitted}
        kept = [mode for mode in self.modes if mode.direction not in axes]
        self.take([*kept, *fitted], notes, self.name)

    def _edited(self):
        modes, self.problem = [], ""
        blocked = self.table.blockSignals(True)
        for row in range(self.table.rowCount()):
            try:
                modes.append(self._mode_in(row))
            except ValueError as error:
                self.problem = self.problem or str(error)
            is_wrong = len(modes) <= row and self.problem
            for column in range(len(COLUMNS)):
                self.table.item(row, column).setBackground(WRONG if is_wrong else QtGui.QBrush())
        self.table.blockSignals(blocked)
        if not self.problem:
            self.modes = modes
        self.changed.emit()

    def _mode_in(self, row):
        numbers = []
        for column in range(len(COLUMNS)):
            text = self.table.item(row, column).text().replace(",", ".")
            try:
                numbers.append(float(text))
            except ValueError:
                raise ValueError(
                    _translate("EvenLoad", "Mode %d: '%s' is no number.") % (row + 1, text)
                ) from None
        direction, frequency, damping, stiffness = numbers
        try:
            return Mode.from_stiffness(stiffness, frequency, damping / 100, direction)
        except ValueError as error:
            told = _translate("EvenLoad", "Mode %d: %s") % (row + 1, shown(str(error)))
            raise ValueError(told) from None

    def _add(self):
        self.take([*self.modes, Mode.from_stiffness(*NEW)], self.notes, self.name)

    def _remove(self):
        rows = {index.row() for index in self.table.selectedIndexes()}
        self.take([m for k, m in enumerate(self.modes) if k not in rows], self.notes, self.name)

    def _open(self):
        path, _ = QtGui.QFileDialog.getOpenFileName(
            self, _translate("EvenLoad", "Open modes"), "", "JSON (*.json)"
        )
        if path:
            self.open_file(path)

    def open_file(self, path):
        try:
            found = vibration.load(path)
        except ValueError as error:
            self.problem = str(error)
            self.changed.emit()
            return
        self.take(found.modes, found.notes, found.name)

    def _save(self):
        path, _ = QtGui.QFileDialog.getSaveFileName(
            self, _translate("EvenLoad", "Save modes"), "", "JSON (*.json)"
        )
        found = self.vibration()
        if path and found:
            found.save(path if path.lower().endswith(".json") else path + ".json")

    def _tap(self):
        path, _ = QtGui.QFileDialog.getOpenFileName(
            self,
            _translate("EvenLoad", "Open a tap test"),
            "",
            _translate("EvenLoad", "Frequency responses (*.csv *.txt *.unv *.uff *.dat);;All (*)"),
        )
        if path:
            dialog = TapTestDialog(path, self)
            if dialog.exec_() == QtGui.QDialog.Accepted:
                self.take_tap_test(dialog.fitted, dialog.frf.notes)
            dialog.deleteLater()
