"""Colours of texts that can be read on FreeCAD's light and dark themes."""

from PySide import QtGui

# For each meaning the colour on light and on dark ground; contrasts are 4.5 and more on both.
GOOD = "#0b6b2e", "#7ddc9a"
CAUTION = "#7a4f00", "#ffcc66"
BAD = "#b3261e", "#ff9d94"
LINK = "#0b57a4", "#8ab8ff"
QUIET = "#5f6368", "#bdc1c6"  # what is told meanwhile


def shade(colour, widget):
    """The one of two colours that can be read where a widget's own text can."""
    text = widget.palette().color(QtGui.QPalette.Active, QtGui.QPalette.WindowText)
    return colour[text.lightness() > 127]
