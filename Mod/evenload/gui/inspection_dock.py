"""The widgets of the dock Inspect: faces, where to measure, what measured points say."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload.gui import load_colours, manual
from evenload.gui import inspection_rows as rows
from evenload.gui.inspection_alignment import Alignment
from evenload.gui.inspection_labels import unit
from evenload.gui.length_box import LengthBox
from evenload.gui.load_legend import NAMES, Legend
from evenload.gui.shaded import Shaded
from evenload.gui.stability_layout import button
from evenload.inspection.points import SHOWN, mm_per
from evenload.units import Quantity, Unit

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadInspection"  # of the dock
WIDTH = 264  # pixels, as FreeCAD's own dock has at first
MARGINS = 4, 4, 4, 4  # pixels around what stands in each other: there is little room
DEVIATION = load_colours.Measure(
    "deviation",
    "Deviation",
    Quantity(*(Unit(name, mm_per(key), digits) for key, (name, digits) in SHOWN.items())),
    tuple(NAMES),
)
TO_MEASURE, MEASURED, PREDICTED = 0, 1, 2  # the numbers of the tabs


class DeviationLegend(Legend):
    """The scale of deviations, and the colour of points beyond the tolerance."""

    has_beyond = False

    def show_deviations(self, largest):
        """The scale from -largest to largest, mm."""
        self.show_scale(DEVIATION, -largest, largest, None)

    def swatches(self):
        words = _translate("EvenLoad", "point beyond the tolerance")
        return [(load_colours.BEYOND, words)] if self.has_beyond else []


class InspectionDock(manual.Dock):
    """view: whose methods the buttons call, an InspectionView."""

    def __init__(self, view):
        window = FreeCADGui.getMainWindow()
        super().__init__(_translate("EvenLoad", "Inspect"), window)
        self.setObjectName(NAME)
        self.set_page("inspect")
        self.faces, self.told_samples, self.told = Shaded(), Shaded(), Shaded()
        self.predicted = Shaded()
        self.file = Shaded(_translate("EvenLoad", "No file is open."))
        self.take = button(
            "Take Selected Faces", "Inspects the faces that are selected", view.take_selection
        )
        self.legend = DeviationLegend()
        self.samples, self.cutting = rows.sampling(), rows.cutting()
        self.evaluation, self.tolerance = rows.evaluating(), rows.tolerance()
        self.alignment = Alignment(view.pick_datum)
        self._unit = unit()
        self.probing = button(
            "Probing Program…",
            "Writes G-code that probes these points, G38.2, by the post-processor",
            view.save_probing,
        )
        self.save_points = button("Points…", "Writes these points as CSV or DMIS", view.save_points)
        self.save_picture = button("Picture…", "Draws these points", view.save_picture)
        self.open = button("Open…", "Reads measured points, CSV or DMIS", view.open_points)
        self.save_report = button("Report…", "Writes a report to print, HTML", view.save_report)
        self.save_map = button("Picture…", "Draws the deviations", view.save_map)
        self.tabs = QtGui.QTabWidget()
        for page, title, tip in (
            (_page(*self._where()), "Where", "Where to measure"),
            (_page(*self._measured()), "Measured", "What measured points say"),
            (_page(self.cutting, self.predicted), "Predicted", "What to expect of a finishing"),
        ):
            number = self.tabs.addTab(page, _translate("EvenLoad", title))
            self.tabs.setTabToolTip(number, _translate("EvenLoad", tip))
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        column.setContentsMargins(*MARGINS)
        column.addWidget(self.faces)
        column.addWidget(self.take)
        column.addWidget(self.tabs, 1)
        area = QtGui.QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QtGui.QFrame.NoFrame)
        area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        area.setWidget(content)
        area.setMinimumWidth(max(WIDTH, content.minimumSizeHint().width() + 20))
        self.setWidget(area)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, self)

    def _where(self):
        saving = self.save_points, self.save_picture
        return self.samples, self.told_samples, saving, self.probing

    def _measured(self):
        saving = self.save_report, self.save_map
        return (
            *((self.open, self.file), self.evaluation, self.alignment, self.tolerance, self.told),
            *(self.legend, saving),
        )

    def follow_units(self, named):
        """Whether lengths were shown in another unit before; now they are in this."""
        is_new, self._unit = named != self._unit, named
        if is_new:
            for box in self.lengths():
                box.follow_units()
        return is_new

    def lengths(self):
        """The fields for lengths."""
        groups = self.samples, self.evaluation, self.tolerance, self.cutting
        widgets = [getattr(group, name) for group in groups for name in group.names]
        return [widget for widget in widgets if isinstance(widget, LengthBox)]

    def offer_operations(self, operations):
        """Lists operations, [(text, name), ...], whose values may be taken; what is chosen stays if
        it is among them, and nobody is told.
        """
        rows.offer(self.cutting.source, operations)


def _page(*parts):
    """A tab with widgets, and rows of widgets, below each other."""
    page = QtGui.QWidget()
    column = QtGui.QVBoxLayout(page)
    column.setContentsMargins(*MARGINS)
    for part in parts:
        if isinstance(part, tuple):
            column.addLayout(_row(*part))
            continue
        if isinstance(part, rows.Rows):
            part.layout().setContentsMargins(*MARGINS)
        column.addWidget(part)
    column.addStretch(1)
    return page


def _row(*widgets):
    row = QtGui.QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget, int(isinstance(widget, QtGui.QLabel)))
    return row
