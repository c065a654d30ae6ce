"""What test_gui.py runs in FreeCAD's GUI: uses the command and the panel as a user does, looks at
the results and writes them as JSON to $EVENLOAD_GUI_OUT/result.json, with pictures beside it.
"""

import os
import sys
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    OUT,
    answering,
    base_list,
    click,
    fold_all,
    later,
    picture,
    press,
    result,
    run,
    set_up,
    unfold_all,
    widgets,
    workbench,
)


def texts(menu):
    found = []
    for action in menu.actions():
        found.append(action.text().replace("&", ""))
        if action.menu():
            found += texts(action.menu())
    return found


def reopened():
    """A document that was made without a GUI: its operation gets a view provider on opening."""
    doc = FreeCAD.openDocument(os.environ["EVENLOAD_GUI_DOCUMENT"])
    op = next(o for o in doc.Objects if type(getattr(o, "Proxy", None)).__name__ == "Adaptive")
    result["reopened_view"] = type(op.ViewObject.Proxy).__name__
    job = op.Proxy.getJob(op)
    result["reopened_job_view"] = type(job.ViewObject.Proxy).__name__
    result["reopened_icon"] = os.path.isfile(op.ViewObject.Proxy.getIcon())
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later()
    result["reopened_panel"] = FreeCADGui.Control.activeDialog()
    picture("reopened")
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    result["reopened_kept"] = op.Name in [o.Name for o in doc.Objects]
    FreeCAD.closeDocument(doc.Name)


def cancelled(op):
    """Computes an operation, with a click on Cancel as soon as the dialog shows."""
    from evenload.gui import progress

    seen = []

    def press_cancel():
        for box in widgets(QtGui.QMessageBox):
            bar, button = box.findChild(QtGui.QProgressBar), box.button(QtGui.QMessageBox.Cancel)
            if not (box.isVisible() and bar and button):
                continue
            seen.append({"title": box.windowTitle(), "value": bar.value(), "modal": box.isModal()})
            box.grab().save(os.path.join(OUT, "progress.png"))
            click(button)

    delay, progress.DELAY = progress.DELAY, 0
    timer = QtCore.QTimer()
    timer.timeout.connect(press_cancel)
    timer.start(0)
    op.touch()
    op.Document.recompute()
    timer.stop()
    progress.DELAY = delay
    later()
    result["provoked"].append(op.Report)
    return {
        "dialogs": seen,
        "report": op.Report,
        "valid": op.isValid(),
        "uncut": op.UncutArea.Value,
        "path": op.Path.toGCode(),
    }


def waited():
    """A computation that asks often: how long until the dialog shows, and how long from a click on
    its Cancel until the computation is told to end. In seconds of the clock, and of this thread's
    work, since other programs may keep it waiting.
    """
    from evenload.gui import progress

    def dialogs():
        boxes = widgets(QtGui.QMessageBox)
        return [box for box in boxes if box.isVisible()]

    def times():
        return time.monotonic(), time.thread_time()

    def since(begin):
        return [now - before for now, before in zip(times(), begin)]

    begin = times()
    with progress.Watch("Long") as watch:
        while not dialogs() and since(begin)[0] < 20:
            assert watch(0.5)
        shown = since(begin)
        click(dialogs()[0].button(QtGui.QMessageBox.Cancel))
        begin = times()
        while watch(0.5) and since(begin)[0] < 20:
            pass
        answered = since(begin)
        still = watch(0.5)
    return {"shown": shown, "answered": answered, "asked_again": still, "left": len(dialogs())}


def choice_cancelled(two_jobs):
    """The command where FreeCAD asks for the job, or for the tool controller, and is answered by
    Cancel.
    """
    from models import SQUARE, block_with, face_of
    from evenload import host

    doc = FreeCAD.newDocument("Choice")
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6, 255, 6366, 1)
    if two_jobs:
        host.create_job(doc, [part], 6, 255, 6366, 1)
    else:
        job.Proxy.addToolController(doc.copyObject(controller))
    FreeCADGui.Selection.clearSelection()
    before = sorted(o.Name for o in doc.Objects)
    with answering(lambda dialog: dialog.reject()) as asked:
        FreeCADGui.runCommand("EvenLoad_Adaptive")
        later(500)
    after = sorted(o.Name for o in doc.Objects)
    panel = FreeCADGui.Control.activeDialog()
    FreeCAD.closeDocument(doc.Name)
    return {"asked": len(asked), "same": before == after, "panel": panel}


