"""What one of EvenLoad's operations is not to exceed, by its settings."""

from evenload import host
from evenload import tool as tools
from evenload.settings.properties import is_ours


def limits_of(operation):
    """(engagement angle in degrees, removal rate in mm3/min) that an operation, or the one under a
    dressup, keeps to; (None, None) for others than EvenLoad's. Raises ValueError without a tool.
    """
    inner = host.operation_under(operation)
    if not is_ours(inner):
        return None, None
    _, data = tools.read(host.controller_of(inner))
    return inner.EngagementAngle.Value, nominal_rate(inner, data.feed)


def nominal_rate(operation, feed):
    """mm3/min that a straight cut of one of EvenLoad's operations removes; feed: mm/min."""
    final = operation.FinalDepth.Value + operation.StockToLeaveAxial.Value
    depth = min(operation.StepDown.Value, operation.StartDepth.Value - final)
    return operation.SideStep.Value * depth * feed
