"""What the dock Finishing Advisor computes, in a thread."""

from PySide import QtCore

from evenload import advisor, waiting
from evenload.gui import preferences
from evenload.gui.observer import Observer, bits_of, own_properties
from evenload.gui.slots import slot, telling_slot
from evenload.gui.worker import Refused, Worker
from evenload.operations.checks import DEPTHS
from evenload.settings.table import FINISHING

LOOK = 50  # ms between looks at what the thread has found

# Of models, controllers and the operation: what changes what is compared. Its pattern and angle do
# not, in whose place each strategy has its own.
PROPERTIES = {
    *("Shape", "Placement", "Base", "ToolController", "Tool", "HorizFeed", "VertFeed"),
    *("HorizRapid", "SpindleSpeed", "SpindleDir", *DEPTHS, *(row.name for row in FINISHING)),
} - {"Strategy", "PassAngle"}


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


def observer_of(job, operation, changed):
    """The Observer of what is compared of a job, with its tool bits, and of an operation or None.
    changed: called with whether one of these is no longer there.
    """
    controllers = job.Tools.Group
    objects = [job, *job.Model.Group, *controllers, *([operation] if operation else [])]
    bits = bits_of(controllers)
    return Observer(objects, PROPERTIES | own_properties(bits), changed, bits)


def preferred_settings():
    """{name: value} of what the user prefers new finishing operations to begin with."""
    names = {row.name for row in FINISHING}
    kept = {row.name: preferences.default_of(row) for row in preferences.ROWS if row.name in names}
    return {name: value for name, value in kept.items() if value is not None}
