"""The widgets of the dock Show Surface."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui.load_legend import Legend
from evenload.gui.measure_dock import MeasureDock, table_of
from evenload.gui.stability_layout import button
from evenload.gui.surface_measures import BARE

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadSurfaceDock"


class SurfaceLegend(Legend):
    """The scale of what faces are coloured by, and the colour of what is not cut."""

    has_bare = False

    def swatches(self):
        return [(BARE, _translate("EvenLoad", "not cut"))] if self.has_bare else []


class SurfaceDock(MeasureDock):
    """view: whose methods the widgets call, a SurfaceView."""

    def __init__(self, view, label):
        title = _translate("EvenLoad", "Surface of %s") % label
        super().__init__(view, NAME, title, "surface_view", SurfaceLegend())
        self.figures = QtGui.QLabel()
        self.figures.setTextFormat(QtCore.Qt.RichText)
        self.picture = button("Picture…", "Writes what the faces are coloured by", view.save)
        self.lay_out([self.figures, self.fly, self.picture])

    def show_figures(self, rows):
        """Shows [(what, value), ...], translated already."""
        self.figures.setText(table_of(rows))

    def show_scale(self, measure, largest, has_bare):
        """Shows the scale of a SurfaceMeasure up to a value in mm or as a share, None: none."""
        self.legend.has_bare = has_bare
        self.legend.setVisible(measure is not None)
        if measure is not None:
            self.legend.show_scale(measure.on_legend, 0.0, largest, None)
