"""What all pictures share: a figure of its own, its file, axes in mm."""

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import ScaledTranslation

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
    """Both axes in mm and to one scale."""
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
