"""A cut that was chosen in the chart goes into the operation and its tool controller."""

from evenload import host
from evenload.stability.operation import depth_of
from evenload.translation import translate

SAME = 1e-9  # share by which a speed may differ and be the same


def take(operation, speed=None, depth=None, cut_mode=None, engagement_deg=None):
    """Sets the tool controller's spindle speed, with its feeds so that the feed per tooth stays,
    and the operation's StepDown, CutMode and EngagementAngle, in one step that can be undone; then
    recomputes.

    speed: rev/min; depth: mm; cut_mode: "climb" or "conventional"; engagement_deg: degrees; None:
    as it is. What an operation does not have it does not get. Raises ValueError for numbers that
    cannot be.
    """
    for name, value in (("spindle speed", speed), ("depth", depth)):
        if value is not None and not value > 0:
            raise ValueError("The %s must be above 0, not %g." % (name, value))
    doc = operation.Document
    doc.openTransaction(translate("Stability chart"))
    try:
        if speed is not None:
            _turn_at(host.controller_of(operation), speed)
        inner = host.operation_under(operation)
        _cut_at(inner, depth, cut_mode)
        if engagement_deg is not None and hasattr(inner, "EngagementAngle"):
            _set(inner, "EngagementAngle", engagement_deg)
        doc.recompute()
    except Exception:
        doc.abortTransaction()
        raise
    doc.commitTransaction()


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


def _turn_at(controller, speed):
    before = float(controller.SpindleSpeed)
    if before > 0 and abs(speed - before) > SAME * before:
        for name in ("HorizFeed", "VertFeed"):
            feed = 60 * getattr(controller, name).Value
            _set(controller, name, "%.12g mm/min" % (feed * speed / before))
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
    if any(path == name for path, _ in obj.ExpressionEngine):
        obj.setExpression(name, None)
    setattr(obj, name, value)
