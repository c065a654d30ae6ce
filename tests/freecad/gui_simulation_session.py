"""What test_simulation_window.py runs in FreeCAD's GUI: the window Simulation."""

import os
import sys

import FreeCAD
import FreeCADGui
import numpy
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    click,
    later,
    ours_and_theirs,
    picture,
    result,
    run,
    toolbar_texts,
    until,
    widgets,
)

NODE = "EvenLoadLoad"


def names_in_scene():
    """The names of the nodes in the active view's scene."""
    scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
    return [str(scene.getChild(i).getName()) for i in range(scene.getNumChildren())]


def nodes_in_scene():
    """How many load nodes are in the active view's scene."""
    return names_in_scene().count(NODE)


def docks():
    from evenload.gui import simulation_dock

    shown = [w for w in widgets(QtGui.QDockWidget) if w.objectName() == simulation_dock.NAME]
    return len([w for w in shown if w.isVisible()])


def simulated(view):
    """Waits until nothing is under way; the window has to be alive meanwhile."""
    until(lambda: not view.task.is_busy)


def command(op):
    from evenload.gui import simulation

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    later(100)
    FreeCADGui.runCommand("EvenLoad_Simulation")
    later(100)
    return simulation._shown[-1]


def place_of_tool(view):
    """(x, y, z) where the tool's tip is in the 3D view."""
    x, y, z = view.in_view.node._place.translation.getValue().getValue()
    return [x, y, z - 1.5 * view.run.simulation.tool_diameter]


def place_of_cursor(view):
    """(x, y, z) where the path is at the time at which the cursor is drawn."""
    number = view.dock.plot.active
    shown = view.runs[number]
    time, found = view.dock.plot.cursor_time(number), shown.simulation
    return [float(numpy.interp(time, shown.time, values)) for values in (found.x, found.y, found.z)]


def both(view):
    return {"tool": place_of_tool(view), "cursor": place_of_cursor(view)}


def clicks_into_plots(view):
    """Clicks at three times of each run, in each row: the time, and what is shown then."""
    seen, plot = [], view.dock.plot
    for number, shown in enumerate(view.runs):
        for row, share in enumerate((0.31, 0.52, 0.83)):
            time = share * float(shown.time[-1])
            foot = plot.pixel_of(number, row, time)
            click(plot, foot - QtCore.QPointF(0, 20))
            later(50)
            drawn = plot.pixel_of(number, row, plot.cursor_time(number))
            seen.append({"run": number, "off": drawn.x() - foot.x(), **both(view)})
            seen[-1]["active"] = plot.active
    return seen


def clicks_into_view(view):
    """Clicks on three places of the path in the 3D view: the place, and what is shown then."""
    from evenload.gui import picking

    inventor = FreeCADGui.activeDocument().activeView()
    found, seen = view.run.simulation, []
    viewport, size = inventor.graphicsView().viewport(), inventor.getSize()
    ratio = viewport.devicePixelRatioF()
    for share in (0.4, 0.6, 0.8):
        number = int(share * len(found.x))
        while found.kind[number] != 3:
            number += 1
        place = numpy.array([[found.x[number], found.y[number], found.z[number]]])
        pixels, _ = picking.pixels_of(inventor.getCameraNode(), size, place)
        x, y = pixels[0]
        focal = inventor.getPoint(int(round(x)), int(round(y)))
        at = QtCore.QPoint(round(x / ratio), round((size[1] - 1 - y) / ratio))
        click(viewport, at)
        later(100)
        seen.append({"clicked": place[0].tolist(), "focal": [focal.x, focal.y], **both(view)})
    return seen


def zoomed(view):
    """The span that is seen before and after the wheel, and after a double click."""
    plot = view.dock.plot
    foot = plot.pixel_of(0, 0, 0.5 * float(view.runs[0].time[-1])) - QtCore.QPointF(0, 20)
    before = plot._seen()
    everywhere = QtCore.QPointF(plot.mapToGlobal(foot.toPoint()))
    event = QtGui.QWheelEvent(
        *(foot, everywhere, QtCore.QPoint(0, 0), QtCore.QPoint(0, 480)),
        *(QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False),
    )
    QtGui.QApplication.sendEvent(plot, event)
    later(200)
    picture("zoomed")
    seen = [before, plot._seen(), plot.place_at(foot)[1]]
    view.dock.whole.click()
    later(50)
    return [*seen, plot._seen()]


def written(view):
    """The files that the window writes, by answers in place of a file dialog."""
    ask = QtGui.QFileDialog.getSaveFileName
    try:
        for name, save in (
            ("plots.png", view.save_picture),
            ("plots.svg", view.save_picture),
            ("samples.csv", view.save_table),
            (os.path.join("missing", "samples.csv"), view.save_table),
        ):
            QtGui.QFileDialog.getSaveFileName = lambda *_, name=name: (os.path.join(OUT, name), "")
            save()
    finally:
        QtGui.QFileDialog.getSaveFileName = ask
    return view.dock.told.text()


def reported(view):
    """What the window says once it has written the report of the job."""
    ask = QtGui.QFileDialog.getSaveFileName
    QtGui.QFileDialog.getSaveFileName = lambda *_: (os.path.join(OUT, "report"), "")
    try:
        view.save_report()
    finally:
        QtGui.QFileDialog.getSaveFileName = ask
    until(lambda: not view.report.task.is_busy)
    return view.dock.told.text()


