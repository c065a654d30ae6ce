"""Makes the pictures of docs/ from paths that the built core computes.

    python3 docs/make_pictures.py [FOLDER]

FOLDER holds the module _core: a build tree, by default build/release of this checkout, or
Mod/evenload of an installed addon. Run it with the Python that the module was built for. Needs
numpy and matplotlib, no display and no FreeCAD.

What the tool removes is counted here on a grid of cells, so that the removal rates shown are not
the core's own opinion of them; the simulator's pictures show the simulator's own dexels and loads.
"""

import io
import math
import sys
from pathlib import Path

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Arc, Circle
from PIL import Image

DOCS = Path(__file__).resolve().parent
RAPID, LINK, ENTRY, CUT = range(4)
WALL_GAP = 8e-4  # mm, and the shares below: as in src/strategy
STAGE_RATIO, OPENING_RATIO = 0.9, 1.25
SHOWN_STAGES = 5  # every fifth, or they could not be told apart
STEP = 0.1  # mm along the path between two looks
INK, GROUND, STOCK = "#202124", "#ffffff", "#e3dccb"
BLUE, ORANGE, GREEN, RED, GREY, VIOLET = (
    "#1a73e8",
    "#e8710a",
    "#188038",
    "#d93025",
    "#80868b",
    "#7b3fa0",
)


# ---- pockets and paths ----


def star():
    """A star of five rounded points, tool 6 mm: the shape of the source's experiment."""
    tip, valley, bulge_tip, bulge_valley = (2.8696, 18.1081), (6.798, 10.1483), 0.6216, -0.2468
    chain = []
    for k in range(5):
        turn = 2 * math.pi * k / 5
        c, s = math.cos(turn), math.sin(turn)
        last = (math.cos(turn + 2 * math.pi / 5), math.sin(turn + 2 * math.pi / 5))
        for (x, y), bulge, (a, b) in (
            (tip, bulge_tip, (c, s)),
            ((-tip[0], tip[1]), 0.0, (c, s)),
            ((-valley[0], valley[1]), bulge_valley, (c, s)),
            (valley, 0.0, last),
        ):
            chain.append((a * x - b * y, b * x + a * y, bulge))
    return chain


def rectangle(width, height):
    return [(0, 0, 0), (width, 0, 0), (width, height, 0), (0, height, 0)]


class Job:
    """A pocket and the path that clears it: tool 6 mm, 60 degrees, one level of 3 mm."""

    diameter, radius, angle, depth, feed = 6.0, 3.0, math.radians(60), 3.0, 255.0
    wish = 1.0  # mm, turn radius

    def __init__(self, core, chain, hole=None, control="constant removal rate"):
        self.core, self.chain, self.hole = core, chain, hole
        self.region = core.Region(chain, [])
        self.path = core.clear_pocket(
            [self.region],
            tool_diameter=self.diameter,
            engagement_angle=self.angle,
            feed_control=control,
            feed=self.feed,
            plunge_feed=self.feed,
            link_feed=1500.0,
            maximum_feed=1000.0,
            roll_radius=self.wish,
            minimum_radius=0.15 * self.diameter,
            helix_diameter=0.9 * self.diameter,
            entry_point=hole and hole[:2],
            hole_diameter=hole[2] if hole else 0.0,
            levels=[-self.depth],
            safe_height=5.0,
            clearance_height=10.0,
        )

    @property
    def nominal_width(self):
        return self.radius * (1 - math.cos(self.angle))

    def centres(self):
        """Where the tool's centre may be."""
        return self.core.offset([self.region], -(self.radius + WALL_GAP))

    def stages(self, count):
        """[(turn radius, region of centres, region of turn centres)] of every fifth stage."""
        result, turn = [], self.wish
        while len(result) < count:
            opening = OPENING_RATIO * turn
            opened = self.core.offset(self.core.offset(self.centres(), -opening), opening)
            result.append((turn, opened, self.core.offset(opened, -turn)))
            turn *= STAGE_RATIO**SHOWN_STAGES
        return result

    def samples(self, step=STEP):
        """[(x, y, heading, kind, feed, length)] every `step` mm at the level."""
        result = []
        for before, after in zip(self.path.moves, self.path.moves[1:]):
            kind, x, y, z, sweep, cx, cy, feed = after
            ax, ay = before[1], before[2]
            if z > -self.depth + 1e-6:
                continue
            radius = math.hypot(ax - cx, ay - cy)
            length = abs(sweep) * radius if sweep else math.hypot(x - ax, y - ay)
            n = max(1, math.ceil(length / step))
            for k in range(1, n + 1):
                if length < 1e-9:
                    continue
                if sweep:
                    at = math.atan2(ay - cy, ax - cx) + sweep * k / n
                    place = (cx + radius * math.cos(at), cy + radius * math.sin(at))
                    heading = at + math.copysign(math.pi / 2, sweep)
                else:
                    place = (ax + (x - ax) * k / n, ay + (y - ay) * k / n)
                    heading = math.atan2(y - ay, x - ax)
                result.append((*place, heading, kind, feed, length / n))
        return result

    def stretches(self, step=STEP):
        """[(kind, [(x, y), ...])] of the moves at the level, cut where their kind changes."""
        return stretches(self.samples(step), step)


