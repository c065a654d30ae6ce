"""What test_panel.py runs in FreeCAD's GUI: the status on top of panels, what is folded, limits and
steps of fields, and how panels fit into a narrow dock.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_panels import fit_of, in_panel, opened, operation_on, picture  # noqa: E402
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    choose_units,
    click,
    fold_all,
    later,
    leave,
    press,
    result,
    run,
    until,
    workbench,
)

EXPRESSIONS = ("EntryPoint.x", "7 mm"), ("StockToLeave", "Sheet.A1 * 0.1 mm")
LAPTOP = 1366, 980  # pixels: what is above the report view is as high as all of a laptop's 768
COMMANDS = ("EvenLoad_Adaptive", "EvenLoad_Trochoid", "EvenLoad_LameSpiral")


def fits(operations):
    """What does not fit into a narrow dock: of each panel, width and unit schema, folded or not."""
    found = {}
    for schema in (METRIC, INCHES):
        choose_units(schema)
        for command, op in operations.items():
            fold_all()
            name = "%s %d" % (command, schema)
            found.update(in_panel(op, lambda page: fit_of(page, name)))
    choose_units(METRIC)
    found.update(in_low_window(next(iter(operations.values()))))
    return found


def in_low_window(op):
    """The same in a window as a laptop has it, in which the panel is to be scrolled."""
    window = FreeCADGui.getMainWindow()
    before = window.size()
    window.resize(*LAPTOP)
    fold_all()

    def look(page):
        seen = fit_of(page, "EvenLoad_Adaptive low")
        page.widgets["EngagementAngle"].setProperty("rawValue", 50.0)  # its status has two lines
        page.widgets["EngagementAngle"].editingFinished.emit()
        until(lambda: page.preview.state == "shown")
        later(100)
        return {**seen, **fit_of(page, "EvenLoad_Adaptive low,preview")}

    found = in_panel(op, look)
    window.resize(before)
    later()
    return found


def step_of(page, name):
    """What an arrow adds to a setting, in FreeCAD's own units."""
    before = getattr(page.obj, name).Value
    assert QtCore.QMetaObject.invokeMethod(page.widgets[name], "stepUp")
    later(50)
    return getattr(page.obj, name).Value - before


def typed(widget, text):
    """Types a text into a field and leaves it."""
    edit = widget.findChild(QtGui.QLineEdit)
    edit.setText(text)
    edit.textEdited.emit(text)
    leave(widget)
    widget.editingFinished.emit()
    later(50)


def strike(widget, text, *keys):
    """Types a text into a field by keys, in place of what it shows, and strikes further keys, of
    which Tab leaves the field.
    """
    edit = widget.findChild(QtGui.QLineEdit)
    widget.setFocus()
    edit.selectAll()
    if text is None:  # all but the unit is taken away
        edit.setSelection(0, edit.text().index(" "))
    for key, letter in [*((0, each) for each in text or ""), *((key, "") for key in keys)]:
        if key == QtCore.Qt.Key_Tab:  # of no effect where no window is active
            leave(widget)
        else:
            for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
                event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, letter)
                QtGui.QApplication.sendEvent(widget if key else edit, event)
        later(50)  # as nobody is faster


def fields(op):
    """Steps, limits and what unset fields show."""
    seen = {"steps": {}}
    for schema in (METRIC, INCHES):
        choose_units(schema)
        steps, seen["tolerance %d" % schema] = in_panel(op, steps_of)
        seen["steps"][schema] = steps
    seen["stepped"] = in_panel(op, lambda page: stepped(page, op))
    choose_units(METRIC)
    seen.update(in_panel(op, lambda page: taken(page, op)))
    seen["bound"] = in_panel(op, lambda page: bound(page, op))
    seen["bound_while_open"] = in_panel(op, lambda page: bound_while_open(page, op))
    seen["bound_before"] = [bound_before(op, *each) for each in EXPRESSIONS]
    return seen


def bound_before(op, path, expression):
    """What the status tells in a panel that opens with an expression, whose cell is gone."""
    sheet = op.Document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "3")
    op.Document.recompute()
    op.setExpression(path, expression)
    # FreeCAD 1.1 evaluates it at once.
    result["provoked"] += ["not found in 'Sheet.A1'", "in property binding 'Session#"]
    op.Document.removeObject(sheet.Name)
    op.touch()

    def look(page):
        until(lambda: page.preview.state not in (None, "computing"))
        return page.status.text()

    seen = in_panel(op, look)
    op.setExpression(path, None)
    return seen


