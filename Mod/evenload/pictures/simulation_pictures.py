"""Pictures of a Simulation: its path, load, force and rest, and a sheet with all four.

Each function draws into a file, SVG where its name ends so, else PNG, and returns the figure; where
the file is None, nothing is written. No display is needed. Lengths in mm, times in s.
"""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from evenload import compiled, planar, units
from evenload.pictures import path_picture
from evenload.pictures.figure import legend_below, new_figure, save, seen_from_above
from evenload.pictures.over_time import LIMIT_COLOUR, draw_force, draw_load
from evenload.simulation import Simulation, prisms_of
from evenload.translation import translate

REST_COLOUR, WAY_COLOUR = "#e8710a", "#c5cbd3"

PART_COLOURS = "#f1ece0", "#b7a88a"  # of the lowest and of the highest top
LABELS = "gouge", "in a fixture", "rapid in material", "plunge in material"  # of incidents
# (beginning of an incident's name, label, marker, colour)
INCIDENTS = (
    ("gouge", LABELS[0], "X", "#d93025"),
    ("fixture", LABELS[1], "s", "#202124"),
    ("rapid", LABELS[2], "^", "#7b3fa0"),
    ("plunge", LABELS[3], "v", "#1a73e8"),
)
MOST_LABELS = 8  # rests that are named by their area, the largest first


def path(simulation, file, outlines=(), hole=None, target_deg=None, title="Engagement"):
    """The path seen from above, cuts coloured by engagement, the other moves by kind.

    outlines: lists of (x, y), or regions; hole: (x, y, diameter) or None; target_deg: the colours
    end a little above it, by default at the largest engagement.
    """
    figure = new_figure(9, 8, layout="constrained")
    axes = figure.add_subplot()
    _draw_path(axes, simulation, outlines, hole, target_deg)
    axes.set_title(translate(title))
    return _saved(figure, file)


def load(simulation, file, target_deg=None, nominal_rate=None, title="Load"):
    """Engagement angle and removal rate over time, with a line each for what they shall not exceed.

    target_deg: engagement in degrees; nominal_rate: mm3/min; None for no line.
    """
    figure = new_figure(10, 6.5, layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    draw_load(upper, lower, simulation, target_deg, nominal_rate)
    upper.set_title(translate(title), loc="left")
    return _saved(figure, file)


def force(simulation, file, reference=None, title="Force"):
    """Peak and mean over a revolution of the force in XY, over time. reference: N, a line.

    Raises ValueError for a Simulation without forces.
    """
    if simulation.force_peak is None:
        raise ValueError("The simulation has no forces: name a material for it.")
    figure = new_figure(10, 4.5, layout="constrained")
    axes = figure.add_subplot()
    draw_force(axes, simulation, reference)
    axes.set_title(translate(title), loc="left")
    return _saved(figure, file)


def rest(simulation, file, stock=(), part=(), title="Rest and incidents"):
    """What is left over, with its areas, and where gouges, rapids and plunges in material are.

    stock and part: in the words that `simulate` takes.
    """
    figure = new_figure(9, 8, layout="constrained")
    axes = figure.add_subplot()
    _draw_rest(axes, simulation, *_prisms(simulation, stock, part))
    axes.set_title(translate(title))
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
    figure = new_figure(16, 12.5, layout="constrained")
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08, wspace=0.04)
    over, below = figure.subfigures(2, 1, height_ratios=(7, 5.5))
    left, right = over.subplots(1, 2)
    tops = {top for _, top in part}
    walls = [region for region, top in part if top == max(tops)]
    _draw_path(left, simulation, walls, hole, target_deg)
    _draw_rest(right, simulation, stock, part)
    left.set_title(translate("Engagement"))
    right.set_title(translate("Rest and incidents"))
    grid = below.add_gridspec(2, 2)
    upper = below.add_subplot(grid[0, 0])
    lower = below.add_subplot(grid[1, 0], sharex=upper)
    draw_load(upper, lower, simulation, target_deg, nominal_rate)
    upper.set_title(translate("Load"), loc="left")
    axes = below.add_subplot(grid[:, 1])
    axes.set_title(translate("Force"), loc="left")
    if simulation.force_peak is None:
        words = translate("no material, no forces")
        axes.text(0.5, 0.5, words, ha="center", transform=axes.transAxes)
        axes.set_axis_off()
    else:
        draw_force(axes, simulation, reference)
    figure.suptitle("%s\n%s" % (translate(title), summary(simulation)), fontsize=12)
    return _saved(figure, file)


