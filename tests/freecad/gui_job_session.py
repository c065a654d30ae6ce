"""What test_job_panel.py runs in FreeCAD's GUI: a job from its dialog, an operation from a click on
a body's face, the Job panel with its six pages, Op Defaults, Cancel; and the same with a document
opened in another process. $EVENLOAD_GUI_STAGE says which.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from FreeCAD import Vector
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    OUT,
    answering,
    base_list,
    click,
    later,
    leave,
    picture,
    press,
    result,
    run,
    widgets,
)

OURS = "EvenLoad Adaptive"
DIALOGS_OK = QtGui.QDialogButtonBox.Ok
CANCEL = QtGui.QDialogButtonBox.Cancel


def accept(dialog):
    """Answers a dialog as who presses Enter does."""
    for box in dialog.findChildren(QtGui.QDialogButtonBox):
        if box.button(DIALOGS_OK):
            box.button(DIALOGS_OK).click()
            return
    dialog.accept()


def plate():
    """A document with a body: a plate with a pocket of 30 x 24 mm, 4 mm deep."""
    from models import body_with_pockets

    doc = FreeCAD.newDocument("Plate")
    body = body_with_pockets(doc, 60, 50, [("Pocket", 15, 13, 30, 24, 4)])
    doc.recompute()
    for feature in body.Group:
        feature.ViewObject.Visibility = feature is body.Tip
    return doc, body


def click_at(point, job, body):
    """A click on a point of the body in the 3D view; what it selected, [[object, names]]."""
    FreeCADGui.Selection.clearSelection()
    # FreeCAD's versions differ in which of them they show.
    for obj in (*job.Model.Group, *job.Operations.Group, job.Stock):
        obj.ViewObject.Visibility = False
    body.ViewObject.Visibility = True
    view = FreeCADGui.activeDocument().activeView()
    view.viewTop()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    later(800)
    x, y = view.getPointOnScreen(point)
    viewport = view.graphicsView().viewport()
    click(viewport, QtCore.QPointF(x, viewport.height() - 1 - y))
    later(300)
    chosen = FreeCADGui.Selection.getSelectionEx()
    return [[item.Object.Name, list(item.SubElementNames)] for item in chosen]


def click_command(name):
    """A click on one of our buttons in the toolbar."""
    from evenload import host

    window = FreeCADGui.getMainWindow()
    for bar in widgets(QtGui.QToolBar):
        if bar.objectName() != host.TOOLBAR:
            continue
        window.insertToolBarBreak(bar)  # a line of its own, or our buttons do not fit
        later(200)
        for action in bar.actions():
            if name in action.text():
                button = bar.widgetForAction(action)
                assert button.isVisible()
                click(button)
                later(800)
                return
    raise AssertionError("no button '%s'" % name)


def job_panel(job):
    """Opens the job's panel; its pages."""
    job.ViewObject.Document.setEdit(job.ViewObject, 0)
    later()
    return form_of(job.ViewObject.Proxy.taskPanel)


def form_of(panel):
    """The pages of a job's panel that is open. FreeCAD 0.20 never lets go of them, and PySide does
    not learn of the end of their lists' items, which are no QObjects: it would take what is made in
    the place of one for that item, and the next panel would fail to open. So they are taken out of
    the lists as the panel ends.
    """
    cleanup = panel.cleanup

    def without_items(*arguments):
        for each in panel.form.findChildren(QtGui.QListWidget):
            while each.count():
                each.takeItem(0)
        for each in panel.form.findChildren(QtGui.QTableWidget):
            for column in range(each.columnCount()):
                each.takeHorizontalHeaderItem(column)
                for row in range(each.rowCount()):
                    each.takeItem(row, column)
        cleanup(*arguments)

    panel.cleanup = without_items
    return panel.form


def pages(form, name):
    """The titles of the panel's pages, all shown one after the other."""
    titles = []
    for number in range(form.count()):
        form.setCurrentIndex(number)
        later(150)
        assert form.currentWidget().isVisible()
        titles.append(form.tabText(number))
        if name:
            picture("%s_%d" % (name, number))
    return titles


