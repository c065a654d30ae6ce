"""The macros in the pages of the operations, run as they stand there, and the names that they use;
the README's table of properties.
"""

import importlib
import re
import shutil
from pathlib import Path

import evenload
import pytest
from conftest import freecad
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


def test_the_readmes_table_of_properties_has_every_setting_once():
    assert tabled(ROOT / "README.md") == sorted(setting.name for setting in Adaptive.settings)
