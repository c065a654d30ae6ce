"""Job files: G-code, pictures and reports without a GUI, and clear words for what is wrong."""

import copy
import errno
import json
import os
import shutil
import subprocess
import sys

import FreeCAD
import Part
import pytest
from conftest import freecad
from models import DEPTH, SQUARE, block_with, face_of, floors_of, rectangle, wire
from evenload import batch, tool
from evenload.host import posts
from evenload.job_files import outputs, read, report
from evenload.simulation import run as simulator_run
from FreeCAD import Vector
from simulated import faulty

BULLNOSE = {"diameter": 6, "shape": "bullnose"}


@pytest.fixture
def folder(tmp_path):
    """A folder with the model as STEP, BREP and FreeCAD document (with a sketch in it)."""
    shape = block_with(face_of(SQUARE))
    shape.exportStep(str(tmp_path / "plate.step"))
    shape.exportBrep(str(tmp_path / "plate.brep"))
    doc = FreeCAD.newDocument("Plate")
    doc.addObject("Part::Feature", "Plate").Shape = shape
    sketch = doc.addObject("Sketcher::SketchObject", "Outline")
    for edge in wire(rectangle(2, 2, 28, 20)).Edges:
        sketch.addGeometry(Part.LineSegment(*(v.Point for v in edge.Vertexes)), False)
    sketch.Placement.Base = Vector(0, 0, -DEPTH)
    doc.recompute()
    doc.saveAs(str(tmp_path / "plate.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    (floor,) = floors_of(shape)
    (tmp_path / "floor").write_text(floor)
    return tmp_path


def a_job(folder, **changes):
    job = {
        "name": "plate",
        "model": "plate.FCStd",
        "base": [(folder / "floor").read_text()],
        "tool": {"diameter": 6},
        "cutting": {"feed": 255, "spindle_speed": 6366},
        "operation": {
            "type": "adaptive",
            "parameters": {"StartDepth": 0, "FinalDepth": -3, "StepDown": 3},
        },
        "output": {"gcode": "out/plate.ngc"},
    }
    job.update(copy.deepcopy(changes))
    if "output" not in changes:
        job["output"] = {"gcode": "out/%s.ngc" % job["name"]}
    return job


def run(folder, *jobs, **more):
    """Writes a job file and runs it; returns (report, progress lines)."""
    path = folder / "jobs.json"
    path.write_text(json.dumps({"jobs": list(jobs), **more}))
    lines = []
    return batch.run_file(str(path), lines.append), lines


@pytest.mark.parametrize("model", ["plate.FCStd", "plate.step", "plate.brep"])
def test_models_of_all_kinds_give_gcode_and_figures(folder, model):
    report, lines = run(folder, a_job(folder, model=model), report="report.json")
    (job,) = report["jobs"]
    assert job["ok"] and job["error"] is None and report["failed"] == 0
    assert "G3 " in (folder / "out" / "plate.ngc").read_text()
    assert job["output"]["gcode"] == str(folder / "out" / "plate.ngc")
    assert 55 < job["figures"]["max_engagement_deg"] < 63
    assert job["figures"]["cutting_time_s"] > job["figures"]["ideal_time_s"] > 0
    assert json.loads((folder / "report.json").read_text()) == report
    assert lines[0].startswith("[1/1] plate: reading") and "done in" in lines[-1]
    assert FreeCAD.listDocuments() == {}


def test_a_sketch_is_taken_whole_by_its_name(folder):
    report, _ = run(folder, a_job(folder, object="Plate", base=["Outline"]))
    assert report["jobs"][0]["ok"]
    assert report["jobs"][0]["figures"]["removed_volume_mm3"] == pytest.approx(
        26 * 18 * 3, rel=0.03
    )


def test_parameters_take_numbers_units_choices_and_points(folder):
    parameters = {
        "StartDepth": "0 mm",
        "FinalDepth": -3,
        "StepDown": 1.5,
        "EngagementAngle": 50,
        "FeedControl": "Constant force",
        "Material": "Al6061-T6",
        "MaximumFeed": 600,
        "LinkFeed": "2 m/min",
        "Entry": "Predrilled hole",
        "EntryPoint": [15, 15, 0],
        "HoleDiameter": 9,
        "OrderBy": "Depth",
        "NarrowPassages": "Skip and report",
        "StockToLeaveAxial": 0.1,
        "WallPass": False,
    }
    job = a_job(folder, operation={"type": "adaptive", "parameters": parameters})
    job["cutting"].update(plunge_feed=100, rapid_feed=8000)
    job["tool"].update(shape="endmill", flutes=3, cutting_length=12)
    job["stock"] = {"margin": 0}
    job["output"]["document"] = "out/job.FCStd"
    report, _ = run(folder, job)
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    doc = FreeCAD.openDocument(str(folder / "out" / "job.FCStd"))
    try:
        op = next(o for o in doc.Objects if type(getattr(o, "Proxy", 0)).__name__ == "Adaptive")
        assert op.EngagementAngle.Value == pytest.approx(50)
        assert op.FeedControl == "Constant force" and op.Material == "Al6061-T6"
        assert op.LinkFeed.Value == pytest.approx(2000 / 60)
        assert op.MaximumFeed.Value == pytest.approx(10)
        assert op.EntryPoint == Vector(15, 15, 0) and op.WallPass is False
        assert op.OrderBy == "Depth" and op.NarrowPassages == "Skip and report"
        assert op.StockToLeaveAxial.Value == pytest.approx(0.1)
        assert op.ToolController.VertFeed.Value == pytest.approx(100 / 60)
        assert op.ToolController.HorizRapid.Value == pytest.approx(8000 / 60)
        assert op.ToolController.Tool.CuttingEdgeHeight.Value == pytest.approx(12)
        assert len(op.Path.Commands) == report["jobs"][0]["figures"]["blocks"]
    finally:
        FreeCAD.closeDocument(doc.Name)


@pytest.mark.parametrize(
    "kind, own",
    [
        ("trochoid", {"Pattern": "Circular", "SlotWidth": 8}),
        (
            "lame_spiral",
            {"Segments": 4, "ExponentEnd": 0.6, "Rest": "Leave", "ExponentCourse": [0, 0.25, 1]},
        ),
    ],
)
def test_the_other_operations_take_their_own_parameters(folder, kind, own):
    job = a_job(folder)
    job["operation"]["type"] = kind
    job["operation"]["parameters"].update(own)
    job["output"]["document"] = "out/job.FCStd"
    report, _ = run(folder, job)
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    doc = FreeCAD.openDocument(str(folder / "out" / "job.FCStd"))
    try:
        (op,) = [o for o in doc.Objects if all(hasattr(o, name) for name in own)]
        for name, value in own.items():
            found = getattr(op, name)
            assert getattr(found, "Value", found) == value
    finally:
        FreeCAD.closeDocument(doc.Name)


def test_the_picture_is_a_png(folder):
    job = a_job(folder)
    job["output"]["picture"] = "out/plate.png"
    report, _ = run(folder, job)
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    assert (folder / "out" / "plate.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


@pytest.fixture
def simulator(monkeypatch):
    """In place of the simulator: a Simulation with faults, and what it was asked for."""
    asked = []

    def simulate(source, stock, top, bottom, tool_diameter, **options):
        asked.append(options)
        if options["resolution"] == 7:
            raise ValueError("The resolution is 7 mm: make it smaller.")
        (op,) = [o for o in FreeCAD.ActiveDocument.Objects if hasattr(o, "EngagementAngle")]
        result = faulty(op)
        assert len(source) > 100 and tool_diameter == 6 and (top, bottom) == (0, -12)
        return result

    monkeypatch.setattr(simulator_run, "simulate", simulate)
    return asked


def test_a_simulation_adds_its_figures_and_its_picture(folder, simulator):
    (folder / "mill.json").write_text("{}")
    wishes = {"resolution": 0.1, "step": 0.2, "material": "steel", "machine": "mill.json"}
    job = a_job(folder, simulation={**wishes, "picture": "out/simulation.svg"})
    result, lines = run(folder, job, a_job(folder, name="without"), report="report.json")
    first, second = result["jobs"]
    assert first["ok"], first["error"]
    (options,) = simulator
    assert (options["resolution"], options["step"]) == (0.1, 0.2)
    assert options["cutting"]["material"] == "steel"
    assert options["machine"] == str(folder / "mill.json")
    figures = first["figures"]
    assert figures["simulated_gouge_mm"] == 0.05 and figures["simulated_rest_area_mm2"] == 1.45
    assert figures["simulated_machine_time_s"] == 150
    assert 55 < figures["simulated_engagement_deg"] < 63 and figures["simulated_force_n"] > 0
    assert (
        "Simulated: rapid in material near (9.000, 9.000, -1.000), (11.000" in figures["simulation"]
    )
    assert first["output"]["simulation_picture"] == str(folder / "out" / "simulation.svg")
    text = (folder / "out" / "simulation.svg").read_text()
    assert "target 60" in text and "nominal 1.147" in text and "plunge in material (1)" in text
    assert "[1/2] plate: simulating" in lines and "[2/2] without: simulating" not in lines
    assert not any(key.startswith("simulat") for key in second["figures"])
    assert json.loads((folder / "report.json").read_text()) == result
    table = report.table(result["jobs"]).splitlines()
    row = next(line for line in table if line.startswith("  gouge"))
    assert row.split() == ["gouge", "mm", "0.050", "-"]
    assert any(
        line.startswith("plate: Simulated: plunge in material near (20.000") for line in table
    )


def test_an_empty_simulation_section_simulates_with_the_defaults(folder, simulator):
    report, _ = run(folder, a_job(folder, simulation={}))
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    (options,) = simulator
    assert (options["resolution"], options["step"], options["machine"]) == (None, 0.1, None)
    assert "material" not in options["cutting"]
    assert set(report["jobs"][0]["output"]) == {"gcode"}


def test_materials_and_machines_are_names_objects_or_files_beside_the_job_file(folder, simulator):
    (folder / "alloy.json").write_text("{}")
    for material, expected in (
        ("alloy.json", str(folder / "alloy.json")),
        ("Al6082-T6", "Al6082-T6"),
        ({"ktc": 600, "krc": 200}, {"ktc": 600, "krc": 200}),
    ):
        report, _ = run(folder, a_job(folder, simulation={"material": material}))
        assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
        assert simulator[-1]["cutting"]["material"] == expected


def test_a_simulation_that_fails_fails_its_job_before_anything_is_written(folder, simulator):
    report, _ = run(folder, a_job(folder, simulation={"resolution": 7, "picture": "out/s.png"}))
    assert report["jobs"][0]["error"] == "The resolution is 7 mm: make it smaller."
    assert os.listdir(folder / "out") == []


def test_one_failure_leaves_the_other_jobs_done(folder):
    bad = a_job(folder, name="bad", tool={"diameter": 40})
    report, lines = run(folder, a_job(folder), bad, a_job(folder, name="last"))
    assert [job["ok"] for job in report["jobs"]] == [True, False, True]
    assert report["failed"] == 1
    assert "largest" in report["jobs"][1]["error"]
    assert any(line.startswith("[2/3] bad: FAILED: ") for line in lines)


def changed(job, path, value):
    *sections, key = path.split("/")
    place = job
    for section in sections:
        place = place.setdefault(section, {})
    if value is None:
        place.pop(key)
    else:
        place[key] = value
    return job


def breaking(post):
    """A post-processor that breaks, in place of one of that name."""

    def broken(job, processor, arguments):
        if processor == "broken":
            raise RuntimeError({"sErrMsg": "in the post\n", "sclassname": "Base::Exception"})
        return post(job, processor, arguments)

    return broken


@pytest.mark.parametrize(
    "path, value, words",
    [
        ("modle", "x", ["unknown key 'modle'", "model", "operation"]),
        ("tool/diamter", 6, ["tool: unknown key 'diamter'", "diameter, shape"]),
        ("cutting/speed", 6, ["cutting: unknown key 'speed'", "spindle_speed"]),
        ("output/file", "x", ["output: unknown key 'file'", "gcode"]),
        ("operation/parameters/Angle", 60, ["unknown key 'Angle'", "EngagementAngle"]),
        ("operation/type", "spiral", ["no operation 'spiral'", "adaptive"]),
        ("operation/parameters/CutMode", "Up", ["CutMode cannot be 'Up'", "Climb, Conventional"]),
        ("operation/parameters/Material", "Gold", ["Material cannot be 'Gold'", "Al6061-T6"]),
        ("operation/parameters/LinkFeed", "fast", ["LinkFeed cannot be 'fast'"]),
        ("operation/parameters/EntryPoint", ["a", 0], ["EntryPoint cannot be ['a', 0]"]),
        ("operation/parameters/EngagementAngle", 200, ["Engagement angle is 200", "180"]),
        ("tool/diameter", None, ["tool: the key 'diameter' is missing"]),
        ("tool/diameter", "six", ["tool: 'diameter' must be a number"]),
        ("tool/diameter", 0, ["tool: 'diameter' is 0: it must be more than 0"]),
        ("tool/diameter", -6, ["tool: 'diameter' is -6: it must be more than 0"]),
        ("tool/flutes", 0, ["tool: 'flutes' is 0: it must be more than 0"]),
        ("cutting/plunge_feed", -1, ["cutting: 'plunge_feed' is -1: it must be more than 0"]),
        ("stock/margin", -1, ["stock: 'margin' is -1: it must be 0 or more"]),
        ("stock/margin", 1e999, ["jobs.json is no JSON: Infinity is no number"]),
        ("simulation/step", 0, ["simulation: 'step' is 0: it must be more than 0"]),
        ("operation/parameters/StockToLeave", -1, ["StockToLeave cannot be -1", "take 0 for it"]),
        ("operation/parameters/StockToLeave", "-1 mm", ["cannot be '-1 mm'", "take 0 for it"]),
        ("operation/parameters/StepDown", "half of it", ["StepDown cannot be 'half of it'"]),
        ("operation/parameters/StepDown", True, ["StepDown cannot be True: it is no yes or no"]),
        ("operation/parameters/WallPass", 1, ["WallPass cannot be 1: it must be true or false"]),
        ("operation/parameters/CutMode", 1, ["CutMode cannot be 1", "Climb, Conventional"]),
        (
            "output/picture",
            "out/../out/plate.ngc",
            ["the picture would overwrite the gcode of job 1"],
        ),
        ("output/document", "plate.FCStd", ["the document would overwrite its model, plate.FCStd"]),
        ("output/gcode", "jobs.json", ["the gcode would overwrite the job file, jobs.json"]),
        ("tool/shape", "ballend", ["a ball end mill", "flat or bull-nosed"]),
        ("tool/corner_radius", 1, ["tool: the tool has no rounded corner", "bullnose"]),
        (
            "tool",
            {**BULLNOSE, "corner_radius": 4},
            ["tool: a corner radius of 4 mm does not fit", "at most the 3 mm"],
        ),
        ("cutting/feed", True, ["cutting: 'feed' must be a number"]),
        ("base", "Face1", ["'base' must be a list"]),
        ("base", [], ["no base geometry"]),
        ("base", ["Face99"], ["there is no 'Face99'", "Plate"]),
        ("base", ["Nothing.Face1"], ["there is no 'Nothing.Face1'"]),
        ("base", [7], ["7 is no name"]),
        ("object", "Body", ["no object 'Body'", "Plate"]),
        ("model", "none.step", ["no model file", "mend the key 'model'"]),
        ("model", "broken.step", ["broken.step cannot be read", "save it anew as FCStd"]),
        ("model", "broken.FCStd", ["broken.FCStd cannot be read", "save it anew as FCStd"]),
        ("simulation/raster", 1, ["simulation: unknown key 'raster'", "resolution, step"]),
        ("simulation/step", "1", ["simulation: 'step' must be a number"]),
        ("simulation/material", 7, ["simulation: 'material' must be a name or an object"]),
        ("post/processor", "nonsense", ["no post-processor 'nonsense'"]),
        ("post/arguments", "--nonsense", ["refuses the arguments '--nonsense'"]),
        ("post/processor", "broken", ["'broken' failed (RuntimeError: in the post): choose"]),
    ],
)
def test_what_is_wrong_in_a_job_is_named(folder, monkeypatch, path, value, words):
    monkeypatch.setattr(posts, "post_processors", lambda: ["linuxcnc", "broken"])
    for name in ("_post_old", "_post_modern"):
        monkeypatch.setattr(posts, name, breaking(getattr(posts, name)))
    (folder / "broken.step").write_text("no model")
    (folder / "broken.FCStd").write_text("no document")
    try:
        report, _ = run(folder, changed(a_job(folder), path, value))
        (job,) = report["jobs"]
        assert not job["ok"] and report["failed"] == 1
        error = job["error"]
    except ValueError as refused:  # the file cannot be used at all
        error = str(refused)
    for word in words:
        assert word in error, error
    assert "{" not in error
    assert not (folder / "out" / "plate.ngc").exists()
    assert FreeCAD.listDocuments() == {}


@pytest.mark.parametrize(
    "text, words",
    [
        ("{", ["is no JSON"]),
        ("[]", ["must be an object with the keys jobs, report"]),
        ('{"job": []}', ["unknown key 'job'", "jobs, report"]),
        ("{}", ["the key 'jobs' is missing"]),
        ('{"jobs": [{"tool": {}, "tool": {}}]}', ["has the key 'tool' twice in one object"]),
        ('{"jobs": [{"tool": {"diameter": NaN}}]}', ["is no JSON: NaN is no number"]),
        ('{"jobs": {}}', ["'jobs' must be a list"]),
    ],
)
def test_a_job_file_that_cannot_be_used_is_refused(tmp_path, text, words):
    path = tmp_path / "jobs.json"
    path.write_text(text)
    with pytest.raises(ValueError) as caught:
        batch.run_file(str(path), lambda line: None)
    for word in words:
        assert word in str(caught.value)


def test_a_bull_nose_has_the_corner_that_its_job_names(folder):
    job = a_job(folder, tool={**BULLNOSE, "corner_radius": 0.5})
    job["output"]["document"] = "out/job.FCStd"
    report, _ = run(folder, job)
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    doc = FreeCAD.openDocument(str(folder / "out" / "job.FCStd"))
    try:
        (controller,) = (o for o in doc.Objects if hasattr(o, "HorizFeed"))
        assert tool.corner_radius(controller) == pytest.approx(0.5)
    finally:
        FreeCAD.closeDocument(doc.Name)


def test_what_two_jobs_would_write_goes_to_the_first(folder):
    """Also where the two names are spelt otherwise."""
    second = a_job(folder, name="second", output={"gcode": "./out/first.ngc"})
    report, _ = run(folder, a_job(folder, name="first"), second, a_job(folder, name="third"))
    assert [job["ok"] for job in report["jobs"]] == [True, False, True]
    assert report["jobs"][1]["error"] == (
        "Job 2, output: the gcode would overwrite the gcode of job 1, ./out/first.ngc: name "
        "another file."
    )


def test_a_mark_at_the_beginning_is_read_over(folder):
    path = folder / "jobs.json"
    path.write_text(json.dumps({"jobs": [a_job(folder)]}), encoding="utf-8-sig")
    assert batch.run_file(str(path), lambda line: None)["failed"] == 0


def test_a_job_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ValueError, match="cannot be read"):
        batch.run_file(str(tmp_path / "none.json"), lambda line: None)


def test_a_job_file_that_cannot_be_read_is_refused(tmp_path, monkeypatch):
    with pytest.raises(ValueError, match="cannot be read: Is a directory"):
        batch.run_file(str(tmp_path), lambda line: None)
    path = tmp_path / "jobs.json"
    path.write_bytes(b"\xff\xfe{}")
    with pytest.raises(ValueError, match="jobs.json is no JSON: 'utf-8' codec can't decode"):
        batch.run_file(str(path), lambda line: None)
    path.write_text("[" * 100000)
    with pytest.raises(ValueError, match="jobs.json is no JSON: "):
        batch.run_file(str(path), lambda line: None)
    forbid(monkeypatch, "jobs.json")
    with pytest.raises(ValueError, match="jobs.json cannot be read: Permission denied"):
        batch.run_file(str(path), lambda line: None)


# ---- outputs that cannot be written ----


def forbid(monkeypatch, ending):
    """Makes opening files whose path ends so fail as without permission, which root never lacks."""

    def refuse(path, *arguments, **options):
        if str(path).endswith(ending):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), path)
        return open(path, *arguments, **options)

    for module in (outputs, read):
        monkeypatch.setattr(module, "open", refuse, raising=False)


