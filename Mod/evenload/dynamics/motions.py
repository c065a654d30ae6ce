"""Forced vibration: the wall that it leaves, and orbits with folds."""

from dataclasses import dataclass, field

import numpy

from evenload.dynamics.modes import core, rpm

CHIPS = ("circular", "velocity", "state-dependent")


@dataclass
class Surface:
    """What a cut leaves on the wall at its side; mm.

    surface_location_error: of the deepest points along the feed, that of largest magnitude along
    the axis; above 0 too much was removed, below 0 stock is left. least, most: its range.
    roughness: largest height of the cusps along the feed. waviness: most - least. is_stable:
    whether the cut is, without which nothing of this holds; None where an Frf does not tell.
    """

    surface_location_error: float
    least: float
    most: float
    roughness: float
    waviness: float
    is_stable: bool
    _core: object = field(repr=False)

    def profile(self, z, x):
        """The wall's offset outwards in mm, an array of heights z x places x along the feed, mm."""
        return 1e3 * numpy.array(
            [
                [self._core.offset(1e-3 * float(height), 1e-3 * float(place)) for place in row]
                for height, row in zip(numpy.ravel(z), [numpy.ravel(x)] * numpy.size(z))
            ]
        )

    def location_error(self, z):
        """The offset of the deepest points in mm at heights z in mm, an array."""
        return 1e3 * numpy.array(
            [self._core.location_error(1e-3 * float(height)) for height in numpy.ravel(z)]
        )


def surface(milling, speed, depth, feed_per_tooth, cut):
    """See Milling.surface()."""
    if cut != "finish wall":
        raise ValueError('cut is "finish wall", not %r.' % (cut,))
    found = core().Surface(
        milling.in_si(), milling.receptance(), rpm(speed), 1e-3 * depth, 1e-3 * feed_per_tooth
    )
    is_stable = None if milling.frf else milling.spectral_radius(speed, depth) < 1
    return Surface(*(1e3 * figure for figure in found.figures()), is_stable, found)


def surface_map(milling, speeds, depths, feed_per_tooth, threads, progress):
    """See Milling.surface_map()."""
    n, a = numpy.meshgrid(numpy.asarray(speeds, float), numpy.asarray(depths, float))
    errors = location_errors(milling, n.ravel(), a.ravel(), feed_per_tooth, threads, progress)
    return errors.reshape(n.shape)


def location_errors(milling, speeds, depths, feed_per_tooth, threads=0, progress=None):
    """Surface location errors in mm of pairs of speed and depth, in rev/min and mm."""
    found = core().location_errors(
        milling.in_si(),
        milling.receptance(),
        rpm(numpy.asarray(speeds, float)).tolist(),
        (1e-3 * numpy.asarray(depths, float)).tolist(),
        1e-3 * feed_per_tooth,
        threads,
        progress,
    )
    return 1e3 * numpy.array(found).reshape(-1, 3)[:, 0]


@dataclass
class OrbitPoint:
    """A periodic motion: depth and amplitude (half of its width) in mm, its largest multipliers."""

    depth: float
    amplitude: float
    multipliers: numpy.ndarray

    @property
    def spectral_radius(self):
        return float(abs(self.multipliers[0]))

    @property
    def is_stable(self):
        return self.spectral_radius < 1


@dataclass
class Orbits:
    """A branch of periodic motions, in the order in which it is followed.

    depth, amplitude (half of the motion's width), mm; spectral_radius; is_stable: arrays of one
    length. points: the same as OrbitPoints. folds: OrbitPoints at which the branch turns back, a
    multiplier is 1. boundaries: where stability changes between. bistable: (low, high) depths in mm
    between which more than one motion exists, None where there are no two folds.
    """

    points: list
    folds: list
    boundaries: list
    wanted: list = field(repr=False)

    @property
    def depth(self):
        return numpy.array([point.depth for point in self.points])

    @property
    def amplitude(self):
        return numpy.array([point.amplitude for point in self.points])

    @property
    def spectral_radius(self):
        return numpy.array([point.spectral_radius for point in self.points])

    @property
    def is_stable(self):
        return self.spectral_radius < 1

    @property
    def bistable(self):
        depths = [fold.depth for fold in self.folds]
        return (min(depths), max(depths)) if len(depths) > 1 else None

    def at(self, depth, tolerance=1e-9):
        """The OrbitPoints at one of the depths that were asked for, in the branch's order."""
        return [p for p in self.wanted if abs(p.depth - depth) <= tolerance + 1e-6 * depth]


def forced_orbits(milling, speed, depths, feed_per_tooth, chip, progress):
    """See Milling.forced_orbits()."""
    milling._demand_modes("A forced orbit")
    if chip not in CHIPS:
        raise ValueError("The chip is %s, not %r." % (", ".join(CHIPS), chip))
    points, boundaries = core().forced_orbits(
        milling.in_si(),
        rpm(speed),
        [1e-3 * float(depth) for depth in numpy.ravel(depths)],
        1e-3 * feed_per_tooth,
        chip != "circular",
        chip == "state-dependent",
        progress,
    )
    made = [(_point(row), row[3], row[4]) for row in points]
    return Orbits(
        [point for point, _, _ in made],
        [point for point, is_fold, _ in made if is_fold],
        [_point(row) for row in boundaries],
        [point for point, _, is_wanted in made if is_wanted],
    )


def thickness_deviation(milling, speed, depth, feed_per_tooth):
    """Largest change of chip thickness by the exact path of the tooth before, over the feed.

    Against the velocity model, on its periodic motion at this depth in mm.
    """
    return core().thickness_deviation(
        milling.in_si(), rpm(speed), 1e-3 * depth, 1e-3 * feed_per_tooth
    )


def _point(row):
    depth, amplitude, multipliers = row[:3]
    return OrbitPoint(1e3 * depth, 1e3 * amplitude, numpy.array(multipliers))
