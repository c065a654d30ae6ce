"""What test_load_view.py runs in FreeCAD's GUI: the load of operations in the 3D view."""

import os
import sys
import time
from types import SimpleNamespace

import FreeCAD
import FreeCADGui
import Path
import numpy
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    INCHES,
    METRIC,
    OUT,
    begun,
    choose_units,
    later,
    on_screen,
    ours_and_theirs,
    result,
    run,
    until,
)

SAMPLES = 100_000
NODE = "EvenLoadLoad"


def nodes_in_scene():
    """The load nodes in the active view's scene."""
    scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
    children = [scene.getChild(i) for i in range(scene.getNumChildren())]
    return [node for node in children if str(node.getName()) == NODE]


def docks():
    from evenload.gui import load_dock

    widgets = [w for w in QtGui.QApplication.allWidgets() if isinstance(w, QtGui.QDockWidget)]
    return [w for w in widgets if w.objectName() == load_dock.NAME and w.isVisible()]


def picture(name):
    FreeCADGui.getMainWindow().grab().save(os.path.join(OUT, name + ".png"))
    view = FreeCADGui.activeDocument().activeView()
    view.saveImage(os.path.join(OUT, name + "_view.png"), 900, 700, "Current")


def vertices_of(view):
    """(places, colours, numbers of vertices of the lines) in the Coin node."""
    path = view.node.path
    places = [list(p.getValue()) for p in path.vertices.vertex.getValues()]
    colours = [list(c.getValue()) for c in path.colours.rgb.getValues()]
    return places, colours, list(path.line.numVertices.getValues())


def seen_of(view, op):
    """What the node holds beside what the simulator tells, for every measure."""
    from evenload.gui import load_colours
    from evenload.simulation import walls

    found = view.found
    places, colours, counts = vertices_of(view)
    samples = numpy.stack([found.x, found.y, found.z], axis=1)
    seen = {
        "samples": len(found.x),
        "vertices": len(places),
        "counts": counts,
        "colours": len(colours),
        "off": float(numpy.abs(numpy.array(places) - samples).max()),
        "measures": {},
    }
    some = [int(i) for i in numpy.random.default_rng(1).choice(len(found.x), 20, replace=False)]
    cuts = [i for i in range(len(found.x)) if found.kind[i] == 3]
    for index in range(view.dock.choice.count()):
        view.dock.choice.setCurrentIndex(index)
        later(100)
        measure = view.measure
        is_kind = measure is load_colours.KIND
        kinds = load_colours.kinds_of(found) if is_kind else found.kind
        _, colours, _ = vertices_of(view)
        values = getattr(found, measure.key)
        least, largest = load_colours.range_of(measure, found)
        seen["measures"][measure.key] = {
            "colours": [colours[i] for i in some],
            "values": [float(values[i]) for i in some],
            "kinds": [int(kinds[i]) for i in some],
            "swatches": [text for _, text in view.dock.legend.swatches()],
            "means": [mean_before(found, values, i) for i in some],
            "worst": max(mean_before(found, values, i) for i in cuts),
            "range": [least, largest],
            "limit": view.limit(),
        }
        picture("%s %s" % (op.Name, measure.key))
    view.dock.choice.setCurrentIndex(0)
    seen["at_walls"] = float(found.length[walls.along_walls(found)].sum())
    return seen


def mean_before(found, values, i, window=0.1):
    """The mean of values over the last 0.1 mm of path before a sample, added up one by one."""
    total, left = 0.0, window
    while i >= 0 and left > 1e-12:
        step = min(left, float(found.length[i]))
        value = float(values[i])
        total += step * (value if value == value else 0.0)
        left -= step
        i -= 1
    return total / window


def cursor(view):
    """The tool at a place of the path, and at the worst one."""
    from pivy import coin

    found, seen = view.found, {}
    number = len(found.x) // 3
    view.dock.slider.setValue(number)
    later(50)
    at = view.node._place.translation.getValue().getValue()
    seen["place"] = [float(v[number]) for v in (found.x, found.y, found.z)]
    seen["tool"] = list(at)
    seen["diameter"] = found.tool_diameter
    seen["told"] = view.dock.values.text()
    view.dock.fly.click()
    later(200)
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    middle = camera.position.getValue() + ahead * camera.focalDistance.getValue()
    worst = view.dock.slider.value()
    seen["worst"] = [float(v[worst]) for v in (found.x, found.y, found.z)]
    seen["middle"] = list(middle.getValue())
    cuts = found.kind == 3
    means = [mean_before(found, found.engagement_deg, i) for i in numpy.flatnonzero(cuts)]
    seen["largest"] = [mean_before(found, found.engagement_deg, worst), max(means)]
    picture("worst")
    return seen


