"""What the window Simulation computes: operations read in FreeCAD's own thread, simulated in
another one.
"""

from PySide import QtCore

from evenload import host, waiting
from evenload.gui.load_view import step_of
from evenload.gui.slots import slot, telling_slot
from evenload.gui.worker import Refused, Worker
from evenload.pictures.load_rows import Run
from evenload.simulation import job

LOOK = 20  # ms between looks at what the thread has found


class Simulating:
    """One task at a time in a thread, by default the simulation of setups. dock: shows the
    progress; taken: a bound method that gets the results, such as Runs, refused: one that gets the
    sentence why there are none. Neither is kept alive.
    """

    def __init__(self, dock, taken, refused):
        self.worker, self._dock = Worker(), dock
        self._taken, self._refused = telling_slot(taken), telling_slot(refused)
        self._share, self._runs = 0.0, []
        self._timer = QtCore.QTimer(dock)
        self._timer.setInterval(LOOK)
        self._timer.timeout.connect(slot(self._look))

    @property
    def is_busy(self):
        return self._timer.isActive()

    def start(self, setups):
        """Simulates setups in place of what is under way."""
        self.run(lambda: simulated(setups, self.done))

    def run(self, task):
        """Does a task, which tells `done` what is done, in place of what is under way."""
        self.worker.cancel()
        self._share, self._runs = 0.0, []
        self._dock.show_progress(0.0)
        self.worker.start(task)
        self._timer.start()

    def cancel(self):
        """Stops what is under way, of which nothing is told any more."""
        self._timer.stop()
        self.worker.cancel()
        self._dock.show_progress(None)

    def done(self, share):
        """Takes the share that is done, 0 to 1, in whichever thread."""
        self._share = share

    def _look(self):
        is_done = not self.worker.is_busy  # asked first, so that nothing comes after what is taken
        for result in self.worker.results():
            if isinstance(result, Refused):
                self.cancel()
                self._refused(result.sentence)
                return
            self._runs.append(result)
        self._dock.show_progress(None if is_done else self._share)
        if is_done:
            self._timer.stop()
            self._taken(self._runs)


def setups_of(operations, material, machine):
    """[(name, function that simulates it), ...] of operations, each as if the others had not been
    there. material: a name; machine: a name or file, None for the programmed feeds alone. Raises
    ValueError for an operation that cannot be simulated.
    """
    names = [operation.Name for operation in operations]
    found = []
    for operation in operations:
        controller = host.controller_of(operation)
        has_speed = controller is not None and controller.SpindleSpeed > 0
        options = {
            "step": step_of(operation),
            "material": material if has_speed else None,
            "machine": machine,
        }
        found.append((operation.Label, job.read(operation, without=names), options))
    return found


def simulated(setups, told):
    """The task that generates the Runs of setups. told: called with the share that is done, 0 to 1,
    in the thread of the task.
    """
    for number, (name, setup, options) in enumerate(setups):

        def going(share, number=number):
            told((number + share) / len(setups))
            return goes_on(share)

        found = setup.simulate(progress=going, **options)
        if found.cancelled:
            raise waiting.Stopped()
        yield Run(name, found)


def goes_on(share):
    """Whether the task of this thread shall go on."""
    try:
        waiting.go_on(share)
    except waiting.Stopped:
        return False
    return True
