"""Further pictures for docs/screenshots.py: the first pocket step by step, the panels of Trochoid
and Lamé spiral, the windows Optimise and Stability chart.
"""

import os

import FreeCAD
import FreeCADGui
from gui_tools import OUT, later, press
from models import body_with_pockets, case_model, corpus_case, floors_of
from PySide import QtGui
from screenshot_tools import done, select, until, window

EXAMPLES = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), os.pardir, "examples", "tap_%s.csv"
)
POCKET = "Pocket", 20, 15, 60, 40, 6  # its place, width, length and depth in a plate, mm
TOP = 12  # mm of the plate
MODES = {"name": "6 mm end mill, 30 mm out"}
CHART = 1120, 900  # pixels
AT = 0.3  # of the path: where the tool is
WIDE = 1640  # pixels of the window, so that all columns of a table are seen


def first_pocket():
    """The steps of docs/first_pocket.md, by the commands that it names."""
    from evenload import host
    from evenload.gui import load_view

    doc = FreeCAD.newDocument("FirstPocket")
    body = body_with_pockets(doc, 100, 70, [POCKET])
    doc.recompute()
    for each in doc.findObjects("Sketcher::SketchObject"):
        each.Visibility = False
    FreeCADGui.activeDocument().activeView().viewIsometric()
    window("first_body")
    job, controller = host.create_job(doc, [body], 8.0, 800.0, 8000, 2)
    controller.Label = "8 mm end mill"
    job.Stock.ViewObject.Visibility = body.ViewObject.Visibility = False
    model = job.Model.Group[0]
    model.ViewObject.Visibility = True
    (floor,) = floors_of(model.Shape, TOP - POCKET[-1])
    select(model, floor)
    FreeCADGui.runCommand("EvenLoad_Adaptive")
    op = job.Operations.Group[-1]
    until(lambda: op.ViewObject.Proxy.panel is not None)
    form = op.ViewObject.Proxy.panel.form
    form.setCurrentIndex(form.count() - 1)
    until(lambda: op.ViewObject.Proxy.panel.featurePages[-1].preview.state == "shown")
    window("first_panel")
    press(QtGui.QDialogButtonBox.Ok)
    later()
    model.ViewObject.DisplayMode = "Wireframe"
    FreeCADGui.Selection.clearSelection()
    view = load_view.show(op)
    done(view)
    view.dock.slider.setValue(int(AT * view.dock.slider.maximum()))
    window("first_path")
    load_view.close()
    FreeCAD.closeDocument(doc.Name)


def _operation(kind, shape, base, diameter, **properties):
    """An operation of a kind on floors of a shape, or on a sketch, in a document of its own."""
    from importlib import import_module

    from evenload import host

    doc = FreeCAD.newDocument(kind.title().replace("_", ""))
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = shape
    doc.recompute()
    job, controller = host.create_job(doc, [part], diameter, 720.0, 9000, 2)
    model = job.Model.Group[0]
    made = import_module("evenload.operations." + kind)
    op = made.Create(made.NAME.replace(" ", ""), parentJob=job, toolController=controller)
    op.Base = base(doc, model)
    for name, value in properties.items():
        setattr(op, name, value)
    doc.recompute()
    model.ViewObject.Transparency = 70
    job.Stock.ViewObject.Visibility = False
    FreeCADGui.activeDocument().activeView().viewTop()
    return op


def _floors(doc, model):
    return [(model, tuple(floors_of(model.Shape)))]


def _panel(op, name):
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later(600)
    window(name)
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    FreeCAD.closeDocument(op.Document.Name)


def panels_of_spirals():
    """The panels of Trochoid, in a slot, and of Lamé spiral, in a square pocket."""
    slot = case_model(corpus_case("slot9"))
    _panel(_operation("trochoid", slot, _floors, 6.0), "trochoid")
    square = case_model(corpus_case("lame_square35"))
    _panel(_operation("lame_spiral", square, _floors, 6.0), "lame_spiral")


def cut_windows():
    """The dock Optimise with a suggestion, and the window Stability chart with a tap test."""
    from evenload import job_stability
    from evenload.dynamics import vibration
    from evenload.gui import optimise, stability

    op = _operation("adaptive", case_model(corpus_case("square60")), _floors, 6.0)
    op.Material = "Al7075-T6"
    op.Document.recompute()
    view = optimise.show(op)
    view.dock.suggest.click()
    done(view)
    window("optimise", width=WIDE)
    optimise.close()
    tests = [{"file": EXAMPLES % axis[0], "axis": axis, "modes": 2} for axis in ("xx", "yy")]
    job_stability.keep(op.ToolController, vibration.load({**MODES, "tap_tests": tests}))
    op.Document.recompute()
    select(op)
    shown = stability.create()
    shown.resize(*CHART)
    until(lambda: not shown.worker.is_busy and not shown.timer.isActive())
    shown.find_best()
    until(lambda: not shown.searcher.is_busy and not shown.timer.isActive())
    later(500)
    shown.grab().save(os.path.join(OUT, "stability.png"))
    stability.close()
    FreeCAD.closeDocument(op.Document.Name)
