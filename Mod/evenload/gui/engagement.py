"""The width of the cut: engagement angle, side step and share of the diameter, which are one."""

import FreeCAD
from PySide import QtGui

from evenload import tool as tools
from evenload.gui import fields
from evenload.gui.cut_drawing import CutDrawing
from evenload.operations.following import ANGLE, STEP, bound

SHARES = 0.1, 99.9  # percent

_translate = FreeCAD.Qt.translate


class EngagementRow(QtGui.QWidget):
    """The engagement angle and, as `share`, the side step in percent of the diameter, which has no
    property, beside a drawing of the cut.
    """

    def __init__(self, label, field):
        """Those of the engagement angle."""
        super().__init__()
        self.share = QtGui.QDoubleSpinBox()
        self.share.setDecimals(1)
        self.share.setRange(*SHARES)
        self.share.setSuffix(" %")
        self.share.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)  # no room in a narrow dock
        widest = self.share.textFromValue(SHARES[1]) + self.share.suffix()
        self.share.setMinimumWidth(fields.width_of(self.share, widest) + fields.FRAME)
        self.share.setToolTip(_translate("EvenLoad", "The side step as a share of the diameter"))
        self._drawing = CutDrawing()
        row = QtGui.QGridLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setHorizontalSpacing(fields.SPACING)
        row.setVerticalSpacing(2)
        row.setColumnStretch(1, 1)
        row.addWidget(self._drawing, 0, 0, 2, 1)
        row.addWidget(label, 0, 1, 1, 2)
        row.addWidget(field, 1, 1)
        row.addWidget(self.share, 1, 2)

    def show_cut(self, obj):
        """Shows the share and the drawing of an operation."""
        diameter = tools.diameter(obj.ToolController)
        if diameter > 0:
            blocked = self.share.blockSignals(True)
            self.share.setValue(100 * obj.SideStep.Value / diameter)
            self.share.blockSignals(blocked)
        self.share.setEnabled(diameter > 0 and not {ANGLE, STEP} & bound(obj))
        self._drawing.show_cut(obj.EngagementAngle.Value, obj.CutMode == "Climb")

    def take_share(self, obj):
        """Takes the share into the side step, which the angle follows; tells whether it differs."""
        diameter = tools.diameter(obj.ToolController)
        if not diameter > 0:  # the tool is gone since
            return False
        step = self.share.value() / 100 * diameter
        before = 100 * obj.SideStep.Value / diameter
        if round(before, self.share.decimals()) == self.share.value():
            return False  # what is shown is rounded
        obj.SideStep = step
        return True
