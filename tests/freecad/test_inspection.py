"""Inspection on faces: where to measure, and what measured points say."""

import math

import FreeCAD
import numpy
import Part
import pytest
from FreeCAD import Vector
from inspected import X, Y, as_measured, bore_faces, dome, dome_faces
from inspected import faces_of, upper_faces, wall_points

from evenload import face_inspection, inspection
from evenload.face_inspection.evaluation import IN, OPEN, OUT
from evenload.face_inspection.patterns import LEAST, PATTERNS, SPACINGS

pytestmark = pytest.mark.between


@pytest.fixture
def part():
    return inspection.test_part("CX")


@pytest.fixture
def top(doc):
    return dome_faces(doc)


@pytest.fixture
def bore(doc):
    return bore_faces(doc)


def round_face(solid):
    """The name of R45 on the test part, the one whose radius is so large."""
    (name,) = (
        n for n in upper_faces(solid) if getattr(solid.getElement(n).Surface, "Radius", 0) > 44
    )
    return name


# ---- sampling ----


@pytest.mark.parametrize("spacing", SPACINGS)
@pytest.mark.parametrize("pattern", PATTERNS)
def test_points_and_normals_are_exact_on_the_faces_and_keep_the_margin(top, part, pattern, spacing):
    found = face_inspection.sample(top, LEAST, pattern, spacing, 2.0)
    feet, normals = part(found.points)
    assert LEAST <= len(found.points) <= 1.5 * LEAST
    assert pattern == "matrix" or len(found.points) == LEAST
    assert found.points == pytest.approx(feet, abs=1e-9)
    assert found.normals == pytest.approx(normals, abs=1e-9)
    assert numpy.abs(found.points[:, :2]).max() <= 38 + 1e-9
    again = face_inspection.sample(top, LEAST, pattern, spacing, 2.0)
    assert numpy.array_equal(again.points, found.points)


def test_a_matrix_in_plan_stands_in_the_middle_of_its_cells(top):
    found = face_inspection.sample(top, 49, "matrix", "plan")
    rows = numpy.unique(numpy.round(found.points[:, 0], 6))
    assert rows == pytest.approx(-40 + 80 * (numpy.arange(7) + 0.5) / 7, abs=1e-5)


def test_by_arc_length_a_row_around_the_dome_has_even_arcs(doc, part):
    solid = dome(part)
    name = round_face(solid)
    found = face_inspection.sample(faces_of(doc, solid, [name]), 25, "matrix", margin=1.0)
    turns = numpy.unique(numpy.round(numpy.arctan2(found.points[:, 1], found.points[:, 2]), 7))
    assert len(turns) == 5
    assert numpy.diff(turns) == pytest.approx(turns[1] - turns[0], abs=1e-4)


def test_trimmed_faces_get_points_inside_only_and_as_many_as_asked(doc):
    plate = Part.makeBox(60, 40, 5).cut(Part.makeCylinder(12, 20, Vector(30, 20, -5)))
    names = [n for n in upper_faces(plate) if plate.getElement(n).BoundBox.ZLength < 1e-6]
    for spacing in SPACINGS:
        found = face_inspection.sample(faces_of(doc, plate, names), 60, spacing=spacing, margin=3)
        from_hole = numpy.hypot(found.points[:, 0] - 30, found.points[:, 1] - 20)
        assert 60 <= len(found.points) <= 62 and from_hole.min() >= 15 - 1e-9
        assert found.points[:, :2].min(axis=0).min() >= 3 - 1e-9
        assert found.points[:, 2] == pytest.approx(5) and found.normals[:, 2] == pytest.approx(1)


def test_round_faces_are_sampled_all_around_with_normals_out_of_the_part(bore, doc):
    found = face_inspection.sample(bore, 64)
    turns = numpy.sort(numpy.arctan2(found.points[:, 1] - 25, found.points[:, 0] - 25))
    assert numpy.diff(turns).max() < 0.2 and len(turns) == 64
    inwards = [25.0, 25.0] - found.points[:, :2]
    assert (found.normals[:, :2] * inwards).sum(axis=1) == pytest.approx(8)
    ball = face_inspection.sample(faces_of(doc, Part.makeSphere(10), ["Face1"]), 50)
    assert ball.points == pytest.approx(10 * ball.normals) and len(ball.points) == 50


