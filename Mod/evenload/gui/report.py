"""The command Report: the HTML report of a job, written into a file and shown in the browser."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host
from evenload.gui import preferences, simulation_task
from evenload.gui.simulation_report import JobReport, asked_file
from evenload.gui.slots import slot
from evenload.settings.sentences import shown

SCALE = 1000  # steps of the progress bar
NEVER = 2**31 - 1  # ms

_translate = FreeCAD.Qt.translate
_shown = []  # the ReportInBrowser that was asked for last


def write(job):
    """Asks for a file and writes the report of a job into it, in place of one that is under way;
    None where the user cancels.
    """
    path = asked_file(FreeCADGui.getMainWindow())
    if not path:
        return None
    close()
    _shown.append(ReportInBrowser(job, path))
    return _shown[-1]


def close():
    """Stops what is under way, if anything is."""
    while _shown:
        _shown.pop().remove()


class ReportInBrowser:
    """A report that is being written, and is shown in the browser then."""

    def __init__(self, job, path):
        self.dialog = ReportProgress(job.Label)
        self.report = JobReport(self.dialog, self.open)
        self.dialog.canceled.connect(slot(self.report.task.cancel))
        self.report.start(job, _material_of(job), preferences.machine(), path)

    def open(self, path):
        """Shows the file that was written."""
        if not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path)):
            told = _translate("EvenLoad", "There is no browser for the report: %s")
            FreeCAD.Console.PrintWarning(told % path + "\n")

    def remove(self):
        """Stops what is under way, and takes the dialog out of the window."""
        self.report.task.cancel()
        self.dialog.deleteLater()


class ReportProgress(QtGui.QProgressDialog):
    """Tells what is done of the report of a job. The window can be used meanwhile."""

    def __init__(self, name):
        super().__init__(FreeCADGui.getMainWindow())
        self.setWindowTitle(_translate("EvenLoad", "EvenLoad Report"))
        self.setLabelText(_translate("EvenLoad", "Simulating the operations of %s") % name)
        self.setRange(0, SCALE)
        self.setAutoClose(False)
        self.setAutoReset(False)
        self.setMinimumDuration(NEVER)  # by itself Qt shows it 4 s after it was set to nothing

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        self.setVisible(share is not None)
        if share is not None:
            self.setValue(round(SCALE * share))

    def tell(self, text, colour=None):
        """Writes into the report view why there is no report; that there is one is seen."""
        if colour:
            FreeCAD.Console.PrintError(shown(text) + "\n")


def _material_of(job):
    """That of the first operation that has one, else the one that is preferred."""
    active = (each for each in host.operations(job) if host.is_active(each))
    return next(filter(None, map(simulation_task.material_of, active)), preferences.material())