def stretches(samples, step=STEP):
    result, last = [], None
    for x, y, _, kind, _, _ in samples:
        gap = last is not None and math.dist(last, (x, y)) > 1.01 * step  # a retract
        if not result or result[-1][0] != kind or gap:
            result.append((kind, [last] if last and not gap else []))
        result[-1][1].append((x, y))
        last = (x, y)
    return result


class Grid:
    """Cells of a pocket that still hold material."""

    def __init__(self, job, cell):
        xs, ys = zip(*outline(job.chain))
        self.cell, self.low = cell, (min(xs) - 1, min(ys) - 1)
        self.x = numpy.arange(self.low[0] + cell / 2, max(xs) + 1, cell)
        self.y = numpy.arange(self.low[1] + cell / 2, max(ys) + 1, cell)
        from matplotlib.path import Path as Polygon

        points = numpy.stack(numpy.meshgrid(self.x, self.y), axis=-1)
        inside = Polygon(outline(job.chain)).contains_points(points.reshape(-1, 2))
        self.full = inside.reshape(len(self.y), len(self.x))
        if job.hole:
            self.take(job.hole[0], job.hole[1], job.hole[2] / 2)

    def take(self, x, y, radius):
        """Clears a disc; returns the area that held material, in mm2."""
        i0, i1 = numpy.searchsorted(self.x, (x - radius, x + radius))
        j0, j1 = numpy.searchsorted(self.y, (y - radius, y + radius))
        away = (self.x[None, i0:i1] - x) ** 2 + (self.y[j0:j1, None] - y) ** 2
        part = self.full[j0:j1, i0:i1]
        hit = part & (away <= radius * radius)
        part[hit] = False
        return numpy.count_nonzero(hit) * self.cell**2


# ---- drawing ----


def outline(chain):
    """[(x, y), ...] of a closed chain of (x, y, bulge, ...), arcs as short chords."""
    points = []
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        points.append((x0, y0))
        if bulge:
            sweep, k = 4 * math.atan(bulge), (1 - bulge * bulge) / (4 * bulge)
            cx, cy = (x0 + x1) / 2 - k * (y1 - y0), (y0 + y1) / 2 + k * (x1 - x0)
            start, radius = math.atan2(y0 - cy, x0 - cx), math.hypot(x0 - cx, y0 - cy)
            n = max(2, math.ceil(abs(sweep) / 0.05))
            points += [
                (
                    cx + radius * math.cos(start + sweep * k / n),
                    cy + radius * math.sin(start + sweep * k / n),
                )
                for k in range(1, n)
            ]
    return points + points[:1]


def canvas(width, height):
    figure = Figure(figsize=(width, height), dpi=110)
    FigureCanvasAgg(figure)
    return figure, figure.add_subplot()


def save(figure, name, note=None, fit=True, dpi="figure", **palette):
    if fit:
        figure.tight_layout()
    raw = io.BytesIO()
    figure.savefig(raw, format="png", dpi=dpi)
    image = Image.open(raw).convert("RGB").quantize(256, dither=Image.Dither.NONE, **palette)
    image.save(DOCS / name, optimize=True)
    size = (DOCS / name).stat().st_size / 1000
    print("%-14s %4d kB%s" % (name, size, "   " + note if note else ""))


