"""The pictures of docs/finishing.md; see make_pictures.py."""

import math
import sys

import numpy
from dynamics_pictures import kept
from evenload import planar
from evenload.pictures.figure import new_figure
from evenload.pictures.path_picture import draw_path
from picture_parts import BLUE, DOCS, GREY, INK, ORANGE, STOCK

sys.path.insert(0, str(DOCS.parent / "tests" / "python"))
import finishing_cases as cases  # noqa: E402

BALL, DEFLECTION, WISH = 5.0, 5e-4, 0.01
CUT = 3


def finished(core, is_convex=True, **others):
    """The core's Finish of a test part."""
    mesh = core.surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
    arguments = {"tolerance": cases.TOLERANCE - DEFLECTION, "deflection": DEFLECTION, **others}
    return core.surface.finish(mesh, **cases.options(**arguments))


def draw_passes(core):
    """Passes over CX at even cusps, seen from above, and their places on its section."""
    moves = finished(core, cusp_height=0.1).toolpath.moves
    lowest = min(move[3] for move in moves if move[0] == CUT)
    figure = new_figure(10, 4, layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1, 1.5))
    samples = [(x, y, z - lowest, kind) for (x, y, z), kind in zip(*planar.drawn(moves))]
    draw_path(left, samples, [], None, "height of the tip above the flats, mm")
    y = numpy.linspace(-40, 40, 801)
    right.fill_between(y, cases.height(y, True), 30, color=STOCK)
    right.plot(y, cases.height(y, True), color=INK, lw=1.2)
    turn = numpy.linspace(0, 2 * math.pi, 60)
    for v, z in sorted({(round(m[2], 6), round(m[3], 6)) for m in moves if m[0] == CUT})[::2]:
        circle = v + BALL * numpy.cos(turn), z + BALL + BALL * numpy.sin(turn)
        right.plot(*circle, color=BLUE, lw=0.7)
    right.set_aspect("equal")
    right.set_xlabel("y, mm: every other pass")
    right.set_ylabel("z, mm")
    kept(figure, "finishing_passes.png")


def cusp(before, after, is_convex=True):
    """What stands between two passes along x, in mm: where their balls meet, off the part."""
    first, second = numpy.array(before), numpy.array(after)
    half, (dy, dz) = numpy.linalg.norm(second - first) / 2, second - first
    down = numpy.array((dz, -dy)) / (2 * half)
    meet = (first + second) / 2 + [0, BALL] + math.sqrt(BALL**2 - half**2) * down
    return cases.distance(numpy.array([(0, *meet)]), is_convex)[0]


def draw_cusps(core):
    """Cusps across CX with even stepovers, and with even cusps."""
    figure = new_figure(9, 3.6, layout="constrained")
    axes = figure.add_subplot()
    even = 2 * math.sqrt(WISH * (2 * BALL - WISH))
    for others, colour, name in (
        ({"stepover": even}, ORANGE, "constant stepover"),
        ({"cusp_height": WISH}, BLUE, "constant cusp height"),
    ):
        found = finished(core, **others)
        moves = found.toolpath.moves
        rows = sorted({(round(m[2], 6), round(m[3], 4)) for m in moves if m[0] == CUT})
        rows = list(dict(rows).items())
        middles = [(a[0] + b[0]) / 2 for a, b in zip(rows, rows[1:])]
        heights = [1e3 * cusp(a, b) for a, b in zip(rows, rows[1:])]
        axes.step(middles, heights, where="mid", color=colour, lw=1.4)
        axes.plot([], [], color=colour, label="%s, %d passes" % (name, len(rows)))
    axes.axhline(1e3 * WISH, color=GREY, lw=0.8, ls="--", label="the wish")
    axes.set_ylim(0, None)
    axes.set_xlabel("y across the dome, mm")
    axes.set_ylabel("between two passes stand, \u00b5m")
    axes.legend(fontsize=8, loc="lower center", ncols=3)
    kept(figure, "finishing_cusps.png")


