"""The cut that removes most of those that are stable and leave a straight wall."""

from collections import namedtuple

import numpy

from evenload.dynamics import charts

SPEEDS, DEPTHS = 81, 60  # of the grid that is looked through
CHUNK = 200
CLOSER = 24  # steps by which a depth is raised to its limit

Best = namedtuple(
    "Best", "speed depth cut_mode removal_rate spectral_radius surface_location_error"
)


def best(
    milling,
    chart,
    margin=0.1,
    surface_limit=None,
    feed_per_tooth=0.1,
    cut_modes=("climb", "conventional"),
    depth_limit=None,
):
    """The Best cut: speed in rev/min, depth in mm, cut_mode, removal_rate in mm3/min, and its
    spectral_radius and surface_location_error (mm).

    chart: a Chart, or (speeds, depths) each (low, high): the box to choose from. margin: the radius
    is at most 1 - margin. surface_limit: largest magnitude of the surface location error, mm; None:
    any. feed_per_tooth: mm. cut_modes: those to choose from. depth_limit: mm, as of the flutes.
    Returns None where no cut of the box will do.
    """
    if not 0 <= margin < 1:
        raise ValueError("The margin must lie from 0 to below 1.")
    speeds, depths = (chart.speeds, chart.depths) if hasattr(chart, "curves") else chart
    speeds, depths = charts.axis_of(speeds, "speeds"), charts.axis_of(depths, "depths")
    deepest = min(depths[1], depth_limit or depths[1])
    n = numpy.linspace(speeds[0], speeds[1], SPEEDS)
    a = deepest * numpy.arange(1, DEPTHS + 1) / DEPTHS
    found = [
        _best_of(milling.changed(cut_mode=mode), n, a, margin, surface_limit, feed_per_tooth)
        for mode in cut_modes
    ]
    found = [row for row in found if row]
    return max(found, key=lambda row: row.removal_rate) if found else None


def _best_of(milling, speeds, depths, margin, surface_limit, feed):
    """The same for one way of cutting: the candidates in falling order of what they remove."""
    n, a = (grid.ravel() for grid in numpy.meshgrid(speeds, depths))
    order = numpy.argsort(-n * a, kind="stable")
    step = depths[0]
    for start in range(0, len(order), CHUNK):
        chunk = order[start : start + CHUNK]
        radii = milling.spectral_radius(n[chunk], a[chunk])
        for i in chunk[radii <= 1 - margin]:
            if _is_straight(milling, n[i], a[i], feed, surface_limit):
                most = min(a[i] + step, depths[-1])
                depth = _deepened(milling, n[i], a[i], most, margin, surface_limit, feed)
                return _row(milling, float(n[i]), float(depth), feed)
    return None


def _is_straight(milling, speed, depth, feed, limit):
    if limit is None:
        return True
    return abs(milling.surface_map([speed], [depth], feed)[0, 0]) <= limit


def _deepened(milling, speed, depth, most, margin, limit, feed):
    """As deep as it may be before the grid's next depth."""
    good, bad = depth, most
    for _ in range(CLOSER):
        middle = 0.5 * (good + bad)
        is_good = milling.spectral_radius(speed, middle) <= 1 - margin and _is_straight(
            milling, speed, middle, feed, limit
        )
        good, bad = (middle, bad) if is_good else (good, middle)
    return good


def _row(milling, speed, depth, feed):
    return Best(
        speed,
        depth,
        milling.cut_mode,
        milling.removal_rate(speed, depth, feed),
        milling.spectral_radius(speed, depth),
        float(milling.surface_map([speed], [depth], feed)[0, 0]),
    )
