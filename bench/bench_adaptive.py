# The adaptive operation on the corpus: how long it computes, beside FreeCAD's own Adaptive on the
# same models in the same process; what its reports say, and what the simulator says of both paths.
# Sums and medians are over PUBLIC, medians of FreeCAD's over the cases for which it finds a path.
import math
import statistics
import sys
import time
from pathlib import Path

import FreeCAD
import judged_path
from evenload import commands, host
from evenload.operations import adaptive
from FreeCAD import Vector

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "freecad"))
from models import case_model, corpus_case, floors_of  # noqa: E402

PUBLIC = (
    "boss_open",
    "circle12",
    "comb",
    "inch_slot",
    "lame_hex50",
    "lame_square35",
    "lshape",
    "ring",
    "slot875",
    "slot9",
    "square60",
    "square_island",
    "star",
    "too_small",
    "two_rooms",
    "two_rooms_closed",
)
TOO_SMALL = ("too_small",)  # no path: both only have to find that out
CLEARABLE = len(PUBLIC) - len(TOO_SMALL)
SPINDLE_SPEED = 6366  # rev/min


def ours(job, controller, case):
    op = adaptive.Create("Ours", parentJob=job, toolController=controller)
    op.EngagementAngle = case["engagement_deg"]
    op.FeedControl = "Constant removal rate"
    op.LinkFeed = "%g mm/min" % case["link_feed"]
    op.MaximumFeed = "%g mm/min" % case["max_feed"]
    op.RollRadius = case["roll_radius"]
    if case.get("hole"):
        x, y, diameter = case["hole"]
        op.Entry, op.EntryPoint, op.HoleDiameter = "Predrilled hole", Vector(x, y, 0), diameter
    return op


def freecads(job, controller, case):
    """Set so that it does the same: all inside the outline, at the same side step."""
    op = host.freecads_adaptive("Theirs", job, controller)
    op.UseOutline, op.ForceInsideOut = False, True
    op.StepOver = round(50 * (1 - math.cos(math.radians(case["engagement_deg"]))))
    return op


def computed(create, case):
    """(operation, seconds of its first recompute) in a document of its own, which stays open."""
    doc = FreeCAD.newDocument("Bench")
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = case_model(case)
    doc.recompute()
    job, controller = host.create_job(doc, [part], case["tool"], case["feed"], SPINDLE_SPEED, 1)
    op = create(job, controller, case)
    model = job.Model.Group[0]
    op.Base = [(model, tuple(floors_of(model.Shape, -case["axial_depth"])))]
    for name in ("StartDepth", "FinalDepth", "StepDown"):
        op.setExpression(name, None)
    op.StartDepth, op.FinalDepth, op.StepDown = 0, -case["axial_depth"], case["axial_depth"]
    start = time.perf_counter()
    doc.recompute()
    return op, time.perf_counter() - start


def path_of(op, case):
    """The operation's moves, with its ways across the floor at the links' feed."""
    moves, _ = commands.to_moves(op.Path.Commands, z=10.0, feed=case["feed"])
    return judged_path.links_at_depth(moves, case["link_feed"])


def reported(op):
    """{figure: (value, unit)} of our own report."""
    if not op.isValid():
        raise RuntimeError("%s: %s" % (op.Document.Name, op.Report))
    return {
        "max_engagement": (op.MaxEngagement.Value, "deg"),
        "reported_time_ratio": (op.CuttingTime / op.IdealTime, ""),
        "uncut_area": (op.UncutArea.Value, "mm2"),
    }


def figures():
    host.cam()  # FreeCAD's modules are loaded once, for neither
    compute, found = {"": 0.0, "freecad_": 0.0}, {}
    for name in PUBLIC:
        case, ideal_time = corpus_case(name), None
        for which, create in (("", ours), ("freecad_", freecads)):
            op, seconds = computed(create, case)
            compute[which] += seconds
            yield "adaptive.%s.%scompute" % (name, which), seconds, "s"
            if name not in TOO_SMALL and len(op.Path.Commands) > 2:
                rows = {}
                if create is ours:
                    rows, ideal_time = reported(op), op.IdealTime
                rows.update(judged_path.judged(case, path_of(op, case), ideal_time))
                for figure, (value, unit) in rows.items():
                    yield "adaptive.%s.%s%s" % (name, which, figure), value, unit
                    found.setdefault(which + figure, []).append(value)
            FreeCAD.closeDocument(op.Document.Name)
    yield from totals(compute, found)


MEDIANS = ("time_ratio", "band3", "rate_held", "blocks_per_metre")
WORST = ("time_ratio", "over", "link_engagement", "rate_worst", "gouge", "rest_share")


