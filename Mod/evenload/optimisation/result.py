"""What an optimisation finds: candidates, and a table of them. Needs no FreeCAD."""

from collections import Counter
from dataclasses import dataclass, field

LIMITS = {  # what refuses a candidate, or holds its feed down, in words
    "tool size": "the tool's diameter",
    "cutting length": "the tools' cutting length",
    "spindle speed": "the spindle speed",
    "chip thickness": "the tools' chip thickness",
    "force": "the force",
    "torque": "the torque",
    "power": "the power",
    "machine feed": "the machine's feed",
    "left area": "the area left",
    "chatter": "chatter",
}


@dataclass
class Candidate:
    """A tool at an angle, a depth and a speed, with the largest feed within the limits. Figures are
    None where the candidate is refused before they are known; a feed that is refused has those of
    the least feed.
    """

    tool: str
    diameter: float  # mm
    teeth: int
    engagement_deg: float
    levels: int
    axial_depth: float  # mm
    spindle_speed: float  # rev/min
    surface_speed: float  # m/min
    refused: str = ""  # a sentence; empty: within all limits
    refused_by: str = ""  # one of LIMITS
    bound_by: str = ""  # one of LIMITS: why the feed is not larger
    feed_per_tooth: float = None  # mm
    feed: float = None  # mm/min, at the engagement angle
    time_s: float = None  # at the programmed feeds
    machine_time_s: float = None  # None without a machine
    ratio: float = None  # time_s over the least possible at the nominal removal rate
    force_peak_n: float = None
    torque_peak_nm: float = None
    power_w: float = None  # mean of a revolution, its largest
    h_max_mm: float = None
    spectral_radius: float = None  # below 1: stable; None where no modes are given
    left_area_mm2: float = None  # that the tool leaves, or cannot reach
    passes: int = None
    links: int = None
    retracts: int = None

    @property
    def seconds(self):
        """What candidates are ranked by."""
        return self.time_s if self.machine_time_s is None else self.machine_time_s


@dataclass
class Optimisation:
    """All candidates, in the order of tools, angles, levels and speeds; the best is None where
    none is within the limits, and `why` then says which limit refuses most.
    """

    candidates: list
    best: Candidate = None
    why: str = ""
    cancelled: bool = False
    notes: list = field(default_factory=list)

    def ranked(self):
        """The candidates within the limits, the fastest first."""
        return sorted((c for c in self.candidates if not c.refused), key=lambda c: c.seconds)

    def table(self, rows=20):
        """The fastest candidates as text, a line each, and what became of the others."""
        lines = [
            "%-16s %6s %6s %7s %7s %8s %8s %7s %7s %7s %7s  %s"
            % (
                *("tool", "angle", "levels", "depth", "rev/min", "mm/min", "time s"),
                *("force N", "Nm", "W", "h_max", "bound by"),
            )
        ]
        for c in self.ranked()[:rows]:
            lines.append(
                "%-16s %6g %6d %7.2f %7.0f %8.0f %8.1f %7.1f %7.3f %7.1f %7.4f  %s"
                % (
                    *(c.tool, c.engagement_deg, c.levels, c.axial_depth, c.spindle_speed, c.feed),
                    *(c.seconds, c.force_peak_n, c.torque_peak_nm, c.power_w, c.h_max_mm),
                    c.bound_by,
                )
            )
        refused = Counter(c.refused_by for c in self.candidates if c.refused)
        for limit, count in refused.most_common():
            lines.append("%d refused by %s" % (count, LIMITS[limit]))
        if self.why:
            lines.append(self.why)
        return "\n".join(lines)
