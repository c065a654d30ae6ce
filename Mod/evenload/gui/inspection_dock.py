"""The widgets of the dock Inspect: faces, where to measure, what measured points say."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host
from evenload.face_inspection.patterns import LEAST
from evenload.gui import load_colours
from evenload.gui.load_legend import NAMES, Legend
from evenload.gui.stability_inputs import Rows, combo, number
from evenload.gui.stability_layout import button

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadInspection"  # of the dock
WIDTH = 320  # pixels at least
MOST_SHOWN = 5000  # points: more would hold the window up for seconds
DEVIATION = load_colours.Measure("deviation", "Deviation", "mm", 4, tuple(NAMES))
PATTERNS = (("Halton-Zaremba", "Halton-Zaremba"), ("Matrix", "matrix"))
SPACINGS = (("Arc length", "arc length"), ("As seen from above", "plan"))
ALIGNED = "aligned"  # a profile without any motion
POINTS_OF = (("All of the file", True), ("Of these faces alone", False))
KINDS = (
    ("Profile, best fit", "profile"),
    ("Profile, as aligned", ALIGNED),
    ("Flatness", "plane"),
    ("Cylindricity", "cylinder"),
    ("Sphericity", "sphere"),
    ("Roundness", "circle"),
    ("Straightness", "line"),
)


class DeviationLegend(Legend):
    """The scale of deviations, and the colour of points beyond the tolerance."""

    has_beyond = False

    def swatches(self):
        words = _translate("EvenLoad", "point beyond the tolerance")
        return [(load_colours.BEYOND, words)] if self.has_beyond else []


class InspectionDock(QtGui.QDockWidget):
    """view: whose methods the buttons call, an InspectionView."""

    def __init__(self, view):
        window = FreeCADGui.getMainWindow()
        super().__init__(_translate("EvenLoad", "Inspect"), window)
        self.setObjectName(NAME)
        self.faces, self.told_samples, self.told = _label(), _label(), _label()
        self.file = _label(_translate("EvenLoad", "No file is open."))
        self.take = button(
            "Take Selected Faces", "Inspects the faces that are selected", view.take_selection
        )
        self.legend = DeviationLegend()
        self.samples = _sampling()
        self.evaluation, self.tolerance = _evaluating(), _tolerance()
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
        self.tabs.addTab(self._where(), _translate("EvenLoad", "Where to measure"))
        self.tabs.addTab(self._measured(), _translate("EvenLoad", "Measured points"))
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
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
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.addWidget(self.samples)
        column.addWidget(self.told_samples)
        column.addLayout(_row(self.save_points, self.save_picture))
        column.addWidget(self.probing)
        column.addStretch(1)
        return page

    def _measured(self):
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.addLayout(_row(self.open, self.file))
        column.addWidget(self.evaluation)
        column.addWidget(self.tolerance)
        column.addWidget(self.told)
        column.addWidget(self.legend)
        column.addLayout(_row(self.save_report, self.save_map))
        column.addStretch(1)
        return page


def _sampling():
    count = QtGui.QSpinBox()
    count.setRange(1, MOST_SHOWN)
    count.setValue(LEAST)
    count.setKeyboardTracking(False)
    posts = combo((name, name) for name in sorted(host.post_processors()))
    posts.setCurrentIndex(max(0, posts.findData("linuxcnc")))
    return Rows(
        "Points",
        (
            (
                "pattern",
                "Pattern",
                "Halton-Zaremba has no rows that may miss a fillet",
                combo(PATTERNS),
            ),
            ("count", "Number", "At least so many; fewer than 49 may tell too little", count),
            ("spacing", "Spacing", "Even along each face, or from above over all", combo(SPACINGS)),
            ("margin", "Margin", "From the border of the faces", number(0, 1000, 2, 0.5, "mm")),
            ("ball", "Probe", "Diameter of the probe's ball", number(0.1, 50, 3, 0.5, "mm")),
            ("post", "Post-processor", "Of the probing program", posts),
        ),
    )


def _evaluating():
    return Rows(
        "Evaluation",
        (
            ("kind", "Form error", "By minimum zone, with its proof", combo(KINDS)),
            ("points", "Points", "A file may be of more faces than these", combo(POINTS_OF)),
            (
                "radius",
                "Ball radius",
                "Of a file that holds centres of the probe's ball",
                number(0, 50, 3, 0.5, "mm", "points of contact"),
            ),
        ),
    )


def _tolerance():
    allowed = number(0, 1000, 4, 0.005, "mm", "none")
    tip = "Width of the zone that is allowed"
    return Rows("Tolerance", (("width", "Zone", tip, allowed),))


def _label(text=""):
    label = QtGui.QLabel(text)
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return label


def _row(*widgets):
    row = QtGui.QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget, int(isinstance(widget, QtGui.QLabel)))
    return row
