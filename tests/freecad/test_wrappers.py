"""PySide's wrappers of what Qt has deleted (see evenload/gui/wrappers.py)."""

import threading

from evenload.gui.wrappers import forget_the_dead

LOOKS = 30  # some hundredths of a second each; fewer than ten met a tuple that was being made


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