def in_inches(view):
    """What the open dock tells at a place of the path with inches, and then with mm again; beside
    them the simulator's values there.
    """
    number = len(view.found.x) // 3
    view.dock.slider.setValue(number)
    names = "removal_rate", "feed", "h_max", "force_peak"
    seen = {"values": [float(getattr(view.found, name)[number]) for name in names]}
    for name, schema in (("inches", INCHES), ("mm", METRIC)):
        choose_units(schema)
        picture("load_" + name)
        document = QtGui.QTextDocument()
        document.setHtml(view.dock.values.text())
        seen[name] = [line for line in document.toPlainText().splitlines() if line]
    return seen


def hundred_thousand():
    """s, of this thread's work, until a node of so many samples is coloured."""
    from evenload.gui import load_colours
    from evenload.gui.load_node import LoadNode

    rows = numpy.random.default_rng(2).random((4, SAMPLES))
    found = SimpleNamespace(x=rows[0], y=rows[1], z=rows[2], engagement_deg=90 * rows[3])
    found.kind, found.length = numpy.full(SAMPLES, 3), numpy.full(SAMPLES, 0.1)
    found.tool_diameter = 6.0
    measure = load_colours.MEASURES[0]
    begin = time.thread_time()
    node = LoadNode(found)
    node.path.colour(load_colours.colours_of(measure, found, 0, 90, 60))
    spent = time.thread_time() - begin
    assert node.path.vertices.vertex.getNum() == SAMPLES
    return spent


def simulated():
    """Waits for what is under way, if there is a view."""
    from evenload.gui import load_view

    later(100)  # what has changed is followed a moment later
    until(lambda: not any(view.task.is_busy for view in load_view._shown))
    later(50)


def after_earlier(view, earlier):
    """What an operation removes, mm3, before and after one that cuts before it is active."""
    before = view.found.removed_volume_total
    earlier.Active = True
    earlier.Document.recompute()
    simulated()
    return [before, view.found.removed_volume_total]


def without_path(view, op):
    """What the dock tells of an operation that has lost its path, and what is there once more."""
    op.Active = False
    op.Document.recompute()
    simulated()
    seen = [view.dock.told.text(), view.dock.slider.isEnabled(), len(nodes_in_scene())]
    op.Active = True
    op.Document.recompute()
    simulated()
    return [*seen, view.dock.told.isVisible(), view.dock.slider.isEnabled(), len(nodes_in_scene())]


def stopped(view):
    """Cancel while it is simulated anew: what is seen before, what is told, and what stays."""
    view.simulate()
    seen = view.node.root.whichChild.getValue()
    shown = view.dock.cancel.isVisible(), view.dock.bar.isVisible()
    view.dock.cancel.click()
    later(50)
    hidden = view.dock.cancel.isVisible(), view.dock.bar.isVisible()
    return [seen, *shown, *hidden, view.dock.told.text(), len(nodes_in_scene())]


def own_line(op):
    """The number of pixels of the 3D view that have the colour of FreeCAD's line of a path."""
    FreeCADGui.Selection.clearSelection()
    later(300)
    view = FreeCADGui.activeDocument().activeView().graphicsView().viewport()
    image = on_screen(view).toImage().convertToFormat(QtGui.QImage.Format_RGB32)
    pixels = numpy.frombuffer(image.constBits(), numpy.uint8).reshape(-1, 4)[:, 2::-1]
    colour = numpy.round(255 * numpy.array(op.ViewObject.NormalColor[:3]))
    return int((numpy.abs(pixels - colour).max(axis=1) <= 1).sum())


def beside_a_preview(op):
    """What is seen of the load while the panel's preview shows another path, and after Cancel."""
    from evenload.gui import load_view
    from gui_preview_tools import CANCEL, opened, shown, turn
    from gui_tools import press

    command(op)
    (view,) = load_view._shown
    seen = [view.limit(), view.node.root.whichChild.getValue()]
    opened(op)
    turn(op, 35)
    until(lambda: shown(op))
    picture("beside_a_preview")
    label = op.ViewObject.Proxy.panel.featurePages[-1].status._state
    result["status_room"] = [label.height(), label.heightForWidth(label.width())]
    view._choose()
    seen += [view.limit(), view.node.root.whichChild.getValue(), view.dock.told.text()]
    press(CANCEL)
    later(200)
    seen += [view.limit(), view.node.root.whichChild.getValue(), view.dock.told.isVisible()]
    command(op)
    # The same where the preview was there first.
    opened(op)
    turn(op, 35)
    until(lambda: shown(op))
    op.ViewObject.Proxy.panel.featurePages[-1].load.click()
    simulated()
    (view,) = load_view._shown
    seen += [view.node.root.whichChild.getValue(), view.dock.told.text()]
    press(CANCEL)
    later(200)
    seen += [view.node.root.whichChild.getValue(), view.dock.told.isVisible()]
    command(op)
    return seen


