"""What test_languages.py runs in FreeCAD's GUI: our window in FreeCAD's $EVENLOAD_LANGUAGE."""

import os
import sys

import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_fit import resize_dock  # noqa: E402
from gui_panels import WIDTHS, fit_of, in_panel, opened, operation_on, picture  # noqa: E402
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    fold_all,
    later,
    press,
    result,
    run,
    toolbar_texts,
    until,
)
from models import SQUARE, block_with, face_of, floors_of, sketch_of  # noqa: E402

LANGUAGE = os.environ["EVENLOAD_LANGUAGE"]
# Docks, or panels: FreeCAD 0.20 cannot have both in one session, see gui_tools.later().
DOCKS = os.environ["EVENLOAD_LOOK_AT"] == "docks"
COMMANDS = (
    "EvenLoad_Adaptive",
    "EvenLoad_Trochoid",
    "EvenLoad_LameSpiral",
    "EvenLoad_Finishing",
)


def texts_in(widget):
    """The texts that a widget and those in it show, tooltips too, as plain text."""
    found, document = [], QtGui.QTextDocument()
    for each in (widget, *widget.findChildren(QtGui.QWidget)):
        found.append(each.toolTip())
        if isinstance(each, (QtGui.QLabel, QtGui.QAbstractButton)):
            found.append(each.text())
        elif isinstance(each, QtGui.QGroupBox):
            found.append(each.title())
        elif isinstance(each, QtGui.QComboBox):
            found += [each.itemText(number) for number in range(each.count())]
        elif isinstance(each, QtGui.QTabWidget):
            numbers = range(each.count())
            found += [say(number) for say in (each.tabText, each.tabToolTip) for number in numbers]
        elif isinstance(each, QtGui.QAbstractSpinBox):
            found += [each.property("specialValueText") or "", each.property("suffix") or ""]
        elif isinstance(each, QtGui.QLineEdit):
            found.append(each.placeholderText())
        elif isinstance(each, QtGui.QTableWidget):
            heads = [each.horizontalHeaderItem(n) for n in range(each.columnCount())]
            found += [text for head in heads for text in (head.text(), head.toolTip())]
        elif isinstance(each, QtGui.QTableView):
            found += in_table(each.model())
    plain = []
    for text in filter(None, found):
        document.setHtml(text) if "<" in text else document.setPlainText(text)
        plain += document.toPlainText().splitlines()
    return sorted({line.strip() for line in plain if line.strip()})


def in_table(model):
    """The texts of a table's columns: titles, tooltips and cells."""
    columns, roles = range(model.columnCount()), (QtCore.Qt.DisplayRole, QtCore.Qt.ToolTipRole)
    heads = [model.headerData(n, QtCore.Qt.Horizontal, role) for role in roles for n in columns]
    cells = [model.index(row, n).data() for row in range(model.rowCount()) for n in columns]
    # A title is told in several lines, of which each may be a word of another text.
    return [text.replace("\n", " ") for text in (*heads, *cells) if text]


def choices_of(page):
    """{setting: [(what a list shows, what it stands for), ...]}"""
    boxes = {n: w for n, w in page.widgets.items() if isinstance(w, QtGui.QComboBox)}
    return {
        name: [(box.itemText(k), box.itemData(k)) for k in range(box.count())]
        for name, box in boxes.items()
    }


def looked_at(page, name):
    seen = {"fit": fit_of(page, name), "texts": texts_in(page.form), "choices": choices_of(page)}
    seen["status"] = page.status.text()
    return seen


def in_inches(look):
    """(what look() tells with metric units, what it tells with inches), of what stays open."""
    seen = look()
    choose_units(INCHES)
    try:
        return seen, look()
    finally:
        choose_units(METRIC)


def refused(op):
    """What the panel says of a value that no path can be computed from, and where it leads."""
    fold_all()
    page = opened(op)
    before = op.MaximumFeed.Value
    op.MaximumFeed = "10 mm/min"
    press(QtGui.QDialogButtonBox.Ok)
    later()
    resize_dock(page, WIDTHS[0])
    picture("refused")
    seen = {"status": page.status.text(), "fields": [p.field for p in page.status._pieces]}
    seen["is_marked"] = "color" in page.labels["MaximumFeed"].styleSheet()
    seen["in_english"] = op.Proxy.refusal(op)
    op.MaximumFeed = before
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    return seen


def noted(op, sketch):
    """The notes of a path, in the panel and in the document."""
    op.Base = [(sketch, "")]
    op.Document.recompute()
    return in_panel(op, lambda page: page.status.text()), op.Report


def load_of(op):
    """The texts of the dock of the load."""
    from evenload.gui import load_view

    view = load_view.show(op)
    until(lambda: not view.task.is_busy)
    choice, legend = view.dock.choice, view.dock.legend

    def look():
        view.dock.grab().save(os.path.join(OUT, "load.png"))
        found = [*texts_in(view.dock), view.dock.windowTitle()]
        for number in (0, choice.count() - 1):  # the first has a limit, the last all kinds
            choice.setCurrentIndex(number)
            found += [text for _, text in legend.swatches()]
        return found

    seen = in_inches(look)
    load_view.close()
    later()
    return seen


def simulation_of(op):
    """The texts of the window Simulation, with the simulation of an operation in it."""
    from evenload.gui import simulation

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_Simulation")
    view = simulation._shown[-1]
    until(lambda: not view.task.is_busy)
    picture("simulation")
    seen = in_inches(lambda: texts_in(view.dock) + [view.dock.windowTitle()])
    view.dock.close()
    later()
    return seen


