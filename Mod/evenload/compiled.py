"""The compiled modules, or one sentence that says why they cannot be had."""

import importlib
import importlib.util
import sysconfig


class NotBuiltError(ImportError):
    """The compiled modules are missing, or were built for another Python or OpenCASCADE."""


def core():
    """The module _core: regions, offsets and toolpaths. Raises NotBuiltError."""
    return _load("_core")


def occt():
    """The module _occt: regions from shapes. Raises NotBuiltError.

    It is linked to OpenCASCADE: one built for another version would take FreeCAD down, so the
    versions are compared first.
    """
    import Part

    try:
        from evenload import _build
    except ImportError:
        raise NotBuiltError(missing()) from None
    if _build.OCC_VERSION != Part.OCC_VERSION:
        raise NotBuiltError(missing())
    return _load("_occt")


def missing():
    """The sentence for a FreeCAD without compiled modules for it; None when they are there."""
    import Part

    python, occ = sysconfig.get_python_version(), Part.OCC_VERSION
    remedy = "run './run install' in EvenLoad's source tree."
    try:
        from evenload import _build
    except ImportError:
        return "EvenLoad's compiled modules are missing: %s" % remedy
    if _build.OCC_VERSION != occ:
        return "EvenLoad was built for OpenCASCADE %s, but this FreeCAD runs on %s: %s" % (
            _build.OCC_VERSION,
            occ,
            remedy,
        )
    for name in ("_core", "_occt"):
        if importlib.util.find_spec("evenload." + name) is None:
            return "EvenLoad's compiled modules for Python %s are missing: %s" % (python, remedy)
    return None


def _load(name):
    try:
        return importlib.import_module("evenload." + name)
    except ImportError as error:
        raise NotBuiltError(missing() or "EvenLoad's module %s: %s." % (name, error)) from None
