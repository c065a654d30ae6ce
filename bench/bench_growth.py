# How the time to compute a path grows: with the pocket's area, its edges, the length of a slot, the
# number of islands, a finer tolerance. Each series ends with the exponent p of time ~ size^p
# between its last two steps, beside that of size x log.
import math
import time

from evenload import _core

TOOL, FEED = 6.0, 255.0  # mm, mm/min
SIDE, SCALES = 60.0, (1, 4, 16, 64)  # mm, areas
RADIUS, WAVE, WAVES = 40.0, 3.0, 12  # mm, mm: an outline like a gear's
EDGES = (10, 30, 100, 300, 1000, 3000, 10000)
TOLERANCES = (0.02, 0.01, 0.005, 0.0025, 0.00125)  # mm
SLOTS, WIDTH = (50, 200, 800, 3200), 9.0  # mm
ISLANDS, PITCH, ISLAND = (1, 4, 16, 64), 25.0, 4.0  # mm, mm: apart, their radius
LEAST = 0.3  # s: what is shorter is measured several times
NOISE = 0.05  # of the exponent: two runs of the same differ by some per cent


def square(scale):
    side = SIDE * math.sqrt(scale)
    return [(0, 0, 0), (side, 0, 0), (side, side, 0), (0, side, 0)]


def wavy(edges):
    chain = []
    for k in range(edges):
        angle = 2 * math.pi * k / edges
        radius = RADIUS + WAVE * math.cos(WAVES * angle)
        chain.append((radius * math.cos(angle), radius * math.sin(angle), 0))
    return chain


def slot(length):
    return [(0, 0, 0), (length, 0, 0), (length, WIDTH, 0), (0, WIDTH, 0)]


def field(count):
    """A square and the round islands in it."""
    rows = math.isqrt(count)
    side = rows * PITCH
    places = [PITCH * (k + 0.5) for k in range(rows)]
    islands = [[(x + ISLAND, y, 1.0), (x - ISLAND, y, 1.0)] for x in places for y in places]
    return [(0, 0, 0), (side, 0, 0), (side, side, 0), (0, side, 0)], islands


def clear(chain, islands=(), **options):
    return _core.clear_pocket(
        [_core.Region(chain, islands)],
        tool_diameter=TOOL,
        engagement_angle=math.radians(60),
        feed_control="constant removal rate",
        feed=FEED,
        plunge_feed=FEED,
        link_feed=1500.0,
        maximum_feed=1000.0,
        levels=[-3.0],
        safe_height=3.0,
        clearance_height=5.0,
        **options,
    )


def seconds(chain, islands=(), **options):
    """Seconds of the processor for one path; the fewest of several where it is short."""
    found, total = [], 0.0
    while total < LEAST:
        start = time.process_time()
        clear(chain, islands, **options)
        found.append(time.process_time() - start)
        total += found[-1]
    return min(found)


def growth(name, sizes, times):
    """The figures of a series: times by size, the exponent, the one allowed, and if it is kept."""
    for size, value in zip(sizes, times):
        yield "growth.%s_%g.compute" % (name, size), value, "s"
    (n, m), (s, t) = sizes[-2:], times[-2:]
    exponent = math.log(t / s) / math.log(m / n)
    allowed = 1 + math.log(math.log(m) / math.log(n)) / math.log(m / n)
    yield "growth.%s.exponent" % name, exponent, ""
    yield "growth.%s.exponent_linear_log" % name, allowed, ""
    yield "growth.%s.no_worse_than_linear_log" % name, int(exponent <= allowed + NOISE), ""


def figures():
    areas = [scale * SIDE**2 / TOOL**2 for scale in SCALES]
    yield from growth("area", areas, [seconds(square(scale)) for scale in SCALES])
    yield from growth("edges", EDGES, [seconds(wavy(edges)) for edges in EDGES])
    yield from growth("slot_length", SLOTS, [seconds(slot(length)) for length in SLOTS])
    yield from growth("islands", ISLANDS, [seconds(*field(count)) for count in ISLANDS])
    fineness = [1 / tolerance for tolerance in TOLERANCES]
    for name, arcs in (("fineness_arcs", True), ("fineness_lines", False)):
        times = [seconds(wavy(100), tolerance=t, arcs=arcs) for t in TOLERANCES]
        yield from growth(name, fineness, times)
