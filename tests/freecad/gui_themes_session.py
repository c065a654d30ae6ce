"""Our texts in FreeCAD's themes: their colours beside those of the ground that they stand on."""

import os
import sys

import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_contrasts import contrasts, of_the_theme, painted  # noqa: E402
from gui_preview_tools import CANCEL, job_with, opened, turn  # noqa: E402
from gui_themes import take, themes  # noqa: E402
from gui_tools import later, picture, press, result, run, until, widgets, workbench  # noqa: E402

ROW = 1  # of a table: the first is selected


def looked_at(form, *more):
    """(contrasts of what can be read in a form, those of bare widgets there)."""
    return [*more, *contrasts(form)], of_the_theme(form)


def page_of(op, name):
    """A page with its path, then with a value that is refused."""
    page = opened(op)
    later(200)
    picture("theme_" + name)  # which lays it out, too
    found = contrasts(page.form)
    turn(op, 3)
    until(lambda: page.preview.state != "computing")
    later(300)
    picture("refused_" + name)
    found = looked_at(page.form, *found)
    press(CANCEL)
    later(200)
    return found


def load_of(op, name):
    """The load view, whose legend paints the ends of its scale."""
    from evenload.gui import load_view
    from evenload.gui.load_legend import BAR

    view = load_view.show(op)
    until(lambda: not view.task.is_busy)
    picture("load_" + name)
    legend = view.dock.legend
    ends = QtCore.QRect(0, BAR + 1, legend.width(), legend.fontMetrics().height())
    found = looked_at(view.dock.widget(), painted(QtGui.QLabel, legend, "ends", ends))
    load_view.close()
    later(100)
    return found


def simulation_of(op, name):
    """The window Simulation, whose plot has figures at its left."""
    from evenload.gui import simulation
    from evenload.gui.colours import ground_of

    view = simulation.show(op)
    until(lambda: not view.task.is_busy)
    picture("simulation_" + name)
    plot = view.dock.plot
    corner = plot.pixel_of(0, 0, 0.0).toPoint()
    figures = QtCore.QRect(0, 0, corner.x() - 1, corner.y())
    text = view.dock.totals.palette().windowText().color()
    result["charts"].append([name, ground_of(plot).name(), text.name()])
    found = looked_at(view.dock.widget(), painted(QtGui.QLabel, plot, "figures", figures))
    simulation.close()
    later(100)
    return found


def stability_of(op, _):
    """The Stability chart, which tells in place of a chart what to do."""
    from evenload.gui import stability

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    window = stability.create()
    later(300)
    view = window.view
    found = looked_at(window, painted(QtGui.QLabel, view, view.message, view.rect()))
    stability.close()
    later(100)
    return found


def tap_test_of(*_):
    """The dialog Tap test, which tells that there is no such file."""
    from evenload.gui.stability_tap import TapTestDialog

    dialog = TapTestDialog("nowhere.csv", FreeCADGui.getMainWindow())
    dialog.show()
    later(300)
    found = looked_at(dialog)
    dialog.close()
    dialog.deleteLater()
    later(100)
    return found


def suggestion_of(op, name):
    """The dock Optimise with its table."""
    from evenload.gui import optimise

    view = optimise.show(op)
    for kept in (view.dock.to_try.keeps_angle, view.dock.to_try.keeps_depth):
        kept.setChecked(True)  # no path has to be computed
    view.dock.suggest.click()
    until(lambda: not view.task.is_busy)
    picture("optimise_" + name)
    table = view.dock.table
    cell = table.visualRect(table.model().index(ROW, 0))
    row = painted(QtGui.QLabel, table.viewport(), "a row", cell)
    found = looked_at(view.dock.widget(), row)
    optimise.close()
    later(100)
    return found


PLACES = page_of, load_of, simulation_of, stability_of, tap_test_of, suggestion_of


def seen_in(theme, op):
    """{place: what is seen there} in a theme."""
    take(theme)
    return {place.__name__: place(op, theme or "none") for place in PLACES}


def session():
    workbench(1300, 1000)
    for dock in widgets(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()  # there is little room
    _, _, op = job_with("Themes", 30.0)
    op.MinimumRadius = 5.0  # what is noted of it
    op.Document.recompute()
    result["notes"], result["charts"] = op.Report, []
    result["themes"] = {theme: seen_in(theme, op) for theme in themes()}
    take(themes()[0])


run(session)
