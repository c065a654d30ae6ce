"""Sentences in the dock Inspect, with lengths in the unit that the user has chosen."""

import contextlib

from PySide import QtCore, QtGui

from evenload.gui import colours, fields, files
from evenload.settings.sentences import shown


def unit():
    """ "mm" or "inch", as the user has chosen."""
    return "inch" if fields.shows_inches() else "mm"


def tell(where, text, colour=None):
    """Tells sentences in a Shaded label, in the user's language and units."""
    where.tell(shown(text), colour)


def name(where, text, colour=None):
    """Shows a text in a Shaded label as it is: what the user has given names to."""
    where.tell(text, colour)


@contextlib.contextmanager
def telling(where):
    """While something takes its time; why it cannot be is told in a label."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    except ValueError as error:
        tell(where, str(error), colours.BAD)
    except OSError as error:
        tell(where, files.refusal(error), colours.BAD)
    finally:
        QtGui.QApplication.restoreOverrideCursor()
