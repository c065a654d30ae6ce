"""What all pictures share: a figure of its own, its file, axes of lengths.

Pictures are drawn in several threads, and FreeCAD's own plots beside them: whatever is drawn has
its sizes itself, for matplotlib's settings are everyone's.
"""

import contextlib
import threading
from dataclasses import dataclass

import matplotlib
import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import AutoLocator, FuncFormatter
from matplotlib.transforms import ScaledTranslation

from evenload import units

LABEL_HEIGHT = 0.5  # inches that an axis' numbers and label take
SVG = {"svg.fonttype": "none", "svg.hashsalt": "EvenLoad"}
_writing_svg = threading.Lock()


@dataclass(frozen=True)
class Ground:
    """The colours of paper, of what is written on it, and of the grid behind what is drawn."""

    paper: str
    ink: str
    grid: str


LIGHT = Ground("#ffffff", "#000000", "#e8eaed")  # of all files
DARK = Ground("#2b2c2e", "#e8eaed", "#44474b")  # of charts in a window whose theme is dark


def new_figure(width, height, **options):
    """An empty figure; inches."""
    # Not pyplot: FreeCAD's own plots keep their backend.
    figure = Figure(figsize=(width, height), dpi=150, **options)
    FigureCanvasAgg(figure)
    return figure


def put_on(figure, ground):
    """Has all that is drawn by now stand on a Ground; the colours of values stay."""
    figure.set_facecolor(ground.paper)
    for axes in figure.axes:
        axes.set_facecolor(ground.paper)
        axes.tick_params(color=ground.ink, labelcolor=ground.ink, grid_color=ground.grid)
        for spine in axes.spines.values():
            spine.set_edgecolor(ground.ink)
    for words in figure.findobj(Text):
        words.set_color(ground.ink)


def save(figure, path):
    """Writes a figure as SVG where the name ends so, else as PNG; nothing is added to the name."""
    if str(path).lower().endswith(".svg"):
        with _svg_as_ours():
            figure.savefig(path, format="svg", metadata={"Date": None})
    else:
        figure.savefig(path, format="png")


@contextlib.contextmanager
def _svg_as_ours():
    """While this lasts SVGs have their texts as texts, and the same names each time. Matplotlib has
    these two settings for all figures alone; no other is touched, and nothing else reads them.
    """
    with _writing_svg:
        before = {key: matplotlib.rcParams[key] for key in SVG}
        matplotlib.rcParams.update(SVG)
        try:
            yield
        finally:
            matplotlib.rcParams.update(before)


def legend_below(axes, columns=6):
    """Under the axes' label, however high the axes are: it hides nothing there."""
    under_label = ScaledTranslation(0, -LABEL_HEIGHT, axes.figure.dpi_scale_trans)
    axes.legend(
        loc="upper center",
        bbox_to_anchor=(0.5, 0),
        bbox_transform=axes.transAxes + under_label,
        fontsize=8,
        frameon=False,
        ncols=columns,
    )


def seen_from_above(axes):
    """Both axes to one scale, values in mm."""
    axes.set_aspect("equal")
    axes.autoscale_view()
    tell_lengths(axes.xaxis, "x, %s")
    tell_lengths(axes.yaxis, "y, %s")


def tell_lengths(axis, label):
    """Has an axis of values in mm tell them in the unit that the user sees lengths in. label: with
    a place for the unit.
    """
    unit = units.LENGTH.shown
    axis.set_label_text(label % unit.name)
    if unit.size != 1.0:
        axis.set_major_locator(_Ticks(unit.size))
        axis.set_major_formatter(
            FuncFormatter(lambda value, _: "%g" % (round(value / unit.size, 6) + 0.0))
        )


class _Ticks(AutoLocator):
    """Ticks at even values in a unit, whose size is in the axis' own."""

    def __init__(self, size):
        super().__init__()
        self._size = size

    def tick_values(self, vmin, vmax):
        return self._size * numpy.asarray(super().tick_values(vmin / self._size, vmax / self._size))
