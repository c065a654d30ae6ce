"""The pictures of docs/inspection.md; see make_pictures.py."""

import numpy
from dynamics_pictures import kept
from evenload import inspection
from evenload.pictures.figure import new_figure

INK, BLUE, RED, GREY = "#202124", "#1a73e8", "#d93025", "#80868b"
SIDE = numpy.linspace(-38, 38, 21)
COUNTS = (16, 25, 36, 49, 64, 81, 100, 121, 196, 256, 441)
REPEATS = 24
MICRON = 1e-3


def waves(x, y, random):
    """The courses of passes: waves of a few mm across the part, of any phase."""
    length = random.uniform(9, 16)
    return 8 * numpy.sin(2 * numpy.pi * y / length + random.uniform(0, 6.28)) + 0.5 * x / 38


def force(x, y, random):
    """High on flats and crest, low on the fillets, as where forces bend the tool."""
    tilt = random.normal(size=2)
    return (
        8 * numpy.cos(6 * numpy.pi * y / 80)
        + 2 * tilt[0] * x * y / 1444
        + random.normal(0, 1, x.shape)
    )


def corners(x, y, random):
    """Errors that grow steeply towards the corners."""
    sign = random.choice([-1, 1], 4)
    far = numpy.abs(x * y / 1444) ** 3
    quadrant = 2 * (x > 0) + (y > 0)
    return 16 * sign[quadrant] * far + random.normal(0, 1, x.shape)


FIELDS = (("waves of passes", waves), ("force on the tool", force), ("corners", corners))


def chosen(pattern, n):
    """Numbers of those of the 441 points that are nearest to a pattern's."""
    side = round(n**0.5)
    if pattern == "matrix":
        wanted = inspection.matrix(n) + 0.5 / side
    else:
        wanted = inspection.halton_zaremba(n) + [0.5 / n, 0]
    places = numpy.clip(numpy.rint(wanted * 21 - 0.5), 0, 20).astype(int)
    return numpy.unique(places[:, 1] * 21 + places[:, 0])


def draw_points(core):
    """Profile error by number of points, beside that of all 441."""
    x, y = (grid.ravel() for grid in numpy.meshgrid(SIDE, SIDE))
    part = inspection.test_part("CX")
    feet, normals = part.at(x, y)
    figure = new_figure(10, 3.8, layout="constrained")
    for axes, (name, field) in zip(figure.subplots(1, 3, sharey=True), FIELDS):
        shares = {"matrix": [], "Halton-Zaremba": []}
        for i in range(REPEATS):
            points = feet + MICRON * field(x, y, numpy.random.default_rng(i))[:, None] * normals
            reference = inspection.profile(points, part).width
            for pattern, into in shares.items():
                into.append(
                    [
                        inspection.profile(points[chosen(pattern, n)], part).width / reference
                        for n in COUNTS[:-1]
                    ]
                    + [1.0]
                )
        for (pattern, found), colour in zip(shares.items(), (BLUE, RED)):
            found = numpy.array(found)
            axes.plot(COUNTS, found.mean(axis=0), "o-", color=colour, ms=3, lw=1.5, label=pattern)
            axes.fill_between(
                COUNTS, found.min(axis=0), found.max(axis=0), color=colour, alpha=0.15
            )
        axes.axvline(49, color=GREY, lw=1, ls="--")
        axes.set_xscale("log")
        axes.set_xticks((16, 25, 49, 100, 196, 441))
        axes.set_xticklabels(("16", "25", "49", "100", "196", "441"))
        axes.minorticks_off()
        axes.set_ylim(0, 1.05)
        axes.set_title(name, fontsize=9)
        axes.set_xlabel("measured points")
        axes.grid(alpha=0.3)
        print(
            "%-18s at 49: matrix %.2f, Halton-Zaremba %.2f"
            % (
                name,
                numpy.mean(shares["matrix"], axis=0)[3],
                numpy.mean(shares["Halton-Zaremba"], axis=0)[3],
            )
        )
    figure.axes[0].set_ylabel("profile error found,\nshare of that of 441 points")
    figure.axes[0].legend(fontsize=8, loc="lower right")
    kept(figure, "inspection_points.png")


