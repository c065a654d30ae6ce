"""The macro in docs/adaptive_operation.md, run as it stands there; the tables of properties."""

import re
from pathlib import Path

import pytest
from conftest import freecad
from evenload.operations.adaptive import Adaptive

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "adaptive_operation.md"


def test_the_macro_of_the_documentation_runs_as_written(tmp_path, rs274):
    (macro,) = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    (tmp_path / "pocket.py").write_text(macro)
    _, output = freecad("pocket.py", cwd=tmp_path)
    text = tmp_path / "pocket.ngc"
    assert text.exists() and "Traceback" not in output, output[-2000:]
    assert "failed: " not in output
    assert rs274(text.read_text(), tmp_path).count("FEED") > 100


@pytest.mark.parametrize("page", [ROOT / "README.md", PAGE], ids=lambda page: page.name)
def test_the_table_of_properties_has_every_setting_once(page):
    (table,) = re.findall(
        r"^\| property \|.*\n\|[-|]+\n((?:\|.*\n)+)", page.read_text(), re.MULTILINE
    )
    names = [name for row in table.splitlines() for name in row.split("|")[1].split(",")]
    assert sorted(map(str.strip, names)) == sorted(setting.name for setting in Adaptive.settings)
