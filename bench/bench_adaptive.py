# The adaptive operation on the corpus: how long it computes, beside FreeCAD's own Adaptive on the
# same models in the same process, and what its reports say. Sums are over PUBLIC.
import math
import sys
import time
from pathlib import Path

import FreeCAD
from evenload import host
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


def figures():
    host.cam()  # FreeCAD's modules are loaded once, for neither
    total = {"compute": 0.0, "freecad_compute": 0.0}
    for name in PUBLIC:
        case, prefix = corpus_case(name), "adaptive.%s." % name
        for key, create in (("compute", ours), ("freecad_compute", freecads)):
            op, seconds = computed(create, case)
            total[key] += seconds
            yield prefix + key, seconds, "s"
            if create is ours and name not in TOO_SMALL:
                if not op.isValid():
                    raise RuntimeError("%s: %s" % (name, op.Report))
                yield prefix + "max_engagement", op.MaxEngagement.Value, "deg"
                yield prefix + "time_ratio", op.CuttingTime / op.IdealTime, ""
                yield prefix + "uncut_area", op.UncutArea.Value, "mm2"
            FreeCAD.closeDocument(op.Document.Name)
    for key, seconds in total.items():
        yield "adaptive.sum." + key, seconds, "s"
    yield "adaptive.sum.compute_ratio", total["compute"] / total["freecad_compute"], ""
