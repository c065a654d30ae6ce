"""The widgets of the dock Show Surface."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload.gui import manual
from evenload.gui.load_legend import Legend
from evenload.gui.shaded import Shaded
from evenload.gui.stability_layout import button
from evenload.gui.surface_measures import BARE

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadSurfaceDock"
BAR = 100  # steps of the progress bar, whose drawing takes as long as some work
# Of the table of figures: what it is, the value.
ROW = '<tr><td style="padding-right: 12px">%s</td><td align="right">%s</td></tr>'


class SurfaceLegend(Legend):
    """The scale of what faces are coloured by, and the colour of what is not cut."""

    has_bare = False

    def swatches(self):
        return [(BARE, _translate("EvenLoad", "not cut"))] if self.has_bare else []


class SurfaceDock(manual.Dock):
    """view: whose methods the widgets call, a SurfaceView."""

    def __init__(self, view, label):
        window = FreeCADGui.getMainWindow()
        super().__init__(_translate("EvenLoad", "Surface of %s") % label, window)
        self.setObjectName(NAME)
        self.set_page("surface_view")
        self.choice = QtGui.QComboBox()
        self.legend = SurfaceLegend()
        self.figures, self.told = QtGui.QLabel(), Shaded()
        self.figures.setTextFormat(QtCore.Qt.RichText)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, BAR)
        self.cancel = button("Cancel", "Stops the simulation; what is known stays", view.cancel)
        self.fly = button("Fly to the worst", "Shows the place with the largest value", view.fly)
        self.picture = button("Picture…", "Writes what the faces are coloured by", view.save)
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        for widget in (self.choice, self.legend, self.figures, self.fly, self.picture):
            column.addWidget(widget)
        for widget in (self.bar, self.cancel, self.told):
            column.addWidget(widget)
        column.addStretch(1)
        self.setWidget(content)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, self)

    def tell(self, text, colour=None):
        """Shows a sentence, translated already; '' none."""
        self.told.setVisible(bool(text))
        self.told.tell(text, colour)

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        for widget in (self.bar, self.cancel):
            widget.setVisible(share is not None)
        self.bar.setValue(round(BAR * (share or 0.0)))

    def list_measures(self, measures):
        """Lists what can be shown; what was chosen stays so. Tells nobody."""
        before = self.choice.currentData()
        blocked = self.choice.blockSignals(True)
        self.choice.clear()
        for each in measures:
            self.choice.addItem(_translate("EvenLoad", each.title), each.key)
        self.choice.setCurrentIndex(max(0, self.choice.findData(before)))
        self.choice.blockSignals(blocked)

    def show_figures(self, rows):
        """Shows [(what, value), ...], translated already."""
        self.figures.setText("<table>%s</table>" % "".join(ROW % row for row in rows))

    def show_scale(self, measure, largest, has_bare):
        """Shows the scale of a SurfaceMeasure up to a value in mm or as a share, None: none."""
        self.legend.has_bare = has_bare
        self.legend.setVisible(measure is not None)
        if measure is not None:
            self.legend.show_scale(measure.on_legend, 0.0, largest / measure.unit.size, None)
