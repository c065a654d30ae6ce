"""What docks have in common that show one of several measures as colours in the 3D view."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload.gui import manual
from evenload.gui.stability_layout import button
from evenload.gui.told import Told

_translate = FreeCAD.Qt.translate

BAR = 100  # steps of the progress bar, whose drawing takes as long as some work
# Of a table of figures: what it is, the value.
ROW = '<tr><td style="padding-right: 12px">%s</td><td align="right">%s</td></tr>'


class MeasureDock(manual.Dock):
    """The choice of the measure, its legend, the progress of its simulation and what is told of it.

    view: whose methods `cancel` and `fly` the widgets call.
    """

    def __init__(self, view, name, title, page, legend):
        """name: the widget's; title: shown; page: of the manual; legend: a Legend."""
        window = FreeCADGui.getMainWindow()
        super().__init__(title, window)
        self.setObjectName(name)
        self.set_page(page)
        self.choice, self.legend, self.told = QtGui.QComboBox(), legend, Told()
        self._chosen = None  # the key of the measure, also while there is none to choose from
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, BAR)
        self.cancel = button("Cancel", "Stops the simulation; what is known stays", view.cancel)
        self.fly = button("Fly to the worst", "Shows the place with the largest value", view.fly)

    def lay_out(self, shown):
        """Puts the choice and the legend above the widgets that show the rest, and the progress
        below them.
        """
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        for widget in (self.choice, self.legend, *shown, self.bar, self.cancel, self.told):
            column.addWidget(widget)
        column.addStretch(1)
        self.setWidget(content)
        FreeCADGui.getMainWindow().addDockWidget(QtCore.Qt.RightDockWidgetArea, self)

    def tell(self, text, colour=None):
        """Shows sentences, or hides those before where there are none."""
        self.told.tell(text, colour)

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        for widget in (self.bar, self.cancel):
            widget.setVisible(share is not None)
        self.bar.setValue(round(BAR * (share or 0.0)))

    def list_measures(self, measures):
        """Lists what can be shown; what was chosen stays so. Tells nobody."""
        self._chosen = self.choice.currentData() or self._chosen
        blocked = self.choice.blockSignals(True)
        self.choice.clear()
        for each in measures:
            self.choice.addItem(_translate("EvenLoad", each.title), each.key)
        self.choice.setCurrentIndex(max(0, self.choice.findData(self._chosen)))
        self.choice.blockSignals(blocked)


def table_of(rows):
    """[(what, value), ...], translated already, as rich text."""
    return "<table>%s</table>" % "".join(ROW % row for row in rows)
