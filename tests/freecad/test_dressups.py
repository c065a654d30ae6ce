"""FreeCAD's dressups on our operations: what the table of docs/dressups.md says of this FreeCAD."""

import re
from pathlib import Path

import FreeCAD
import Part
import Path as FreeCADPath
import pytest
from conftest import Bench
from dressup_verdicts import (
    GOUGES,
    LOSES_FEEDS,
    NO_PATH,
    PLUNGES,
    TOOL,
    check_far,
    feed_moves,
    slope,
    verdict,
)
from finishing_parts import upper
from FreeCAD import Vector
from models import DEPTH, block_with, face_of, floors_of, rectangle

from evenload import host
from evenload.operations import dressed, finishing

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "dressups.md").read_text()
VERSION = "%s.%s" % tuple(FreeCAD.Version()[:2])
SIDE = 16.0  # mm, of the pocket
KINDS = ("adaptive", "trochoid", "lame_spiral")
NO_SUCH_SETTING = "–"


# ---- how the dressups are set ----


def nothing(dressup, folder):
    """Leaves it as FreeCAD makes it."""


def across(dressup, folder):
    box = dressup.Document.addObject("Part::Box", "Half")
    box.Length, box.Width, box.Height = 20 + SIDE * 2 / 3, SIDE + 40, 40
    box.Placement.Base = Vector(-20, -20, -20)
    before, dressup.Stock = dressup.Stock, box
    if before is not None:
        dressup.Document.removeObject(before.Name)


def without_layers(dressup, folder):
    dressup.IncludeLayers = False


def with_tags(dressup, folder):
    at = TOOL / 2
    dressup.Positions = [Vector(x, 0.3 * SIDE, -DEPTH) for x in (at, SIDE - at)]
    dressup.Width, dressup.Height, dressup.Angle, dressup.Radius = 4, 1, 90, 0
    dressup.Disabled = []


def probed(dressup, folder):
    grid = [(x, y) for x in range(-20, 51, 10) for y in range(-20, 51, 10)]
    file = folder / "probe.txt"
    file.write_text("".join("%g %g %g\n" % (x, y, slope(x, y)) for x, y in grid))
    dressup.probefile = str(file)


# By the rows of the page's table: what sets the dressup, and properties of the operation.
SETTINGS = {
    ("Boundary", "all of the path inside"): (nothing, {}),
    ("Boundary", "across the pocket"): (across, {}),
    ("LeadInOut", "as it is made"): (nothing, {}),
    ("LeadInOut", "IncludeLayers no"): (without_layers, {}),
    ("RampEntry", "as it is made"): (nothing, {}),
    ("Tags", "as it is made: no tags"): (nothing, {}),
    ("Tags", "two tags at the walls"): (with_tags, {}),
    ("ZCorrect", "a file of probed points"): (probed, {}),
    ("AxisMap", "as it is made"): (nothing, {}),
    ("AxisMap", "Arcs of the operation no"): (nothing, {"Arcs": False}),
    ("Dogbone", "as it is made"): (nothing, {}),
    ("Dogbone", "Arcs of the operation no"): (nothing, {"Arcs": False}),
}


def table():
    """{(dressup, how it is set): what the page says of this FreeCAD, as a set of words}"""
    head, *rows = re.search(
        r"^(\| dressup \|.*\n)\|[-|]+\n((?:\|.*\n)+)", PAGE, re.MULTILINE
    ).groups()
    names = [name.strip() for name in head.strip().strip("|").split("|")]
    said = {}
    for row in rows[0].splitlines():
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        said[cells[0], cells[1]] = set(cells[names.index(VERSION)].split(", "))
    return said


SAID = table()


def test_the_pages_table_has_every_dressup_and_each_row_is_tested():
    assert set(SAID) == set(SETTINGS)
    assert {name for name, _ in SAID} == set(host.DRESSUPS)


# ---- tests ----


