"""What test_stability_window.py runs in FreeCAD's GUI: the window Stability chart, from a tap test
to the operation.
"""

import os
import sys
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    answering,
    choose_units,
    click,
    later,
    picture,
    press,
    result,
    run,
    toolbar_texts,
    until,
)

TAP = os.environ["EVENLOAD_TAP_TEST"]


def grab(widget, name):
    widget.grab().save(os.path.join(OUT, name + ".png"))


def settled(window):
    """Waits until the chart and its verdict are there."""
    until(lambda: not window.worker.is_busy and not window.timer.isActive())


def text_of(window):
    return window.told.text()


def in_inches(window):
    """What the window tells with inches, beside the values; and with mm again."""
    best, read = window.best, window.read
    seen = {"best": [best.depth, best.removal_rate, best.surface_location_error, read.removal_rate]}
    before = window.asked().depth, window._box()
    for name, schema in (("inches", INCHES), ("mm", METRIC)):
        choose_units(schema)
        seen[name] = {
            "told": [window.told.text(), window.found.text()],
            "boxes": [box.text() for box in (window.cut.depth, window.chart.to_depth)],
            "error": window.limits.error.suffix(),
            "axis": window.view.drawn().get_ylabel(),
            "ticks": [each.get_text() for each in window.view.drawn().get_yticklabels()],
            "is_same": (window.asked().depth, window._box()) == before,
        }
        grab(window, "stability_" + name)
    return seen


def cut_off(window):
    """The widgets of the settings whose right edge is hidden."""
    area = window.findChild(QtGui.QScrollArea)
    seen = area.viewport().width()
    kinds = QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QPushButton, QtGui.QTableWidget
    return [
        widget.metaObject().className()
        for kind in kinds
        for widget in area.widget().findChildren(kind)
        if widget.isVisible()
        and widget.mapTo(area.viewport(), widget.rect().topRight()).x() >= seen
    ]


def state(op):
    controller = op.ToolController
    return {
        "speed": controller.SpindleSpeed,
        "feed": 60 * controller.HorizFeed.Value,
        "plunge": 60 * controller.VertFeed.Value,
        "step": op.StepDown.Value,
        "mode": op.CutMode,
        "valid": op.isValid(),
    }


def longest_gap(is_so):
    """The longest time in ms between two ticks of a timer while something is not yet true."""
    ticks = [time.monotonic()]
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: ticks.append(time.monotonic()))
    timer.start(5)
    until(is_so)
    timer.stop()
    return 1e3 * max(b - a for a, b in zip(ticks, ticks[1:]))


def alone(window):
    """Seconds that the first grid and all of them take with nothing else to do."""
    began, times = time.monotonic(), []
    from evenload.stability import field

    for _ in field.levels(window.asked(), *window._box()):
        times.append(time.monotonic() - began)
    return times[0], times[-1]


def a_job():
    from models import DEPTH, case_model, corpus_case, floors_of
    from evenload import host
    from evenload.operations import adaptive

    doc = FreeCAD.newDocument("Star")
    doc.UndoMode = 1
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = case_model(corpus_case("star"))
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6.0, 600.0, 9000, 2)
    model = job.Model.Group[0]
    pocket = host.freecads("PocketShape", "Pocket", job, controller)
    pocket.Base = [(model, tuple(floors_of(model.Shape)))]
    for name, value in (("StartDepth", 0), ("FinalDepth", -DEPTH), ("StepDown", DEPTH)):
        pocket.setExpression(name, None)
        setattr(pocket, name, value)
    doc.recompute()
    op = adaptive.Create("Star", parentJob=job, toolController=controller)
    op.Base = [(model, tuple(floors_of(model.Shape)))]
    for name, value in (("StartDepth", 0), ("FinalDepth", -DEPTH), ("StepDown", DEPTH)):
        op.setExpression(name, None)
        setattr(op, name, value)
    doc.recompute()
    pocket.ViewObject.Visibility = False
    return doc, job, op, pocket


def tap_test(window):
    """Loads the tap test by the dialog, as a user does."""
    from evenload.gui import stability_modes

    def use(dialog):
        if not hasattr(dialog, "fitted"):
            return
        seen = {"asks": dialog.told.text(), "ok_before": dialog.ok.isEnabled()}
        dialog.unit.setCurrentIndex(dialog.unit.findData("um/N"))
        later(100)
        seen["fitted"] = dialog.told.text()
        grab(dialog, "tap_test")
        seen["ok"] = dialog.ok.isEnabled()
        result["tap"] = seen
        dialog.ok.click()

    chosen = QtGui.QFileDialog.getOpenFileName
    try:
        stability_modes.QtGui.QFileDialog.getOpenFileName = staticmethod(lambda *_: (TAP, ""))
        with answering(use):
            button = next(
                b for b in window.modes.findChildren(QtGui.QPushButton) if "Tap" in b.text()
            )
            click(button)
    finally:
        stability_modes.QtGui.QFileDialog.getOpenFileName = chosen


