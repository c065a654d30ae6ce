"""The values that the dock Inspect asks for."""

from PySide import QtGui

from evenload import host
from evenload.face_inspection.patterns import LEAST
from evenload.face_inspection.probing_program import Probe
from evenload.gui import fields
from evenload.gui.length_box import FineLengthBox, LengthBox, RoughnessBox
from evenload.gui.stability_inputs import Rows, combo, number
from evenload.inspection.predictions import SOURCE, ZIG_ZAG
from evenload.settings.table import FINISHING

MOST_SHOWN = 5000  # points: more would hold the window up for seconds
PATTERNS = (("Halton-Zaremba", "Halton-Zaremba"), ("Matrix", "matrix"))
SPACINGS = (("Arc length", "arc length"), ("As seen from above", "plan"))
POINTS_OF = (("All of the file", True), ("Of these faces alone", False))
KINDS = (
    ("Profile", "profile"),
    ("Flatness", "plane"),
    ("Cylindricity", "cylinder"),
    ("Sphericity", "sphere"),
    ("Roundness", "circle"),
    ("Straightness", "line"),
)
NATURES = (("Convex", "CX"), ("Concave", "CV"))
OWN = ""  # in the list of operations: numbers of the user's own


def sampling():
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
            ("margin", "Margin", "From the border of the faces", LengthBox(1000)),
            (
                "ball",
                "Probe",
                "Diameter of the probe's ball",
                LengthBox(50, Probe.diameter, least=0.1),
            ),
            ("post", "Post-processor", "Of the probing program", posts),
        ),
    )


def evaluating():
    return Rows(
        "Evaluation",
        (
            ("kind", "Form error", "By minimum zone, with its proof", combo(KINDS)),
            ("points", "Points", "A file may be of more faces than these", combo(POINTS_OF)),
            (
                "radius",
                "Ball radius",
                "Of a file that holds centres of the probe's ball",
                LengthBox(50, unset="points of contact"),
            ),
        ),
    )


def tolerance():
    allowed = FineLengthBox(1000, unset="none")
    tip = "Width of the zone that is allowed"
    return Rows("Tolerance", (("width", "Zone", tip, allowed),))


def cutting():
    """How the faces are finished; the beginning is the source's."""
    (strategy,) = (setting for setting in FINISHING if setting.name == "Strategy")
    passes = combo((each, each) for each in strategy.value)
    passes.setCurrentIndex(passes.findData(ZIG_ZAG))
    direction, speed = number(0, 90, 1, 5, "°"), number(0, 200000, 0, 50, "rev/min")
    speed.setValue(SOURCE.spindle_speed)
    for box in (direction, speed):  # or they would ask for room for the largest number
        box.setMinimumWidth(fields.NARROWEST)
    return Rows(
        "Finishing",
        (
            ("source", "Values", "Of an operation, or of your own", combo([("Own", OWN)])),
            ("nature", "Face", "How it is bent", combo(NATURES)),
            (
                "direction",
                "Feed direction",
                "Of the passes, seen from above, to the cylinder's axis",
                direction,
            ),
            (
                "roughness",
                "Rz",
                "Measured; an operation tells the height of its cusps, the least that it can be",
                RoughnessBox(0.2, unset="not told"),
            ),
            (
                "stepover",
                "Stepover",
                "Distance of neighbouring passes",
                FineLengthBox(100, SOURCE.stepover),
            ),
            (
                "feed",
                "Feed per tooth",
                "Of the tool",
                FineLengthBox(10, SOURCE.feed_per_tooth),
            ),
            ("depth", "Depth", "What is taken off the face", FineLengthBox(100, SOURCE.depth)),
            ("tool", "Tool radius", "At its end", LengthBox(500, SOURCE.tool_radius)),
            ("face", "Face radius", "Of the cylinder", LengthBox(100000, SOURCE.face_radius)),
            ("speed", "Spindle speed", "Of the tool", speed),
            ("passes", "Passes", "Their strategy", passes),
        ),
    )


def offer(box, rows):
    """Lists rows of (text, value) below the first of a list; what is chosen stays if it is among
    them, and nobody is told.
    """
    before = box.currentData()
    blocked = box.blockSignals(True)
    while box.count() > 1:
        box.removeItem(1)
    for text, value in rows:
        box.addItem(text, value)
    box.setCurrentIndex(max(0, box.findData(before)))
    box.blockSignals(blocked)