# Names of files that cannot be written, and what the system says of them. The first two are found
# before the work, the third when there is something to write.
UNWRITABLE = [
    ("folder.d", "Is a directory"),
    ("file/below.d/x", "Not a directory"),
    ("/dev/full", "No space left on device"),
]


@pytest.fixture
def obstacles(folder):
    """The job folder with what UNWRITABLE needs in it."""
    (folder / "folder.d").mkdir()
    (folder / "file").write_text("kept")
    return folder


def test_a_simulations_picture_that_cannot_be_written_is_named_before_the_work(obstacles):
    job = a_job(obstacles, simulation={"picture": "folder.d"})
    report, lines = run(obstacles, job)
    assert report["jobs"][0]["error"].startswith(
        "Job 1, simulation: the picture cannot be written to %s" % (obstacles / "folder.d")
    )
    assert not any("computing" in line for line in lines)


@pytest.mark.parametrize("key", ["gcode", "picture"])
@pytest.mark.parametrize("name, reason", UNWRITABLE)
def test_an_output_that_cannot_be_written_fails_its_job_only(obstacles, key, name, reason):
    bad = changed(a_job(obstacles, name="bad"), "output/" + key, name)
    report, lines = run(obstacles, bad, a_job(obstacles, name="good"), report="report.json")
    assert [job["ok"] for job in report["jobs"]] == [False, True]
    assert report["jobs"][0]["error"] == (
        "Job 1, output: the %s cannot be written to %s (%s): name another file."
        % (key, os.path.join(obstacles, name), reason)
    )
    assert json.loads((obstacles / "report.json").read_text()) == report
    assert (obstacles / "out" / "good.ngc").exists()
    assert (obstacles / "file").read_text() == "kept"
    computed = any(line == "[1/2] bad: computing" for line in lines)
    assert computed == (reason == "No space left on device")


