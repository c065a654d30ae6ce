"""What test_inspection_dock.py runs in FreeCAD: the dock Inspect, from faces to the report."""

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
    save,
)
from gui_tools import (  # noqa: E402
    OUT,
    answering,
    click,
    is_enabled,
    later,
    picture,
    result,
    run,
    toolbar_texts,
)

NODE = "EvenLoadInspection"


def nodes():
    """Our nodes in the active view's scene."""
    scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
    children = [scene.getChild(i) for i in range(scene.getNumChildren())]
    return [node for node in children if str(node.getName()) == NODE]


def session():
    import Part
    from inspected import dome, upper_faces
    from evenload import host, inspection

    with answering(lambda dialog: dialog.accept()):  # what FreeCAD asks new users
        FreeCADGui.activateWorkbench(host.WORKBENCH)
        later(800)
    result["provoked"].append("SetupSheet has no support for Probing")  # FreeCAD's own words
    doc = FreeCAD.newDocument("Dome")
    part = doc.addObject("Part::Feature", "Dome")
    part.Shape = dome(inspection.test_part("CX"))
    doc.recompute()
    FreeCADGui.activeDocument().activeView().viewAxonometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    result["actions"] = toolbar_texts()
    result["enabled"] = [is_enabled("EvenLoad_Inspect")]
    FreeCADGui.Selection.addSelection(part, "Edge1")
    result["enabled"].append(is_enabled("EvenLoad_Inspect"))
    FreeCADGui.Selection.clearSelection()
    for name in upper_faces(part.Shape):
        FreeCADGui.Selection.addSelection(part, name)
    result["enabled"].append(is_enabled("EvenLoad_Inspect"))
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(300)
    from evenload.gui import inspection as command
    from evenload.gui.inspection_node import RAISED

    view = command._shown[0]
    dock = view.dock
    choose(dock.samples.spacing, "plan")
    dock.samples.margin.setValue(2)
    later(100)
    result["samples"] = [dock.faces.text(), dock.told_samples.text(), len(nodes())]
    points = view.node.points
    marks = (
        points.getChild(points.getNumChildren() - 1).getChild(2).vertexProperty.getValue().vertex
    )
    raised = view.samples.points + RAISED * view.faces.size() * view.samples.normals
    result["off"] = float(
        numpy.abs(numpy.array([p.getValue() for p in marks.getValues()]) - raised).max()
    )
    result["cut_off"] = cut_off(dock)
    picture("where")
    FreeCADGui.activeDocument().activeView().saveImage(
        os.path.join(OUT, "where_view.png"), 900, 700, "Current"
    )
    result["saved"] = {
        "points.csv": save(dock.save_points, "points.csv"),
        "points.dmi": save(dock.save_points, "points.dmi"),
        "samples.png": save(dock.save_picture, "samples.png"),
        "probe.ngc": save(dock.probing, "probe.ngc"),
    }
    later(200)
    result["told_after_saving"] = dock.told_samples.text()
    result["documents"] = sorted(FreeCAD.listDocuments())
    dock.samples.margin.setValue(60)
    later(100)
    result["no_room"] = [dock.told_samples.text(), dock.save_points.isEnabled()]
    dock.samples.margin.setValue(2)

    # Measured points.
    dock.tabs.setCurrentIndex(1)
    later(100)
    feet, normals = inspection.test_part("CX").at(*grid())
    waves = 0.01 * numpy.sin(feet[:, 0] / 12) * numpy.cos(feet[:, 1] / 15)
    open_points(dock, measured("dome.csv", feet + waves[:, None] * normals, normals))
    result["zone"] = [view.found.zone, dock.told.text()]
    dock.tolerance.width.setValue(0.01)
    later(100)
    result["out"] = [dock.told.text(), dock.legend.swatches() != []]
    group = view.node.colours.getChild(1)
    colours, _, triangles = (group.getChild(number) for number in range(3))
    result["triangles"] = triangles.numVertices.getNum()
    result["colours"] = len({colour.getValue() for colour in colours.rgb.getValues()})
    result["cut_off"] += cut_off(dock)
    picture("measured")
    FreeCADGui.activeDocument().activeView().saveImage(
        os.path.join(OUT, "view.png"), 900, 700, "Current"
    )
    choose(dock.evaluation.points, False)
    result["of_faces"] = dock.told.text()
    choose(dock.evaluation.points, True)
    choose(dock.alignment.free, "none")
    result["aligned"] = [view.found.zone, float(2 * numpy.abs(waves).max())]
    dock.tolerance.width.setValue(0.05)
    later(100)
    result["in"] = dock.told.text()
    result["reports"] = {
        "report.html": save(dock.save_report, "report.html"),
        "map.png": save(dock.save_map, "map.png"),
    }
    open_points(dock, measured("far.csv", feet + [0, 0, 30], normals))
    result["far"] = dock.told.text()
    choose(dock.alignment.free, "all")
    open_points(dock, measured("few.csv", feet[:3], normals[:3]))
    result["few"] = [dock.told.text(), dock.save_report.isEnabled()]

    # Other faces, a changed model, the end.
    FreeCADGui.Selection.clearSelection()
    click(dock.take)
    later(50)
    result["nothing_taken"] = dock.faces.text()
    FreeCADGui.Selection.addSelection(part, upper_faces(part.Shape)[0])
    click(dock.take)
    later(50)
    result["taken"] = dock.faces.text()
    part.Shape = Part.makeBox(30, 30, 30)
    doc.recompute()
    later(200)
    result["changed"] = view.faces.size()
    dock.close()
    later(100)
    result["closed"] = [len(command._shown), len(nodes())]
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(part, "Face6")
    FreeCADGui.runCommand("EvenLoad_Inspect")
    later(100)
    result["again"] = len(command._shown)
    FreeCAD.closeDocument(doc.Name)
    later(200)
    result["gone"] = len(command._shown)


run(session)