def other_panel(doc, job, model, floor, command):
    """The panel of another kind of operation: what it shows, takes and computes."""
    fold_all()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floor)
    FreeCADGui.runCommand(command)
    later(800)
    op = job.Operations.Group[-1]
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    first = [name for name, widget in page.widgets.items() if widget.isVisible()]
    unfold_all(page)
    seen = {
        "first": first,
        "view": type(op.ViewObject.Proxy).__name__,
        "icon": os.path.isfile(op.ViewObject.Proxy.getIcon()),
        "shown": [name for name, widget in page.widgets.items() if widget.isVisible()],
        "settings": [setting.name for setting in op.Proxy.settings],
    }
    for name in ("StartDepth", "FinalDepth", "StepDown"):
        op.setExpression(name, None)
    op.StartDepth, op.FinalDepth, op.StepDown = 0, -3, 3
    press(QtGui.QDialogButtonBox.Apply)
    later(500)
    seen["valid"], seen["commands"] = op.isValid(), len(op.Path.Commands)
    seen["results"] = page.status.text()
    seen["own_after_apply"] = list(op.OwnValues)
    picture(command)
    if op.Proxy.fitted:
        widget = page.widgets["ExponentEnd"]
        seen["fitted"] = widget.value(), op.ExponentEnd
        widget.setValue(0.9)
        widget.editingFinished.emit()
        seen["own_after_edit"], seen["set"] = list(op.OwnValues), op.ExponentEnd
        page.again.click()
        seen["own_after_again"] = list(op.OwnValues)
        course = page.widgets["ExponentCourse"]
        seen["courses"] = [(course.text(), list(op.ExponentCourse))]
        result["provoked"].append("Course of exponent takes numbers")
        for text in ("0; 0,25; 1", "0, 0.5, 1", "0; much", ""):
            course.setText(text)
            course.editingFinished.emit()
            seen["courses"].append((course.text(), list(op.ExponentCourse)))
    press(QtGui.QDialogButtonBox.Cancel)
    later(500)
    return seen


def controllers_of_the_list(job, op):
    """What the panel's list of tool controllers offers, and what becomes of the operation's when
    the last two are chosen that FreeCAD 1.1 adds: "Copy ..." and "New tool controller...".
    """
    from evenload import host

    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later()
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    combo = page.form.toolController
    seen = {
        "makes": host.LIST_MAKES_CONTROLLERS,
        "items": [combo.itemText(i) for i in range(combo.count())],
        "labels": [controller.Label for controller in job.Tools.Group],
        "chosen": [],
    }
    if host.LIST_MAKES_CONTROLLERS:
        for from_the_end in (2, 1):
            index = combo.count() - from_the_end
            with answering(lambda dialog: dialog.reject()):  # that for a new one's tool bit
                combo.setCurrentIndex(index)
                combo.activated.emit(index)
                later(500)
            seen["chosen"].append(
                [op.ToolController is not None, combo.currentText(), len(job.Tools.Group)]
            )
        page.form.editToolController.setChecked(True)
        later()
        picture("controller")
    press(QtGui.QDialogButtonBox.Cancel)
    later(500)
    return seen