@pytest.mark.parametrize(
    "name, words",
    [
        ("folder.FCStd", "/folder.FCStd (Is a directory): name another file."),
        ("file/below/x.FCStd", "/file/below/x.FCStd (Not a directory): name another file."),
        ("job", "output: the document is 'job': its name must end in .FCStd."),
    ],
)
def test_a_document_that_cannot_be_written_fails_its_job(obstacles, name, words):
    (obstacles / "folder.FCStd").mkdir()
    report, lines = run(obstacles, changed(a_job(obstacles), "output/document", name))
    assert report["jobs"][0]["error"].endswith(words)
    assert not any("computing" in line for line in lines)
    assert not (obstacles / "out" / "plate.ngc").exists()


def test_outputs_without_permission_are_named(folder, monkeypatch):
    forbid(monkeypatch, "plate.ngc")
    report, _ = run(folder, a_job(folder))
    assert "plate.ngc (Permission denied): name another file." in report["jobs"][0]["error"]
    monkeypatch.undo()
    forbid(monkeypatch, "report.json")
    report, _ = run(folder, a_job(folder), report="report.json")
    assert report["failed"] == 0 and "report.json (Permission denied)" in report["error"]


def test_trying_whether_an_output_can_be_written_changes_no_file(folder):
    (folder / "out").mkdir()
    (folder / "out" / "plate.ngc").write_text("of an earlier run")
    report, _ = run(folder, a_job(folder, tool={"diameter": 40}))
    assert report["failed"] == 1
    assert (folder / "out" / "plate.ngc").read_text() == "of an earlier run"


