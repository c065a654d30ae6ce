"""What test_recording.py runs in FreeCAD's GUI: an operation is made in its panel, and what the
macro recorder is told meanwhile is kept.
"""

import contextlib
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import OUT, later, press, result, run, set_up  # noqa: E402


@contextlib.contextmanager
def recording(file):
    """While this lasts, what is told to FreeCAD's macro recorder is done as ever, and written to a
    file: its own dialog would need a user.
    """
    before = FreeCADGui.doCommand, FreeCADGui.addModule
    lines = []

    def do(line):
        lines.append(line)
        before[0](line)

    def add(module):
        lines.append("import " + module)
        before[1](module)

    FreeCADGui.doCommand, FreeCADGui.addModule = do, add
    try:
        yield
    finally:
        FreeCADGui.doCommand, FreeCADGui.addModule = before
        with open(file, "w") as out:
            out.write("\n".join(lines) + "\n")


def set_in_panel(op):
    """Edits an operation whose panel is open, and has the panel show it."""
    op.EngagementAngle, op.FeedControl, op.LinkFeed = 45, "Constant removal rate", "1200 mm/min"
    op.setExpression("StepDown", None)
    op.StepDown = 1.5
    op.setExpression("LinkLift", "OpToolDiameter * 0.1")
    op.setExpression("StockToLeave", "OpToolDiameter * 0.05")
    op.setExpression("EntryPoint.x", "7 mm")
    for page in op.ViewObject.Proxy.panel.featurePages:
        page.setFields(op)


def session():
    from evenload import host
    from models import SQUARE, block_with, face_of, floors_of

    set_up()
    FreeCADGui.activateWorkbench(host.WORKBENCH)
    later(500)
    doc = FreeCAD.newDocument("Session")
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, _ = host.create_job(doc, [part], 6, 255, 6366, 1)
    doc.saveCopy(os.path.join(OUT, "job.FCStd"))

    model = job.Model.Group[0]
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floors_of(model.Shape)[0])
    with recording(os.path.join(OUT, "recorded.FCMacro")):
        FreeCADGui.runCommand("EvenLoad_Adaptive")
        later(600)
        op = job.Operations.Group[-1]
        set_in_panel(op)
        press(QtGui.QDialogButtonBox.Ok)
        later(500)
        # Once more: a number takes the place of an expression.
        op.ViewObject.Document.setEdit(op.ViewObject, 0)
        later(300)
        op.setExpression("StockToLeave", None)
        op.StockToLeave = 0.1
        press(QtGui.QDialogButtonBox.Ok)
        later(500)
    result["valid"] = op.isValid()
    result["own"] = list(op.OwnValues)
    result["expressions"] = sorted(map(list, op.ExpressionEngine))
    result["path"] = op.Path.toGCode()


run(session)
