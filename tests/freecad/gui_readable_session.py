"""What test_readable.py runs in FreeCAD's GUI: Compare in a laptop's window and Show Load in a
narrow dock, in each language and with both units.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    later,
    ours_and_theirs,
    result,
    run,
    until,
)

LANGUAGES = "English", "German", "Hungarian"  # as FreeCAD has them
WIDTH, NARROW = 1400, 264  # pixels: of the window, and of FreeCAD's own dock at first
LONG = "Roughing_of_the_large_pocket_in_the_second_setup"  # a name that no column has room for


def seen_of(widget):
    """(pixels of a widget's width that the screen shows, that it has)"""
    return widget.visibleRegion().boundingRect().width(), widget.width()


def table_of(label):
    """(height of a label's text as it is shown, height where no line is wrapped)"""
    document = QtGui.QTextDocument()
    document.setDocumentMargin(0)
    document.setDefaultFont(label.font())
    document.setHtml(label.text())
    natural = document.size().height()
    document.setTextWidth(label.contentsRect().width())
    return document.size().height(), natural


def figures_of(dock, name):
    """What is seen of the right column of the window Simulation."""
    dock.grab().save(os.path.join(OUT, name + ".png"))
    shown = {
        "totals": dock.totals,
        **{each.text(): each for each in (dock.picture, dock.table, dock.report)},
    }
    return {
        "seen": {what: seen_of(widget) for what, widget in shown.items()},
        "heights": table_of(dock.totals),
        "sideways": dock.right.horizontalScrollBar().maximum(),
        "plot": dock.plot.width(),
        "dock": seen_of(dock),
    }


def compared(language, ours, theirs):
    """{units: what is seen of Compare}"""
    from evenload.gui import simulation

    view = simulation.show(ours, theirs)
    until(lambda: not view.task.is_busy)
    later()
    seen = {"mm": figures_of(view.dock, language + " mm")}
    choose_units(INCHES)
    later()
    seen["inches"] = figures_of(view.dock, language + " inches")
    choose_units(METRIC)
    if language == LANGUAGES[0]:
        ours.Label = LONG
        view.simulate()
        until(lambda: not view.task.is_busy)
        later()
        result["long_name"] = figures_of(view.dock, "long name")
        ours.Label = "EvenLoadAdaptive"
    simulation.close()
    later()
    return seen


def legends_by_width():
    """{width: the texts of swatches that a legend does not paint that becomes so narrow}"""
    from evenload.gui import load_colours, load_legend

    (engagement, *_), missing = load_colours.MEASURES, {}
    legend = load_legend.Legend()
    legend.resize(600, legend.height())
    legend.show()
    legend.show_scale(engagement, 0.0, 180.0, 102.5)
    for width in (600, 264, 180):
        legend.resize(width, legend.height())
        later()
        image = legend.grab().toImage()
        image.save(os.path.join(OUT, "legend %d.png" % width))
        missing[width] = [t for colour, t in legend.swatches() if not is_painted(image, colour)]
    legend.hide()
    legend.deleteLater()
    return missing


def is_painted(image, colour):
    """Whether a whole swatch in a colour is in a picture."""
    from evenload.gui.load_legend import BAR

    wanted = QtGui.QColor.fromRgbF(*map(float, colour)).rgb()
    spots = range(image.width()), range(image.height())
    return sum(image.pixel(x, y) == wanted for x in spots[0] for y in spots[1]) >= BAR * (BAR - 4)


def legends(language, op):
    """{measure: the texts of swatches that the legend does not paint in a narrow dock}"""
    from evenload.gui import load_view

    view = load_view.show(op)
    until(lambda: not view.task.is_busy)
    dock, missing = view.dock, {}
    FreeCADGui.getMainWindow().resizeDocks([dock], [NARROW], QtCore.Qt.Horizontal)
    for number in range(dock.choice.count()):
        dock.choice.setCurrentIndex(number)
        later()
        image = dock.legend.grab().toImage()
        swatches = dock.legend.swatches()
        missing[view.measure.key] = [t for colour, t in swatches if not is_painted(image, colour)]
        dock.grab().save(os.path.join(OUT, "%s %s.png" % (language, view.measure.key)))
    missing["width"] = dock.legend.width()
    load_view.close()
    later()
    return missing


def session():
    from models import face_of, rectangle

    doc = begun(WIDTH, 1100)
    _, ours, theirs = ours_and_theirs(doc, face_of(rectangle(0, 0, 18, 18)))
    ours.Label, theirs.Label = "EvenLoadAdaptive", "EvenLoadTrochoid"
    for each in ("compared", "legends", "by_width"):
        result[each] = {}
    for language in LANGUAGES:
        FreeCADGui.setLocale(language)
        later()
        result["by_width"][language] = legends_by_width()
        result["legends"][language] = legends(language, ours)
        result["compared"][language] = compared(language, ours, theirs)
    FreeCAD.closeDocument(doc.Name)


run(session)
