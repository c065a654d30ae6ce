"""Many chips as solids at once: FreeCADs without a window that each make one after the other.

Processes, since OpenCASCADE's booleans neither let go of Python's lock nor stand threads; and of
FreeCAD's own program, since a copy of a process with a window is none that one can go on with. A
process that ends, or takes too long, over a chip costs that chip alone.
"""

import contextlib
import json
import os
import queue
import signal
import subprocess
import threading

from evenload import host, waiting

WORKER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "solid_worker.py")
READY = "ready"  # a worker's first line
LONGEST = 120.0  # s that one chip may take
ASKED_EVERY = 0.1  # s, whether to go on


def answers(cases, progress=None, processes=0):
    """[answer of solid_worker.py to each case, a dict], in their order.

    progress(share done) -> whether to go on; left out: as waiting.go_on. processes: 0: as many as
    there are cores. Raises waiting.Stopped where it shall not go on, ValueError for a case that
    cannot be, and RuntimeError where FreeCAD does not start.
    """
    cases = list(cases)
    ask = progress or waiting.asked() or (lambda share: True)
    open_cases, done = queue.SimpleQueue(), queue.SimpleQueue()
    for numbered in enumerate(cases):
        open_cases.put(numbered)
    count = min(processes or os.cpu_count() or 1, len(cases))
    workers = [_Worker(open_cases, done) for _ in range(count)]
    try:
        return _collected(len(cases), done, ask)
    finally:
        for worker in workers:
            worker.end()


def _collected(count, done, ask):
    found = {}
    while len(found) < count:
        if not ask(len(found) / count):
            raise waiting.Stopped()
        try:
            number, answer = done.get(timeout=ASKED_EVERY)
        except queue.Empty:
            continue
        if isinstance(answer, Exception):
            raise answer
        found[number] = answer
    return [found[number] for number in range(count)]


@contextlib.contextmanager
def _broken_pipes_told():
    """While this lasts a line to a worker that has ended is an error to catch in this thread.
    FreeCAD 1.1's Python leaves the signal as it is, which would end FreeCAD.
    """
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGPIPE})
    try:
        yield
    finally:
        if signal.SIGPIPE not in before:
            if signal.SIGPIPE in signal.sigpending():  # else it would come now
                signal.sigwait({signal.SIGPIPE})
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Worker:
    """A thread that hands cases to a process of its own, and starts another one where it ends."""

    def __init__(self, open_cases, done):
        self._open_cases, self._done = open_cases, done
        self._lock = threading.Lock()
        self._process, self._is_over = None, False
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def end(self):
        """Ends the process at once, whatever it does, and waits for the thread."""
        with self._lock:
            self._is_over = True
            if self._process:
                self._process.kill()
        self._thread.join()

    def _run(self):
        try:
            while not self._is_over:
                number, case = self._open_cases.get_nowait()
                self._done.put((number, self._answer(case)))
        except queue.Empty:
            pass
        except Exception as error:  # raised again where the answers are taken
            self._done.put((None, error))
        finally:
            self._close()

    def _answer(self, case):
        if self._process is None:
            self._start()
        timer = threading.Timer(LONGEST, self._process.kill)
        timer.start()
        try:
            line = self._line_after(json.dumps(case, default=float))
        finally:
            timer.cancel()
            timer.join()  # so that no thread outlives its chip
        if not line.endswith("\n"):  # it ended, maybe while it wrote
            self._close()
            return {"flagged": "FreeCAD ended over it, or took more than %g s." % LONGEST}
        answer = json.loads(line)
        return ValueError(answer["refused"]) if "refused" in answer else answer

    def _line_after(self, text):
        try:
            with _broken_pipes_told():
                self._process.stdin.write(text + "\n")
                self._process.stdin.flush()
            return self._process.stdout.readline()
        except BrokenPipeError:
            return ""

    def _start(self):
        with self._lock:
            if self._is_over:
                raise RuntimeError("The computation is over.")
            self._process = subprocess.Popen(
                [host.without_window(), WORKER],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
                encoding="utf-8",
            )
        for line in self._process.stdout:  # FreeCAD's greeting first
            if line.strip() == READY:
                return
        raise RuntimeError("FreeCAD without a window, %s, does not start." % self._process.args[0])

    def _close(self):
        with self._lock:
            process, self._process = self._process, None
        if process:
            process.kill()
            process.wait()
            # Of a line that was not taken any more.
            with contextlib.suppress(BrokenPipeError), _broken_pipes_told():
                process.stdin.close()
            process.stdout.close()
