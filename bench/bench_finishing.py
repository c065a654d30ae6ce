# Finishing paths: what the part CX takes at a stepover of 0.15 mm and a tolerance of 5 um, by
# zig-zag at five angles and by each other strategy, how the time grows with triangles and passes,
# a plain drop cutter beside it, feeds by chip thickness, and how many moves the tolerance demands.
import ctypes
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from evenload import compiled
from evenload.ball_end import chip_feeds, loads, places
from evenload.planar import CUT
from timing import best_time, best_times

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))
import finishing_cases as cases  # noqa: E402
import lines_demanded  # noqa: E402

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
# Feeds by chip thickness: the source's 0.08 mm per tooth and 0.35 mm [Varga 2023, table 3].
BALL = loads.Cutting(10.0, 4, 5100.0, 0.3, {"ktc": 1.0, "krc": 0.0, "kte": 0.0, "kre": 0.0})
FED, FED_STEPOVER = 0.08 * BALL.teeth * BALL.speed, 0.35
FED_WAYS = {
    "0_degrees": dict(angle=0.0),
    "45_degrees": dict(angle=math.pi / 4),
    "90_degrees": dict(angle=math.pi / 2),
    "contours_inwards": dict(pattern="contours inwards"),
    "spiral_outwards": dict(pattern="spiral outwards"),
}
_ENDS = (("before", 1), ("before", 99), ("after", 1), ("after", 99))
COUNTED = {
    name: FED_WAYS[name]
    for name in ("45_degrees", "90_degrees", "contours_inwards", "spiral_outwards")
}


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


def chip_feed():
    """Feeds by chip thickness: what h_m is along paths then, by the part's own curvatures, and the
    time that finding them takes.
    """
    for is_convex, part in ((True, "cx"), (False, "cv")):
        mesh = compiled.core().surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
        for name, way in FED_WAYS.items():
            arguments = dict(stepover=FED_STEPOVER, feed=FED, plunge_feed=1e5, allowance=0.0)
            arguments.update(tolerance=TOLERANCE - DEFLECTION, deflection=DEFLECTION, **way)
            arguments = cases.options(**arguments)
            found = []

            def path():
                found[:] = [compiled.core().surface.finish(mesh, **arguments)]

            def feeds():
                stepover = max(FED_STEPOVER, found[0].largest_stepover)
                found[1:] = [
                    chip_feeds.fed(found[0].toolpath, mesh, arguments, stepover, BALL, 2 * FED)
                ]

            name = "finishing.chip_feeds.%s.%s" % (part, name)
            yield name + ".path", best_time(path, 2), "s"
            yield name + ".compute", best_time(feeds, 2), "s"
            finish, fed = found
            yield name + ".least", fed.least, "mm/min"
            yield name + ".largest", fed.largest, "mm/min"
            for when, toolpath in (("before", finish.toolpath), ("after", fed.toolpath)):
                off = 100 * (_thickness(toolpath.moves, is_convex) / fed.thickness - 1)
                for share in (1, 99):
                    yield "%s.%s.p%d" % (name, when, share), numpy.percentile(off, share), "%"
                yield "%s.%s.moves" % (name, when), len(toolpath.moves), ""
                yield "%s.%s.time" % (name, when), toolpath.report.cutting_time, "s"


def _thickness(moves, is_convex, count=2000):
    """mm, h_m of places between joints and off the borders."""
    along = places.places_along(moves, count, FED_STEPOVER)
    normals, curvature, off = cases.bends_under(along.tips[:, 1], BALL.diameter / 2, is_convex)
    bends = loads.Bends(normals, numpy.zeros(count), curvature, numpy.tile([1.0, 0, 0], (count, 1)))
    aside = cases.HALF - numpy.abs(along.tips[:, :2]).max(axis=1)
    felt = loads.loads_at(along, bends, BALL)
    return felt.mean_thickness[((off > 1.2) & (aside > 2) & (along.uncut != "strip"))[felt.rows]]


