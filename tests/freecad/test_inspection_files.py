"""What an inspection on faces writes: probing programs, pictures, reports; and job files."""

import base64
import html
import json
import re
import sys
from pathlib import Path

import FreeCAD
import numpy
import Part
import pytest
from inspected import as_measured, bore_faces, dome_faces, faces_of, wall_points
from models import block_with, face_of, floors_of, rectangle

from evenload import batch, face_inspection, inspection, translation
from evenload.face_inspection import html_report, picture
from evenload.face_inspection.evaluation import IN
from evenload.face_inspection.probing_program import Probe, probing_program

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
from languages import translator  # noqa: E402

pytestmark = pytest.mark.between

WALL = wall_points(24, numpy.zeros(24))


@pytest.fixture
def bore(doc):
    return bore_faces(doc)


# ---- what comes out ----


def test_the_probing_program_probes_each_point_and_leaves_the_spindle_still(doc, rs274, tmp_path):
    top = dome_faces(doc)
    samples = face_inspection.sample(top, 16, "matrix", "plan", 2.0)
    probe = Probe(diameter=3.0, feed=50.0)
    before = set(FreeCAD.listDocuments()), FreeCAD.ActiveDocument.Name
    text = probing_program(top, samples, probe)
    assert (set(FreeCAD.listDocuments()), FreeCAD.ActiveDocument.Name) == before
    touches = re.findall(r"G38\.2 X(\S+) Y(\S+) Z(\S+) F(\S+)", text)
    ends = samples.points + (1.5 - probe.overshoot) * samples.normals
    assert numpy.array(touches, dtype=float) == pytest.approx(
        numpy.column_stack([ends, numpy.full(16, 50.0)]), abs=6e-4
    )
    assert not re.search(r"\bM0?[34]\b", text)
    assert rs274(text, tmp_path).count("STRAIGHT_PROBE") == 16
    with pytest.raises(ValueError, match="diameter must be above 0"):
        probing_program(top, samples, Probe(diameter=0))


def test_what_looks_down_is_not_probed_from_above(doc):
    below = faces_of(doc, Part.makeBox(20, 20, 10), ["Face5"])
    samples = face_inspection.sample(below, 4)
    with pytest.raises(ValueError, match="looks down"):
        probing_program(below, samples, Probe())


def test_pictures_are_drawn_as_png_and_svg(bore, tmp_path):
    found = face_inspection.evaluate(bore, as_measured(WALL), "cylinder", 0.01)
    for name, begins in (("a.png", b"\x89PNG"), ("a.svg", b"<?xml")):
        path = tmp_path / name
        for draw in (
            lambda p: picture.save_map(found, p),
            lambda p: picture.save_samples(bore, face_inspection.sample(bore, 20), p),
        ):
            draw(path)
            assert path.read_bytes().startswith(begins) and path.stat().st_size > 5000
            path.unlink()


def test_the_report_is_one_file_with_its_picture_verdict_and_certificate(bore):
    deviations = numpy.random.default_rng(3).uniform(-0.01, 0.01, 24)
    deviations[5] = 0.05
    measured = as_measured(wall_points(24, deviations))
    found = face_inspection.evaluate(bore, measured, "cylinder", 0.03)
    text = html_report.report_of(found, "bore <1>.csv")
    assert "bore &lt;1&gt;.csv" in text and "Out of tolerance" in text
    assert "The minimum zone is proved" in text
    assert text.count("<tr") == text.count("</tr>")
    assert not re.search(r"(src|href)=\"(?!data:)|https?:|<script", text)
    (data,) = re.findall(r"base64,([^\"]+)", text)
    assert base64.b64decode(data).startswith(b"\x89PNG")
    assert text.count('<tr class="bad">') == found.is_beyond.sum() > 0
    contacts = len(found.found.contacts)
    assert len(re.findall(r"<td>(?:outer|inner)</td>", text)) == contacts
    assert html_report.report_of(found, "bore <1>.csv") == text


