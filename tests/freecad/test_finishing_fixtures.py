"""Fixtures of the finishing operation: OpenCASCADE's distance between them and the tool, its ball
and a shank above it, along the whole path.
"""

import json
import random

import Part
import pytest
from conftest import moves_of, points_of, reopened
from finishing_parts import part, upper
from FreeCAD import Placement, Rotation, Vector

from evenload import batch, host
from evenload.operations import finishing

pytestmark = pytest.mark.between

BALL, TOLERANCE, CLEARANCE = 5.0, 0.01, 1.0
SHANK = 40.0  # mm above the ball's centre
SAFE = 70.0  # mm


def finish(bench, **properties):
    """A Bench with a finishing operation on CX, whose crest is at z = 45."""
    b = bench(part(True), tool=2 * BALL, feed=1650)
    b.controller.Tool = host.create_tool("ballend", {"Diameter": 2 * BALL})
    b.doc.recompute()
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    op.Base = [(b.model, upper(b.model.Shape))]
    b.set(op, Stepover=4.0, Tolerance=TOLERANCE, SafeHeight=SAFE, ClearanceHeight=SAFE + 5)
    b.set(op, **properties)
    return b, op


def clamp(doc, name="Clamp"):
    """A finger over the crest near the border, and its post beside the part."""
    found = doc.addObject("Part::Feature", name)
    finger, post = (Part.makeBox(*sizes) for sizes in ((35, 16, 8), (15, 16, 40)))
    finger.translate(Vector(25, -8, 45))
    post.translate(Vector(45, -8, 10))
    found.Shape = finger.fuse(post)
    doc.recompute()
    return found


def pin(doc):
    """A leaning round bar through the part's middle."""
    found = doc.addObject("Part::Cylinder", "Pin")
    found.Radius, found.Height = 4, 60
    found.Placement = Placement(Vector(-5, 5, 0), Rotation(Vector(1, 1, 0), 25))
    doc.recompute()
    return found


def tool():
    """The tool with its tip at the origin."""
    ball = Part.makeSphere(BALL, Vector(0, 0, BALL))
    return ball.fuse(Part.makeCylinder(BALL, SHANK, Vector(0, 0, BALL)))


def nearest(op, fixture, count=150, seed=1):
    """mm between fixture and tool at places of all moves: those of the path nearest to it, and
    some anywhere.
    """
    places = [Vector(x, y, z) for x, y, z, _ in points_of(op, 0.5)]
    ends = [Vector(*end) for _, start, end, *_ in moves_of(op) if None not in start]
    box = fixture.Shape.BoundBox
    box.enlarge(BALL + 1.5 * CLEARANCE)
    near = [p for p in places + ends if box.isInside(p)]
    chance = random.Random(seed)
    chosen = chance.sample(near, min(count, len(near))) + chance.sample(places, 30)
    distances = []
    for place in chosen:
        moved = tool()
        moved.translate(place)
        distances.append(fixture.Shape.distToShape(moved)[0])
    return min(distances)


def corners_of(op):
    """Where moves end, to a nanometre."""
    ends = [end for _, _, end, *_ in moves_of(op) if None not in end]
    return {tuple(round(each, 6) for each in end) for end in ends}


STRATEGIES = ["Zig-zag", "One way", "Contours inwards", "Spiral outwards"]


@pytest.mark.parametrize(
    "strategy",
    [STRATEGIES[0], *(pytest.param(each, marks=pytest.mark.core) for each in STRATEGIES[1:])],
)
def test_a_clamp_over_the_edge_is_not_touched(bench, strategy):
    b, op = finish(bench, Strategy=strategy)
    fixture = clamp(b.doc)
    b.done(op)
    assert nearest(op, fixture) == 0  # it would be, without a word of it
    b.set(op, Fixtures=[fixture])
    b.done(op)
    least = nearest(op, fixture)
    # Lines leave the tool's true height by a twentieth of the tolerance downwards.
    assert least > CLEARANCE - TOLERANCE
    assert least < CLEARANCE + 0.5  # no further off than it must


def test_what_is_not_near_a_fixture_is_cut_as_before(bench):
    b, op = finish(bench, PassAngle=90)
    b.done(op)
    before = corners_of(op)
    b.set(op, Fixtures=[clamp(b.doc)])
    b.done(op)
    after = corners_of(op)
    away = {place for place in before if place[0] < 10}
    assert len(away) > 500 and len(away - after) < 10  # but for a pass's beginning or end


@pytest.mark.parametrize("clearance", [0.0, pytest.param(0.3, marks=pytest.mark.core)])
def test_a_leaning_pin_may_be_as_near_as_is_wished(bench, clearance):
    b, op = finish(bench, PassAngle=30, FixtureClearance=clearance)
    fixture = pin(b.doc)
    b.set(op, Fixtures=[fixture])
    b.done(op)
    least = nearest(op, fixture, count=400)
    # Its triangles are taken for what stands out from them at the most.
    assert clearance - 0.3 * TOLERANCE < least < clearance + 0.5


