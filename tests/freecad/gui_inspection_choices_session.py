"""What test_inspection_choices.py runs in FreeCAD: datum, motions, units and predictions of the
dock Inspect.
"""

import os
import sys

import FreeCAD
import FreeCADGui
import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_inspection_tools import (  # noqa: E402
    choose,
    cut_off,
    grid,
    measured,
    open_points,
    opened,
    save,
)
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    click,
    later,
    picture,
    result,
    run,
)

WIDTHS = 264, 420


def told(view):
    """What the dock tells of measured points, and the zone in mm, None where there is none."""
    return view.dock.told.text(), view.found.zone if view.found else None


def pictures(dock, name):
    """Pictures of the open tab, as narrow as FreeCAD's dock at first and wider; what is cut off."""
    from PySide import QtCore

    found = []
    for width in WIDTHS:
        FreeCADGui.getMainWindow().resizeDocks([dock], [width], QtCore.Qt.Horizontal)
        later(100)
        dock.grab().save(os.path.join(OUT, "%s_%d.png" % (name, width)))
        found += cut_off(dock)
        # Another dock of FreeCAD's in the same area may need more.
        result.setdefault("needed", []).append(dock.minimumSizeHint().width())
        result.setdefault("widths", []).append(dock.width())
    return found


def plane_choices(part, view):
    """The datum from the list and from the 3D view, and the motions that are left free."""
    alignment = view.dock.alignment
    planes = [alignment.datum.list.itemText(k) for k in range(alignment.datum.list.count())]
    result["planes"] = planes
    result["free"] = [alignment.free.currentData(), alignment.motions.isVisible(), *told(view)]
    choose(alignment.free, "chosen")
    result["none_ticked"] = [alignment.motions.isVisible(), *told(view)]
    for name in ("tz", "rx"):
        alignment.motions.boxes[name].setChecked(True)
    later(50)
    result["ticked"] = [*alignment.value(), *told(view)]
    result["cut_off"] = pictures(view.dock, "measured")
    # From the 3D view: the underside, which is none of the picked faces.
    click(alignment.datum.pick)
    later(50)
    result["nothing_picked"] = view.dock.told.text()
    FreeCADGui.Selection.addSelection(part, underside(part))
    click(alignment.datum.pick)
    later(50)
    FreeCADGui.Selection.clearSelection()
    result["picked"] = [alignment.datum.list.currentText(), *alignment.value(), *told(view)]
    enabled = [name for name, box in alignment.motions.boxes.items() if box.isEnabled()]
    choose(alignment.free, "all")
    result["in_datum"] = [enabled, *alignment.value(), *told(view)]
    result["datum"] = [list(each) for each in view.found.datum]
    datum_plane(part.Document, view)
    choose(view.dock.evaluation.kind, "cylinder")
    result["of_feature"] = [alignment.isVisible(), told(view)[1] is not None]
    choose(view.dock.evaluation.kind, "profile")


def datum_plane(doc, view):
    """A datum plane of the document, which is moved, and deleted."""
    alignment = view.dock.alignment
    plane = doc.addObject("PartDesign::Plane", "Level")
    plane.Placement.Base = FreeCAD.Vector(0, 0, 3)
    doc.recompute()
    FreeCADGui.Selection.addSelection(plane)
    click(alignment.datum.pick)
    later(50)
    FreeCADGui.Selection.clearSelection()
    result["datum_plane"] = [alignment.datum.list.currentText(), list(view.found.datum[0])]
    plane.Placement.Base = FreeCAD.Vector(0, 0, 5)
    doc.recompute()
    later(200)
    result["datum_moved"] = list(view.found.datum[0])
    doc.removeObject(plane.Name)
    later(200)
    result["datum_gone"] = [alignment.value()[1], view.found.datum]


def inches(view, feet, normals):
    """Another unit of lengths, by FreeCAD's preferences, and back."""
    dock = view.dock
    dock.tolerance.width.set_mm(0.05)
    dock.samples.margin.set_mm(2)
    later(50)
    before = [view.found.zone, view.found.tolerance]
    for schema in (INCHES, METRIC):
        choose_units(schema)
        if schema == METRIC:
            break
        result["inch"] = {
            "told": dock.told.text(),
            "tolerance": dock.tolerance.width.text(),
            "margin": dock.samples.margin.text(),
            "ball": dock.samples.ball.text(),
            "legend": dock.legend._measure.quantity.shown.name,
            "same": [view.found.zone, view.found.tolerance] == before,
            "roughness": dock.cutting.roughness.suffix(),
        }
        dock.tolerance.width.setValue(0.0004)
        later(50)
        result["inch"]["typed"] = view.found.tolerance
        dock.samples.margin.set_mm(254)
        later(50)
        result["inch"]["refused"] = dock.told_samples.text()
        dock.samples.margin.set_mm(2)
        open_points(dock, measured("far.csv", feet + [0, 0, 30], normals))
        result["inch"]["far"] = dock.told.text()
        open_points(dock, measured("dome.csv", feet, normals))
        result["inch_pictures"] = pictures(dock, "inch")
        result["inch_report"] = text_of(view, "inch.html")
        dock.tabs.setCurrentIndex(0)
        later(100)
        result["inch_file"] = head_of(dock, "inch.csv")
        result["cut_off"] += pictures(dock, "where")
        dock.tabs.setCurrentIndex(1)
    result["back"] = [dock.told.text(), dock.samples.margin.text(), dock.tolerance.width.mm()]
    result["cut_off"] += result.pop("inch_pictures")


