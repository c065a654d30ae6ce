"""The finishing operation on the source's test parts as solids: judged by OpenCASCADE's own
distance between the tool's ball and the part, on the path and on what is posted of it.
"""

import json
import math
import random
import re
from pathlib import Path

import FreeCAD
import Part
import pytest
from conftest import moves_of, points_of, reopened
from finishing_parts import DOME, LEAN, cone, lofted, part, upper
from FreeCAD import Vector
from models import sketch_of

from evenload import advisor, batch, host
from evenload.geometry import facets
from evenload.operations import finishing
from evenload.settings.labels import told
from evenload.settings.notes import FACT, KEPT_OFF, kind_of

TOLERANCE, BALL = 0.01, 5.0
BELOW, BELOW_IF_ROUND = 0.2 * TOLERANCE, 0.35 * TOLERANCE  # mm, into the part
PLACES = 2000
UNIT_ROUNDING = 1e-6  # mm


def finish(bench, shape, tool="ballend", faces=None, **properties):
    """A Bench with a finishing operation on the upper side of a shape."""
    b = bench(shape, tool=2 * BALL, feed=1650)
    if tool != "endmill":
        b.controller.Tool = host.create_tool(tool, {"Diameter": 2 * BALL})
        b.doc.recompute()
    names = upper(b.model.Shape) if faces is None else faces
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    op.Base = [(b.model, names)]
    b.set(op, Stepover=2.0, Tolerance=TOLERANCE, LeadRadius=0.0)
    b.set(op, **properties)
    return b, op


def cut_places(path, count, seed=1):
    """Random places (x, y, z) of the tip on the feed moves of [(name, start, end), ...], but for
    straight ways down.
    """
    random_ = random.Random(seed)
    cuts = [(s, e) for name, s, e in path if name == "G1" and (s.x, s.y) != (e.x, e.y)]
    lengths = [(end - start).Length for start, end in cuts]
    chosen = random_.choices(cuts, lengths, k=count)
    return [start + (end - start) * random_.random() for start, end in chosen]


def lines_of(op):
    """[(name, start, end), ...] of an operation's moves."""
    result = []
    for name, start, end, *_ in moves_of(op):
        if None not in start:
            result.append((name, Vector(*start), Vector(*end)))
    return result


def posted_lines(text):
    """The same of a posted program."""
    at, result, name = {}, [], None
    for line in text.splitlines():
        words = dict(re.findall(r"([GXYZ])(-?[\d.]+)", re.sub(r"\(.*?\)|;.*", "", line)))
        if "G" in words and float(words["G"]) in (0, 1):
            name = "G%d" % float(words["G"])
        if name is None or not set("XYZ") & set(words):
            continue
        before, at = dict(at), {**at, **{k: float(words[k]) for k in "XYZ" if k in words}}
        if len(before) == 3:
            ends = (Vector(*(each[k] for k in "XYZ")) for each in (before, at))
            result.append((name, *ends))
    return result


def off_by(shape, places, radius=BALL):
    """(least, largest) distance of the ball from a shape, in mm, at places of its tip."""
    off = [shape.distToShape(Part.Vertex(p + Vector(0, 0, radius)))[0] - radius for p in places]
    return min(off), max(off)


def test_a_ball_over_a_spline_surface_touches_it_all_along(bench):
    b, op = finish(bench, lofted(), PassAngle=35, Stepover=1.5, Boundary="Tool contact")
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), 500))
    assert least > -BELOW_IF_ROUND - UNIT_ROUNDING and largest < TOLERANCE


def test_a_mesh_is_refused(doc):
    mesh = doc.addObject("Mesh::Feature", "Scan")
    with pytest.raises(ValueError, match="'Scan' is a mesh without faces: make a solid of it"):
        facets.of([(mesh, ("Face1",))], [mesh], TOLERANCE)


