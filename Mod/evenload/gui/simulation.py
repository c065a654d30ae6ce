"""The commands Simulation and Compare."""

import FreeCAD
import FreeCADGui
from PySide import QtGui

from evenload import host
from evenload.gui import load_view
from evenload.gui.simulation_view import SimulationView
from evenload.settings.sentences import shown

_translate = FreeCAD.Qt.translate
_shown = []  # the SimulationView that is there


def show(operation, against=None):
    """Opens the window Simulation for an operation, with another one beside it where one is given,
    in place of one that is open and of Show Load; None, with a sentence in the report view, where
    there is no 3D view.
    """
    close()
    load_view.close()
    try:
        _shown.append(SimulationView(operation, close, against))
    except ValueError as error:
        FreeCAD.Console.PrintError(shown(str(error)) + "\n")
        return None
    return _shown[-1]


def compare(operation, against=None):
    """The same for two operations. The user is asked for the other where only one is given; None
    where he cancels.
    """
    against = against or _asked_other(operation)
    return show(operation, against) if against is not None else None


def close():
    """Removes the window, if there is one."""
    while _shown:
        _shown.pop().remove()


def _asked_other(operation):
    """One of the other operations of its job that have a path, None where the user cancels."""
    others = [each for each in host.with_path(host.parent_job(operation)) if each != operation]
    labels = [each.Label for each in others]
    # Two may have one label.
    rows = [
        each.Label if labels.count(each.Label) == 1 else "%s (%s)" % (each.Label, each.Name)
        for each in others
    ]
    chosen, is_taken = QtGui.QInputDialog.getItem(
        FreeCADGui.getMainWindow(),
        _translate("EvenLoad", "EvenLoad Compare"),
        _translate("EvenLoad", "Compare %s with") % operation.Label,
        *(rows, 0, False),
    )
    return others[rows.index(chosen)] if is_taken else None
