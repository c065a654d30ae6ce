"""docs/stability_chart.md and docs/batch.md: what they tell of modes and reports is so."""

import json
import re
from pathlib import Path

from evenload.dynamics import vibration

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "stability_chart.md").read_text()


def test_the_file_of_modes_on_the_page_can_be_read():
    (text,) = re.findall(r"^```json\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    found = vibration.load(json.loads(text), str(ROOT / "examples"))
    assert found.name == "6 mm end mill, 30 mm out"
    assert len(found.modes) == 4 and len(found.fits) == 1


def test_every_key_of_modes_and_tap_tests_is_on_the_page():
    named = set(re.findall(r"[`\"](\w+)[`\"]", PAGE))
    assert {*vibration.MODE_KEYS, *vibration.TAP_KEYS, "name", "modes", "tap_tests"} <= named


def test_the_example_tap_tests_are_fitted_with_the_modes_that_they_were_made_of():
    rows = [{"file": "tap_%s.csv" % axis, "axis": axis + axis, "modes": 2} for axis in "xy"]
    found = vibration.load({"tap_tests": rows}, str(ROOT / "examples"))
    made = ((812, 0.021, 3.1), (1730, 0.018, 14.0), (871, 0.024, 3.6), (1810, 0.017, 16.0))
    for mode, (frequency, damping, stiffness) in zip(found.modes, made):
        assert abs(mode.frequency / frequency - 1) < 0.001
        assert abs(mode.damping_ratio / damping - 1) < 0.05
        assert abs(mode.stiffness / stiffness - 1) < 0.05  # the noise is 8 % of its peak
    assert found.notes == []