def session():
    from evenload import host
    from evenload.gui import stability
    from evenload.stability import operation as read

    with answering(lambda dialog: dialog.accept()):  # what FreeCAD asks new users
        FreeCADGui.activateWorkbench(host.WORKBENCH)
        later(800)
    result["provoked"].append("SetupSheet has no support for Pocket")  # FreeCAD's own words
    doc, job, op, pocket = a_job()
    result["actions"] = toolbar_texts()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_StabilityChart")
    later(300)
    window = stability._Open.window
    result["empty"] = window.view.message
    grab(window, "empty")

    tap_test(window)
    settled(window)
    result["rows"] = window.modes.table.rowCount()
    result["kept"] = [mode.frequency for mode in read.kept(op.ToolController).modes]
    result["verdict"], result["stable"] = text_of(window), window.view.is_stable
    grab(window, "chart")
    result["cut_off"] = cut_off(window)
    picture("in_freecad")

    # How quickly it follows.
    firsts, alls = [], []
    for angle in (62, 64, 66):
        window.view.field = None
        began = time.monotonic()
        window.cut.engagement.setValue(angle)
        until(lambda: window.view.field is not None)
        firsts.append(time.monotonic() - began)
        until(lambda: window.view.field is not None and window.view.field.share == 1)
        alls.append(time.monotonic() - began)
        settled(window)
    result["first"], result["all"] = min(firsts), min(alls)
    result["alone"] = min(alone(window) for _ in firsts)
    gaps = []
    for angle in (68, 69, 70):
        window.cut.engagement.setValue(angle)
        gaps.append(longest_gap(lambda: not window.worker.is_busy))
        settled(window)
    result["gap"] = min(gaps)
    cancels = []
    for angle in (71, 72, 73, 74, 75):
        window.cut.engagement.setValue(angle)
        later(60)
        began = time.monotonic()
        window.worker.cancel()
        window.worker.join()
        cancels.append(time.monotonic() - began)
    result["cancel"] = sorted(cancels)
    window.cut.engagement.setValue(60)
    settled(window)

    # A click, Apply, undo and redo.
    before = state(op)
    fields = window.view.field
    limits = fields.limits()
    column = max(range(len(limits)), key=lambda k: min(limits[k], 1e3) * (k > 10))
    target = float(fields.speeds[column]), 0.6 * min(float(limits[column]), fields.depths[-1])
    click(window.view, window.view.pixel_of(target))
    settled(window)
    result["clicked"] = [*window.view.point, *target]
    result["boxes"] = [window.cut.speed.value(), window.cut.depth.value()]
    result["before"], result["between"] = before, state(op)
    grab(window, "clicked")
    click(window.apply_button)
    settled(window)
    result["after"] = state(op)
    result["after_verdict"] = text_of(window)
    doc.undo()
    doc.recompute()
    result["undone"] = state(op)
    doc.redo()
    doc.recompute()
    result["redone"] = state(op)

    # The best cut.
    window.limits.margin.setValue(15)
    click(window.best_button)
    until(lambda: not window.searcher.is_busy and window.best is not None)
    settled(window)
    best = window.best
    result["best"] = [best.speed, best.depth, best.cut_mode, best.spectral_radius]
    result["best_text"] = window.found.text()
    result["best_boxes"] = [
        window.cut.speed.value(),
        window.cut.depth.value(),
        window.cut.cut_mode.currentData(),
    ]
    grab(window, "best")
    result["units"] = in_inches(window)
    click(window.apply_button)
    settled(window)
    result["best_taken"], result["best_verdict"] = state(op), text_of(window)

    # A double click takes a cut at once.
    target = best.speed, 0.5 * best.depth
    place = window.view.pixel_of(target)
    click(window.view, place)
    double = QtGui.QMouseEvent(
        *(
            QtCore.QEvent.MouseButtonDblClick,
            place,
            QtCore.QPointF(window.view.mapToGlobal(place.toPoint())),
        ),
        *(QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier),
    )
    QtGui.QApplication.sendEvent(window.view, double)
    settled(window)
    result["double"] = [*target, state(op)["speed"], state(op)["step"]]

    # What cannot be, one sentence each.
    window.modes.table.item(0, 2).setText("-3")
    later(100)
    result["wrong"] = text_of(window)
    grab(window, "wrong")
    window.modes.table.item(0, 2).setText("3")
    settled(window)
    result["mended"] = text_of(window)

    # FreeCAD's own operation, chosen in the list while the best cut of the other is looked for.
    click(window.best_button)
    searched = window.searcher.is_busy
    window.operations.setCurrentIndex(window.operations.findData(pocket.Name))
    window._operation_chosen()
    settled(window)
    until(lambda: not window.searcher.is_busy)
    later(100)
    result["best_of_another"] = [searched, window.best is None, window.found.text()]
    result["pocket"] = [text_of(window), window.cut.engagement.value()]
    grab(window, "pocket")

    # It is read again by a window that is opened anew; and closes with its document.
    stability.close()
    later(200)
    result["closed"] = stability._Open.window is None
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_StabilityChart")
    window = stability._Open.window
    settled(window)
    result["again"] = window.modes.table.rowCount()

    # Beside an open panel, whose step to undo another one would close.
    before = state(op)
    window.cut.speed.setValue(before["speed"] + 500)
    settled(window)
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later(300)
    window.apply()
    result["beside_panel"] = [text_of(window), state(op) == before]
    press(QtGui.QDialogButtonBox.Cancel)
    later(300)
    window.cut.engagement.setValue(50)
    FreeCAD.closeDocument(doc.Name)
    later(500)
    result["gone"] = stability._Open.window is None


run(session)
