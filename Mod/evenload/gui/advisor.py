"""The command Finishing Advisor."""

import FreeCAD
import FreeCADGui

from evenload import host
from evenload.gui.advisor_view import AdvisorView
from evenload.gui.inspection_selection import selected_faces
from evenload.operations.finishing import Finishing
from evenload.settings.sentences import shown

_shown = []  # the AdvisorView that is there


def show():
    """Opens the dock for the selected finishing operation, or for the selected faces of a job, in
    place of one that is open; None, with a sentence in the report view, where that cannot be.
    """
    document = FreeCAD.ActiveDocument
    operation = _selected_operation()
    faces = [] if operation is not None else selected_faces(document.Name)
    job = host.parent_job(operation) if operation is not None else host.job_for_selection()
    if job is None:
        return None
    close()
    try:
        _shown.append(AdvisorView(job, faces, operation, close))
    except ValueError as error:
        FreeCAD.Console.PrintError(shown(str(error)) + "\n")
        return None
    return _shown[-1]


def _selected_operation():
    """The one selected operation EvenLoad Finishing; None without."""
    selected = FreeCADGui.Selection.getSelection()
    if len(selected) != 1 or not isinstance(getattr(selected[0], "Proxy", None), Finishing):
        return None
    return selected[0]


def close():
    """Removes the dock, if there is one."""
    while _shown:
        _shown.pop().remove()
