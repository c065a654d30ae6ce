"""What test_manual_in_gui.py runs in FreeCAD's GUI: What's This, F1, and shortcuts."""

import os
import re
import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import begun, click, later, ours_and_theirs, press  # noqa: E402
from gui_tools import result, run, widgets  # noqa: E402

opened = []  # the names of the pages that were opened since the last look
# Those with commands in C++ that have shortcuts; those in Python are found by their text.
WORKBENCHES = "Part", "PartDesign", "Sketcher", "Surface", "TechDraw", "Mesh", "Spreadsheet"
ACCEL = re.compile(r"""["']Accel["']\]?\s*[:=]\s*["']([^"']+)["']""")


def note(url):
    opened.append(os.path.splitext(os.path.basename(url.path()))[0])
    return True


class Browser(QtCore.QObject):
    """Stands for the browser, for FreeCAD's own calls of Qt."""

    @QtCore.Slot(QtCore.QUrl)
    def show(self, url):
        note(url)


def seen():
    """The pages that were opened since the last look."""
    later(200)
    found = opened[:]
    opened.clear()
    return found


def whats_this(widget):
    """The page that FreeCAD opens by What's This and a click on a widget."""
    FreeCADGui.runCommand("Std_WhatsThis")
    later(100)
    click(widget)
    found = seen()
    QtGui.QWhatsThis.leaveWhatsThisMode()
    return found


def f1(widget):
    """The page that F1 opens while a widget has the focus, as Qt asks and tells by its key."""
    widget.setFocus()
    for kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
        event = QtGui.QKeyEvent(kind, QtCore.Qt.Key_F1, QtCore.Qt.NoModifier)
        event.ignore()
        QtGui.QApplication.sendEvent(widget, event)
        if not event.isAccepted():
            return ["FreeCAD's own"]
    return seen()


def both(widget, focused=None):
    return {"whats_this": whats_this(widget), "f1": f1(focused or widget)}


def buttons():
    """{text: its button in FreeCAD's toolbar}"""
    from evenload import host

    bars = [bar for bar in widgets(QtGui.QToolBar) if bar.objectName() == host.TOOLBAR]
    found = {}
    for bar in bars:
        for action in bar.actions():
            if "EvenLoad" in action.text() and bar.widgetForAction(action) is not None:
                found[action.text().replace("&", "")] = bar.widgetForAction(action)
    return found


def docks(job, op):
    """What our docks and the window Stability chart open."""
    from evenload.gui import inspection, load_view, optimise, simulation, stability, surface

    found = {}
    view = load_view.show(op)
    found["load_view"] = both(view.dock.values, view.dock.slider)
    load_view.close()
    view = surface.show(op)
    found["surface_view"] = both(view.dock.told, view.dock.choice)
    surface.close()
    view = simulation.show(op)
    later(1500)
    found["simulation_window"] = both(view.dock.values, view.dock.slider)
    simulation.close()
    view = optimise.show(op)
    found["optimisation"] = both(view.dock.told, view.dock.table)
    optimise.close()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(job.Model.Group[0], "Face1")
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(300)
    (view,) = inspection._shown
    found["inspect"] = both(view.dock.faces, view.dock.take)
    view.dock.close()
    later(300)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    window = stability.create()
    later(1500)
    found["stability_chart"] = {"f1": f1(window.operations), "whats_this": [window.page]}
    stability.close()
    later(300)
    return found


def shortcuts():
    """{command: its shortcut} of commands that are there, ours among them; {file: shortcuts} of
    FreeCAD's commands in Python, whether they are loaded or not.
    """
    for name in WORKBENCHES:
        FreeCADGui.activateWorkbench(name + "Workbench")
        later(50)
    loaded = {
        name: FreeCADGui.Command.get(name).getShortcut() for name in FreeCADGui.Command.listAll()
    }
    written = {}
    for folder in FreeCAD.__ModDirs__:
        for path in Path(folder).rglob("*.py"):
            found = ACCEL.findall(path.read_text(encoding="utf-8", errors="replace"))
            if found and not Path(folder, "Mod", "evenload").is_dir():
                written[str(path)] = found
    return [{name: keys for name, keys in loaded.items() if keys}, written]


def session():
    from models import face_of, rectangle

    doc = begun(1390, 1100)
    browser = Browser()
    QtGui.QDesktopServices.setUrlHandler("file", browser, "show")
    QtGui.QDesktopServices.openUrl = note  # for FreeCAD's module Help
    result["commands"] = {text: whats_this(button) for text, button in buttons().items()}
    job, ours, _ = ours_and_theirs(doc, face_of(rectangle(0, 0, 18, 18)))
    result["docks"] = docks(job, ours)
    FreeCADGui.activeDocument().setEdit(ours)
    later(800)
    page = ours.ViewObject.Proxy.panel.featurePages[-1]
    edit = page.widgets["StockToLeave"]
    result["panel"] = {"f1": f1(edit), "whats_this": whats_this(page.live)}
    result["page"] = page.form.page
    press(QtGui.QDialogButtonBox.Cancel)
    later(300)
    result["shortcuts"] = shortcuts()
    QtGui.QDesktopServices.unsetUrlHandler("file")


run(session)