def draw_patterns(core):
    """Both patterns with 36 points on the test part, seen from above."""
    x, y = (grid.ravel() for grid in numpy.meshgrid(SIDE, SIDE))
    figure = new_figure(8.4, 3.7, layout="constrained")
    for axes, pattern in zip(figure.subplots(1, 2, sharey=True), ("matrix", "Halton-Zaremba")):
        for low, high, colour, word in (
            (-40, -30, "#e8eaed", "flat"),
            (-30, -24.545, "#fad2cf", "fillet R10"),
            (-24.545, 24.545, "#d2e3fc", "dome R45"),
            (24.545, 30, "#fad2cf", None),
            (30, 40, "#e8eaed", None),
        ):
            axes.axhspan(low, high, color=colour, lw=0, label=word)
        axes.plot(x, y, ".", color=GREY, ms=1.5)
        picked = chosen(pattern, 36)
        axes.plot(x[picked], y[picked], "o", color=INK, ms=4)
        axes.set_title("%s, 36 points" % pattern, fontsize=9)
        axes.set_aspect("equal")
        axes.set_xlim(-40, 40)
        axes.set_ylim(-40, 40)
        axes.set_xlabel("x, mm")
    figure.axes[0].set_ylabel("y, mm")
    axes.legend(
        *figure.axes[0].get_legend_handles_labels(),
        fontsize=8,
        loc="center left",
        bbox_to_anchor=(1.02, 0.5),
    )
    kept(figure, "inspection_patterns.png")


def draw_zone(core):
    """A roundness plot: both zones, and the contacts with their multipliers."""
    random = numpy.random.default_rng(21)
    turn = numpy.linspace(0, 2 * numpy.pi, 90, endpoint=False)
    error = 3 * numpy.cos(3 * turn + 0.5) + 1.2 * numpy.cos(7 * turn) + random.normal(0, 0.5, 90)
    radius = 20 + MICRON * error
    points = numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn)], axis=1)
    figure = new_figure(8.4, 4.5)
    fits = [
        inspection.fit(points, "circle", method) for method in ("least squares", "minimum zone")
    ]
    shown = figure.subplots(1, 2, subplot_kw={"projection": "polar"})
    for axes, found in zip(shown, fits):
        round_ = numpy.linspace(0, 2 * numpy.pi, 361)
        height = 1e3 * found.deviations
        axes.fill_between(
            round_,
            numpy.full(361, height.min()),
            numpy.full(361, height.max()),
            color=BLUE,
            alpha=0.15,
            lw=0,
        )
        axes.plot(
            numpy.append(turn, turn[0]),
            numpy.append(height, height[0]),
            ".-",
            color=INK,
            ms=3,
            lw=0.8,
        )
        for point, side, share in zip(found.contacts, found.sides, found.multipliers):
            fill = INK if side > 0 else "#ffffff"
            axes.plot(turn[point], height[point], "o", color=INK, mfc=fill, ms=8)
            axes.annotate(
                "%.2f" % share,
                (turn[point], height[point]),
                textcoords="offset points",
                xytext=(9, 5),
                fontsize=8,
            )
        axes.set_ylim(-14, 7)
        axes.set_yticks((-5, 0, 5))
        axes.set_yticklabels(("\u22125", "0", "5 \u00b5m"), fontsize=7)
        axes.set_xticks([])
        axes.set_title("%s: %.2f \u00b5m" % (found.method, 1e3 * found.zone), fontsize=10)
    figure.subplots_adjust(0.02, 0.02, 0.98, 0.88, wspace=0.06)
    kept(figure, "inspection_zone.png")


PICTURES = (draw_points, draw_patterns, draw_zone)
