"""The pictures of docs/chip_model.md; see make_pictures.py."""

import warnings

import numpy
from dynamics_pictures import kept
from evenload import ball_end
from evenload.pictures.figure import new_figure

RADIUS, FEED, STEPOVER, ALLOWANCE = 5.0, 0.16, 0.35, 0.3
INK = "#202124"
COLOURS = ("#1a73e8", "#188038", "#d93025")


def depths_on_the_plane(side, ahead):
    """How far, in mm, what bounds the chip lies below the ball: tooth before, pass, stock's top.

    side: mm to the right of the contact; ahead: mm along the feed, both on the ball itself.
    """
    down = numpy.sqrt(RADIUS**2 - side**2 - ahead**2)
    before = -FEED * ahead / RADIUS
    before = RADIUS - before - numpy.sqrt(before**2 + RADIUS**2 - FEED**2)
    # The earlier pass is a cylinder along the feed, a stepover to the left.
    across = (side**2 + down**2) / RADIUS**2
    along = -side * STEPOVER / RADIUS
    root = numpy.sqrt(along**2 + across * (RADIUS**2 - STEPOVER**2))
    earlier = RADIUS - (along + root) / across
    top = RADIUS - (RADIUS - ALLOWANCE) * RADIUS / down
    return before, earlier, top


def draw_chip(core):
    """A chip seen from above: its thickness, and what bounds it."""
    side, ahead = numpy.meshgrid(numpy.linspace(-0.4, 1.9, 700), numpy.linspace(-0.15, 1.3, 450))
    depths = depths_on_the_plane(side, ahead)
    thickness = numpy.minimum.reduce(depths)
    figure = new_figure(8, 4.4, layout="constrained")
    axes = figure.add_subplot()
    shown = numpy.where(thickness > 0, 1e3 * thickness, numpy.nan)
    image = axes.contourf(side, ahead, shown, levels=numpy.arange(0, 33, 3), cmap="viridis")
    figure.colorbar(image, label="thickness, \u00b5m")
    words = ("tooth before", "earlier pass", "top of the stock")
    for depth, colour, word in zip(depths, COLOURS, words):
        axes.contour(side, ahead, depth, levels=[0], colors=[colour], linewidths=1.5)
        axes.plot([], [], color=colour, label="bound: " + word)
    owner = numpy.argmin(depths, axis=0) == 0
    edge = numpy.where(thickness > 0, owner.astype(float), numpy.nan)
    axes.contour(side, ahead, edge, levels=[0.5], colors=["white"], linewidths=1, linestyles="--")
    axes.plot([0], [0], "+", color=INK, ms=9, label="point of contact")
    axes.set_aspect("equal")
    axes.set_xlabel("to the right of the feed, mm")
    axes.set_ylabel("along the feed, mm")
    axes.legend(fontsize=8, loc="upper left", framealpha=0.9)
    kept(figure, "chip_model_chip.png")


def draw_thickness(core):
    """Mean thickness along both test parts, beside the source's E1."""
    y = numpy.linspace(-35, 35, 141)
    figure = new_figure(9, 3.8, layout="constrained")
    for axes, part in zip(figure.subplots(1, 2, sharey=True), ("CX", "CV")):
        for direction, colour in zip((0, 45, 90), COLOURS):
            found = sum(
                ball_end.chips(
                    ("test part", part), 10, 0.12, 0.15, 0.3, direction, y, side
                ).mean_thickness
                for side in ("right", "left")
            )
            axes.plot(y, 500 * found, color=colour, lw=1.5, label="feed at %d\u00b0" % direction)
            inner = y[abs(y) <= 21]
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                fitted = ball_end.regression(
                    "E1", part, direction, 0.12, 0.15, numpy.degrees(numpy.arcsin(inner / 45))
                )
            axes.plot(inner, 1e3 * fitted, "--", color=colour, lw=1)
        axes.plot([], [], "--", color=INK, lw=1, label="E1 of the source")
        axes.set_title("%s, feed 0.12, stepover 0.15 mm" % part, fontsize=9)
        axes.set_xlabel("y of the tool, mm")
        axes.grid(alpha=0.3)
    figure.axes[0].set_ylabel("mean chip thickness, \u00b5m")
    figure.axes[0].legend(fontsize=8, loc="upper center")
    kept(figure, "chip_model_thickness.png")


def draw_tip(core):
    """The tip's share by the side on which material stands."""
    y = numpy.linspace(-22, 22, 133)
    figure = new_figure(8, 3.4, layout="constrained")
    axes = figure.add_subplot()
    for side, colour in zip(("right", "left"), COLOURS):
        found = ball_end.chips(("cylinder", 45), 10, 0.12, 0.15, 0.3, 0, y, side)
        axes.plot(y, 100 * found.tip_share, color=colour, lw=1.5, label="uncut on the " + side)
    axes.set_xlabel("y of the tool, mm")
    axes.set_ylabel("share of the volume\ncut by the tip, %")
    axes.set_title("Dome R45, feed along its axis", fontsize=9)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    kept(figure, "chip_model_tip.png")


PICTURES = (draw_chip, draw_thickness, draw_tip)
