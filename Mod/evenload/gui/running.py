"""A task in a thread, as a dock has it: progress, results, a refusal."""

from PySide import QtCore

from evenload.gui.slots import slot, telling_slot
from evenload.gui.worker import Refused, Worker

LOOK = 20  # ms between looks at what the thread has found


class Running:
    """One task at a time, a generator of results. parent: of its timer; progressed: gets the share
    that is done, 0 to 1, or None at the end; found: gets each result as it comes, completed: the
    list of all, refused: the sentence why there are none or no more. All are bound methods, and not
    kept alive.
    """

    def __init__(self, parent, progressed, refused, found=None, completed=None):
        self.worker = Worker()
        self._progressed, self._refused = telling_slot(progressed), telling_slot(refused)
        self._found, self._completed = (each and telling_slot(each) for each in (found, completed))
        self._share, self._results = 0.0, []
        self._timer = QtCore.QTimer(parent)
        self._timer.setInterval(LOOK)
        self._timer.timeout.connect(slot(self._look))

    @property
    def is_busy(self):
        return self._timer.isActive()

    def run(self, task):
        """Does a task, which tells `done` what is done, in place of what is under way."""
        self.worker.cancel()
        self._share, self._results = 0.0, []
        self._progressed(0.0)
        self.worker.start(task)
        self._timer.start()

    def cancel(self):
        """Stops what is under way, of which nothing is told any more."""
        self._timer.stop()
        self.worker.cancel()
        self._progressed(None)

    def done(self, share):
        """Takes the share that is done, 0 to 1, in whichever thread."""
        self._share = share

    def _look(self):
        is_done = not self.worker.is_busy  # asked first, so that nothing comes after what is taken
        try:
            self._take(is_done)
        except Exception:  # a bug in the task, which keeps its traceback, and is told once
            self.cancel()
            raise

    def _take(self, is_done):
        for result in self.worker.results():
            if isinstance(result, Refused):
                self.cancel()
                self._refused(result.sentence)
                return
            self._results.append(result)
            if self._found:
                self._found(result)
        if is_done:
            self._timer.stop()
        self._progressed(None if is_done else self._share)
        if is_done and self._completed:
            self._completed(self._results)
