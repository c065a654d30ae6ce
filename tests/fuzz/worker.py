"""A process that does one task after the other, and is replaced when it crashes or hangs."""

import multiprocessing
import queue
import resource
import time
from functools import partial

MEMORY = 4 << 30  # bytes, of such a process
LOOK = 5  # s between two looks whether the one that gives the tasks is still there


class Failed(Exception):
    """A task had no end, or an end without an answer; says which."""


class Crashed(Failed):
    pass


class TookTooLong(Failed):
    pass


def work(begin, tasks, answers):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    if begin:
        begin()
    for function, arguments in iter(partial(next_task, tasks), None):
        answers.put(function(*arguments))
    answers.cancel_join_thread()  # nobody reads on


def next_task(tasks):
    """The next; None where there is none any more, or nobody to give one."""
    while multiprocessing.parent_process().is_alive():
        try:
            return tasks.get(timeout=LOOK)
        except queue.Empty:
            pass
    return None


class Worker:
    """method: how the process starts; a spawned one has none of the modules of this one. begin: a
    function without arguments that it calls first.
    """

    def __init__(self, method="fork", begin=None):
        self._context = multiprocessing.get_context(method)
        self._begin = begin
        self._process = None

    def call(self, seconds, function, *arguments):
        """What the function returns there. Raises Failed, after so many seconds at the latest."""
        if self._process is None:
            self._start()
        self._tasks.put((function, arguments))
        deadline = time.monotonic() + seconds
        while True:
            try:
                return self._answers.get(timeout=1)
            except queue.Empty:
                if not self._process.is_alive():
                    code = self._process.exitcode
                    self._process = None
                    raise Crashed("crashed with code %s" % code) from None
                if time.monotonic() > deadline:
                    self._process.kill()
                    self._process.join()
                    self._process = None
                    raise TookTooLong("took more than %d s" % seconds) from None

    def _start(self):
        self._tasks, self._answers = self._context.Queue(), self._context.Queue()
        self._process = self._context.Process(
            target=work, args=(self._begin, self._tasks, self._answers), daemon=True
        )
        self._process.start()

    def stop(self):
        if self._process is not None:
            self._tasks.put(None)
            self._process.join()
            self._process = None
