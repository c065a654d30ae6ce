"""Figures of an operation as a dictionary and a table, and pictures of its path."""

import math

from evenload import planar

# (key, property, unit, decimals) in the table's order
FIGURES = (
    ("engagement_deg", "EngagementAngle", "deg", 1),
    ("max_engagement_deg", "MaxEngagement", "deg", 1),
    ("cutting_time_s", "CuttingTime", "s", 1),
    ("ideal_time_s", "IdealTime", "s", 1),
    ("time_ratio", None, "", 2),
    ("removed_volume_mm3", "RemovedVolume", "mm3", 0),
    ("uncut_area_mm2", "UncutArea", "mm2", 2),
    ("cut_length_mm", None, "mm", 0),
    ("link_length_mm", None, "mm", 0),
    ("passes", "Passes", "", 0),
    ("links", "Links", "", 0),
    ("retracts", "Retracts", "", 0),
    ("blocks", None, "", 0),
)
# (key, attribute of a Simulation, unit, decimals) of the rows that follow where there is one
SIMULATED = (
    ("simulated_engagement_deg", "max_engagement_deg", "deg", 1),
    ("simulated_entry_engagement_deg", "entry_engagement_deg", "deg", 1),
    ("simulated_removal_rate_mm3_min", "removal_rate_peak", "mm3/min", 0),
    ("simulated_removed_volume_mm3", "removed_volume_total", "mm3", 0),
    ("simulated_time_s", "time_total_s", "s", 1),
    ("simulated_machine_time_s", "machine_time_total_s", "s", 1),
    ("simulated_rest_area_mm2", "rest_area", "mm2", 2),
    ("simulated_gouge_mm", "gouge_mm", "mm", 3),
    ("simulated_fixture_mm", "fixture_mm", "mm", 3),
    ("simulated_rapid_in_material_mm", "rapid_in_material_mm", "mm", 2),
    ("simulated_plunge_in_material_mm", "plunge_in_material_mm", "mm", 2),
    ("simulated_air_mm", "air_mm", "mm", 0),
    ("simulated_force_n", "force_peak_max", "N", 0),
)
MOST_PLACES = 3  # of incidents that are named one by one
LABELS = {
    "engagement_deg": "engagement, target",
    "max_engagement_deg": "engagement, largest",
    "cutting_time_s": "time",
    "ideal_time_s": "time, ideal",
    "time_ratio": "time / ideal",
    "removed_volume_mm3": "removed volume",
    "uncut_area_mm2": "area left",
    "cut_length_mm": "length of cuts",
    "link_length_mm": "length of links",
    "passes": "passes",
    "links": "links",
    "retracts": "retracts",
    "blocks": "G-code blocks",
    "simulated_engagement_deg": "simulated: engagement",
    "simulated_entry_engagement_deg": "  entry's engagement",
    "simulated_removal_rate_mm3_min": "  removal rate, largest",
    "simulated_removed_volume_mm3": "  removed volume",
    "simulated_time_s": "  time",
    "simulated_machine_time_s": "  time on the machine",
    "simulated_rest_area_mm2": "  area left",
    "simulated_gouge_mm": "  gouge",
    "simulated_fixture_mm": "  into fixtures",
    "simulated_rapid_in_material_mm": "  rapids in material",
    "simulated_plunge_in_material_mm": "  plunges in material",
    "simulated_air_mm": "  cuts in air",
    "simulated_force_n": "  force, largest",
}
PROFILE_GAP = (
    0.35  # mm: points of the core's profile further apart than this have a retract between
)
ARC_STEP = math.radians(5)  # of pictures: arcs are drawn as chords over this angle
LINK_COLOUR, ENTRY_COLOUR, WALL_COLOUR = "#9aa0a6", "#7b3fa0", "#202124"
START_COLOUR = "#188038"
LABEL_HEIGHT = 0.5  # inches that an axis' numbers and label take
MOST_VECTORS = 20000  # samples: longer paths are pixels in an SVG, too


def figures(op):
    """What an operation reports: {key: number}, units in the keys, and 'report', its text."""
    result = {}
    for key, prop, _, _ in FIGURES:
        if prop:
            value = getattr(op, prop)
            result[key] = float(getattr(value, "Value", value))
    if result["ideal_time_s"] > 0:
        result["time_ratio"] = result["cutting_time_s"] / result["ideal_time_s"]
    last = op.Proxy.last
    if last is not None:
        report = last.toolpath.report
        result["cut_length_mm"], result["link_length_mm"] = report.cut_length, report.link_length
    for key in ("passes", "links", "retracts"):
        result[key] = int(result[key])
    result["blocks"] = len(op.Path.Commands)
    result["report"] = op.Report
    return result


def simulated(simulation):
    """What a Simulation reports: {key: number}, units in the keys, and 'simulation', its notes and
    the places where something is wrong. What it has not got is left out.
    """
    result = {}
    for key, attribute, _, _ in SIMULATED:
        value = getattr(simulation, attribute)
        if value is not None:
            result[key] = float(value)
    result["simulation"] = "\n".join([*simulation.notes, *_incidents(simulation)])
    return result


