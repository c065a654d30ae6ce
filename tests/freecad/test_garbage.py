"""Python's garbage while threads work (see evenload/gui/garbage.py)."""

import gc
import threading
import time

from evenload.gui import garbage
from evenload.gui.worker import Worker
from PySide import QtCore

APPLICATION = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
MANY, LONGEST = 50, 60  # pieces of garbage; s until the window's thread has collected them


class InACycle:
    """Tells in which thread it ends, as a widget would that a closed panel still knows."""

    ended_in = []

    def __init__(self):
        self.itself = self

    def __del__(self):
        self.ended_in.append(threading.get_ident())


def until(condition):
    """Lets Qt go on until a condition holds."""
    end = time.monotonic() + LONGEST
    while not condition():
        assert time.monotonic() < end
        APPLICATION.processEvents(QtCore.QEventLoop.AllEvents, 50)


def test_it_is_collected_in_the_windows_thread_alone_while_another_works():
    begin, full, enough = threading.Event(), threading.Event(), threading.Event()

    def holds_containers():
        begin.wait(LONGEST)
        held = [[] for _ in range(3 * gc.get_threshold()[0])]
        full.set()
        enough.wait(LONGEST)
        yield len(held)

    worker = Worker()
    worker.start(holds_containers)
    for _ in range(MANY):
        InACycle()
    begin.set()
    assert full.wait(LONGEST)
    until(lambda: len(InACycle.ended_in) == MANY)
    enough.set()
    worker.join()
    assert set(InACycle.ended_in) == {threading.get_ident()}
    assert len(worker.results()) == 1
    until(gc.isenabled)


def test_it_stays_uncollected_where_somebody_wants_that():
    gc.disable()
    try:
        worker = Worker()
        worker.start(lambda: iter([1]))
        worker.join()
        until(lambda: not garbage._timer.isActive())
        assert not gc.isenabled()
    finally:
        gc.enable()


def test_who_switches_it_on_meanwhile_has_it_in_the_windows_thread_alone():
    enough = threading.Event()

    def waits():
        enough.wait(LONGEST)
        yield True

    worker = Worker()
    worker.start(waits)
    gc.enable()
    until(lambda: not gc.isenabled())
    enough.set()
    worker.join()
    until(gc.isenabled)
