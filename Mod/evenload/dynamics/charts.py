"""Stability charts, by multipliers or in the frequency domain."""

import functools
import math
import time

import numpy

from evenload.dynamics.modes import core, rpm

KINDS = ("Hopf", "flip", "fold")
METHODS = ("semi-discretisation", "multi-frequency", "zeroth-order")
FIRST_CELLS = 64, 32  # of speeds and depths, by default
FIRST_LOOK = 2  # each second line of the first grid is enough for a first picture
FREQUENCY_CELLS = (20, 12, 8)  # speed, depth and frequency, of the multi-frequency solution
HARMONICS = 8
LOBE_POINTS = 4000
DEPTH_STEPS = 60
HIGHEST_SHARE = 2.0  # of the highest mode's frequency, beyond which nothing grows


class Chart:
    """A stability chart.

    curves: list of n x 2 arrays, speed in rev/min and depth in mm. kind: for each curve n words,
    "Hopf", "flip" or "fold"; chatter_frequency: for each curve n numbers, Hz. evaluations: of
    multipliers or determinants. efficiency: 1/(D_P - 1), see mdbm(). seconds: what it took.
    speeds, depths: (low, high) of the box. method: as asked for.
    """

    def __init__(self, milling, speeds, depths, method, harmonics=HARMONICS):
        self.milling, self.method, self.harmonics = milling, method, harmonics
        self.speeds, self.depths = speeds[:2], depths[:2]
        self.curves, self.kind, self.chatter_frequency = [], [], []
        self.evaluations, self.efficiency, self.seconds = 0, math.nan, 0.0

    def picture(self, file, **options):
        """Draws it into a PNG or SVG file, see pictures.chart(); returns the figure."""
        from evenload.dynamics import pictures  # needs matplotlib

        return pictures.chart(self, file, **options)

    def is_stable(self, speed, depth):
        """Whether a cut is stable; rev/min and mm, numbers or arrays that broadcast."""
        if self.method == "semi-discretisation":
            stable = numpy.asarray(self.milling.spectral_radius(speed, depth)) < 1
        else:
            speeds, depths = numpy.broadcast_arrays(speed, depth)
            domain = _domain(self.milling, 0 if self.method == "zeroth-order" else self.harmonics)
            highest = HIGHEST_SHARE * _highest(self.milling)
            stable = numpy.array(
                [
                    domain.unstable_count(rpm(float(n)), 1e-3 * float(a), highest) == 0
                    for n, a in zip(speeds.ravel(), depths.ravel())
                ]
            ).reshape(speeds.shape)
        return bool(stable) if stable.ndim == 0 else stable


def chart(milling, speeds, depths, method, tolerance, harmonics=None, threads=0, progress=None):
    """See Milling.chart()."""
    if method not in METHODS:
        raise ValueError("The method of a chart is %s, not %r." % (", ".join(METHODS), method))
    if not 0 < tolerance < 1:
        raise ValueError("The tolerance of a chart must lie between 0 and 1.")
    if method == "semi-discretisation":
        return list(levels(milling, speeds, depths, tolerance, threads, progress, only_last=True))[
            0
        ]
    if method == "zeroth-order":
        return _zeroth_order(milling, speeds, depths)
    return _multi_frequency(milling, speeds, depths, tolerance, harmonics, threads, progress)


def levels(milling, speeds, depths, tolerance, threads, progress, only_last=False):
    """See Milling.chart_levels()."""
    milling._demand_modes("A chart by multipliers")
    speeds, depths = axis_of(speeds, "speeds"), axis_of(depths, "depths", FIRST_CELLS[1])
    milling.check_depth(depths[1])
    start = time.perf_counter()
    work = core().StabilityChart(milling.in_si(), *_in_si(speeds, depths), threads)
    steps = [work.begin] + [work.halve] * _halvings(speeds[2], tolerance)
    if not only_last and speeds[2] % FIRST_LOOK == depths[2] % FIRST_LOOK == 0:
        steps.insert(0, functools.partial(work.begin, every=FIRST_LOOK))
    told = _Told(progress, len(steps) + 1)
    for number, step in enumerate(steps):
        told.part = number
        step(told.callback)
        if only_last and number < len(steps) - 1:
            continue
        found = Chart(milling, speeds, depths, "semi-discretisation")
        for n, a, kinds, frequencies in work.curves(told.callback):
            found.curves.append(numpy.column_stack([numpy.array(n) / rpm(1), 1e3 * numpy.array(a)]))
            found.kind.append([KINDS[kind] for kind in kinds])
            found.chatter_frequency.append(numpy.array(frequencies) / (2 * math.pi))
        found.evaluations, found.efficiency = work.evaluations, work.efficiency
        found.seconds = time.perf_counter() - start
        yield found


class _Told:
    """The share done of work in parts, which never turns back."""

    def __init__(self, progress, parts):
        self.progress, self.parts, self.part, self.share = progress, parts, 0, 0.0
        self.callback = self._tell if progress else None

    def _tell(self, share):
        self.share = max(self.share, (self.part + share) / self.parts)
        return self.progress(self.share)


