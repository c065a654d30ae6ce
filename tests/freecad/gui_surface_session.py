"""What test_surface_view.py runs in FreeCAD: the surface of a Finishing operation as colours on its
faces, with pictures in $EVENLOAD_GUI_OUT.
"""

import os
import sys

import FreeCAD
import FreeCADGui
import numpy
from pivy import coin
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from finishing_parts import part, upper  # noqa: E402
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    later,
    picture,
    result,
    run,
    until,
    widgets,
)

NODE = "EvenLoadSurface"


def nodes_in_scene():
    scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
    children = [scene.getChild(i) for i in range(scene.getNumChildren())]
    return len([node for node in children if str(node.getName()) == NODE])


def docks():
    from evenload.gui import surface_dock

    found = [w for w in widgets(QtGui.QDockWidget) if w.objectName() == surface_dock.NAME]
    return len([w for w in found if w.isVisible()])


def shown():
    from evenload.gui import surface

    return surface._shown


def command():
    FreeCADGui.runCommand("EvenLoad_ShowSurface")
    later(100)


def ended(view):
    """Waits until the simulation has ended."""
    until(lambda: not view.task.is_busy)


def select(obj):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)


def job_on(doc):
    from evenload import host
    from evenload.operations import finishing

    solid = doc.addObject("Part::Feature", "Part")
    solid.Shape = part(True)
    doc.recompute()
    job, controller = host.create_job(doc, [solid], 10.0, 1632, 5100, 4)
    controller.Tool = host.create_tool("ballend", {"Diameter": 10.0, "Flutes": 4})
    model = job.Model.Group[0]
    op = finishing.Create("Finishing", parentJob=job, toolController=controller)
    op.ViewObject.Visibility = True
    op.Base = [(model, upper(model.Shape))]
    op.Stepover = 0.8
    doc.recompute()
    return op


def seen_of(view):
    """What the node has for each measure."""
    found = {}
    node = view.node
    for index in range(view.dock.choice.count()):
        view.dock.choice.setCurrentIndex(index)
        later(50)
        colours = node._colour.rgb.getNum()
        values = view.values()
        legend = view.dock.legend
        known = values[numpy.isfinite(values)]
        found[view.measure.key] = {
            "title": view.dock.choice.currentText(),
            "colours": colours,
            "kinds": len({tuple(c.getValue()) for c in node._colour.rgb.getValues()[::50]}),
            "largest": float(known.max()),
            "some": colours_at(view),
            "scale": [legend._least, scale_of(legend)[1]],
            "swatches": [text for _, text in legend.swatches()],
        }
        FreeCADGui.SendMsgToActiveView("ViewFit")
        later(100)
        picture("surface_" + view.measure.key)
        active = FreeCADGui.activeDocument().activeView()
        active.saveImage(os.path.join(OUT, "view_%s.png" % view.measure.key), 700, 600, "Current")
    return found


def colours_at(view, count=20):
    """[(the colour of a vertex, the one that its place's value has on the scale), ...]"""
    from evenload.gui import load_colours, preferences, surface_measures

    found, values = view.known.found, view.values()
    points = view.node.root.getChild(5).vertexProperty.getValue().vertex.getValues()
    colours = view.node._colour.rgb.getValues()
    rows = []
    for number in numpy.random.default_rng(5).choice(len(points), count, replace=False):
        x, y, _ = points[number].getValue()
        cell = numpy.abs(found.y - y).argmin(), numpy.abs(found.x - x).argmin()
        if not found.is_covered[cell] and view.measure.key != "gouge":
            wanted = surface_measures.BARE
        elif numpy.isnan(values[cell]):
            wanted = load_colours.KINDS[1]
        else:
            share = values[cell] / surface_measures.largest_of(values)
            wanted = load_colours.on_scale([share], preferences.scale())[0]
        rows.append([list(colours[number].getValue()), list(map(float, wanted))])
    return rows


def aim_after_flight(view):
    """[(where the camera looks, the place of the largest value), mm that it shows]"""
    view.fly()
    later(100)
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    aim = camera.position.getValue() + ahead * camera.focalDistance.getValue()
    found, values = view.known.found, view.values()
    row, column = numpy.unravel_index(numpy.nanargmax(values), values.shape)
    place = found.x[column], found.y[row], found.part[row, column]
    return [list(aim.getValue()), list(map(float, place)), camera.height.getValue()]


