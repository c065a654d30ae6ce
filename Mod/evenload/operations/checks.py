"""Whether an operation's settings can be used, and the sentences that say why not."""

from evenload import host
from evenload.operations.following import ANGLE, STEP, bound
from evenload.settings import ranges
from evenload.settings.table import HOLE_ENTRIES, TOLERANCE
from evenload.words import listed

DEPTHS = ("StartDepth", "FinalDepth", "StepDown", "SafeHeight", "ClearanceHeight")
MOST_LEVELS = 5000  # more is a slip of the pen, and would take days


def for_geometry(obj):
    """Raises ValueError for settings that reading the base geometry needs."""
    ranges.check(obj, [TOLERANCE])


def settings(obj, rows, tool, data):
    """Raises ValueError for settings, of these rows, and for depths that cannot be used."""
    values(obj, rows, tool, data)
    depths(obj, tool)


def as_set(obj, rows, tool, data):
    """Raises ValueError for what cannot be used of that which the user sets: depths that follow the
    geometry are not known before it is read.
    """
    values(obj, rows, tool, data)
    if not bound(obj) & set(DEPTHS):
        depths(obj, tool)


def values(obj, rows, tool, data):
    """Raises ValueError for settings, of these rows, that cannot be used."""
    ranges.check(obj, rows)
    if {ANGLE, STEP} <= bound(obj):
        raise ValueError(
            "EngagementAngle and SideStep both have an expression, though each sets the other: "
            "take one of the two away."
        )
    if not 0 < obj.SideStep.Value < tool.diameter:
        raise ValueError(
            "SideStep is %g mm: it must lie between 0 and the tool's diameter of %g mm."
            % (obj.SideStep.Value, tool.diameter)
        )
    # Nothing could be held that is less than what the path may be off; it would not end, either.
    if obj.SideStep.Value < obj.Tolerance.Value:
        raise ValueError(
            "SideStep is %g mm, less than the Tolerance of %g mm: lower Tolerance or raise "
            "EngagementAngle." % (obj.SideStep.Value, obj.Tolerance.Value)
        )
    if 60 * obj.MaximumFeed.Value < data.feed * (1 - 1e-9):
        raise ValueError(
            "MaximumFeed is %g mm/min: it must not be below the tool controller's horizontal "
            "feed of %g mm/min." % (60 * obj.MaximumFeed.Value, data.feed)
        )


def depths(obj, tool):
    """Raises ValueError for depths and heights that cannot be used."""
    start, final, step = obj.StartDepth.Value, obj.FinalDepth.Value, obj.StepDown.Value
    last = final + obj.StockToLeaveAxial.Value
    if not start > final:
        raise ValueError(
            "StartDepth (%g mm) does not lie above FinalDepth (%g mm): raise StartDepth or "
            "lower FinalDepth." % (start, final)
        )
    if not start > last:
        raise ValueError(
            "StockToLeaveAxial is %g mm: between StartDepth (%g mm) and FinalDepth (%g mm) that "
            "leaves nothing to cut, lower it." % (last - final, start, final)
        )
    if not step > 0:
        raise ValueError("StepDown is %g mm: it must be positive." % step)
    if start - last > MOST_LEVELS * step:
        raise ValueError(
            "StepDown is %g mm: from StartDepth to FinalDepth that makes more than %d levels, "
            "raise it." % (step, MOST_LEVELS)
        )
    if tool.cutting_length and start - last > tool.cutting_length + 1e-6:
        raise ValueError(
            "The depth of %g mm is more than the cutting length of %g mm of the tool '%s': "
            "take a longer tool or raise FinalDepth."
            % (start - last, tool.cutting_length, tool.name)
        )
    heights(obj, start)


def heights(obj, start):
    """Raises ValueError for heights of rapids that lie below a start in mm, or each other."""
    if obj.SafeHeight.Value < start:
        raise ValueError(
            "SafeHeight (%g mm) lies below StartDepth (%g mm): raise it."
            % (obj.SafeHeight.Value, start)
        )
    if obj.ClearanceHeight.Value < obj.SafeHeight.Value:
        raise ValueError(
            "ClearanceHeight (%g mm) lies below SafeHeight (%g mm): raise it."
            % (obj.ClearanceHeight.Value, obj.SafeHeight.Value)
        )


def levels(obj, top, depth, names):
    """The heights of the levels in mm from a top down to a depth, with StockToLeaveAxial upon it.
    Raises ValueError, with the names of the floors there, where there is nothing to cut.
    """
    last = depth + obj.StockToLeaveAxial.Value
    if not top > last:
        raise ValueError(
            "%s: nothing is to be cut down to %g mm, for the cut begins at %g mm; raise "
            "StartDepth, or take it out of the base geometry."
            % (listed(names, " and ", "others"), round(last, 4), round(top, 4))
        )
    return host.cutting_levels(top, obj.StepDown.Value, last)


def hole(obj, tool, floors):
    """(x, y, diameter) of the pre-drilled hole, or None."""
    diameter, at = obj.HoleDiameter.Value, obj.EntryPoint
    if obj.Entry not in HOLE_ENTRIES:
        return None
    if not diameter > 0:
        if obj.Entry == "Predrilled hole":
            raise ValueError(
                "Entry is 'Predrilled hole', but there is no hole: set EntryPoint and "
                "HoleDiameter."
            )
        return None
    if diameter < tool.diameter - 1e-9:
        raise ValueError(
            "HoleDiameter (%g mm) is smaller than the tool's diameter of %g mm: drill a "
            "larger hole or choose another Entry." % (diameter, tool.diameter)
        )
    if not any(floor.contains(at.x, at.y) for floor in floors):
        raise ValueError(
            "EntryPoint is (%g, %g), outside %s: move it inside."
            % (at.x, at.y, listed([floor.name for floor in floors], " and ", "others"))
        )
    return at.x, at.y, diameter


def open_side_at(obj):
    """(x, y) of the place near the open side over which the tool comes in, or None."""
    is_chosen = getattr(obj, "ChooseOpenSide", False) and obj.Entry == "Automatic"
    return (obj.OpenSideAt.x, obj.OpenSideAt.y) if is_chosen else None


def open_side(obj, floors):
    """Raises ValueError where the tool shall come in over an open side and there is none."""
    chains = [chain for floor in floors for chain in (floor.outer, *floor.islands)]
    if open_side_at(obj) and not any(vertex[3] for chain in chains for vertex in chain):
        raise ValueError(
            "No side of %s is open, over which the tool could come in: turn ChooseOpenSide off."
            % listed([floor.name for floor in floors], " and ", "others")
        )