def fed_table(values):
    """The table of docs/finishing.md, 7."""
    for part in ("cx", "cv"):
        for name in FED_WAYS:
            of = {
                key.rsplit("%s.%s." % (part, name), 1)[1]: value
                for key, value in values.items()
                if key.startswith("finishing.chip_feeds.%s.%s." % (part, name))
            }
            cells = ["%s, %s" % (part.upper(), name.replace("_", " "))]
            cells.append(
                "%+.0f … %+.0f %% → %+.0f … %+.0f %%" % tuple(of["%s.p%d" % each] for each in _ENDS)
            )
            cells.append("%.0f … %.0f" % (of["least"], of["largest"]))
            cells += [
                "%d → %d" % (of["before.moves"], of["after.moves"]),
                "%.0f → %.0f s" % (of["before.time"], of["after.time"]),
            ]
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
    """Passes at 90 degrees: the time of the whole path, and that of a plain drop cutter on one core
    for the heights alone, at the same places: all those at which the path's passes are sampled. On
    CX, whose triangles are few and long, and on a dome, where they are many.
    """
    parts = (("cx", cases.triangles(True, DEFLECTION), STEPOVER), ("dome", _dome(), 4 * STEPOVER))
    for part, triangles, stepover in parts:
        mesh, core = compiled.core().surface.FacetMesh(*triangles), compiled.core()
        arguments = cases.options(
            stepover=stepover,
            tolerance=TOLERANCE - DEFLECTION,
            deflection=DEFLECTION,
            angle=math.pi / 2,
        )
        path = core.surface.finish(mesh, **arguments).toolpath
        half = numpy.abs(triangles[0][:, 1]).max()
        places, heights = _sampled(mesh, path.moves, half, arguments)
        plain, floor = PlainDropCutter(triangles), arguments["floor"]
        name = "finishing.drop_cutter.%s." % part
        yield name + "triangles", len(mesh), ""
        yield name + "places", len(places), ""
        off = numpy.abs(plain.heights(places, floor) - heights).max()
        yield name + "heights_differ_by", 1e6 * off, "nm"
        plain_work = best_times(lambda: plain.heights(places, floor), 3)[1]
        yield name + "plain_one_core", plain_work, "s"
        seconds, work = best_times(lambda: core.surface.finish(mesh, **arguments), 3)
        yield name + "whole_path", seconds, "s"
        yield name + "whole_path_work_of_cores", work, "s"
        yield name + "plain_over_whole_path", plain_work / seconds, ""
        yield name + "plain_over_work_of_cores", plain_work / work, ""


def _dome(radius=60.0, half=30.0):
    """(points, triangles, picked) of a dome that is bent both ways, triangles to DEFLECTION."""
    apart = math.sqrt(4 * radius * DEFLECTION)
    ordinates = numpy.linspace(-half, half, math.ceil(2 * half / apart) + 1)
    x, y = (each.ravel() for each in numpy.meshgrid(ordinates, ordinates, indexing="ij"))
    points = numpy.column_stack([x, y, numpy.sqrt(radius**2 - x**2 - y**2) - 20])
    count = len(ordinates)
    corner = (numpy.arange(count - 1)[:, None] * count + numpy.arange(count - 1)).ravel()
    right, up = corner + count, corner + 1
    numbers = numpy.vstack(
        [
            numpy.column_stack([corner, right, right + 1]),
            numpy.column_stack([corner, right + 1, up]),
        ]
    )
    return points, numbers.astype(numpy.uint32), numpy.ones(len(numbers), bool)


def _sampled(mesh, moves, half, arguments):
    """(n x 2 places, their heights) at which passes along y were sampled: over a part that ends at
    y = half, mm, and the tool's radius beyond it.
    """
    samples = compiled.core().surface.samples
    ordinates = sorted({round(move[1], 6) for move in moves if move[0] == CUT})
    reach = half + arguments["corner_radius"]
    places, heights = [], []
    for x in ordinates:
        found = samples(
            *(mesh, arguments["tool_diameter"], arguments["corner_radius"]),
            *((x, -reach), (x, reach), arguments["floor"], arguments["tolerance"]),
        )
        places.append(numpy.column_stack([numpy.full(len(found), x), found[:, 0] - reach]))
        heights.append(found[:, 1])
    return numpy.vstack(places), numpy.concatenate(heights)


class PlainDropCutter:
    """plain_drop_cutter.cpp, compiled as the core is."""

    def __init__(self, triangles, radius=5.0):
        points, numbers, _ = triangles
        self._corners = numpy.ascontiguousarray(points[numbers].reshape(-1, 9))
        self._radius = radius
        with tempfile.TemporaryDirectory() as folder:
            library = Path(folder) / "plain.so"
            source = Path(__file__).resolve().with_name("plain_drop_cutter.cpp")
            flags = "-std=c++20 -O3 -DNDEBUG -fno-math-errno -shared -fPIC".split()
            subprocess.run(["c++", *flags, "-o", library, source], check=True)
            self._drop = ctypes.CDLL(str(library)).plain_drop

    def heights(self, places, floor):
        """mm, of the tip over n x 2 places."""
        found = numpy.empty(len(places))
        wanted = numpy.ascontiguousarray(places)
        numbers = ctypes.POINTER(ctypes.c_double)
        corners, at, into = (
            each.ctypes.data_as(numbers) for each in (self._corners, wanted, found)
        )
        self._drop(
            *(corners, ctypes.c_size_t(len(self._corners)), ctypes.c_double(self._radius)),
            *(at, ctypes.c_size_t(len(places)), ctypes.c_double(floor), into),
        )
        return found


def lines():
    """Moves for each that the tolerance demands, on sample passes (lines_demanded.py)."""
    core = compiled.core()
    for is_convex, part in ((True, "cx"), (False, "cv")):
        mesh = core.surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
        for name, way in COUNTED.items():
            path = finished(mesh, stepover=1.0, **way).toolpath
            posted, demanded = lines_demanded.counted(
                mesh, path.moves, TOLERANCE - DEFLECTION, cases.options()["floor"], 40
            )
            name = "finishing.lines.%s.%s" % (part, name)
            yield name + ".posted", posted, ""
            yield name + ".demanded", demanded, ""
            yield name + ".posted_over_demanded", posted / demanded, ""


def figures():
    for part in (test_part, strategies, chip_feed, growth, drop_cutter, lines):
        yield from part()
