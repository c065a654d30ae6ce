"""Work in a thread of its own, so that the window stays alive."""

import queue
import threading

from evenload import waiting
from evenload.gui import garbage


class Refused:
    """A sentence in place of a result: why there is none."""

    def __init__(self, sentence):
        self.sentence = sentence


class Worker:
    """Does one task at a time: a new one stops that before.

    A task is a generator of results. Whoever waits takes them by `results`, in the thread that he
    is in. What a task raises but ValueError is raised there again. Tasks start in the window's
    thread.
    """

    def __init__(self):
        self._results = queue.SimpleQueue()
        self._thread = self._stop = None

    def start(self, task):
        """Starts iterating over task(), in place of what is under way."""
        self.cancel()
        self._results = queue.SimpleQueue()
        self._stop = threading.Event()
        arguments = task, self._results, self._stop
        self._thread = threading.Thread(target=_work, args=arguments, daemon=True)
        garbage.stays_here(self._thread)
        self._thread.start()

    def cancel(self):
        """Stops what is under way, within some hundredths of a second, and forgets its results."""
        if self._stop is not None:
            self._stop.set()
        self._results = queue.SimpleQueue()

    @property
    def is_busy(self):
        return self._thread is not None and self._thread.is_alive() and not self._stop.is_set()

    def join(self):
        """Waits until the thread has ended."""
        if self._thread is not None:
            self._thread.join()

    def results(self):
        """What has come since the last call."""
        found = []
        while not self._results.empty():
            result = self._results.get()
            if isinstance(result, BaseException):
                raise result
            found.append(result)
        return found


def _work(task, results, stop):
    with waiting.asking(lambda _: not stop.is_set()):
        try:
            for result in task():
                results.put(result)
        except waiting.Stopped:
            return
        except ValueError as error:
            results.put(Refused(str(error)))
        except Exception as error:  # raised again where the results are taken
            results.put(error)
