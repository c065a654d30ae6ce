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
        super().__init__(view, NAME, "", "load_view", Legend())
        self.name(label)
        told = _translate("EvenLoad", "Stops the simulation; colours come with the next path")
        self.cancel.setToolTip(told)
        self.slider, self.values = QtGui.QSlider(QtCore.Qt.Horizontal), QtGui.QLabel()
        self.slider.setToolTip(_translate("EvenLoad", "Moves the tool along the path"))
        self.values.setTextFormat(QtCore.Qt.RichText)
        self.lay_out([self.slider, self.values, self.fly])

    def name(self, label):
        """Tells in its title whose load it shows."""
        self.setWindowTitle(_translate("EvenLoad", "Load of %s") % label)

    def show_path(self, measures, size):
        """Lists what a path of `size` samples can be coloured by; no measures: there is no path."""
        self.list_measures(measures)
        # What cannot be used keeps its place, so that the dock keeps its width.
        for widget in (self.choice, self.legend, self.slider, self.values, self.fly):
            widget.setEnabled(bool(measures))
        self.slider.setRange(0, max(0, size - 1))
