"""The compiled modules, or one sentence that says why they cannot be had.

Those for several FreeCADs lie side by side: Python's suffix in their file names says which Python
they are for, and the name of the one that is linked to OpenCASCADE says which version of that.
"""

import importlib
import importlib.util
import os
import re
import sysconfig

REMEDY = "build EvenLoad for it with './run install' in its source tree (README.md)."


class NotBuiltError(ImportError):
    """The compiled modules are missing, or none of them is for this Python and OpenCASCADE."""


def core():
    """The module _core: regions, offsets and toolpaths. Raises NotBuiltError."""
    return _load("_core")


def occt():
    """The module _occt_X_Y_Z of this FreeCAD's OpenCASCADE: regions from shapes. Raises
    NotBuiltError. One that is linked to another version would take FreeCAD down.
    """
    return _load(_occt_name())


def missing():
    """The sentence for a FreeCAD without compiled modules for it; None when they are there."""
    if all(importlib.util.find_spec("evenload." + name) for name in ("_core", _occt_name())):
        return None
    wanted = "Python %s and OpenCASCADE %s" % (sysconfig.get_python_version(), _occ_version())
    found = sorted(_built_for(os.path.dirname(os.path.abspath(__file__))))
    if not found:
        return "EvenLoad's compiled modules are missing, for %s: %s" % (wanted, REMEDY)
    return "This FreeCAD has %s, EvenLoad's compiled modules are for %s: %s" % (
        wanted,
        "; ".join("Python %s and OpenCASCADE %s" % each for each in found),
        REMEDY,
    )


def _occ_version():
    import Part

    return Part.OCC_VERSION


def _occt_name():
    return "_occt_" + _occ_version().replace(".", "_")


def _built_for(folder):
    """{(Python's version, OpenCASCADE's version)} of the modules in a folder."""
    found = set()
    for file in os.listdir(folder):
        match = re.match(r"_occt_([0-9_]+)\.(?:cpython-|cp)3([0-9]+)", file)
        if match:
            found.add(("3." + match[2], match[1].replace("_", ".")))
    return found


def _load(name):
    try:
        return importlib.import_module("evenload." + name)
    except ImportError as error:
        raise NotBuiltError(missing() or "EvenLoad's module %s: %s." % (name, error)) from None