def lines(axes, regions, **style):
    for region in regions:
        for chain in (region.outer, *region.islands):
            axes.plot(*zip(*outline(chain)), **style)
            style.pop("label", None)


def plan(axes, x=None, y=None):
    axes.set_aspect("equal")
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    if x:
        axes.set_xlim(*x)
        axes.set_ylim(*y)


def stock(axes, grid):
    """What still holds material, shaded."""
    axes.contourf(
        grid.x, grid.y, grid.full.astype(float), levels=(0.5, 1.5), colors=[STOCK], zorder=0
    )


def draw_star(core):
    job = Job(core, star(), hole=(0.0, 0.0, 11.0))
    profile = core.engagement_profile([job.region], job.path, job.diameter, hole=job.hole)
    figure, axes = canvas(8.2, 6.4)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8, label="pocket")
    axes.add_patch(Circle((0, 0), 5.5, fill=False, ls="--", color=INK, label="drilled hole"))
    cuts, values, links = [], [], []
    for a, b in zip(profile, profile[1:]):
        if math.dist(a[:2], b[:2]) > 0.35:
            continue  # a retract lies between
        if b[3] == CUT:
            cuts.append((a[:2], b[:2]))
            values.append(b[2])
        elif b[3] == LINK:
            links.append((a[:2], b[:2]))
    coloured = LineCollection(cuts, array=values, cmap="turbo", linewidths=1.5, zorder=3)
    coloured.set_clim(0, 70)
    axes.add_collection(coloured)
    axes.add_collection(LineCollection(links, colors=GREY, linewidths=0.8, label="link"))
    figure.colorbar(coloured, ax=axes, label="engagement angle, degrees (set: 60)", shrink=0.95)
    plan(axes)
    axes.legend(loc="upper right", fontsize=9)
    report = job.path.report
    save(
        figure,
        "star.png",
        "%.0f s, %.2f of the ideal; engagement at most %.1f; %d passes, %d links, %d retracts; "
        "left %.2f mm2"
        % (
            report.cutting_time,
            report.cutting_time / report.ideal_time,
            math.degrees(report.max_engagement),
            report.passes,
            report.links,
            report.retracts,
            report.uncut_area,
        ),
    )


def draw_square(core):
    job = Job(core, rectangle(60, 60))
    figure, axes = canvas(7, 6.6)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    helix = [(m[1], m[2]) for m in job.path.moves if m[0] == ENTRY][-1]
    names = {"spiral": BLUE, "passes": ORANGE, "links": GREY}
    first = True
    for kind, points in job.stretches():
        if kind == ENTRY:
            continue
        name = "links" if kind == LINK else "spiral" if first else "passes"
        first = first and kind == LINK
        axes.plot(
            *zip(*points),
            color=names[name],
            linewidth=1.3 if kind == CUT else 0.8,
            label=name if name in names else None,
        )
    axes.add_patch(Circle((30, 30), helix[0] - 30, fill=False, color=VIOLET, lw=1.6, label="helix"))
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles))
    place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "ncol": 4, "frameon": False}
    axes.legend(once.values(), once.keys(), fontsize=9, **place)
    plan(axes)
    save(figure, "square.png")


