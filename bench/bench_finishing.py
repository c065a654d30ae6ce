# Finishing paths: what the part CX takes at a stepover of 0.15 mm and a tolerance of 5 um, by
# zig-zag at five angles and by each other strategy, how the time grows with triangles and passes,
# and a plain drop cutter beside it, on one core.
import math
import sys
from pathlib import Path

import numpy
from evenload import compiled
from timing import best_time, best_times

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))
import finishing_cases as cases  # noqa: E402

STEPOVER, TOLERANCE, DEFLECTION = 0.15, 0.005, 0.0005
ANGLES = (0, 22.5, 45, 67.5, 90)  # degrees [Varga 2023, table of strategies]
CUSP = STEPOVER**2 / 40  # mm, what passes at STEPOVER leave on a level face
GUIDES = [[(-40.0, -40.0), (40.0, -40.0)], [(-40.0, 40.0), (40.0, 40.0)]]
STRATEGIES = (
    "zig-zag",
    "one way",
    "contours inwards",
    "contours outwards",
    "spiral inwards",
    "spiral outwards",
    "between guides",
    "one way between guides",
)
SPACING = 0.45  # mm, of the plain drop cutter: the widest samples of a pass


def mesh_of(deflection):
    return compiled.core().surface.FacetMesh(*cases.triangles(True, deflection))


def finished(mesh, deflection=DEFLECTION, **others):
    arguments = dict(stepover=STEPOVER, tolerance=TOLERANCE - deflection, deflection=deflection)
    return compiled.core().surface.finish(mesh, **cases.options(**{**arguments, **others}))


def test_part():
    mesh = mesh_of(DEFLECTION)
    for angle in ANGLES:
        direction = math.radians(angle)
        name = "finishing.cx.%g_degrees" % angle
        yield name + ".compute", best_time(lambda: finished(mesh, angle=direction), 3), "s"
        path = finished(mesh, angle=direction).toolpath
        yield name + ".length", path.report.cut_length / 1000, "m"
        yield name + ".blocks_per_pass", len(path.moves) / path.report.passes, ""
        yield name + ".points", len(path.moves), ""
    seconds = best_time(lambda: finished(mesh, cusp_height=CUSP), 3)
    yield "finishing.cx.even_cusps.compute", seconds, "s"


def strategies():
    """Each strategy at a constant stepover, and at the cusp height of that on a level face."""
    mesh = mesh_of(DEFLECTION)
    for pattern in STRATEGIES:
        guides = {"guides": GUIDES} if "guides" in pattern else {}
        for ending, cusp in (("", 0.0), (".even_cusps", CUSP)):
            name = "finishing.cx.%s%s" % (pattern.replace(" ", "_"), ending)
            found = []

            def compute():
                found[:] = [finished(mesh, pattern=pattern, cusp_height=cusp, **guides)]

            seconds, work = best_times(compute, 2)
            yield name + ".compute", seconds, "s"
            yield name + ".work_of_cores", work, "s"
            toolpath = found[0].toolpath
            yield name + ".length", toolpath.report.cut_length / 1000, "m"
            yield name + ".points", len(toolpath.moves), ""


def table(values):
    """The table of docs/finishing.md."""
    yield "| CX, stepover of 0.15 mm | work | points | even cusps of 0.56 µm | points |"
    yield "|---|---|---|---|---|"
    for pattern in STRATEGIES:
        cells = [pattern[0].upper() + pattern[1:]]
        for ending in ("", ".even_cusps"):
            name = "finishing.cx.%s%s" % (pattern.replace(" ", "_"), ending)
            work, points = (values[name + end] for end in (".work_of_cores", ".points"))
            cells += ["%.1f s" % work, "%d" % points]
        yield "| %s |" % " | ".join(cells)


def growth():
    for share in (4, 20, 100):
        mesh = mesh_of(TOLERANCE / share)
        seconds = best_time(lambda: finished(mesh, TOLERANCE / share, angle=math.pi / 2), 3)
        yield "finishing.growth.%d_triangles" % len(mesh), seconds, "s"
    mesh = mesh_of(DEFLECTION)
    for step in (0.6, 0.3, 0.15):
        seconds = best_time(lambda: finished(mesh, angle=math.pi / 2, stepover=step), 3)
        yield "finishing.growth.stepover_%g" % step, seconds, "s"


def drop_cutter():
    """The heights alone, at even samples of all passes."""
    mesh, core = mesh_of(DEFLECTION), compiled.core()
    x, y = numpy.meshgrid(numpy.arange(-40, 40, STEPOVER), numpy.arange(-40, 40.01, SPACING))
    places = numpy.column_stack((x.ravel(), y.ravel()))
    for threads, name in ((1, "one_core"), (0, "all_cores")):
        seconds = best_time(
            lambda: core.surface.contacts(mesh, 10, 5, places, -100.0, threads=threads), 3
        )
        yield "finishing.drop_cutter.%s" % name, seconds, "s"
    seconds = best_time(lambda: finished(mesh, angle=math.pi / 2, threads=1), 3)
    yield "finishing.drop_cutter.whole_path_one_core", seconds, "s"
    yield "finishing.drop_cutter.places", len(places), ""


def figures():
    for part in (test_part, strategies, growth, drop_cutter):
        yield from part()