@pytest.mark.parametrize(
    "angle", [0, pytest.param(30, marks=pytest.mark.core), pytest.param(90, marks=pytest.mark.core)]
)
@pytest.mark.parametrize(
    "is_convex", [True, pytest.param(False, marks=pytest.mark.core)], ids=["CX", "CV"]
)
def test_the_ball_touches_the_part_all_along_and_never_cuts_into_it(bench, is_convex, angle):
    b, op = finish(bench, part(is_convex), PassAngle=angle)
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), PLACES))
    assert least > -BELOW - UNIT_ROUNDING
    assert largest < TOLERANCE
    assert op.Retracts == 0 and op.Passes >= 40
    assert op.LargestStepover.Value <= 2.0
    assert 3000 < op.PathLength.Value < 3800
    assert op.Report == KEPT_OFF and kind_of(op.Report) == FACT


@pytest.mark.parametrize("processor", ["linuxcnc", "grbl"])
def test_what_is_posted_is_as_near(bench, rs274, tmp_path, processor):
    b, op = finish(bench, part(True), PassAngle=90)
    b.done(op)
    text = host.post(b.job, processor, "--no-show-editor")
    lines = posted_lines(text)
    assert len(lines) >= len(lines_of(op))
    least, largest = off_by(b.model.Shape, cut_places(lines, 300))
    assert least > -BELOW - 0.001 and largest < TOLERANCE + 0.001
    if processor == "linuxcnc":
        assert rs274(text, tmp_path).count("STRAIGHT_FEED") > 1000


def test_an_allowance_stays_all_around(bench):
    b, op = finish(bench, part(False), PassAngle=90, Allowance=0.3)
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), 300))
    assert 0.3 - BELOW - UNIT_ROUNDING < least and largest < 0.3 + TOLERANCE


def test_a_single_face_is_kept_to_by_the_contact_or_by_the_axis(bench):
    shape = part(True)
    dome = [n for n in upper(shape) if shape.getElement(n).BoundBox.YLength > 45]
    b, op = finish(bench, shape, faces=tuple(dome), PassAngle=90)
    edge = DOME * math.sin(LEAN)
    for boundary, reach in (("Tool contact", edge + BALL * math.sin(LEAN)), ("Tool centre", edge)):
        op.Boundary = boundary
        b.done(op)
        ys = [y for _, s, e in cuts_of(op) for y in (s.y, e.y)]
        assert max(ys) == pytest.approx(reach, abs=0.05)
        assert min(ys) == pytest.approx(-reach, abs=0.05)


def cuts_of(op):
    return [line for line in lines_of(op) if line[0] == "G1"]


def test_stepover_and_cusp_height_follow_each_other(bench):
    b, op = finish(bench, part(True))
    op.Stepover = 0.6
    assert op.CuspHeight.Value == pytest.approx(BALL - math.sqrt(BALL**2 - 0.3**2))
    op.CuspHeight = 0.01
    assert op.Stepover.Value == pytest.approx(2 * math.sqrt(0.01 * (2 * BALL - 0.01)))
    assert op.OwnValues == ["Stepover", "LeadRadius"]


def test_even_cusps_take_narrower_steps_where_the_part_is_steep(bench):
    b, op = finish(bench, part(True), Spacing="Constant cusp height", CuspHeight=0.02)
    b.done(op)
    level = 2 * math.sqrt(0.02 * (2 * BALL - 0.02))
    # On the dome the passes' centres run on R50: 50/45 as far apart, less what the cusp's sides
    # fall away by; at 33 degrees their plan distance is cos 33 of it.
    assert op.LeastStepover.Value < 0.9 * level < op.LargestStepover.Value < 1.1 * level


def test_one_way_cuts_in_one_direction_and_comes_back_over_the_part(bench):
    b, op = finish(bench, part(True), Strategy="One way", CutMode="Climb")
    b.done(op)
    runs = [e.x - s.x for _, s, e in cuts_of(op) if abs(e.x - s.x) > 1]
    assert all(run < 0 for run in runs) and op.Retracts == op.Passes - 1
    op.CutMode = "Conventional"
    b.done(op)
    assert all(e.x > s.x for _, s, e in cuts_of(op) if abs(e.x - s.x) > 1)


@pytest.mark.parametrize(
    "strategy", ["Contours inwards", pytest.param("Contours outwards", marks=pytest.mark.core)]
)
def test_contours_touch_the_part_all_along(bench, strategy):
    b, op = finish(bench, part(False), Strategy=strategy)
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), 500))
    assert least > -BELOW - UNIT_ROUNDING and largest < TOLERANCE
    assert op.Passes == 20 and op.Retracts == 0 and op.LargestStepover.Value == 2.0