def test_faces_are_taken_where_they_stand_in_the_world(doc):
    container = doc.addObject("App::Part", "Container")
    container.Placement.Base = Vector(100, 0, 0)
    obj = doc.addObject("Part::Feature", "Box")
    obj.Shape = Part.makeBox(10, 10, 10)
    obj.Placement.Base = Vector(0, 50, 0)
    container.addObject(obj)
    doc.recompute()
    found = face_inspection.sample(face_inspection.picked([(obj, upper_faces(obj.Shape))]), 16)
    lows, highs = found.points.min(axis=0), found.points.max(axis=0)
    assert 100 < lows[0] < highs[0] < 110 and 50 < lows[1] < highs[1] < 60


@pytest.mark.parametrize(
    "options, words",
    [
        ({"count": 0}, "number of points is 1 to"),
        ({"pattern": "random"}, "pattern is Halton-Zaremba or matrix"),
        ({"spacing": "time"}, "spacing is by arc length or plan"),
        ({"margin": -1}, "margin is a length"),
        ({"margin": math.nan}, "margin is a length"),
        ({"margin": 30}, "take a smaller one"),
        ({"margin": 30, "spacing": "plan"}, "take a smaller one"),
        ({"spacing": "plan"}, "space the points by arc length"),
    ],
)
def test_what_cannot_be_sampled_is_told_in_a_sentence(bore, options, words):
    with pytest.raises(ValueError, match=words):
        face_inspection.sample(bore, **options)


def test_what_is_no_face_is_told_in_a_sentence(doc):
    obj = doc.addObject("Part::Feature", "Box")
    obj.Shape = Part.makeBox(10, 10, 10)
    for base, words in (
        ([], "No face is picked"),
        ([(obj, "Edge1")], "Edge1 of Box is no face"),
        ([(obj, "")], "All of Box is no face"),
        ([(obj, "Face9")], "There is no Face9 on Box"),
    ):
        with pytest.raises(ValueError, match=words):
            face_inspection.picked(base)


# ---- evaluation ----


def rotation(vector):
    """The turn about a vector by its length in rad."""
    turn = FreeCAD.Rotation(Vector(*vector), math.degrees(numpy.linalg.norm(vector)))
    return numpy.array([tuple(turn.multVec(Vector(*axis))) for axis in numpy.eye(3)]).T


