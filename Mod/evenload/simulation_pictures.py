"""Pictures of a Simulation: its path, load, force and rest, and a sheet with all four.

Each function draws into a file, SVG where its name ends so, else PNG, and returns the figure; where
the file is None, nothing is written. No display is needed. Lengths in mm, times in s.
"""

import numpy

from evenload import compiled, planar, report
from evenload.simulation import Simulation, prisms_of

LOAD_COLOUR, LIMIT_COLOUR, REST_COLOUR, WAY_COLOUR = "#1a73e8", "#d93025", "#e8710a", "#c5cbd3"
PART_COLOURS = "#f1ece0", "#b7a88a"  # of the lowest and of the highest top
# (beginning of an incident's name, label, marker, colour)
INCIDENTS = (
    ("gouge", "gouge", "X", "#d93025"),
    ("fixture", "in a fixture", "s", "#202124"),
    ("rapid", "rapid in material", "^", "#7b3fa0"),
    ("plunge", "plunge in material", "v", "#1a73e8"),
)
KINDS = (
    (planar.CUT, "cuts", LOAD_COLOUR),
    (planar.ENTRY, "entries", report.ENTRY_COLOUR),
    (planar.LINK, "links", report.LINK_COLOUR),
    (planar.RAPID, "rapids", "#dadce0"),
)
MOST_LABELS = 8  # rests that are named by their area, the largest first
COLUMNS = 1200  # of a plot over time: more samples are drawn as their least, mean and largest


def path(simulation, file, outlines=(), hole=None, target_deg=None, title="Engagement"):
    """The path seen from above, cuts coloured by engagement, the other moves by kind.

    outlines: lists of (x, y), or regions; hole: (x, y, diameter) or None; target_deg: the colours
    end a little above it, by default at the largest engagement.
    """
    figure = report.new_figure(9, 8, layout="constrained")
    axes = figure.add_subplot()
    _draw_path(axes, simulation, outlines, hole, target_deg)
    axes.set_title(title)
    return _saved(figure, file)


def load(simulation, file, target_deg=None, nominal_rate=None, title="Load"):
    """Engagement angle and removal rate over time, with a line each for what they shall not exceed.

    target_deg: engagement in degrees; nominal_rate: mm3/min; None for no line.
    """
    figure = report.new_figure(10, 6.5, layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    _draw_load(upper, lower, simulation, target_deg, nominal_rate)
    upper.set_title(title, loc="left")
    return _saved(figure, file)


def force(simulation, file, reference=None, title="Force"):
    """Peak and mean over a revolution of the force in XY, over time. reference: N, a line.

    Raises ValueError for a Simulation without forces.
    """
    if simulation.force_peak is None:
        raise ValueError("The simulation has no forces: name a material for it.")
    figure = report.new_figure(10, 4.5, layout="constrained")
    axes = figure.add_subplot()
    _draw_force(axes, simulation, reference)
    axes.set_title(title, loc="left")
    return _saved(figure, file)


def rest(simulation, file, stock=(), part=(), title="Rest and incidents"):
    """What is left over, with its areas, and where gouges, rapids and plunges in material are.

    stock and part: in the words that `simulate` takes.
    """
    figure = report.new_figure(9, 8, layout="constrained")
    axes = figure.add_subplot()
    _draw_rest(axes, simulation, *_prisms(simulation, stock, part))
    axes.set_title(title)
    return _saved(figure, file)


def sheet(
    simulation,
    file,
    stock=(),
    part=(),
    hole=None,
    target_deg=None,
    nominal_rate=None,
    reference=None,
    title="Simulation",
):
    """All four on one sheet, under a line with the figures; see the single pictures.

    stock and part: in the words that `simulate` takes. Raises ValueError for others.
    """
    stock, part = _prisms(simulation, stock, part)
    figure = report.new_figure(16, 12.5, layout="constrained")
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08, wspace=0.04)
    over, below = figure.subfigures(2, 1, height_ratios=(7, 5.5))
    left, right = over.subplots(1, 2)
    tops = {top for _, top in part}
    walls = [region for region, top in part if top == max(tops)]
    _draw_path(left, simulation, walls, hole, target_deg)
    _draw_rest(right, simulation, stock, part)
    left.set_title("Engagement")
    right.set_title("Rest and incidents")
    grid = below.add_gridspec(2, 2)
    upper = below.add_subplot(grid[0, 0])
    lower = below.add_subplot(grid[1, 0], sharex=upper)
    _draw_load(upper, lower, simulation, target_deg, nominal_rate)
    upper.set_title("Load", loc="left")
    axes = below.add_subplot(grid[:, 1])
    axes.set_title("Force", loc="left")
    if simulation.force_peak is None:
        axes.text(0.5, 0.5, "no material, no forces", ha="center", transform=axes.transAxes)
        axes.set_axis_off()
    else:
        _draw_force(axes, simulation, reference)
    figure.suptitle("%s\n%s" % (title, summary(simulation)), fontsize=12)
    return _saved(figure, file)


