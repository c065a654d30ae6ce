"""What test_hole_pick.py runs in FreeCAD's GUI: clicks on a hole and beside it in the 3D view."""

import os
import sys

import FreeCADGui
import numpy
from FreeCAD import Vector
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import begun, click, later, picture, press, result, run, unfold_all  # noqa: E402

CANCEL = QtGui.QDialogButtonBox.Cancel
HOLE = 9.0, 21.0, 8.5  # x, y, diameter, in the floor of the pocket


def at_rest(view):
    """Waits until a view has its size, and its camera stands still."""
    seen = None
    for _ in range(100):
        now = view.getSize(), view.getCamera()
        if now == seen:
            return
        seen = now
        later(100)
    raise RuntimeError("The 3D view does not come to rest.")


def click_at(place):
    """Clicks where the 3D view shows a place."""
    from evenload.gui import picking

    view = FreeCADGui.activeDocument().activeView()
    at_rest(view)
    size, viewport = view.getSize(), view.graphicsView().viewport()
    pixels, _ = picking.pixels_of(view.getCameraNode(), size, numpy.array([place], float))
    x, y = pixels[0] / viewport.devicePixelRatioF()
    click(viewport, QtCore.QPoint(round(x), round(viewport.height() - 1 - y)))
    later(150)


def nodes_in_scene():
    scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
    return scene.getNumChildren()


def session():
    import Part
    from evenload import host
    from evenload.operations import adaptive
    from models import DEPTH, SQUARE, block_with, face_of, floors_of

    doc = begun(1300, 1000)
    x, y, diameter = HOLE
    drill = Part.makeCylinder(diameter / 2, 20, Vector(x, y, -20))
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE)).cut(drill)
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6, 255, 6366, 1)
    op = adaptive.Create("Pocket", parentJob=job, toolController=controller)
    model = job.Model.Group[0]
    op.Base = [(model, tuple(floors_of(model.Shape)))]
    doc.recompute()
    FreeCADGui.activeDocument().activeView().viewTop()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    later(300)
    before = nodes_in_scene()
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later(300)
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    unfold_all(page)
    page.live.setChecked(False)
    button, base = page.hole.button, list(op.Base)

    def taken():
        place = op.EntryPoint
        return [place.x, place.y, op.HoleDiameter.Value, button.isChecked()]

    seam = x + diameter / 2, y, -DEPTH  # where the circle begins
    rim = x - diameter / 2, y, -DEPTH
    click_at(rim)
    result["not_asked"] = taken()
    button.click()
    result["asks"] = [button.isChecked(), nodes_in_scene() - before]
    click_at((200, 200, 0))  # beside the part
    result["nothing"] = taken()
    click_at(rim)
    result["rim"] = taken()
    result["fields"] = [page.widgets["HoleDiameter"].property("text")] + [
        box.property("text") for box in page.points["EntryPoint"]
    ]
    picture("rim")
    click_at((20, 5, -DEPTH))
    result["ended"] = taken()
    op.EntryPoint, op.HoleDiameter = Vector(), 0
    button.click()
    click_at(seam)
    result["seam"] = taken()
    button.click()
    click_at((20, 5, -DEPTH))
    result["floor"] = taken()
    result["base"] = op.Base == base
    op.Entry = "Helix"
    page.setFields(op)
    result["helix"] = button.isEnabled()
    op.Entry = "Automatic"
    page.setFields(op)
    side = page.open_side.button
    op.Entry = "Helix"
    page.setFields(op)
    result["side_offered"] = [side.isEnabled()]
    op.Entry = "Automatic"
    page.setFields(op)
    result["side_offered"].append(side.isEnabled())
    side.click()
    click_at((20, 5, -DEPTH))
    result["side"] = [op.OpenSideAt.x, op.OpenSideAt.y, op.ChooseOpenSide, side.isChecked()]
    result["side_fields"] = [box.property("text") for box in page.points["OpenSideAt"]]
    picture("side")
    op.Entry = "Automatic"
    page.setFields(op)
    button.click()
    press(CANCEL)
    later(300)
    result["left"] = nodes_in_scene() - before
    result["cancelled"] = [op.EntryPoint.x, op.HoleDiameter.Value]


run(session)