@pytest.mark.parametrize("name, reason", UNWRITABLE)
def test_a_report_that_cannot_be_written_leaves_the_jobs_done(obstacles, name, reason):
    report, _ = run(obstacles, a_job(obstacles), report=name)
    assert report["jobs"][0]["ok"] and report["failed"] == 0
    assert (obstacles / "out" / "plate.ngc").exists()
    assert report["error"] == (
        "The report cannot be written to %s (%s): name another file."
        % (os.path.join(obstacles, name), reason)
    )


def test_outputs_are_written_under_their_very_names_in_folders_made_for_them(folder):
    job = changed(a_job(folder), "output/picture", "out/drawing")
    report, _ = run(folder, job, report="a/new/folder/report")
    assert report["jobs"][0]["ok"], report["jobs"][0]["error"]
    assert (folder / "out" / "drawing").read_bytes()[:4] == b"\x89PNG"
    assert sorted(os.listdir(folder / "out")) == ["drawing", "plate.ngc"]
    assert os.listdir(folder / "a" / "new" / "folder") == ["report"]


# ---- as a program ----


def program(folder, *arguments, **environment):
    """Runs batch.py with freecadcmd; returns (exit code, output)."""
    return freecad(os.path.abspath(batch.__file__), *arguments, cwd=folder, **environment)


