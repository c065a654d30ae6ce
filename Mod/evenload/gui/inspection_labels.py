"""Sentences in the dock Inspect, with lengths in the unit that the user has chosen."""

import contextlib
import re

from PySide import QtCore, QtGui

from evenload.gui import colours, fields, files
from evenload.inspection.points import SHOWN, mm_per
from evenload.settings.sentences import shown

# A length as sentences on what cannot be tell it; feeds are no lengths.
IN_MM = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) mm\b(?!/)")


def unit():
    """ "mm" or "inch", as the user has chosen."""
    return "inch" if fields.shows_inches() else "mm"


def in_users_unit(text):
    """A sentence in English that tells lengths in mm, in the user's language and unit."""
    text = shown(text)  # first: its patterns have mm
    if unit() == "mm":
        return text
    name = SHOWN["inch"][0]
    return IN_MM.sub(lambda found: "%.4g %s" % (float(found[1]) / mm_per("inch"), name), text)


def tell(where, text, colour=None):
    """Tells a text in a label, a sentence in the user's language."""
    where.tell(shown(text), colour)


@contextlib.contextmanager
def telling(where):
    """While something takes its time; why it cannot be is told in a label."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    except ValueError as error:
        tell(where, in_users_unit(str(error)), colours.BAD)
    except OSError as error:
        tell(where, files.refusal(error), colours.BAD)
    finally:
        QtGui.QApplication.restoreOverrideCursor()