def test_chips_hold_their_thickness_beside_fixtures_too(bench):
    b, op = finish(bench, PassAngle=90)
    b.controller.SpindleSpeed = 5100
    fixture = clamp(b.doc)
    b.set(op, Fixtures=[fixture], FeedControl="Constant chip thickness")
    b.done(op)
    assert op.Report.startswith("Feeds of the cuts: ")
    assert nearest(op, fixture) > CLEARANCE - TOLERANCE


def test_an_operation_is_out_of_date_when_a_fixture_moves_or_is_deleted(bench):
    b, op = finish(bench)
    b.done(op)
    without = [c.toGCode() for c in op.Path.Commands]
    fixture = clamp(b.doc)
    b.set(op, Fixtures=[fixture])
    b.done(op)
    held = [c.toGCode() for c in op.Path.Commands]
    assert held != without
    fixture.Placement = Placement(Vector(0, 10, 0), Rotation())
    assert b.doc.recompute() > 0
    moved = [c.toGCode() for c in op.Path.Commands]
    assert moved not in (held, without)
    assert "Up-to-date" in op.State
    b.doc.removeObject(fixture.Name)
    assert "Touched" in op.State and op.Fixtures == []
    b.doc.recompute()
    assert [c.toGCode() for c in op.Path.Commands] == without


def test_it_is_the_same_after_saving_and_old_documents_have_none(bench, tmp_path):
    b, op = finish(bench)
    b.set(op, Fixtures=[clamp(b.doc)])
    b.done(op)
    before = [c.toGCode() for c in op.Path.Commands]
    with reopened(b.doc, tmp_path / "held.FCStd") as doc:
        again = doc.getObject("Finish")
        assert [each.Name for each in again.Fixtures] == ["Clamp"]
        again.touch()
        doc.recompute()
        assert again.isValid() and [c.toGCode() for c in again.Path.Commands] == before


def test_an_operation_from_before_there_were_fixtures_has_none(bench, tmp_path):
    b, op = finish(bench)
    for name in ("Fixtures", "FixtureClearance"):
        op.removeProperty(name)
    with reopened(b.doc, tmp_path / "old.FCStd") as doc:
        again = doc.getObject("Finish")
        assert again.Fixtures == [] and again.FixtureClearance.Value == 1.0
        again.touch()
        doc.recompute()
        assert again.isValid()


def test_what_is_no_fixture_is_refused(bench):
    b, op = finish(bench)
    note = b.doc.addObject("App::Annotation", "Note")
    b.set(op, Fixtures=[note])
    assert "'Note' has no faces that the tool could keep off" in b.refused(op)
    b.set(op, Fixtures=[b.model])
    assert "is a model of the job, which the tool keeps off anyway" in b.refused(op)
    b.set(op, Fixtures=[clamp(b.doc)], SafeHeight=50.0)
    assert "(50 mm) lies below the top of the fixtures and their clearance (54" in b.refused(op)
    b.set(op, SafeHeight=SAFE, FixtureClearance=-0.5)
    assert op.FixtureClearance.Value == 0  # as FreeCAD has lengths


def test_a_fixture_over_all_that_is_picked_is_refused(bench):
    b, op = finish(bench)
    plate = b.doc.addObject("Part::Box", "Plate")
    plate.Length = plate.Width = 90
    plate.Placement.Base = Vector(-45, -45, 46)
    b.doc.recompute()
    b.set(op, Fixtures=[plate])
    assert "leave the tool none of the picked faces: move them, or lower" in b.refused(op)


def test_a_job_file_names_fixtures(bench, tmp_path):
    b, _ = finish(bench)
    fixture = clamp(b.doc)
    fixture.Label = "Left clamp"
    b.doc.saveAs(str(tmp_path / "held.FCStd"))
    job = {
        "name": "held",
        "model": "held.FCStd",
        "object": "Part",
        "base": list(upper(b.part.Shape)),
        "tool": {"diameter": 10, "shape": "ballend"},
        "cutting": {"feed": 1650, "plunge_feed": 800, "spindle_speed": 5100},
        "operation": {
            "type": "finishing",
            "parameters": {
                **{"Stepover": 4, "SafeHeight": SAFE, "ClearanceHeight": SAFE},
                "Fixtures": ["Left clamp"],
            },
        },
        "output": {"gcode": "held.ngc"},
    }
    wrong = json.loads(json.dumps({**job, "name": "wrong", "output": {"gcode": "wrong.ngc"}}))
    wrong["operation"]["parameters"]["Fixtures"] = ["Vice"]
    (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [job, wrong]}))
    done, failed = batch.run_file(str(tmp_path / "jobs.json"), lambda line: None)["jobs"]
    assert done["ok"], done["error"]
    assert "there is no object 'Vice'" in failed["error"]
    free = {**job, "name": "free", "output": {"gcode": "free.ngc"}}
    free["operation"]["parameters"].pop("Fixtures")
    (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [free]}))
    (other,) = batch.run_file(str(tmp_path / "jobs.json"), lambda line: None)["jobs"]
    assert other["figures"]["cut_length_mm"] > done["figures"]["cut_length_mm"] + 50
