# The simulator: how long it takes and how that grows, what a large stock needs, how exact it is.
import math
import os
import subprocess
import sys
from pathlib import Path

import evenload
import pocket_case
from evenload import _core
from timing import best_time

RADIUS, DEPTH, FEED = 3.0, 3.0, 255.0
STAR = {"material": "Star test piece", "spindle_speed": 6366}
BLOCK, PITCH, MOVES = 300, 1.5, 100000  # mm, mm
RESOLUTIONS = (0.4, 0.2, 0.1, 0.05)


# ---- the star ----


def star():
    case = pocket_case.load("star")
    path, options = pocket_case.path_of(case), pocket_case.scene(case)
    loaded = {"cutting": STAR, "machine": "linuxcnc_mill"}
    run = evenload.simulate(path, **options)
    yield "simulation.star.path", (run.cut_mm + run.link_mm) / 1000, "m"
    yield "simulation.star.max_engagement", run.max_engagement_deg, "deg"
    yield "simulation.star.compute", best_time(lambda: evenload.simulate(path, **options)), "s"
    yield "simulation.star.compute_with_force_and_machine", best_time(
        lambda: evenload.simulate(path, **options, **loaded)
    ), "s"


# ---- a long path ----


def spiral(moves, share=1.0):
    """The first `share` of an Archimedean spiral that fills the block, in lines of one length."""
    largest = BLOCK / 2 - RADIUS / 2
    path = [(0, 0, 0, 5, 0, 0, 0, 0), (2, 0, 0, -DEPTH, 0, 0, 0, 100)]
    for k in range(1, moves + 1):
        radius = largest * math.sqrt(share * k / moves)
        angle = 2 * math.pi * radius / PITCH
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        path.append((3, x, y, -DEPTH, 0, 0, 0, FEED))
    return path


def seconds(path, resolution):
    block = (-BLOCK / 2, -BLOCK / 2, BLOCK / 2, BLOCK / 2)
    return best_time(
        lambda: evenload.simulate(path, block, 0, -DEPTH, 2 * RADIUS, resolution=resolution),
        repeats=1,
    )


def long_path():
    whole, half = spiral(MOVES), spiral(MOVES // 2, 0.5)
    at_tenth = seconds(whole, 0.1)
    yield "simulation.moves_100000.compute", at_tenth, "s"
    yield "simulation.moves_100000.growth_with_path", at_tenth / seconds(half, 0.1), ""
    at_fifth, at_twentieth = seconds(whole, 0.2), seconds(whole, 0.05)
    yield "simulation.moves_100000.growth_with_resolution_0.1", at_tenth / at_fifth, ""
    yield "simulation.moves_100000.growth_with_resolution_0.05", at_twentieth / at_tenth, ""


# ---- a large stock ----


def largest_memory():
    """MiB that this process has had at the most. Its ru_maxrss is its parent's at least."""
    with open("/proc/self/status", encoding="ascii") as file:
        (line,) = (line for line in file if line.startswith("VmHWM:"))
    return int(line.split()[1]) / 1024


def large_stock(ribs):
    """MiB that a stock of 1000 x 1000 mm at 0.05 mm takes, whole or cut into ribs 10 mm apart."""
    before = largest_memory()
    block = [(0, 0, 0), (1000, 0, 0), (1000, 1000, 0), (0, 1000, 0)]
    stock = _core.DexelStock([(_core.Region(block), 0)], -DEPTH, 0.05)
    if ribs:
        path = [(0, -5, 5, -DEPTH, 0, 0, 0, 0)]
        for y in range(5, 1000, 10):
            path.append((3, -5 if path[-1][1] > 0 else 1005, y, -DEPTH, 0, 0, 0, FEED))
            path.append((3, path[-1][1], y + 10, -DEPTH, 0, 0, 0, FEED))
        _core.simulate(path, stock, tool_diameter=2 * RADIUS, step=10.0, find_rest=False)
    return largest_memory() - before


def memory():
    here = Path(__file__).resolve().parent
    folders = (here, Path(evenload.__file__).resolve().parents[1])
    for name, ribs in (("whole", False), ("ribs", True)):
        # In a process of its own, as memory that was once given back would not count.
        code = "import bench_simulation; print(bench_simulation.large_stock(%r))" % ribs
        output = subprocess.run(
            [os.path.join(sys.prefix, "bin", "python3"), "-c", code],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, folders))},
            stdout=subprocess.PIPE,
            text=True,
            check=True,
        ).stdout
        yield "simulation.stock_1000x1000.%s" % name, float(output), "MiB"


# ---- errors ----


def circle(radius, x=0.0, y=0.0):
    return [(x - radius, y, 1.0), (x + radius, y, 1.0)]


def contour_errors(resolution):
    """Degrees by which samples miss Thesis I of [Jacsó 2021] inside of circles."""
    errors = []
    for k in range(12):
        rho, theta = 6.1 + 2.37 * k, math.radians(35 + 9 * k)
        root = math.sqrt(rho**2 - (RADIUS * math.sin(theta)) ** 2)
        side_step = RADIUS * (1 - math.cos(theta)) - rho + root
        around = rho + side_step - RADIUS
        size = rho + 2 * RADIUS
        block = [(-size, -size, 0), (size, -size, 0), (size, size, 0), (-size, size, 0)]
        path = [(0, around, 0, 5, 0, 0, 0, 0), (2, around, 0, -DEPTH, 0, 0, 0, 100)]
        for eighth in range(1, 7):
            turned = eighth * math.pi / 4
            x, y = around * math.cos(turned), around * math.sin(turned)
            path.append((3, x, y, -DEPTH, math.pi / 4, 0, 0, FEED))
        stock = _core.Region(block, [circle(rho)])
        run = evenload.simulate(path, stock, 0, -DEPTH, 2 * RADIUS, resolution=resolution)
        felt = run.engagement_deg[len(run.x) // 3 : len(run.x) * 9 // 10]
        errors.extend(abs(felt - math.degrees(theta)))
    return errors


def area_errors(resolution):
    """mm2 by which discs that lie anyhow between the dexels miss their areas."""
    for k in range(40):
        radius = 5 + 0.317 * k
        disc = _core.Region(circle(radius, 0.0137 * k, 0.0291 * k))
        yield abs(_core.DexelStock([(disc, 0)], -1, resolution).area - math.pi * radius**2)


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def errors():
    for resolution in RESOLUTIONS:
        name = "simulation.resolution_%g." % resolution
        found = []
        took = best_time(lambda: found.extend(contour_errors(resolution)), repeats=1)
        yield name + "compute", took, "s"
        yield name + "engagement_error", mean(found), "deg"
        yield name + "largest_engagement_error", max(found), "deg"
        yield name + "area_error", mean(area_errors(resolution)), "mm2"


def figures():
    yield from star()
    yield from long_path()
    yield from memory()
    yield from errors()
