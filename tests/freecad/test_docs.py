"""The macros in the pages of the operations, run as they stand there; the tables of properties."""

import re
from pathlib import Path

import pytest
from conftest import freecad
from evenload.operations.adaptive import Adaptive
from evenload.operations.lame_spiral import LameSpiral
from evenload.operations.trochoid import Trochoid

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "adaptive_operation.md"
KINDS = {"adaptive": Adaptive, "trochoid": Trochoid, "lame_spiral": LameSpiral}


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


def tabled(page):
    (table,) = re.findall(
        r"^\| property \|.*\n\|[-|]+\n((?:\|.*\n)+)", page.read_text(), re.MULTILINE
    )
    rows = table.splitlines()
    return sorted(name.strip() for row in rows for name in row.split("|")[1].split(","))


@pytest.mark.parametrize("page", [ROOT / "README.md", PAGE], ids=lambda page: page.name)
def test_the_table_of_properties_has_every_setting_once(page):
    assert tabled(page) == sorted(setting.name for setting in Adaptive.settings)


@pytest.mark.parametrize("kind", ["trochoid", "lame_spiral"])
def test_the_page_of_an_operation_has_its_own_settings_once(kind):
    own = {s.name for s in KINDS[kind].settings} - {s.name for s in Adaptive.settings}
    assert tabled(ROOT / "docs" / (kind + "_operation.md")) == sorted(own)