@pytest.mark.parametrize("unit, factor, name", [("mm", 1, "mm"), ("inch", 25.4, "in")])
def test_the_report_is_in_the_unit_that_is_asked_with_motions_and_datum(doc, unit, factor, name):
    faces = faces_of(doc, Part.makeBox(20, 20, 10), ["Face6"])
    measured = as_measured([[x, y, 10.02] for x in (2, 8, 14, 18) for y in (3, 9, 17)])
    datum = (0, 0, 2.54), (0, 0, 1)
    found = face_inspection.evaluate(faces, measured, "profile", 0.05, ("tx",), datum)
    text = html_report.report_of(found, unit=unit)
    digits = {"mm": 4, "inch": 6}[unit]
    assert "is %.*f %s, of 12 points" % (digits, 0.04 / factor, name) in text
    assert "keeps the tolerance of %.*f %s." % (digits, 0.05 / factor, name) in text
    assert "<td>%.*f</td>" % (digits, 10.02 / factor) in text  # z of a point
    assert "Deviation, %s<" % name in text and "<td>tx</td>" in text
    through = "through %s %s, normal 0.000000" % (
        ", ".join("%.*f" % (digits + 2, each / factor) for each in (0, 0, 2.54)),
        name,
    )
    assert through in text
    assert (" mm" in text) == (unit == "mm")


def test_the_report_tells_a_prediction_beside_what_was_measured(bore):
    found = face_inspection.evaluate(bore, as_measured(WALL), "cylinder")
    assert "Prediction" not in html_report.report_of(found)
    cut = inspection.Cut(0.15, 0.08, 0.3, 5, 8, 5100)
    predicted = inspection.prediction("CV", 90, 3, cut)
    text = html_report.report_of(found, prediction=predicted)
    row = "<td>Cylindricity</td><td>0.0445</td><td>95.6 %%</td><td>%.4f</td>" % found.zone
    assert row in text and "a concave face, passes at 90° to its axis, Rz 3 µm" in text
    assert "face radius 8, not 45 mm" in text
    text = html_report.report_of(found, unit="inch", prediction=predicted)
    assert "Rz 118.1 µin" in text and "face radius 0.315, not 1.772 in" in text
    found = face_inspection.evaluate(bore, as_measured(WALL), free=())
    text = html_report.report_of(found, prediction=predicted)
    measured = re.findall(r"<td>([^<]*)</td><td>[^<]*</td><td>[^<]* %</td><td>[^<]+</td>", text)
    assert measured == ["Profile of a surface in the datum"]


def texts_of(page):
    """What a reader of the page sees of words, its picture's too."""
    found = re.findall(r'>([^<>]+)<|alt="([^"]*)"', page.split("</style>")[1])
    return {html.unescape(text or alt) for text, alt in found if (text or alt).strip()}


def in_language(page, language, monkeypatch):
    """The texts of page() where FreeCAD's window has a language."""
    with monkeypatch.context() as patch:
        patch.setattr(translation, "translator", translator(language))
        text = page()
    assert '<html lang="%s">' % language in text
    return texts_of(text)


@pytest.mark.parametrize(
    "language, words",
    [
        ("de", {"Au\u00dferhalb der Toleranz", "Zylindrizit\u00e4t", "Nachweis"}),
        ("hu", {"T\u0171r\u00e9sen k\u00edv\u00fcl", "Hengeress\u00e9g", "Bizony\u00edt\u00e1s"}),
    ],
)
def test_in_the_window_the_report_is_in_the_users_language(bore, language, words, monkeypatch):
    cut = inspection.Cut(0.15, 0.08, 0.3, 5, 8, 5100)
    predicted = inspection.prediction("CV", 90, 3, cut)
    measured = as_measured(wall_points(24, 0.05 * numpy.eye(24)[5]))
    datum = (0, 0, 0), (0, 0, 1)
    for found in (
        face_inspection.evaluate(bore, measured, "cylinder", 0.03),
        face_inspection.evaluate(bore, measured, "profile", 0.01, (), datum),
    ):

        def page(found=found):
            return html_report.report_of(found, "wall.csv", "mm", predicted)

        told = in_language(page, language, monkeypatch)
        same = {each for each in told & texts_of(page()) if re.search("[a-z]{3}", each)}
        assert same <= {"Radius"}
        assert found.kind == "profile" or words <= told
    assert '<html lang="en">' in page()


