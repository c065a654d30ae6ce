# Lamé spirals on the four geometries of their source [Tancsa 2023], beside clearing at constant
# engagement, contour-parallel milling, FreeCAD's Pocket and FreeCAD's Adaptive: time over the ideal
# one, the forces and the engagement that the simulator finds, and how long a path takes to compute.
# Contour-parallel milling, ours and that of FreeCAD's Pocket, is measured at the same feed, where
# it slots and thus exceeds the removal rate, and at the same peak force.
import math

import contour_parallel
import evenload
import freecads_paths
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


def judged(case, moves, infer_kinds=False):
    """infer_kinds: whether entries are told from cuts by what the moves do, as for FreeCAD's."""
    scene = pocket_case.scene(case)
    run = evenload.simulate(moves, **scene, cutting=CUTTING, infer_kinds=infer_kinds)
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


def at_share(moves, share):
    """The same moves, cuts at a share of their feed."""
    return [(*m[:7], share * m[7] if m[0] == CUT else m[7]) for m in moves]


def contours(case, moves, force, infer_kinds=False):
    """Figures of contour-parallel moves at their feed, and at that with which their peak force is
    `force` N: the force is nearly a straight line over the feed, which two feeds give.
    """
    row = judged(case, moves, infer_kinds)
    peak = row["force_peak"][0]
    half = judged(case, at_share(moves, 0.5), infer_kinds)["force_peak"][0]
    share = 1 + (force - peak) / (2 * (peak - half))
    return row, judged(case, at_share(moves, share), infer_kinds)


def figures():
    for name in CASES:
        case = pocket_case.load(name)
        path = spiral(case)
        rows = {
            "spiral": judged(case, path),
            "spiral_even_force": judged(case, spiral(case, **even_force())),
            "constant_engagement": judged(case, pocket_case.path_of(case)),
            "freecad_adaptive": judged(
                case, freecads_paths.moves_of(freecads_paths.adaptive, case), True
            ),
        }
        force = rows["spiral_even_force"]["force_peak"][0]
        moves = contour_parallel.moves_of(case, case["feed"])
        rows["contours"], rows["contours_same_force"] = contours(case, moves, force)
        moves = freecads_paths.moves_of(freecads_paths.pocket, case)
        rows["freecad_pocket"], rows["freecad_pocket_same_force"] = contours(
            case, moves, force, True
        )
        for which, row in rows.items():
            for figure, (value, unit) in row.items():
                yield "lame.%s.%s.%s" % (name, which, figure), value, unit
        yield "lame.%s.cleared_share" % name, path.cleared_share, ""
        yield "lame.%s.compute" % name, best_time(lambda: spiral(case)), "s"
        alone = best_time(lambda: spiral(case, rest="leave"))
        yield "lame.%s.compute_spiral" % name, alone, "s"


PATHS = (
    "spiral",
    "spiral_even_force",
    "constant_engagement",
    "freecad_adaptive",
    "contours",
    "contours_same_force",
    "freecad_pocket",
    "freecad_pocket_same_force",
)
COLUMNS = ("time", "time_ratio", "force_peak", "force_mean", "max_engagement")


def table(values):
    """The figures side by side; time in s and over the ideal, forces in N, angles in degrees."""
    yield "%-20s %-26s" % ("case", "path") + "".join("%16s" % column for column in COLUMNS)
    for name in CASES:
        for which in PATHS:
            line = "%-20s %-26s" % (name, which)
            for column in COLUMNS:
                value = values.get("lame.%s.%s.%s" % (name, which, column))
                line += "%16s" % ("-" if value is None else "%.2f" % value)
            yield line
    yield "s to compute, rest left: " + ", ".join(
        "%s %.3f" % (name, values.get("lame.%s.compute_spiral" % name, math.nan)) for name in CASES
    )
