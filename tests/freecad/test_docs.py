"""The macro in docs/adaptive_operation.md, run as it stands there."""

import os
import re
import shutil
import subprocess
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "adaptive_operation.md"


def test_the_macro_of_the_documentation_runs_as_written(tmp_path, rs274):
    (macro,) = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    (tmp_path / "pocket.py").write_text(macro)
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    result = subprocess.run(
        [program, "pocket.py"],
        cwd=tmp_path,
        env={k: v for k, v in os.environ.items() if k != "PYTEST_ADDOPTS"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        timeout=120,
    )
    text = tmp_path / "pocket.ngc"
    assert text.exists() and "Traceback" not in result.stdout, result.stdout[-2000:]
    assert "failed: " not in result.stdout
    assert rs274(text.read_text(), tmp_path).count("FEED") > 100
