"""Pictures of an operation's stability chart, by matplotlib; no display is needed."""

from evenload import units
from evenload.pictures.figure import new_figure, tell_lengths
from evenload.pictures.figure import save as save_figure
from evenload.stability import field
from evenload.translation import translate

EDGE, GREY = "#d93025", "#9aa0a6"
TINT = 0.12  # of the unstable area by the colour of its edge, on any ground
STABLE_POINT, UNSTABLE_POINT = "#188038", "#d93025"
SPEEDS = 0.5, 1.8  # of the operation's, that a chart shows
DEPTHS = 2.5  # times the operation's
SIZE = 9, 5.5  # inches


def box_of(cut):
    """((low, high) in rev/min, (low, high) in mm) of the chart that shows a Cut."""
    low, high = SPEEDS[0] * cut.speed, SPEEDS[1] * cut.speed
    low, high = max(low, cut.speeds[0]), min(high, cut.speeds[1])
    if not low < high:
        low, high = SPEEDS[0] * cut.speed, SPEEDS[1] * cut.speed
    return (low, high), (0.005 * cut.depth, DEPTHS * cut.depth)


def draw(axes, found, cut=None, is_stable=None):
    """A Field in matplotlib's axes, and the point of the operation in it."""
    if found.radii.max() >= 1:
        levels = (1, max(2.0, 1.001 * found.radii.max()))
        axes.contourf(
            *(found.speeds, found.depths, found.radii),
            levels=levels,
            colors=[EDGE],
            alpha=TINT,
        )
        axes.contour(
            *(found.speeds, found.depths, found.radii),
            levels=[1],
            colors=[EDGE],
            linewidths=1.4,
        )
    axes.set_xlim(found.speeds[0], found.speeds[-1])
    axes.set_ylim(0, found.depths[-1])
    axes.set_xlabel(translate("spindle speed, rev/min"))
    tell_lengths(axes.yaxis, translate("axial depth, %s"))
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.set_axisbelow(True)
    if cut is not None:
        colour = STABLE_POINT if is_stable else UNSTABLE_POINT
        axes.plot(cut.speed, cut.depth, "o", color=colour, markersize=9, zorder=9)


def save(cut, verdict, path):
    """Draws the chart of a Cut with its Verdict into a PNG or SVG file."""
    *_, found = field.levels(cut, *box_of(cut))
    figure = new_figure(*SIZE, layout="constrained")
    axes = figure.add_subplot()
    draw(axes, found, cut, verdict.is_stable)
    axes.set_title(cut.label, loc="left")
    sentence = units.in_users_unit(verdict.sentence)
    figure.text(0.01, 0.005, sentence, fontsize=8, color="#3c4043", wrap=True)
    figure.get_layout_engine().set(rect=(0, 0.05, 1, 0.95))
    save_figure(figure, path)