def test_the_program_takes_the_job_file_from_the_environment(folder):
    (folder / "jobs.json").write_text(json.dumps({"jobs": [a_job(folder)]}))
    code, output = program(folder, EVENLOAD_JOB=str(folder / "jobs.json"))
    assert code == 0, output
    assert "[1/1] plate: wrote" in output and "engagement, largest" in output
    assert (folder / "out" / "plate.ngc").exists()


def test_the_program_takes_the_job_file_as_an_argument_and_fails_when_a_job_does(folder):
    jobs = [a_job(folder, base=["Face99"]), a_job(folder, name="good")]
    (folder / "jobs.json").write_text(json.dumps({"jobs": jobs}))
    code, output = program(folder, "jobs.json")
    assert code == 1, output
    assert "[1/2] plate: FAILED" in output and "[2/2] good: done" in output
    assert "Traceback" not in output


def test_the_program_fails_when_a_file_cannot_be_written(obstacles):
    jobs = [changed(a_job(obstacles), "output/gcode", "folder.d"), a_job(obstacles, name="good")]
    content = {"jobs": jobs, "report": "folder.d"}
    (obstacles / "jobs.json").write_text(json.dumps(content))
    code, output = program(obstacles, "jobs.json")
    assert code == 1 and "Traceback" not in output, output
    assert "[1/2] plate: FAILED: Job 1, output: the gcode cannot be written" in output
    assert "[2/2] good: done" in output and "engagement, largest" in output
    assert output.splitlines()[-1].startswith("The report cannot be written to ")
    (obstacles / "jobs.json").write_text(json.dumps({**content, "jobs": jobs[1:]}))
    code, output = program(obstacles, "jobs.json")
    assert code == 1 and "[1/1] good: done" in output, output


