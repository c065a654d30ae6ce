"""Pictures of a path seen from above, coloured by what its cuts are worth."""

import math
import re

from matplotlib.collections import LineCollection
from matplotlib.patches import Circle

from evenload import compiled, planar
from evenload.pictures.figure import legend_below, new_figure, save, seen_from_above
from evenload.translation import translate

PROFILE_GAP = (
    0.35  # mm: points of the core's profile further apart than this have a retract between
)
ARC_STEP = math.radians(5)  # of pictures: arcs are drawn as chords over this angle
LINK_COLOUR, ENTRY_COLOUR, WALL_COLOUR = "#9aa0a6", "#7b3fa0", "#202124"
START_COLOUR = "#188038"
MOST_VECTORS = 20000  # samples: longer paths are pixels in an SVG, too


def picture(op, path):
    """Draws the lowest level of each depth of an operation's last path, coloured by engagement,
    into a PNG or SVG file.

    Raises ValueError for an operation that has not been computed since its document was opened.
    """
    last = op.Proxy.last
    if last is None:
        raise ValueError("%s has no path to draw: recompute it first." % op.Label)
    samples = []
    for cut in last.cuts:
        samples += compiled.core().engagement_profile(
            cut.material, cut.toolpath, last.tool.diameter, hole=last.hole
        )
    chains = [c for floor in last.floors for c in (floor.outer, *floor.islands)]
    title = "%s: %d s" % (op.Label, round(op.CuttingTime))
    if op.IdealTime > 0:
        title += translate(", %.2f of the ideal") % (op.CuttingTime / op.IdealTime)
    draw(
        path,
        samples,
        [outline(chain) for chain in chains],
        last.hole,
        title,
        translate("engagement angle, degrees"),
        largest=1.15 * op.EngagementAngle.Value,
        gap=PROFILE_GAP,
    )


def outline(chain):
    """[(x, y), ...] of a closed chain of (x, y, bulge, ...), arcs as short chords."""
    points = [(x, y) for x, y in planar.flattened(chain)]
    return points + points[:1]


def samples_of_moves(moves):
    """[(x, y, feed in mm/min, kind), ...] along moves as the core returns them, for `draw`."""
    samples, x, y = [], None, None
    for kind, nx, ny, _, sweep, cx, cy, feed in moves:
        ends = _arc(x, y, cx, cy, sweep) if sweep and x is not None else [(nx, ny)]
        samples += [(u, v, feed, kind) for u, v in ends]
        x, y = nx, ny
    return samples


def samples_of_gcode(text):
    """[(x, y, feed in mm/min, kind), ...] along G-code (G0 to G3, absolute, mm, I and J relative to
    the start); every feed move counts as a cut.
    """
    samples, x, y, feed, mode = [], None, None, 0.0, None
    for line in text.splitlines():
        words = _words(line)
        for letter, value in words:
            if letter == "G" and value in (0, 1, 2, 3):
                mode = int(value)
        at = dict(words)
        feed = at.get("F", feed)
        nx, ny = at.get("X", x), at.get("Y", y)
        if mode is None or not {"X", "Y", "I", "J"} & set(at):
            continue
        if mode in (2, 3) and x is not None:
            i, j = at.get("I", 0.0), at.get("J", 0.0)
            sweep = planar.sweep_of(nx - x, ny - y, i, j, mode == 3)
            ends = _arc(x, y, x + i, y + j, sweep)
        else:
            ends = [(nx, ny)]
        kind = planar.CUT if mode else planar.RAPID
        samples += [(u, v, feed if mode else 0.0, kind) for u, v in ends if None not in (u, v)]
        x, y = nx, ny
    return samples


def _words(line):
    line = re.sub(r"\(.*?\)|;.*", "", line).upper()
    return [(a, float(b)) for a, b in re.findall(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))", line)]


def _arc(x, y, cx, cy, sweep):
    radius, start = math.hypot(x - cx, y - cy), math.atan2(y - cy, x - cx)
    steps = max(1, math.ceil(abs(sweep) / ARC_STEP))
    angles = [start + sweep * k / steps for k in range(1, steps + 1)]
    return [(cx + radius * math.cos(a), cy + radius * math.sin(a)) for a in angles]


def draw(path, samples, outlines, hole, title, meaning, largest=None, gap=None):
    """Draws samples into a PNG or SVG file, as `save` has it; see `draw_path`."""
    figure = new_figure(9, 8)
    axes = figure.add_subplot()
    draw_path(axes, samples, outlines, hole, meaning, largest, gap)
    axes.set_title(title)
    figure.tight_layout()
    save(figure, path)


def draw_path(axes, samples, outlines, hole, meaning, largest=None, gap=None, walls=None):
    """Draws samples (x, y, value, kind): cuts coloured by value, the rest by kind.

    outlines: lists of (x, y), black, and `walls` what they are, a pocket by default; hole:
    (x, y, diameter) or None; meaning: of the value; largest: value at the colours' end, by default
    the largest there is; gap: samples further apart than this are joined as rapids are. mm.
    """
    for line in outlines:
        axes.plot(*zip(*line), color=WALL_COLOUR, linewidth=1.6, zorder=4)
    pieces = {kind: ([], []) for kind in range(4)}
    for before, after in zip(samples, samples[1:]):
        jump = gap is not None and math.dist(before[:2], after[:2]) > gap
        lines, values = pieces[planar.RAPID if jump else after[3]]
        if before[:2] != after[:2]:
            lines.append((before[:2], after[:2]))
            values.append(0.5 * (before[2] + after[2]) if before[3] == after[3] else after[2])
    many = len(samples) > MOST_VECTORS
    lines, values = pieces[planar.CUT]
    cuts = LineCollection(
        lines, array=values, cmap="turbo", linewidths=1.1, zorder=3, rasterized=many
    )
    cuts.set_clim(0, largest or max(values, default=1.0))
    axes.add_collection(cuts)
    axes.figure.colorbar(cuts, ax=axes, label=meaning, shrink=0.8)
    for kind, colour, label, style in (
        (planar.LINK, LINK_COLOUR, translate("links"), "-"),
        (planar.ENTRY, ENTRY_COLOUR, translate("entry"), "-"),
        (planar.RAPID, LINK_COLOUR, translate("rapids"), ":"),
    ):
        lines = pieces[kind][0]
        if lines:
            axes.add_collection(
                LineCollection(
                    lines,
                    colors=colour,
                    linewidths=0.7,
                    linestyles=style,
                    label=label,
                    rasterized=many,
                )
            )
    if hole:
        axes.add_patch(
            Circle(
                hole[:2],
                hole[2] / 2,
                fill=False,
                linestyle="--",
                color=WALL_COLOUR,
                label=translate("hole"),
            )
        )
    first = next((s for s in samples if s[3] != planar.RAPID), None)
    if first:
        axes.plot(
            *first[:2], "o", color=START_COLOUR, markersize=7, zorder=5, label=translate("start")
        )
    if outlines:
        axes.plot([], [], color=WALL_COLOUR, linewidth=1.6, label=walls or translate("pocket"))
    seen_from_above(axes)
    legend_below(axes)
