"""Engagement, removal rate and force of one or two simulations over time, on one scale.

A row of axes for each of them, a column for each simulation. Times in s.
"""

from dataclasses import dataclass

import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.transforms import ScaledTranslation

from evenload import units
from evenload.pictures import over_time
from evenload.pictures.figure import new_figure
from evenload.planar import CUT, LINK
from evenload.translation import translate
from evenload.words import ends_of

MARGINS = 0.5, 0.12, 0.42, 0.66  # inches: left, right, top, bottom
BETWEEN = 0.5, 0.24  # inches between columns, between rows, each of which has its label above it
LETTERS, LINE = 8, 1.2  # points, and a line's height in letters
BOLD = 0.72  # the width of bold letters in their size, on average of wide words
POINTS = 72  # per inch
HEADROOM = 1.08  # over the largest value or limit
SIZE = 10, 7  # inches, of a picture in a file; wider with two simulations
ABOVE = 3  # points between axes and the label above them


@dataclass(frozen=True)
class Row:
    """One thing that is plotted."""

    key: str  # the Simulation's attribute
    title: str  # with a place for the unit
    quantity: units.Quantity
    # Of these the scale is made: entries meet material all round.
    kinds: tuple = (CUT, LINK)


ROWS = (
    Row("engagement_deg", "Engagement, %s", units.ANGLE),
    Row("removal_rate", "Removal rate, %s", units.LARGE_RATE),
    Row("force_peak", "Peak force, %s", units.FORCE),
)


@dataclass(frozen=True)
class Run:
    """A simulation of an operation, by its name."""

    name: str
    simulation: object

    @property
    def time(self):
        """s for each sample: on the machine where there is one, else at the programmed feeds."""
        found = self.simulation
        return found.time_s if found.machine_time_s is None else found.machine_time_s


def whole(runs):
    """(0, end) of the longest of the simulations, in s."""
    return 0.0, max([1e-9, *(float(run.time[-1]) for run in runs if len(run.time))])


def picture(runs, limits, span=None):
    """A figure of its own with the plots; see `draw`."""
    width, height = SIZE
    figure = new_figure(width * (1.0 if len(runs) < 2 else 1.6), height)
    draw(figure, runs, limits, span)
    return figure


def draw(figure, runs, limits, span=None):
    """Draws Runs into an empty figure; returns the axes, [[one for each row] for each run].

    limits: {a row's key: its limit in the simulation's unit, or None}; span: (from, to) in s that
    is shown of each, None for all.
    """
    span = span or whole(runs)
    tops = [_top(row, runs, limits.get(row.key)) for row in ROWS]
    columns = []
    for number, run in enumerate(runs):
        axes = [figure.add_axes(_box(figure, k, number, len(runs))) for k in range(len(ROWS))]
        for row, each, top in zip(ROWS, axes, tops):
            _draw_row(each, row, run, limits.get(row.key), span, top)
            each.tick_params(labelsize=LETTERS, labelbottom=row is ROWS[-1])
        _draw_name(axes[0], run.name)
        axes[-1].set_xlabel(
            (
                translate("time, s")
                if run.simulation.machine_time_s is None
                else translate("time on the machine, s")
            ),
            fontsize=LETTERS,
        )
        columns.append(axes)
    _draw_legend(figure, any(limits.get(row.key) for row in ROWS))
    return columns


def _box(figure, row, column, columns):
    """(left, bottom, width, height) of axes, in shares of the figure."""
    width, height = figure.get_size_inches()
    left, right, top, bottom = MARGINS
    beside, below = BETWEEN
    wide = (width - left - right - (columns - 1) * beside) / columns
    high = (height - top - bottom - (len(ROWS) - 1) * below) / len(ROWS)
    x = left + column * (wide + beside)
    y = bottom + (len(ROWS) - 1 - row) * (high + below)
    return x / width, y / height, max(wide, 0.1) / width, max(high, 0.1) / height


def _top(row, runs, limit):
    """The upper end of a row's scale, the same for all runs."""
    size = row.quantity.shown.size
    largest = [0.0 if limit is None else limit / size]
    for run in runs:
        values = getattr(run.simulation, row.key)
        if values is None:
            continue
        counted = values[numpy.isin(run.simulation.kind, row.kinds)]
        counted = counted[numpy.isfinite(counted)]
        largest += [float(counted.max()) / size] if len(counted) else []
    return HEADROOM * max(largest) or 1.0


def _draw_row(axes, row, run, limit, span, top):
    seen = _seen(run.time, span)
    time, values = run.time[seen], getattr(run.simulation, row.key)
    unit = row.quantity.shown
    _draw_label(axes, translate(row.title) % unit.name)
    if values is None:
        words = translate("no material, no force")
        axes.text(0.5, 0.5, words, ha="center", transform=axes.transAxes, fontsize=LETTERS)
    elif len(time):
        over_time.draw_band(axes, time, values[seen] / unit.size)
    over_time.draw_limit(axes, limit and limit / unit.size, "%.4g")
    axes.set_ylim(0, top)
    if row is ROWS[0]:
        over_time.draw_kinds(axes, time, run.simulation.kind[seen])
    over_time.dress(axes, time)
    axes.set_xlim(*span)


def _draw_label(axes, words):
    """What a row tells, above its left end: beside it, upright, long words need more than its
    height.
    """
    above = ScaledTranslation(0, ABOVE / POINTS, axes.figure.dpi_scale_trans)
    axes.set_ylabel(words, rotation="horizontal", ha="left", va="bottom", fontsize=LETTERS)
    axes.yaxis.set_label_coords(0, 1, transform=axes.transAxes + above)


def _draw_name(axes, name):
    """The name of a run over the label of its first row, as far as there is room above the axes."""
    pad, letters = 2 * ABOVE + LINE * LETTERS, LETTERS + 1
    width = axes.get_position().width * axes.figure.get_figwidth() * POINTS
    shown = ends_of(name, max(3, int(width / (BOLD * letters))))
    axes.set_title(shown, loc="left", pad=pad, fontsize=letters, fontweight="bold")


def _seen(time, span):
    """The slice of samples in a span, with one more on each side so that lines go on."""
    first = numpy.searchsorted(time, span[0], side="left") - 1
    last = numpy.searchsorted(time, span[1], side="right") + 1
    return slice(max(0, int(first)), int(last))


def _draw_legend(figure, has_limits):
    signs = [Patch(color=colour, label=translate(label)) for _, label, colour in over_time.KINDS]
    if has_limits:
        words = translate("limit")
        line = Line2D([], [], color=over_time.LIMIT_COLOUR, linestyle="--", label=words)
        signs.append(line)
    close = {"handlelength": 1.2, "handletextpad": 0.4, "columnspacing": 1.0}  # for long words
    figure.legend(
        handles=signs,
        loc="lower center",
        ncol=len(signs),
        frameon=False,
        fontsize=LETTERS,
        **close,
    )
