"""What test_preferences.py runs in FreeCAD's GUI: our page of FreeCAD's preferences, and what new
operations and windows make of it.
"""

import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import OUT, answering, begun, later, press, result, run, until  # noqa: E402

PREFERRED = {
    "EngagementAngle": 45.0,
    "CutMode": "Conventional",
    "StockToLeave": 0.3,
    "Tolerance": 0.01,
    "Arcs": False,
}
KEPT_IN = "User parameter:BaseApp/Preferences/Mod/EvenLoad"


def page_in_dialog():
    """FreeCAD's own dialog with our page in front: whether it shows there."""
    seen = []

    def answer(dialog):
        boxes = [box for box in dialog.findChildren(QtGui.QGroupBox) if box.isVisible()]
        seen.append([box.title() for box in boxes])
        dialog.resize(900, 700)
        later(200)
        dialog.grab().save(os.path.join(OUT, "dialog.png"))
        dialog.reject()

    with answering(answer):
        FreeCADGui.showPreferences("EvenLoad", 0)
    return seen[0]


def values_of(op):
    from evenload.gui import preferences

    return {row.name: row.of(op) for row in preferences.ROWS if hasattr(op, row.name)}


def new_page():
    from evenload.gui import PreferencesPage

    page = PreferencesPage()
    page.loadSettings()
    return page


def edit(page, values):
    """Shows values in the fields of settings as their user would have set them."""
    from evenload.gui import preferences

    for row in preferences.ROWS:
        if row.name in values:
            page._widgets._show(row, values[row.name])


def made_by_command(face):
    """The values of an operation that the command makes, whose panel is cancelled."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(*face)
    FreeCADGui.runCommand("EvenLoad_Adaptive")
    later(300)
    op = FreeCAD.ActiveDocument.getObject("EvenLoadAdaptive")
    seen = values_of(op)
    press(QtGui.QDialogButtonBox.Cancel)
    later(300)
    return seen


def session():
    from evenload import host
    from evenload.gui import load_view, preferences
    from evenload.operations import adaptive
    from models import SQUARE, block_with, face_of, floors_of

    doc = begun(1300, 1000)
    result["titles"] = page_in_dialog()
    page = new_page()
    result["preferred"] = PREFERRED
    FreeCAD.Units.setSchema(3)  # inches
    in_inches = new_page()
    fields = in_inches._widgets.defaults
    result["texts"] = [fields[n].property("text") for n in ("EngagementAngle", "StockToLeave")]
    in_inches.saveSettings()  # rounded to inches as it is shown
    FreeCAD.Units.setSchema(6)
    page.saveSettings()
    result["kept_at_first"] = FreeCAD.ParamGet(KEPT_IN + "/Defaults").GetContents() or []
    edit(page, PREFERRED)
    page._widgets.live.setChecked(False)
    page._widgets.scale.setCurrentIndex(1)
    page._widgets.machine.setCurrentIndex(page._widgets.machine.findData("hobby_router_grbl"))
    page.saveSettings()
    again = new_page()
    result["again"] = {
        row.name: again._widgets._value(row) for row in preferences.ROWS if row.name in PREFERRED
    }
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6, 255, 6366, 1)
    model = job.Model.Group[0]
    (floor,) = floors_of(model.Shape)
    face = doc.Name, model.Name, floor
    result["made"] = made_by_command(face)
    job.SetupSheet.addProperty("App::PropertyAngle", "EvenLoadAdaptiveEngagementAngle")
    job.SetupSheet.EvenLoadAdaptiveEngagementAngle = 75
    result["with_setup_sheet"] = made_by_command(face)["EngagementAngle"]
    job.SetupSheet.removeProperty("EvenLoadAdaptiveEngagementAngle")
    scripted = adaptive.Create("Scripted", parentJob=job, toolController=controller)
    result["scripted"] = values_of(scripted)
    scripted.Base = [(model, (floor,))]
    doc.recompute()
    result["windows"] = [
        preferences.live_preview(),
        preferences.scale(),
        preferences.machine(),
        preferences.material(),
    ]
    view = load_view.show(scripted)
    until(lambda: not view.task.is_busy)
    picture = view.dock.legend.grab().toImage()
    at = picture.width() - 2, 4
    colour = QtGui.QColor(picture.pixel(*at))
    result["legend"] = [colour.redF(), colour.greenF(), colour.blueF()]
    load_view.close()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(scripted)
    FreeCADGui.runCommand("EvenLoad_Simulation")
    later(300)
    from evenload.gui import simulation

    result["machine_shown"] = simulation._shown[0].dock.asked.machine.machine()
    simulation.close()
    # What is kept of another version, or by hand, and can no longer be.
    group = FreeCAD.ParamGet(KEPT_IN + "/Defaults")
    group.SetString("CutMode", "Sideways")
    group.SetFloat("EngagementAngle", 400.0)
    FreeCAD.ParamGet(KEPT_IN).SetString("ColourScale", "Plaid")
    FreeCAD.ParamGet(KEPT_IN).SetString("Machine", "gone")
    result["spoiled"] = [preferences.scale(), preferences.machine()]
    broken = made_by_command(face)
    result["spoiled"] += [broken["CutMode"], broken["EngagementAngle"]]
    page = new_page()
    own = {row.name: preferences.own_default(row) for row in preferences.ROWS}
    edit(page, PREFERRED)
    page.saveSettings()
    edit(page, own)
    page.saveSettings()
    result["cleared"] = group.GetContents() or []


run(session)