def _incidents(simulation):
    """A sentence for each kind of incident, and one for what is left."""
    found = {}
    for what, x, y, z, *_ in simulation.incidents:
        found.setdefault(what, []).append("(%.3f, %.3f, %.3f)" % (x, y, z))
    sentences = []
    for what, places in found.items():
        more = " and %d more" % (len(places) - MOST_PLACES) if len(places) > MOST_PLACES else ""
        named = ", ".join(places[:MOST_PLACES])
        sentences.append("Simulated: %s near %s%s." % (what, named, more))
    if simulation.rests:
        area, x, y, depth = max(simulation.rests)
        sentences.append(
            "Simulated: %d places left; the largest has %.2f mm2, %.3f mm deep, near (%.3f, %.3f)."
            % (len(simulation.rests), area, depth, x, y)
        )
    return sentences


def table(jobs):
    """A table of jobs as in a batch's report: a column of figures each, then what they report."""
    done = [job for job in jobs if job["ok"]]
    lines = []
    if done:
        left = max(len(label) for label in LABELS.values())
        widths = [max(10, len(job["name"])) for job in done]
        rows = [*FIGURES]
        rows += [row for row in SIMULATED if any(row[0] in job["figures"] for job in done)]
        wide = max(len(unit) for _, _, unit, _ in rows)
        head = " " * (left + wide + 1)
        lines.append(head + "".join("  " + j["name"].rjust(w) for j, w in zip(done, widths)))
        for key, _, unit, decimals in rows:
            cells = []
            for job, width in zip(done, widths):
                value = job["figures"].get(key)
                cells.append(
                    "  " + ("%.*f" % (decimals, value) if value is not None else "-").rjust(width)
                )
            lines.append(LABELS[key].ljust(left) + " " + unit.ljust(wide) + "".join(cells))
        for job in done:
            for text in (job["figures"]["report"], job["figures"].get("simulation", "")):
                lines += ["%s: %s" % (job["name"], line) for line in text.splitlines()]
    lines += ["%s FAILED: %s" % (job["name"], job["error"]) for job in jobs if not job["ok"]]
    return "\n".join(lines)


def picture(op, path):
    """Draws the lowest level of an operation's last path, coloured by engagement, into a PNG or SVG
    file.

    Raises ValueError for an operation that has not been computed since its document was opened.
    """
    from evenload import compiled

    last = op.Proxy.last
    if last is None:
        raise ValueError("%s has no path to draw: recompute it first." % op.Label)
    samples = compiled.core().engagement_profile(
        last.material, last.toolpath, last.tool.diameter, hole=last.hole
    )
    chains = [c for floor in last.floors for c in (floor.outer, *floor.islands)]
    ratio = figures(op).get("time_ratio")
    title = "%s: %d s" % (op.Label, round(op.CuttingTime))
    if ratio:
        title += ", %.2f of the ideal" % ratio
    draw(
        path,
        samples,
        [outline(chain) for chain in chains],
        last.hole,
        title,
        "engagement angle, degrees",
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
    import re

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


def new_figure(width, height, **options):
    """An empty figure; inches."""
    # Not pyplot: FreeCAD's own plots keep their backend.
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), dpi=150, **options)
    FigureCanvasAgg(figure)
    return figure


def save(figure, path):
    """Writes a figure as SVG where the name ends so, else as PNG; nothing is added to the name."""
    import matplotlib

    is_svg = str(path).lower().endswith(".svg")
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": "EvenLoad"}):
        if is_svg:
            figure.savefig(path, format="svg", metadata={"Date": None})
        else:
            figure.savefig(path, format="png")


def draw_path(axes, samples, outlines, hole, meaning, largest=None, gap=None, walls="pocket"):
    """Draws samples (x, y, value, kind): cuts coloured by value, the rest by kind.

    outlines: lists of (x, y), black, and `walls` what they are; hole: (x, y, diameter) or None;
    meaning: of the value; largest: value at the colours' end, by default the largest there is; gap:
    samples further apart than this are joined as rapids are. mm.
    """
    from matplotlib.collections import LineCollection

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
        (planar.LINK, LINK_COLOUR, "links", "-"),
        (planar.ENTRY, ENTRY_COLOUR, "entry", "-"),
        (planar.RAPID, LINK_COLOUR, "rapids", ":"),
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
        from matplotlib.patches import Circle

        axes.add_patch(
            Circle(
                hole[:2], hole[2] / 2, fill=False, linestyle="--", color=WALL_COLOUR, label="hole"
            )
        )
    first = next((s for s in samples if s[3] != planar.RAPID), None)
    if first:
        axes.plot(*first[:2], "o", color=START_COLOUR, markersize=7, zorder=5, label="start")
    if outlines:
        axes.plot([], [], color=WALL_COLOUR, linewidth=1.6, label=walls)
    seen_from_above(axes)
    legend_below(axes)


def legend_below(axes, columns=6):
    """Under the axes' label, however high the axes are: it hides nothing there."""
    from matplotlib.transforms import ScaledTranslation

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