def out_of_its_job(op):
    """What the dock tells once an operation has left its job, and once it is there again."""
    from evenload.gui import load_view

    command(op)
    (view,) = load_view._shown
    view.dock.choice.setCurrentIndex(2)
    operations = view.operation.Document.getObject("Operations")
    group = operations.Group
    operations.Group = [each for each in group if each is not op]
    op.touch()
    op.Document.recompute()
    result["provoked"].append(op.Report)
    simulated()
    seen = [view.dock.told.text(), view.found is None]
    operations.Group = group
    op.touch()
    op.Document.recompute()
    simulated()
    seen += [view.dock.told.isVisible(), view.found is None, view.dock.choice.currentIndex()]
    op.Label = "Renamed"
    seen.append(view.dock.windowTitle())
    op.Label = "Ours"
    command(op)
    return seen


def of_a_plain_path(doc):
    """What is there after the command for a path that is no operation's, and what it has said."""
    plain = doc.addObject("Path::Feature", "Plain")
    plain.Path = Path.Path("G0 Z5\nG0 X1\nG1 Z0 F1\nG1 X9")
    doc.recompute()
    result["provoked"].append("'Plain' belongs to no job: put it into one.")
    return command(plain)


def first_stopped(op):
    """What is there after Cancel of the first simulation."""
    from evenload.gui import load_view

    load_view.close()
    view = load_view.show(op)
    view.dock.cancel.click()
    later(100)
    return [len(nodes_in_scene()), len(docks())]


def command(op):
    """Runs the command for an operation as a user does; tells what is there then."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(op)
    later(100)
    FreeCADGui.runCommand("EvenLoad_ShowLoad")
    simulated()
    return [len(nodes_in_scene()), len(docks())]


def session():
    from models import SQUARE, face_of

    doc = begun(1300, 1000)
    job, ours, theirs = ours_and_theirs(doc, face_of(SQUARE))
    result["before"] = len(nodes_in_scene())
    theirs.ViewObject.Visibility = False  # its line has the same colour
    before = own_line(ours)
    result["ours_shown"] = command(ours)
    result["own_line"] = [before, own_line(ours)]
    theirs.ViewObject.Visibility = True
    from evenload.gui import load_view

    view = load_view._shown[0]
    result["ours"] = seen_of(view, ours)
    result["cursor"] = cursor(view)
    result["units"] = in_inches(view)
    swatches = [text for _, text in view.dock.legend.swatches()]
    result["legend"] = [view.dock.windowTitle(), view.dock.legend.isVisible(), swatches]
    # A change of the path is followed.
    ours.EngagementAngle = 40
    doc.recompute()
    simulated()
    result["same_view"] = view is load_view._shown[0]
    result["followed"] = [view.found.max_engagement_deg, len(nodes_in_scene()), len(docks())]
    result["ours_hidden"] = command(ours)
    result["first_stopped"] = first_stopped(ours)
    result["out_of_its_job"] = out_of_its_job(ours)
    result["beside_a_preview"] = beside_a_preview(ours)
    # Another one, of FreeCAD's own, which no other has cut before; then it is deleted.
    ours.Active = False
    doc.recompute()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    result["theirs_shown"] = command(theirs)
    result["theirs"] = seen_of(load_view._shown[0], theirs)
    result["after_earlier"] = after_earlier(load_view._shown[0], ours)
    result["no_path"] = without_path(load_view._shown[0], theirs)
    result["stopped"] = stopped(load_view._shown[0])
    result["plain"] = of_a_plain_path(doc)
    command(theirs)
    doc.removeObject(theirs.Name)
    later(200)
    result["deleted"] = [len(nodes_in_scene()), len(docks())]
    # A dock that its user closes; a document that is closed.
    command(ours)
    docks()[0].close()
    later(200)
    result["dock_closed"] = [len(nodes_in_scene()), len(docks())]
    command(ours)
    FreeCAD.closeDocument(doc.Name)
    later(300)
    result["document_closed"] = len(docks())
    result["seconds"] = hundred_thousand()


run(session)