def totals(compute, found):
    for which, seconds in compute.items():
        yield "adaptive.sum.%scompute" % which, seconds, "s"
    yield "adaptive.sum.compute_ratio", compute[""] / compute["freecad_"], ""
    for which in compute:
        yield "adaptive.sum.%spaths" % which, len(found[which + "time_ratio"]), ""
        for figure in MEDIANS:
            median = statistics.median(found[which + figure])
            yield "adaptive.median.%s%s" % (which, figure), median, ""
        for figure in WORST:
            yield "adaptive.worst.%s%s" % (which, figure), max(found[which + figure]), ""
        yield "adaptive.worst.%srate_least" % which, min(found[which + "rate_least"]), ""


# ---- the table ----

COLUMNS = (
    ("time_ratio", "time", "%7.3f"),
    ("over", "over", "%7.2f"),
    ("link_engagement", "linkE", "%7.2f"),
    ("band3", "band3", "%7.2f"),
    ("rate_worst", "rate+", "%7.3f"),
    ("rate_least", "rate-", "%7.3f"),
    ("rate_held", "held", "%7.2f"),
    ("gouge", "gouge", "%7.3f"),
    ("blocks_per_metre", "blk/m", "%7.0f"),
    ("compute", "comp s", "%7.3f"),
)


SUMMARIES = ("median", "worst", "sum")  # rows below those of the cases
# (what, its key; FreeCAD's after "freecad_", whether it is to be at least or at most what follows:
# required, wished) of the second table
GOALS = (
    ("star: time / ideal", "star.%stime_ratio", "<=", 1.18, 1.10),
    ("time / ideal, median", "median.%stime_ratio", "<=", 1.15, 1.08),
    ("over the angle, degrees", "worst.%sover", "<=", 2, 0.5),
    ("star: cut within 3 degrees", "star.%sband3", ">=", 0.70, 0.85),
    ("removal rate, largest", "worst.%srate_worst", "<=", 1.05, 1.02),
    ("removal rate where F < max", "worst.%srate_least", ">=", 0.85, 0.98),
    ("engagement of links, degrees", "worst.%slink_engagement", "<=", 1, 1),
    ("gouge, mm", "worst.%sgouge", "<=", 0.005, 0.005),
    ("area left / cleared", "worst.%srest_share", "<=", 0.0005, 0.0005),
    ("cases with a path", "sum.%spaths", ">=", CLEARABLE, CLEARABLE),
    ("star: blocks per metre", "star.%sblocks_per_metre", "<=", 700, 400),
    ("compute / FreeCAD's", "sum.%scompute_ratio", "<=", 0.5, 0.1),
)


def table(values):
    """The figures side by side, a line for each case and operation, then those of all cases, and
    what is required and wished beside them; values: {name: value}.

    time: over the ideal; linkE: engagement of links in degrees; rate+, rate-: the largest removal
    rate and, where F < MaximumFeed, the least, over the nominal; held: the share of the length with
    such a feed on which it is 0.85 or more.
    """
    yield "%-17s %-8s" % ("case", "path") + "".join("%8s" % title for _, title, _ in COLUMNS)
    for name in (*PUBLIC, *SUMMARIES):
        for which, maker in (("", "EvenLoad"), ("freecad_", "FreeCAD")):
            line = "%-17s %-8s" % (name, maker)
            for figure, _, form in COLUMNS:
                value = values.get("adaptive.%s.%s%s" % (name, which, figure))
                line += " " + ("%7s" % "-" if value is None else form % value)
            yield line
    yield ""
    yield "%-30s" % "of all cases" + "%10s%10s%12s%10s" % (
        "FreeCAD",
        "EvenLoad",
        "required",
        "wished",
    )
    for title, key, sign, required, wished in GOALS:
        yield goal_line(values, title, "adaptive." + key, sign, required, wished)


def goal_line(values, title, key, sign, required, wished):
    """One line: FreeCAD's figure, ours, and how far ours is as it should be."""
    theirs, value = values.get(key % "freecad_"), values.get(key % "")
    line = "%-30s" % title
    for number in (theirs, value):
        line += "%10s" % ("-" if number is None else "%.4g" % number)
    line += "%12s%10s" % ("%s %g" % (sign, required), "%s %g" % (sign, wished))
    if value is None:
        return line
    kept = [value <= goal if sign == "<=" else value >= goal for goal in (required, wished)]
    return line + "  " + ("as wished" if kept[1] else "as required" if kept[0] else "MISSED")
