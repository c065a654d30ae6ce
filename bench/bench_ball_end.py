# Chips of ball-end tools: errors against closed forms and the values of an independent computation
# (tests/ball_end_chips.csv), the source's regressions, and what chips cost on one core.
import sys
import time
from pathlib import Path

import numpy
from evenload import ball_end
from evenload.ball_end import regressions, source

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))
import ball_end_cases  # noqa: E402

KEYS = ball_end_cases.KEYS
PLANE = 45.0  # feed direction on the plane, degrees


def plane():
    errors = {"volume": [], "tool_face": [], "previous_face": [], "mean_thickness": []}
    for feed, stepover in (*source.PAIRS, (0.08, None)):
        volume, tool, previous = ball_end_cases.on_the_plane(feed, stepover)
        found = ball_end.chip(
            ("plane",),
            *(source.DIAMETER, feed, stepover or 1, source.ALLOWANCE, PLANE),
            uncut="slot" if stepover is None else "right",
        )
        wanted = (volume, tool, previous, volume / previous)
        for (name, into), value in zip(errors.items(), wanted):
            into.append(abs(getattr(found, name) / value - 1))
    for name, into in errors.items():
        yield "ball_end.plane.%s_error" % name, 100 * max(into), "%"


def reference():
    rows = ball_end_cases.VECTORS
    found = [ball_end_cases.figures(ball_end_cases.vector_chip(row)) for row in rows]
    for i, key in enumerate(KEYS, 6):
        worst = max(abs(each[key] / row[i] - 1) for each, row in zip(found, rows))
        yield "ball_end.vectors.%s_error" % key, 100 * worst, "%"
    wanted, ours = ball_end_cases.table()
    for key in KEYS:
        worst = numpy.abs(ours[key] / wanted[key] - 1).max()
        yield "ball_end.table.%s_error" % key, 100 * worst, "%"
    worst = numpy.abs(ours["tip_V"] - wanted["tip_V"]).max()
    yield "ball_end.table.tip_share_error", 100 * worst, "points"


def fits():
    found = ball_end.fit(ball_end.source_rows())
    for model, published in regressions.PUBLISHED.items():
        pairs = zip(regressions.MODELS[model], published)
        errors = [
            abs(found[model].coefficients[term] / value - 1)
            for term, value in pairs
            if term != "normal"  # within its standard error of 0
        ]
        yield "ball_end.%s.coefficient_error" % model, 100 * max(errors), "%"
        yield "ball_end.%s.adjusted_r_squared" % model, 100 * found[model].adjusted_r_squared, "%"
        yield "ball_end.%s.sum_of_squares" % model, found[model].sum_of_squares, "mm2"
    both = found["E3 CV"].sum_of_squares + found["E3 CX"].sum_of_squares
    yield "ball_end.E3.sum_of_squares", both, "mm2"


def times():
    parts = numpy.repeat([-1, 1], 630)
    surfaces = [("test part", "CX" if part > 0 else "CV") for part in parts]
    y, direction, pair = (
        numpy.tile(grid.ravel(), 2)
        for grid in numpy.meshgrid(
            source.PITCH * numpy.arange(-10, 11), source.DIRECTIONS, range(len(source.PAIRS))
        )
    )
    feed, stepover = numpy.array(source.PAIRS)[pair].T
    arguments = (source.DIAMETER, feed, stepover, source.ALLOWANCE, direction, y)
    start = time.process_time()
    ball_end.chips(surfaces, *arguments, threads=1)
    yield "ball_end.chips_1260.one_core", time.process_time() - start, "s"
    start = time.perf_counter()
    ball_end.chips(surfaces, *arguments)
    yield "ball_end.chips_1260.all_cores", time.perf_counter() - start, "s"


def figures():
    for part in (plane, reference, fits, times):
        yield from part()


# What is required, by the end of a figure's name.
REQUIRED = {
    **{"plane.%s_error" % name: "0.02 %" for name in ("volume", "tool_face", "previous_face")},
    "plane.mean_thickness_error": "0.02 %",
    **{"V_error": "0.1 %", "A_tool_error": "0.2 %", "A_prev_error": "0.2 %"},
    **{"h_tool_error": "0.2 %", "h_m_error": "0.2 %", "h_max_error": "1 %"},
    **{"coefficient_error": "3 %", "one_core": "2 s"},
    **{"E0.adjusted_r_squared": "96.6 %", "E1.adjusted_r_squared": "97.4 %"},
    **{"E2.adjusted_r_squared": "97.5 %", "E1.sum_of_squares": "2.24e-4 mm2"},
    "E2.sum_of_squares": "2.22e-4 mm2",
}


def table(values):
    yield "chip model, beside what is required"
    for name, value in values.items():
        if name.startswith("ball_end."):
            ends = [text for end, text in REQUIRED.items() if name.endswith(end)]
            yield "  %-44s %12.4g   %s" % (name, value, *(ends or [""]))
