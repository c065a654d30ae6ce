"""The command Inspect."""

import FreeCAD
import FreeCADGui

from evenload.gui.inspection_selection import selected_faces
from evenload.gui.inspection_view import InspectionView

_shown = []  # the InspectionView that is there


def create():
    """Shows the dock for the selected faces, or gives these to the dock that is there; None, with a
    sentence in the report view, where that cannot be.
    """
    document = FreeCAD.ActiveDocument
    if _shown and _shown[-1].document is document:
        _shown[-1].take_selection()
        return _shown[-1]
    close()
    base = selected_faces(document.Name) if document is not None else []
    try:
        _shown.append(InspectionView(document, base, close))
    except ValueError as error:
        FreeCAD.Console.PrintError("%s\n" % error)
        return None
    FreeCADGui.Selection.clearSelection()  # its green would hide the colours
    return _shown[-1]


def close():
    """Removes the dock, if there is one."""
    while _shown:
        _shown.pop().remove()
