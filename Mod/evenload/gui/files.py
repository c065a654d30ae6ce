"""Files that a window writes."""

import os

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import colours

PICTURES = "PNG (*.png);;SVG (*.svg)"

_translate = FreeCAD.Qt.translate


def asked_name(parent, title, filters, extension):
    """The name of a file to write, with an extension; '' where the user cancels."""
    path, _ = QtGui.QFileDialog.getSaveFileName(parent, _translate("EvenLoad", title), "", filters)
    return path + extension if path and not os.path.splitext(path)[1] else path


def refusal(error):
    """The sentence for an OSError that a file was not written for."""
    told = _translate("EvenLoad", "The file cannot be written (%s): name another one.")
    return told % (error.strerror or error)


def write(writes, tell):
    """Whether a file was written by writes(), which may take its time. tell(sentence, colour): told
    why not.
    """
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        writes()
    except OSError as error:
        tell(refusal(error), colours.BAD)
        return False
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    return True
