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
from adaptive_goals import PUBLIC, TOO_SMALL, table  # noqa: F401: run.py prints the table
from evenload import commands, host
from evenload.operations import adaptive
from FreeCAD import Vector

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "freecad"))
from models import case_model, corpus_case, floors_of  # noqa: E402

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


def even(job, controller, case):
    """Ours, with feeds in steps as fine as the removal rate needs."""
    op = ours(job, controller, case)
    op.LeastLoad = judged_path.LEAST_LOAD
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
    compute, found = {"": 0.0, "even_": 0.0, "freecad_": 0.0}, {}
    for name in PUBLIC:
        case, ideal_time = corpus_case(name), None
        for which, create in (("", ours), ("even_", even), ("freecad_", freecads)):
            op, seconds = computed(create, case)
            compute[which] += seconds
            yield "adaptive.%s.%scompute" % (name, which), seconds, "s"
            if name not in TOO_SMALL and len(op.Path.Commands) > 2:
                rows = {}
                if create is not freecads:
                    rows, ideal_time = reported(op), op.IdealTime
                rows.update(judged_path.judged(case, path_of(op, case), ideal_time))
                for figure, (value, unit) in rows.items():
                    yield "adaptive.%s.%s%s" % (name, which, figure), value, unit
                    found.setdefault(which + figure, []).append(value)
            FreeCAD.closeDocument(op.Document.Name)
    yield from totals(compute, found)


MEDIANS = ("time_ratio", "band3", "rate_held", "blocks_per_metre")
LARGEST = (
    "time_ratio",
    "over",
    "link_engagement",
    "rate_worst",
    "gouge",
    "rest_share",
    "kinks_beyond",
    "entry",
    "plunge",
)
LEAST = ("rate_least", "rate_held", "climb")


def totals(compute, found):
    for which, seconds in compute.items():
        yield "adaptive.sum.%scompute" % which, seconds, "s"
    yield "adaptive.sum.compute_ratio", compute[""] / compute["freecad_"], ""
    for which in compute:
        yield "adaptive.sum.%spaths" % which, len(found[which + "time_ratio"]), ""
        for figure in MEDIANS:
            median = statistics.median(found[which + figure])
            yield "adaptive.median.%s%s" % (which, figure), median, ""
        for figure in LARGEST:
            yield "adaptive.worst.%s%s" % (which, figure), max(found[which + figure]), ""
        for figure in LEAST:
            yield "adaptive.worst.%s%s" % (which, figure), min(found[which + figure]), ""
