"""The widgets of the dock Show Load."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui.load_legend import Legend
from evenload.gui.measure_dock import MeasureDock

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadLoadView"


class LoadDock(MeasureDock):
    """view: whose methods the widgets call, a LoadView."""

    def __init__(self, view, label):
        title = _translate("EvenLoad", "Load of %s") % label
        super().__init__(view, NAME, title, "load_view", Legend())
        self.slider, self.values = QtGui.QSlider(QtCore.Qt.Horizontal), QtGui.QLabel()
        self.slider.setToolTip(_translate("EvenLoad", "Moves the tool along the path"))
        self.values.setTextFormat(QtCore.Qt.RichText)
        self.lay_out([self.slider, self.values, self.fly])

    def show_path(self, measures, size):
        """Lists what a path of `size` samples can be coloured by; no measures: there is no path."""
        self.list_measures(measures)
        for widget in (self.choice, self.slider, self.fly):
            widget.setEnabled(bool(measures))
        self.slider.setRange(0, max(0, size - 1))
        self.legend.setVisible(bool(measures))
        self.values.setVisible(bool(measures))
