"""The advisor: ten strategies on planes and on the source's test parts, against closed forms, the
operation's own figures and what the source found.
"""

import math
import re
from pathlib import Path

import numpy
import FreeCAD
import Part
import pytest
from conftest import Bench, freecad
from finishing_parts import DOME, part, upper
from FreeCAD import Vector

from evenload import advisor, ball_end, face_inspection, host, machines, materials, waiting
from evenload.advisor import bent_faces
from evenload.operations import finishing

pytestmark = pytest.mark.core  # what is computed, behind docks that each FreeCAD is asked for

BALL, STOCK, FEED, SPEED, TEETH = 5.0, 0.3, 1632.0, 5100.0, 4  # [Varga 2023, ch. 8]
NAMES = [
    *("Zig-zag 0°", "Zig-zag 22.5°", "Zig-zag 45°", "Zig-zag 67.5°", "Zig-zag 90°"),
    *("Contours inwards", "Contours outwards", "Spiral inwards", "Spiral outwards", "One way 0°"),
]
FIGURES = [
    *("seconds", "mean_thickness", "scatter", "max_thickness", "mean_cusp", "max_cusp"),
    *("tip_share", "least_speed", "impulse"),
]


@pytest.fixture
def job_of(bench):
    """A Bench with the source's tool and conditions."""

    def made(shape, shape_of_tool="ballend"):
        b = bench(shape, tool=2 * BALL, feed=FEED)
        b.controller.Tool = host.create_tool(shape_of_tool, {"Diameter": 2 * BALL, "Flutes": TEETH})
        b.controller.SpindleSpeed = SPEED
        b.doc.recompute()
        return b

    return made


def faces_of(b):
    return [(b.model, upper(b.model.Shape))]


def by_name(rows):
    return {row.strategy.name: row for row in rows}


@pytest.mark.core
def test_on_a_plane_figures_are_those_of_the_closed_forms(job_of):
    b = job_of(Part.makeBox(40, 30, 10))
    rows = advisor.advice(
        b.job,
        faces_of(b),
        controller=b.controller,
        stock=STOCK,
        machine="linuxcnc_mill",
        Stepover=0.5,
    )
    assert [row.strategy.name for row in rows] == NAMES
    assert not any(row.refusal or row.notes for row in rows)
    slot = ball_end.chip(("plane",), 2 * BALL, FEED / SPEED / TEETH, 0.5, STOCK, 0, uncut="slot")
    found = by_name(rows)["Zig-zag 0°"]
    chip = ball_end.chip(("plane",), 2 * BALL, FEED / SPEED / TEETH, 0.5, STOCK, 0)
    passes = 60  # of 0.5 mm, of which the first has no other beside it
    thickness = chip.mean_thickness + (slot.mean_thickness - chip.mean_thickness) / passes
    assert found.mean_thickness == pytest.approx(thickness, rel=2e-3)
    assert found.max_thickness == pytest.approx(slot.max_thickness, rel=1e-3)
    share = (passes - 1) / passes**2
    scatter = math.sqrt(share) * (slot.mean_thickness - chip.mean_thickness)
    assert found.scatter == pytest.approx(scatter, rel=0.1)
    assert found.mean_cusp == pytest.approx(0.5**2 / (8 * BALL), rel=2e-3)
    assert found.max_cusp == pytest.approx(found.mean_cusp, rel=1e-6)
    assert found.tip_share == pytest.approx(max(chip.tip_share, slot.tip_share), abs=1e-3)
    assert found.least_speed == 0
    assert found.seconds > 60 * 40 * passes / FEED  # the cuts alone
    for row in rows:
        assert row.machine_seconds > row.seconds
        assert row.mean_cusp == pytest.approx(found.mean_cusp, rel=0.03)


def test_the_impulse_is_the_force_over_the_time_of_the_cuts(job_of):
    b = job_of(Part.makeBox(40, 30, 10))
    options = dict(controller=b.controller, strategies=advisor.STRATEGIES[:1], Stepover=0.5)
    (first,) = advisor.advice(b.job, faces_of(b), material={"ktc": 600, "krc": 200}, **options)
    (second,) = advisor.advice(b.job, faces_of(b), material={"ktc": 1200, "krc": 400}, **options)
    assert second.impulse == pytest.approx(2 * first.impulse, rel=1e-9)
    chip = ball_end.chip(("plane",), 2 * BALL, FEED / SPEED / TEETH, 0.5, STOCK, 0)
    # Without edge terms a tooth's impulse is that of sqrt(ktc^2 + krc^2) V over the speed of the
    # edge, which is slow: 2 mm of local radius is more than half of the plane's edge has.
    work = math.hypot(600, 200) * chip.volume * TEETH * SPEED / 60
    least = work / (2 * math.pi * 2.0 * SPEED / 60)
    assert first.impulse / (60 * 40 * 60 / FEED) > least


