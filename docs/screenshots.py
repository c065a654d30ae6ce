"""Pictures of FreeCAD's window with EvenLoad in it; ./run screenshots starts it in FreeCAD.

$EVENLOAD_GUI_OUT is the folder that gets them, $EVENLOAD_LANGUAGE FreeCAD's name of a language.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "tests", "freecad")
sys.path.insert(0, TESTS)
from finishing_parts import part, upper  # noqa: E402
from gui_tools import OUT, answering, begun, later, press, run, widgets  # noqa: E402
from models import case_model, corpus_case, floors_of  # noqa: E402

LANGUAGE = os.environ.get("EVENLOAD_LANGUAGE", "English")
WINDOW = 1360, 1000  # pixels
DIALOG = 900, 700
STAR, AT = 48, 0.35  # mm of height of the star's pocket; the tool's place along the path
DOCKS = {"left": 330, "right": 300}  # pixels of width


def window(name, height=None):
    """A picture of the whole window. height: mm that the 3D view shows; None: all there is."""
    main = FreeCADGui.getMainWindow()
    for dock in widgets(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
    areas = {"left": QtCore.Qt.LeftDockWidgetArea, "right": QtCore.Qt.RightDockWidgetArea}
    for side, width in DOCKS.items():
        docks = [d for d in widgets(QtGui.QDockWidget) if main.dockWidgetArea(d) == areas[side]]
        docks = [d for d in docks if d.isVisible()]
        main.resizeDocks(docks, [width] * len(docks), QtCore.Qt.Horizontal)
    later(500)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    if height is not None:
        FreeCADGui.activeDocument().activeView().getCameraNode().height = height
    later(500)
    picture = main.grab()
    _draw_view(picture)
    picture.save(os.path.join(OUT, name + ".png"))


def _draw_view(picture):
    """Puts the 3D view into a picture of the window, which Qt draws without it."""
    view = FreeCADGui.activeDocument().activeView()
    viewport = view.graphicsView().viewport()
    file = os.path.join(OUT, "view.png")
    view.saveImage(file, viewport.width(), viewport.height(), "Current")
    at = viewport.mapTo(FreeCADGui.getMainWindow(), QtCore.QPoint(0, 0))
    painter = QtGui.QPainter(picture)
    painter.drawImage(at, QtGui.QImage(file))
    painter.end()
    os.remove(file)


def select(*names):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(*names)


def star(doc):
    """Our operation in the star's pocket."""
    from evenload import host
    from evenload.operations import adaptive

    body = doc.addObject("Part::Feature", "Star")
    body.Shape = case_model(corpus_case("star"))
    doc.recompute()
    job, controller = host.create_job(doc, [body], 6.0, 600.0, 9000, 2)
    model = job.Model.Group[0]
    op = adaptive.Create("EvenLoadAdaptive", parentJob=job, toolController=controller)
    op.Base = [(model, tuple(floors_of(model.Shape)))]
    doc.recompute()
    model.ViewObject.Transparency = 70
    job.Stock.ViewObject.Visibility = False
    FreeCADGui.activeDocument().activeView().viewTop()
    return op


def dome():
    """A finishing operation on the source's dome, in a document of its own."""
    from evenload import host
    from evenload.operations import finishing

    doc = FreeCAD.newDocument("Part")
    body = doc.addObject("Part::Feature", "Dome")
    body.Shape = part(True)
    doc.recompute()
    job, controller = host.create_job(doc, [body], 10.0, 1650.0, 5500, 2)
    controller.Tool = host.create_tool("ballend", {"Diameter": 10.0})
    doc.recompute()
    model = job.Model.Group[0]
    op = finishing.Create("EvenLoadFinishing", parentJob=job, toolController=controller)
    op.Base = [(model, upper(model.Shape))]
    op.Stepover = 2.5
    doc.recompute()
    job.Stock.ViewObject.Visibility = False
    FreeCADGui.activeDocument().activeView().viewIsometric()
    return op, model


def preferences():
    def answer(dialog):
        dialog.resize(*DIALOG)
        later(300)
        dialog.grab().save(os.path.join(OUT, "preferences.png"))
        dialog.reject()

    with answering(answer):
        FreeCADGui.showPreferences("EvenLoad", 0)


def simulated(view):
    for _ in range(400):
        later(50)
        if not view.task.is_busy:
            return


def session():
    from evenload.gui import load_view, simulation

    doc = begun(*WINDOW)
    FreeCADGui.setLocale(LANGUAGE)
    preferences()
    op = star(doc)
    shown = load_view.show(op)
    shown.slider.setValue(int(AT * shown.slider.maximum()))
    window("load", STAR)
    load_view.close()
    view = simulation.show(op)
    simulated(view)
    view.dock.slider.setValue(int(AT * view.dock.slider.maximum()))
    window("simulation", STAR)
    simulation.close()
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    window("panel")
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    finish, model = dome()
    window("finishing")
    select(finish.Document.Name, model.Name, upper(model.Shape)[0])
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(1000)
    window("inspect")


run(session)
