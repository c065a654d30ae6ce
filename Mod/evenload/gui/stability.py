"""The command Stability chart."""

import FreeCAD
import FreeCADGui

from evenload import host
from evenload.gui.stability_window import StabilityWindow

_translate = FreeCAD.Qt.translate


class _Open:
    window = None  # the one that is open, which Python would take for garbage else


def create():
    """Opens the window for the selected operation, else the job's last one that has a tool; None
    where there is none, or where the user cancels the choice of the job.
    """
    operation = _selected()
    if operation is None:
        job = host.job_for_selection()
        if job is None:  # the user has cancelled the choice of one
            return None
        operation = next(filter(_has_tool, reversed(host.operations(job))), None)
    if operation is None:
        FreeCAD.Console.PrintError(
            _translate("EvenLoad", "The job has no operation with a tool: create one first.") + "\n"
        )
        return None
    close()
    _Open.window = StabilityWindow(operation)
    _Open.window.closed.connect(_forget)
    _Open.window.show()
    return _Open.window


def close():
    """Closes the window that is open."""
    if _Open.window is not None:
        _Open.window.close()


def _forget(*_):
    _Open.window = None


def _selected():
    return next(filter(_has_tool, FreeCADGui.Selection.getSelection()), None)


def _has_tool(obj):
    return host.has_path(obj) and host.controller_of(obj) is not None