@pytest.mark.core
@pytest.mark.parametrize("strategy", [advisor.STRATEGIES[k] for k in (1, 5, 8)], ids=str)
def test_seconds_are_those_of_the_operation_that_it_makes(job_of, strategy):
    b = job_of(part(True))
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    op.Base = faces_of(b)
    b.set(op, Stepover=2.0, Tolerance=0.02, **strategy.settings)
    (row,) = advisor.advice(op, strategies=[strategy])
    (of_job,) = advisor.advice(
        b.job, faces_of(b), [strategy], controller=b.controller, Stepover=2.0, Tolerance=0.02
    )
    b.done(op)
    assert row.seconds == pytest.approx(op.CuttingTime, rel=1e-9)
    assert of_job.seconds == pytest.approx(op.CuttingTime, rel=1e-9)


@pytest.fixture(scope="module")
def advised():
    """{whether convex: {name: Advice}} of the source's parts at a_e 0.35 and f_z 0.08."""
    found = {}
    for is_convex in (True, False):
        doc = FreeCAD.newDocument("Advised")
        b = Bench(doc, part(is_convex), tool=2 * BALL, feed=FEED)
        b.controller.Tool = host.create_tool("ballend", {"Diameter": 2 * BALL, "Flutes": TEETH})
        b.controller.SpindleSpeed = SPEED
        doc.recompute()
        rows = advisor.advice(b.job, faces_of(b), controller=b.controller, Stepover=0.35)
        found[is_convex] = by_name(rows)
        FreeCAD.closeDocument(doc.Name)
    return found


BOTH = pytest.mark.parametrize(
    "is_convex", [True, pytest.param(False, marks=pytest.mark.core)], ids=["CX", "CV"]
)


@BOTH
def test_every_strategy_has_all_figures_on_the_source_s_parts(advised, is_convex):
    for row in advised[is_convex].values():
        assert not row.refusal
        assert all(math.isfinite(getattr(row, name)) for name in FIGURES)
        assert row.machine_seconds is None


@BOTH
def test_direction_changes_the_scatter_of_h_m_and_hardly_its_mean(advised, is_convex):
    """[Varga 2023, p. 58]: least at 0 degrees, largest at 90; the mean hardly depends on it."""
    rows = [advised[is_convex][name] for name in NAMES[:5]]
    assert rows[0].scatter < 0.75 * rows[4].scatter
    means = [row.mean_thickness for row in rows]
    assert max(means) < 1.05 * min(means)


@BOTH
def test_zig_zags_take_about_as_long_in_all_directions(advised, is_convex):
    """[Varga 2023, ch. 8]: strategies 1 to 6 differ little in time."""
    times = [advised[is_convex][name].seconds for name in NAMES[:6]]
    assert max(times) < 1.06 * min(times)
    assert advised[is_convex]["One way 0°"].seconds > 1.2 * times[0]


@BOTH
def test_the_tip_cuts_most_where_passes_come_down_the_slope_beside(advised, is_convex):
    """At an inclined place the side of the earlier passes decides it (docs/chip_model.md)."""
    rows = advised[is_convex]
    assert rows["Zig-zag 0°"].tip_share > 0.9
    assert rows["Zig-zag 90°"].tip_share < 0.7
    contours = rows["Contours inwards"].tip_share, rows["Contours outwards"].tip_share
    assert (contours[0] < contours[1]) == is_convex  # uphill on the dome


@BOTH
def test_cusps_across_the_slope_are_higher_at_an_even_stepover_in_plan(advised, is_convex):
    rows = advised[is_convex]
    level = BALL - math.sqrt(BALL**2 - 0.35**2 / 4)
    steepest = (30 / 55) / math.sqrt(1 - (30 / 55) ** 2)  # tan of the parts' largest slope
    for name in NAMES[:5]:
        assert rows[name].mean_cusp == pytest.approx(level, rel=0.1)
    assert rows["Zig-zag 0°"].max_cusp > level * (1 + steepest**2)
    assert rows["Zig-zag 90°"].max_cusp < 1.05 * level