def draw_lines(core):
    """How far a pass over the crest of CX is from the part."""
    found = finished(core, stepover=10.0, angle=math.pi / 2)
    moves = found.toolpath.moves
    first = next(i for i, m in enumerate(moves) if m[0] == CUT)
    last = next(i for i in range(first, len(moves)) if moves[i][0] != CUT)
    piece = moves[first - 1 : last]
    places = cases.places_along(piece, (CUT,), 0.02)
    off = 1e3 * (cases.distance(places + [0, 0, BALL], True) - BALL)
    figure = new_figure(9, 3.2, layout="constrained")
    axes = figure.add_subplot()
    order = numpy.argsort(places[:, 1])
    axes.plot(places[order, 1], off[order], color=BLUE, lw=1)
    for bound in (-0.2, 1):
        axes.axhline(1e3 * bound * cases.TOLERANCE, color=ORANGE, lw=1, ls="--")
    axes.axhline(0, color=INK, lw=0.8)
    axes.set_xlabel("y along the pass, mm: %d lines" % len(piece))
    axes.set_ylabel("ball above the part, \u00b5m")
    kept(figure, "finishing_lines.png")


def draw_contours(core):
    """Contours over CX at even cusps, and what stands between them at places of the part."""
    moves = finished(
        core, pattern="contours inwards", cusp_height=0.2, tolerance=5e-4
    ).toolpath.moves
    lowest = min(move[3] for move in moves if move[0] == CUT)
    figure = new_figure(10, 4.6, layout="constrained")
    left, right = figure.subplots(1, 2)
    samples = [(x, y, z - lowest, kind) for (x, y, z), kind in zip(*planar.drawn(moves))]
    draw_path(left, samples, [], None, "height of the tip above the flats, mm")
    x, y = numpy.meshgrid(*[numpy.linspace(-40, 40, 321)] * 2)
    centres = cases.places_along(moves, (CUT,), 0.1) + [0, 0, BALL]
    stands = numpy.full(x.shape, numpy.inf)
    # What each ball leaves in a square about it, the least of which counts.
    span = numpy.arange(-16, 17)
    column = numpy.rint((centres[:, 0] + 40) / 0.25).astype(int)
    row = numpy.rint((centres[:, 1] + 40) / 0.25).astype(int)
    part = cases.height(y, True)
    for i in span:
        for k in span:
            r, c = row + i, column + k
            inside = (r >= 0) & (r < 321) & (c >= 0) & (c < 321)
            r, c, centre = r[inside], c[inside], centres[inside]
            place = numpy.column_stack([x[r, c], y[r, c], part[r, c]])
            off = numpy.linalg.norm(place - centre, axis=1) - BALL
            numpy.minimum.at(stands, (r, c), off)
    shown = right.imshow(
        stands, origin="lower", extent=(-40, 40, -40, 40), cmap="turbo", vmin=0, vmax=0.22
    )
    figure.colorbar(shown, ax=right, label="what stands, mm, for a wish of 0.2")
    right.set_xlabel("x, mm")
    right.set_ylabel("y, mm")
    kept(figure, "finishing_contours.png")


def draw_extension(core):
    """Contours that go on beyond CX, and a section of them through its middle."""
    moves = finished(core, pattern="contours inwards", stepover=2.5, extension=5.0).toolpath.moves
    lowest = min(move[3] for move in moves if move[0] == CUT)
    figure = new_figure(10, 4, layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1, 1.4))
    samples = [(x, y, z - lowest, kind) for (x, y, z), kind in zip(*planar.drawn(moves))]
    square = [(-40, -40), (40, -40), (40, 40), (-40, 40), (-40, -40)]
    draw_path(left, samples, [square], None, "height of the tip above the flats, mm", walls="faces")
    y = numpy.linspace(-40, 40, 801)
    right.fill_between(y, cases.height(y, True), 30, color=STOCK)
    right.plot(y, cases.height(y, True), color=INK, lw=1.2)
    turn = numpy.linspace(0, 2 * math.pi, 60)
    places = cases.places_along(moves, (CUT,), 0.5)
    middle = places[numpy.abs(places[:, 0]) < 0.3]
    for v, z in {round(p[1] / 2.5): (p[1], p[2]) for p in middle}.values():
        right.plot(
            v + BALL * numpy.cos(turn), z + BALL + BALL * numpy.sin(turn), color=BLUE, lw=0.7
        )
    right.set_aspect("equal")
    right.set_xlabel("y, mm")
    right.set_ylabel("z, mm")
    kept(figure, "finishing_extension.png")


PICTURES = (draw_passes, draw_cusps, draw_lines, draw_contours, draw_extension)
