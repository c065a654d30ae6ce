"""freecadcmd tests/freecad/run_tests.py: runs pytest inside FreeCAD.

Options come in PYTEST_ADDOPTS; EVENLOAD_TESTS names single files or tests, separated by spaces.
EVENLOAD_TEST_QUEUE names a folder that several such processes share: each file of tests is run by
the process that comes to it first. EVENLOAD_TEST_QUEUE_END lets one begin at the queue's other end.
"""

import os
import sys

import pytest

here = os.path.dirname(os.path.abspath(__file__))


class Queue:
    """A plugin that runs only the files that no other process has taken.

    from_its_end: whether it leaves files that open a window to the others, as long as it can.
    """

    def __init__(self, folder, from_its_end):
        self.folder = folder
        self.from_its_end = from_its_end
        self.taken = {}  # by file: whether it is ours

    def is_ours(self, file):
        if file not in self.taken:
            try:
                os.close(os.open(os.path.join(self.folder, file), os.O_CREAT | os.O_EXCL))
                self.taken[file] = True
            except FileExistsError:
                self.taken[file] = False
        return self.taken[file]

    def pytest_collection_modifyitems(self, items):
        """Files that open a window first and of these, as of the others, those with many tests: so
        the processes end at about the same time.
        """
        count = {}
        for item in items:
            count[item.path] = count.get(item.path, 0) + 1

        def rank(item):
            opens_a_window = hasattr(item.module, "in_gui")
            return opens_a_window == self.from_its_end, -count[item.path], item.path.name

        items.sort(key=rank)

    def pytest_runtest_protocol(self, item):
        """Answers True, that is done, for tests of others."""
        return None if self.is_ours(item.path.name) else True


chosen = os.environ.get("EVENLOAD_TESTS", "").split()
queue = os.environ.get("EVENLOAD_TEST_QUEUE")
code = pytest.main(
    ["--rootdir", here, *(os.path.join(here, name) for name in chosen or [""])],
    plugins=[Queue(queue, "EVENLOAD_TEST_QUEUE_END" in os.environ)] if queue else [],
)
sys.stdout.flush()
sys.stderr.flush()
os._exit(int(code))  # FreeCAD would exit with 0 whatever happened