def op_defaults(form, name):
    """The table of Op Defaults for an operation."""
    form.setCurrentWidget(form.tabOpDefaults)
    form.opDefaultOp.setCurrentIndex(form.opDefaultOp.findText("Op " + name))
    later(200)
    tables = [t for t in form.tabOpDefaults.findChildren(QtGui.QTableView) if t.isVisible()]
    assert len(tables) == 1
    return tables[0]


def rows(table):
    """{property: (whether it is set, the text of its value)} of a table of Op Defaults."""
    model = table.model()
    return {
        model.item(row, 1).text(): (
            model.item(row, 0).checkState() == QtCore.Qt.Checked,
            str(model.index(row, 2).data()),
        )
        for row in range(model.rowCount())
    }


def set_default(table, name, value=None):
    """Sets one of Op Defaults: ticks it, opens its editor, and puts a value in. None: ticks it and
    opens the editor only, and takes the tick away again.
    """
    model = table.model()
    row = next(r for r in range(model.rowCount()) if model.item(r, 1).text() == name)
    model.item(row, 0).setCheckState(QtCore.Qt.Checked)
    cell = model.index(row, 2)
    table.scrollTo(cell)
    table.edit(cell)
    later(50)
    editors = [
        w
        for w in table.viewport().findChildren(QtGui.QWidget)
        if w.isVisible() and isinstance(w, (QtGui.QLineEdit, QtGui.QComboBox))
    ]
    assert editors, "no editor for " + name
    editor = editors[0]
    if value is not None:
        if isinstance(editor, QtGui.QComboBox):
            editor.setCurrentText(value)
        else:
            editor.setText(value)
    kind = editor.metaObject().className()
    leave(editor)
    later(50)
    if value is None:
        model.item(row, 0).setCheckState(QtCore.Qt.Unchecked)
    return kind


def names(doc):
    return sorted(o.Name for o in doc.Objects)


def adaptives(doc):
    return [o for o in doc.Objects if type(getattr(o, "Proxy", None)).__name__ == "Adaptive"]


def cancelled_panel(doc, job, name):
    """What the Job panel shows, and whether Cancel loses anything. name: of its pages' pictures."""
    before = names(doc)
    form = job_panel(job)
    seen = {"active": FreeCADGui.Control.activeDialog(), "pages": pages(form, name)}
    seen["rows"] = rows(op_defaults(form, OURS))
    picture("our_defaults")
    press(CANCEL)
    later()
    seen["kept"] = names(doc) == before and not FreeCADGui.Control.activeDialog()
    seen["valid"] = [op.isValid() for op in adaptives(doc)]
    return seen


def defaults_set(job):
    """Opens each editor of our defaults, sets some, and leaves the panel open; (the editors'
    classes, the names in the table of FreeCAD's Adaptive). Keeps nothing of the panel: what PySide
    knows of it would be taken for what is made in its place when it is gone.
    """
    form = job_panel(job)
    table = op_defaults(form, OURS)
    editors = {name: set_default(table, name) for name in rows(table)}
    for name, value in (
        ("EngagementAngle", "45 deg"),
        ("StockToLeave", "0.4 mm"),
        ("CutMode", "Conventional"),
        ("Arcs", "false"),
    ):
        set_default(table, name, value)
    picture("op_defaults")
    freecads_rows = sorted(rows(op_defaults(form, "Adaptive")))
    picture("op_defaults_of_freecad")
    return editors, freecads_rows