@pytest.mark.parametrize("is_spline", [False, True])
def test_a_known_deviation_and_motion_are_recovered_on_faces(doc, part, is_spline):
    random = numpy.random.default_rng(4)
    feet, normals = part.at(X, Y)
    # At six places or more the deviation is the largest, now on this side, now on that: no motion
    # makes it smaller, as the proof tells.
    deviations = 0.01 * numpy.where((numpy.arange(441) // 7) % 2, 1, -1)
    deviations[random.random(441) < 0.8] *= 0.5
    turn, shift = rotation([0.002, -0.001, 0.0015]), numpy.array([0.0, 0.05, -0.08])
    moved = (feet + deviations[:, None] * normals - shift) @ turn
    solid = dome(part)
    faces = faces_of(doc, solid.toNurbs() if is_spline else solid, upper_faces(solid))
    found = face_inspection.evaluate(faces, as_measured(moved))
    assert found.found.is_proved
    assert found.zone == pytest.approx(0.02, abs=1e-6)
    assert found.found.turn == pytest.approx(turn, abs=1e-6)
    assert found.found.shift[1:] == pytest.approx(shift[1:], abs=1e-6)  # x is free of the part
    assert found.deviations == pytest.approx(deviations, abs=1e-6)


def test_distances_are_to_the_faces_as_they_are_trimmed(doc):
    faces = faces_of(doc, Part.makeBox(10, 10, 10), ["Face6"])
    part = face_inspection.FacesPart(faces)
    points = [[5, 5, 10.5], [13, 5, 10], [13, 14, 10]]
    assert part.distances(points) == pytest.approx([0.5, 3, 5])
    feet, normals = part(numpy.array([[10.2, 5, 10.1]]), [0])
    # Beyond the border the plane goes on: the deviation stays along the normal.
    assert feet == pytest.approx(numpy.array([[10.2, 5, 10]]))
    assert normals == pytest.approx(numpy.array([[0, 0, 1]]))


def test_verdicts_follow_the_zone_and_its_proof(bore):
    deviations = numpy.random.default_rng(3).uniform(-0.01, 0.01, 24)
    found = face_inspection.evaluate(bore, as_measured(wall_points(24, deviations)), "cylinder")
    assert found.verdict is None and found.is_beyond is None and found.found.is_proved
    assert found.found.radius == pytest.approx(8, abs=0.01)
    for tolerance, verdict, words in (
        (1.01 * found.zone, IN, "keeps the tolerance"),
        (0.99 * found.zone, OUT, "exceeds the tolerance"),
    ):
        judged = face_inspection.evaluate(bore, found.measured, "cylinder", tolerance)
        assert judged.verdict == verdict and words in judged.sentences[-1]
        assert judged.is_beyond.any() == (verdict == OUT)
    # A line in space may stay unproved: too wide a zone is no verdict then.
    judged = face_inspection.evaluate(bore, found.measured, "cylinder", 0.99 * found.zone)
    unproved = judged.found.__class__(**{**judged.found.__dict__, "is_proved": False})
    open_one = judged.__class__(**{**judged.__dict__, "found": unproved})
    assert open_one.verdict == OPEN and "not decided" in open_one.sentences[-1]
    assert "not proved" in open_one.sentences[1]


def test_a_datum_leaves_the_error_of_position_in_the_profile(doc):
    box = Part.makeBox(20, 20, 10)
    faces = faces_of(doc, box, ["Face6"])
    points = as_measured([[x, y, 10.02] for x in (2, 8, 14, 18) for y in (3, 9, 17)])
    datum = face_inspection.datum_of(faces_of(doc, box, ["Face5"]))
    assert face_inspection.evaluate(faces, points).zone == pytest.approx(0, abs=1e-9)
    found = face_inspection.evaluate(faces, points, datum=datum)
    assert found.zone == pytest.approx(0.04) and found.deviations == pytest.approx(0.02)
    with pytest.raises(ValueError, match="one plane face"):
        face_inspection.datum_of(faces_of(doc, Part.makeSphere(5), ["Face1"]))


def test_a_datum_is_a_plane_face_or_a_datum_plane_of_the_document(doc):
    obj = doc.addObject("Part::Feature", "Box")
    obj.Shape = Part.makeBox(20, 20, 10)
    obj.Placement.Base = Vector(0, 0, 5)
    body = doc.addObject("PartDesign::Body", "Body")
    plane = body.newObject("PartDesign::Plane", "Plane")
    plane.AttachmentOffset.Base = plane.Placement.Base = Vector(1, 2, 3)
    body.Placement.Base = Vector(0, 0, 4)
    doc.recompute()
    point, normal = face_inspection.datum_at(obj, "Face6")
    assert point == pytest.approx((10, 10, 15)) and normal == pytest.approx((0, 0, 1))
    point, normal = face_inspection.datum_at(plane, "")
    assert point == pytest.approx((1, 2, 7)) and normal == pytest.approx((0, 0, 1))
    level = next(each for each in doc.Objects if each.Name.startswith("XZ_Plane"))
    assert face_inspection.datum_at(level, "")[1] == pytest.approx((0, -1, 0))
    ball = doc.addObject("Part::Feature", "Ball")
    ball.Shape = Part.makeSphere(5)
    with pytest.raises(ValueError, match="one plane face"):
        face_inspection.datum_at(ball, "Face1")
    base = [(obj, ["Face1", "Face6"]), (ball, ["Face1"])]
    assert face_inspection.plane_faces(base) == [(obj, "Face1"), (obj, "Face6")]


def test_the_motions_that_were_free_are_told(bore):
    points = as_measured(wall_points(24, numpy.random.default_rng(3).uniform(-0.01, 0.01, 24)))
    assert face_inspection.evaluate(bore, points).free == inspection.profiles.MOTIONS
    assert face_inspection.evaluate(bore, points, free="tz").free == ("tz",)
    datum = (0, 0, 0), (0, 0, 1)
    found = face_inspection.evaluate(bore, points, datum=datum)
    assert found.free == () and found.datum == datum


def test_the_largest_cylinder_tells_how_faces_are_bent(doc, part, top, bore):
    bent = face_inspection.round_face(top)
    assert bent.nature == "CX" and bent.radius == pytest.approx(45)
    for angle, wanted in ((0, 0), (30, 30), (90, 90), (135, 45), (-20, 20), (180, 0)):
        assert bent.feed_direction(angle) == pytest.approx(wanted)
    bent = face_inspection.round_face(bore)
    assert bent.nature == "CV" and bent.radius == pytest.approx(8)
    assert face_inspection.round_face(faces_of(doc, Part.makeBox(1, 1, 1), ["Face1"])) is None


def test_points_that_other_faces_are_nearer_to_can_be_left_out(doc, part):
    solid = dome(part)
    name = round_face(solid)
    feet, normals = part.at(X, Y)
    away = numpy.where(part.piece(feet) == 2, 0.005, 0.05)
    measured = as_measured(feet + away[:, None] * normals)
    faces = faces_of(doc, solid, [name])
    found = face_inspection.evaluate(faces, measured, free=(), all_points=False)
    assert found.zone == pytest.approx(0.01) and found.deviations == pytest.approx(0.005)
    assert found.left_out == (part.piece(feet) != 2).sum() == 441 - len(found.measured.names)
    assert "left out: %d" % found.left_out in found.sentences[2]
    with pytest.raises(ValueError, match="from the faces"):
        face_inspection.evaluate(faces, measured, free=())
    beside = as_measured(measured.points[:21])
    with pytest.raises(ValueError, match="All points are nearer to other faces"):
        face_inspection.evaluate(faces, beside, all_points=False)


WALL = wall_points(24, numpy.zeros(24))
LINE = [[33, 25, z] for z in numpy.linspace(1, 19, 12)]


@pytest.mark.parametrize(
    "points, options, words",
    [
        (WALL[:6], {}, "6 points fit any face by 6 free motions: measure 7"),
        (WALL[:3], {"kind": "cylinder"}, "too few"),
        (LINE, {}, "All points lie on one line"),
        (LINE, {"kind": "cylinder"}, "do not determine a cylinder"),
        (WALL + [0, 0, 60], {}, "lies .* mm from the faces"),
        (WALL * 25.4, {}, "only if their numbers are mm"),
        (WALL / 25.4, {}, "only if their numbers are inch"),
        (WALL, {"kind": "cone"}, "What is evaluated is profile"),
        (WALL, {"tolerance": 0}, "tolerance is a width above 0"),
        (WALL, {"tolerance": math.nan}, "tolerance is a width above 0"),
        (WALL, {"free": ["up"]}, "motions are tx"),
        (WALL, {"kind": "plane", "free": ["tz"]}, "Only a profile"),
    ],
)
def test_points_that_tell_nothing_are_refused_in_a_sentence(bore, points, options, words):
    with pytest.raises(ValueError, match=words) as refused:
        face_inspection.evaluate(bore, as_measured(points), **options)
    assert str(refused.value).endswith(".") and "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "name, text, words",
    [
        ("a.txt", "", "ends in .csv or .dmi"),
        ("none.csv", None, "cannot be read"),
        ("a.csv", "x [mm],y [mm],z [mm],i,j,k\n", "has no points"),
        ("a.csv", "x [mm],y [mm],z [mm],i,j,k\nnan,0,0,0,0,1\n", "holds six numbers"),
        ("a.csv", "x [mm],y [inch],z [mm],i,j,k\n1,0,0,0,0,1\n", "different units"),
        ("a.csv", b"\xff\xfe\x00", "is no text"),
        ("a.dmo", "UNITS/MM,ANGDEC\n", "no measured points"),
    ],
)
def test_files_that_cannot_be_read_are_refused_in_a_sentence(tmp_path, name, text, words):
    path = tmp_path / name
    if text is not None:
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ValueError, match=words):
        face_inspection.read_points(str(path))


def test_centres_of_the_probes_ball_are_corrected(bore, tmp_path):
    normals = [25.0, 25.0, 0.0] - WALL * [1, 1, 0]
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    inspection.write_csv(tmp_path / "centres.csv", WALL + 1.5 * normals, normals, "inch")
    inspection.write_csv(tmp_path / "mm.csv", WALL + 1.5 * normals, normals, "mm")
    found = face_inspection.read_points(str(tmp_path / "mm.csv"), 1.5)
    assert found.points == pytest.approx(WALL)
    with pytest.raises(ValueError, match="are mm: correct the unit"):
        face_inspection.evaluate(bore, face_inspection.read_points(str(tmp_path / "centres.csv")))
