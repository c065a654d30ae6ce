# Finishing paths: what the part CX takes at a stepover of 0.15 mm and a tolerance of 5 um, by
# zig-zag at five angles and by each other strategy, how the time grows with triangles and passes,
# and a plain drop cutter beside it, on one core.
import math
import sys
from pathlib import Path

import numpy
from evenload import compiled
from evenload.ball_end import chip_feeds, loads, places
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
    for part in (test_part, strategies, chip_feed, growth, drop_cutter):
        yield from part()
