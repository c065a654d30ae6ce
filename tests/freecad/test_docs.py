"""The macro in docs/adaptive_operation.md, run as it stands there."""

import re
from pathlib import Path

from conftest import freecad

PAGE = Path(__file__).resolve().parents[2] / "docs" / "adaptive_operation.md"


def test_the_macro_of_the_documentation_runs_as_written(tmp_path, rs274):
    (macro,) = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    (tmp_path / "pocket.py").write_text(macro)
    _, output = freecad("pocket.py", cwd=tmp_path)
    text = tmp_path / "pocket.ngc"
    assert text.exists() and "Traceback" not in output, output[-2000:]
    assert "failed: " not in output
    assert rs274(text.read_text(), tmp_path).count("FEED") > 100
