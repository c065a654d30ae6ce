"""Colours of texts that can be read on FreeCAD's themes."""

from PySide import QtCore, QtGui

# For each meaning the colour on light and on dark ground; contrasts are 4.5 and more on both.
GOOD = "#0b6b2e", "#7ddc9a"
CAUTION = "#7a4f00", "#ffcc66"
BAD = "#b3261e", "#ff9d94"
LINK = "#0b57a4", "#8ab8ff"
QUIET = "#5f6368", "#bdc1c6"  # what is told meanwhile

LEAST = 4.5  # contrast of a text with its ground [WCAG 2, 1.4.3]
WEIGHTS = 0.2126, 0.7152, 0.0722  # of red, green and blue [WCAG 2, relative luminance]


def shade(colour, widget, ground=None):
    """The one of two colours that can be read in a widget; on grey ground, where neither can, that
    of the widget's own text. ground: as ground_of() has it, where that was asked before. Not for
    use while something is painted, see drawn().
    """
    ground = ground or ground_of(widget)
    best = max(colour, key=lambda each: contrast(each, ground))
    return best if contrast(best, ground) >= LEAST else _text_of(widget).name()


def drawn(colour, widget):
    """The one of two colours that goes with a widget's own text, for lines that are painted."""
    return colour[_text_of(widget).lightness() > 127]


def ground_of(widget):
    """The colour that a widget's text stands on, a QColor. Style sheets may draw it anywhere above
    the widget, and tell no palette: so one pixel is looked at. As long as the widget is not seen
    its palette has to do.
    """
    if not widget.isVisible():
        light = _text_of(widget).lightness() > 127
        return QtGui.QColor("#333333" if light else "#f0f0f0")
    window = widget.window()
    corner = widget.mapTo(window, QtCore.QPoint(0, 0))
    return window.grab(QtCore.QRect(corner, QtCore.QSize(1, 1))).toImage().pixelColor(0, 0)


def contrast(one, other):
    """Of two colours, 1 to 21 [WCAG 2, contrast ratio]."""
    low, high = sorted((_luminance(QtGui.QColor(one)), _luminance(QtGui.QColor(other))))
    return (high + 0.05) / (low + 0.05)


def _luminance(colour):
    parts = colour.redF(), colour.greenF(), colour.blueF()
    even = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return sum(weight * each for weight, each in zip(WEIGHTS, even))


def _text_of(widget):
    return widget.palette().color(QtGui.QPalette.Active, QtGui.QPalette.WindowText)
