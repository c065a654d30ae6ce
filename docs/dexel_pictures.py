"""The pictures of docs/simulation.md; see make_pictures.py."""

import math

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Arc, Circle
from picture_parts import BLUE, CUT, ENTRY, GREEN, GREY, INK, ORANGE, RAPID, RED
from picture_parts import Job, backwards, plan, save, star
from PIL import Image


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


PICTURES = (draw_dexels, draw_star_simulation)
