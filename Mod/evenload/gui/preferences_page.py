"""The page EvenLoad of FreeCAD's preferences."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import fields, load_colours, manual, preferences
from evenload.gui.length_box import SettingBox
from evenload.gui.machine_box import MachineBox
from evenload.settings.setting import ANGLE, BOOL, LENGTH

BAR = 72, 12  # pixels of a scale's picture
MOST = 1e4  # mm

_translate = FreeCAD.Qt.translate


class PageWidgets:
    """The page's widgets: `form` is all of them, `defaults` those of settings by their names."""

    def __init__(self):
        self.form = manual.Widget()
        self.form.set_page("preferences")
        # FreeCAD's dialog shows this as the page's name.
        self.form.setWindowTitle(_translate("EvenLoad", "General"))
        self._shown = {}  # values of settings as they were shown, rounded
        self.defaults = {row.name: _field_of(row) for row in preferences.ROWS}
        self.live = QtGui.QCheckBox(_translate("EvenLoad", "Live preview"))
        self.live.setToolTip(
            _translate("EvenLoad", "Shows the path in the 3D view while values change")
        )
        self.scale, self.machine = fields.combo_box(), MachineBox()
        self.scale.setIconSize(QtCore.QSize(*BAR))
        self.scale.setToolTip(_translate("EvenLoad", "From the least value to the largest"))
        self.machine.setToolTip(_translate("EvenLoad", "Windows that tell times begin with it"))
        for name in load_colours.names():
            self.scale.addItem(_picture(name), _translate("EvenLoad", name), name)
        column = QtGui.QVBoxLayout(self.form)
        column.addWidget(self._operations())
        column.addWidget(self._windows())
        column.addStretch(1)

    def show(self):
        """Shows what is kept."""
        for row in preferences.ROWS:
            kept = preferences.default_of(row)
            self._show(row, preferences.own_default(row) if kept is None else kept)
            self._shown[row.name] = self._value(row)
        self.live.setChecked(preferences.live_preview())
        self.scale.setCurrentIndex(self.scale.findData(preferences.scale()))
        self.machine.show_machine(preferences.machine())

    def keep(self):
        """Keeps what was changed since it was shown: what is shown may be rounded."""
        for row in preferences.ROWS:
            value = self._value(row)
            if value != self._shown[row.name]:
                preferences.keep_default(row, value)
                self._shown[row.name] = value
        preferences.keep_live_preview(self.live.isChecked())
        preferences.keep_scale(self.scale.itemData(self.scale.currentIndex()))
        preferences.keep_machine(self.machine.machine())

    def _operations(self):
        box = QtGui.QGroupBox(_translate("EvenLoad", "New operations begin with"))
        box.setToolTip(
            _translate(
                "EvenLoad",
                "In the window; the setup sheet of a job comes first. Macros and job files begin "
                "with the same values for everyone",
            )
        )
        rows = QtGui.QFormLayout(box)
        for row in preferences.ROWS:
            widget = self.defaults[row.name]
            widget.setToolTip(_translate("EvenLoad", row.doc))
            if row.type == BOOL:
                rows.addRow(widget)
            else:
                rows.addRow(_translate("EvenLoad", row.label), widget)
        return box

    def _windows(self):
        box = QtGui.QGroupBox(_translate("EvenLoad", "Windows"))
        rows = QtGui.QFormLayout(box)
        rows.addRow(self.live)
        rows.addRow(_translate("EvenLoad", "Colours of values"), self.scale)
        rows.addRow(_translate("EvenLoad", "Machine"), self.machine)
        return box

    def _show(self, row, value):
        widget = self.defaults[row.name]
        if row.is_fine:
            widget.show_units()
            widget.set_mm(value)
        elif row.type == LENGTH:
            widget.set_mm(value)
            widget.follow_units()
        elif row.type == ANGLE:
            widget.setProperty("unit", "deg")
            widget.setProperty("rawValue", float(value))
            fields.set_step(widget, row.type)
        else:
            fields.show(widget, value)

    def _value(self, row):
        widget = self.defaults[row.name]
        if row.type == ANGLE:
            return float(widget.property("rawValue"))
        if row.type == LENGTH:
            widget.interpretText()  # what is still being typed
        return fields.value_of(widget)


def _field_of(row):
    """The field of a setting. FreeCAD's own would round thousandths of an inch away."""
    if row.type == LENGTH and not row.is_fine:
        return SettingBox(MOST, least=row.range.low)
    return fields.widget_of(row)


def _picture(name):
    """The colours of a scale beside each other."""
    width, height = BAR
    picture = QtGui.QPixmap(width, height)
    painter = QtGui.QPainter(picture)
    colours = load_colours.on_scale([(k + 0.5) / width for k in range(width)], name)
    for k, colour in enumerate(colours):
        painter.fillRect(k, 0, 1, height, QtGui.QColor.fromRgbF(*map(float, colour)))
    painter.end()
    return QtGui.QIcon(picture)