@pytest.mark.parametrize("strategy", ["Contours inwards", "Spiral outwards"])
def test_contours_and_spirals_follow_a_cusp_height_and_the_part(bench, strategy):
    b, op = finish(bench, part(True), Strategy=strategy, Spacing="Constant cusp height")
    b.set(op, CuspHeight=0.1)
    b.done(op)
    # Across the fillets of R10 the ball's centre runs on R5, and half as far as its contact.
    level = 2 * math.sqrt(0.1 * (2 * BALL - 0.1))
    assert op.LeastStepover.Value < 0.75 * level < level < op.LargestStepover.Value < 1.1 * level
    cuts = [Vector(x, y, z) for x, y, z, _ in points_of(op, 1.0) if z < 45]
    least, _ = off_by(b.model.Shape, random.Random(3).sample(cuts, 300))
    assert least > -BELOW - UNIT_ROUNDING


@pytest.mark.parametrize(
    "strategy, slope", [("Contours inwards", 0), ("Spiral outwards", 0.003)], ids=["level", "helix"]
)
def test_round_passes_are_arcs_which_posts_and_controls_keep(
    bench, rs274, tmp_path, strategy, slope
):
    b, op = finish(bench, cone(), Strategy=strategy)
    b.done(op)
    arcs = [c for c in op.Path.Commands if c.Name in ("G2", "G3")]
    # Turns of some 100 lines each are one to three arcs and, where one begins, a line.
    assert op.Passes <= len(arcs) <= 16 * op.Passes
    assert len(op.Path.Commands) < 20 * op.Passes
    rises = [abs(e[2] - s[2]) for name, s, e, *_ in moves_of(op) if name in ("G2", "G3")]
    assert (max(rises) > 0.01) == (slope > 0)
    cuts = [Vector(x, y, z) for x, y, z, name in points_of(op, 1.0) if name != "G1"]
    least, largest = off_by(b.model.Shape, random.Random(2).sample(cuts, 400))
    assert least > -BELOW_IF_ROUND - UNIT_ROUNDING and largest < TOLERANCE
    # FreeCAD's own picture of them: within the faces, a radius about.
    box = op.Path.BoundBox
    assert max(-box.XMin, box.XMax, -box.YMin, box.YMax) < 20 + 5 + 2
    posted = host.post(b.job, "linuxcnc", "--no-show-editor")
    assert rs274(posted, tmp_path).count("ARC_FEED") == len(arcs)
    posted = host.post(b.job, "grbl", "--no-show-editor")
    assert len(re.findall(r"^G[23] ", posted, re.MULTILINE)) == len(arcs)


@pytest.mark.parametrize(
    "strategy", ["Contours inwards", pytest.param("Spiral outwards", marks=pytest.mark.core)]
)
def test_round_passes_are_lines_for_controllers_without_arcs(bench, strategy):
    b, op = finish(bench, cone(), Strategy=strategy, Arcs=False)
    b.done(op)
    assert not {c.Name for c in op.Path.Commands} & {"G2", "G3"}
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), 400))
    assert least > -BELOW_IF_ROUND - UNIT_ROUNDING and largest < TOLERANCE


def test_an_operation_from_before_there_was_a_setting_for_arcs_has_them(bench, tmp_path):
    b, op = finish(bench, cone(), Strategy="Contours inwards")
    op.removeProperty("Arcs")
    with reopened(b.doc, tmp_path / "finish.FCStd") as doc:
        again = doc.getObject("Finish")
        assert again.Arcs is True
        again.touch()
        doc.recompute()
        assert "G2" in {c.Name for c in again.Path.Commands}


@pytest.mark.parametrize("tool", ["bullnose", "endmill"])
def test_other_tools_leave_a_flat_face_level(bench, tool):
    b, op = finish(bench, Part.makeBox(30, 30, 10), tool=tool, Stepover=3.0)
    b.done(op)
    assert {round(z, 6) for _, s, e in cuts_of(op)[1:] for z in (s.z, e.z)} == {10.0}
    if tool == "endmill":
        assert op.CuspHeight.Value == 0


