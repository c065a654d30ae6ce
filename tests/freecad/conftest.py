"""Jobs and operations for the tests, and how to read what they make."""

import contextlib
import importlib
import json
import math
import os
import re
import shutil
import subprocess
import sys

import FreeCAD
import Part
import pytest
from FreeCAD import Vector
from models import DEPTH, SQUARE, block_with, face_of, floors_of

sys.dont_write_bytecode = True


class Bench:
    """A document with a job on one model, and operations in it."""

    def __init__(self, doc, shape, tool=6.0, feed=255.0, flutes=1):
        from evenload import host

        self.doc = doc
        self.part = doc.addObject("Part::Feature", "Part")
        self.part.Shape = shape
        doc.recompute()
        self.job, self.controller = host.create_job(doc, [self.part], tool, feed, 6366, flutes)
        self.model = self.job.Model.Group[0]

    def operation(self, base=None, kind="adaptive", **properties):
        """A new operation on the model's floors or on `base`; kind: its module."""
        module = importlib.import_module("evenload.operations." + kind)
        op = module.Create("Operation", parentJob=self.job, toolController=self.controller)
        if base is None:
            base = [(self.model, tuple(floors_of(self.model.Shape)))]
        op.Base = base
        self.set(op, StartDepth=0.0, FinalDepth=-DEPTH, StepDown=DEPTH)
        self.set(op, **properties)
        return op

    @staticmethod
    def set(op, **properties):
        for name, value in properties.items():
            if any(path == name for path, _ in op.ExpressionEngine):
                op.setExpression(name, None)
            setattr(op, name, value)

    def set_stock(self, shape):
        """Gives the job a solid as its stock."""
        stock = self.doc.addObject("Part::Feature", "Blank")
        stock.Shape = shape
        stock.addProperty("App::PropertyString", "StockType", "Stock")
        stock.StockType = "Unknown"  # as FreeCAD marks solids that are taken for stock
        before, self.job.Stock = self.job.Stock, stock
        self.doc.removeObject(before.Name)
        self.doc.recompute()

    def done(self, op):
        """Recomputes; the operation must be valid and have a path."""
        op.touch()
        self.doc.recompute()
        assert op.isValid(), op.Report or op.getStatusString()
        assert len(op.Path.Commands) > 10
        return op

    def refused(self, op):
        """Recomputes; the operation must be invalid and empty. Returns what Report says."""
        op.touch()
        self.doc.recompute()
        assert not op.isValid()
        assert op.Path.Commands == []
        assert op.CuttingTime == 0 and op.CycleTime == ""
        assert not hasattr(op, "MaxEngagement") or op.MaxEngagement.Value == 0
        sentence = op.Report
        assert sentence.endswith(".") and "\n" not in sentence and len(sentence) < 300, sentence
        assert sentence in op.getStatusString()
        return sentence


@pytest.fixture
def doc():
    document = FreeCAD.newDocument("Test")
    name = document.Name
    yield document
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.fixture
def bench(doc):
    """Makes a Bench in the test's document."""
    return lambda shape, **options: Bench(doc, shape, **options)


@pytest.fixture
def square(bench):
    """A Bench with a square pocket of 30 mm."""
    return bench(block_with(face_of(SQUARE)))


@pytest.fixture(scope="session")
def rs274():
    """Runs a G-code text through LinuxCNC's interpreter; returns the canonical commands."""
    program = os.environ.get("EVENLOAD_RS274")
    assert program, "EVENLOAD_RS274 names no interpreter: start the tests with ./run test"

    def interpret(text, folder):
        file = os.path.join(str(folder), "program.ngc")
        with open(file, "w") as out:
            out.write(text)
        result = subprocess.run(
            [program, file], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120
        )
        assert result.returncode == 0, result.stdout[-500:] + result.stderr[-500:]
        return result.stdout

    return interpret


