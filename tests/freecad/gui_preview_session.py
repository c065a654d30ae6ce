"""What test_preview.py runs in FreeCAD's GUI: the live preview through changes, Apply, Cancel, and
whatever may be taken away meanwhile. Its times stand in the result, for no test depends on them;
with EVENLOAD_PREVIEW_FIGURES set they are of what takes longest.
"""

import os
import random
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_preview_tools import (  # noqa: E402
    CANCEL,
    Ticks,
    cancelled,
    colours,
    content,
    gone_widgets,
    job_with,
    memory,
    nodes,
    opened,
    picture,
    shown,
    state,
    turn,
)
from gui_tools import click, later, press, result, run, until, wait, workbench  # noqa: E402

OK, APPLY = QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Apply
CHANGES, BETWEEN = 20, 100  # ms: 20 changes in 2 s
ANGLE = 30.0  # degrees: takes long, in a large pocket
# mm of a pocket that takes long, moments of Cancel in it, previews for the memory.
LARGE, MOMENTS, MANY = (300, 10, 200) if "EVENLOAD_PREVIEW_FIGURES" in os.environ else (80, 4, 60)


def follows(doc, op, ticks):
    """Many changes, one after the other, and Cancel."""
    before = content(doc, "before")
    path = op.Path.toGCode()
    page = opened(op)
    seen = {"opened": [page.preview.state, nodes(op)]}
    computed = []
    preview = op.Proxy.preview
    op.Proxy.preview = lambda obj: computed.append(obj.EngagementAngle.Value) or preview(obj)
    ticks.reset()
    for k in range(CHANGES):
        turn(op, 40 + k)
        seen.setdefault("states", []).append(state(op))
        wait(BETWEEN)
    turn(op, 70)
    seen["seconds"] = until(lambda: shown(op))
    seen["gap"] = ticks.taken()
    del op.Proxy.preview
    seen["computed"] = computed
    seen["status"] = page.status.text()
    seen["nodes"] = nodes(op)
    seen["path_kept"] = op.Path.toGCode() == path
    seen["colours"] = len(colours(page))
    picture("shown")
    turn(op, 30)
    seen["grey"] = [state(op), len(colours(page)), page.status.text()]
    picture("computing")
    until(lambda: shown(op))
    op.setExpression("FinalDepth", None)
    op.FinalDepth = 5.0
    until(lambda: state(op) == "refused")
    seen["refused"] = [page.status.text(), nodes(op), len(colours(page))]
    picture("refused")
    press(CANCEL)
    later(100)
    seen["left"] = nodes(op)
    seen["same"] = content(doc, "after") == before
    seen["state"] = list(op.State)
    return seen


def applied(doc, op):
    """Apply of what the preview shows, of what it does not show yet, and OK; Cancel after Apply."""
    seen, generate = {"runs": []}, type(op.Proxy).generate
    before = content(doc, "before")

    def counted(*arguments):
        seen["runs"][-1] += 1
        return generate(op.Proxy, *arguments)

    page = opened(op)
    op.Proxy.generate = counted
    for angle, is_shown in ((50, True), (55, False)):
        seen["runs"].append(0)
        turn(op, angle)
        if is_shown:
            until(lambda: shown(op))
        press(APPLY)
        later(100)
        seen.setdefault("reports", []).append(op.Report)
        seen.setdefault("valid", []).append([op.isValid(), page.status.text().splitlines()[0]])
        seen.setdefault("widgets", []).append(gone_widgets(page))
    seen["nodes"] = nodes(op)
    press(CANCEL)
    later(100)
    seen["same"] = content(doc, "after") == before
    seen["cancelled_runs"] = seen["runs"][-1]
    opened(op)
    seen["runs"].append(0)
    turn(op, 45)
    until(lambda: shown(op))
    press(OK)
    later()
    seen["ok"] = [op.EngagementAngle.Value, op.isValid(), nodes(op)]
    del op.Proxy.generate
    path, op.Proxy.known = op.Path.toGCode(), None
    op.touch()
    doc.recompute()
    seen["same_path"] = op.Path.toGCode() == path
    return seen


def stepped(op):
    """Arrows, keys and typing in fields, with what is set after each, and the preview's state."""
    page, seen = opened(op), {}
    for name, box in (
        ("angle", page.widgets["EngagementAngle"]),
        ("share", page.engagement.share),
        ("left", page.widgets["StockToLeave"]),
    ):
        done = seen[name] = []
        arrow = box.rect().topRight() + QtCore.QPoint(-6, box.height() // 4)
        for step in (
            lambda: click(box, arrow),
            lambda: key(box, QtCore.Qt.Key_Up),
            lambda: key(box, QtCore.Qt.Key_Down),
            lambda: key(box, QtCore.Qt.Key_2, "2"),  # typed, and not done
        ):
            step()
            later(20)
            values = op.EngagementAngle, op.SideStep, op.StockToLeave
            done.append([round(value.Value, 2) for value in values])
    seen["state"] = state(op)
    until(lambda: shown(op))
    press(CANCEL)
    later(100)
    return seen


def key(box, code, text=""):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, code, QtCore.Qt.NoModifier, text)
        QtGui.QApplication.sendEvent(box, event)


def elsewhere(doc, op):
    """OK and Cancel while another document is the active one, which has an object of that name."""
    before, seen = op.EngagementAngle.Value, {}
    other = FreeCAD.newDocument("Beside")
    double = other.addObject("App::FeaturePython", op.Name)
    for button in (OK, CANCEL):
        FreeCAD.setActiveDocument(doc.Name)
        opened(op)
        turn(op, 63 if button == OK else 44)
        until(lambda: shown(op))
        FreeCAD.setActiveDocument(other.Name)
        press(button)
        later(100)
        seen[str(button == OK)] = [
            op.EngagementAngle.Value,
            list(op.State),
            op.ViewObject.Proxy.panel is None,
            FreeCAD.ActiveDocument is other,
            [each.Name for each in other.Objects] == [double.Name],
        ]
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(doc.Name)
    later()
    op.EngagementAngle = before
    doc.recompute()
    return seen