def summary(simulation):
    """The figures in one line."""
    words = ["%.0f s" % simulation.time_total_s]
    if simulation.machine_time_total_s is not None:
        words.append("%.0f s on the machine" % simulation.machine_time_total_s)
    words.append("largest engagement %.1f\u00b0" % simulation.max_engagement_deg)
    words.append("rest %.2f mm\u00b2" % simulation.rest_area)
    words.append("gouge %.3f mm" % simulation.gouge_mm)
    words.append("rapids in material %.1f mm" % simulation.rapid_in_material_mm)
    words.append("plunges in material %.1f mm" % simulation.plunge_in_material_mm)
    if simulation.force_peak_max is not None:
        words.append("largest force %.0f N" % simulation.force_peak_max)
    return ", ".join(words)


def _saved(figure, file):
    if file is not None:
        report.save(figure, file)
    return figure


# ---- seen from above ----


def _draw_path(axes, simulation, outlines, hole, target_deg):
    columns = (simulation.x, simulation.y, simulation.engagement_deg, simulation.kind)
    samples = list(zip(*(numpy.asarray(column).tolist() for column in columns)))
    report.draw_path(
        axes,
        samples,
        [_closed(polygon) for item in outlines for polygon in _polygons(item)],
        hole,
        "engagement angle, degrees",
        largest=1.15 * target_deg if target_deg else None,
        walls="part",
    )


def _draw_rest(axes, simulation, stock, part):
    for region, _ in stock:
        for polygon in _polygons(region):
            axes.plot(*zip(*_closed(polygon)), color=report.WALL_COLOUR, linewidth=1.2, zorder=3)
    _fill_part(axes, part)
    _draw_way(axes, simulation)
    for number, outline in enumerate(simulation.rest_outlines):
        label = "rest" if number == 0 else None
        points = numpy.array(outline)
        # Edges in the same colour: the tiles of one patch show no seams.
        axes.fill(*points.T, color=REST_COLOUR, lw=0.6, zorder=5, label=label)
    for area, x, y, _ in sorted(simulation.rests, reverse=True)[:MOST_LABELS]:
        axes.annotate(
            "%.2f mm\u00b2" % area,
            (x, y),
            xytext=(9, 9),
            textcoords="offset points",
            fontsize=8,
            color=LIMIT_COLOUR,
            arrowprops={"arrowstyle": "-", "color": LIMIT_COLOUR, "linewidth": 0.6},
            bbox={"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.8},
            zorder=7,
        )
    for beginning, label, marker, colour in INCIDENTS:
        places = [i[1:3] for i in simulation.incidents if i[0].startswith(beginning)]
        if places:
            axes.scatter(
                *zip(*places),
                marker=marker,
                s=70,
                color=colour,
                edgecolors="white",
                linewidths=0.8,
                zorder=6,
                label="%s (%d)" % (label, len(places)),
            )
    report.seen_from_above(axes)
    if not simulation.incidents and not len(simulation.rest_outlines):
        axes.plot([], [], " ", label="no rest, no incidents")
    report.legend_below(axes, columns=3)


def _fill_part(axes, part):
    """The part's prisms, the lowest first, in a darker colour the higher they are."""
    from matplotlib.colors import LinearSegmentedColormap
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    colours = LinearSegmentedColormap.from_list("part", PART_COLOURS)
    tops = sorted({round(top, 4) for _, top in part})
    for item, top in sorted(part, key=lambda prism: prism[1]):
        loops = [Path(_closed(polygon), closed=True) for polygon in _polygons(item)]
        rank = tops.index(round(top, 4))
        label = "part, top at z = %g" % tops[rank]
        axes.add_patch(
            PathPatch(
                Path.make_compound_path(*loops),
                facecolor=colours(rank / max(1, len(tops) - 1)),
                edgecolor="#8d7f63",
                linewidth=0.5,
                zorder=1 + 0.5 * rank / max(1, len(tops)),
                label=label if label not in axes.get_legend_handles_labels()[1] else None,
            )
        )


def _draw_way(axes, simulation):
    """The path of everything but rapids, faintly."""
    from matplotlib.collections import LineCollection

    points = numpy.column_stack([simulation.x, simulation.y])
    pieces = numpy.stack([points[:-1], points[1:]], axis=1)
    kept = numpy.asarray(simulation.kind)[1:] != planar.RAPID
    many = len(points) > report.MOST_VECTORS
    axes.add_collection(
        LineCollection(pieces[kept], colors=WAY_COLOUR, linewidths=0.5, zorder=2, rasterized=many)
    )


def _prisms(simulation, stock, part):
    """[(the core's Region, top), ...] of the stock and of the part."""
    core = compiled.core()
    if isinstance(stock, Simulation):
        stock = stock.stock_regions
    return tuple(
        prisms_of(core, shapes, simulation.top, what, may_be_none=True)
        for shapes, what in ((stock, "The stock"), (part, "The part"))
    )


def _polygons(item):
    """Lists of (x, y): outer boundary and islands of a region, box, chain or list of points."""
    if hasattr(item, "outer"):
        return [planar.flattened(chain) for chain in (item.outer, *item.islands)]
    if len(item) == 4 and not hasattr(item[0], "__len__"):
        x0, y0, x1, y1 = item
        return [numpy.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])]
    if len(item[0]) > 2:
        return [planar.flattened(list(item))]
    return [numpy.array(item)]


