"""What test_advisor_dock.py runs in FreeCAD: the dock Finishing Advisor, from faces to operations,
with pictures in $EVENLOAD_GUI_OUT.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from finishing_parts import part, upper  # noqa: E402
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    begun,
    choose_units,
    click,
    is_enabled,
    later,
    panel_of_another,
    picture,
    press,
    result,
    run,
    toolbar_texts,
    until,
)


def select(obj, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(obj, name)
    if not names:
        FreeCADGui.Selection.addSelection(obj)


def shown():
    from evenload.gui import advisor

    return advisor._shown


def ended(view):
    """Waits until the comparison has ended."""
    until(lambda: not view.task.is_busy)


def texts(dock, column):
    """What a column shows, from the top."""
    model = dock.table.model()
    return [model.index(row, column).data() for row in range(model.rowCount())]


def sorted_by(dock, column, order):
    """The values of a column as they are sorted."""
    dock.table.sortByColumn(column, order)
    model = dock.table.model()
    return [model.index(row, column).data(QtCore.Qt.UserRole) for row in range(model.rowCount())]


def choose(dock, name):
    dock.table.selectRow(texts(dock, 0).index(name))
    later(50)


def headers(dock):
    model = dock.table.model()
    return [model.headerData(k, QtCore.Qt.Horizontal) for k in range(model.columnCount())]


def marked(dock):
    """How many cells of each column are in bold."""
    model = dock.table.model()
    return [
        sum(
            model.index(row, column).data(QtCore.Qt.FontRole) is not None
            for row in range(model.rowCount())
        )
        for column in range(model.columnCount())
    ]


def cut_off(dock):
    """The fields at the left whose right edge is hidden."""
    area = next(each for each in dock.widget().findChildren(QtGui.QScrollArea))
    seen = area.viewport().width()
    kinds = QtGui.QAbstractSpinBox, QtGui.QComboBox
    return [
        widget.metaObject().className()
        for kind in kinds
        for widget in area.widget().findChildren(kind)
        if widget.mapTo(area.viewport(), widget.rect().topRight()).x() >= seen
    ]


def operations(job):
    return [op.Name for op in job.Operations.Group]


def prefer(tolerance):
    """Has new operations begin with a tolerance in mm; None: with their own."""
    from evenload.gui import preferences

    (row,) = (row for row in preferences.ROWS if row.name == "Tolerance")
    preferences.keep_default(row, tolerance or preferences.own_default(row))


def follows(view, *changes):
    """Whether it compares anew after each of some changes."""
    found = []
    for change in changes:
        view.task.cancel()
        change()
        view.job.Document.recompute()
        later(100)
        found.append(view.task.is_busy)
    return found


def in_panel(view, op):
    """What is set while the operation's own panel is open, and after its Cancel."""
    found = {"before": [op.Strategy, op.Document.UndoCount]}
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later(300)
    choose(view.dock, "Contours outwards")
    click(view.dock.make)
    later(100)
    found["told"] = view.dock.told.text()
    page = op.ViewObject.Proxy.panel.featurePages[-1]
    found["set"] = [op.Strategy, page.widgets["Strategy"].currentText()]
    press(QtGui.QDialogButtonBox.Cancel)
    later(300)
    found["after"] = [op.Strategy, op.Document.UndoCount]
    return found


