# FreeCAD's own ways to clear a case, to compare with: Adaptive, and Pocket with the pattern Offset,
# which is contour-parallel milling. Both in a real job, with the side step, tool and feeds of ours.
# Open stock is cleared from outside: its floor is extended beyond the edge, by a tool's diameter
# for Adaptive, which clears nothing with less, and for Pocket by so much less that its first ring
# takes one side step.
import math

import bench_adaptive
from evenload import host


def extended(op, job, case, by):
    """The operation with its floor extended by `by` mm, where the case has open stock."""
    if case.get("open"):
        model = job.Model.Group[0]
        floor = bench_adaptive.floors_of(model.Shape, -case["axial_depth"])[0]
        edge = model.Shape.getElement(floor).OuterWire.Edges
        numbers = [
            str(n)
            for n, found in enumerate(model.Shape.Edges, 1)
            if any(found.isSame(wanted) for wanted in edge)
        ]
        op.setExpression("ExtensionLengthDefault", None)
        op.ExtensionLengthDefault = by
        op.ExtensionFeature = [(model, "%s:Wire(%s)" % (floor, ",".join(numbers)))]
    return op


def pocket(job, controller, case):
    op = host.freecads("PocketShape", "Theirs", job, controller)
    share = 0.5 * (1 - math.cos(math.radians(case["engagement_deg"])))  # of the diameter
    op.OffsetPattern, op.KeepToolDown, op.StepOver = "Offset", True, round(100 * share)
    op.StartAt = "Edge" if case.get("open") else "Center"
    return extended(op, job, case, (1 - share) * case["tool"])


def adaptive(job, controller, case):
    op = bench_adaptive.freecads(job, controller, case)
    op.ForceInsideOut = not case.get("open")
    return extended(op, job, case, case["tool"])


def moves_of(create, case):
    """The moves of one of these operations."""
    op, _ = bench_adaptive.computed(create, case)
    moves = bench_adaptive.path_of(op, case)
    bench_adaptive.FreeCAD.closeDocument(op.Document.Name)
    return moves