def stability_of(op):
    """The texts of the window Stability chart."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_StabilityChart")
    later(500)
    from evenload.gui import stability

    window = stability._Open.window
    window.grab().save(os.path.join(OUT, "stability.png"))
    seen = in_inches(lambda: texts_in(window) + [window.windowTitle()])
    stability.close()
    later()
    return seen


def inspection_of(doc, model, floor):
    """The texts of the dock Inspect, with a prediction for what the source has not measured."""
    from evenload.gui import inspection, inspection_dock

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floor)
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(500)
    view = inspection._shown[-1]
    view.dock.tabs.setCurrentIndex(inspection_dock.PREDICTED)
    view.dock.cutting.show_values(passes="One way")
    view.dock.cutting.stepover.set_mm(0.5)
    view.dock.cutting.roughness.set_mm(0.003)
    view.predict()
    picture("inspection")
    seen = in_inches(lambda: texts_in(view.dock) + [view.dock.windowTitle()])
    inspection.close()
    later()
    return seen


def advice_on(doc, model, floor):
    """The texts of the dock Finishing Advisor, with its refusal of a tool without a ball."""
    from evenload.gui import advisor

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floor)
    FreeCADGui.runCommand("EvenLoad_FinishingAdvisor")
    later(500)
    view = advisor._shown[-1]
    picture("advisor")
    seen = in_inches(lambda: [*texts_in(view.dock), view.dock.windowTitle()])
    assert all(view.dock.told.text() in each for each in seen)
    advisor.close()
    later()
    return seen


def suggested_for(op):
    """The texts of the dock Optimise with a suggestion, and with one that cannot be."""
    from evenload.gui import optimise

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_Optimise")
    later(500)
    view, seen = optimise._shown[-1], ([], [])
    view.dock.to_try.angles.setText("50; 70")
    view.dock.to_try.levels.setValue(1)
    for most in (0.0, 1.0):  # N, of which the first is no limit
        view.dock.limits.max_force.setValue(most)
        view.suggest()
        until(lambda: not view.task.is_busy)
        picture("optimise_%d" % most)
        for texts, each in zip(seen, in_inches(lambda: texts_in(view.dock))):
            texts += each
    seen[0].append(view.dock.windowTitle())
    optimise.close()
    later()
    return seen


def preferences_page():
    """The texts of our page of FreeCAD's preferences."""
    from evenload.gui import PreferencesPage

    page = PreferencesPage()

    def look():
        page.loadSettings()
        return [*texts_in(page.form), page.form.windowTitle()]

    return in_inches(look)


def surface_of(op):
    """The texts of the dock Show Surface, with its figures and remarks."""
    from evenload.gui import surface
    from evenload.surface_simulation import rough_map

    rough_map.PLACES = 4  # of whose texts there are no more with many
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    FreeCADGui.runCommand("EvenLoad_ShowSurface")
    (view,) = surface._shown
    until(lambda: not view.task.is_busy)
    picture("surface")
    swatches = [text for _, text in view.dock.legend.swatches()]
    seen = in_inches(lambda: [*texts_in(view.dock), view.dock.windowTitle(), *swatches])
    assert view.dock.told.text() in seen[0]
    surface.close()
    later()
    return seen


def look_at_panels(doc, job, model, floor):
    operations = {c: operation_on(doc, job, model, floor, c) for c in COMMANDS}
    result["undo"] = list(doc.UndoNames)
    result["panels"] = panels_of(operations)
    adaptive = operations["EvenLoad_Adaptive"]
    result["refused"] = refused(adaptive)
    wedge = [(0, 0, 0), (40, 0, 0), (0, 12, 0)]  # whose tips no wished radius fits
    sketch = sketch_of(doc, wedge)
    result["notes"] = noted(adaptive, sketch)
    choose_units(INCHES)
    adaptive.Base = [(model, (floor,))]
    doc.recompute()
    result["in_inches"] = {"panels": panels_of(operations), "refused": refused(adaptive)}
    result["in_inches"]["notes"] = noted(adaptive, sketch)
    choose_units(METRIC)


def panels_of(operations):
    """{command: what is seen of the panel of its operation}"""
    seen = {}
    for command, op in operations.items():
        fold_all()
        seen[command] = in_panel(op, lambda page: looked_at(page, command))
    return seen


def look_at_docks(doc, job, model, floor):
    from evenload.operations import adaptive

    op = adaptive.Create("Ours", parentJob=job)
    op.Base = [(model, (floor,))]
    doc.recompute()
    seen = {
        "load": load_of(op),
        "surface": surface_of(op),
        "simulation": simulation_of(op),
        "stability": stability_of(op),
        "inspection": inspection_of(doc, model, floor),
        "advisor": advice_on(doc, model, floor),
        "optimise": suggested_for(op),
        "preferences": preferences_page(),
    }
    result["docks"] = {name: texts for name, (texts, _) in seen.items()}
    result["docks_in_inches"] = {name: texts for name, (_, texts) in seen.items()}


def session():
    from evenload import host

    if DOCKS:  # FreeCAD starts in English, and has started with the language for panels
        FreeCADGui.setLocale(LANGUAGE)
    doc = begun(1300, 1400)
    result["toolbar"] = toolbar_texts()
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, _ = host.create_job(doc, [part], 6, 255, 6366, 1)
    model = job.Model.Group[0]
    (floor,) = floors_of(model.Shape)
    fold_all()
    look = look_at_docks if DOCKS else look_at_panels
    look(doc, job, model, floor)


run(session)