def session():
    from evenload import host
    from evenload.gui import advisor as command

    doc = begun(1500, 1000)
    result["actions"] = toolbar_texts()
    solid = doc.addObject("Part::Feature", "Dome")
    solid.Shape = part(True)
    doc.recompute()
    select(solid, upper(solid.Shape)[0])
    result["enabled"] = [is_enabled("EvenLoad_FinishingAdvisor")]  # without a job
    job, controller = host.create_job(doc, [solid], 10, 1632, 5100, 4)
    controller.Label = "Ball"
    controller.Tool = host.create_tool("ballend", {"Diameter": 10, "Flutes": 4})
    flat = host.cam().controller.Create("Flat")
    flat.Tool = host.create_tool("endmill", {"Diameter": 10, "Flutes": 4})
    flat.HorizFeed = flat.VertFeed = "1000 mm/min"
    flat.SpindleSpeed = 5000
    job.Proxy.addToolController(flat)
    doc.recompute()
    model = job.Model.Group[0]
    FreeCADGui.activeDocument().activeView().viewAxonometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.Selection.clearSelection()
    result["enabled"].append(is_enabled("EvenLoad_FinishingAdvisor"))
    result["provoked"].append("Select the faces that are to be finished")
    result["without_faces"] = command.show() is None and not shown()
    select(model, "Edge1")
    result["enabled"].append(is_enabled("EvenLoad_FinishingAdvisor"))
    select(model, *upper(model.Shape))
    result["enabled"].append(is_enabled("EvenLoad_FinishingAdvisor"))

    # Cancelled under way, then in whole. New operations begin with a tolerance that is preferred.
    prefer(0.02)
    FreeCADGui.runCommand("EvenLoad_FinishingAdvisor")
    view = shown()[0]
    dock = view.dock
    until(lambda: view.rows)
    picture("under_way")
    result["busy"] = [view.task.is_busy, dock.bar.isVisible()]
    click(dock.cancel)
    later(100)
    result["cancelled"] = [
        view.task.is_busy,
        len(view.rows),
        dock.told.text(),
        dock.bar.isVisible(),
    ]
    before = dock.asked.CuspHeight.value()
    dock.asked.machine.setCurrentIndex(1)
    dock.asked.Stepover.setValue(2.0)
    result["cusp_of_stepover"] = [before, dock.asked.CuspHeight.value()]
    dock.asked.CuspHeight.setValue(0.2)
    result["stepover_of_cusp"] = dock.asked.Stepover.value()
    later(50)
    ended(view)
    result["names"] = texts(dock, 0)
    result["headers"] = headers(dock)
    result["marked"] = marked(dock)
    result["sorted"] = {
        "%d %s" % (column, name): sorted_by(dock, column, order)
        for column in range(1, 11)
        for name, order in (("up", QtCore.Qt.AscendingOrder), ("down", QtCore.Qt.DescendingOrder))
    }
    result["cut_off"] = cut_off(dock)
    dock.table.sortByColumn(4, QtCore.Qt.AscendingOrder)
    result["can_make"] = [dock.make.isEnabled()]
    choose(dock, "Zig-zag 67.5°")
    result["can_make"].append(dock.make.isEnabled())
    picture("compared")

    # One click makes the operation, one undo takes it back.
    chosen = dock.chosen()
    with panel_of_another():
        click(dock.make)
        later(100)
        result["other_panel"] = [operations(job), dock.told.text()]
    click(dock.make)
    later(300)
    (name,) = operations(job)
    op = doc.getObject(name)
    result["made"] = {
        "settings": [op.Strategy, op.PassAngle.Value, op.Spacing, op.Stepover.Value],
        "valid": op.isValid(),
        "seconds": [op.CuttingTime, chosen.seconds],
        "tolerance": op.Tolerance.Value,
        "faces": [list(names) for _, names in op.Base],
        "told": dock.told.text(),
        "still": [len(view.rows), view.task.is_busy],
    }
    prefer(None)
    doc.undo()
    later(100)
    result["undone"] = operations(job)
    doc.redo()
    later(100)
    result["redone"] = operations(job)

    # A tool without a ball; another schema.
    dock.asked.controller.setCurrentIndex(1)
    later(200)
    result["flat_cusp"] = dock.lengths()["CuspHeight"]
    result["flat"] = [dock.told.text(), len(view.rows), view.task.is_busy, dock.make.isEnabled()]
    picture("flat")
    command.close()
    op = doc.getObject(operations(job)[0])
    choose_units(INCHES)
    select(op)
    result["enabled"].append(is_enabled("EvenLoad_FinishingAdvisor"))
    FreeCADGui.runCommand("EvenLoad_FinishingAdvisor")
    view = shown()[0]
    dock = view.dock
    result["of_operation"] = [dock.faces.text(), op.Label, dock.make.text()]
    ended(view)
    result["inches"] = [headers(dock), dock.asked.Stepover.text()]
    picture("inches")
    result["own_panel"] = in_panel(view, op)
    ended(view)
    choose(dock, "Contours inwards")
    click(dock.make)
    later(300)
    result["set"] = [op.Strategy, op.isValid(), len(operations(job))]
    doc.undo()
    later(100)
    result["set_undone"] = op.Strategy
    choose_units(METRIC)
    ended(view)  # which the undo has begun anew
    result["mm_again"] = [headers(dock), dock.asked.Stepover.text()]

    # A strategy that does not fit.
    from evenload.advisor import STRATEGIES, Advice

    view._show([Advice(STRATEGIES[0], refusal="It does not fit."), *view.rows[1:4]])
    result["refused"] = {
        name: [sorted_by(dock, 1, order)[-1], texts(dock, 11)[-1], texts(dock, 1)[-1]]
        for name, order in (("up", QtCore.Qt.AscendingOrder), ("down", QtCore.Qt.DescendingOrder))
    }
    choose(dock, STRATEGIES[0].name)
    result["refused"]["can_make"] = dock.make.isEnabled()

    # What changes meanwhile; the end.
    bit = controller.Tool
    result["again"] = follows(
        view,
        lambda: setattr(controller, "SpindleSpeed", 4000),
        lambda: setattr(op, "Tolerance", 0.03),
        lambda: setattr(op, "FinalDepth", op.FinalDepth.Value + 0.5),
        lambda: setattr(bit, "Flutes", 3),
        lambda: setattr(bit, "Diameter", 8),
        lambda: setattr(op, "Stepover", 1.5),
    )
    result["lengths"] = [view.dock.lengths(), op.Stepover.Value, op.CuspHeight.Value]
    view.task.cancel()
    dock.asked.Stepover.setValue(1.0)
    later(100)
    view.task.cancel()
    op.Strategy = "One way"  # each row has its own
    doc.recompute()
    later(100)
    result["not_again"] = [view.task.is_busy, dock.lengths()["Stepover"]]
    dock.close()
    later(100)
    result["closed"] = len(shown())
    select(model, *upper(model.Shape))
    FreeCADGui.runCommand("EvenLoad_FinishingAdvisor")
    later(100)
    result["opened"] = len(shown())
    FreeCAD.closeDocument(doc.Name)
    later(200)
    result["gone"] = len(shown())


run(session)
