"""What test_optimise_dock.py runs in FreeCAD's GUI: the dock Optimise."""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    begun,
    choose_units,
    later,
    ours_and_theirs,
    panel_of_another,
    picture,
    press,
    result,
    run,
    toolbar_texts,
    unfold_all,
    until,
    widgets,
)

NAME = "EvenLoad_Optimise"


def docks():
    from evenload.gui import optimise_dock

    shown = [w for w in widgets(QtGui.QDockWidget) if w.objectName() == optimise_dock.NAME]
    return len([w for w in shown if w.isVisible()])


def select(*objects):
    FreeCADGui.Selection.clearSelection()
    for each in objects:
        FreeCADGui.Selection.addSelection(each)
    later(50)


def is_active(*objects):
    select(*objects)
    return bool(FreeCADGui.Command.get(NAME).isActive())


def shown():
    from evenload.gui import optimise

    return optimise._shown[-1]


def command(op):
    select(op)
    FreeCADGui.runCommand(NAME)
    later(100)
    return shown()


def quick(view):
    """Few paths, so that it does not take long."""
    view.dock.to_try.angles.setText("50; 70")
    view.dock.to_try.levels.setValue(1)


def suggested(view):
    """Presses Suggest and waits; the window has to be alive meanwhile."""
    view.dock.suggest.click()
    until(lambda: not view.task.is_busy)


def state(op):
    controller = op.ToolController
    return {
        "angle": op.EngagementAngle.Value,
        "step": op.StepDown.Value,
        "speed": controller.SpindleSpeed,
        "feed": 60 * controller.HorizFeed.Value,
        "time": op.CuttingTime,
        "valid": op.isValid(),
    }


def tool_of(view):
    from evenload.gui import optimise_inputs

    return optimise_inputs.tool_of(view.dock.tool)


def cells(view):
    model = view.dock.model
    return [
        [model.index(row, column).data() for column in range(model.columnCount())]
        for row in range(model.rowCount())
    ]


def titles(view):
    model = view.dock.model
    return [model.headerData(k, QtCore.Qt.Horizontal) for k in range(model.columnCount())]


def sorted_by(view, title):
    """The numbers of the column as it stands after its heading was clicked, up and down."""
    dock, found = view.dock, []
    column = titles(view).index(title)
    for order in (QtCore.Qt.AscendingOrder, QtCore.Qt.DescendingOrder):
        dock.table.sortByColumn(column, order)
        found.append([dock.model.shown[column].number(row) for row in dock.model.rows])
    chosen = dock.table.currentIndex().row()
    return found, dock.model.rows[chosen] is view.chosen


def numbers_of(candidate):
    return {
        "angle": candidate.engagement_deg,
        "step": candidate.axial_depth,
        "speed": candidate.spindle_speed,
        "feed": candidate.feed,
        "force": candidate.force_peak_n,
    }


def taken(view, op):
    """Take, undo and redo; what the dock says meanwhile."""
    before = state(op)
    seen = {"before": before, "wanted": numbers_of(view.chosen)}
    undone = op.Document.UndoCount
    view.dock.take.click()
    later(500)  # longer than it waits after a change
    seen["after"], seen["steps"] = state(op), op.Document.UndoCount - undone
    seen["told"], seen["still"] = view.dock.told.text(), len(view.dock.model.rows)
    op.Document.undo()
    later(500)
    seen["undone"], seen["cleared"] = state(op), len(view.dock.model.rows)
    seen["asks"] = view.dock.told.text()
    op.Document.redo()
    later(500)
    seen["redone"] = state(op)
    return seen


def followed(view, op):
    """How many rows there are before and after changes to operation, tool bit, machine and part."""
    bit, part = op.ToolController.Tool, op.Base[0][0]
    machine = view.dock.limits.machine
    changes = (
        lambda: setattr(op, "HoleDiameter", 8),
        lambda: setattr(op, "StockToLeave", 0.2),
        lambda: setattr(bit, "Diameter", 5.8),
        lambda: setattr(bit, "Flutes", 3),
        machine.taken.emit,
        lambda: setattr(part, "Shape", part.Shape.scaled(0.9)),
    )
    op.EntryPoint = (12, 11, 0)
    before = op.HoleDiameter, op.StockToLeave, bit.Diameter, bit.Flutes, part.Shape.copy()
    found = []
    for change in changes:
        suggested(view)
        found.append([view.dock.told.text(), len(cells(view))])
        change()
        later(500)
        found[-1].append(len(cells(view)))
    op.HoleDiameter, op.StockToLeave, bit.Diameter, bit.Flutes, part.Shape = before
    op.Document.recompute()
    later(500)
    return found


def without_path(job):
    """Of an operation that has no path, nor base geometry: whether the command is active, and what
    the dock tells where the panel opens it.
    """
    from evenload.gui import optimise
    from evenload.operations import adaptive

    empty = adaptive.Create("Empty", parentJob=job)
    found = [is_active(empty)]
    view = optimise.show(empty)
    found += [view.dock.told.text(), view.dock.take.isEnabled()]
    view.dock.suggest.click()
    later(100)
    found += [view.dock.told.text(), view.task.is_busy]
    empty.Document.removeObject(empty.Name)
    later(300)
    return [*found, docks()]


