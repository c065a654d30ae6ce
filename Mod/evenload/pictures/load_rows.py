"""Engagement, removal rate and force of one or two simulations over time, on one scale.

A row of axes for each of them, a column for each simulation. Times in s.
"""

from dataclasses import dataclass

import matplotlib
import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from evenload import units
from evenload.pictures import over_time
from evenload.pictures.figure import new_figure
from evenload.planar import CUT, LINK
from evenload.translation import translate

MARGINS = 0.62, 0.12, 0.28, 0.66  # inches: left, right, top, bottom
BETWEEN = 0.62, 0.10  # inches between columns, between rows
LETTERS = 8  # points
HEADROOM = 1.08  # over the largest value or limit
SIZE = 10, 7  # inches, of a picture in a file; wider with two simulations
PLACE = 0.03  # where the title stands, of the axes' width


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
    Row("removal_rate", "Removal rate,\n%s", units.LARGE_RATE),
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
    with matplotlib.rc_context({"font.size": LETTERS}):
        columns = []
        for number, run in enumerate(runs):
            axes = [figure.add_axes(_box(figure, k, number, len(runs))) for k in range(len(ROWS))]
            for row, each, top in zip(ROWS, axes, tops):
                _draw_row(each, row, run, limits.get(row.key), span, top)
                each.tick_params(labelbottom=row is ROWS[-1])
            axes[0].set_title(run.name, loc="left", x=PLACE, fontsize=LETTERS + 1)
            axes[-1].set_xlabel(
                translate("time, s")
                if run.simulation.machine_time_s is None
                else translate("time on the machine, s")
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
    axes.set_ylabel(translate(row.title) % unit.name)
    if values is None:
        axes.text(
            0.5, 0.5, translate("no material, no force"), ha="center", transform=axes.transAxes
        )
    elif len(time):
        over_time.draw_band(axes, time, values[seen] / unit.size)
    over_time.draw_limit(axes, limit and limit / unit.size, "%.4g")
    axes.set_ylim(0, top)
    if row is ROWS[0]:
        over_time.draw_kinds(axes, time, run.simulation.kind[seen])
    over_time.dress(axes, time)
    axes.set_xlim(*span)


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
    figure.legend(handles=signs, loc="lower center", ncol=len(signs), frameon=False, **close)