def summary(simulation):
    """The figures in one line."""
    words = ["%.0f s" % simulation.time_total_s]
    if simulation.machine_time_total_s is not None:
        words.append(translate("%.0f s on the machine") % simulation.machine_time_total_s)
    words.append(translate("largest engagement %.1f\u00b0") % simulation.max_engagement_deg)
    words.append(translate("rest %s") % units.AREA.shown.told(simulation.rest_area))
    words.append(translate("gouge %s") % units.LENGTH.shown.told(simulation.gouge_mm))
    way = units.WAY.shown
    words.append(translate("rapids in material %s") % way.told(simulation.rapid_in_material_mm))
    words.append(translate("plunges in material %s") % way.told(simulation.plunge_in_material_mm))
    if simulation.force_peak_max is not None:
        words.append(translate("largest force %.0f N") % simulation.force_peak_max)
    return ", ".join(words)


def _saved(figure, file):
    if file is not None:
        save(figure, file)
    return figure


# ---- seen from above ----


def _draw_path(axes, simulation, outlines, hole, target_deg):
    columns = (simulation.x, simulation.y, simulation.engagement_deg, simulation.kind)
    samples = list(zip(*(numpy.asarray(column).tolist() for column in columns)))
    path_picture.draw_path(
        axes,
        samples,
        [_closed(polygon) for item in outlines for polygon in _polygons(item)],
        hole,
        translate("engagement angle, degrees"),
        largest=1.15 * target_deg if target_deg else None,
        walls=translate("part"),
    )


def _draw_rest(axes, simulation, stock, part):
    for region, _ in stock:
        for polygon in _polygons(region):
            axes.plot(
                *zip(*_closed(polygon)), color=path_picture.WALL_COLOUR, linewidth=1.2, zorder=3
            )
    _fill_part(axes, part)
    _draw_way(axes, simulation)
    for number, outline in enumerate(simulation.rest_outlines):
        label = translate("rest") if number == 0 else None
        points = numpy.array(outline)
        # Edges in the same colour: the tiles of one patch show no seams.
        axes.fill(*points.T, color=REST_COLOUR, lw=0.6, zorder=5, label=label)
    for area, x, y, _ in sorted(simulation.rests, reverse=True)[:MOST_LABELS]:
        axes.annotate(
            units.AREA.shown.told(area),
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
                label="%s (%d)" % (translate(label), len(places)),
            )
    seen_from_above(axes)
    if not simulation.incidents and not len(simulation.rest_outlines):
        axes.plot([], [], " ", label=translate("no rest, no incidents"))
    legend_below(axes, columns=3)


def _fill_part(axes, part):
    """The part's prisms, the lowest first, in a darker colour the higher they are."""
    colours = LinearSegmentedColormap.from_list("part", PART_COLOURS)
    size = units.LENGTH.shown.size
    tops = sorted({round(top, 4) for _, top in part})
    for item, top in sorted(part, key=lambda prism: prism[1]):
        loops = [Path(_closed(polygon), closed=True) for polygon in _polygons(item)]
        rank = tops.index(round(top, 4))
        label = translate("part, top at z = %g") % (tops[rank] / size)
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
    points = numpy.column_stack([simulation.x, simulation.y])
    pieces = numpy.stack([points[:-1], points[1:]], axis=1)
    kept = numpy.asarray(simulation.kind)[1:] != planar.RAPID
    many = len(points) > path_picture.MOST_VECTORS
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
