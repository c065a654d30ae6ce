"""Pictures of FreeCAD's window with EvenLoad in it; ./run screenshots starts it in FreeCAD.

$EVENLOAD_GUI_OUT is the folder that gets them.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from screenshot_tools import OUT, WINDOW, done, later, select, window  # noqa: E402

from finishing_parts import part, upper  # noqa: E402
from gui_tools import answering, begun, press, run  # noqa: E402
from models import case_model, corpus_case, floors_of  # noqa: E402
from screenshot_windows import WIDE, cut_windows, first_pocket, panels_of_spirals  # noqa: E402

DIALOG = 900, 700
STAR, AT = 48, 0.35  # mm of height of the star's pocket; the tool's place along the path


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


def session():
    from evenload.gui import advisor, load_view, simulation, surface

    doc = begun(*WINDOW)
    preferences()
    first_pocket()
    FreeCAD.setActiveDocument(doc.Name)
    FreeCADGui.activateView("Gui::View3DInventor", True)
    op = star(doc)
    view = load_view.show(op)
    done(view)
    view.dock.slider.setValue(int(AT * view.dock.slider.maximum()))
    window("load", STAR)
    load_view.close()
    view = simulation.show(op)
    done(view)
    view.dock.slider.setValue(int(AT * view.dock.slider.maximum()))
    window("simulation", STAR)
    simulation.close()
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    window("panel")
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    panels_of_spirals()
    cut_windows()
    finish, model = dome()
    window("finishing")
    select(finish)
    FreeCADGui.runCommand("EvenLoad_FinishingAdvisor")
    later(300)
    done(advisor._shown[-1])
    window("advisor", width=WIDE)
    advisor.close()
    finish.Stepover = 0.5
    finish.Document.recompute()
    finish.ViewObject.Visibility = False  # its path would hide the colours
    view = surface.show(finish)
    done(view)
    window("surface")
    view.dock.choice.setCurrentIndex(view.dock.choice.findData("rz_across"))
    window("surface_roughness")
    surface.close()
    select(model, upper(model.Shape)[0])
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(1000)
    window("inspect")


run(session, are_views_plain=False)