def headless_document(folder):
    """The file of a document with a job and a computed operation, made without a GUI."""
    doc = FreeCAD.newDocument("Headless")
    bench = Bench(doc, block_with(face_of(SQUARE)))
    bench.done(bench.operation())
    path = os.path.join(str(folder), "headless.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    return path


@contextlib.contextmanager
def reopened(doc, path):
    """Saves a document, closes it, and opens it for the context's length."""
    doc.saveAs(str(path))
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(str(path))
    try:
        yield again
    finally:
        FreeCAD.closeDocument(again.Name)


@contextlib.contextmanager
def saved_copy(doc, path):
    """Saves a document as it is now, and opens the copy for the context's length."""
    doc.saveCopy(str(path))
    copy = FreeCAD.openDocument(str(path))
    try:
        yield copy
    finally:
        FreeCAD.closeDocument(copy.Name)
        FreeCAD.setActiveDocument(doc.Name)


def freecad(*arguments, cwd=None, command=None, timeout=120, **environment):
    """Runs FreeCAD without a GUI, or the command in place of it; returns (exit code, output).

    environment: variables besides this process's own, of which those that steer the tests and job
    files stay out. timeout in s.
    """
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    inherited = {k: v for k, v in os.environ.items() if k not in ("EVENLOAD_JOB", "PYTEST_ADDOPTS")}
    result = subprocess.run(
        [*(command or [program]), *arguments],
        cwd=cwd,
        env={**inherited, **environment},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        timeout=timeout,
    )
    return result.returncode, result.stdout


def in_gui(script, folder, *arguments, **environment):
    """Runs a script of this folder in FreeCAD's GUI, on a virtual screen; returns what it reports
    (see gui_tools.py). At its end nothing may stand in red in the report view but sentences that
    the script provoked, and no traceback.

    folder: for its report and its pictures; arguments: FreeCAD's.
    """
    program = shutil.which("freecad") or shutil.which("FreeCAD")
    assert program and shutil.which("xvfb-run"), "freecad and xvfb are needed"
    _, log = freecad(
        os.path.join(os.path.dirname(os.path.abspath(__file__)), script),
        *arguments,
        command=["xvfb-run", "-a", "-s", "-screen 0 1400x1500x24", program],
        timeout=540,
        EVENLOAD_GUI_OUT=str(folder),
        QTWEBENGINE_DISABLE_SANDBOX="1",
        LIBGL_ALWAYS_SOFTWARE="1",
        **environment,
    )
    report, hang = folder / "result.json", folder / "hang.txt"
    if not report.exists():
        words = hang.read_text() if hang.exists() else ""
        raise AssertionError(
            "%s\nis the last of:\n%s%s" % (_end_of(log, words), log[-2000:], words)
        )
    content = json.loads(report.read_text())
    report.unlink()  # another session may use the folder
    assert "traceback" not in content, content["traceback"]
    errors = errors_in(content["report_view"], content["provoked"])
    seen = "\n".join(text for text, _ in content["report_view"])
    assert errors == [], "%s, among:\n%s" % (errors, seen)
    return content


def _end_of(log, words):
    """In one line where it crashed, in faulthandler's words, or the last line that it wrote."""
    fatal = re.search("^Fatal Python error: .*$", words, re.MULTILINE)
    if not fatal:
        return "".join((log.rstrip() + "\n" + words).splitlines()[-1:])
    thread = words.partition("Current thread 0x")[2].partition("\n\n")[0]
    frames = re.findall(r'File ".*?([^/"]+)", line (\d+) in (\S+)', thread)
    # From Python 3.14 on there are those of C, too.
    calls = re.findall(r'Binary file ".*?([^/"]+)", at (\S+)', words)
    named = ["%s:%s %s" % frame for frame in frames[:6]] + ["%s %s" % call for call in calls[3:13]]
    return "%s in %s" % (fatal.group(), " < ".join(named))


def errors_in(report_view, provoked):
    """The lines of the report view, [(text, whether it is an error's)], that are errors and
    tracebacks, but for those with a sentence that was provoked, and what FreeCAD says whatever is
    installed.
    """
    lines = _without_slips_of_pyside(
        [text for text, red in report_view if red or "Traceback" in text]
    )
    assert lines and lines[-1].endswith("The session ends."), (
        "errors are not seen: %s" % report_view
    )
    assert all(provoked), "an empty sentence would excuse all errors"
    expected = [*provoked, *OF_EVERY_JOB]
    if provoked:
        expected.append("Recompute failed! Please check report view.")
    return [text for text in lines[:-1] if not any(each in text for each in expected)]


def _without_slips_of_pyside(lines):
    """The lines without the tracebacks that end with OF_PYSIDE."""
    kept = []
    for line in lines:
        kept.append(line)
        if OF_PYSIDE in line:
            begin = max((i for i, each in enumerate(kept) if "Traceback" in each), default=None)
            if begin is not None:
                del kept[begin:]
    return kept


# FreeCAD 0.20 opens a tool controller, under Python 3.11, by a method that its class lacks.
# What FreeCAD's posts print stands in the report view like an error. 1.1 misses its examples, which
# Debian packs apart.
OF_EVERY_JOB = [
    "<class 'AttributeError'>: setAttr failed.",
    "Show editor = ",
    "postprocessing...",
    "done postprocessing.",
    "Cannot read /usr/share/freecad/examples",
]
# PySide 2 now and then hands FreeCAD's own filter of events a widget in place of an event.
OF_PYSIDE = "AttributeError: 'PySide2.QtWidgets.QWidget' object has no attribute 'type'"


# ---- reading paths ----


def moves_of(op):
    """[(name, start, end, centre or None, feed in mm/min)] of the motions of a path; all points
    (x, y, z). Positions that are not known yet are None.
    """
    result, at = [], (None, None, None)
    for command in op.Path.Commands:
        if command.Name not in ("G0", "G1", "G2", "G3"):
            continue
        p = command.Parameters
        end = tuple(p.get(axis, before) for axis, before in zip("XYZ", at))
        centre = (at[0] + p["I"], at[1] + p["J"]) if "I" in p else None
        result.append((command.Name, at, end, centre, 60 * p.get("F", 0)))
        at = end
    return result


def sweep_of(name, start, end, centre):
    """The signed sweep of an arc of moves_of, in rad; ends that coincide make a full circle."""
    turn = math.atan2(end[1] - centre[1], end[0] - centre[0])
    turn -= math.atan2(start[1] - centre[1], start[0] - centre[0])
    if name == "G2":
        return -((-turn) % (2 * math.pi) or 2 * math.pi)
    return turn % (2 * math.pi) or 2 * math.pi


def points_of(op, step=0.05):
    """[(x, y, z, name)] along the feed moves of a path, at most `step` mm apart."""
    result = []
    for name, start, end, centre, _ in moves_of(op):
        if name == "G0" or None in start:
            continue
        if centre is None:
            count = max(1, math.ceil(math.dist(start, end) / step))
            for k in range(1, count + 1):
                t = k / count
                result.append((*(a + t * (b - a) for a, b in zip(start, end)), name))
            continue
        cx, cy = centre
        radius = math.hypot(start[0] - cx, start[1] - cy)
        first = math.atan2(start[1] - cy, start[0] - cx)
        turn = sweep_of(name, start, end, centre)
        count = max(2, math.ceil(radius * abs(turn) / step))
        for k in range(1, count + 1):
            angle, t = first + turn * k / count, k / count
            z = start[2] + t * (end[2] - start[2])
            result.append((cx + radius * math.cos(angle), cy + radius * math.sin(angle), z, name))
    return result


def solid_in_tool(op, solid, diameter, below, every=5):
    """(mm3, place): the most of a solid that is inside of the tool at ends of moves under a height.

    every: one of so many ends is looked at.
    """
    worst, at = 0.0, None
    ends = [end for _, _, end, _, _ in moves_of(op) if None not in end and end[2] < below - 1e-6]
    for x, y, z in ends[::every]:
        tool = Part.makeCylinder(diameter / 2 - 0.01, 100, Vector(x, y, z + 0.002))
        volume = tool.common(solid).Volume
        if volume > worst:
            worst, at = volume, (x, y, z)
    return worst, at


def check_path(op, floors, tool=6.0, islands=()):
    """What holds for every path: levels, no zero lengths, round arcs, no rapid below the top, and
    the tool inside the pockets (faces of FreeCAD's), which it clears to within what it can reach.

    floors: faces at the pockets' floors; open sides are not for this check.
    """
    moves = moves_of(op)
    assert moves
    top = op.StartDepth.Value
    for name, start, end, centre, feed in moves:
        assert all(math.isfinite(v) for v in end if v is not None)
        if None in start:
            continue
        assert math.dist(start, end) > 4e-4, (name, start, end)
        if name == "G0":
            sideways = math.dist(start[:2], end[:2]) > 0
            assert not (sideways and min(start[2], end[2]) < top), (start, end)
        else:
            assert feed > 0
        if centre:
            mismatch = math.dist(start[:2], centre) - math.dist(end[:2], centre)
            assert abs(mismatch) <= 0.0011 and math.dist(start[:2], end[:2]) >= 0.002
    final = op.FinalDepth.Value
    assert min(end[2] for _, _, end, *_ in moves if end[2] is not None) == pytest.approx(final)

    points = points_of(op)
    at_floor = [(x, y) for x, y, z, _ in points if z < final + 1e-6]
    for face in floors:
        box, radius = face.BoundBox, tool / 2
        wires = face.Wires
        mine = [p for p in at_floor if box.isInside(Vector(*p, box.Center.z))]
        assert mine
        for x, y in mine[::7]:
            vertex = Part.Vertex(x, y, box.ZMin)
            assert min(w.distToShape(vertex)[0] for w in wires) >= radius - 0.01, (x, y)
        missed, inside = 0, 0
        grid = _grid(mine, radius)
        for x in _steps(box.XMin, box.XMax):
            for y in _steps(box.YMin, box.YMax):
                point = Vector(x, y, box.ZMin)
                if not face.isInside(point, 1e-6, True):
                    continue
                vertex = Part.Vertex(point)
                if min(w.distToShape(vertex)[0] for w in wires) < 0.75 * radius:
                    continue  # corners that the tool cannot reach
                inside += 1
                missed += not grid(x, y)
        assert inside > 10 and missed == 0, "%d of %d places left" % (missed, inside)


def _steps(low, high, step=1.7):
    count = int((high - low) / step)
    return [low + step * (k + 0.5) for k in range(count)]


def _grid(points, radius):
    cells = {}
    for x, y in points:
        cells.setdefault((int(x // radius), int(y // radius)), []).append((x, y))

    def covered(x, y):
        a, b = int(x // radius), int(y // radius)
        return any(
            math.hypot(x - u, y - v) <= radius + 1e-3
            for i in (a - 1, a, a + 1)
            for j in (b - 1, b, b + 1)
            for u, v in cells.get((i, j), ())
        )

    return covered
