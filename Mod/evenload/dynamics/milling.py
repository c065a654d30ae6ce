"""A milling process: its stability, its forced vibration, the wall that it leaves."""

import math
from collections import namedtuple

import numpy

from evenload.dynamics import charts, motions
from evenload.dynamics.frf import Frf
from evenload.dynamics.modes import core, rpm

CUT_MODES = ("climb", "conventional")
DIRECTIONS = 180  # feed directions that are looked at for the worst one
ACCURATE = 1e-6

OptimalDepths = namedtuple("OptimalDepths", "trivial non_trivial")


class Milling:
    """A tool, how it cuts, and what vibrates.

    modes: a list of Modes in machine axes, or an Frf, for what asks for no modes. teeth: 1 or more.
    tangential, normal: cutting coefficients, N/mm2. cut_mode: "climb" or "conventional". immersion:
    radial depth over diameter, above 0 to 1; or engagement_angle, degrees. diameter: mm.
    helix_pitch: lead of the helix, mm, None = straight; or helix_angle, degrees. tooth_angles:
    pitch angles to the tooth ahead, degrees, sum 360, None = even. feed_direction: degrees from
    machine X. process_damping: C of the flank, N/m, some 1e5 for steel and aluminium.
    flank_friction: ratio. flute_length: mm, None = long enough; deeper cuts are refused. Raises
    ValueError, in a sentence, for numbers that cannot be. Sources: [Bachrathy 2013].
    """

    def __init__(
        self,
        modes,
        teeth,
        tangential,
        normal,
        cut_mode="climb",
        immersion=1.0,
        diameter=10,
        helix_pitch=None,
        tooth_angles=None,
        feed_direction=0,
        process_damping=0,
        flank_friction=0,
        *,
        engagement_angle=None,
        helix_angle=None,
        flute_length=None,
    ):
        if cut_mode not in CUT_MODES:
            raise ValueError('cut_mode is "climb" or "conventional", not %r.' % (cut_mode,))
        if engagement_angle is None:
            if not 0 < immersion <= 1:
                raise ValueError(
                    "The immersion must lie above 0, where nothing is cut, and at most at 1."
                )
            engagement_angle = math.degrees(math.acos(1 - 2 * immersion))
        if helix_angle is not None:
            if helix_pitch is not None:
                raise ValueError("Give the helix_pitch or the helix_angle, not both.")
            if not 0 <= helix_angle < 90:
                raise ValueError("The helix angle must lie from 0 to below 90 degrees.")
            if helix_angle > 0:
                helix_pitch = math.pi * diameter / math.tan(math.radians(helix_angle))
        if helix_pitch is not None and not helix_pitch > 0:
            raise ValueError("The lead of the helix must be above 0 mm, or None for straight.")
        self.frf = modes if isinstance(modes, Frf) else None
        self.modes = [] if self.frf else list(modes)
        self.teeth, self.tangential, self.normal = teeth, tangential, normal
        self.cut_mode, self.engagement_angle, self.diameter = cut_mode, engagement_angle, diameter
        self.helix_pitch, self.tooth_angles = helix_pitch, tooth_angles
        self.feed_direction, self.flute_length = feed_direction, flute_length
        self.process_damping, self.flank_friction = process_damping, flank_friction
        self.in_si()

    def changed(self, **changes):
        """The same process with other values for some of the arguments."""
        words = (
            "teeth tangential normal cut_mode engagement_angle diameter helix_pitch tooth_angles"
            " feed_direction process_damping flank_friction flute_length"
        )
        arguments = {word: getattr(self, word) for word in words.split()}
        arguments["modes"] = self.frf or self.modes
        if "immersion" in changes:
            del arguments["engagement_angle"]
        if "helix_angle" in changes:
            del arguments["helix_pitch"]
        return Milling(**{**arguments, **changes})

    @property
    def immersion(self):
        """Radial depth over diameter."""
        return 0.5 * (1 - math.cos(math.radians(self.engagement_angle)))

    def removal_rate(self, speed, depth, feed_per_tooth):
        """mm3/min."""
        return depth * self.immersion * self.diameter * self.teeth * feed_per_tooth * speed

    # ---- stability ----

    def spectral_radius(self, speed, depth, accuracy=1e-3):
        """The largest modulus of a multiplier of the period: below 1 the cut is stable.

        speed: rev/min, depth: mm; numbers, or arrays that broadcast, then an array. accuracy: the
        error that is aimed at, relative where the radius is above 1. The period is the passing of a
        tooth, or with tooth_angles a revolution. Raises ValueError for what cannot be.
        """
        self._demand_modes("The spectral radius")
        self.check_depth(depth)
        speeds, depths = numpy.broadcast_arrays(
            numpy.asarray(speed, dtype=float), numpy.asarray(depth, dtype=float)
        )
        found = core().spectral_radii(
            self.in_si(),
            (rpm(speeds)).ravel().tolist(),
            (1e-3 * depths).ravel().tolist(),
            float(accuracy),
            0 if speeds.size > 1 else 1,
            None,
        )
        return numpy.array(found).reshape(speeds.shape) if speeds.shape else found[0]

    def worst_spectral_radius(self, speed, depth, directions=None, accuracy=1e-3):
        """(radius, feed direction in degrees) of the least stable feed direction.

        directions: degrees from machine X, those of a path's tangents; None: 180 all around.
        """
        if directions is None:
            directions = numpy.arange(DIRECTIONS) * 180.0 / DIRECTIONS
        radii = [
            self.changed(feed_direction=float(direction)).spectral_radius(speed, depth, accuracy)
            for direction in directions
        ]
        worst = int(numpy.argmax(radii))
        return radii[worst], float(directions[worst])

    def multipliers(self, speed, depth, count=6):
        """The largest multipliers of the period map, complex, the largest first.

        `count` of them are accurate where there are so many; more may follow that are rough.
        """
        self._demand_modes("The multipliers")
        self.check_depth(depth)
        found = core().multipliers(self.in_si(), rpm(speed), 1e-3 * depth, ACCURATE, int(count))
        return numpy.array(found)[:count]

    def critical_depth(self, speed, largest):
        """The least depth in mm, up to `largest`, at which the cut is unstable; inf if none is."""
        self.check_depth(largest)
        if self.frf:
            return charts.critical_depth(self, speed, largest)
        return 1e3 * core().critical_depth(self.in_si(), rpm(speed), 1e-3 * largest, ACCURATE)

    def chatter(self, speed, depth):
        """(kind, frequency in Hz) of the vibration that dies last, or grows.

        kind: "Hopf", "flip" or "fold"; the frequency of its strongest part at the tip.
        """
        self._demand_modes("The chatter frequency")
        self.check_depth(depth)
        _, frequency, kind = core().strongest_vibration(self.in_si(), rpm(speed), 1e-3 * depth)
        return charts.KINDS[kind], frequency / (2 * math.pi)

    def chart(self, speeds, depths, method="semi-discretisation", tolerance=1 / 512, **options):
        """The stability Chart over spindle speeds and depths.

        speeds, depths: (low, high), (low, high, cells of the first grid), or a rising grid, in
        rev/min and mm. method: "semi-discretisation" (multipliers), "multi-frequency" or
        "zeroth-order" (both from modes or an Frf). tolerance: width of the last cells over the box;
        points lie much nearer to the boundary. options: harmonics, of the multi-frequency solution;
        threads, 0 = all; progress, asked with the share done, answers whether to go on.
        """
        return charts.chart(self, speeds, depths, method, tolerance, **options)

    def chart_levels(self, speeds, depths, tolerance=1 / 512, threads=0, progress=None):
        """The same chart by multipliers, yielded after a look at each second line of the first grid
        (where its cells are even in number), after the grid and after each halving."""
        return charts.levels(self, speeds, depths, tolerance, threads, progress)

    # ---- forced vibration ----

    def surface(self, speed, depth, feed_per_tooth, cut="finish wall"):
        """The Surface that a stable cut leaves on the wall at its side.

        feed_per_tooth: mean over the teeth, mm. cut: "finish wall" is the only one there is.
        """
        self.check_depth(depth)
        return motions.surface(self, speed, depth, feed_per_tooth, cut)

    def surface_map(self, speeds, depths, feed_per_tooth, threads=0, progress=None):
        """Largest surface location errors in mm, an array of depths x speeds."""
        return motions.surface_map(self, speeds, depths, feed_per_tooth, threads, progress)

    def optimal_depths(self, speed, frequency, largest):
        """OptimalDepths(trivial, non_trivial) in mm up to `largest`, for a mode of `frequency` Hz.

        trivial: j p/N, where the teeth's force is constant, so that nothing is forced to vibrate;
        non_trivial: j p n/(60 f), where a tooth's pass leaves no vibration of the mode. None for
        straight teeth. [Bachrathy 2013, thesis 3].
        """
        if self.helix_pitch is None:
            return OptimalDepths([], [])
        if not (speed > 0 and frequency > 0):
            raise ValueError("Speed and frequency must be above 0.")
        steps = (self.helix_pitch / self.teeth, self.helix_pitch * speed / (60 * frequency))
        return OptimalDepths(
            *([step * j for j in range(1, int(largest / step + 1e-9) + 1)] for step in steps)
        )

    def forced_orbits(self, speed, depths, feed_per_tooth, chip="velocity", progress=None):
        """The Orbits: periodic motions along a branch in depth, with its folds.

        depths: mm; the branch is followed from the least to the largest, around folds, and each of
        them gets points of its own. chip: "circular", "velocity" (thickness and force follow the
        edge's own velocity) or "state-dependent" (the exact path of the tooth before, too). The
        flank pushes only while its edge moves into the work. Even pitch only.
        """
        return motions.forced_orbits(self, speed, depths, feed_per_tooth, chip, progress)

    # ---- for the core ----

    def in_si(self):
        """The core's Milling; raises ValueError for numbers that cannot be."""
        m = core().Milling()
        # What asks for no modes needs a stand-in that passes the checks.
        m.modes = [mode.in_si() for mode in self.modes]
        if self.frf:
            m.modes = [core().Mode(1.0, 2 * math.pi * self.frf.strongest, 0.01, 0.0)]
        m.teeth = int(self.teeth)
        m.tangential, m.normal = 1e6 * self.tangential, 1e6 * self.normal
        m.climb = self.cut_mode == "climb"
        m.engagement = min(math.radians(self.engagement_angle), math.pi)
        m.radius = 0.5e-3 * self.diameter
        m.lead = 1e-3 * (self.helix_pitch or 0.0)
        if self.tooth_angles is not None:
            m.tooth_angles = [math.radians(angle) for angle in self.tooth_angles]
        m.feed_direction = math.radians(self.feed_direction)
        m.process_damping, m.flank_friction = float(self.process_damping), float(
            self.flank_friction
        )
        m.check()
        return m

    def receptance(self):
        """The core's Receptance, in machine axes."""
        if self.frf:
            return self.frf.receptance()
        return core().Receptance.of_modes([mode.in_si() for mode in self.modes])

    def check_depth(self, depth):
        """Raises ValueError for a depth in mm, or an array of them, beyond the flutes."""
        deepest = float(numpy.max(depth))
        if self.flute_length is not None and deepest > self.flute_length:
            raise ValueError(
                "The depth of %g mm is beyond the tool's flutes, %g mm."
                % (deepest, self.flute_length)
            )

    def _demand_modes(self, what):
        if self.frf:
            raise ValueError(
                "%s needs modes: fit them to the frequency response with frf.fit()." % what
            )
