"""The cut that removes most of those that are stable and leave a straight wall."""

from collections import namedtuple

import numpy

from evenload.dynamics import charts, motions

SPEEDS, DEPTHS = 61, 50  # of the grid that is looked through
CHUNK = 200
CLOSER = 16  # steps by which a depth is raised to its limit

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
    deepest = min(d for d in (depths[1], depth_limit, milling.flute_length) if d)
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
        good = chunk[_will_do(milling, n[chunk], a[chunk], margin, surface_limit, feed)]
        if len(good):
            speed, depth = float(n[good[0]]), float(a[good[0]])
            most = min(depth + step, depths[-1])
            depth = _deepened(milling, speed, depth, most, margin, surface_limit, feed)
            return _row(milling, speed, depth, feed)
    return None


def _will_do(milling, speeds, depths, margin, limit, feed):
    """Whether each cut is stable with its margin, and straight; an array."""
    good = milling.spectral_radius(speeds, depths) <= 1 - margin
    if limit is not None and good.any():
        errors = motions.location_errors(milling, speeds[good], depths[good], feed)
        good[good] = abs(errors) <= limit
    return good


def _deepened(milling, speed, depth, most, margin, limit, feed):
    """As deep as it may be before the grid's next depth."""
    good, bad = depth, most
    for _ in range(CLOSER):
        middle = 0.5 * (good + bad)
        pair = numpy.array([speed]), numpy.array([middle])
        is_good = _will_do(milling, *pair, margin, limit, feed)[0]
        good, bad = (middle, bad) if is_good else (good, middle)
    return good


def _row(milling, speed, depth, feed):
    return Best(
        speed,
        depth,
        milling.cut_mode,
        milling.removal_rate(speed, depth, feed),
        milling.spectral_radius(speed, depth),
        float(motions.location_errors(milling, [speed], [depth], feed)[0]),
    )
