"""What the dock Finishing Advisor computes, in a thread."""

from PySide import QtCore

from evenload import advisor, waiting
from evenload.gui.slots import slot, telling_slot
from evenload.gui.worker import Refused, Worker

LOOK = 50  # ms between looks at what the thread has found


class Advising:
    """One comparison at a time. parent: of its timer; told: a bound method that gets the share that
    is done, or None at the end; taken: one that gets each Advice; refused: one that gets the
    sentence why there is no more. None of them is kept alive.
    """

    def __init__(self, parent, told, taken, refused):
        self.worker = Worker()
        self._told, self._taken, self._refused = map(telling_slot, (told, taken, refused))
        self._share = 0.0
        self._timer = QtCore.QTimer(parent)
        self._timer.setInterval(LOOK)
        self._timer.timeout.connect(slot(self._look))

    @property
    def is_busy(self):
        return self._timer.isActive()

    def start(self, question):
        """Compares all strategies on a Question's faces, in place of what is under way."""
        self._share = 0.0
        self._told(0.0)
        self.worker.start(lambda: _answers(question, self._done))
        self._timer.start()

    def cancel(self):
        """Stops what is under way, of which nothing is told any more."""
        self._timer.stop()
        self.worker.cancel()
        self._told(None)

    def _done(self, share):
        self._share = share

    def _look(self):
        is_done = not self.worker.is_busy  # asked first, so that nothing comes after what is taken
        for result in self.worker.results():
            if isinstance(result, Refused):
                self.cancel()
                self._refused(result.sentence)
                return
            self._taken(result)
        if is_done:
            self._timer.stop()
        self._told(None if is_done else self._share)


def _answers(question, told):
    """The task that generates each Advice. told: called with the share that is done, in the thread
    of the task.
    """
    asked = waiting.asked()

    def watch(share):
        told(share)
        return asked(share)

    with waiting.asking(watch):
        yield from advisor.answers(question)