def text_of(view, name):
    save(view.dock.save_report, name)
    with open(os.path.join(OUT, name), encoding="utf-8") as file:
        return file.read()


def head_of(dock, name):
    save(dock.save_points, name)
    with open(os.path.join(OUT, name), encoding="utf-8") as file:
        return file.readline().strip()


def predictions(part, view):
    """Values of the user's own, and those of a finishing operation."""
    from evenload import host
    from evenload.operations import finishing

    dock, cutting = view.dock, view.dock.cutting
    dock.tabs.setCurrentIndex(2)
    later(100)
    result["unasked"] = [dock.predicted.text(), cutting.nature.currentData(), cutting.face.mm()]
    cutting.roughness.set_mm(0.003)
    later(50)
    result["own"] = [dock.predicted.text(), dict(view.prediction.errors)]
    cutting.stepover.setValue(0.3)
    later(50)
    result["outside"] = dock.predicted.text()
    cutting.roughness.set_mm(0)
    job, controller = host.create_job(part.Document, [part], 10, 1650, 5100, 4)
    controller.Tool = host.create_tool("ballend", {"Diameter": 10, "Flutes": 2})
    op = finishing.Create("Finish", parentJob=job, toolController=controller)
    op.Base = [(job.Model.Group[0], "Face%d" % number_of_top(part))]
    op.PassAngle, op.Stepover = 67.5, 0.2
    part.Document.recompute()
    dock.tabs.setCurrentIndex(0)
    dock.tabs.setCurrentIndex(2)
    later(100)
    choose(cutting.source, op.Name)
    result["operation"] = {
        "listed": [cutting.source.itemText(k) for k in range(cutting.source.count())],
        "values": [cutting.stepover.mm(), cutting.feed.mm(), cutting.tool.mm()],
        "others": [cutting.direction.value(), cutting.speed.value(), cutting.roughness.mm()],
        "cusp": op.CuspHeight.Value,
        "told": dock.predicted.text(),
    }
    result["cut_off"] += pictures(dock, "predicted")
    picture("predicted_window")
    cutting.roughness.set_mm(0.003)
    later(50)
    result["edited"] = cutting.source.currentData()
    dock.tabs.setCurrentIndex(1)
    later(50)
    result["report"] = text_of(view, "predicted.html")
    controller.SpindleSpeed = 0
    choose(cutting.source, op.Name)
    result["standing"] = [dock.predicted.text(), view.prediction is None]
    result["provoked"].append("SetupSheet has no support for Finish")


def underside(part):
    """The name of the plane face that looks down, which is none of the inspected ones."""
    faces = enumerate(part.Shape.Faces, 1)
    return "Face%d" % min((face.BoundBox.ZMax, number) for number, face in faces)[1]


def number_of_top(part):
    faces = enumerate(part.Shape.Faces, 1)
    return max((face.BoundBox.ZMax, number) for number, face in faces)[1]


def session():
    from evenload import inspection
    from evenload.gui import inspection as command

    FreeCAD.closeDocument(begun(1300, 1400).Name)
    result["provoked"].append("The datum of the inspection is no longer there")
    part, view = opened()
    view.dock.tabs.setCurrentIndex(1)
    feet, normals = inspection.test_part("CX").at(*grid())
    waves = 0.01 * numpy.sin(feet[:, 0] / 12) * numpy.cos(feet[:, 1] / 15) + 0.01
    points = feet + waves[:, None] * normals
    result["waves"] = float(2 * numpy.abs(waves).max())
    open_points(view.dock, measured("dome.csv", points, normals))
    plane_choices(part, view)
    inches(view, points, normals)
    predictions(part, view)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(part, "Face%d" % number_of_top(part))
    view.dock.tabs.setCurrentIndex(1)
    click(view.dock.alignment.datum.pick)  # of a round face, which is none
    later(50)
    result["round_datum"] = view.dock.told.text()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(part, underside(part))
    click(view.dock.alignment.datum.pick)
    later(50)
    picked = view.dock.alignment.value()[1]
    FreeCAD.closeDocument(part.Document.Name)
    later(200)
    result["closed_with_datum"] = [picked, len(command._shown)]


run(session)