@pytest.mark.core
def test_a_ball_on_a_sphere_beside_a_wall_keeps_off_both(bench):
    shape = Part.makeBox(60, 40, 10).fuse(Part.makeSphere(15, Vector(20, 20, 5)))
    shape = shape.fuse(Part.makeBox(10, 40, 25, Vector(50, 0, 0))).removeSplitter()
    faces = [n for n in upper(shape) if shape.getElement(n).BoundBox.ZMax < 24]
    assert len(faces) == 2
    b, op = finish(bench, shape, faces=tuple(faces), PassAngle=20, Stepover=1.0)
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(lines_of(op), PLACES))
    assert least > -BELOW_IF_ROUND - UNIT_ROUNDING and largest < TOLERANCE


def test_it_is_the_same_after_saving_and_reopening(bench, tmp_path):
    b, op = finish(bench, part(False), Stepover=4.0)
    b.done(op)
    before = [c.toGCode() for c in op.Path.Commands]
    with reopened(b.doc, tmp_path / "finish.FCStd") as doc:
        again = doc.getObject("Finish")
        assert isinstance(again.Proxy, finishing.Finishing)
        again.touch()
        doc.recompute()
        assert again.isValid() and [c.toGCode() for c in again.Path.Commands] == before


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({"Stepover": 10.5}, "Stepover is 10.5 mm, more than the tool's diameter of 10 mm"),
        ({"Stepover": 0.0}, "Stepover is 0 mm: it must be positive."),
        ({"Tolerance": 0.0}, "Tolerance is 0 mm: it must be positive."),
        (
            {"Spacing": "Constant cusp height", "CuspHeight": 0.0},
            "Cusp height is 0 mm: it must lie between 0 and the 5 mm",
        ),
        ({"StartDepth": 10.0, "FinalDepth": 20.0}, "does not lie above"),
        ({"FinalDepth": 47.0, "StartDepth": 48.0}, "touches none of the picked faces"),
        ({"SafeHeight": 40.0}, "Safe Height (40 mm) lies below Start Depth"),
        ({"SafeHeight": 44.0, "StartDepth": 43.0}, "(44 mm) lies below the top of the models"),
    ],
)
def test_settings_that_cannot_be_are_refused(bench, change, sentence):
    b, op = finish(bench, part(True))
    b.set(op, **change)
    assert sentence in b.refused(op)


def test_faces_that_cannot_be_reached_from_above_are_refused(bench):
    b, op = finish(bench, part(True))
    shape = b.model.Shape
    normals = {n: f.normalAt(0, 0) for n, f in enumerate(shape.Faces, 1)}
    wall = next(n for n, normal in normals.items() if abs(normal.z) < 1e-9)
    floor = next(n for n, normal in normals.items() if normal.z < -0.9)
    for number, sentence in ((wall, "stands upright"), (floor, "looks down"), (99, "no Face99")):
        op.Base = [(b.model, ("Face%d" % number,))]
        assert sentence in b.refused(op)
    op.Base = []
    assert "no base geometry" in b.refused(op)
    op.Base = [(b.model, ("Edge1",))]
    assert "is no face" in b.refused(op)


def test_other_operations_still_refuse_a_ball_and_finishing_a_drill(bench):
    b, op = finish(bench, part(True))
    adaptive = b.operation()
    assert "is a ball end mill" in b.refused(adaptive)
    b.doc.removeObject(adaptive.Name)
    b.controller.Tool = host.create_tool("drill", {"Diameter": 6})
    assert "is a drill: choose a ball end, bull-nosed or flat end mill" in b.refused(op)


def test_a_flat_end_mill_has_no_cusps(bench):
    b, op = finish(bench, part(True), tool="endmill", Spacing="Constant cusp height")
    assert "has a flat end, which leaves steps" in b.refused(op)


