"""What takes pictures of FreeCAD's window for docs/screenshots.py."""

import os
import sys

import FreeCADGui
from PySide import QtCore, QtGui

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "tests", "freecad")
sys.path.insert(0, TESTS)
from gui_tools import OUT, later, on_screen, widgets  # noqa: E402

WINDOW = 1360, 1000  # pixels
DOCKS = {"left": 330, "right": 300}  # pixels of width
PATIENCE = 1200  # times 50 ms that anything is waited for


def window(name, height=None, width=WINDOW[0]):
    """A picture of the whole window, so many pixels wide. height: mm that the 3D view shows; None:
    all there is.
    """
    main = FreeCADGui.getMainWindow()
    main.move(0, 0)
    # FreeCAD 1.1 shows a bar over the 3D view where the mouse is.
    QtGui.QCursor.setPos(0, QtGui.QGuiApplication.primaryScreen().geometry().bottom())
    main.resize(width, WINDOW[1])
    for dock in widgets(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
    areas = {"left": QtCore.Qt.LeftDockWidgetArea, "right": QtCore.Qt.RightDockWidgetArea}
    for side, room in DOCKS.items():
        docks = [d for d in widgets(QtGui.QDockWidget) if main.dockWidgetArea(d) == areas[side]]
        docks = [d for d in docks if d.isVisible()]
        main.resizeDocks(docks, [room] * len(docks), QtCore.Qt.Horizontal)
    later(500)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    if height is not None:
        FreeCADGui.activeDocument().activeView().getCameraNode().height = height
    later(500)
    on_screen(main).save(os.path.join(OUT, name + ".png"))


def select(obj, *names):
    """Selects an object, or parts of it by their names."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj, *names)


def until(is_so):
    """Lets the GUI go on until something is so."""
    for _ in range(PATIENCE):
        later(50)
        if is_so():
            return
    raise AssertionError("it never came")


def done(view):
    """Waits for the task of a window or dock."""
    until(lambda: not view.task.is_busy)