def test_the_picked_faces_bend_as_they_are_drawn(job_of):
    b = job_of(part(True))
    found = advisor.read(b.job, faces_of(b), controller=b.controller, Stepover=0.35)
    tops = numpy.array([(3.0, 12.0, math.sqrt(DOME**2 - 144)), (-8.0, -20.0, math.sqrt(1625))])
    bends, is_face = bent_faces.bends_at(found.faces, tops, tops * (0, 1, 1) / DOME, 0.0)
    assert is_face.all()
    assert bends.across(numpy.array([(1.0, 0, 0)] * 2)) == pytest.approx([1 / DOME] * 2)
    assert bends.across(numpy.cross(bends.normals, (1, 0, 0))) == pytest.approx([0, 0], abs=1e-12)


# ---- how faces bend ----


def bends_of(shape, points, allowance=0.0):
    """The Bends at points of a shape's faces, with outward normals as contacts have them."""
    faces = face_inspection.PickedFaces(
        [("Solid", "Face%d" % n) for n, _ in enumerate(shape.Faces, 1)],
        shape.Faces,
        None,
        Part.Compound([shape]),
    )
    found = face_inspection.FacesPart(faces)
    points = numpy.array(points, float)
    _, normals = found(points, range(len(points)))
    return bent_faces.bends_at(found, points, normals, allowance)


@pytest.mark.parametrize("allowance", [0.0, 0.5])
def test_a_sphere_bends_alike_in_all_directions_its_pole_too(allowance):
    points = 20 * numpy.array([(0, 0, 1), (0.6, 0, 0.8), (0, -0.6, 0.8)])
    bends, is_face = bends_of(Part.makeSphere(20), points, allowance)
    assert is_face.all()
    assert bends.first == pytest.approx([1 / (20 + allowance)] * 3)
    assert bends.second == pytest.approx([1 / (20 + allowance)] * 3)


def test_a_torus_has_both_its_curvatures_along_their_directions():
    ring, tube = 30.0, 8.0
    bends, _ = bends_of(Part.makeTorus(ring, tube), [(ring + 4, 0, math.sqrt(48))])
    sine = 0.5  # of the normal's lean outwards
    assert bends.first[0] == pytest.approx(sine / (ring + tube * sine))
    assert bends.second[0] == pytest.approx(1 / tube)
    assert abs(bends.directions[0] @ (0, 1, 0)) == pytest.approx(1)


def test_a_trough_bends_the_other_way_and_less_below_an_allowance():
    block = Part.makeBox(40, 60, 30, Vector(-20, -30, -30))
    trough = block.cut(Part.makeCylinder(20, 60, Vector(-30, 0, 5), Vector(1, 0, 0)))
    for allowance in (0.0, 0.5):
        bends, is_face = bends_of(trough, [(0, 0, -15)], allowance)
        assert is_face.all() and bends.normals[0] == pytest.approx((0, 0, 1), abs=1e-9)
        assert bends.first[0] == pytest.approx(-1 / (20 - allowance))
        assert bends.second[0] == pytest.approx(0, abs=1e-12)
        assert abs(bends.directions[0] @ (0, 1, 0)) == pytest.approx(1)


def test_guides_beside_the_faces_are_left_aside(job_of):
    b = job_of(Part.makeBox(40, 30, 10))
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    edges = [name for name in ("Edge%d" % n for n in range(1, 13)) if is_upper(b, name)][:2]
    op.Base = [*faces_of(b), (b.model, tuple(edges))]
    b.set(op, Strategy="Between guides", Stepover=2.0)
    (row,) = advisor.advice(op, strategies=advisor.STRATEGIES[:1])
    b.set(op, **row.strategy.settings)
    assert b.done(op).CuttingTime == pytest.approx(row.seconds, rel=1e-9)


def is_upper(b, name):
    return b.model.Shape.getElement(name).BoundBox.ZMin > 9.9


# ---- what is told where it cannot be ----


def test_a_strategy_that_does_not_fit_is_told_in_its_row(job_of):
    b = job_of(Part.makeBox(40, 2, 10))
    rows = by_name(
        advisor.advice(b.job, faces_of(b), controller=b.controller, Stepover=3.0, stock=0.2)
    )
    assert list(rows) == NAMES
    for name, row in rows.items():
        if name.startswith("Contours"):
            assert row.refusal.endswith(".") and row.seconds is None and row.impulse is None
        else:
            assert not row.refusal and row.seconds > 0


