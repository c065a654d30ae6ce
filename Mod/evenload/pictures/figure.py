"""What all pictures share: a figure of its own, its file, axes of lengths."""

import matplotlib
import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import AutoLocator, FuncFormatter
from matplotlib.transforms import ScaledTranslation

from evenload import units

LABEL_HEIGHT = 0.5  # inches that an axis' numbers and label take


def new_figure(width, height, **options):
    """An empty figure; inches."""
    # Not pyplot: FreeCAD's own plots keep their backend.
    figure = Figure(figsize=(width, height), dpi=150, **options)
    FigureCanvasAgg(figure)
    return figure


def save(figure, path):
    """Writes a figure as SVG where the name ends so, else as PNG; nothing is added to the name."""
    is_svg = str(path).lower().endswith(".svg")
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": "EvenLoad"}):
        if is_svg:
            figure.savefig(path, format="svg", metadata={"Date": None})
        else:
            figure.savefig(path, format="png")


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
