"""What scripts share that use the dock Inspect in FreeCAD's GUI."""

import os

import FreeCAD
import FreeCADGui
from gui_tools import OUT, click, later
from PySide import QtGui


def opened():
    """(the object, its InspectionView) of the source's part CX, whose upper faces are inspected."""
    from evenload import inspection
    from evenload.gui import inspection as command
    from inspected import dome, upper_faces

    doc = FreeCAD.newDocument("Dome")
    part = doc.addObject("Part::Feature", "Dome")
    part.Shape = dome(inspection.test_part("CX"))
    doc.recompute()
    FreeCADGui.activeDocument().activeView().viewAxonometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    for name in upper_faces(part.Shape):
        FreeCADGui.Selection.addSelection(part, name)
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(300)
    return part, command._shown[0]


def save(button, name):
    """Clicks a button that writes a file; tells how large it is then."""
    path = os.path.join(OUT, name)
    dialog, before = QtGui.QFileDialog, QtGui.QFileDialog.getSaveFileName
    try:
        dialog.getSaveFileName = staticmethod(lambda *_: (path, ""))
        click(button)
    finally:
        dialog.getSaveFileName = before
    return os.path.getsize(path) if os.path.exists(path) else 0


def open_points(dock, path):
    dialog, before = QtGui.QFileDialog, QtGui.QFileDialog.getOpenFileName
    try:
        dialog.getOpenFileName = staticmethod(lambda *_: (path, ""))
        click(dock.open)
    finally:
        dialog.getOpenFileName = before
    later(50)


def choose(box, data):
    box.setCurrentIndex(box.findData(data))
    later(50)


def cut_off(dock):
    """The widgets of the dock whose right edge is hidden."""
    area = dock.widget()
    seen = area.viewport().width()
    kinds = QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QPushButton
    return [
        widget.metaObject().className()
        for kind in kinds
        for widget in area.widget().findChildren(kind)
        if widget.isVisible()
        and widget.mapTo(area.viewport(), widget.rect().topRight()).x() >= seen
    ]


def measured(name, points, normals):
    from evenload import inspection

    path = os.path.join(OUT, name)
    inspection.write_csv(path, points, normals, "mm")
    return path


def grid():
    """Fewer places than test_inspection.py has, which are drawn sooner."""
    from inspected import X, Y

    return (each.reshape(21, 21)[::2, ::2].ravel() for each in (X, Y))
