"""What the pictures of docs/ have in common: pockets, paths, and how they are drawn.

What the tool removes is counted here on a grid of cells, so that the removal rates shown are not
the core's own opinion of them; the simulator's pictures show the simulator's own dexels and loads.
"""

import io
import math
import sys
from pathlib import Path

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
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


def places(before, move, step=STEP):
    """[(x, y), ...] along a move of a path, both ends among them."""
    (ax, ay), (_, x, y, _, sweep, cx, cy, _) = before[1:3], move
    radius = math.hypot(ax - cx, ay - cy)
    length = abs(sweep) * radius if sweep else math.hypot(x - ax, y - ay)
    n, start = max(1, math.ceil(length / step)), math.atan2(ay - cy, ax - cx)
    if not sweep:
        return [(ax + (x - ax) * k / n, ay + (y - ay) * k / n) for k in range(n + 1)]
    turned = [start + sweep * k / n for k in range(n + 1)]
    return [(cx + radius * math.cos(at), cy + radius * math.sin(at)) for at in turned]


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

    def holds(self, x, y, radius):
        """Whether a disc holds material."""
        i0, i1 = numpy.searchsorted(self.x, (x - radius, x + radius))
        j0, j1 = numpy.searchsorted(self.y, (y - radius, y + radius))
        away = (self.x[None, i0:i1] - x) ** 2 + (self.y[j0:j1, None] - y) ** 2
        return bool((self.full[j0:j1, i0:i1] & (away <= radius * radius)).any())


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