def _closed(polygon):
    return numpy.vstack([polygon, polygon[:1]])


# ---- over time ----


def _draw_load(upper, lower, simulation, target_deg, nominal_rate):
    time = simulation.time_s
    _draw_band(upper, time, simulation.engagement_deg)
    upper.set_ylabel("engagement, degrees")
    _limit(upper, target_deg, "target %.4g\u00b0")
    _draw_kinds(upper, simulation)
    _draw_band(lower, time, numpy.asarray(simulation.removal_rate) / 1000.0)
    lower.set_ylabel("removal rate, cm\u00b3/min")
    _limit(lower, nominal_rate / 1000.0 if nominal_rate else None, "nominal %.4g cm\u00b3/min")
    for axes in (upper, lower):
        _dress(axes, time)
    upper.tick_params(labelbottom=False)
    lower.set_xlabel("time, s")
    _legend_above(upper)
    if nominal_rate:
        _legend_above(lower)


def _draw_force(axes, simulation, reference):
    _draw_band(axes, simulation.time_s, simulation.force_peak, colour=REST_COLOUR, label="peak")
    _draw_band(axes, simulation.time_s, simulation.force_mean, label="mean of a revolution")
    _limit(axes, reference, "reference %.4g N")
    _dress(axes, simulation.time_s)
    axes.set_ylabel("force in XY, N")
    axes.set_xlabel("time, s")
    _legend_above(axes)


def _dress(axes, time):
    axes.set_xlim(0, max(time[-1], 1e-9) if len(time) else 1)
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.set_axisbelow(True)


def _legend_above(axes):
    """In one row over the right end of the axes, where it hides nothing; titles are on the left."""
    axes.legend(
        loc="lower right",
        bbox_to_anchor=(1, 1),
        borderaxespad=0.1,
        fontsize=8,
        frameon=False,
        ncols=6,
        columnspacing=1.2,
    )


def _limit(axes, value, words):
    if value:
        axes.axhline(
            value, color=LIMIT_COLOUR, linestyle="--", lw=1.1, label=words % value, zorder=4
        )
        axes.set_ylim(top=max(axes.get_ylim()[1], 1.12 * value))


def _draw_band(axes, time, values, colour=LOAD_COLOUR, label=None):
    """Values over time: a line, or many of them as a band from the least to the largest with their
    mean in it.
    """
    time, values = numpy.asarray(time), numpy.asarray(values)
    if len(time) <= 2 * COLUMNS:
        axes.plot(time, values, color=colour, linewidth=0.8, label=label, zorder=3)
        return
    middle, least, mean, largest = columns(time, values, COLUMNS)
    axes.fill_between(middle, least, largest, color=colour, alpha=0.3, linewidth=0, zorder=2)
    axes.plot(middle, largest, color=colour, linewidth=0.5, zorder=3)
    axes.plot(middle, mean, color=colour, linewidth=0.9, label=label, zorder=3)


def columns(time, values, count):
    """(time, least, mean, largest) of the values in each of `count` equal spans of time that has
    any. time: rising.
    """
    span = (time[-1] - time[0]) or 1.0
    column = numpy.minimum((count * (time - time[0]) / span).astype(int), count - 1)
    starts = numpy.flatnonzero(numpy.r_[True, numpy.diff(column) > 0])
    sizes = numpy.diff(numpy.r_[starts, len(values)])
    middle = time[0] + (column[starts] + 0.5) * span / count
    least = numpy.minimum.reduceat(values, starts)
    largest = numpy.maximum.reduceat(values, starts)
    return middle, least, numpy.add.reduceat(values, starts) / sizes, largest


def _draw_kinds(axes, simulation):
    """A strip at the foot of the axes that tells what kind of move it is."""
    time, kind = numpy.asarray(simulation.time_s), numpy.asarray(simulation.kind)
    if len(time) < 2:
        return
    height = 0.05 * axes.get_ylim()[1]
    starts = numpy.flatnonzero(numpy.r_[True, numpy.diff(kind[1:]) != 0])
    ends = numpy.r_[starts[1:], len(kind) - 1]
    for number, label, colour in KINDS:
        spans = [
            (time[a], time[b] - time[a]) for a, b in zip(starts, ends) if kind[a + 1] == number
        ]
        if spans:
            axes.broken_barh(
                spans, (-1.6 * height, height), facecolors=colour, linewidth=0, label=label
            )
    axes.set_ylim(bottom=-2.0 * height)