def session():
    from models import SQUARE, block_with, face_of, floors_of, wire
    from evenload import host

    set_up()
    fold_all()
    reopened()
    workbench()
    window = FreeCADGui.getMainWindow()
    menus = {m.title().replace("&", ""): m for m in window.menuBar().findChildren(QtGui.QMenu)}
    result["menu"] = texts(menus[host.MENU.replace("&", "")])
    bars = [b for b in widgets(QtGui.QToolBar) if b.objectName() == host.TOOLBAR]
    result["toolbar"] = [a.text().replace("&", "") for b in bars for a in b.actions()]
    icons = [a.icon() for b in bars for a in b.actions() if "EvenLoad Adaptive" in a.text()]
    result["icon"] = bool(icons) and not icons[0].isNull()

    doc = FreeCAD.newDocument("Session")
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6, 255, 6366, 1)
    result["job_view"] = type(job.ViewObject.Proxy).__name__
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    model = job.Model.Group[0]
    (floor,) = floors_of(model.Shape)

    # A face, through the command.
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floor)
    FreeCADGui.runCommand("EvenLoad_Adaptive")
    later(800)
    op = job.Operations.Group[0]
    result["base"] = [list(names) for _, names in op.Base]
    result["view"] = type(op.ViewObject.Proxy).__name__
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    result["base_list"] = base_list(op)
    result["first"] = [name for name, widget in page.widgets.items() if widget.isVisible()]
    unfold_all(page)
    result["shown"] = [name for name, widget in page.widgets.items() if widget.isVisible()]
    result["tolerance_text"] = page.widgets["Tolerance"].text()
    picture("panel")

    # Editing one of the two that follow each other.
    page.widgets["EngagementAngle"].setProperty("rawValue", 90.0)
    page.widgets["EngagementAngle"].editingFinished.emit()
    result["side_step_property"] = op.SideStep.Value
    result["side_step_widget"] = page.widgets["SideStep"].property("rawValue")
    page.widgets["SideStep"].setProperty("rawValue", 1.5)
    page.widgets["SideStep"].editingFinished.emit()
    result["angle_property"] = op.EngagementAngle.Value
    combo = page.widgets["FeedControl"]
    result["feed_controls"] = [combo.itemText(i) for i in range(combo.count())]
    material = page.widgets["Material"]
    result["materials"] = [material.itemText(i) for i in range(material.count())]
    result["material_enabled"] = []
    for i in (1, 3):
        combo.setCurrentIndex(i)
        combo.activated.emit(i)
        result["material_enabled"].append(material.isEnabled())
    material.setCurrentIndex(2)
    material.activated.emit(2)
    result["material"] = op.Material
    combo.setCurrentIndex(1)
    combo.activated.emit(1)
    result["feed_control"] = op.FeedControl
    page.points["EntryPoint"][0].setProperty("rawValue", 12.0)
    page.points["EntryPoint"][0].editingFinished.emit()
    result["entry_point"] = list(op.EntryPoint)
    page.widgets["Arcs"].setChecked(False)
    result["arcs"] = op.Arcs
    page.widgets["Arcs"].setChecked(True)
    for name in ("StartDepth", "FinalDepth", "StepDown"):
        op.setExpression(name, None)
    op.StartDepth, op.FinalDepth, op.StepDown = 0, -3, 3
    press(QtGui.QDialogButtonBox.Apply)
    later(500)
    result["commands"] = len(op.Path.Commands)
    result["valid"] = op.isValid()
    result["results_text"] = page.status.text()
    result["angle_after_apply"] = op.EngagementAngle.Value
    picture("applied")
    press(QtGui.QDialogButtonBox.Ok)
    later(500)
    result["closed"] = not FreeCADGui.Control.activeDialog()

    result["controllers"] = controllers_of_the_list(job, op)

    # A sketch as a whole.
    sketch = doc.addObject("Sketcher::SketchObject", "Outline")
    for edge in wire([(2, 2, 0), (20, 2, 0), (20, 20, 0), (2, 20, 0)]).Edges:
        import Part

        sketch.addGeometry(Part.LineSegment(*(v.Point for v in edge.Vertexes)), False)
    sketch.Placement.Base.z = -3
    doc.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(sketch)
    FreeCADGui.runCommand("EvenLoad_Adaptive")
    later(800)
    second = job.Operations.Group[-1]
    result["sketch_base"] = [[o.Name, list(names)] for o, names in second.Base]
    picture("sketch")
    press(QtGui.QDialogButtonBox.Cancel)
    later(500)
    result["cancelled_is_gone"] = len(job.Operations.Group) == 1

    result["others"] = {
        command: other_panel(doc, job, model, floor, command)
        for command in ("EvenLoad_Trochoid", "EvenLoad_LameSpiral")
    }

    # Cancelled, then computed whole.
    result["cancel"] = cancelled(op)
    result["after_cancel"] = not QtGui.QApplication.activeModalWidget()
    op.touch()
    doc.recompute()
    result["whole"] = [op.Report, len(op.Path.Commands)]

    result["waited"] = waited()

    # An error shows its sentence.
    op.EngagementAngle = 200
    doc.recompute()
    result["error"] = op.Report
    result["provoked"].append(op.Report)
    result["error_valid"] = op.isValid()
    result["choices"] = [choice_cancelled(two_jobs) for two_jobs in (True, False)]


run(session)