def stepped(page, op):
    """Stock to leave and roll radius in inches: the texts, and mm, of three presses of a key each,
    and of a thousandth that is typed.
    """
    seen = {}
    for name in ("RollRadius", "StockToLeave"):
        box = page.widgets[name]
        page.folds.get("Turns", page.folds["Feeds"]).unfold()
        seen[name] = [[box.property("text"), getattr(op, name).Value]]
        for _ in range(3):
            assert QtCore.QMetaObject.invokeMethod(box, "stepUp")
            later(50)
            seen[name].append([box.property("text"), getattr(op, name).Value])
    box, tab, up, down = page.widgets["StockToLeave"], *(
        getattr(QtCore.Qt, "Key_" + name) for name in ("Tab", "Up", "Down")
    )
    seen["struck"] = {}
    for name, text, *keys in (
        ("a thousandth", "0.002 in", tab),
        ("then an arrow", ".003", up),
        ("and left", ".007", down, down, tab),
        ("down", ".003", tab, down, down, down, down),
        ("up again", ".004", tab, down, down, down, up),
        ("mm", "0.1 mm", tab),
        ("nothing", "", QtCore.Qt.Key_Backspace, tab),
        ("backspaces", "0.07", *5 * [QtCore.Qt.Key_Backspace], tab),
        ("number only", None, QtCore.Qt.Key_Backspace, tab),
        ("sum", "0.1 mm + 0.001 in*2 - 0.002 in", tab),
        ("below", "-5", tab),
        ("words", "five", tab),
        ("none", "0", tab),
    ):
        strike(box, text, *keys)
        seen["struck"][name] = [box.property("text"), op.StockToLeave.Value / 25.4]
    seen["other_units"] = in_other_units(page, op, box)
    return seen


def in_other_units(page, op, box):
    """Texts and mm of stock to leave with metric units, chosen while the panel is open, then with
    inches again; in between the field is left and seen again. Then of what is set elsewhere.
    """
    strike(box, "0.002", QtCore.Qt.Key_Tab)
    seen = []
    for schema in (METRIC, INCHES):
        choose_units(schema)
        later(100)
        box.hide()
        box.show()
        leave(box)
        later(100)
        seen.append([box.property("text"), op.StockToLeave.Value, box.property("minimum")])
    op.StockToLeave = 0.3
    box.hide()
    box.show()
    later(100)
    leave(box)
    page.getFields(op)
    seen.append(op.StockToLeave.Value)
    strike(box, "0", QtCore.Qt.Key_Tab)
    return seen


def bound_while_open(page, op):
    """What the fields show, and whether Apply can be pressed, once side step has an expression."""
    op.setExpression("SideStep", "OpToolDiameter * 0.3")
    later(100)
    seen = [page.widgets[n].property("text") for n in ("SideStep", "EngagementAngle")]
    seen += [page.widgets["EngagementAngle"].isEnabled(), page.isdirty, op.SideStep.Value]
    op.setExpression("SideStep", None)
    later(100)
    return [*seen, page.widgets["EngagementAngle"].isEnabled()]


def steps_of(page):
    names = ("EngagementAngle", "SideStep", "MaximumFeed", "RollRadius")
    return {name: step_of(page, name) for name in names}, page.widgets["Tolerance"].text()


def taken(page, op):
    """What fields take, and what they show of it."""
    names = ("HoleDiameter", "LeastLoad", "MostBlocksPerMetre")
    edits = [page.widgets[name].findChild(QtGui.QLineEdit) for name in names]
    seen = {"unset": [edit.text() or edit.placeholderText() for edit in edits]}
    seen["hole_enabled"] = [page.widgets["EntryPoint"].isEnabled()]
    typed(page.widgets["HoleDiameter"], "9 mm")
    seen["hole"] = op.HoleDiameter.Value
    seen["hole_enabled"].append(page.widgets["EntryPoint"].isEnabled())
    typed(page.widgets["HoleDiameter"], "0 mm")
    seen["unset_again"] = edits[0].text()
    typed(page.widgets["RollRadius"], "-5 mm")
    typed(page.widgets["EngagementAngle"], "200")
    seen["beyond"] = [
        op.RollRadius.Value,
        page.widgets["RollRadius"].property("text"),
        op.EngagementAngle.Value,
        page.widgets["EngagementAngle"].property("text"),
    ]
    page.engagement.share.setValue(50.0)
    page.engagement.share.editingFinished.emit()
    seen["share"] = [op.SideStep.Value, op.EngagementAngle.Value]
    return seen


def bound(page, op):
    """[enabled?, tooltip's end] of fields beside and under an expression, and what is left of an
    edit of the share.
    """
    seen = {}
    for name in ("EngagementAngle", "SideStep", "Tolerance"):
        before = getattr(op, name).Value
        op.setExpression(name, {"Tolerance": "0.02 mm"}.get(name, "%.17g" % before))
        page.refresh()
        names = ("EngagementAngle", "SideStep", "Tolerance", "RollRadius")
        seen[name] = {each: page.widgets[each].isEnabled() for each in names}
        seen[name]["share"] = page.engagement.share.isEnabled()
        seen[name]["tips"] = [page.widgets[each].toolTip().splitlines()[-1] for each in names]
        op.setExpression(name, None)
    page.refresh()
    seen["after"] = [page.widgets[each].isEnabled() for each in names]
    return seen


def remembered(op):
    """Whether what is unfolded is so in the next panel, and what is not, not."""
    fold_all()
    in_panel(op, lambda page: page.folds["Feeds"].unfold())
    return in_panel(op, lambda page: {name: fold.is_open() for name, fold in page.folds.items()})