def draw_step(core):
    """One place of a pass in a slot: the tool, what it touches, the turn that it could make."""
    job = Job(core, rectangle(60, 14))
    grid = Grid(job, 0.02)
    samples = job.samples()
    at = None
    for i, (x, y, heading, kind, _, _) in enumerate(samples):
        if kind == CUT and x > 39 and math.sin(heading) > 0.75 and 6.6 < y < 7.0:
            at = i
            break
        grid.take(x, y, job.radius)
    x, y, heading, *_ = samples[at]
    turn = job.wish
    figure, axes = canvas(7.6, 6.2)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    ahead = [s[:2] for s in samples[at : at + 45]]
    axes.plot(*zip(*[s[:2] for s in samples[at - 40 : at + 1]]), color=BLUE, lw=2)
    axes.plot(*zip(*ahead), color=BLUE, lw=1.4, ls=":")
    axes.add_patch(Circle((x, y), job.radius, fill=False, color=INK, lw=1.2))
    right = math.degrees(heading) - 90
    engaged = math.degrees(job.angle)
    axes.add_patch(
        Arc((x, y), 6, 6, theta1=right, theta2=right + engaged, color=RED, lw=4, zorder=4)
    )
    c = math.radians(right + engaged)
    cx, cy = x + job.radius * math.cos(c), y + job.radius * math.sin(c)
    axes.plot([x, cx], [y, cy], color=RED, lw=1)
    r = math.radians(right)
    axes.plot([x, x + job.radius * math.cos(r)], [y, y + job.radius * math.sin(r)], color=RED, lw=1)
    axes.add_patch(Arc((x, y), 2, 2, theta1=right, theta2=right + engaged, color=RED, lw=1))
    middle = math.radians(right + engaged / 2)
    text = {"ha": "center", "va": "center", "fontsize": 13}
    axes.text(x + 1.4 * math.cos(middle), y + 1.4 * math.sin(middle), "θ", color=RED, **text)
    axes.text(cx + 0.35, cy + 0.35, "C", color=RED, **text)
    axes.text(x + 0.3, y - 0.4, "P", color=INK, **text)
    axes.annotate(
        "",
        (x + 2.2 * math.cos(heading), y + 2.2 * math.sin(heading)),
        (x, y),
        arrowprops={"arrowstyle": "-|>", "color": BLUE, "lw": 2},
        zorder=5,
    )
    qx, qy = x - turn * math.sin(heading), y + turn * math.cos(heading)
    axes.add_patch(Circle((qx, qy), turn, fill=False, color=GREEN, lw=1.4, ls="--"))
    axes.plot(qx, qy, "o", color=GREEN, ms=4)
    axes.text(qx - 0.38, qy, "Q", color=GREEN, **text)
    lines(axes, job.centres(), color=VIOLET, lw=1.3, label="walls of the tool's centre")
    stage = job.stages(1)[0]
    lines(axes, stage[2], color=GREEN, lw=1.3, ls=":", label="border of the place of Q")
    axes.plot([], [], color=BLUE, lw=2, label="pass, and what follows (dotted)")
    axes.plot([], [], color=RED, lw=4, label="engaged arc")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2, fontsize=9, frameon=False)
    plan(axes, (x - 6.5, x + 7), (-0.7, 14.7))
    save(figure, "step.png")