# ---- job files ----


@pytest.fixture
def plate(tmp_path):
    """A folder with a model and points of its floor, and what makes a job with a section."""
    shape = block_with(face_of(rectangle(0, 0, 30, 20)))
    shape.exportBrep(str(tmp_path / "plate.brep"))
    (floor,) = floors_of(shape)
    grid = numpy.array([[x, y, -3.0] for x in (2, 10, 20, 28) for y in (2, 10, 18)])
    grid[::2, 2] += 0.01
    inspection.write_csv(tmp_path / "floor.csv", grid, numpy.tile([0, 0, 1.0], (12, 1)), "mm")

    def run(**section):
        job = {
            "model": "plate.brep",
            "base": [floor],
            "tool": {"diameter": 6},
            "cutting": {"feed": 255, "spindle_speed": 6366},
            "operation": {"type": "adaptive", "parameters": {"StepDown": 3}},
            "output": {"gcode": "plate.ngc"},
            "inspection": section,
        }
        (tmp_path / "jobs.json").write_text(json.dumps({"jobs": [job]}))
        (done,) = batch.run_file(str(tmp_path / "jobs.json"), lambda _: None)["jobs"]
        return done

    run.folder = tmp_path
    return run


def test_a_job_file_samples_and_evaluates(plate):
    done = plate(
        **{"points": 20, "margin": 1, "csv": "out/points.csv", "dmis": "out/points.dmi"},
        **{"picture": "out/points.png", "probing": "out/probe.ngc", "probe": {"diameter": 2}},
        **{"measured": "floor.csv", "feature": "plane", "tolerance": 0.02},
        **{"map": "out/map.png", "report": "out/floor.html"},
    )
    assert done["ok"], done["error"]
    figures = done["figures"]
    assert figures["inspection_zone_mm"] == pytest.approx(0.01, abs=1e-6)
    assert figures["inspection_verdict"] == IN and figures["inspection_proved"] is True
    assert "flatness is 0.0100 mm, of 12 points" in figures["inspection"]
    out = plate.folder / "out"
    points, normals = inspection.read_csv(out / "points.csv")
    assert len(points) == 20 and points[:, 2] == pytest.approx(-3)
    assert normals == pytest.approx(numpy.tile([0, 0, 1.0], (20, 1)))
    assert (out / "points.dmi").read_text().count("PTMEAS/") == 20
    assert (out / "probe.ngc").read_text().count("G38.2") == 20
    assert "G38" not in (plate.folder / "plate.ngc").read_text()
    for name in ("points.png", "map.png", "floor.html"):
        assert (out / name).stat().st_size > 5000
    assert set(done["output"]) == {
        "gcode",
        *("inspection_" + key for key in ("csv", "dmis", "picture", "probing", "map", "report")),
    }
    assert "inspection: zone" in batch.table([done])


@pytest.mark.parametrize(
    "section, words",
    [
        ({}, "nothing is asked"),
        ({"csv": "a.csv", "pionts": 4}, "unknown key 'pionts'"),
        ({"csv": "a.csv", "probe": {"diamter": 4}}, "unknown key 'diamter'"),
        ({"csv": "a.csv", "tolerance": 0.1}, "'tolerance' needs 'measured'"),
        ({"measured": "floor.csv", "points": 9}, "'points' needs 'csv'"),
        ({"csv": "a.csv", "probe": {}}, "'probe' needs 'probing'"),
        ({"csv": "floor.csv", "measured": "floor.csv"}, "overwrite its measured points"),
        ({"csv": "a.csv", "margin": 40}, "take a smaller one"),
        ({"measured": "none.csv"}, "none.csv cannot be read"),
        ({"measured": "floor.csv", "faces": ["Face99"]}, "there is no 'Face99'"),
        ({"measured": "floor.csv", "points_of": "air"}, "'points_of' is 'file' or 'faces'"),
        ({"measured": "floor.csv", "feature": "cone"}, "What is evaluated is"),
    ],
)
def test_what_is_wrong_in_a_section_is_named(plate, section, words):
    done = plate(**section)
    assert not done["ok"] and words in done["error"], done["error"]
    assert not (plate.folder / "plate.ngc").exists()
