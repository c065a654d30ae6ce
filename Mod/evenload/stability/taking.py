"""A cut that was chosen goes into the operation and its tool controller."""

import contextlib

from evenload import host
from evenload.stability.operation import depth_of
from evenload.translation import translate

SAME = 1e-9  # share by which a speed may differ and be the same


def take(
    operation,
    speed=None,
    depth=None,
    cut_mode=None,
    engagement_deg=None,
    feed=None,
    step=None,
):
    """Sets the tool controller's spindle speed and feeds, and the operation's StepDown, CutMode and
    EngagementAngle, in one step that can be undone; then recomputes.

    speed: rev/min; depth: mm; cut_mode: "climb" or "conventional"; engagement_deg: degrees; feed:
    mm/min, the horizontal one, of which the vertical one and a MaximumFeed that was set keep their
    shares; None: as it is, but the feed per tooth stays where the speed changes. What an operation
    does not have it does not get. step: what undoing is called. Raises ValueError for numbers that
    cannot be.
    """
    with undoable(operation.Document, step or translate("Stability chart")):
        take_open(operation, speed, depth, cut_mode, engagement_deg, feed)
        operation.Document.recompute()


@contextlib.contextmanager
def undoable(document, step):
    """What is set while this lasts is one step to undo; on an error nothing is set."""
    document.openTransaction(step)
    try:
        yield
    except Exception:
        document.abortTransaction()
        raise
    document.commitTransaction()


def take_open(operation, speed=None, depth=None, cut_mode=None, engagement_deg=None, feed=None):
    """The same within a step that is open, such as that of a panel, and without a recompute."""
    for name, value in (("spindle speed", speed), ("depth", depth), ("feed", feed)):
        if value is not None and not value > 0:
            raise ValueError("The %s must be above 0, not %g." % (name, value))
    inner = host.operation_under(operation)
    _turn_at(host.controller_of(operation), inner, speed, feed)
    _cut_at(inner, depth, cut_mode)
    if engagement_deg is not None and hasattr(inner, "EngagementAngle"):
        _free(inner, "SideStep")  # whose expression would set the angle
        _set(inner, "EngagementAngle", engagement_deg)


def sharers(operation):
    """The labels of the job's other operations with the same tool controller."""
    job, controller = host.parent_job(operation), host.controller_of(operation)
    if job is None:
        return []
    return [
        other.Label
        for other in host.operations(job)
        if other is not operation and host.controller_of(other) is controller
    ]


def _turn_at(controller, operation, speed, feed):
    """Feeds first, which the speed changes unless one is given."""
    if speed is None and feed is None:
        return
    before, now = float(controller.SpindleSpeed), 60 * controller.HorizFeed.Value
    share = 1.0
    if feed is not None and now > 0:
        share = feed / now
    elif feed is None and speed is not None and before > 0:
        share = speed / before
    if abs(share - 1) > SAME:
        for name in ("HorizFeed", "VertFeed"):
            _set(controller, name, "%.12g mm/min" % (60 * share * getattr(controller, name).Value))
        if "MaximumFeed" in getattr(operation, "OwnValues", ()):
            most = 60 * share * operation.MaximumFeed.Value
            _set(operation, "MaximumFeed", "%.12g mm/min" % most)
    if speed is not None:
        _set(controller, "SpindleSpeed", float(speed))


def _cut_at(operation, depth, cut_mode):
    if depth is not None and hasattr(operation, "StepDown"):
        whole = operation.StartDepth.Value - operation.FinalDepth.Value
        if depth < whole or depth_of(operation) < whole:
            _set(operation, "StepDown", min(depth, whole))
    wanted = (cut_mode or "").capitalize()
    if wanted in (operation.getEnumerationsOfProperty("CutMode") or ()):
        operation.CutMode = wanted


def _set(obj, name, value):
    """Sets a property, also one that an expression has held."""
    _free(obj, name)
    setattr(obj, name, value)


def _free(obj, name):
    """Takes a property's expression away, if it has one."""
    if any(path == name for path, _ in obj.ExpressionEngine):
        obj.setExpression(name, None)
