"""The macros in the pages of the operations, run as they stand there, and the names that they use;
the table of properties at a glance; what the page of controllers posts.
"""

import importlib
import re
import shutil
from pathlib import Path

import evenload
import pytest
from conftest import freecad
from evenload import compiled, host
from evenload.operations.adaptive import Adaptive

ROOT = Path(__file__).resolve().parents[2]
KINDS = ("adaptive", "trochoid", "lame_spiral", "finishing")


@pytest.mark.parametrize("kind", KINDS)
def test_the_macro_of_the_documentation_runs_as_written(kind, tmp_path, rs274):
    page = (ROOT / "docs" / (kind + "_operation.md")).read_text()
    (macro,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "macro.py").write_text(macro)
    _, output = freecad("macro.py", cwd=tmp_path)
    (text,) = tmp_path.glob("*.ngc")
    assert text.exists() and "Traceback" not in output, output[-2000:]
    assert "failed: " not in output
    assert rs274(text.read_text(), tmp_path).count("FEED") > 100


def test_the_example_from_measurement_to_gcode_prints_what_the_page_says(tmp_path, rs274):
    page = (ROOT / "docs" / "stability_chart.md").read_text()
    macro, printed = re.search(
        r"^```python\n(.*?)^```\n.*?^```\n(.*?)^```", page, re.MULTILINE | re.DOTALL
    ).groups()
    for name in ("tap_x.csv", "tap_y.csv"):
        shutil.copy(ROOT / "examples" / name, tmp_path)
    (tmp_path / "macro.py").write_text(macro)
    _, output = freecad("macro.py", cwd=tmp_path)
    assert "Traceback" not in output, output[-2000:]
    for line in printed.splitlines():
        assert line in output
    assert "S12333" in (tmp_path / "pocket.ngc").read_text()
    assert rs274((tmp_path / "pocket.ngc").read_text(), tmp_path).count("FEED") > 100
    for name in ("fit_x.png", "chart.png"):
        assert (tmp_path / name).stat().st_size > 10000


def test_the_macro_of_what_is_left_on_the_faces_runs_as_written(tmp_path):
    page = (ROOT / "docs" / "surface_simulation.md").read_text()
    (macro,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "macro.py").write_text(macro)
    _, output = freecad("macro.py", cwd=tmp_path)
    assert "Traceback" not in output, output[-2000:]
    assert "gouge 0." in output and "% within 10 % of the wish" in output
    assert (tmp_path / "cusps.png").stat().st_size > 10000


@pytest.mark.parametrize(
    "name, module",
    [
        ("proof", "simulation.proof"),
        ("job_simulation", "simulation.job"),
        ("simulation_pictures", "pictures.simulation_pictures"),
        ("job_stability", "stability.job"),
    ],
)
def test_a_name_for_macros_is_the_module_in_its_room(name, module):
    found = importlib.import_module("evenload." + name)
    assert found is importlib.import_module("evenload." + module)
    assert getattr(evenload, name) is found


def tabled(page):
    (table,) = re.findall(
        r"^\| property \|.*\n\|[-|]+\n((?:\|.*\n)+)", page.read_text(), re.MULTILINE
    )
    rows = table.splitlines()
    return sorted(name.strip() for row in rows for name in row.split("|")[1].split(","))


def test_the_table_of_properties_at_a_glance_has_every_setting_once():
    assert tabled(ROOT / "docs" / "properties.md") == sorted(
        setting.name for setting in Adaptive.settings
    )


CONTROLLERS = (ROOT / "docs" / "controllers.md").read_text()


def read(text):
    """The moves of a program, which our reader must take without a note."""
    program = compiled.core().read_gcode(text)
    assert len(program.moves) > 100 and program.notes == []
    return program.moves


@pytest.mark.parametrize(
    "processor, arguments",
    re.findall(r"^\| .+? \| `(\w+)` \| `(.*?)` \|", CONTROLLERS, re.MULTILINE),
)
def test_the_post_processors_for_controllers_write_what_can_be_read(square, processor, arguments):
    square.done(square.operation())
    read(host.post(square.job, processor, arguments))


def test_the_program_for_haas_has_its_signs_around_it(square, tmp_path, monkeypatch):
    square.done(square.operation())
    (macro,) = re.findall(r"^```python\n(.*?)^```", CONTROLLERS, re.MULTILINE | re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(macro, {"job": square.job, "host": host})
    text = (tmp_path / "pocket.nc").read_text()
    assert text.startswith("%\nO1000\n") and text.rstrip().endswith("M30\n%")
    read(text)
