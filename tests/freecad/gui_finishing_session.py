"""What test_finishing_panel.py runs in FreeCAD's GUI: the finishing operation from its command to
its path, with pictures in $EVENLOAD_GUI_OUT.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from finishing_parts import part, upper  # noqa: E402
from gui_fit import resize_dock, too_wide  # noqa: E402
from gui_tools import (  # noqa: E402
    fold_all,
    later,
    picture,
    press,
    result,
    run,
    unfold_all,
    widgets,
    workbench,
)


NARROW = 264  # pixels: FreeCAD's own dock at first


def edit(page, name, value):
    """Types a value into a box of the panel."""
    widget = page.widgets[name]
    if widget.property("rawValue") is not None:
        widget.setProperty("rawValue", value)
    else:
        widget.setValue(value)
    widget.editingFinished.emit()


def surface_by_button(page):
    """[whether the button is there, how many views it shows, how many when pressed again]"""
    from evenload.gui import surface

    found = [page.load.isVisible()]
    for _ in range(2):
        page.load.click()
        later(50)
        found.append(len(surface._shown))
    return found


def fixtures_by_button(doc, op, page):
    """[names in the property, text of the button] with nothing selected, and with two objects."""
    boxes = []
    for name in ("Clamp", "Vice"):
        boxes.append(doc.addObject("Part::Box", name))
        boxes[-1].Placement.Base = FreeCAD.Vector(60, 60, 0)
    doc.recompute()
    for chosen in ([], boxes, boxes[:1]):
        FreeCADGui.Selection.clearSelection()
        for each in chosen:
            FreeCADGui.Selection.addSelection(doc.Name, each.Name)
        page.widgets["Fixtures"].click()
        later(50)
        clearance = page.widgets["FixtureClearance"].isEnabled()
        yield [each.Name for each in op.Fixtures], page.widgets["Fixtures"].text(), clearance
    FreeCADGui.Selection.clearSelection()


def session():
    from evenload import host

    workbench()
    bars = [b for b in widgets(QtGui.QToolBar) if b.objectName() == host.TOOLBAR]
    icons = [a.icon() for b in bars for a in b.actions() if "EvenLoad Finishing" in a.text()]
    result["icon"] = bool(icons) and not icons[0].isNull()
    doc = FreeCAD.newDocument("Session")
    solid = doc.addObject("Part::Feature", "Part")
    solid.Shape = part(True)
    doc.recompute()
    job, controller = host.create_job(doc, [solid], 10, 1650, 5100, 4)
    controller.Tool = host.create_tool("ballend", {"Diameter": 10})
    model = job.Model.Group[0]
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.Selection.clearSelection()
    for name in upper(model.Shape):
        FreeCADGui.Selection.addSelection(doc.Name, model.Name, name)
    fold_all()
    FreeCADGui.runCommand("EvenLoad_Finishing")
    later(800)
    op = job.Operations.Group[0]
    result["base"] = [list(names) for _, names in op.Base]
    result["view"] = type(op.ViewObject.Proxy).__name__
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    result["first"] = [name for name, widget in page.widgets.items() if widget.isVisible()]
    picture("folded")
    unfold_all(page)
    result["shown"] = [name for name, widget in page.widgets.items() if widget.isVisible()]
    result["settings"] = [setting.name for setting in op.Proxy.settings]
    result["at_first"] = op.Stepover.Value, op.CuspHeight.Value
    edit(page, "Stepover", 3.0)
    result["cusp_of_stepover"] = op.CuspHeight.Value, page.widgets["CuspHeight"].value()
    edit(page, "CuspHeight", 0.1)
    result["stepover_of_cusp"] = op.Stepover.Value, page.widgets["Stepover"].property("rawValue")
    edit(page, "PassAngle", 90.0)
    press(QtGui.QDialogButtonBox.Apply)
    later(500)
    result["valid"], result["commands"] = op.isValid(), len(op.Path.Commands)
    result["results"] = page.status.text()
    result["surface"] = surface_by_button(page)
    picture("finishing")
    result["fixtures"] = list(fixtures_by_button(doc, op, page))
    resize_dock(page, NARROW)
    result["too_wide"] = too_wide(page)
    picture("narrow")
    press(QtGui.QDialogButtonBox.Ok)
    later(500)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    picture("path")

    gate = op.ViewObject.Proxy.getSelectionFactory()
    gate()
    FreeCADGui.Selection.clearSelection()
    walls = [n for n, f in enumerate(model.Shape.Faces, 1) if abs(f.normalAt(0, 0).z) < 1e-9]
    for name in ("Face%d" % walls[0], "Edge1", upper(model.Shape)[0]):
        FreeCADGui.Selection.addSelection(doc.Name, model.Name, name)
    result["picked"] = list(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames)
    result["wanted"] = ["Edge1", upper(model.Shape)[0]]  # edges may be guides
    FreeCADGui.Selection.removeSelectionGate()


run(session)
