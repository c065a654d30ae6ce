"""The documentation: which page tells of what, for FreeCAD's What's This and for F1.

What's This is FreeCAD's own (Shift+F1, then a click): it opens the address that a command or a
widget has. F1 opens FreeCAD's start page, but where one of our widgets has the focus,
which takes the key for its page.
"""

import os

from PySide import QtCore, QtGui

from evenload import host
from evenload.gui.icons import DOCS


def address(page):
    """The address of a page by its name: as HTML, which installing makes, or in a checkout as it is
    written.
    """
    path = os.path.join(DOCS, page + ".html")
    if not os.path.isfile(path):
        path = os.path.join(DOCS, page + ".md")
    return QtCore.QUrl.fromLocalFile(path).toString()


class _Helped:
    """A widget with a page."""

    page = None

    def set_page(self, page):
        """Opens a page, by its name, for What's This and F1 in this widget."""
        self.page = page
        self.setWhatsThis(address(page))

    def event(self, event):
        # PySide 2 may hand a dead object that lay in the event's place.
        if not isinstance(event, QtCore.QEvent):
            return False
        if self.page is None or not _is_help(event):
            return super().event(event)
        event.accept()  # FreeCAD's own command does not get the key then
        if event.type() == QtCore.QEvent.KeyPress:
            host.show_help(address(self.page))
        return True


def _is_help(event):
    if event.type() not in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
        return False
    return event.key() == QtCore.Qt.Key_F1 and event.modifiers() == QtCore.Qt.NoModifier


class Widget(_Helped, QtGui.QWidget):
    """A part of one of FreeCAD's panels."""


class Dock(_Helped, QtGui.QDockWidget):
    """A dock."""


class Dialog(_Helped, QtGui.QDialog):
    """A window of its own."""
