"""Our texts in FreeCAD's themes: their colours beside those of the ground that they stand on."""

import os
import re
import sys

import FreeCAD
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_preview_tools import CANCEL, job_with, opened, turn, until  # noqa: E402
from gui_tools import later, picture, press, result, run, workbench  # noqa: E402

MAIN = "User parameter:BaseApp/Preferences/MainWindow"
OURS = re.compile(r"color: ?(#[0-9a-f]{6})")  # of a text's own markup or style
SHOWN = QtGui.QLabel, QtGui.QAbstractButton, QtGui.QAbstractSpinBox, QtGui.QComboBox


def themes():
    """The names of the style sheets that FreeCAD brings along, and none."""
    return ["", *QtCore.QDir("qss:").entryList(["*.qss"])]


def take(theme):
    """As FreeCAD does at its start; FreeCAD 1.1 does it by itself, a moment after it was told."""
    FreeCAD.ParamGet(MAIN).SetString("StyleSheet", theme)
    later(600)
    file = QtCore.QFile("qss:" + theme)
    text = ""
    if theme and file.open(QtCore.QFile.ReadOnly):
        text = bytes(file.readAll()).decode()
    if "@" not in text:  # what the others are filled with only FreeCAD knows
        QtGui.QApplication.instance().setStyleSheet(text)
    later(100)


def luminance(colour):
    """Of a colour, relative to white [WCAG 2, relative luminance]."""
    parts = colour.redF(), colour.greenF(), colour.blueF()
    even = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return sum(weight * each for weight, each in zip((0.2126, 0.7152, 0.0722), even))


def contrast(one, other):
    """[WCAG 2, contrast ratio]"""
    low, high = sorted((luminance(QtGui.QColor(one)), luminance(QtGui.QColor(other))))
    return (high + 0.05) / (low + 0.05)


def colours_in(widget):
    """The colours of a widget's picture as names, the most frequent first."""
    image, counts = widget.grab().toImage(), {}
    for y in range(image.height()):
        for x in range(image.width()):
            name = image.pixelColor(x, y).name()
            counts[name] = counts.get(name, 0) + 1
    return sorted(counts, key=counts.get, reverse=True)


def has_text(widget):
    text = widget.currentText() if isinstance(widget, QtGui.QComboBox) else widget.text()
    return bool(re.sub(r"<[^>]*>", "", text).strip())


def contrasts(form):
    """{text: [contrast as it is drawn, the least of the colours that we gave it]} of a form."""
    found = {}
    for kind in SHOWN:
        for widget in form.findChildren(kind):
            if not (widget.isVisible() and widget.isEnabled() and has_text(widget)):
                continue
            drawn = colours_in(widget)
            text = widget.currentText() if kind is QtGui.QComboBox else widget.text()
            ours = OURS.findall(text + widget.styleSheet())
            drawn_best = max(contrast(drawn[0], each) for each in drawn)
            own = min((contrast(drawn[0], each) for each in ours), default=None)
            found["%s: %s" % (kind.__name__, text)] = [drawn_best, own]
    return found


def seen_in(theme, op):
    """The contrasts of a page where the path is there, and where a value is refused."""
    take(theme)
    page = opened(op)
    later(200)
    found = {"valid " + text: each for text, each in contrasts(page.form).items()}
    picture("theme_%s" % (theme or "none"))
    turn(op, 3)
    until(lambda: page.preview.state != "computing")
    later(100)
    found.update(("refused " + text, each) for text, each in contrasts(page.form).items())
    press(CANCEL)
    later(200)
    return found


def session():
    workbench(1300, 1000)
    _, _, op = job_with("Themes", 60.0)
    op.MinimumRadius = 5.0  # what is noted of it
    op.Document.recompute()
    result["notes"] = op.Report
    result["themes"] = {theme: seen_in(theme, op) for theme in themes()}
    take("")
    later(100)


run(session)
