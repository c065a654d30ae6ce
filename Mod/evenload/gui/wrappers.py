"""Python's wrappers of Qt's objects, which may outlive these.

PySide 2 keeps for ever what a slot in Python is connected to. When Qt deletes such a widget and
makes another in its place, PySide takes the one for the other, and Python is told that the new one
is deleted: panels, FreeCAD's too, fail to open then.
"""

from importlib import import_module

from PySide import QtCore

from evenload.compiled import core

# PySide 6 keeps nothing.
_shiboken = import_module("shiboken2") if QtCore.qVersion().startswith("5.") else None


def forget_the_dead():
    """Has PySide forget the wrappers of all objects that Qt has deleted: in some hundredths of a
    second, so that it is for the opening and the end of panels. Threads that are busy meanwhile are
    not disturbed (_core.objects_of_type).
    """
    if _shiboken is None:
        return
    for wrapper in core().objects_of_type(QtCore.QObject):
        if not _shiboken.isValid(wrapper):
            _shiboken.invalidate(wrapper)
