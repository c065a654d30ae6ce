"""Probing moves, and the radius of the probe's ball."""

import math

from evenload.inspection.points import normals_of, points_of


def compensated(centres, normals, probe_radius):
    """Points of contact, n x 3, from the centres of the probe's ball and the part's normals.

    Same unit of length for all. The ball touches opposite to the normal. Raises ValueError for a
    radius below 0.
    """
    centres = points_of(centres)
    if not (math.isfinite(probe_radius) and probe_radius >= 0):
        raise ValueError("The probe's radius is a number of at least 0, not %r." % (probe_radius,))
    return centres - probe_radius * normals_of(normals, len(centres))


def probing_moves(
    points, normals, probe_radius, clearance, overshoot, retract_height, rapid_feed, probe_feed
):
    """[(name, words)] of Path-like commands that probe points along their normals, G38.2.

    points, normals: n x 3, nominal, mm. Words X, Y, Z are of the ball's centre in mm, F in mm/min.
    Before each point the probe travels at retract_height by G0, which must lie above every place
    that is approached, comes down to `clearance` before the surface by G1 at rapid_feed, probes
    against the normal as far as `overshoot` behind the surface at probe_feed, returns and rises.
    Nothing but that height is checked for collisions: neither stem, part nor clamps. Raises
    ValueError, in a sentence, for numbers that are not above 0, a retract_height that is too low,
    and normals that look down, which a probe from above cannot reach.
    """
    points = points_of(points)
    normals = normals_of(normals, len(points))
    for name, value in {
        "clearance": clearance,
        "overshoot": overshoot,
        "rapid feed": rapid_feed,
        "probe feed": probe_feed,
    }.items():
        if not (math.isfinite(value) and value > 0):
            raise ValueError("The %s must be above 0, not %r." % (name, value))
    if len(points) and normals[:, 2].min() < -1e-9:
        raise ValueError("A normal looks down: a probe from above cannot reach its point.")
    centres = compensated(points, -normals, probe_radius)
    starts, ends = centres + clearance * normals, centres - overshoot * normals
    highest = float(starts[:, 2].max()) if len(points) else -math.inf
    if not retract_height >= highest:
        raise ValueError(
            "The retract height must be at least %.3f mm, above every approach." % highest
        )
    moves = []
    for start, end in zip(starts, ends):
        above = {"X": float(start[0]), "Y": float(start[1])}
        at_start = {**above, "Z": float(start[2])}
        moves += [
            ("G0", {"Z": float(retract_height)}),
            ("G0", above),
            ("G1", {**at_start, "F": float(rapid_feed)}),
            ("G38.2", {**dict(zip("XYZ", map(float, end))), "F": float(probe_feed)}),
            ("G1", {**at_start, "F": float(rapid_feed)}),
            ("G0", {"Z": float(retract_height)}),
        ]
    return moves
