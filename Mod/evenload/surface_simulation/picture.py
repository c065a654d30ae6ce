"""Pictures of a surface that was simulated, seen from above, by matplotlib.

Made in FreeCAD's window they are in the user's units, else in mm and µm.
"""

import matplotlib
import numpy
from matplotlib.colors import ListedColormap, Normalize

from evenload import units
from evenload.pictures.figure import new_figure, seen_from_above, tell_lengths
from evenload.pictures.figure import save as save_figure

SIZE = 7.5, 6.2  # inches
ROUGH_SIZE = 7.5, 8.0
GROUND, BAD, BARE = "#d7dadd", "#d93025", "#f2c9a0"  # the part, gouges, what no pass has cut
COLOURS = "viridis"  # its lightness rises evenly: the picture can be read in grey
SHOWN_SHARE = 99.5  # % of the cells whose values the scale reaches: single corners may stand high
MICRONS = 1e3  # of a mm
LEAST_GOUGE = 1e-3  # mm: less is rounding
LEAST_SCALE = 1e-2  # of a scale's largest value, in what it tells


def save(simulation, path, what):
    """Draws one of WHAT into a PNG or SVG file; see SurfaceSimulation.picture."""
    if what not in WHAT:
        known = ", ".join("'%s'" % each for each in WHAT)
        raise ValueError("There is no picture of '%s': choose one of %s." % (what, known))
    save_figure(WHAT[what](simulation), path)


def _cusp(simulation):
    title = "no cusps"
    if simulation.max_cusp is not None:
        title = "cusps of %.2f µm, 95 %% below %.2f µm, the highest %.2f µm" % tuple(
            MICRONS * each
            for each in (simulation.mean_cusp, simulation.cusp_95, simulation.max_cusp)
        )
    if simulation.wish_share is not None:
        wish = 100 * simulation.wish_share, MICRONS * simulation.wish
        title += "\n%.0f %% within 10 %% of the wished %.2f µm" % wish
    return _map_of_heights(simulation, simulation.cusp, "cusp height", title)


def _rest(simulation):
    rest = numpy.where(simulation.is_covered, simulation.rest, numpy.nan)
    title = "%.1f mm² of %.1f mm² are not cut" % (
        simulation.uncovered_area,
        simulation.uncovered_area + simulation.covered_area,
    )
    return _map_of_heights(simulation, rest, "above the part", title)


def _gouge(simulation):
    at = simulation.gouge_at
    title = "the part is nowhere cut into by more than %g µm" % (MICRONS * LEAST_GOUGE)
    if at is not None:
        deepest = MICRONS * simulation.gouge_mm
        title = "the part is cut into by %.2f µm" % deepest
        title += ", at (%.2f, %.2f, %.2f)" % at
    values = simulation.gouge_anywhere
    figure, axes = _figure(simulation, title)
    _ground(simulation, axes, numpy.isfinite(values))
    shown, unit = numpy.where(values > LEAST_GOUGE, values, numpy.nan), units.ROUGHNESS.shown
    meaning = "below the part's surface, " + unit.name
    _colours(figure, axes, simulation, shown / unit.size, meaning, "Reds")
    if at is not None:
        axes.plot(*at[:2], "o", markerfacecolor="none", markeredgecolor=BAD, markersize=12)
    return figure


def _h_m(simulation):
    chips = simulation.chips
    title = "mean chip thickness h_m of %.2f µm ± %.2f µm" % (
        MICRONS * chips.mean_thickness.mean(),
        MICRONS * chips.mean_thickness.std(),
    )
    values = chips.on(simulation, chips.mean_thickness)
    return _map_of_heights(simulation, values, "mean chip thickness h_m", title)


def _tip_share(simulation):
    chips = simulation.chips
    title = "the tip cuts up to %.0f %% of a chip" % (100 * chips.tip_share.max())
    values = 100 * chips.on(simulation, chips.tip_share)
    return _map(simulation, values, "share of the chip that the tip cuts, %", title)


def _rz_along(simulation):
    return _rz(simulation, simulation.roughness_map.rz_along, "along")


def _rz_across(simulation):
    return _rz(simulation, simulation.roughness_map.rz_across, "across")


