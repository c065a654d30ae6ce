"""Load and force of a Simulation over time, drawn into axes."""

import numpy

from evenload import planar, units
from evenload.pictures.path_picture import ENTRY_COLOUR, LINK_COLOUR
from evenload.translation import translate

LOAD_COLOUR, LIMIT_COLOUR, PEAK_COLOUR = "#1a73e8", "#d93025", "#e8710a"
KINDS = (
    (planar.CUT, "cuts", LOAD_COLOUR),
    (planar.ENTRY, "entries", ENTRY_COLOUR),
    (planar.LINK, "links", LINK_COLOUR),
    (planar.RAPID, "rapids", "#dadce0"),
)
COLUMNS = 1200  # of a plot over time: more samples are drawn as their least, mean and largest


def draw_load(upper, lower, simulation, target_deg, nominal_rate):
    time = simulation.time_s
    draw_band(upper, time, simulation.engagement_deg)
    upper.set_ylabel(translate("engagement, degrees"))
    draw_limit(upper, target_deg, translate("target %.4g\u00b0"))
    draw_kinds(upper, time, simulation.kind)
    unit = units.LARGE_RATE.shown
    draw_band(lower, time, numpy.asarray(simulation.removal_rate) / unit.size)
    lower.set_ylabel(translate("removal rate, %s") % unit.name)
    nominal = translate("nominal %s") % ("%.4g " + unit.name)
    draw_limit(lower, nominal_rate / unit.size if nominal_rate else None, nominal)
    for axes in (upper, lower):
        dress(axes, time)
    upper.tick_params(labelbottom=False)
    lower.set_xlabel(translate("time, s"))
    _legend_above(upper)
    if nominal_rate:
        _legend_above(lower)


def draw_force(axes, simulation, reference):
    time, peak, mean = simulation.time_s, translate("peak"), translate("mean of a revolution")
    draw_band(axes, time, simulation.force_peak, colour=PEAK_COLOUR, label=peak)
    draw_band(axes, time, simulation.force_mean, label=mean)
    draw_limit(axes, reference, translate("reference %.4g N"))
    dress(axes, time)
    axes.set_ylabel(translate("force in XY, N"))
    axes.set_xlabel(translate("time, s"))
    _legend_above(axes)


def dress(axes, time):
    """The ends of the axes and their grid."""
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


def draw_limit(axes, value, words):
    """A line at a value, if there is one; words: with a place for it."""
    if value:
        axes.axhline(
            value, color=LIMIT_COLOUR, linestyle="--", lw=1.1, label=words % value, zorder=4
        )
        axes.set_ylim(top=max(axes.get_ylim()[1], 1.12 * value))


def draw_band(axes, time, values, colour=LOAD_COLOUR, label=None):
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


def draw_kinds(axes, time, kind):
    """A strip at the foot of the axes that tells what kind of move it is."""
    time, kind = numpy.asarray(time), numpy.asarray(kind)
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
            place = -1.6 * height, height
            words = translate(label)
            axes.broken_barh(spans, place, facecolors=colour, linewidth=0, label=words)
    axes.set_ylim(bottom=-2.0 * height)