def scale_of(legend):
    """(the unit of a legend's scale, its largest value in that unit)"""
    unit = legend._measure.quantity.shown
    return unit.name, legend._largest / unit.size


def in_other_units(view):
    """What the dock shows with inches, and in a language with a decimal comma."""
    choose_units(INCHES)
    legend = view.dock.legend
    found = {"inches": [view.dock.figures.text(), *scale_of(legend)]}
    picture("surface_inches")
    choose_units(METRIC)
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
    later(100)
    view.dock.choice.setCurrentIndex(1)
    view.dock.choice.setCurrentIndex(0)
    found["comma"] = [view.dock.figures.text(), *scale_of(legend)]
    QtCore.QLocale.setDefault(before)
    return found


def pictures_of(view):
    """The first bytes of the picture that is written for each measure."""
    from evenload.gui import files

    asked, found = files.asked_name, []
    for index in range(view.dock.choice.count()):
        view.dock.choice.setCurrentIndex(index)
        path = os.path.join(OUT, "written_%d.png" % index)
        files.asked_name = lambda *_, path=path: path
        view.save()
        with open(path, "rb") as file:
            found.append(file.read(4).hex())
    files.asked_name = asked
    return found


def session():
    doc = begun(1300, 900)
    op = job_on(doc)
    FreeCADGui.activeDocument().activeView().viewIsometric()
    result["before"] = [nodes_in_scene(), docks()]
    select(op)
    command()
    (view,) = shown()
    result["busy"] = view.task.is_busy and view.dock.bar.isVisible()
    ended(view)
    result["shown"] = [nodes_in_scene(), docks()]
    result["bar_gone"] = not view.dock.bar.isVisible()
    result["seen"] = seen_of(view)
    result["vertices"] = view.node.root.getChild(5).vertexProperty.getValue().vertex.getNum()
    result["figures"] = view.dock.figures.text()
    found = view.known.found
    result["mean_cusp"] = found.mean_cusp
    over = found.roughness_map
    result["rough"] = {"rz_along": over.rz_along.tolist(), "rz_across": over.rz_across.tolist()}
    result["told"] = view.dock.told.text()
    view.dock.choice.setCurrentIndex(0)
    before = view.known
    result["flown"] = aim_after_flight(view)
    result["units"] = in_other_units(view)
    result["uncovered"] = found.uncovered_area
    result["pictures"] = pictures_of(view)
    # A changed path is simulated anew.
    op.Stepover = 1.2
    doc.recompute()
    later(200)
    ended(view)
    result["follows"] = view.known is not before and view.known.found.mean_cusp > found.mean_cusp
    # What is under way can be stopped, and what was known stays.
    view.simulate()
    view.cancel()
    later(200)
    result["cancelled"] = view.dock.told.text()
    result["after_cancel"] = [view.task.is_busy, view.known is not None, nodes_in_scene()]
    # A tool that cannot be simulated takes the colours away, and says why.
    from evenload import host

    ball = op.ToolController.Tool
    op.ToolController.Tool = host.create_tool("v-bit", {"Diameter": 6.0})
    view.simulate()
    result["refused"] = [view.dock.told.text(), nodes_in_scene(), view.dock.choice.count()]
    op.ToolController.Tool = ball
    # The command takes all of it away again.
    select(op)
    command()
    result["closed"] = [nodes_in_scene(), docks(), len(shown())]
    # Nothing is read any more once it is gone.
    command()
    (view,) = shown()
    ended(view)
    op.touch()
    doc.recompute()
    is_waiting = view._again.isActive()
    from evenload.gui import surface

    surface.close()
    result["waiting"] = [is_waiting, view._again.isActive()]
    later(100)
    # So does closing its dock, or the document.
    command()
    ended(shown()[0])
    shown()[0].dock.close()
    later(200)
    result["dock_closed"] = [nodes_in_scene(), docks(), len(shown())]
    select(op)
    command()
    FreeCAD.closeDocument(doc.Name)
    later(200)
    result["document_closed"] = [docks(), len(shown())]


run(session)
