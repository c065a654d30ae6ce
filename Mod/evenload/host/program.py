"""FreeCAD's program without a window, which computes in processes of its own."""

import os
import shutil
import sys

import FreeCAD

# As packages name it: without a window on Linux, and in bundles of all systems.
_NAMES = ("freecadcmd", "FreeCADCmd", "freecadcmd-python3", "FreeCADCmd.exe", "freecadcmd.exe")


def without_window():
    """The path of this FreeCAD's own; raises RuntimeError where there is none."""
    folders = [FreeCAD.ConfigGet("BinPath"), os.path.dirname(sys.executable or "")]
    for folder in filter(None, folders):
        for name in _NAMES:
            if os.path.isfile(os.path.join(folder, name)):
                return os.path.join(folder, name)
    found = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not found:
        raise RuntimeError(
            "FreeCAD's program without a window, freecadcmd, is not where FreeCAD is: install it."
        )
    return found