def draw_slot(core):
    job = Job(core, rectangle(100, 9))
    grid = Grid(job, 0.02)
    samples, passes = job.samples(), 0
    begin = next(i for i, s in enumerate(samples) if s[3] == CUT and s[0] > 61.5)
    while samples[begin][3] != LINK:
        begin += 1
    end, last = begin, None
    while passes < 4:
        if samples[end][3] == LINK and last == CUT:
            passes += 1
        last = samples[end][3]
        end += 1
    while samples[end - 1][3] == LINK:
        end -= 1
    for x, y, *_ in samples[:begin]:
        grid.take(x, y, job.radius)
    figure, axes = canvas(8.0, 6.2)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, lw=1.8)
    lines(axes, job.centres(), color=VIOLET, lw=1.2, label="walls of the tool's centre")
    part = samples[begin:end]
    for kind, name, style in (
        (CUT, "pass", {"colors": BLUE, "linewidths": 2}),
        (LINK, "link", {"colors": ORANGE, "linewidths": 1.3, "linestyles": "--"}),
    ):
        pieces = [points for k, points in stretches(part) if k == kind]
        axes.add_collection(LineCollection(pieces, label=name, zorder=3, **style))
    starts = [a[:2] for a, b in zip(part, part[1:]) if a[3] == LINK and b[3] == CUT]
    axes.plot(*zip(*starts), "o", color=GREEN, ms=6, zorder=5, label="start, at a wall sample")
    x, y = starts[0]
    axes.add_patch(Circle((x, y), job.radius, fill=False, color=INK, lw=1, ls=":", label="tool"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=5, fontsize=9, frameon=False)
    plan(axes, (x - 4.5, x + 6), (-0.4, 9.4))
    save(figure, "slot.png")


def draw_corner(core):
    job = Job(core, rectangle(60, 60))
    figure = Figure(figsize=(9.4, 5.2), dpi=110)
    FigureCanvasAgg(figure)
    parts = job.stretches(0.005)
    shades = ("#0b3d91", "#1a73e8", "#5fa8ff", "#b3d4ff")
    for axes, low in zip(figure.subplots(1, 2), (54.4, 56.4)):
        for (turn, opened, _), shade in zip(job.stages(4), shades):
            label = "stage, turn radius %.2f mm" % turn
            lines(axes, opened, color=shade, lw=4.5, label=label)
        lines(axes, job.centres(), color=RED, lw=2.4, label="last stage: exact border")
        first = job.stages(1)[0][2]
        lines(axes, first, color=GREEN, lw=1.3, ls=":", label="border of Q's place, first stage")
        for kind, colour, name in ((CUT, INK, "passes"), (LINK, ORANGE, "links")):
            pieces = [points for k, points in parts if k == kind]
            axes.add_collection(
                LineCollection(pieces, colors=colour, linewidths=0.8, label=name, zorder=3)
            )
        plan(axes, (low, 57.06), (low, 57.06))
    figure.axes[1].set_ylabel("")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=4, fontsize=8.5, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    save(figure, "corner.png", fit=False)


def draw_feed(core):
    window = 0.5  # mm, over which rates are means
    figure, axes = canvas(8.6, 4.4)
    notes = []
    for control, colour in (("constant feed", GREY), ("constant removal rate", BLUE)):
        job = Job(core, star(), hole=(0.0, 0.0, 11.0), control=control)
        grid, way, removed, area, minutes = Grid(job, 0.01), 0.0, 0.0, 0.0, 0.0
        nominal, along, rates = job.nominal_width * job.feed * job.depth, [], []
        length_before = 0.0
        for x, y, _, kind, feed, length in job.samples(0.05):
            took = grid.take(x, y, job.radius)
            if kind != CUT:
                continue
            way, area, minutes = way + length, area + took, minutes + length / feed
            if way - length_before >= window:
                along.append((way + length_before) / 2)
                rates.append((area * job.depth / minutes, area))
                removed += area
                length_before, area, minutes = way, 0.0, 0.0
        axes.plot(along, [r for r, _ in rates], color=colour, lw=1.4, label=control)
        near = sum(a for r, a in rates if r >= 0.9 * nominal) / removed
        notes.append(
            "%s: %.0f s, %.0f %% of the area at 0.9 of the rate or more, mean over %g mm at most "
            "%.3f of it"
            % (
                control,
                job.path.report.cutting_time,
                100 * near,
                window,
                max(r for r, _ in rates) / nominal,
            )
        )
    axes.axhline(nominal, color=RED, lw=1, ls="--", label="nominal: %.1f mm³/min" % nominal)
    axes.set_xlim(200, 330)
    axes.set_ylim(0, 1.15 * nominal)
    axes.set_xlabel("way along the cuts of the star, mm (the spiral ends at about 230)")
    axes.set_ylabel("removal rate, mm³/min")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, fontsize=9, frameon=False)
    save(figure, "feed.png", "; ".join(notes))


