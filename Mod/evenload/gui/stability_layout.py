"""Where the widgets of the window Stability chart are."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui.slots import slot

_translate = FreeCAD.Qt.translate

LEFT = 345  # pixels of the settings, at least
LINES = 4  # of the verdict, for which there is room always
SIZE = 1120, 860


def button(title, tip, action):
    """A push button that calls a method; Enter in a field does not press it."""
    made = QtGui.QPushButton(_translate("EvenLoad", title))
    made.setToolTip(_translate("EvenLoad", tip))
    made.setAutoDefault(False)
    made.clicked.connect(slot(action))
    return made


def scrolled(content, width):
    """A column that can be scrolled up and down, at least so many pixels wide."""
    area = QtGui.QScrollArea()
    area.setWidgetResizable(True)
    area.setFrameShape(QtGui.QFrame.NoFrame)
    area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
    area.setWidget(content)
    # As wide as a style's widgets need, with room for a scroll bar.
    bar = area.verticalScrollBar().sizeHint().width()
    area.setFixedWidth(max(width, content.minimumSizeHint().width() + bar + 4))
    return area


def lay_out(window):
    """Puts the widgets of the window Stability chart in their places."""
    told = window.told
    told.setMinimumHeight(LINES * told.fontMetrics().lineSpacing())
    told.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
    window.limits.layout().addRow(window.best_button)
    window.limits.layout().addRow(window.found)
    left = QtGui.QWidget()
    column = QtGui.QVBoxLayout(left)
    for widget in (window.operations, window.modes, window.cut, window.limits, window.chart):
        column.addWidget(widget)
    column.addStretch(1)
    area = scrolled(left, LEFT)
    below = QtGui.QHBoxLayout()
    below.addWidget(told, 1)
    below.addWidget(window.apply_button)
    below.addWidget(window.close_button)
    right = QtGui.QVBoxLayout()
    right.addWidget(window.view, 1)
    right.addLayout(below)
    layout = QtGui.QHBoxLayout(window)
    layout.addWidget(area)
    layout.addLayout(right, 1)
    window.resize(*SIZE)
