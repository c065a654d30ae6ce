"""The dialog that fits modes to a tap test: what its file does not tell, the fit over the data."""

import os

import FreeCAD
from PySide import QtCore, QtGui

from evenload.dynamics import Frf, pictures
from evenload.gui import colours
from evenload.gui.images import image_of
from evenload.gui.shaded import Shaded
from evenload.gui.slots import slot
from evenload.settings.sentences import shown

_translate = FreeCAD.Qt.translate

UNITS = ("m/N", "mm/N", "um/N", "uin/lbf", "(m/s)/N", "(m/s2)/N", "g/N")
FORMS = ("real-imaginary", "magnitude-phase")
AXES = ("xx", "yy")
AXIS_NAMES = ("along X", "along Y")
MOST_MODES = 8
SIZE = 860, 400  # pixels of the picture
DPI = 86
BAND = 1e5  # Hz: more than any tap test has


class TapTestDialog(QtGui.QDialog):
    """fitted: the ModalFit, None while there is none; frf: the Frf."""

    def __init__(self, path, parent=None):
        super().__init__(parent)
        self.path, self.frf, self.fitted = path, None, None
        self.setWindowTitle(_translate("EvenLoad", "Tap test") + " " + os.path.basename(path))
        self.axis = self._combo(zip(AXIS_NAMES, AXES))
        as_file = _translate("EvenLoad", "as in the file")
        self.unit = self._combo([(as_file, None), *((unit, unit) for unit in UNITS)])
        self.form = self._combo([(as_file, None), *((form, form) for form in FORMS)])
        self.modes = QtGui.QSpinBox()
        self.modes.setRange(1, MOST_MODES)
        self.lowest, self.highest = self._hertz(), self._hertz()
        self.picture = QtGui.QLabel()
        self.picture.setFixedSize(*SIZE)
        self.picture.setAlignment(QtCore.Qt.AlignCenter)
        self.told = Shaded()
        self.told.setFixedWidth(SIZE[0])
        buttons = QtGui.QDialogButtonBox(
            QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel, QtCore.Qt.Horizontal
        )
        self.ok = buttons.button(QtGui.QDialogButtonBox.Ok)
        self._lay_out(buttons)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        for box in (self.axis, self.unit, self.form):
            box.currentIndexChanged.connect(slot(self.fit))
        for box in (self.modes, self.lowest, self.highest):
            box.valueChanged.connect(slot(self.fit))
        self.fit()

    def _lay_out(self, buttons):
        grid = QtGui.QGridLayout()
        for place, (title, widget) in enumerate(
            (
                ("Hammer and sensor", self.axis),
                ("Unit", self.unit),
                ("Columns", self.form),
                ("Modes", self.modes),
                ("From", self.lowest),
                ("To", self.highest),
            )
        ):
            row, column = divmod(place, 3)
            grid.addWidget(QtGui.QLabel(_translate("EvenLoad", title)), row, 2 * column)
            grid.addWidget(widget, row, 2 * column + 1)
            grid.setColumnStretch(2 * column + 1, 1)
        layout = QtGui.QVBoxLayout(self)
        layout.addLayout(grid)
        layout.addWidget(self.picture)
        layout.addWidget(self.told)
        layout.addWidget(buttons)

    @staticmethod
    def _combo(rows):
        box = QtGui.QComboBox()
        for title, value in rows:
            box.addItem(_translate("EvenLoad", title), value)
        return box

    @staticmethod
    def _hertz():
        box = QtGui.QDoubleSpinBox()
        box.setRange(0, BAND)
        box.setDecimals(0)
        box.setSingleStep(50)
        box.setSuffix(" Hz")
        box.setSpecialValueText(_translate("EvenLoad", "all lines"))
        box.setKeyboardTracking(False)
        return box

    def fit(self):
        """Reads the file and fits modes anew, and shows both, or why that cannot be."""
        self.fitted = None
        try:
            self.frf = Frf.read(
                self.path,
                unit=self.unit.currentData(),
                axis=self.axis.currentData(),
                form=self.form.currentData(),
            )
            self.fitted = self.frf.fit(
                self.modes.value(), self.lowest.value() or None, self.highest.value() or None
            )
        except (ValueError, OSError) as error:
            self.picture.clear()
            self._tell(str(error), colours.BAD)
        else:
            self.picture.setPixmap(_pixmap_of(self.fitted))
            rows = [
                _translate("EvenLoad", "%.1f Hz, %.2f %% damping, %.3g N/µm")
                % (mode.frequency, 100 * mode.damping_ratio, mode.stiffness)
                for mode in self.fitted
            ]
            self._tell("\n".join(["; ".join(rows), *self.frf.notes]))
        self.ok.setEnabled(self.fitted is not None)

    def _tell(self, text, colour=None):
        self.told.tell(shown(text), colour)


def _pixmap_of(fitted):
    """The fit over the data."""
    figure = pictures.fit(fitted, None, title="")
    figure.set_size_inches(SIZE[0] / DPI, SIZE[1] / DPI)
    figure.set_dpi(DPI)
    return QtGui.QPixmap.fromImage(image_of(figure))
