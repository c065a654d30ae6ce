"""The macros of docs/macros.md, run as they stand there; templates of jobs."""

import json
import re
from importlib import import_module
from pathlib import Path

import FreeCAD
import pytest
from conftest import freecad
from models import SQUARE, block_with, face_of

from evenload import host

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "macros.md").read_text()
# By the headings of the page's examples: (code, what it is said to print, "" where nothing is).
EXAMPLES = {
    title: (code, printed)
    for title, code, printed in re.findall(
        r"^## (\d\. [^\n]*)\n(?:(?!^## ).)*?^```python\n(.*?)^```"
        r"(?:\n\nIt (?:prints|ends with)\n\n```\n(.*?)^```)?",
        PAGE,
        re.MULTILINE | re.DOTALL,
    )
}


def test_there_are_five_examples():
    assert [title[0] for title in EXAMPLES] == ["1", "2", "3", "4", "5"]
    assert PAGE.count("```python") == 5


@pytest.mark.parametrize("title", list(EXAMPLES))
def test_an_example_runs_as_written(title, tmp_path, rs274):
    code, printed = EXAMPLES[title]
    (tmp_path / "macro.py").write_text(code)
    _, output = freecad("macro.py", cwd=tmp_path)
    for fault in ("Traceback", "Exception while processing", "failed: "):
        assert fault not in output, output[-2000:]
    lines = [line.strip() for line in output.splitlines()]
    for line in printed.splitlines():
        assert line in lines, output[-2000:]
    (program,) = tmp_path.glob("*.ngc")
    assert rs274(program.read_text(), tmp_path).count("FEED") > 100
    for picture in re.findall(r'told\("(\w+)"\)', code):
        assert (tmp_path / (picture + ".png")).stat().st_size > 10000
    if "report.md" in code:
        assert (tmp_path / "report.md").read_text().count("|\n") == 4
    if "floors" in title:
        assert [z for z in (16, 14, 11) if "cut down to %d mm." % z not in output] == []


# ---- templates ----

# Defaults of each type that is kept, by the kind of operation.
DEFAULTS = {
    "adaptive": {
        "EngagementAngle": 47.0,
        "StockToLeave": 0.25,
        "CutMode": "Conventional",
        "WallPass": False,
    },
    "trochoid": {"EngagementAngle": 33.0, "Pattern": "Cycloid", "Arcs": False},
    "lame_spiral": {"HelixAngle": 2.5, "Rest": "Leave", "WallPass": False},
    "finishing": {"Tolerance": 0.02, "PassAngle": 30.0},
}


def value_of(op, name):
    value = getattr(op, name)
    return getattr(value, "Value", value)


def exported(job, file):
    """Writes a job's template, by the calls of FreeCAD's command."""
    sheet = job.Proxy.setupSheet
    attributes = job.Proxy.templateAttrs(job)
    attributes["ToolController"] = [tc.Proxy.templateAttrs(tc) for tc in job.Tools.Group]
    kept = sheet.templateAttributes(True, True, True, True, sheet.operationsWithSettings())
    attributes["SetupSheet"] = kept
    file.write_text(json.dumps(sheet.encodeTemplateAttributes(attributes)))


def test_a_jobs_template_keeps_the_defaults_of_each_of_our_operations(square, tmp_path):
    sheet, registered = square.job.SetupSheet, host.cam().setup_sheet._RegisteredOps
    for kind, values in DEFAULTS.items():
        name = import_module("evenload.operations." + kind).NAME
        prototype = registered[name].prototype(name)
        for prop, value in values.items():
            # As the page Op Defaults does when a row is ticked and set.
            prototype.getProperty(prop).setupProperty(
                sheet, host.cam().setup_sheet.OpPropertyName(name, prop), name, value
            )
    exported(square.job, tmp_path / "job_ours.json")

    doc = FreeCAD.newDocument("Fresh")
    try:
        part = doc.addObject("Part::Feature", "Part")
        part.Shape = block_with(face_of(SQUARE))
        doc.recompute()
        job = host.cam().job.Create("Job", [part], str(tmp_path / "job_ours.json"))
        for kind, values in DEFAULTS.items():
            op = import_module("evenload.operations." + kind).Create(
                "Operation", parentJob=job, toolController=job.Tools.Group[0]
            )
            for prop, value in values.items():
                assert value_of(op, prop) == pytest.approx(value), (kind, prop)
    finally:
        FreeCAD.closeDocument(doc.Name)