@pytest.fixture(scope="module")
def operations():
    """callable(kind, properties) -> (Bench, operation on its pocket), each computed once."""
    doc, made = FreeCAD.newDocument("Dressups"), {}
    pocket = Bench(doc, block_with(face_of(rectangle(0, 0, SIDE, SIDE))), tool=TOOL)

    def operation(kind, properties):
        key = (kind, *sorted(properties.items()))
        if key not in made:
            made[key] = pocket.done(
                pocket.operation(kind=kind, FeedControl="Constant removal rate", **properties)
            )
        pocket.job.Operations.Group = [made[key]]
        return pocket, made[key]

    yield operation
    FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("row", list(SETTINGS), ids=", ".join)
def test_a_dressup_does_what_the_page_says_of_it(operations, kind, row, tmp_path):
    set_it, properties = SETTINGS[row]
    b, op = operations(kind, properties)
    dressup = host.dressed(row[0], op)
    if SAID[row] == {NO_SUCH_SETTING}:
        assert not hasattr(dressup, "IncludeLayers")
        return
    set_it(dressup, tmp_path)
    b.doc.recompute()
    assert host.operations(b.job) == [dressup]
    assert verdict(op, dressup, row[0]) == SAID[row]
    b.doc.removeObject(dressup.Name)


def test_what_is_called_a_fault_of_freecads_is_so_with_its_own_adaptive(square, tmp_path):
    own = host.freecads_adaptive("Own", square.job, square.controller)
    own.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    square.set(own, StartDepth=0.0, FinalDepth=-DEPTH, StepDown=DEPTH)
    square.doc.recompute()
    faults = {"Boundary": PLUNGES}
    if VERSION == "0.20":
        faults.update(LeadInOut=NO_PATH, ZCorrect=LOSES_FEEDS)
    else:
        faults.update(LeadInOut=PLUNGES, Dogbone=GOUGES)
    for name, fault in faults.items():
        square.job.Operations.Group = [own]
        dressup = host.dressed(name, own)
        if name == "Boundary":
            across(dressup, tmp_path)
        elif name == "ZCorrect":
            probed(dressup, tmp_path)
        square.doc.recompute()
        assert fault in verdict(own, dressup, name), name


def test_dressups_of_finishing_do_what_the_page_says(bench, tmp_path):
    trough = Part.makeCylinder(20, 24, Vector(0, 8, 25), Vector(1, 0, 0))
    b = bench(Part.makeBox(24, 16, 8).cut(trough), tool=TOOL)
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    op.Base = [(b.model, upper(b.model.Shape))]
    b.set(op, Stepover=3.0, Tolerance=0.02)
    b.done(op)
    count = len(feed_moves(op.Path.Commands))
    for name in ("Boundary", "AxisMap", "ZCorrect"):
        b.job.Operations.Group = [op]
        dressup = host.dressed(name, op)
        if name == "ZCorrect":
            probed(dressup, tmp_path)
        b.doc.recompute()
        assert dressup.isValid(), name
        check_far(dressup)
        feeds = [words.get("F", 0.0) for _, _, words, _ in feed_moves(dressup.Path.Commands)]
        assert len(feeds) >= count
        assert all(feeds) == (name != "ZCorrect" or VERSION != "0.20"), name


def test_a_dressup_that_goes_beyond_ten_metres_is_emptied_and_named(operations, capfd):
    b, op = operations("adaptive", {})
    dressup = host.dressed("Boundary", op)
    dressup.Label = "Far one"
    dressup.Proxy = Far()
    dressup.touch()
    b.doc.recompute()
    assert dressup.Path.Commands == [] and "Touched" in dressup.State
    assert "'Far one' would send the tool more than 10 m" in capfd.readouterr().err
    b.doc.removeObject(dressup.Name)


class Far:
    """A dressup's proxy with a fault."""

    def execute(self, obj):
        far = dressed.FARTHEST + 100
        obj.Path = FreeCADPath.Path([FreeCADPath.Command("G1", {"X": far, "Y": 0, "F": 1})])


@pytest.mark.parametrize("turn", [0.0, 17.0])
def test_dogbones_of_a_ramp_stay_within_ten_metres(bench, turn):
    pocket = block_with(face_of(rectangle(0, 0, SIDE, SIDE)))
    pocket.rotate(Vector(0, 0, 0), Vector(0, 0, 1), turn)
    b = bench(pocket, tool=TOOL)
    dressup = host.dressed("Dogbone", b.done(b.operation(Entry="Ramp")))
    b.doc.recompute()
    check_far(dressup)