def test_the_program_without_a_usable_job_file_says_so(folder):
    code, output = program(folder)
    assert code == 2 and "EVENLOAD_JOB" in output
    code, output = program(folder, EVENLOAD_JOB="none.json")
    assert code == 2 and "none.json cannot be read" in output and "Traceback" not in output
    code, output = program(folder, str(folder))
    assert code == 2 and "cannot be read: Is a directory" in output and "Traceback" not in output


@pytest.mark.parametrize(
    "modules, words",
    [
        ([], "EvenLoad's compiled modules are missing, for Python "),
        (
            ["_core.cpython-39-x86_64-linux-gnu.so", "_occt_7_1_0.cpython-39-x86_64-linux-gnu.so"],
            "EvenLoad's compiled modules are for Python 3.9 and OpenCASCADE 7.1.0: ",
        ),
    ],
)
def test_a_tree_without_modules_for_this_freecad_gives_one_sentence(folder, modules, words):
    source = os.path.dirname(os.path.abspath(batch.__file__))
    bare = folder / "bare" / "Mod" / "evenload"
    shutil.copytree(source, bare, ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    resources = os.path.join(source, "..", "..", "Resources")
    shutil.copytree(resources, folder / "bare" / "Resources")
    for name in modules:
        (bare / name).write_bytes(b"of another FreeCAD")
    (folder / "jobs.json").write_text(json.dumps({"jobs": [a_job(folder)]}))
    home = folder / "home"
    home.mkdir()  # or FreeCAD takes the user's own, with the addon in it if that is installed
    code, output = freecad(
        str(bare / "batch.py"), "jobs.json", cwd=folder, FREECAD_USER_HOME=str(home)
    )
    assert code == 2, output
    assert words in output
    assert "build EvenLoad for it with './run install'" in output
    assert "Traceback" not in output


def test_importing_the_package_imports_nothing_heavy():
    code = "import evenload, sys; print(sorted(m for m in sys.modules if 'evenload' in m))"
    path = os.path.dirname(os.path.dirname(os.path.abspath(batch.__file__)))
    python = shutil.which("python3", path="/usr/bin") or sys.executable
    result = subprocess.run(
        [python, "-c", code], env=dict(os.environ, PYTHONPATH=path), capture_output=True, text=True
    )
    assert result.stdout.strip() == "['evenload']", result.stderr
