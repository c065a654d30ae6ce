"""The widgets of the window Simulation."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import materials, units
from evenload.gui import fields, manual
from evenload.gui.docks import add_below
from evenload.gui.fitted_column import FittedColumn
from evenload.gui.length_box import LengthBox
from evenload.gui.machine_box import MachineBox
from evenload.gui.shaded import Shaded
from evenload.gui.simulation_plot import PlotView
from evenload.gui.simulation_totals import totals_of
from evenload.gui.stability_inputs import Rows, combo, number
from evenload.gui.stability_layout import button, scrolled
from evenload.gui.told import Told

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadSimulation"  # of the dock
LEFT, RIGHT, HEIGHT = 285, 280, 430  # pixels
WIDEST = 540  # pixels, of what is on the right: the plots are to be seen
BAR = 100  # steps of the progress bar, whose drawing takes as long as some work


class RateBox(LengthBox):
    """A field for removal rates: what they call mm are mm3/min."""

    names, factors = units.LARGE_RATE.names, units.LARGE_RATE.sizes
    digits, steps = (4, 4), (1e3, 0.1 * units.INCH**3)


class SimulationDock(manual.Dock):
    """view: whose methods the widgets call, a SimulationView."""

    def __init__(self, view):
        window = FreeCADGui.getMainWindow()
        super().__init__(_translate("EvenLoad", "EvenLoad Simulation"), window)
        self.setObjectName(NAME)
        self.set_page("simulation_window")
        self.asked, self.limits = _asked(), _limits()
        self.plot = PlotView()
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setToolTip(_translate("EvenLoad", "Moves the tool along the path"))
        self.told = Told()
        self.values, self.totals = (Shaded(form=QtCore.Qt.RichText) for _ in range(2))
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, BAR)
        self.cancel = button("Cancel", "Stops the simulation", view.cancel)
        self.whole = button("Whole Time", "Shows all of the time", self.plot.show_all)
        self.picture = button("Picture…", "Draws the plots, PNG or SVG", view.save_picture)
        self.table = button("Table…", "Writes all samples, CSV", view.save_table)
        self.report = button(
            "Report…", "Simulates the job and writes a report to print, HTML", view.save_report
        )
        self.worst = button("Fly to the Worst", "Shows the place with the largest value", view.fly)
        content = QtGui.QWidget()
        row = QtGui.QHBoxLayout(content)
        row.addWidget(self._left())
        row.addLayout(self._middle(), 1)
        self.right = self._right()
        row.addWidget(self.right)
        self.setWidget(content)
        add_below(window, self, HEIGHT)

    def list_operations(self, operations, chosen, against=None):
        """Lists operations to choose from, one of which is chosen, and one or None beside it; tells
        nobody.
        """
        for widget in (self.asked.operation, self.asked.against):
            widget.blockSignals(True)
        self.asked.against.addItem(_translate("EvenLoad", "None"), "")
        listed = (*operations, chosen) if against is None else (*operations, chosen, against)
        for each in dict.fromkeys(listed):
            self.asked.operation.addItem(each.Label, each.Name)
            self.asked.against.addItem(each.Label, each.Name)
        for widget in (self.asked.operation, self.asked.against):
            fields.make_room_for_choices(widget)
            widget.blockSignals(False)
        beside = "" if against is None else against.Name
        self.asked.show_values(operation=chosen.Name, against=beside)

    def forget(self, gone, chosen):
        """Takes an operation that is no more, by its name, out of the lists, and chooses another;
        tells nobody.
        """
        for widget in (self.asked.operation, self.asked.against):
            blocked = widget.blockSignals(True)
            widget.removeItem(widget.findData(gone))
            widget.blockSignals(blocked)
        self.asked.show_values(operation=chosen)

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        for widget in (self.bar, self.cancel):
            widget.setVisible(share is not None)
        self.slider.setVisible(share is None)
        self.bar.setValue(round(BAR * (share or 0.0)))

    def tell(self, text, colour=None):
        """Shows sentences, or hides those before where there are none."""
        self.told.tell(text, colour)

    def show_totals(self, runs):
        """Shows the figures of Runs beside each other; none: nothing."""
        self.totals.setText(totals_of(runs) if runs else "")
        self.right.fit()

    def _left(self):
        return scrolled(_column((self.asked, self.limits)), LEFT)

    def _middle(self):
        column = QtGui.QVBoxLayout()
        column.addWidget(self.plot, 1)
        below = QtGui.QHBoxLayout()
        for widget in (self.slider, self.bar):
            below.addWidget(widget, 1)
        for widget in (self.cancel, self.whole, self.worst):
            below.addWidget(widget)
        column.addLayout(below)
        return column

    def _right(self):
        files = QtGui.QWidget()
        row = QtGui.QHBoxLayout(files)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.picture, self.table, self.report):
            row.addWidget(widget)
        column = _column((self.told, files, self.values, self.totals))
        return FittedColumn(column, RIGHT, WIDEST)


def _asked():
    return Rows(
        "Simulation",
        (
            ("operation", "Operation", "Whose path is simulated", combo(())),
            (
                "against",
                "Against",
                "Another one beside it on the same scale; each as if the other had cut nothing",
                combo(()),
            ),
            ("machine", "Machine", "Times are within its limits", MachineBox()),
            (
                "material",
                "Material",
                "Its force coefficients",
                combo((name, name) for name in materials.names()),
            ),
        ),
    )


def _limits():
    """Named as the attributes of a Simulation are."""
    return Rows(
        "Limits",
        (
            (
                "engagement_deg",
                "Engagement",
                "Draws a line at this engagement angle",
                number(0, 360, 1, 5, "°", "none"),
            ),
            (
                "removal_rate",
                "Removal rate",
                "Draws a line at this removal rate",
                RateBox(1e8, unset="none"),
            ),
            (
                "force_peak",
                "Force",
                "Draws a line at this force",
                number(0, 1e6, 0, 10, "N", "none"),
            ),
        ),
    )


def _column(widgets):
    """Widgets one below the other."""
    content = QtGui.QWidget()
    column = QtGui.QVBoxLayout(content)
    column.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        column.addWidget(widget)
    column.addStretch(1)
    return content