def test_a_flat_end_mill_takes_the_cusp_height_away_and_a_ball_keeps_the_stepover(bench):
    b, op = finish(bench, part(True), Stepover=1.0)
    ball = b.controller.Tool
    assert op.CuspHeight.Value == pytest.approx(5 - math.sqrt(25 - 0.25))
    b.controller.Tool = host.create_tool("endmill", {"Diameter": 2 * BALL})
    b.doc.recompute()
    assert (op.Stepover.Value, op.CuspHeight.Value) == (1.0, 0.0)
    b.controller.Tool = ball
    b.doc.recompute()
    assert op.Stepover.Value == 1.0
    assert op.CuspHeight.Value == pytest.approx(5 - math.sqrt(25 - 0.25))


def test_it_can_be_stopped_within_a_moment(bench):
    b, op = finish(bench, part(True), Stepover=0.1, PassAngle=90)
    asked = []

    def progress(share):
        asked.append(share)
        return len(asked) < 20

    op.Proxy.progress = progress
    op.touch()
    b.doc.recompute()
    assert not op.isValid() and op.Report.startswith("Cancelled") and len(asked) == 20
    assert [c.Name for c in op.Path.Commands] == ["(Cancelled: nothing is cut here)"]


def test_every_label_in_a_sentence_is_the_panels():
    assert told("CuspHeight") == "Cusp height"


def test_a_job_file_finishes_without_a_window(tmp_path):
    shape = part(True)
    shape.exportStep(str(tmp_path / "part.step"))
    read = Part.read(str(tmp_path / "part.step"))
    job = {
        "name": "dome",
        "model": "part.step",
        "base": list(upper(read)),
        "tool": {"diameter": 10, "shape": "ballend"},
        "cutting": {"feed": 1650, "plunge_feed": 800, "spindle_speed": 5100},
        "operation": {"type": "finishing", "parameters": {"CuspHeight": 0.05, "PassAngle": 45}},
        "output": {"gcode": "dome.ngc", "picture": "dome.png"},
    }
    refused = {**job, "name": "simulated", "simulation": {}, "output": {"gcode": "other.ngc"}}
    (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [job, refused]}))
    result = batch.run_file(str(tmp_path / "jobs.json"), lambda line: None)
    done, failed = result["jobs"]
    assert done["ok"], done["error"]
    figures = done["figures"]
    assert figures["passes"] > 50 and "engagement_deg" not in figures
    assert figures["largest_stepover_mm"] <= 2 * math.sqrt(0.05 * (2 * BALL - 0.05))
    assert (tmp_path / "dome.ngc").stat().st_size > 1e4 and (tmp_path / "dome.png").exists()
    assert failed["error"].endswith("there is none of a finishing operation yet: take the key out.")
    assert "stepover, largest" in batch.table(result["jobs"])


def test_the_examples_finish_the_whole_upper_sides_of_the_source_s_parts():
    examples = Path(__file__).resolve().parents[2] / "examples"
    jobs = json.loads((examples / "finishing.json").read_text())["jobs"]
    doc = FreeCAD.openDocument(str(examples / "finishing.FCStd"))
    try:
        assert [job["object"] for job in jobs] == ["CX", "CV"]
        for job in jobs:
            shape = doc.getObject(job["object"]).Shape
            assert job["base"] == list(upper(shape))
            # The same solid, but for how far it goes down and where it stands.
            ours, source = (
                sorted(shape.getElement(name).Area for name in upper(shape))
                for shape in (shape, part(job["object"] == "CX"))
            )
            assert ours == pytest.approx(source)
    finally:
        FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize("strategy", ["Spiral inwards", "Spiral outwards"])
def test_spirals_touch_the_part_all_along(bench, strategy):
    b, op = finish(bench, part(True), Strategy=strategy)
    b.done(op)
    least, largest = off_by(b.model.Shape, cut_places(cuts_of(op), 500))
    assert least > -BELOW - UNIT_ROUNDING and largest < TOLERANCE


def borders(shape, y):
    """The names of the edges of the upper side along x at an ordinate."""
    return [
        "Edge%d" % number
        for number, edge in enumerate(shape.Edges, 1)
        if all(abs(v.Y - y) < 1e-6 and v.Z > -60 for v in edge.Vertexes)
        and edge.BoundBox.XLength > 70
        and edge.BoundBox.ZLength < 1e-6
    ]


