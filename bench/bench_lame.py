# Lamé spirals on the four geometries of their source [Tancsa 2023], beside clearing at constant
# engagement, contour-parallel milling, FreeCAD's Pocket and FreeCAD's Adaptive: time over the ideal
# one, the forces and the engagement that the simulator finds, and how long a path takes to compute:
# the fit and the spiral alone, with its feeds and report, and with what it leaves.
# Contour-parallel milling, ours and that of FreeCAD's Pocket, is measured at the same feed, where
# it slots and thus exceeds the removal rate, and at the same peak force as the spiral's with the
# feed control Constant force. FreeCAD's Pocket is set against that spiral in its time, too, and at
# its own feed against the spiral at a higher one: an even load allows that at a lower peak force.
# The same spirals with a late exponent show what courses do to the time. Of other pockets there is
# the time over the ideal one alone.
import math
import time

import contour_parallel
import evenload
import freecads_paths
import lame_pockets
import pocket_case
from evenload import _core, materials
from evenload.simulation import HELIX_ANGLE_DEG
from timing import best_time

CASES = ("lame_square35", "lame_hex50", "lame_square_island", "lame_hex_island")
CUTTING = {"material": "Star test piece", "spindle_speed": 6366}
CUT = 3  # kind of a move
SPIRAL_IS_THERE = 0.5  # of the progress
# mm/min, at which a straight cut at 60 degrees has about the peak force of contours that slot at
# the cases' 255 mm/min.
RAISED_FEED = 368
LATE = [0, 0, 1]  # the course of the exponent that takes least time in the pockets


def spiral(case, **parameters):
    return pocket_case.path_of(case, _core.clear_with_lame_spiral, **parameters)


def fit_and_spiral(case, repeats=5):
    """The fewest seconds of the processor until the spiral is there, and its feeds are not: half of
    the progress is reported then.
    """
    times = []
    for _ in range(repeats):
        start = time.process_time()
        ends = []

        def go_on(done):
            if done >= SPIRAL_IS_THERE:
                ends.append(time.process_time())
            return not ends

        spiral(case, progress=go_on)
        times.append(ends[0] - start)
    return min(times)


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


def in_time(case, moves, seconds):
    """Figures of FreeCAD's moves with cuts at such a share of their feed that they take `seconds`:
    the time is nearly a straight line over one over the share.
    """
    slow, fast = 1.0, 2.0
    rows = {share: judged(case, at_share(moves, share), True) for share in (1.0, 2.0)}
    for _ in range(3):
        at_slow, at_fast = rows[slow]["time"][0], rows[fast]["time"][0]
        part = (seconds - at_slow) / (at_fast - at_slow)
        slow, fast = fast, 1 / (1 / slow + part * (1 / fast - 1 / slow))
        rows[fast] = judged(case, at_share(moves, fast), True)
    return rows[fast]


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
            "spiral_late_exponent": judged(case, spiral(case, exponent_course=LATE)),
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
        even = rows["spiral_even_force"]["time"][0]
        rows["freecad_pocket_same_time"] = in_time(case, moves, even)
        raised = spiral({**case, "feed": RAISED_FEED}, **even_force())
        rows["spiral_raised_feed"] = judged(case, raised)
        for which, row in rows.items():
            for figure, (value, unit) in row.items():
                yield "lame.%s.%s.%s" % (name, which, figure), value, unit
        yield "lame.%s.cleared_share" % name, path.cleared_share, ""
        yield "lame.%s.compute" % name, best_time(lambda: spiral(case)), "s"
        alone = best_time(lambda: spiral(case, rest="leave"))
        yield "lame.%s.compute_spiral" % name, alone, "s"
        yield "lame.%s.compute_fit_and_spiral" % name, fit_and_spiral(case), "s"
    yield from other_figures()


def other_figures():
    for name, case in lame_pockets.CASES.items():
        row = judged(case, spiral(case))
        yield "lame.other.%s.time_over_ideal" % name, row["time_ratio"][0], ""
        yield "lame.other.%s.max_engagement" % name, row["max_engagement"][0], "deg"


PATHS = (
    "spiral",
    "spiral_late_exponent",
    "spiral_even_force",
    "constant_engagement",
    "freecad_adaptive",
    "contours",
    "contours_same_force",
    "freecad_pocket",
    "freecad_pocket_same_force",
    "freecad_pocket_same_time",
    "spiral_raised_feed",
)
# The spiral's path and the contours' that are set against each other.
COMPARED = (
    ("at the same feed", "spiral", "freecad_pocket"),
    ("at the same peak force", "spiral_even_force", "freecad_pocket_same_force"),
    ("in the spiral's time", "spiral_even_force", "freecad_pocket_same_time"),
    ("spiral's feed raised", "spiral_raised_feed", "freecad_pocket"),
    ("the same, helix contours", "spiral_raised_feed", "contours"),
)
SAME = 0.001  # of two figures: less is no difference
COMPUTED = (
    ("fit and spiral alone", "compute_fit_and_spiral"),
    ("with feeds and report, rest left", "compute_spiral"),
    ("with the rest", "compute"),
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
    yield ""
    yield from verdicts(values)
    yield ""
    for what, figure in COMPUTED:
        yield what + ": " + ", ".join(
            "%s %.1f ms" % (name, 1000 * values.get("lame.%s.%s" % (name, figure), math.nan))
            for name in CASES
        )
    yield "other pockets, over ideal: " + ", ".join(
        "%s %.2f" % (name, values.get("lame.other.%s.time_over_ideal" % name, math.nan))
        for name in lame_pockets.CASES
    )


def verdicts(values):
    """Whether the spiral is better than contours, case by case: s and N of both. Contours are those
    of FreeCAD's Pocket, which comes straight down, and ours, which begin with a helix in pockets.
    """
    yield "%-20s %-26s%20s%20s  spiral better in" % ("case", "compared", "spiral", "contours")
    for name in CASES:
        for how, ours, theirs in COMPARED:
            row = []
            for which in (ours, theirs):
                keys = ["lame.%s.%s.%s" % (name, which, f) for f in ("time", "force_peak")]
                row.append([values.get(key, math.nan) for key in keys])
            (our_time, our_force), (their_time, their_force) = row
            better = [
                word
                for word, a, b in (
                    ("time", our_time, their_time),
                    ("force", our_force, their_force),
                )
                if a < (1 - SAME) * b
            ]
            yield "%-20s %-26s%11.1f s %5.1f N%11.1f s %5.1f N  %s" % (
                name,
                how,
                our_time,
                our_force,
                their_time,
                their_force,
                " and ".join(better) or "nothing",
            )
