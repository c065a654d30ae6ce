"""Which FreeCAD this is, and where it keeps its modules: 0.20 (PathScripts, workbench "Path"), 1.0
(Path.Op, workbench "CAM") and 1.1 (tool bits are assets).
"""

import functools
import importlib
from types import SimpleNamespace

import FreeCAD

_VERSION = tuple(int(number) for number in FreeCAD.Version()[:2])
MOVED = _VERSION >= (0, 21)  # PathScripts.PathOp has become Path.Op.Base, and so on
CAM = _VERSION >= (1, 0)  # the workbench Path has become CAM
ASSETS = _VERSION >= (1, 1)  # Path.Tool.Bit has become Path.Tool.toolbit, and shapes are assets


@functools.lru_cache(maxsize=None)
def cam():
    """FreeCAD's modules for operations and jobs, by short names. The first call takes 0.7 s."""
    import PathScripts.PathUtils as utils

    if MOVED:
        import Path.Base.SetupSheet as setup_sheet
        import Path.Main.Job as job
        import Path.Main.Stock as stock
        import Path.Op.Base as op
        import Path.Preferences as preferences
        import Path.Tool.Controller as controller

        bit = importlib.import_module("Path.Tool." + ("toolbit" if ASSETS else "Bit"))
    else:
        import PathScripts.PathJob as job
        import PathScripts.PathOp as op
        import PathScripts.PathPreferences as preferences
        import PathScripts.PathSetupSheet as setup_sheet
        import PathScripts.PathStock as stock
        import PathScripts.PathToolBit as bit
        import PathScripts.PathToolController as controller
    return SimpleNamespace(
        utils=utils,
        setup_sheet=setup_sheet,
        job=job,
        stock=stock,
        op=op,
        preferences=preferences,
        bit=bit,
        controller=controller,
    )
