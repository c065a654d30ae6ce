"""Folded parts of panels, which stay as the user left them."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import fields, preferences
from evenload.gui.slots import telling_slot
from evenload.settings.setting import LENGTH

KEPT_IN = preferences.KEPT_IN + "/Panels"


class Fold(QtGui.QWidget):
    """A heading that shows and hides what is below it; at first it is hidden."""

    def __init__(self, name, title):
        """name: under which its state is kept, the same for all panels."""
        super().__init__()
        self._name = name
        self._heading = QtGui.QToolButton()
        self._heading.setText(title)
        self._heading.setCheckable(True)
        self._heading.setAutoRaise(True)
        self._heading.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self._heading.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        font = self._heading.font()
        font.setBold(True)
        self._heading.setFont(font)
        self.body = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._heading)
        layout.addWidget(self.body)
        is_open = FreeCAD.ParamGet(KEPT_IN).GetBool(name, False)
        self._heading.setChecked(is_open)
        self._show(is_open)
        self._heading.toggled.connect(telling_slot(self._toggled))

    def is_open(self):
        return self._heading.isChecked()

    def unfold(self):
        self._heading.setChecked(True)

    def _toggled(self, is_open):
        FreeCAD.ParamGet(KEPT_IN).SetBool(self._name, is_open)
        self._show(is_open)

    def _show(self, is_open):
        self._heading.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)
        self.body.setVisible(is_open)


def form_in(widget, entries):
    """Lays out rows in a widget, as all panels have them, so that they fit into FreeCAD's narrow
    dock: a field that has no room beside the others' labels stands below its own.

    entries: (label, field) each, or (None, field) for a field that has its label in itself.
    """
    rows = QtGui.QFormLayout(widget)
    rows.setContentsMargins(4, 0, 0, 4)
    rows.setHorizontalSpacing(fields.SPACING)
    rows.setVerticalSpacing(3)
    rows.setRowWrapPolicy(QtGui.QFormLayout.DontWrapRows)
    rows.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    room = fields.ROOM - fields.SPACING
    shortest = fields.needed_by(LENGTH, widget)  # whose labels are to stand beside it
    widths = [label.sizeHint().width() for label, _ in entries if label is not None]
    column = max((width for width in widths if width <= room - shortest), default=0)
    for label, field in entries:
        if label is None:
            rows.addRow(field)
        elif label.sizeHint().width() > column or fields.narrowest(field) > room - column:
            rows.addRow(label)
            rows.addRow(field)
        else:
            rows.addRow(label, field)
    return rows