def _rz(simulation, values, way):
    title = "R_z %s the feed, %.2f µm on the mean, %.2f µm at the most" % (
        way,
        MICRONS * values.mean(),
        MICRONS * values.max(),
    )
    on_cells = simulation.roughness_map.on(simulation, values)
    return _map_of_heights(simulation, on_cells, "R_z %s the feed" % way, title)


def _roughness(simulation):
    patch = simulation.roughness()
    figure = new_figure(*ROUGH_SIZE, layout="constrained")
    title = (
        "at (%.2f, %.2f)\nalong the feed R_t %.2f µm, R_z %.2f µm; across it %.2f µm, %.2f µm"
        % (
            *patch.at,
            *(MICRONS * patch.rt_along, MICRONS * patch.rz_along),
            *(MICRONS * patch.rt_across, MICRONS * patch.rz_across),
        )
    )
    title = "%s %s" % (simulation.label, units.in_users_unit(title))
    figure.suptitle(title, fontsize=10)
    above, below = figure.subplots(2, 1, height_ratios=(3, 1))
    half = patch.resolution * (len(patch.heights) - 1) / 2
    unit = units.ROUGHNESS.shown
    heights = (patch.heights - numpy.nanmin(patch.heights)) / unit.size
    shown = above.imshow(heights, origin="lower", extent=(-half, half, -half, half), cmap=COLOURS)
    figure.colorbar(shown, ax=above, label="height, " + unit.name)
    tell_lengths(above.xaxis, "along the feed, %s")
    tell_lengths(above.yaxis, "across the feed, %s")
    places, middle = numpy.linspace(-half, half, len(heights)), len(heights) // 2
    below.plot(places, heights[middle], label="along the feed", color="#1a73e8")
    below.plot(places, heights[:, middle], label="across the feed", color="#b06000")
    tell_lengths(below.xaxis, "%s from the middle")
    below.set_ylabel("height, " + unit.name)
    below.legend(fontsize=8, frameon=False, loc="upper right")
    return figure


WHAT = {
    "cusp": _cusp,
    "gouge": _gouge,
    "rest": _rest,
    "roughness": _roughness,
    "h_m": _h_m,
    "tip share": _tip_share,
    "rz_along": _rz_along,
    "rz_across": _rz_across,
}


def _map_of_heights(simulation, values, meaning, title):
    """values: mm."""
    unit = units.ROUGHNESS.shown
    return _map(simulation, values / unit.size, "%s, %s" % (meaning, unit.name), title)


def _map(simulation, values, meaning, title):
    figure, axes = _figure(simulation, title)
    _ground(simulation, axes, simulation.is_covered)
    _colours(figure, axes, simulation, values, meaning, COLOURS)
    return figure


def _figure(simulation, title):
    figure = new_figure(*SIZE, layout="constrained")
    figure.suptitle("%s: %s" % (simulation.label, units.in_users_unit(title)), fontsize=10)
    axes = figure.subplots()
    seen_from_above(axes)
    return figure, axes


def _ground(simulation, axes, is_part):
    """What is known of each cell: part, and picked faces that no pass has cut."""
    kinds = numpy.where(is_part, 0.0, numpy.nan)
    kinds[simulation.is_picked & ~simulation.is_covered] = 1.0
    _image(axes, simulation, kinds, ListedColormap([GROUND, BARE]), Normalize(0, 1))


def _colours(figure, axes, simulation, values, meaning, colours):
    known = values[numpy.isfinite(values)]
    largest = numpy.percentile(known, SHOWN_SHARE) if len(known) else 0.0
    norm = Normalize(0, max(float(largest), LEAST_SCALE))
    shown = _image(axes, simulation, values, matplotlib.colormaps[colours], norm)
    figure.colorbar(shown, ax=axes, shrink=0.8, label=meaning, extend="max")


def _image(axes, simulation, values, colours, norm):
    half = simulation.resolution / 2
    x, y = simulation.x, simulation.y
    extent = x[0] - half, x[-1] + half, y[0] - half, y[-1] + half
    return axes.imshow(
        values, origin="lower", extent=extent, cmap=colours, norm=norm, interpolation="nearest"
    )