@pytest.mark.parametrize(
    "tool, asked, sentence",
    [
        ("endmill", {}, "has no ball end"),
        ("ballend", {"stock": 0.0}, "must be more than 0"),
        ("ballend", {"stock": 6.0}, "more than the ball can take"),
        ("ballend", {"Stepdown": 1.0}, "has no 'Stepdown'"),
        ("ballend", {"Stepover": -1.0}, "Stepover is -1 mm"),
        ("ballend", {"material": "Butter"}, "no material 'Butter'"),
        ("ballend", {"machine": "Lathe"}, "no machine 'Lathe'"),
    ],
)
def test_what_cannot_be_asked_is_refused_in_a_sentence(job_of, tool, asked, sentence):
    b = job_of(Part.makeBox(20, 10, 10), tool)
    with pytest.raises(ValueError, match=sentence):
        advisor.read(b.job, faces_of(b), controller=b.controller, **asked)


def test_without_faces_a_spindle_speed_or_a_controller_it_is_refused(job_of):
    b = job_of(Part.makeBox(20, 10, 10))
    with pytest.raises(ValueError, match="pick the faces to be finished"):
        advisor.read(b.job, [])
    with pytest.raises(ValueError, match="is no face"):
        advisor.read(b.job, [(b.model, ("Edge1",))])
    b.controller.SpindleSpeed = 0
    with pytest.raises(ValueError, match="no spindle speed"):
        advisor.read(b.job, faces_of(b))
    b.job.Tools.Group = []
    with pytest.raises(ValueError, match="has no tool"):
        advisor.read(b.job, faces_of(b))


def test_an_operation_in_no_job_is_refused_in_a_sentence(job_of):
    b = job_of(Part.makeBox(20, 10, 10))
    op = finishing.Create("Finish", parentJob=b.job, toolController=b.controller)
    b.job.Operations.Group = []
    with pytest.raises(ValueError, match="belongs to no job"):
        advisor.read(op)


def test_stepover_and_cusp_height_follow_each_other(job_of):
    b = job_of(Part.makeBox(20, 10, 10))
    of_cusp = advisor.read(b.job, faces_of(b), CuspHeight=0.01).settings
    assert of_cusp.Stepover.Value == pytest.approx(2 * math.sqrt(0.01 * 9.99))
    of_step = advisor.read(b.job, faces_of(b), Stepover=2.0).settings
    assert of_step.CuspHeight.Value == pytest.approx(BALL - math.sqrt(BALL**2 - 1))


def test_the_example_of_the_documentation_runs_as_written(tmp_path):
    page = (Path(__file__).resolve().parents[2] / "docs" / "finishing.md").read_text()
    (macro,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "macro.py").write_text(macro)
    _, output = freecad("macro.py", cwd=tmp_path)
    assert "Traceback" not in output and "cannot be" not in output, output[-2000:]
    assert len(re.findall(r"h_m \d+\.\d+ µm ± \d+\.\d+, tip +\d+ %, +\d+ N s", output)) == 10


def test_nothing_in_the_document_is_changed(job_of):
    b = job_of(part(False))
    before = [obj.Name for obj in b.doc.Objects]
    advisor.advice(b.job, faces_of(b), advisor.STRATEGIES[:1], Stepover=3.0)
    assert [obj.Name for obj in b.doc.Objects] == before
    assert not any(obj.State and "Touched" in obj.State for obj in b.doc.Objects)


def test_once_read_no_document_is_needed(job_of):
    """Another thread computes while the user goes on, or closes the document."""
    b = job_of(Part.makeBox(20, 10, 10))
    question = advisor.read(b.job, faces_of(b), Stepover=2.0)
    (before,) = advisor.answers(question, advisor.STRATEGIES[:1])
    b.controller.Tool.Diameter = 3
    b.doc.removeObject(b.controller.Name)
    assert list(advisor.answers(question, advisor.STRATEGIES[:1])) == [before]
    assert before.seconds > 0


@pytest.mark.parametrize(
    "share",
    [pytest.param(0.05, marks=pytest.mark.core), 0.55, pytest.param(0.96, marks=pytest.mark.core)],
)
def test_it_is_stopped_wherever_it_is(job_of, share):
    b = job_of(part(True))
    question = advisor.read(b.job, faces_of(b), Stepover=4.0)
    seen = []

    def watch(done):
        seen.append(done)
        return done < share

    with waiting.asking(watch), pytest.raises(waiting.Stopped):
        list(advisor.answers(question))
    assert seen == sorted(seen) and share <= seen[-1] < share + 0.1


def test_a_machine_and_a_material_are_read_by_their_names(job_of):
    b = job_of(Part.makeBox(20, 10, 10))
    question = advisor.read(b.job, faces_of(b), machine=machines.names()[0])
    assert question.cutting.coefficients["name"] == materials.names()[0]
    assert question.machine["name"]
