"""Python's garbage while threads work (see evenload/gui/garbage.py)."""

import gc
import threading
import time

import pytest
from evenload.gui.worker import Worker
from PySide import QtCore

MANY, LONGEST = 50, 60  # pieces of garbage; s until the window's thread has collected them


class InACycle:
    """Tells in which thread it ends, as a widget would that a closed panel still knows."""

    ended_in = []

    def __init__(self):
        self.itself = self

    def __del__(self):
        self.ended_in.append(threading.get_ident())


@pytest.fixture(scope="module")
def until():
    """Lets Qt go on until a condition holds."""
    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])

    def until(condition):
        end = time.monotonic() + LONGEST
        while not condition():
            assert time.monotonic() < end
            application.processEvents(QtCore.QEventLoop.AllEvents, 50)

    return until


def test_it_is_collected_in_the_windows_thread_alone_while_another_works(until):
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


def test_it_stays_uncollected_where_somebody_wants_that(until):
    worker = Worker()
    gc.disable()
    try:
        worker.start(lambda: iter([1]))
        worker.join()
        until(lambda: worker.results() == [1])
        assert not gc.isenabled()
    finally:
        gc.enable()