def test_passes_between_two_edges_are_parallel_to_both(bench):
    b, op = finish(bench, part(True), Strategy="Between guides")
    assert "need two of them beside the faces" in b.refused(op) and "makes 0 lines" in op.Report
    b.set(op, Base=[*op.Base, (b.model, [_top(b, 40.0)])])
    assert "makes 1 lines" in b.refused(op)
    b.set(op, Base=[*op.Base, (b.model, [_top(b, -40.0)])])
    b.done(op)
    passes = [(s, e) for _, s, e in cuts_of(op) if abs(e.x - s.x) > 1]
    assert all(abs(e.y - s.y) < 1e-6 for s, e in passes)
    ordinates = sorted({round(e.y, 4) for s, e in passes})
    assert ordinates == pytest.approx([-39 + 2 * k for k in range(40)], abs=1e-3)
    least, largest = off_by(b.model.Shape, cut_places(cuts_of(op), 300))
    assert least > -BELOW - UNIT_ROUNDING and largest < TOLERANCE


def _top(b, y):
    """The name of the upper edge at an ordinate."""
    names = borders(b.model.Shape, y)
    return max(names, key=lambda name: b.model.Shape.getElement(name).BoundBox.ZMax)


def test_between_guides_passes_are_as_many_as_a_cusp_height_takes(bench):
    b, op = finish(bench, part(True), Strategy="Between guides", CuspHeight=0.02)
    b.set(op, Base=[*op.Base, (b.model, [_top(b, 40.0)]), (b.model, [_top(b, -40.0)])])
    b.done(op)
    even = op.Passes, op.LargestStepover.Value
    b.set(op, Spacing="Constant cusp height")
    b.done(op)
    # The dome is steep across these passes: what would do on a level face leaves more there.
    assert op.Passes > even[0] and op.LargestStepover.Value < even[1]


def test_between_guides_all_passes_may_go_one_way(bench):
    b, op = finish(bench, part(True), Strategy="One way between guides", Stepover=8.0)
    b.set(op, Base=[*op.Base, (b.model, [_top(b, 40.0)]), (b.model, [_top(b, -40.0)])])
    ways = {}
    for mode in ("Climb", "Conventional"):
        b.set(op, CutMode=mode)
        b.done(op)
        ways[mode] = {math.copysign(1, e.x - s.x) for _, s, e in cuts_of(op) if abs(e.x - s.x) > 1}
        assert op.Passes == 10 and op.Retracts == 9
    assert sorted(map(len, ways.values())) == [1, 1] and ways["Climb"] != ways["Conventional"]


@pytest.mark.parametrize("strategy", ["Zig-zag", "Contours inwards", "Spiral outwards"])
def test_passes_go_on_beyond_the_faces_and_keep_off_the_part(bench, strategy):
    shape = Part.makeBox(50, 30, 10).fuse(Part.makeBox(10, 30, 20, Vector(50, 0, 0)))
    shape = shape.removeSplitter()
    level = [n for n in upper(shape) if shape.getElement(n).BoundBox.ZMax < 15]
    b, op = finish(bench, shape, faces=tuple(level), Strategy=strategy, Extension=3.0)
    b.done(op)
    cuts = [Vector(x, y, z) for x, y, z, _ in points_of(op, 1.0) if z < 10 + TOLERANCE]
    xs, ys = [p.x for p in cuts], [p.y for p in cuts]
    # The border of passes of 2 mm may be half of that within 3 mm; beside the wall's ends the ball
    # goes round its corners.
    assert -3.01 < min(xs) < -1.9 and -3.01 < min(ys) < -1.9 and 31.9 < max(ys) < 33.01
    before_it = [p.x for p in cuts if 0 < p.y < 30]
    assert 43.9 < max(before_it) < 50 - BALL + 0.01
    least, _ = off_by(b.model.Shape, random.Random(6).sample(cuts, 300))
    assert least > -BELOW - UNIT_ROUNDING


