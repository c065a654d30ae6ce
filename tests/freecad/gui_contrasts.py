"""How well texts can be read in a window, for scripts that tests run in FreeCAD's GUI: the colours
of letters beside those of the ground that they stand on.
"""

import re

import numpy
from gui_tools import later
from PySide import QtCore, QtGui

OURS = re.compile(r"color: ?(#[0-9a-f]{6})")  # of a text's own markup or style
SIGN = re.compile("<span[^>]*>\u25a0</span>")  # of a colour in the 3D view: no text
SHOWN = (
    *(QtGui.QLabel, QtGui.QToolButton, QtGui.QPushButton, QtGui.QCheckBox),
    *(QtGui.QLineEdit, QtGui.QComboBox),
)


def colours_in(widget, window, part=None):
    """The colours of a widget in its window's picture as names, the most frequent first. part: a
    rectangle in the widget, where not all of it counts.
    """
    # FreeCAD's button for expressions stands at the right of a number.
    width = widget.width() // (2 if isinstance(widget, QtGui.QLineEdit) else 1)
    part = part or QtCore.QRect(0, 0, width, widget.height())
    corner = widget.mapTo(widget.window(), part.topLeft())
    ratio = window.width() / widget.window().width()
    rect = corner.x(), corner.y(), part.width(), part.height()
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
            ours = OURS.findall(SIGN.sub("", text) + widget.styleSheet())
            best = max(contrast(drawn[0], each) for each in drawn)
            own = min((contrast(drawn[0], each) for each in ours), default=None)
            found.append([kind.__name__, text, best, own])
    return found


def painted(kind, widget, text, part):
    """The same of a text that a widget paints by itself in a part of it, alone on its ground."""
    from evenload.gui.colours import contrast

    drawn = colours_in(widget, widget.window().grab().toImage(), part)
    return [kind.__name__, text, max(contrast(drawn[0], each) for each in drawn), None]


def of_the_theme(form):
    """{kind: contrast} of bare widgets in place of all that is in a form, which stays hidden."""
    for each in form.children():
        if isinstance(each, QtGui.QWidget):
            each.hide()
    bare = QtGui.QWidget(form)
    columns = QtGui.QHBoxLayout(bare)
    columns.setContentsMargins(0, 0, 0, 0)
    for room in (QtGui.QWidget(), QtGui.QGroupBox()):  # a theme may draw them otherwise in these
        _fill(room)
        columns.addWidget(room)
    bare.setGeometry(form.rect())
    bare.setAutoFillBackground(True)
    bare.show()
    later(50)
    seen = contrasts(bare)
    bare.hide()
    bare.deleteLater()
    return {kind: min(best for other, _, best, _ in seen if other == kind) for kind, *_ in seen}


def _fill(room):
    """Puts a widget of each kind into another."""
    rows = QtGui.QVBoxLayout(room)
    rows.setContentsMargins(0, 0, 0, 0)
    rows.setSpacing(0)
    for kind in SHOWN:
        # FreeCAD's themes have colours of their own for the lines in boxes for numbers.
        widget = QtGui.QDoubleSpinBox() if kind is QtGui.QLineEdit else kind()
        if kind is QtGui.QComboBox:
            widget.addItem("Text")
        elif kind is not QtGui.QLineEdit:
            widget.setText("Text")
        rows.addWidget(widget)
