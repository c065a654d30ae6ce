# What a ball leaves on the part CX: cusps against their closed form on the flats, the share within
# 10 % of the wished height, and what the map costs by cells and by threads.
import math
import sys
from pathlib import Path

import numpy
from evenload import compiled
from timing import best_time

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))
import finishing_cases as cases  # noqa: E402

BALL, DEFLECTION, TOLERANCE = 5.0, 1e-4, 0.005  # mm
STEPOVER, CUSP = 0.35, 0.01  # mm
WITHIN = 0.1  # of the wished height


def finished(**others):
    """(what the core needs of the part CX, moves over it)"""
    points, triangles, picked = cases.triangles(True, DEFLECTION)
    core = compiled.core()
    arguments = dict(tolerance=TOLERANCE - DEFLECTION, deflection=DEFLECTION, **others)
    mesh = core.surface.FacetMesh(points, triangles, picked)
    finish = core.surface.finish(mesh, **cases.options(**arguments))
    return (core.HeightMap(points, triangles), picked), finish.toolpath.moves


def mapped(part, moves, spacing, threads=0):
    cells = int(2 * cases.HALF / spacing)
    first = -(cells - 1) / 2 * spacing
    return compiled.core().surface_map(
        *(*part, moves),
        tool_diameter=2 * BALL,
        corner_radius=BALL,
        first=(first, first),
        spacing=spacing,
        cells=(cells, cells),
        stock=0.3,
        threads=threads,
    )


def cusps():
    part, moves = finished(stepover=0.4)
    found = mapped(part, moves, 0.1)["cusp"]
    flat = found[-50:][numpy.isfinite(found[-50:])]
    wanted = BALL - math.sqrt(BALL**2 - 0.4**2 / 4)
    yield "surface_map.flat.cusp_error", 100 * abs(numpy.median(flat) / wanted - 1), "%"
    part, moves = finished(stepover=1.0, cusp_height=CUSP)
    found = mapped(part, moves, 0.07)["cusp"]
    found = found[numpy.isfinite(found)]
    within = 100 * (abs(found - CUSP) <= WITHIN * CUSP).mean()
    yield "surface_map.cx.within_the_wish", within, "%"


def cost():
    part, moves = finished(stepover=STEPOVER)
    for spacing in (0.4, 0.2, 0.1):
        seconds = best_time(lambda: mapped(part, moves, spacing), 3)
        yield "surface_map.cx.cells_of_%g_mm" % spacing, seconds, "s"
    yield "surface_map.cx.one_core", best_time(lambda: mapped(part, moves, 0.1, 1), 3), "s"


def figures():
    yield from cusps()
    yield from cost()