def undone(doc, op):
    """Undo with the panel open, a change after it and Cancel: is the path that of what is left?"""
    before = op.EngagementAngle.Value
    opened(op)
    turn(op, 44)
    until(lambda: shown(op))
    doc.undo()
    later(100)
    op.EngagementAngle = 47
    press(CANCEL)
    later(100)
    left, is_computed = op.Path.toGCode(), op.State == ["Up-to-date"]
    op.touch()
    doc.recompute()
    seen = {"is computed": is_computed, "angle": op.EngagementAngle.Value}
    seen["is its path"] = op.Path.toGCode() == left
    op.EngagementAngle = before
    doc.recompute()
    return seen


def switched(op):
    """The box Live preview, which is remembered."""
    page = opened(op)
    page.live.setChecked(False)
    turn(op, 65)
    wait(200)
    seen = [page.preview.state, nodes(op), page.status.text().splitlines()[0]]
    press(CANCEL)
    later(100)
    page = opened(op)
    seen.append(page.live.isChecked())
    page.live.setChecked(True)
    turn(op, 65)
    until(lambda: shown(op))
    press(CANCEL)
    later(100)
    return seen


def many(op):
    """MB of this process through many previews, which follow each other without a delay."""
    preview, seen = opened(op).preview, []
    preview._delay.setInterval(0)
    for k in range(MANY):
        preview.restart()
        until(lambda: preview.state == "shown")
        if k % (MANY // 4) == MANY // 4 - 1:
            later(10)
            seen.append(memory())
    press(CANCEL)
    later(100)
    return seen


def large(op, ticks):
    """What takes long: the window stays alive, and Cancel comes at once at any moment."""
    seen, chance = {"cancel": [], "kept": []}, random.Random(1)
    path = op.Path.Size
    opened(op)
    ticks.reset()
    turn(op, ANGLE)
    seen["seconds"] = until(lambda: shown(op))
    seen["gap"] = ticks.taken()
    picture("large")
    ticks.reset()
    press(APPLY)
    seen["apply_gap"] = ticks.taken()
    seen["applied"] = op.isValid() and op.Path.Size > path
    press(CANCEL)
    opened(op)
    seen["idle_cancel"] = cancelled()
    for _ in range(MOMENTS):
        opened(op)
        turn(op, ANGLE)
        wait(chance.randrange(50, int(1000 * min(max(seen["seconds"], 0.2), 1.5))))
        seen["cancel"].append(cancelled())
        seen["kept"].append(op.Path.Size == path and op.State == ["Up-to-date"])
    later()
    return seen


def taken_away(doc, job, op):
    """The base, the tool, the operation and the document, while there is a preview."""
    seen = {}
    for name, remove in (
        ("base", lambda: doc.removeObject(job.Model.Group[0].Name)),
        ("tool", lambda: doc.removeObject(op.ToolController.Name)),
    ):
        count = len(doc.Objects)
        page = opened(op)
        turn(op, 48)
        until(lambda: shown(op))
        remove()
        until(lambda: state(op) == "refused")
        seen[name] = [page.preview.sentence]
        press(OK)
        later(100)
        seen[name] += [bool(FreeCADGui.Control.activeDialog()), seen[name][0] in page.status.text()]
        press(CANCEL)
        later(100)
        seen[name] += [len(doc.Objects) == count, op.isValid(), op.Path.Size > 10]
    seen["two"] = two_panels(doc, job, op)
    other_doc, _, other = job_with("Other", 30.0)
    opened(other)
    turn(other, 48)
    other_doc.removeObject(other.Name)
    wait(300)
    FreeCADGui.Control.closeDialog()
    later()
    FreeCAD.closeDocument(other_doc.Name)
    closing, _, third = job_with("Closing", 60.0)
    opened(third)
    turn(third, 20)
    wait(120)
    FreeCAD.closeDocument(closing.Name)
    later()
    seen["closed"] = [FreeCADGui.Control.activeDialog(), op.isValid()]
    FreeCAD.setActiveDocument(doc.Name)
    return seen


def two_panels(doc, job, op):
    """The panel of a second operation, which FreeCAD opens in place of the first one's."""
    from evenload.operations import adaptive

    second = adaptive.Create("Second", parentJob=job, toolController=job.Tools.Group[0])
    second.Base = op.Base
    doc.recompute()
    opened(op)
    turn(op, 48)
    until(lambda: shown(op))
    opened(second)
    turn(second, 48)
    until(lambda: shown(second))
    seen = [op.ViewObject.Proxy.panel is None, nodes(op), op.isValid(), op.EngagementAngle.Value]
    press(CANCEL)
    later(100)
    doc.removeObject(second.Name)
    return seen


def session():
    workbench(1300, 1000)
    ticks = Ticks()
    doc, job, op = job_with("Session", 60.0)
    result["follows"] = follows(doc, op, ticks)
    result["applied"] = applied(doc, op)
    result["switched"] = switched(op)
    result["stepped"] = stepped(op)
    result["elsewhere"] = elsewhere(doc, op)
    result["undone"] = undone(doc, op)
    result["taken_away"] = taken_away(doc, job, op)
    _, _, small_op = job_with("Small", 20.0)
    result["memory"] = many(small_op)
    _, _, large_op = job_with("Large", LARGE)
    result["large"] = large(large_op, ticks)


run(session)
