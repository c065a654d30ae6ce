"""The pictures of docs/trochoid.md; see make_pictures.py."""

import math

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from picture_parts import BLUE, GREY, INK, ORANGE, STOCK, VIOLET, canvas, outline, plan, save

TOOL, WIDTH, ANGLE = 6.0, 12.0, math.radians(60)  # mm
SLOT = {
    "tool_diameter": TOOL,
    "width": WIDTH,
    "engagement_angle": ANGLE,
    "roll_radius": 0.9,
    "feed": 255.0,
    "link_feed": 1500.0,
}
PERIODS = 4


def points(moves):
    """[(x, y), ...] of moves (x0, y0, x1, y1, bulge)."""
    found = []
    for x0, y0, x1, y1, bulge in moves:
        piece = outline([(x0, y0, bulge), (x1, y1, 0.0)])[:-1]
        found += piece if not found else piece[1:]
    return found


def walls(axes, low, high):
    for y in (-WIDTH / 2, WIDTH / 2):
        axes.plot((low, high), (y, y), color=INK, linewidth=1.6)


def draw_iteration(core):
    passes, residuals = core.trochoid_passes(most=10, **SLOT)
    figure = Figure(figsize=(9, 3.6), dpi=110)
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2, width_ratios=(2, 1))
    colours = LineCollection([points(p) for p in passes], cmap="viridis", linewidths=1.4)
    colours.set_array(range(1, len(passes) + 1))
    left.add_collection(colours)
    walls(left, -3, 15)
    left.autoscale()
    plan(left)
    figure.colorbar(colours, ax=left, label="pass")
    right.semilogy(range(2, len(passes) + 1), residuals, "o-", color=BLUE)
    right.set_xlabel("pass")
    right.set_ylabel("advance differs by, mm")
    right.grid(True, which="both", color="#e8eaed")
    save(figure, "trochoid_iteration.png")


def draw_patterns(core):
    figure = Figure(figsize=(9, 3), dpi=110)
    FigureCanvasAgg(figure)
    kinds = ("constant engagement", "circular", "cycloid")
    for axes, kind, colour in zip(figure.subplots(1, 3), kinds, (BLUE, ORANGE, VIOLET)):
        found = core.trochoid_pattern(pattern=kind, **SLOT)
        step = found["step"]
        for k in range(PERIODS):
            for moves, style in (
                ("link", {"color": GREY, "linewidth": 0.8}),
                ("cut", {"color": colour, "linewidth": 1.5}),
            ):
                shifted = [(x + k * step, y) for x, y in points(found[moves])]
                axes.plot(*zip(*shifted), **style)
        walls(axes, -4, 11)
        axes.set_title(
            "%s\nstep %.2f mm, %.0f mm²/min" % (kind, step, found["removal"]), fontsize=10
        )
        plan(axes)
    save(figure, "trochoid_patterns.png")


def draw_slot(core):
    middle = [(0, 0, 0), (30, 0, math.tan(math.pi / 8)), (50, 20, 0), (50, 40, 0)]
    region = core.slot_around(middle, width=11.0, ends="round")
    path, report = core.clear_slot(
        [region],
        tool_diameter=TOOL,
        engagement_angle=ANGLE,
        feed_control="constant removal rate",
        feed=255.0,
        plunge_feed=255.0,
        link_feed=1500.0,
        maximum_feed=1000.0,
        levels=[-3.0],
        safe_height=5.0,
        clearance_height=10.0,
    )
    figure, axes = canvas(7.6, 6)
    axes.fill(*zip(*outline([tuple(v[:3]) for v in region.outer])), color=STOCK)
    at = None
    for kind, x, y, z, sweep, cx, cy, _ in path.moves:
        if at and kind > 0:
            bulge = math.tan(sweep / 4)
            style = {1: (GREY, 0.6), 2: (VIOLET, 1.2), 3: (BLUE, 0.9)}[kind]
            axes.plot(*zip(*points([(*at, x, y, bulge)])), color=style[0], linewidth=style[1])
        at = (x, y)
    plan(axes)
    save(
        figure,
        "trochoid_slot.png",
        "%.0f s, %.2f of the ideal; pattern along %.0f mm, step %.2f mm"
        % (
            path.report.cutting_time,
            path.report.cutting_time / path.report.ideal_time,
            report.length,
            report.step,
        ),
    )


PICTURES = (draw_iteration, draw_patterns, draw_slot)