def fresh():
    """A user's first session."""
    from evenload import host

    with answering(accept) as result["first_dialogs"]:
        FreeCADGui.activateWorkbench(host.WORKBENCH)
        later(800)
    doc, body = plate()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(body)
    with answering(accept) as result["job_dialogs"]:
        FreeCADGui.runCommand("CAM_Job" if host.WORKBENCH == "CAMWorkbench" else "Path_Job")
        later(800)
    job = next(o for o in doc.Objects if o.Name.startswith("Job"))
    result["new_job_panel"] = FreeCADGui.Control.activeDialog()
    result["new_job_pages"] = pages(form_of(job.ViewObject.Proxy.taskPanel), None)
    press(DIALOGS_OK)
    later()
    controller = job.Tools.Group[0]
    controller.HorizFeed = controller.VertFeed = "255 mm/min"
    controller.SpindleSpeed = 6366
    host.set_rapid_feed(controller, 5000)
    doc.recompute()

    # An operation from a click on the floor, and one on the button.
    result["clicked"] = click_at(Vector(30, 25, 8), job, body)
    picture("clicked")
    click_command(OURS)
    (op,) = job.Operations.Group
    model = job.Model.Group[0]
    result["base"] = [[o.Name, list(found)] for o, found in op.Base]
    result["model"] = model.Name
    result["base_list"] = base_list(op)
    picture("operation")
    with answering(accept) as result["operation_dialogs"]:
        press(DIALOGS_OK)
        later(500)
    result["valid"], result["report"] = op.isValid(), op.Report
    result["commands"] = len(op.Path.Commands)

    # It follows the model.
    boxes = []
    for x in (0, 200):
        model.Placement.Base.x = x
        doc.recompute()
        assert op.isValid(), op.Report
        places = [[c.Parameters.get(a) for c in op.Path.Commands] for a in "XYZ"]
        ends = [[v for v in axis if v is not None] for axis in places]
        boxes.append([*map(min, ends), *map(max, ends)])
    result["boxes"] = boxes
    model.Placement.Base.x = 0
    doc.recompute()

    doc.saveAs(os.path.join(OUT, "job.FCStd"))


def opened():
    """(the document that $EVENLOAD_GUI_DOCUMENT names, its job)."""
    from evenload import host

    with answering(accept):
        FreeCADGui.activateWorkbench(host.WORKBENCH)
        later(800)
        doc = FreeCAD.openDocument(os.environ["EVENLOAD_GUI_DOCUMENT"])
        later(500)
    return doc, next(o for o in doc.Objects if o.Name.startswith("Job"))


# FreeCAD 0.20 never lets go of the widgets of its panels, and PySide may take what is made in the
# places of those for them: the third panel or the fourth may fail to open. So each of the following
# is a session of its own, in which at most one Job panel opens.


def panel():
    """The Job panel of the first session's document, cancelled."""
    doc, job = opened()
    result["panel"] = cancelled_panel(doc, job, "job_panel")


def defaults():
    """Defaults of ours for operations to come, set in the Job panel and saved."""
    doc, job = opened()
    result["editors"], result["freecads_rows"] = defaults_set(job)
    press(DIALOGS_OK)
    later()
    doc.save()


def second():
    """A second operation in that document, which is saved."""
    doc, job = opened()
    (op,) = job.Operations.Group
    body = next(o for o in doc.Objects if o.TypeId == "PartDesign::Body")
    result["clicked"] = click_at(Vector(30, 25, 8), job, body)
    click_command(OURS)
    second = job.Operations.Group[-1]
    result["second"] = {
        "new": second is not op and second.Name != op.Name,
        "EngagementAngle": second.EngagementAngle.Value,
        "SideStep": second.SideStep.Value,
        "StockToLeave": second.StockToLeave.Value,
        "CutMode": second.CutMode,
        "Arcs": second.Arcs,
        "diameter": second.OpToolDiameter.Value,
    }
    press(DIALOGS_OK)
    later(500)
    result["second"]["valid"] = second.isValid()
    result["first_kept"] = [op.EngagementAngle.Value, op.CutMode]

    # One that is cancelled, and saved so.
    second.Proxy.progress = lambda share: False
    second.touch()
    doc.recompute()
    result["provoked"].append(second.Report)
    result["cancelled"] = state_of(second)
    doc.save()


def state_of(op):
    return {
        "valid": op.isValid(),
        "uncut": op.UncutArea.Value,
        "report": op.Report,
        "path": op.Path.toGCode().split(),
    }


def again():
    """A later session with a saved document."""
    from evenload import host

    doc, job = opened()
    result["states"] = [state_of(op) for op in adaptives(doc)]
    result["posted"] = host.post(job, "linuxcnc", "--no-show-editor")
    result["panel"] = cancelled_panel(doc, job, None)
    doc.recompute()
    result["all_valid"] = [op.isValid() for op in adaptives(doc)]


STAGES = (fresh, panel, defaults, second, again)
run({stage.__name__: stage for stage in STAGES}[os.environ["EVENLOAD_GUI_STAGE"]])