class Dexels:
    """A box of stock that moves were run on, and where its rows and columns end."""

    top, bottom = 0.0, -3.0

    def __init__(self, core, box, moves, diameter, resolution):
        self.box, self.resolution = box, resolution
        x0, y0, x1, y1 = box
        swapped = [(k, y, x, z, -sweep, cy, cx, feed) for k, x, y, z, sweep, cx, cy, feed in moves]
        # Columns are the rows of the scene in a mirror that swaps x and y.
        self.stocks = []
        for each, path in ((box, moves), ((y0, x0, y1, x1), swapped)):
            stock = box_stock(core, each, resolution)
            core.simulate(path, stock, tool_diameter=diameter, find_rest=False)
            self.stocks.append(stock)

    def places(self, side):
        """y of the rows (side 0), x of the columns (side 1)."""
        low, high = self.box[1 - side], self.box[3 - side]
        return numpy.arange(low + 0.5 * self.resolution, high, self.resolution)

    def has_material(self, side, across, along):
        return self.stocks[side].height_at(along, across) > self.bottom

    def runs(self, side, across):
        """[(low, high), ...] of the material on a row or column; ends are found by bisection."""
        low, high = self.box[side], self.box[side + 2]
        looks = [low - 0.01, *numpy.arange(low + 0.005, high, 0.01), high + 0.01]
        ends = []
        for a, b in zip(looks, looks[1:]):
            before = self.has_material(side, across, a)
            if before == self.has_material(side, across, b):
                continue
            for _ in range(40):
                middle = 0.5 * (a + b)
                if self.has_material(side, across, middle) == before:
                    a = middle
                else:
                    b = middle
            ends.append(b)
        return list(zip(ends[::2], ends[1::2]))


def box_stock(core, box, resolution):
    x0, y0, x1, y1 = box
    region = core.Region([(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)])
    return core.DexelStock([(region, Dexels.top)], Dexels.bottom, resolution)


