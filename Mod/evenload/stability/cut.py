"""The cut of an operation as milling dynamics has it, and the verdict on it. Needs no FreeCAD."""

import math
from dataclasses import dataclass, field

import numpy

from evenload.dynamics import Milling, Mode, directions

AROUND = 0.5, 1.5  # of the spindle speed: where a stable one is looked for
DEEPEST = 4.0  # times the depth: how deep the limit is looked for


@dataclass
class Cut:
    """What of an operation its stability depends on."""

    label: str
    modes: list  # of dynamics.Mode, in machine axes
    teeth: int
    diameter: float  # mm
    helix_angle: float  # degrees
    flute_length: float  # mm; None: not known
    engagement_deg: float
    cut_mode: str  # "climb" or "conventional"
    material: dict  # as of materials.load
    speed: float  # rev/min
    depth: float  # mm
    feed_per_tooth: float  # mm
    directions: numpy.ndarray  # degrees from machine X: those of the path's level cuts
    speeds: tuple = (0.0, math.inf)  # rev/min that the spindle can do
    process_damping: float = 0.0  # N/m
    is_reversed: bool = False  # whether the spindle turns counter-clockwise
    notes: list = field(default_factory=list)  # sentences on what was assumed

    def milling(self, **changes):
        """The process. A spindle that turns the other way round is seen in a mirror."""
        side = -1.0 if self.is_reversed else 1.0
        modes = [
            Mode(mode.mass, mode.frequency, mode.damping_ratio, side * mode.direction)
            for mode in self.modes
        ]
        arguments = {
            "modes": modes,
            "teeth": self.teeth,
            "tangential": self.material["ktc"],
            "normal": self.material["krc"],
            "cut_mode": self.cut_mode,
            "engagement_angle": self.engagement_deg,
            "diameter": self.diameter,
            "helix_angle": self.helix_angle,
            "process_damping": self.process_damping,
            "flute_length": self.flute_length,
        }
        return Milling(**{**arguments, **changes})

    @property
    def removal_rate(self):
        """mm3/min."""
        width = 0.5 * self.diameter * (1 - math.cos(math.radians(self.engagement_deg)))
        return self.depth * width * self.teeth * self.feed_per_tooth * self.speed

    @property
    def seen_directions(self):
        """The directions as `milling` has them."""
        return (-self.directions) % 180 if self.is_reversed else self.directions


@dataclass
class Verdict:
    """Whether a cut is stable in all feed directions of its path.

    spectral_radius: largest of all directions, stable below 1; feed_direction: degrees from machine
    X, where it is reached. limit_depth: mm, the least unstable depth at this speed; inf: none up to
    the flutes or four times the depth. chatter_hz: of the strongest vibration, chatter_kind:
    "Hopf", "flip" or "fold". stable_speed: rev/min, the nearest at which this depth is stable with
    a margin; None: none, or not needed. sentence: all that in words. notes: what was assumed.
    """

    is_stable: bool
    spectral_radius: float
    feed_direction: float
    limit_depth: float
    chatter_kind: str
    chatter_hz: float
    stable_speed: float
    sentence: str
    notes: list


def check(cut):
    """Raises ValueError, in a sentence, for a Cut that stability cannot be told of."""
    if not cut.speed > 0:
        raise ValueError("'%s' has no spindle speed: set the tool controller's." % cut.label)
    if not len(cut.directions):
        raise ValueError("'%s' has no level cut, whose stability could be told." % cut.label)


def worst_of(cut):
    """(largest multiplier, its feed direction as `milling` has it) of a Cut, in all directions of
    its path. Raises ValueError, in a sentence, for a cut that cannot be.
    """
    check(cut)
    radii, worst = directions.worst_radii(cut.milling(), cut.speed, cut.depth, cut.seen_directions)
    return float(radii), float(worst)


def judged(cut):
    """The Verdict on a Cut. Raises ValueError, in a sentence, for a cut that cannot be."""
    radius, direction = worst_of(cut)
    milling, all_of_them = cut.milling(), cut.seen_directions
    is_stable = radius < 1
    deepest = cut.depth if not is_stable else DEEPEST * cut.depth
    if cut.flute_length:
        deepest = min(deepest, cut.flute_length)
    limit = directions.limit_depth(milling, cut.speed, deepest, all_of_them)
    kind, chatter = milling.changed(feed_direction=direction).chatter(cut.speed, cut.depth)
    other = None
    if not is_stable:
        low, high = (share * cut.speed for share in AROUND)
        low, high = max(low, cut.speeds[0]), min(high, cut.speeds[1])
        if low < high:
            other = directions.nearest_stable_speed(
                milling, cut.speed, cut.depth, (low, high), all_of_them
            )
    if cut.is_reversed:
        direction = -direction % 180
    figures = is_stable, radius, direction, limit, kind, chatter, other
    return Verdict(*figures, _sentence(cut, *figures), list(cut.notes))


def _sentence(cut, is_stable, radius, direction, limit, kind, chatter, other):
    if is_stable:
        more = "" if math.isinf(limit) else ", up to %.3g mm deep" % limit
        return "The cut is stable at %.0f rev/min and %.3g mm%s." % (cut.speed, cut.depth, more)
    remedies = ["lower the step down below %.3g mm" % limit]
    if other:
        remedies.append("turn the spindle at %.0f rev/min" % other)
    return (
        "The cut is unstable: %.3g mm deep at %.0f rev/min it chatters near %.0f Hz, worst where"
        " the feed is at %.0f° to X; %s."
        % (cut.depth, cut.speed, chatter, direction, " or ".join(remedies))
    )
