"""Our texts in FreeCAD's themes: their colours beside those of the ground that they stand on."""

import os
import re
import sys

import FreeCAD
import numpy
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_preview_tools import CANCEL, job_with, opened, turn  # noqa: E402
from gui_tools import later, picture, press, result, run, until, workbench  # noqa: E402

MAIN = "User parameter:BaseApp/Preferences/MainWindow"
OURS = re.compile(r"color: ?(#[0-9a-f]{6})")  # of a text's own markup or style
SHOWN = QtGui.QLabel, QtGui.QAbstractButton, QtGui.QLineEdit, QtGui.QComboBox


def themes():
    """The names of the style sheets that FreeCAD brings along, and none. Of those that differ by
    the colour of what is selected one is enough.
    """
    found = QtCore.QDir("qss:").entryList(["*.qss"])
    return ["", *(name for name in found if not re.search("-(green|orange)[.]", name))]


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


def colours_in(widget, window):
    """The colours of a widget in its window's picture as names, the most frequent first."""
    corner = widget.mapTo(widget.window(), QtCore.QPoint(0, 0))
    ratio = window.width() / widget.window().width()
    # FreeCAD's button for expressions stands at the right of a number.
    width = widget.width() // (2 if isinstance(widget, QtGui.QLineEdit) else 1)
    rect = corner.x(), corner.y(), width, widget.height()
    image = window.copy(*(round(ratio * each) for each in rect))
    image = image.convertToFormat(QtGui.QImage.Format_RGB32)
    pixels = numpy.frombuffer(image.constBits(), numpy.uint32) & 0xFFFFFF
    colours, counts = numpy.unique(pixels, return_counts=True)
    return ["#%06x" % each for each in colours[numpy.argsort(-counts)]]


def text_of(widget):
    return widget.currentText() if isinstance(widget, QtGui.QComboBox) else widget.text()


def is_read(widget):
    """Whether all of it can be seen, and has a text. FreeCAD's own fields for quantities are left
    out: FreeCAD 0.20 writes them in black on any ground, in its own pages, too.
    """
    if widget.parentWidget().metaObject().className() == "Gui::QuantitySpinBox":
        return False
    seen = widget.visibleRegion().boundingRect()
    whole = seen.height() > 0.8 * widget.height() and 2 * seen.width() > widget.width()
    return whole and widget.isEnabled() and re.sub(r"<[^>]*>", "", text_of(widget)).strip()


def contrasts(form):
    """[[kind, text, contrast as it is drawn, the least of the colours that we gave it]] of what
    can be read in a form.
    """
    from evenload.gui.colours import contrast

    window, found = form.window().grab().toImage(), []
    for kind in SHOWN:
        for widget in filter(is_read, form.findChildren(kind)):
            drawn, text = colours_in(widget, window), text_of(widget)
            ours = OURS.findall(text + widget.styleSheet())
            best = max(contrast(drawn[0], each) for each in drawn)
            own = min((contrast(drawn[0], each) for each in ours), default=None)
            found.append([kind.__name__, text, best, own])
    return found


def of_the_theme(form):
    """{kind: contrast} of bare widgets in the place of a form's first ones."""
    bare = QtGui.QWidget(form)
    rows = QtGui.QVBoxLayout(bare)
    for kind in SHOWN:
        concrete = {SHOWN[1]: QtGui.QToolButton, SHOWN[2]: QtGui.QDoubleSpinBox}.get(kind, kind)
        widget = concrete(bare)
        if kind is QtGui.QComboBox:
            widget.addItem("Text")
        elif concrete is kind or kind is QtGui.QAbstractButton:
            widget.setText("Text")
        rows.addWidget(widget)
    bare.setGeometry(form.rect())
    bare.setAutoFillBackground(True)
    bare.show()
    later(50)
    found = {kind: best for kind, _, best, _ in contrasts(bare)}
    bare.hide()
    bare.deleteLater()
    return found


def seen_in(theme, op):
    """The contrasts of a page with its path and with a value that is refused; of the theme."""
    take(theme)
    page = opened(op)
    later(200)
    picture("theme_%s" % (theme or "none"))  # which lays it out, too
    found = contrasts(page.form)
    turn(op, 3)
    until(lambda: page.preview.state != "computing")
    later(300)
    picture("refused_%s" % (theme or "none"))
    found += contrasts(page.form)
    bare = of_the_theme(page.form)
    press(CANCEL)
    later(200)
    return found, bare


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
