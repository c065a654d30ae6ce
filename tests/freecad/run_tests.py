"""freecadcmd tests/freecad/run_tests.py: runs pytest inside FreeCAD.

Options come in PYTEST_ADDOPTS; EVENLOAD_TESTS names single files or tests, separated by spaces.
EVENLOAD_TEST_QUEUE names a folder that several such processes share: each file of tests is run by
the process that comes to it first.
"""

import os
import sys

import pytest

here = os.path.dirname(os.path.abspath(__file__))


class Queue:
    """A plugin that runs only the files that no other process has taken."""

    def __init__(self, folder):
        self.folder = folder
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
        """Files with many tests first, so that the processes end at about the same time."""
        count = {}
        for item in items:
            count[item.path] = count.get(item.path, 0) + 1
        items.sort(key=lambda item: -count[item.path])

    def pytest_runtest_protocol(self, item):
        """Answers True, that is done, for tests of others."""
        return None if self.is_ours(item.path.name) else True


chosen = os.environ.get("EVENLOAD_TESTS", "").split()
queue = os.environ.get("EVENLOAD_TEST_QUEUE")
code = pytest.main(
    ["--rootdir", here, *(os.path.join(here, name) for name in chosen or [""])],
    plugins=[Queue(queue)] if queue else [],
)
sys.stdout.flush()
sys.stderr.flush()
os._exit(int(code))  # FreeCAD would exit with 0 whatever happened