def draw_dexels(core):
    """One step of the simulator: rows, columns, the engaged arc, and how its end is found."""
    radius, resolution, step = 3.0, 0.5, 1.0
    box, centre, swing, half = (4.2, 0.0, 16.0, 18.0), (-8.0, 9.0), 14.0, 0.95
    x, y, z = 7.6, 9.3, Dexels.bottom
    begin, end = (
        (centre[0] + swing * math.cos(a), centre[1] + swing * math.sin(a)) for a in (-half, half)
    )
    moves = [
        (RAPID, *begin, z, 0, 0, 0, 0),
        (CUT, *end, z, 2 * half, *centre, 255.0),
        (RAPID, *end, 5.0, 0, 0, 0, 0),
        (RAPID, x, -6.0, 5.0, 0, 0, 0, 0),
        (RAPID, x, -6.0, z, 0, 0, 0, 0),
        (CUT, x, y - step, z, 0, 0, 0, 255.0),
    ]
    dexels = Dexels(core, box, moves, 2 * radius, resolution)
    record, _, _ = core.simulate(
        [*moves, (CUT, x, y, z, 0, 0, 0, 255.0)],
        box_stock(core, box, resolution),
        tool_diameter=2 * radius,
        step=step,
        find_rest=False,
    )
    ((low, high, _),) = record["arcs"][record["first_arc"][-2] :]
    first, last = math.pi / 2 + low, math.pi / 2 + high  # the feed is along y
    found = (x + radius * math.cos(last), y + radius * math.sin(last))
    # The old border is a circle: where the tool's circle meets it is known.
    border, away = swing + radius, math.dist((x, y), centre)
    opening = math.acos((border**2 - radius**2 - away**2) / (2 * radius * away))
    exact = math.atan2(y - centre[1], x - centre[0]) + opening

    figure = Figure(figsize=(9.4, 5.4), dpi=110)
    FigureCanvasAgg(figure)
    wide, near = figure.subplots(1, 2)
    pieces = {
        BLUE: [((a, q), (b, q)) for q in dexels.places(0) for a, b in dexels.runs(0, q)],
        ORANGE: [((q, a), (q, b)) for q in dexels.places(1) for a, b in dexels.runs(1, q)],
    }
    grid_x, grid_y = numpy.meshgrid(numpy.arange(4.2, 16, 0.02), numpy.arange(3, 15, 0.02))
    # Positive where there is material: outside of the old border and of what the tool has swept.
    swept = numpy.minimum(
        numpy.hypot(grid_x - x, grid_y - y + step) - radius,
        numpy.maximum(grid_x - x - radius, grid_y - y + step),
    )
    full = numpy.minimum(numpy.hypot(grid_x - centre[0], grid_y - centre[1]) - border, swept)
    taken = numpy.minimum(full, radius - numpy.hypot(grid_x - x, grid_y - y))
    for axes, size in ((wide, 3), (near, 9)):
        for where, colour in ((full, "#f3efe4"), (taken, "#f6c9c2")):
            axes.contourf(grid_x, grid_y, where, levels=(0, 99), colors=[colour])
        for colour, dexels_here in pieces.items():
            axes.add_collection(
                LineCollection(dexels_here, colors=colour, linewidths=0.5 + 0.1 * size, zorder=2)
            )
            ends = [end for piece in dexels_here for end in piece]
            axes.plot(*zip(*ends), "o", color=colour, ms=size, zorder=4)
        outline_of = {"fill": False, "lw": 1.5, "zorder": 3}
        axes.add_patch(Circle((x, y - step), radius, color=GREY, ls="--", **outline_of))
        axes.add_patch(Circle((x, y), radius, color=INK, **outline_of))
        span = {"theta1": math.degrees(first), "theta2": math.degrees(last), "zorder": 5}
        axes.add_patch(Arc((x, y), 2 * radius, 2 * radius, color=RED, lw=4, **span))
    arrow = {"arrowstyle": "-|>", "color": INK, "lw": 2}
    wide.annotate("", (x, y + 2.0), (x, y), arrowprops=arrow, zorder=5)
    for end in ((x + radius, y), found):
        wide.plot([x, end[0]], [y, end[1]], color=RED, lw=1)
    middle = 0.5 * (first + last)
    text = {"ha": "center", "va": "center", "fontsize": 13}
    wide.text(x + 1.2 * math.cos(middle), y + 1.2 * math.sin(middle), "θ", color=RED, **text)
    wide.text(x - 0.4, y + 1.0, "feed", rotation=90, ha="center", va="center")
    draw_looks(near, dexels, (x, y), radius)
    ends = [end for dexels_here in pieces.values() for piece in dexels_here for end in piece]
    left = [p for p in ends if math.dist(p, (x, y)) > radius + 1e-4]
    nearest = sorted(left, key=lambda p: math.dist(p, found))[1]
    near.plot(*zip(nearest, found), color=GREEN, lw=2.2, ls=":", zorder=6)
    near.plot(*found, "D", color=RED, ms=11, mec="white", zorder=8)
    plan(wide, (x - 4.0, x + 6.4), (y - 5.2, y + 5.2))
    plan(near, (found[0] - 0.95, found[0] + 1.15), (found[1] - 1.05, found[1] + 1.05))
    wide.set_title("a step of %g mm, before it is cut" % step, fontsize=10)
    near.set_title("where the engaged arc ends", fontsize=10)
    near.set_ylabel("")
    samples = (
        ("row and its end", {"color": BLUE, "marker": "o"}),
        ("column and its end", {"color": ORANGE, "marker": "o"}),
        ("tool before the step", {"color": GREY, "ls": "--"}),
        ("tool at its end", {"color": INK}),
        ("engaged arc", {"color": RED, "lw": 4}),
        ("what the step will cut", {"color": "#f6c9c2", "lw": 8}),
        ("asked here: material", {"color": INK, "marker": "s", "ls": "", "ms": 8}),
        ("asked here: none", {"color": INK, "marker": "s", "ls": "", "ms": 8, "mfc": "white"}),
        ("old border, extrapolated", {"color": GREEN, "ls": ":", "lw": 2.2}),
        ("end of the arc", {"color": RED, "marker": "D", "ls": "", "ms": 9}),
    )
    handles = [Line2D([], [], label=name, **style) for name, style in samples]
    figure.legend(handles=handles, loc="upper center", ncol=5, fontsize=8.5, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.93))
    note = "arc's end at %.2f degrees, exactly %.2f" % (math.degrees(last), math.degrees(exact))
    save(figure, "simulation_step.png", note, fit=False)


def draw_looks(axes, dexels, centre, radius):
    """Where dexels are asked for material: rows on the circle's right quarter, columns above."""
    for side, colour in enumerate((BLUE, ORANGE)):
        for across in dexels.places(side):
            d = across - centre[1 - side]
            if abs(d) > radius * math.sqrt(0.5):
                continue
            along = centre[side] + math.sqrt(radius**2 - d * d)
            face = colour if dexels.has_material(side, across, along) else "white"
            place = (along, across) if side == 0 else (across, along)
            axes.plot(*place, "s", ms=9, mfc=face, mec=colour, mew=1.8, zorder=7)


