"""The pictures of docs/dynamics.md; see make_pictures.py."""

import io

import numpy
from evenload import dynamics
from evenload.dynamics import pictures
from PIL import Image
from picture_parts import DOCS

MODE = (0.03993, 922, 0.011)  # the benchmark of [Insperger & Stépán 2004]


def kept(figure, name):
    """A figure as a small PNG of few colours."""
    raw = io.BytesIO()
    figure.savefig(raw, format="png", dpi=90)
    image = Image.open(raw).convert("RGB").quantize(64, dither=Image.Dither.NONE)
    image.save(DOCS / name, optimize=True)
    print("%-20s %4d kB" % (name, (DOCS / name).stat().st_size / 1000))


def islands():
    return dynamics.Milling([dynamics.Mode(*MODE)], 2, 600, 200, immersion=0.7, helix_pitch=10)


def helical():
    modes = [dynamics.Mode(*MODE), dynamics.Mode(0.06, 1150, 0.011, 90)]
    return dynamics.Milling(modes, 2, 600, 200, immersion=0.1, diameter=8, helix_angle=45)


def draw_chart(core):
    chart = helical().chart((4000, 16000), (0.1, 14))
    words = "A tool of 8 mm, two teeth, 45\u00b0 helix, two unequal modes, climb 0.1 D"
    figure = pictures.chart(
        chart, None, point=(9000, 5), feed_per_tooth=0.05, frequency=922, title=words
    )
    kept(figure, "dynamics_chart.png")


def draw_islands(core):
    chart = islands().chart((9000, 22000), (0.3, 8))
    words = "Islands of a helical tool: climb 0.7 D, lead 10 mm, one mode"
    kept(pictures.chart(chart, None, frequency=922, title=words), "dynamics_islands.png")


def draw_bisection(core):
    """Nodes that are evaluated around a circle, level by level."""
    from evenload.pictures.figure import new_figure

    figure = new_figure(9, 3.2, layout="constrained")
    for axes, halvings in zip(figure.subplots(1, 3), (0, 1, 3)):
        looks = []

        def circle(x, y):
            looks.append((x, y))
            return x * x + y * y - 1

        found = dynamics.mdbm(circle, [(-2, 2, 8), (-2, 2, 8)], halvings)
        axes.plot(*zip(*looks), ".", color="#9aa0a6", ms=3)
        for curve in found.curves:
            axes.plot(*curve.T, color="#1a73e8", lw=1.5)
        axes.set_aspect("equal")
        axes.set_title("%d halvings: %d evaluations" % (halvings, found.evaluations), fontsize=9)
    kept(figure, "dynamics_bisection.png")


def draw_wall(core):
    modes = [dynamics.Mode(*MODE), dynamics.Mode(*MODE, 90)]
    tool = dynamics.Milling(modes, 2, 600, 200, immersion=0.1, diameter=8, helix_angle=45)
    figure = pictures.wall(tool.surface(9220, 1.5, 0.1), None, 1.5, 0.1)
    kept(figure, "dynamics_wall.png")


def draw_orbits(core):
    tool = dynamics.Milling([dynamics.Mode(*MODE)], 3, 600, 400, "conventional", 0.35)
    orbits = tool.forced_orbits(9266.1, numpy.array([0.1, 2.6]), 0.2)
    kept(pictures.orbits(orbits, None), "dynamics_orbits.png")


PICTURES = (draw_chart, draw_islands, draw_bisection, draw_wall, draw_orbits)