def test_a_sketch_may_be_a_guide(bench):
    b, op = finish(bench, part(True), Strategy="Between guides")
    chain = [(-35, -20, 0), (0, -28, 0), (35, -20, 0)]
    guide = sketch_of(b.doc, chain, z=60, closed=False)
    b.set(op, Base=[*op.Base, (b.model, [_top(b, 40.0)]), (guide, "")])
    b.done(op)
    assert op.LeastStepover.Value < op.LargestStepover.Value <= 2.0
    first = min(cuts_of(op), key=lambda cut: cut[2].y)
    assert first[2].y == pytest.approx(-28 + 1, abs=0.2)


def test_arcs_lead_into_passes_and_follow_the_tool(bench):
    b, op = finish(bench, part(True), Strategy="One way", Stepover=8.0, PassAngle=0)
    other = finishing.Create("Other", parentJob=b.job, toolController=b.controller)
    assert other.LeadRadius.Value == pytest.approx(0.1 * 2 * BALL) and not other.OwnValues
    b.doc.removeObject(other.Name)
    b.set(op, LeadRadius=1.0)
    b.done(op)
    rises = [e.z - s.z for name, s, e in lines_of(op) if name == "G1" and e.z - s.z > 0.1]
    assert len(rises) >= 10
    b.set(op, LeadRadius=0.0)
    b.done(op)
    ways = [(s, e) for name, s, e in lines_of(op) if name == "G1"]
    assert all(abs(e.z - s.z) < 1e-6 for s, e in ways if (s.x, s.y) != (e.x, e.y))


# ---- feeds by chip thickness ----


def fed(bench, **properties):
    """A Bench with a finishing operation on CV, four teeth at 5100 rev/min and 0.08 mm each."""
    b, op = finish(bench, part(False), PassAngle=90, Stepover=1.0, **properties)
    b.controller.Tool.Flutes = 4
    b.controller.SpindleSpeed = 5100
    b.set(b.controller, HorizFeed="1632 mm/min", VertFeed="6000 mm/min")
    return b, op


def feeds_of(op):
    """mm/min, each once, of lines."""
    return {round(60 * c.Parameters["F"], 3) for c in op.Path.Commands if c.Name == "G1"}


def test_the_feed_follows_the_chips_up_to_its_maximum_and_report_tells_it(bench):
    b, op = fed(bench)
    b.done(op)
    assert op.FeedControl == "Constant feed" and 60 * op.MaximumFeed.Value == pytest.approx(3264)
    assert op.StockOnFaces.Value == pytest.approx(0.3) and "MaximumFeed" not in op.OwnValues
    constant = [c.toGCode() for c in op.Path.Commands]
    assert op.Report == KEPT_OFF and feeds_of(op) == {1632}
    b.set(op, FeedControl="Constant chip thickness")
    b.done(op)
    assert min(feeds_of(op)) < 1500 and 1700 < max(feeds_of(op)) < 3264
    told_feeds = re.match(r"Feeds of the cuts: (\d+) to (\d+) mm/min, for chips with", op.Report)
    assert kind_of(op.Report.split("\n")[0]) == FACT
    assert int(told_feeds[2]) == pytest.approx(max(feeds_of(op)), abs=1)
    b.set(op, MaximumFeed="1700 mm/min")
    b.done(op)
    assert max(feeds_of(op)) <= 1700 + 1e-6
    b.set(op, FeedControl="Constant feed")
    b.done(op)
    assert [c.toGCode() for c in op.Path.Commands] == constant


def test_a_number_of_teeth_that_is_not_known_is_told_where_chips_count(bench):
    sentence = "does not tell its number of teeth: 1 tooth is assumed."
    b, op = fed(bench, FeedControl="Constant chip thickness")
    b.controller.Tool.Flutes = 2
    assert sentence not in b.done(op).Report
    b.controller.Tool.Flutes = 0
    assert sentence in b.done(op).Report
    (advice,) = advisor.advice(op, strategies=advisor.STRATEGIES[:1])
    assert sentence in "".join(advice.notes)
    b.set(op, FeedControl="Constant feed")
    assert sentence not in b.done(op).Report


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({"MaximumFeed": "1600 mm/min"}, "1600 mm/min: it must not be below"),
        ({"StockOnFaces": 5.0}, "5 mm: it must lie between 0 and the ball's radius of 5 mm"),
        ({"StockOnFaces": 0.0}, "0 mm: it must be positive"),
    ],
)
def test_feed_control_refuses_what_it_cannot_hold(bench, change, sentence):
    b, op = fed(bench, FeedControl="Constant chip thickness")
    b.set(op, **change)
    assert sentence in b.refused(op)


