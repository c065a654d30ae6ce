"""The cut that removes most of those that are stable and leave a straight wall."""

from collections import namedtuple

import numpy

from evenload import waiting
from evenload.dynamics import charts, directions, motions

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
    feed_directions=None,
):
    """The Best cut: speed in rev/min, depth in mm, cut_mode, removal_rate in mm3/min, and its
    spectral_radius and surface_location_error (mm).

    chart: a Chart, or (speeds, depths) each (low, high): the box to choose from. margin: the radius
    is at most 1 - margin. surface_limit: largest magnitude of the surface location error, mm; None:
    any. feed_per_tooth: mm. cut_modes: those to choose from. depth_limit: mm, as of the flutes.
    feed_directions: degrees from machine X, of all of which the worst counts; None: milling's own.
    Returns None where no cut of the box will do. Asks `waiting` whether to go on.
    """
    if not 0 <= margin < 1:
        raise ValueError("The margin must lie from 0 to below 1.")
    speeds, depths = (chart.speeds, chart.depths) if hasattr(chart, "curves") else chart
    speeds, depths = charts.axis_of(speeds, "speeds"), charts.axis_of(depths, "depths")
    deepest = min(d for d in (depths[1], depth_limit, milling.flute_length) if d)
    n = numpy.linspace(speeds[0], speeds[1], SPEEDS)
    a = deepest * numpy.arange(1, DEPTHS + 1) / DEPTHS
    if feed_directions is None:
        feed_directions = [milling.feed_direction]
    found = [
        _Search(
            milling.changed(cut_mode=mode), feed_directions, margin, surface_limit, feed_per_tooth
        ).best_of(n, a)
        for mode in cut_modes
    ]
    found = [row for row in found if row]
    return max(found, key=lambda row: row.removal_rate) if found else None


class _Search:
    """One way of cutting: the candidates in falling order of what they remove."""

    def __init__(self, milling, feed_directions, margin, surface_limit, feed):
        self.milling, self.all = milling, numpy.asarray(feed_directions, dtype=float)
        self.most, self.surface_limit, self.feed = 1 - margin, surface_limit, feed

    def best_of(self, speeds, depths):
        n, a = (grid.ravel() for grid in numpy.meshgrid(speeds, depths))
        order = numpy.argsort(-n * a, kind="stable")
        step = depths[0]
        few = directions.spread(self.all, directions.FEW)
        for start in range(0, len(order), CHUNK):
            chunk = order[start : start + CHUNK]
            for k in chunk[self.will_do(n[chunk], a[chunk], few)]:
                # Few directions show what will not do; all of them what will.
                if self.will_do(n[k : k + 1], a[k : k + 1], self.all)[0]:
                    speed, depth = float(n[k]), float(a[k])
                    most = min(depth + step, depths[-1])
                    return self.row(speed, self.deepened(speed, depth, most))
        return None

    def will_do(self, speeds, depths, some):
        """Whether each cut is stable with its margin and straight in some directions; an array."""
        beyond = numpy.nextafter(self.most, 2)
        radii, _ = directions.worst_radii(self.milling, speeds, depths, some, enough=beyond)
        good = radii <= self.most
        if self.surface_limit is not None and good.any():
            errors = self.errors(speeds[good], depths[good])
            good[good] = abs(errors) <= self.surface_limit
        return good

    def errors(self, speeds, depths):
        """mm: surface location errors, each of the direction where it is largest."""
        worst = numpy.zeros(len(speeds))
        for direction in directions.spread(self.all, directions.FEW):
            waiting.go_on()
            turned = self.milling.changed(feed_direction=float(direction))
            found = motions.location_errors(turned, speeds, depths, self.feed)
            worst = numpy.where(abs(found) > abs(worst), found, worst)
        return worst

    def deepened(self, speed, depth, most):
        """As deep as it may be before the grid's next depth."""
        good, bad = depth, most
        for _ in range(CLOSER):
            middle = 0.5 * (good + bad)
            pair = numpy.array([speed]), numpy.array([middle])
            is_good = self.will_do(*pair, self.all)[0]
            good, bad = (middle, bad) if is_good else (good, middle)
        return good

    def row(self, speed, depth):
        pair = numpy.array([speed]), numpy.array([depth])
        return Best(
            speed,
            depth,
            self.milling.cut_mode,
            self.milling.removal_rate(speed, depth, self.feed),
            float(directions.worst_radii(self.milling, *pair, self.all)[0][0]),
            float(self.errors(*pair)[0]),
        )
