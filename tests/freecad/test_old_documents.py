"""Documents that earlier versions saved: their operations are found, and keep what was set.

documents/three_operations.FCStd: a block with a square pocket, cleared by an operation of each
kind, saved by EvenLoad 0.1.0 in FreeCAD 0.20 before Mod/evenload had rooms. The first has an
EngagementAngle of 50 degrees and a RollRadius of 0.7 mm, the last a Pitch of 0.8 mm.
"""

import os
import shutil

import FreeCAD
import pytest
from evenload.operations.adaptive import Adaptive
from evenload.operations.lame_spiral import LameSpiral
from evenload.operations.trochoid import Trochoid

FILE = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "documents", "three_operations.FCStd"
)
KINDS = {"Adaptive": Adaptive, "Trochoid": Trochoid, "Spiral": LameSpiral}


@pytest.fixture
def old(tmp_path):
    doc = FreeCAD.openDocument(shutil.copy(FILE, tmp_path))
    yield doc
    FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("name", KINDS)
def test_an_operation_of_an_earlier_version_is_one_of_ours_with_all_its_settings(old, name):
    op = old.getObject(name)
    assert type(op.Proxy) is KINDS[name]
    names = [setting.name for setting in (*op.Proxy.settings, *op.Proxy.results)]
    assert [name for name in names if not hasattr(op, name)] == []


def test_what_was_set_in_an_earlier_version_is_kept(old):
    adaptive, spiral = old.Adaptive, old.Spiral
    assert adaptive.EngagementAngle.Value == 50 and adaptive.RollRadius.Value == 0.7
    assert list(adaptive.OwnValues) == ["RollRadius"]
    assert spiral.Pitch.Value == 0.8 and list(spiral.OwnValues) == ["Pitch"]


@pytest.mark.skipif(
    tuple(int(n) for n in FreeCAD.Version()[:2]) != (0, 20),
    reason="FreeCAD does not open jobs of 0.20 as jobs",
)
def test_operations_of_an_earlier_version_are_computed_again(old):
    for name in KINDS:
        old.getObject(name).touch()
    old.recompute()
    for name in KINDS:
        op = old.getObject(name)
        assert op.isValid() and len(op.Path.Commands) > 100, op.Report
