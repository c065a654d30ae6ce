"""What FreeCAD's macro recorder writes down makes the same operation without a window."""

import pytest
from conftest import freecad, in_gui

# Reads the job that the session began with, and does what was recorded.
REPLAY = """
import FreeCAD
doc = FreeCAD.openDocument("job.FCStd")
FreeCAD.setActiveDocument(doc.Name)
exec(open("recorded.FCMacro").read())
doc.recompute()
op = doc.getObject("EvenLoadAdaptive")
with open("replayed.txt", "w") as out:
    expressions = sorted(map(list, op.ExpressionEngine))
    out.write("%s\\n%s\\n%s\\n" % (op.isValid(), list(op.OwnValues), expressions))
    out.write(op.Path.toGCode())
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("recording")


def test_a_recorded_macro_makes_the_same_operation_without_a_window(folder):
    seen = in_gui("gui_recording_session.py", folder)
    assert seen["valid"]
    (folder / "replay.py").write_text(REPLAY)
    _, output = freecad("replay.py", cwd=folder)
    assert (folder / "replayed.txt").exists(), output[-2000:]
    valid, own, expressions, path = (folder / "replayed.txt").read_text().split("\n", 3)
    assert valid == "True" and own == str(seen["own"]) == "['LinkFeed']"
    assert expressions == str(seen["expressions"])
    paths = {path.lstrip(".") for path, _ in seen["expressions"]}
    assert {"LinkLift", "EntryPoint.x"} < paths and "StockToLeave" not in paths
    assert path == seen["path"] and path.count("G1") > 20
