"""docs/simulation.md: its example runs as written, and its tables name all that there is."""

import dataclasses
import inspect
import re
from pathlib import Path

from evenload import simulation

PAGE = Path(__file__).resolve().parents[2] / "docs" / "simulation.md"
# What a Simulation was given, and whether it was cancelled.
GIVEN = {"stock_regions", "part", "tool_diameter", "top", "bottom", "cancelled"}


def test_the_example_prints_what_the_page_says(tmp_path, monkeypatch, capsys):
    example, printed = re.search(
        r"^```python\n(.*?)^```\n.*?^```\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL
    ).groups()
    monkeypatch.chdir(tmp_path)
    exec(example, {})
    assert capsys.readouterr().out == printed


def test_every_array_and_figure_is_on_the_page():
    _, outputs = PAGE.read_text().split("## What comes out")
    named = set(re.findall(r"`(\w+)", outputs))
    for field in dataclasses.fields(simulation.Simulation):
        name, of_place = field.name, re.match(r"(.*)_at$", field.name)
        if of_place:  # stands for the place of the figure beside it
            assert any(figure.startswith(of_place[1]) for figure in named), name
        else:
            assert name in named | GIVEN, name


def test_every_argument_has_its_default_on_the_page():
    inputs, _ = PAGE.read_text().split("## What comes out")
    rows = re.findall(r"^\| (`.*?) \| (.*?) \|", inputs, re.MULTILINE)
    told = {name: default for names, default in rows for name in re.findall(r"`(\w+)`", names)}
    for name, parameter in inspect.signature(simulation.simulate).parameters.items():
        needed = parameter.default is inspect.Parameter.empty
        assert told[name] == ("needed" if needed else str(parameter.default)), name