def told(view):
    """What the window tells in lengths, beside the simulator's values of the first run."""
    from evenload.simulation.means import worst_force

    dock, found = view.dock, view.runs[0].simulation
    document = QtGui.QTextDocument()
    document.setHtml(dock.totals.text())
    rate = dock.plot.drawn()[0][1]
    return {
        "totals": document.toPlainText().splitlines(),
        "values": dock.values.text(),
        "limit": [dock.limits.removal_rate.value(), dock.limits.removal_rate.suffix()],
        "limits": view.limits(),
        "axis": [rate.get_ylabel(), rate.get_ylim()[1]],
        "found": [found.removal_rate_peak, found.rest_area, worst_force(found)],
    }


def points_of(faces):
    """The vertices of a set of faces in Coin."""
    vertices = faces.vertexProperty.getValue()
    return [list(p.getValue()) for p in vertices.vertex.getValues()]


def areas_seen(view):
    """What the areas of rest are in the 3D view, beside the simulator's outlines."""
    found, shown = view.run.simulation, view.in_view.areas
    outlines = [len(each) for each in found.rest_outlines]
    corners = [list(map(float, p)) for each in found.rest_outlines for p in each]
    return {
        "area": found.rest_area,
        "counts": [list(shown.rest.numVertices.getValues()), outlines],
        "corners": [points_of(shown.rest), corners],
        "in_scene": names_in_scene().count("EvenLoadAreas"),
    }


def gouge_seen():
    """The areas and marks of a path that gouges a wall, put into the scene."""
    import evenload
    from evenload.gui.areas_node import AreasNode

    moves = [(0, 5, 9, 5, 0, 0, 0, 0), (2, 5, 9, -3, 0, 0, 0, 100), (3, 17, 9, -3, 0, 0, 0, 255)]
    around = (-10, -10, 28, 28)
    walls = [[(18, -10, 0), (28, -10, 0), (28, 28, 0), (18, 28, 0)]]
    found = evenload.simulate(moves, around, 0, -12, 6, part=walls)
    node, scene = AreasNode(found), FreeCADGui.activeDocument().activeView().getSceneGraph()
    scene.addChild(node.root)
    save_view("gouge.png")
    scene.removeChild(node.root)
    marks = sum(each.vertexProperty.getValue().vertex.getNum() for each in node.marks)
    return {"points": points_of(node.gouges), "marks": marks, "incidents": len(found.incidents)}


def save_view(name):
    view = FreeCADGui.activeDocument().activeView()
    view.saveImage(os.path.join(OUT, name), 900, 700, "Current")


def session():
    from models import face_of, rectangle

    doc = begun(1390, 1100)
    job, ours, theirs = ours_and_theirs(doc, face_of(rectangle(0, 0, 18, 18)))
    result["actions"] = toolbar_texts().count("EvenLoad Simulation")
    view = command(ours)
    simulated(view)
    result["shown"] = [nodes_in_scene(), docks()]
    result["limits"] = view.limits()
    result["nominal"] = [ours.EngagementAngle.Value, 3 * ours.SideStep.Value * 255]
    result["time"] = [float(view.run.time[-1]), ours.CuttingTime]
    FreeCADGui.SendMsgToActiveView("ViewFit")
    later(200)
    result["from_plot"] = clicks_into_plots(view)
    picture("one")
    result["from_view"] = clicks_into_view(view)
    result["zoom"] = zoomed(view)
    view.dock.slider.setValue(477)
    result["slid"] = both(view)
    # Another beside it, on one scale.
    asked = view.dock.asked
    asked.against.setCurrentIndex(asked.against.findData(theirs.Name))
    simulated(view)
    result["names"] = [each.name for each in view.runs]
    result["scale"] = [
        [[*axes.get_xlim(), *axes.get_ylim()] for axes in column]
        for column in view.dock.plot.drawn()
    ]
    result["removed"] = [each.simulation.removed_volume_total for each in view.runs]
    result["from_both"] = clicks_into_plots(view)
    picture("two")
    save_view("view.png")
    programmed = [float(each.time[-1]) for each in view.runs]
    asked.machine.setCurrentIndex(asked.machine.findData("hobby_router_grbl"))
    simulated(view)
    result["machine"] = [programmed, [float(each.time[-1]) for each in view.runs]]
    view.dock.limits.force_peak.setValue(95)
    later(100)
    picture("machine")
    choose_units(INCHES)
    result["inches"] = told(view)
    picture("inches")
    result["refused"] = written(view)
    result["reported"] = reported(view)
    choose_units(METRIC)
    result["mm"] = told(view)
    result["samples"] = sum(len(each.time) for each in view.runs)
    # A change is followed; the end of an operation ends it, and its user does.
    ours.EngagementAngle, ours.WallPass = 40, False
    doc.recompute()
    later(100)
    simulated(view)
    result["followed"] = view.runs[0].simulation.max_engagement_deg
    view.place(0, 0)
    result["areas"], result["gouge"] = areas_seen(view), gouge_seen()
    save_view("rest.png")
    asked.material.setCurrentIndex((asked.material.currentIndex() + 1) % asked.material.count())
    view.cancel()
    later(300)
    result["cancelled"] = [view.dock.told.text(), len(view.runs), view.dock.bar.isVisible()]
    doc.removeObject(theirs.Name)
    later(300)
    result["deleted"] = [nodes_in_scene(), docks()]
    command(ours).dock.close()
    later(300)
    result["closed"] = [nodes_in_scene(), docks()]
    command(ours)
    FreeCAD.closeDocument(doc.Name)
    later(300)
    result["document_closed"] = docks()


run(session)