def test_feed_control_needs_a_ball_and_a_spindle_speed(bench):
    b, op = fed(bench, FeedControl="Constant chip thickness")
    b.set(b.controller, SpindleSpeed=0)
    assert "without a spindle speed there is no feed per tooth" in b.refused(op)
    b.set(b.controller, SpindleSpeed=5100)
    b.controller.Tool = host.create_tool("bullnose", {"Diameter": 10})
    assert "has no ball end, and the chips that are known" in b.refused(op)
    b.set(op, FeedControl="Constant feed")
    b.done(op)


def test_feed_control_is_the_same_after_saving_and_reopening(bench, tmp_path):
    b, op = fed(bench, FeedControl="Constant chip thickness")
    b.done(op)
    before = op.CuttingTime
    with reopened(b.doc, tmp_path / "fed.FCStd") as doc:
        again = doc.getObject("Finish")
        assert again.FeedControl == "Constant chip thickness"
        again.touch()
        doc.recompute()
        assert again.isValid()
        # A file keeps a shape's numbers to some digits. The fitted feed shows it in its sixth, by
        # which one piece of the path may become two.
        assert again.CuttingTime == pytest.approx(before, rel=1e-3)


def test_an_operation_from_before_there_was_a_feed_control_has_a_constant_feed(bench, tmp_path):
    b, op = fed(bench)
    for name in ("FeedControl", "MaximumFeed", "StockOnFaces"):
        op.removeProperty(name)
    with reopened(b.doc, tmp_path / "old.FCStd") as doc:
        again = doc.getObject("Finish")
        assert again.FeedControl == "Constant feed"
        again.touch()
        doc.recompute()
        assert again.isValid() and again.Report == KEPT_OFF
        assert 60 * again.MaximumFeed.Value == pytest.approx(3264)
        assert again.StockOnFaces.Value == pytest.approx(0.3)


def test_undo_brings_the_constant_feed_back(bench):
    b, op = fed(bench)
    b.done(op)
    b.doc.UndoMode = 1
    b.doc.openTransaction("control")
    op.FeedControl = "Constant chip thickness"
    op.MaximumFeed = "2000 mm/min"
    b.doc.commitTransaction()
    assert "MaximumFeed" in op.OwnValues
    b.doc.undo()
    assert op.FeedControl == "Constant feed" and "MaximumFeed" not in op.OwnValues
    assert 60 * op.MaximumFeed.Value == pytest.approx(3264)


def test_a_fed_path_can_be_stopped(bench):
    b, op = fed(bench, FeedControl="Constant chip thickness")
    asked = []

    def progress(share):
        asked.append(share)
        return share < 0.61

    op.Proxy.progress = progress
    op.touch()
    b.doc.recompute()
    assert not op.isValid() and op.Report.startswith("Cancelled") and asked[-1] >= 0.61


def test_a_job_file_takes_the_feed_control(tmp_path):
    part(False).exportStep(str(tmp_path / "part.step"))
    read = Part.read(str(tmp_path / "part.step"))
    parameters = {"FeedControl": "Constant chip thickness", "MaximumFeed": 2500, "Stepover": 1.0}
    job = {
        "name": "trough",
        "model": "part.step",
        "base": list(upper(read)),
        "tool": {"diameter": 10, "shape": "ballend", "flutes": 4},
        "cutting": {"feed": 1632, "plunge_feed": 6000, "spindle_speed": 5100},
        "operation": {"type": "finishing", "parameters": {**parameters, "StockOnFaces": 0.2}},
        "output": {"gcode": "trough.ngc"},
    }
    (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [job]}))
    (done,) = batch.run_file(str(tmp_path / "jobs.json"), lambda line: None)["jobs"]
    assert done["ok"], done["error"]
    assert any(
        note.startswith("Feeds of the cuts: ") for note in done["figures"]["report"].split("\n")
    )
