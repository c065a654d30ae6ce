"""freecadcmd tests/freecad/run_tests.py: runs pytest inside FreeCAD.

Options come in PYTEST_ADDOPTS; EVENLOAD_TESTS names single files or tests, separated by spaces.
"""

import os
import sys

import pytest

here = os.path.dirname(os.path.abspath(__file__))
chosen = os.environ.get("EVENLOAD_TESTS", "").split()
code = pytest.main(["--rootdir", here, *(os.path.join(here, name) for name in chosen or [""])])
sys.stdout.flush()
sys.stderr.flush()
os._exit(int(code))  # FreeCAD would exit with 0 whatever happened
