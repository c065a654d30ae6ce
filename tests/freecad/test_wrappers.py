"""PySide's wrappers of what Qt has deleted (see evenload/gui/wrappers.py)."""

import threading

import pytest
from evenload.gui import wrappers
from evenload.gui.wrappers import forget_the_dead
from PySide import QtCore

needs_pyside_2 = pytest.mark.skipif(
    not QtCore.qVersion().startswith("5."), reason="PySide 6 keeps no dead wrappers"
)

LOOKS = 30  # some hundredths of a second each; fewer than ten met a tuple that was being made


@needs_pyside_2
def test_a_dead_one_is_forgotten_and_a_living_one_is_not(monkeypatch):
    living, dead = QtCore.QObject(), QtCore.QObject()
    wrappers._shiboken.delete(dead)
    forgotten = []
    monkeypatch.setattr(
        wrappers._shiboken, "invalidate", lambda wrapper: forgotten.append(id(wrapper))
    )
    forget_the_dead()
    assert id(dead) in forgotten and id(living) not in forgotten


@needs_pyside_2
def test_looking_for_them_disturbs_no_thread_that_makes_tuples():
    ended, failed = threading.Event(), []

    def make_tuples():
        try:
            while not ended.is_set():
                assert len(tuple(str(number) for number in range(2000))) == 2000
        except BaseException as error:
            failed.append(error)

    threads = [threading.Thread(target=make_tuples) for _ in range(2)]
    for thread in threads:
        thread.start()
    for _ in range(LOOKS):
        forget_the_dead()
    ended.set()
    for thread in threads:
        thread.join()
    assert failed == []
