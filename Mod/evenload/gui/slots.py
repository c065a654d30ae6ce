"""Slots that keep nothing alive.

A page and its widgets that held each other would stay until Python looks for cycles. By then Qt may
have made other widgets in the places of those, and PySide would take these for the old ones:
FreeCAD 0.20's Job panel fails to open then.
"""

import weakref


def slot(method, *arguments):
    """A slot that calls method(*arguments), whatever its signal tells, and does not keep the
    method's object alive.
    """
    weakly = weakref.WeakMethod(method)

    def call(*_):
        living = weakly()
        if living is not None:
            living(*arguments)

    return call


def telling_slot(method):
    """The same for a method that gets what the signal tells."""
    weakly = weakref.WeakMethod(method)

    def call(*told):
        living = weakly()
        return living(*told) if living is not None else None

    return call