def in_panel(op):
    """Suggest… in the panel: what is taken shows there; Cancel takes it back, OK is one step."""
    found = {"before": state(op)}
    for name, button in (
        ("cancelled", QtGui.QDialogButtonBox.Cancel),
        ("accepted", QtGui.QDialogButtonBox.Ok),
    ):
        undone = op.Document.UndoCount
        op.ViewObject.Document.setEdit(op.ViewObject, 0)
        later(300)
        page = op.ViewObject.Proxy.panel.featurePages[-1]
        unfold_all(page)
        page.suggest.click()
        later(100)
        view = shown()
        quick(view)
        view.dock.tool.most_speed.set_mm(140)
        suggested(view)
        wanted = numbers_of(view.chosen)
        view.dock.take.click()
        later(500)
        found[name] = {
            "open": bool(FreeCADGui.Control.activeDialog()),
            "wanted": wanted,
            "shown": page.widgets["EngagementAngle"].property("rawValue"),
            "set": state(op),
            "told": view.dock.told.text(),
        }
        if name == "accepted":
            picture("panel")
        press(button)
        later(500)
        found[name]["left"] = state(op)
        found[name]["steps"] = op.Document.UndoCount - undone
    op.Document.undo()
    op.Document.recompute()
    later(300)
    found["undone"] = state(op)
    return found


def session():
    from evenload import host
    from models import face_of, rectangle

    doc = begun(1390, 1100)
    doc.UndoMode = 1
    job, ours, theirs = ours_and_theirs(doc, face_of(rectangle(0, 0, 30, 22)))
    ours.setExpression("StepDown", None)
    ours.StepDown = 1.5
    doc.recompute()
    result["actions"] = toolbar_texts().count("EvenLoad Optimise")
    before = list(job.Operations.Group)
    dressed = host.dressed("Boundary", ours)
    doc.recompute()
    result["active"] = [is_active(), is_active(ours), is_active(theirs), is_active(dressed)]
    result["active"].append(is_active(ours, theirs))
    result["under"] = command(dressed).operation is ours
    job.Operations.Group = before
    doc.removeObject(dressed.Name)
    doc.recompute()
    later(300)
    view = command(ours)
    result["shown"], result["tool"] = docks(), tool_of(view)
    quick(view)
    suggested(view)
    result["now"] = [numbers_of(view.now), state(ours), view.now.time_s]
    result["told"], result["compared"] = view.dock.told.text(), view.dock.compared.text()
    result["titles"], result["cells"] = titles(view), cells(view)
    result["best"] = [numbers_of(view.chosen), view.dock.table.currentIndex().row()]
    result["force"], result["kept_row"] = sorted_by(view, "Force, N")
    picture("suggested")
    view.dock.table.selectRow(2)
    later(50)
    result["clicked"] = view.chosen is view.dock.model.rows[2]
    result["compared_after"] = view.dock.compared.text()
    with panel_of_another():
        before = [state(ours), doc.UndoCount]
        view.dock.take.click()
        later(100)
        result["other_panel"] = [before, [state(ours), doc.UndoCount], view.dock.told.text()]
    result["taken"] = taken(view, ours)
    # Limits that refuse all, a machine, inches, what cannot be, Cancel.
    limits = view.dock.limits
    limits.max_force.setValue(1)
    suggested(view)
    result["refused"] = [view.dock.told.text(), view.dock.take.isEnabled(), cells(view)]
    limits.max_force.setValue(120)
    limits.machine.setCurrentIndex(limits.machine.findData("linuxcnc_mill"))
    suggested(view)
    result["machine"] = titles(view)
    choose_units(INCHES)
    result["inches"] = [titles(view), view.dock.tool.max_chip_thickness.suffix(), tool_of(view)]
    result["inch_cells"], result["rows"] = cells(view)[0], numbers_of(view.dock.model.rows[0])
    picture("inches")
    choose_units(METRIC)
    view.dock.to_try.angles.setText("50; 190")
    view.dock.suggest.click()
    later(50)
    result["angles"] = view.dock.told.text()
    view.dock.to_try.angles.setText("30; 45; 60; 75; 90")
    view.dock.to_try.levels.setValue(4)
    view.dock.suggest.click()
    later(20)
    result["busy"] = [view.task.is_busy, view.dock.bar.isVisible()]
    view.dock.cancel.click()
    later(300)
    result["cancelled"] = [view.task.is_busy, view.dock.told.text(), view.dock.bar.isVisible()]
    view.task.worker.join()
    # What is kept: a new dock begins with it.
    view.dock.tool.most_speed.set_mm(135)
    quick(view)
    suggested(view)
    view = command(ours)
    result["kept"] = [tool_of(view)["most_speed"], view.dock.limits.max_force.value()]
    result["kept"].append(view.dock.to_try.angles.text())
    view.dock.limits.max_force.setValue(0)
    # A tool without a diameter, and a change outside.
    suggested(view)
    ours.EngagementAngle = 44
    later(500)
    result["changed"] = [cells(view), view.dock.told.text()]
    # FreeCAD 1.1 fails with its own operation while the part is another one.
    doc.removeObject(theirs.Name)
    result["followed"] = followed(view, ours)
    ours.ToolController.Tool.Diameter = 0
    view.dock.suggest.click()
    later(100)
    result["no_diameter"] = [view.dock.told.text(), view.task.is_busy]
    ours.ToolController.Tool.Diameter = 6
    doc.recompute()
    later(500)
    result["empty"] = without_path(job)
    result["panel"] = in_panel(ours)
    # It goes with its operation's document, also while it computes, and by its user.
    view = command(ours)
    view.dock.close()
    later(200)
    result["closed"] = docks()
    view = command(ours)
    view.dock.to_try.levels.setValue(4)
    view.dock.to_try.angles.setText("30; 45; 60; 75; 90")
    view.dock.suggest.click()
    later(20)
    worker = view.task.worker
    result["busy_at_close"] = worker.is_busy
    FreeCAD.closeDocument(doc.Name)
    later(300)
    worker.join()
    later(300)
    result["document_closed"] = docks()


run(session)