def _multi_frequency(milling, speeds, depths, tolerance, harmonics, threads, progress):
    harmonics = HARMONICS if harmonics is None else int(harmonics)
    speeds, depths = (
        axis_of(given, what, cells)
        for given, what, cells in zip((speeds, depths), ("speeds", "depths"), FREQUENCY_CELLS)
    )
    start = time.perf_counter()
    found = Chart(milling, speeds, depths, "multi-frequency", harmonics)
    work = core().FrequencyChart(
        _domain(milling, harmonics),
        *_in_si(speeds, depths),
        2 * math.pi * _strongest(milling),
        FREQUENCY_CELLS[2],
        threads,
    )
    halvings = _halvings(speeds[2], tolerance)
    told = _Told(progress, halvings + 1)
    work.begin(told.callback)
    for told.part in range(1, halvings + 1):
        work.halve(told.callback)
    _take_lines(found, work.curves(), milling, harmonics)
    found.evaluations, found.efficiency = work.evaluations, work.efficiency
    found.seconds = time.perf_counter() - start
    return found


def _zeroth_order(milling, speeds, depths):
    speeds, depths = axis_of(speeds, "speeds"), axis_of(depths, "depths", FIRST_CELLS[1])
    start = time.perf_counter()
    found = Chart(milling, speeds, depths, "zeroth-order", 0)
    highest = HIGHEST_SHARE * _highest(milling)
    lines = core().zeroth_order_lobes(
        milling.in_si(),
        milling.receptance(),
        *_in_si(speeds, depths),
        1e-3 * highest,
        highest,
        LOBE_POINTS,
    )
    _take_lines(found, lines, milling, 0)
    found.evaluations = LOBE_POINTS
    found.seconds = time.perf_counter() - start
    return found


def _take_lines(found, lines, milling, harmonics):
    """Curves from rows of speed, depth and frequency; half the base is a period doubling."""
    for line in lines:
        rows = numpy.array(line).reshape(-1, 3)
        found.curves.append(numpy.column_stack([rows[:, 0] / rpm(1), 1e3 * rows[:, 1]]))
        teeth = 1 if milling.tooth_angles is not None else milling.teeth
        share = numpy.mod(rows[:, 2] / (teeth * rows[:, 0]), 1.0)
        flips = (numpy.abs(share - 0.5) < 1e-3) & (harmonics > 0)
        found.kind.append(["flip" if flip else "Hopf" for flip in flips])
        found.chatter_frequency.append(rows[:, 2] / (2 * math.pi))


def limit(milling, speed, depth, frequency, harmonics=HARMONICS):
    """(depth in mm, chatter frequency in Hz) at which a vibration neither grows nor dies.

    The multi-frequency solution with so many harmonics on each side, 0 = zeroth order, at a spindle
    speed in rev/min, from a guess of depth and frequency. Raises ValueError where none is near.
    """
    is_found, depth, angular = _domain(milling, harmonics).find_limit(
        rpm(speed), 1e-3 * depth, 2 * math.pi * frequency
    )
    if not is_found:
        raise ValueError("No limit was found near this depth and frequency.")
    return 1e3 * depth, angular / (2 * math.pi)


def zeroth_order(milling, frequency):
    """[(depth in mm, phase in rad)] of the zeroth order at a chatter frequency in Hz."""
    found = core().zeroth_order(milling.in_si(), milling.receptance(), 2 * math.pi * frequency)
    return [(1e3 * depth, phase) for depth, phase in found]


def critical_depth(milling, speed, largest, harmonics=HARMONICS):
    """The least unstable depth in mm in the frequency domain, to a thousandth; inf if none."""
    domain, highest = _domain(milling, harmonics), HIGHEST_SHARE * _highest(milling)

    def is_unstable(depth):
        return domain.unstable_count(rpm(speed), 1e-3 * depth, highest) > 0

    low = 0.0
    for step in range(1, DEPTH_STEPS + 1):
        high = largest * step / DEPTH_STEPS
        if is_unstable(high):
            while high - low > 1e-4 * high:
                middle = 0.5 * (low + high)
                low, high = (low, middle) if is_unstable(middle) else (middle, high)
            return high
        low = high
    return math.inf


def axis_of(given, what, cells=FIRST_CELLS[0]):
    """(low, high, cells) of what the user gave: a tuple of two or three, or a rising grid."""
    numbers = [float(number) for number in numpy.ravel(given)]
    rises = all(a < b for a, b in zip(numbers, numbers[1:]))
    if len(numbers) == 2 and rises:
        return numbers[0], numbers[1], cells
    if len(numbers) == 3 and numbers[0] < numbers[1] and (isinstance(given, tuple) or not rises):
        if numbers[2] == int(numbers[2]) >= 1:
            return numbers[0], numbers[1], int(numbers[2])
    if len(numbers) < 3 or not rises:
        raise ValueError(
            "The %s of a chart are (low, high), (low, high, cells) or a rising grid." % what
        )
    return numbers[0], numbers[-1], len(numbers) - 1


def _in_si(speeds, depths):
    return (
        (rpm(speeds[0]), rpm(speeds[1]), speeds[2]),
        (1e-3 * depths[0], 1e-3 * depths[1], depths[2]),
    )


def _halvings(cells, tolerance):
    return max(0, math.ceil(math.log2(1 / (tolerance * cells)) - 1e-9))


def _domain(milling, harmonics):
    return core().FrequencyDomain(milling.in_si(), milling.receptance(), int(harmonics))


def _strongest(milling):
    """Hz of the most flexible mode."""
    if milling.frf:
        return milling.frf.strongest
    return max(
        milling.modes, key=lambda m: 1 / (m.stiffness * max(m.damping_ratio, 1e-6))
    ).frequency


def _highest(milling):
    """rad/s of the highest mode, or of the response's last line."""
    if milling.frf:
        return 2 * math.pi * float(milling.frf.frequencies[-1])
    return 2 * math.pi * max(mode.frequency for mode in milling.modes)