def draw_star_simulation(core):
    """The sheet of a simulation, as operations and batch jobs have it."""
    from evenload import simulate, simulation_pictures

    job = Job(core, star(), hole=(0.0, 0.0, 11.0))
    half = 23.0
    block = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    part = [(core.Region(block, [backwards(job.chain)]), 0.0)]
    drilled = simulate(
        [(RAPID, 0, 0, 5, 0, 0, 0, 0), (ENTRY, 0, 0, -job.depth, 0, 0, 0, 100.0)],
        stock=block,
        top=0,
        bottom=-job.depth,
        tool_diameter=job.hole[2],
    )
    run = simulate(
        job.path,
        drilled,
        top=0,
        bottom=-job.depth,
        tool_diameter=job.diameter,
        part=part,
        cutting={"material": "Star test piece", "spindle_speed": 6366},
        machine="linuxcnc_mill",
    )
    figure = simulation_pictures.sheet(
        run,
        None,
        [block],
        part,
        hole=job.hole,
        target_deg=math.degrees(job.angle),
        nominal_rate=job.nominal_width * job.depth * job.feed,
        reference=99.0,
        title="Star, tool 6 mm at 60°",
    )
    palette = {"dpi": 100, "method": Image.Quantize.MAXCOVERAGE, "kmeans": 2}
    save(figure, "simulation_star.png", simulation_pictures.summary(run), fit=False, **palette)


# ---- optimising ----

CUTTERS = [
    {
        "diameter": diameter,
        "teeth": teeth,
        "cutting_length": 2 * diameter,
        "max_chip_thickness": 0.006 * diameter,
        "surface_speed": (100, 200),
    }
    for diameter, teeth in ((4, 2), (6, 2), (8, 3), (10, 3))
]


def draw_optimisation(core):
    """Time over force of all candidates of docs/optimisation.md's example."""
    import evenload

    pocket = core.Region(rectangle(60, 40), [])
    options = {"depth": 10, "max_force": 300, "engagement_deg": (30, 45, 60, 75, 90)}
    found = evenload.optimise(pocket, CUTTERS, "Al7075-T6", "linuxcnc_mill", **options)
    figure = Figure(figsize=(7.2, 4.2))
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for cutter, colour in zip(CUTTERS, (GREY, GREEN, BLUE, ORANGE)):
        rows = [c for c in found.ranked() if c.diameter == cutter["diameter"]]
        force, time = [c.force_peak_n for c in rows], [c.seconds for c in rows]
        name = "%g mm, %d teeth" % (cutter["diameter"], cutter["teeth"])
        axes.plot(force, time, "o", ms=4, color=colour, alpha=0.7, label=name, mew=0)
    axes.plot(found.best.force_peak_n, found.best.seconds, "o", ms=12, mfc="none", mec=RED)
    axes.axvline(options["max_force"], color=RED, lw=1, ls="--")
    axes.set(yscale="log", xlabel="peak force, N", ylabel="time on the machine, s")
    axes.set_yticks((100, 200, 500, 1000, 2000, 5000))
    axes.set_yticklabels(("100", "200", "500", "1000", "2000", "5000"))
    axes.minorticks_off()
    axes.legend(frameon=False)
    save(figure, "optimisation.png", found.table(3), fit=False)


def backwards(chain):
    """The same closed chain run the other way round."""
    turned = [(x, y, -chain[i - 1][2]) for i, (x, y, _) in enumerate(chain)]
    return turned[::-1]


def built_core():
    """The module _core of the folder that the command line names."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS.parent / "build" / "release"
    sys.path.insert(0, str(DOCS.parent / "Mod"))
    import evenload

    evenload.__path__.append(str(folder.resolve()))
    try:
        from evenload import _core
    except ImportError as error:
        sys.exit("No module _core for this Python in %s: %s." % (folder, error))
    return _core


def main():
    core = built_core()
    for draw in (
        draw_star,
        draw_square,
        draw_step,
        draw_slot,
        draw_corner,
        draw_feed,
        draw_dexels,
        draw_star_simulation,
        draw_optimisation,
    ):
        draw(core)


if __name__ == "__main__":
    main()
