"""Stability over the feed directions of a path: the least stable one counts."""

import math

import numpy

from evenload import planar, waiting

ALL = numpy.arange(180.0)  # degrees; a feed and its opposite are alike
FEW = 18  # directions that a search looks at before it looks at all
CHUNK = 60  # cuts between two questions whether to go on: some hundredths of a second
DEPTHS, SPEEDS = 60, 121  # of the grids that limits and stable speeds are looked for on
BISECTIONS = 12
LEVEL = 1e-6  # mm


def of_moves(moves):
    """The whole degrees from 0 to 179 along which the level feed moves of a path go; an array.

    moves: (kind, x, y, z, sweep, cx, cy, feed), mm and rad, of which the first says where the tool
    is. Arcs have all directions between those of their ends.
    """
    found = numpy.zeros(len(ALL), dtype=bool)
    x = y = z = None
    for kind, nx, ny, nz, sweep, cx, cy, _ in moves:
        if x is not None and kind != planar.RAPID and abs(nz - z) < LEVEL:
            if sweep:
                first = math.degrees(math.atan2(y - cy, x - cx)) + 90
                last = first + math.degrees(sweep)
                low, high = round(min(first, last)), round(max(first, last))
                found[numpy.arange(low, min(high, low + len(ALL)) + 1) % len(ALL)] = True
            elif math.hypot(nx - x, ny - y) > LEVEL:
                found[round(math.degrees(math.atan2(ny - y, nx - x))) % len(ALL)] = True
        x, y, z = nx, ny, nz
    return numpy.flatnonzero(found).astype(float)


def spread(directions, count):
    """At most `count` of some directions, as evenly as they come; always the first one."""
    directions = numpy.asarray(directions, dtype=float)
    if len(directions) <= count:
        return directions
    return directions[(numpy.arange(count) * len(directions)) // count]


def worst_radii(milling, speeds, depths, directions=ALL, enough=math.inf, accuracy=1e-3):
    """(radii, directions) of the least stable direction of each cut; arrays.

    speeds, depths: rev/min and mm, arrays that broadcast. directions: degrees from machine X.
    enough: a cut whose radius reaches it is looked at in no further direction. Asks `waiting`
    whether to go on, and raises waiting.Stopped.
    """
    speeds, depths = numpy.broadcast_arrays(
        numpy.asarray(speeds, dtype=float), numpy.asarray(depths, dtype=float)
    )
    n, a = speeds.ravel(), depths.ravel()
    radii, worst = numpy.full(n.shape, -1.0), numpy.zeros(n.shape)
    for direction in _from_coarse_to_fine(directions):
        turned = milling.changed(feed_direction=float(direction))
        waits = numpy.flatnonzero(radii < enough)
        for start in range(0, len(waits), CHUNK):
            waiting.go_on()
            some = waits[start : start + CHUNK]
            found = turned.spectral_radius(n[some], a[some], accuracy)
            larger = found > radii[some]
            radii[some[larger]], worst[some[larger]] = found[larger], direction
    return radii.reshape(speeds.shape), worst.reshape(speeds.shape)


def limit_depth(milling, speed, largest, directions=ALL):
    """The least depth in mm, up to `largest`, at which a direction is unstable; inf if none is."""

    def is_unstable(depth):
        return worst_radii(milling, speed, depth, directions, enough=1.0)[0] >= 1

    depths = largest * numpy.arange(1, DEPTHS + 1) / DEPTHS
    radii, _ = worst_radii(milling, speed, depths, spread(directions, FEW), enough=1.0)
    unstable = numpy.flatnonzero(radii >= 1)
    first = unstable[0] if len(unstable) else DEPTHS - 1
    if not len(unstable) and not is_unstable(largest):
        return math.inf
    high = depths[first]
    while first > 0 and is_unstable(depths[first - 1]):
        first -= 1
        high = depths[first]
    low = depths[first - 1] if first else 0.0
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if is_unstable(middle) else (middle, high)
    return float(high)


def nearest_stable_speed(milling, speed, depth, speeds, directions=ALL, margin=0.05):
    """rev/min within (low, high) nearest to `speed` at which a depth in mm is stable in all
    directions, the radius being at most 1 - margin; None if there is none.
    """
    grid = numpy.linspace(*speeds, SPEEDS)
    most = 1 - margin
    radii, _ = worst_radii(milling, grid, depth, spread(directions, FEW), enough=most)
    possible = grid[radii < most]
    for candidate in possible[numpy.argsort(abs(possible - speed), kind="stable")]:
        if worst_radii(milling, candidate, depth, directions, enough=most)[0] < most:
            return float(candidate)
    return None


def _from_coarse_to_fine(directions):
    """Spread over the circle from the beginning: what is unstable shows after few of them."""
    directions = numpy.atleast_1d(numpy.asarray(directions, dtype=float))
    if not len(directions):
        raise ValueError("There is no feed direction: the path has no level cut.")
    bits = max(1, (len(directions) - 1).bit_length())
    keys = [int(format(i, "0%db" % bits)[::-1], 2) for i in range(len(directions))]
    return directions[numpy.argsort(keys)]
