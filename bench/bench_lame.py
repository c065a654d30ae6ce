# Lamé spirals on the four geometries of their source [Tancsa 2023], beside contour-parallel milling
# and clearing at constant engagement: time over the ideal one, the forces and the engagement that
# the simulator finds, and how long a path takes to compute. Contour-parallel milling is measured at
# the same feed, where it slots and thus exceeds the removal rate, and at the same peak force.
import math

import contour_parallel
import evenload
import pocket_case
from evenload import _core, materials
from evenload.simulation import HELIX_ANGLE_DEG
from timing import best_time

CASES = ("lame_square35", "lame_hex50", "lame_square_island", "lame_hex_island")
CUTTING = {"material": "Star test piece", "spindle_speed": 6366}
CUT = 3  # kind of a move


def spiral(case, **parameters):
    return pocket_case.path_of(case, _core.clear_with_lame_spiral, **parameters)


def even_force():
    """Parameters with which the feed control holds the force of a straight cut."""
    row = materials.load(CUTTING["material"])
    return {
        "feed_control": "constant force",
        "force_coefficients": tuple(row[key] for key in ("ktc", "krc", "kte", "kre")),
        "teeth": 1,
        "tool_helix_angle": math.radians(HELIX_ANGLE_DEG),
        "spindle_speed": CUTTING["spindle_speed"],
    }


def judged(case, moves):
    run = evenload.simulate(moves, **pocket_case.scene(case), cutting=CUTTING)
    width = 0.5 * case["tool"] * (1 - math.cos(math.radians(case["engagement_deg"])))
    ideal = 60 * run.removed_volume_total / (width * case["axial_depth"] * case["feed"])
    cuts = (run.kind == CUT) & (run.length > 0)
    force, seconds = run.force_mean[cuts], run.length[cuts] / run.feed[cuts]
    return {
        "time": (run.time_total_s, "s"),
        "time_ratio": (run.time_total_s / ideal, ""),
        "force_peak": (float(run.force_peak[cuts].max()), "N"),
        "force_mean": (float((force * seconds).sum() / seconds.sum()), "N"),
        "max_engagement": (run.max_engagement_deg, "deg"),
        "gouge": (run.gouge_mm, "mm"),
    }


def slower_contours(case, force):
    """Contour-parallel at the feed with which its peak force is `force` N: the force is nearly a
    straight line over the feed, which two feeds give.
    """
    feeds = (case["feed"], 0.5 * case["feed"])
    peaks = [judged(case, contour_parallel.moves_of(case, f))["force_peak"][0] for f in feeds]
    slope = (peaks[0] - peaks[1]) / (feeds[0] - feeds[1])
    return contour_parallel.moves_of(case, feeds[0] + (force - peaks[0]) / slope)


def figures():
    for name in CASES:
        case = pocket_case.load(name)
        path = spiral(case)
        rows = {
            "spiral": judged(case, path),
            "spiral_even_force": judged(case, spiral(case, **even_force())),
            "constant_engagement": judged(case, pocket_case.path_of(case)),
            "contours": judged(case, contour_parallel.moves_of(case, case["feed"])),
        }
        force = rows["spiral_even_force"]["force_peak"][0]
        rows["contours_same_force"] = judged(case, slower_contours(case, force))
        for which, row in rows.items():
            for figure, (value, unit) in row.items():
                yield "lame.%s.%s.%s" % (name, which, figure), value, unit
        yield "lame.%s.cleared_share" % name, path.cleared_share, ""
        yield "lame.%s.compute" % name, best_time(lambda: spiral(case)), "s"


PATHS = (
    "spiral",
    "spiral_even_force",
    "constant_engagement",
    "contours",
    "contours_same_force",
)
COLUMNS = ("time", "time_ratio", "force_peak", "force_mean", "max_engagement")


def table(values):
    """The figures side by side; time in s and over the ideal, forces in N, angles in degrees."""
    yield "%-20s %-20s" % ("case", "path") + "".join("%16s" % column for column in COLUMNS)
    for name in CASES:
        for which in PATHS:
            line = "%-20s %-20s" % (name, which)
            for column in COLUMNS:
                value = values.get("lame.%s.%s.%s" % (name, which, column))
                line += "%16s" % ("-" if value is None else "%.2f" % value)
            yield line
