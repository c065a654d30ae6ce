"""What test_compare_and_report.py runs in FreeCAD's GUI: the commands Compare and Report."""

import os
import sys
import threading

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gui_tools import (  # noqa: E402
    OUT,
    answering,
    begun,
    is_enabled,
    later,
    ours_and_theirs,
    picture,
    result,
    run,
    toolbar_texts,
    until,
    widgets,
)

COMPARE, REPORT = "EvenLoad_Compare", "EvenLoad_Report"


def select(*objects):
    FreeCADGui.Selection.clearSelection()
    for each in objects:
        FreeCADGui.Selection.addSelection(each)
    later(100)


def ended(task):
    """Waits until a task is done; the window has to be alive meanwhile."""
    until(lambda: not task.is_busy)


def windows():
    from evenload.gui import simulation_dock

    docks = [w for w in widgets(QtGui.QDockWidget) if w.objectName() == simulation_dock.NAME]
    return len([w for w in docks if w.isVisible()])


def compared():
    """The names in the window that Compare opens, and the scales of both."""
    from evenload.gui import simulation

    FreeCADGui.runCommand(COMPARE)
    (view,) = simulation._shown
    ended(view.task)
    columns = view.dock.plot.drawn()
    scales = [[[*each.get_xlim(), *each.get_ylim()] for each in axes] for axes in columns]
    asked = view.dock.asked
    return {
        "runs": [each.name for each in view.runs],
        "asked": [asked.operation.currentText(), asked.against.currentText()],
        "scales": scales,
    }


def chosen(answer):
    """What Compare offers beside the one operation, and what it opens when it is answered."""
    from evenload.gui import simulation

    offered = []

    def tell(dialog):
        box = next(b for b in widgets(QtGui.QComboBox) if b.window() is dialog)
        offered.append([box.itemText(i) for i in range(box.count())])
        getattr(dialog, answer)()

    with answering(tell) as seen:
        FreeCADGui.runCommand(COMPARE)
    later(100)
    return {"titles": seen, "offered": offered[0], "windows": len(simulation._shown)}


def written(name):
    """What Report does where the user names a file, or none."""
    from evenload.gui import report, simulation_report

    opened, ask = [], QtGui.QFileDialog.getSaveFileName
    browse, drawn, draw = QtGui.QDesktopServices.openUrl, [], simulation_report.report_of

    def drawn_in(*facts):
        drawn.append(threading.current_thread() is threading.main_thread())
        return draw(*facts)

    simulation_report.report_of = drawn_in
    QtGui.QFileDialog.getSaveFileName = lambda *_: (name and os.path.join(OUT, name), "")
    QtGui.QDesktopServices.openUrl = lambda url: opened.append(url.toLocalFile()) or True
    try:
        FreeCADGui.runCommand(REPORT)
        dialogs = [each.dialog.isVisible() for each in report._shown]
        for each in report._shown:
            ended(each.report.task)
        # By itself Qt shows a dialog of progress after so long where nothing is done yet.
        waits = [each.dialog.minimumDuration() for each in report._shown]
    finally:
        QtGui.QFileDialog.getSaveFileName = ask
        QtGui.QDesktopServices.openUrl = browse
        simulation_report.report_of = draw
    return {"dialogs": dialogs, "opened": opened, "waits": waits, "in_windows_thread": drawn}


def stopped():
    """Whether anything is under way, seen or written after Cancel in the dialog of Report."""
    from evenload.gui import report

    ask = QtGui.QFileDialog.getSaveFileName
    QtGui.QFileDialog.getSaveFileName = lambda *_: (os.path.join(OUT, "cancelled.html"), "")
    try:
        FreeCADGui.runCommand(REPORT)
    finally:
        QtGui.QFileDialog.getSaveFileName = ask
    (shown,) = report._shown
    shown.dialog.canceled.emit()
    later(500)
    return [shown.report.task.is_busy, shown.dialog.isVisible()]


def active(*objects):
    """Whether each of the two commands can be used with these selected."""
    select(*objects)
    return [is_enabled(COMPARE), is_enabled(REPORT)]


def session():
    from evenload.gui import simulation
    from models import face_of, rectangle

    FreeCADGui.Selection.clearSelection()
    result["enabled"] = {"without a document": [is_enabled(COMPARE), is_enabled(REPORT)]}
    doc = begun(1390, 1100)
    job, ours, theirs = ours_and_theirs(doc, face_of(rectangle(0, 0, 18, 18)))
    bars = toolbar_texts()
    result["toolbar"] = [bars.count("EvenLoad Compare"), bars.count("EvenLoad Report")]
    infos = [FreeCADGui.Command.get(name).getInfo() for name in (COMPARE, REPORT)]
    result["icons"] = [not FreeCADGui.getIcon(info["pixmap"]).isNull() for info in infos]
    result["enabled"].update(
        nothing=active(),
        job=active(job),
        one=active(ours),
        two=active(ours, theirs),
        operation_and_job=active(ours, job),
        model=active(job.Model.Group[0]),
    )
    select(theirs, ours)
    result["two"] = compared()
    picture("two")
    simulation.close()
    select(ours)
    result["cancelled"] = chosen("reject")
    result["one"] = chosen("accept")
    simulation.close()
    select(job)
    result["no_file"] = written("")
    result["written"] = written("job")
    result["missing"] = written(os.path.join("missing", "job.html"))
    result["provoked"].append("cannot be written")
    result["stopped"] = stopped()
    # One operation without another, and a job none of whose operations has a path.
    doc.removeObject(theirs.Name)
    result["enabled"]["the only one"] = active(ours)
    ours.Active = False
    doc.recompute()
    result["enabled"]["without a path"] = active(ours)
    FreeCAD.closeDocument(doc.Name)


run(session)
