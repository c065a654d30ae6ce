"""The live preview: while an operation's panel is open its path is computed in a thread of its own
whenever a value changes, and shown beside the document, which is not touched.
"""

import contextlib

import FreeCAD
from PySide import QtCore

from evenload import waiting
from evenload.gui import load_view, preferences
from evenload.gui.observer import Observer
from evenload.gui.preview_node import PreviewNode, colours_of
from evenload.gui.slots import slot, telling_slot
from evenload.gui.worker import Refused, Worker
from evenload.operations.base import SENTENCES
from evenload.planar import drawn
from evenload.settings.labels import told

DELAY = 50  # ms without a change until computing begins: whoever turns a knob changes it more often
LOOK = 20  # ms between looks at what the thread has found

COMPUTING, SHOWN, REFUSED = "computing", "shown", "refused"  # states of a preview


def computed(task):
    """The task for the thread: yields (task, its Computation, places along the path, colours)."""
    done = task.run(waiting.asked())
    points, kinds = drawn(done.toolpath.moves)
    yield task, done, points, colours_of(kinds)


class Preview:
    """That of one operation, while its panel is open."""

    def __init__(self, operation, changed, parent):
        """changed: a bound method that is called after each change of `state`, and not kept alive;
        parent: a widget of the panel.
        """
        self.operation = operation
        self.state = None  # or COMPUTING, SHOWN, REFUSED
        self.sentence = ""  # why it is REFUSED
        self.done = None  # the Computation that is shown, greyed where it is no longer SHOWN
        self._changed = telling_slot(changed)
        self._worker, self._node = Worker(), None
        self._delay, self._look = QtCore.QTimer(parent), QtCore.QTimer(parent)
        self._delay.setSingleShot(True)
        self._delay.setInterval(DELAY)
        self._look.setInterval(LOOK)
        self._delay.timeout.connect(slot(self._start))
        self._look.timeout.connect(slot(self._take))
        self._observer = Observer([operation], ("Path",), telling_slot(self._path_changed))
        FreeCAD.addDocumentObserver(self._observer)

    @property
    def is_in_view(self):
        """Whether the 3D view shows it, greyed or not, in place of the operation's own path."""
        return self._node is not None

    def restart(self):
        """Has the path computed anew, in place of what is under way."""
        if self._observer is None or not preferences.live_preview():
            return
        self._stop()
        self._delay.start()
        if self._node is not None:
            self._node.grey()
        self._tell(COMPUTING)

    def clear(self):
        """Shows nothing but the operation's own path, and forgets what was computed."""
        self._remove()
        self.operation.Proxy.known = None
        self._tell(None)

    def close(self, is_kept):
        """Ends it, and tells whether the operation is still there. is_kept: whether the recompute
        that comes next may take what was computed.
        """
        if self._observer is None:
            return False
        FreeCAD.removeDocumentObserver(self._observer)
        self._observer = None
        self._remove()
        if not is_kept:
            self.operation.Proxy.known = None
        return True

    # ---- computing ----

    def _start(self):
        if not self.operation.Active:
            self.clear()
            return
        if self._node is None:
            self._node = PreviewNode(self.operation.ViewObject)
            load_view.stand_back(self.operation, True)
            self._node.grey()
        with self._cleared_by_bugs():
            try:
                task = self.operation.Proxy.preview(self.operation)
            except SENTENCES as error:
                self._refuse(str(error))
                return
        self._worker.start(lambda: computed(task))
        self._look.start()

    def _take(self):
        # Asked first, so that nothing comes after what is taken.
        if not self._worker.is_busy:
            self._look.stop()
        with self._cleared_by_bugs():
            found = self._worker.results()
        for result in found:
            if isinstance(result, Refused):
                self._refuse(result.sentence)
            else:
                self._show(*result)

    @contextlib.contextmanager
    def _cleared_by_bugs(self):
        """Errors that are no sentences keep their tracebacks, and nothing waits for a result."""
        try:
            yield
        except Exception:
            self.clear()
            raise

    def _show(self, task, done, points, colours):
        self.operation.Proxy.known = task, done
        self.done = done
        self._node.show(points, colours)
        self._tell(SHOWN)

    def _refuse(self, sentence):
        self.sentence = told(sentence)
        self._tell(REFUSED)

    # ---- its end ----

    def _path_changed(self, is_gone):
        """After a recompute of the operation, or at its end."""
        if is_gone:
            self.close(is_kept=False)
        else:
            self.clear()

    def _stop(self):
        self._worker.cancel()
        self._delay.stop()
        self._look.stop()

    def _remove(self):
        self._stop()
        if self._node is not None:
            self._node.remove()
            load_view.stand_back(self.operation, False)
        self._node = self.done = None

    def _tell(self, state):
        self.state = state
        self._changed()
