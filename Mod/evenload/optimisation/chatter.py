"""Chatter as one more limit: which spindle speeds are stable at a depth. Needs no FreeCAD."""

from evenload import materials, waiting
from evenload.dynamics import Milling, directions, vibration


def modes_of(given, name):
    """The modes of vibration of a tool, None where none are given. Raises ValueError."""
    if given is None:
        return None
    try:
        return vibration.load(given).modes
    except ValueError as error:
        raise ValueError("modes of %s: %s" % (name, error)) from None


def check_margin(margin):
    """Raises ValueError for a margin of the largest multiplier that cannot be."""
    if not materials.number(margin) or not 0 <= margin < 1:
        raise ValueError("stability_margin must be 0 or more and below 1, not %r." % (margin,))


def judge(rows, tool, path, height, task, watch):
    """Sets spectral_radius of candidates of one path and height, and tells what refuses them.

    rows: Candidates that differ in their spindle speed. watch: asked with 0 whether to go on;
    raises waiting.Stopped. Yields (candidate, sentence) for each that is not stable in all feed
    directions.
    """
    milling = Milling(
        tool.modes,
        tool.teeth,
        tool.material["ktc"],
        tool.material["krc"],
        cut_mode=task.cut_mode,
        engagement_angle=rows[0].engagement_deg,
        diameter=tool.diameter,
        helix_angle=tool.helix_angle_deg,
    )
    along = directions.of_moves(path.moves(height, 1, path.feed))
    most = 1 - task.stability_margin
    speeds = [row.spindle_speed for row in rows]
    with waiting.asking(watch):
        radii, worst = directions.worst_radii(milling, speeds, height, along, enough=most)
    for row, radius, direction in zip(rows, radii, worst):
        row.spectral_radius = float(radius)
        if radius >= most:
            yield row, (
                "%s %s %.3g mm deep at %.5g rev/min and %g°, where the feed is at %g° to X."
                % (
                    *(tool.name, "chatters" if radius >= 1 else "nearly chatters"),
                    *(height, row.spindle_speed, row.engagement_deg, direction),
                )
            )