def status(op):
    """The status through changes, failures and OK."""
    seen = {}
    fold_all()
    page = opened(op)
    seen["valid"] = page.status.text()
    seen["cycle_time"] = op.CycleTime
    seen["on_top"] = (
        page.status.top.mapToGlobal(QtCore.QPoint(0, 0)).y()
        < page.area.mapToGlobal(QtCore.QPoint(0, 0)).y()
        and not page.status.top.visibleRegion().isEmpty()
    )
    page.widgets["EngagementAngle"].setProperty("rawValue", 50.0)
    page.widgets["EngagementAngle"].editingFinished.emit()
    seen["changed"] = page.status.text()
    # OK with a value that no path can be computed from.
    op.MaximumFeed = "10 mm/min"
    press(QtGui.QDialogButtonBox.Ok)
    later()
    seen["open"] = bool(FreeCADGui.Control.activeDialog())
    seen["refused"] = page.status.text()
    field = page.widgets["MaximumFeed"]
    seen["field"] = [
        page.folds["Feeds"].is_open(),
        not field.visibleRegion().isEmpty(),
        "color" in page.labels["MaximumFeed"].styleSheet(),
        field.property("text")[:3],
    ]
    seen["path"] = len(op.Path.Commands)
    picture("refused")
    # Apply of the same.
    press(QtGui.QDialogButtonBox.Apply)
    later(500)
    seen["failed"] = [op.isValid(), page.status.text()]
    result["provoked"].append(op.Report)
    picture("failed")
    op.MaximumFeed = "510 mm/min"
    page.setDirty()
    press(QtGui.QDialogButtonBox.Apply)
    later(500)
    seen["mended"] = page.status.text()
    seen["unmarked"] = page.labels["MaximumFeed"].styleSheet() == ""
    # A refusal of FreeCAD's own depths leads to its page.
    for name in ("StartDepth", "FinalDepth", "StepDown", "SafeHeight", "ClearanceHeight"):
        op.setExpression(name, None)
    op.FinalDepth = 4.0
    page.setDirty()
    press(QtGui.QDialogButtonBox.Ok)
    later()
    seen["depth"] = page.status.text()
    page.follow(page.status._pieces[0])
    later(100)
    seen["depth_page"] = page.parent.form.currentWidget() is page.parent.featurePages[1].form
    op.FinalDepth = -3.0
    page.parent.form.setCurrentWidget(page.form)
    press(QtGui.QDialogButtonBox.Ok)
    later(500)
    seen["closed"] = not FreeCADGui.Control.activeDialog()
    return seen


def notes(page):
    """A click on a place that a note names; what is folded."""
    from pivy import coin

    seen = {"text": page.status.text(), "warnings": page.status._warnings.text()}
    seen["remarks_folded"] = not page.status._remarks.isVisible()
    piece = next(piece for piece in page.status._pieces if piece.place)
    number = page.status._pieces.index(piece)
    page.status._remarks.linkActivated.emit(str(number))
    later(200)
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    middle = camera.position.getValue() + ahead * camera.focalDistance.getValue()
    seen["place"], seen["middle"] = piece.place, list(middle.getValue())
    click(page.status._fold)
    later(100)
    seen["remarks_unfolded"] = page.status._remarks.isVisible()
    picture("remarks")
    return seen


def changed_elsewhere(op):
    """What is left at OK of what was changed beside the open panel, and computed."""
    before = op.CutMode
    opened(op)
    op.CutMode = "Conventional"
    op.Document.recompute()
    later(100)
    press(QtGui.QDialogButtonBox.Ok)
    later()
    left = op.CutMode
    op.CutMode = before
    op.Document.recompute()
    return left


def session():
    from evenload import host
    from models import SQUARE, block_with, face_of, floors_of, sketch_of

    workbench(1200, 1400)
    doc = FreeCAD.newDocument("Session")
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, _ = host.create_job(doc, [part], 6, 255, 6366, 1)
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    model = job.Model.Group[0]
    (floor,) = floors_of(model.Shape)
    operations = {c: operation_on(doc, job, model, floor, c) for c in COMMANDS}
    adaptive = operations["EvenLoad_Adaptive"]
    result["wide"] = fits(operations)
    result["fields"] = fields(adaptive)
    result["remembered"] = remembered(adaptive)
    result["changed_elsewhere"] = changed_elsewhere(adaptive)
    result["status"] = status(adaptive)
    result["job_time"] = job.CycleTime
    result["times"] = [op.CuttingTime for op in operations.values()]
    wedge = [(0, 0, 0), (40, 0, 0), (0, 12, 0)]  # whose tips no wished radius fits
    sketch = sketch_of(doc, wedge)
    adaptive.Base = [(sketch, "")]
    doc.recompute()
    result["notes"] = in_panel(adaptive, notes)
    choose_units(INCHES)
    result["notes in inches"] = in_panel(adaptive, notes)
    choose_units(METRIC)


run(session)
