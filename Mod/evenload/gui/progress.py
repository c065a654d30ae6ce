"""Progress of a computation, and its Cancel button."""

import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

DELAY = 0.3  # s: what takes less shows no dialog; who waits for longer than half a second wonders
WINDOWS_OWN = QtCore.QEventLoop.ExcludeUserInputEvents
REFRESH = 0.05  # s: how often the dialog is brought up to date and Cancel is looked at
SCALE = 1000  # steps of the progress bar
WIDTH = 280  # pixels of the progress bar, so that the title can be read

_translate = FreeCAD.Qt.translate


class Watch:
    """What the core asks while it works: watch(share) -> whether to go on; a share of None is not
    known.

    A context, at whose end the dialog vanishes. Until it shows, the window draws itself, and what
    its user does waits; while it shows, nothing but its button can be used.
    """

    def __init__(self, title):
        self._title = title
        self._dialog = self._bar = None
        self._cancelled = False
        self._shows_at = time.monotonic() + DELAY
        self._next = 0.0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._dialog is not None:
            QtGui.QApplication.restoreOverrideCursor()
            self._dialog.hide()
            self._dialog.deleteLater()
            self._dialog = None

    def __call__(self, share):
        now = time.monotonic()
        if self._cancelled or now < self._next:
            return not self._cancelled
        if now < self._shows_at:
            QtGui.QApplication.processEvents(WINDOWS_OWN)
            self._next = time.monotonic() + REFRESH
            return True
        if self._dialog is None:
            self._show()
        if share is not None:
            self._bar.setValue(round(SCALE * share))
        QtGui.QApplication.processEvents()
        self._next = time.monotonic() + REFRESH
        self._cancelled = self._dialog.clickedButton() is not None
        return not self._cancelled

    def _show(self):
        # A message box: while FreeCAD recomputes, it takes the mouse from every other dialog.
        self._dialog = QtGui.QMessageBox(FreeCADGui.getMainWindow())
        self._dialog.setWindowTitle(self._title)
        self._dialog.setText(_translate("EvenLoad", "Computing the path"))
        self._dialog.setStandardButtons(QtGui.QMessageBox.Cancel)
        self._dialog.setWindowModality(QtCore.Qt.ApplicationModal)
        self._bar = QtGui.QProgressBar()
        self._bar.setMinimumWidth(WIDTH)
        self._bar.setRange(0, SCALE)
        grid = self._dialog.layout()
        grid.addWidget(self._bar, 1, grid.columnCount() - 1)
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.ArrowCursor)
        self._dialog.show()
