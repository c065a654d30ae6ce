"""Paths for the simulator's tests, and how they are run."""

import math

import evenload
import numpy
from evenload import compiled

core = compiled.core()
RAPID, LINK, ENTRY, CUT = range(4)
RADIUS, DEPTH, FEED, SPEED = 3.0, 3.0, 255.0, 6366.0
BELOW = (-30, -30, 30, 0)  # stock below the line y = 0
AROUND = (-30, -30, 30, 30)
BOX_CHAIN = [(-30, -30, 0), (30, -30, 0), (30, 0, 0), (-30, 0, 0)]
GOUGED = (-30, -30, 30, -1.45)  # its border is 0.05 mm within the tool at y = 1.5
GOUGED_CHAIN = [(-30, -30, 0), (30, -30, 0), (30, -1.45, 0), (-30, -1.45, 0)]
STAR = {"material": "Star test piece", "spindle_speed": SPEED}
UP = (RAPID, -40, 0, 5, 0, 0, 0, 0)


def line_at(y, z=-DEPTH):
    """Moves along the stock from left to right, at `y`."""
    return [UP, (LINK, -40, y, z, 0, 0, 0, 600), (CUT, 40, y, z, 0, 0, 0, FEED)]


def climb(degrees):
    """Moves that cut BELOW at that engagement, the material on the right."""
    return line_at(RADIUS * math.cos(math.radians(degrees)))


def simulated(source, stock=AROUND, **options):
    return evenload.simulate(source, stock, 0, -DEPTH, 2 * RADIUS, **options)


def middle(run):
    """The sample of the cut nearest to x = 0."""
    return int(numpy.argmin(numpy.where(run.kind == CUT, abs(run.x), numpy.inf)))


def written(folder, text, name="path.ngc"):
    path = folder / name
    path.write_text(text)
    return path


def same_load(a, b):
    """Whether two runs have the same samples and loads, bit by bit."""
    names = ("x", "y", "z", "kind", "length", "time_s", "engagement_deg", "removal_rate")
    return all(numpy.array_equal(getattr(a, n), getattr(b, n)) for n in names)


def spiral(moves=400, pitch=2.0):
    path = [(RAPID, 0, 0, 5, 0, 0, 0, 0), (ENTRY, 0, 0, -DEPTH, 0, 0, 0, 100)]
    for k in range(1, moves + 1):
        radius = 20 * math.sqrt(k / moves)
        angle = 2 * math.pi * radius / pitch
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        path.append((CUT, x, y, -DEPTH, 0, 0, 0, FEED))
    return path
