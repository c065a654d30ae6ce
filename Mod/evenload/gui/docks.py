"""Where docks stand in FreeCAD's window."""

from PySide import QtCore, QtGui

OTHERS = "Report view", "Python console"  # FreeCAD's docks below, in whose place ours stand


def add_below(window, dock, height):
    """Puts a dock below the 3D view, `height` pixels high and over all of the width: as a tab with
    FreeCAD's own there, beside which it would have half of it.
    """
    window.addDockWidget(QtCore.Qt.BottomDockWidgetArea, dock)
    for name in OTHERS:
        other = window.findChild(QtGui.QDockWidget, name)
        if other is None or not other.isVisible() or other.isFloating():
            continue
        if window.dockWidgetArea(other) == QtCore.Qt.BottomDockWidgetArea:
            window.tabifyDockWidget(other, dock)
            QtCore.QTimer.singleShot(0, dock.raise_)
    window.resizeDocks([dock], [height], QtCore.Qt.Vertical)
