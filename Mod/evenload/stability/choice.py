"""The best cut for an operation: what removes most, within limits. Needs no FreeCAD."""

import math

from evenload import compiled
from evenload.dynamics import best

DEPTHS = 60  # at which the force is looked at
MARGIN = 0.1  # of the largest multiplier below 1


def best_of(cut, speeds, deepest, margin=MARGIN, surface_limit=None, force_limit=None):
    """dynamics.Best of an operation's Cut: the spindle speed, depth and cut mode that remove most
    of those that are stable in all its feed directions; None where there is none.

    speeds: (low, high) in rev/min; deepest: mm; the spindle's speeds and the flutes hold besides.
    margin: the largest multiplier is at most 1 - margin. surface_limit: mm, largest surface
    location error; force_limit: N, peak in the plane, at the feed per tooth that the cut has; None:
    any. Raises ValueError, in a sentence; asks `waiting` whether to go on.
    """
    low, high = max(speeds[0], cut.speeds[0]), min(speeds[1], cut.speeds[1])
    if not low < high:
        raise ValueError("The spindle can do none of the chart's speeds.")
    if force_limit is not None:
        deepest = min(deepest, depth_within(cut, force_limit, deepest))
        if not deepest > 0:
            return None
    return best(
        cut.milling(),
        ((low, high), (0.0, deepest)),
        margin,
        surface_limit,
        cut.feed_per_tooth,
        feed_directions=cut.seen_directions,
    )


def force_at(cut, depth):
    """N: the peak of the cutting force in the plane, at a depth in mm; of climb as of conventional
    milling, whose forces are each other's mirror images.
    """
    edge = compiled.core().ForceCoefficients(
        *(cut.material[key] for key in ("ktc", "krc", "kte", "kre"))
    )
    model = compiled.core().ForceModel(
        edge, 0.5 * cut.diameter, cut.teeth, math.radians(cut.helix_angle)
    )
    arc = 0.5 * math.pi - math.radians(cut.engagement_deg), 0.5 * math.pi, depth
    return model.force([arc], cut.feed_per_tooth, cut.speed).peak_xy


def depth_within(cut, force_limit, deepest):
    """mm up to `deepest`, to a sixtieth of it: so deep keeps the force, and all that is less."""
    for step in range(1, DEPTHS + 1):
        if force_at(cut, deepest * step / DEPTHS) > force_limit:
            return deepest * (step - 1) / DEPTHS
    return deepest
