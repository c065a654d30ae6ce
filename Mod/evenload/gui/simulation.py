"""The command Simulation."""

import FreeCAD

from evenload.gui import load_view
from evenload.gui.simulation_view import SimulationView

_shown = []  # the SimulationView that is there


def show(operation):
    """Opens the window Simulation for an operation, in place of one that is open and of Show Load;
    None, with a sentence in the report view, where there is no 3D view.
    """
    close()
    load_view.close()
    try:
        _shown.append(SimulationView(operation, close))
    except ValueError as error:
        FreeCAD.Console.PrintError("%s\n" % error)
        return None
    return _shown[-1]


def close():
    """Removes the window, if there is one."""
    while _shown:
        _shown.pop().remove()
