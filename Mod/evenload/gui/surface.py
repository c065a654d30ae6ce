"""The command Show Surface."""

import FreeCAD

from evenload.gui.surface_view import SurfaceView
from evenload.settings.sentences import shown

_shown = []  # the SurfaceView that is there


def toggle(operation):
    """Shows the surface that an operation leaves, or hides it where it is the one that is shown."""
    before = _shown[0].operation if _shown else None
    close()
    if operation is not before:
        show(operation)


def show(operation):
    """Opens the dock for an operation, in place of one that is open; None, with a sentence in the
    report view, where there is no 3D view.
    """
    close()
    try:
        _shown.append(SurfaceView(operation, close))
    except ValueError as error:
        FreeCAD.Console.PrintError(shown(str(error)) + "\n")
        return None
    return _shown[-1]


def close():
    """Removes the dock and its colours, if there are any."""
    while _shown:
        _shown.pop().remove()
