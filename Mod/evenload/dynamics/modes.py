"""Modes of vibration at the tool's tip."""

import math
from dataclasses import dataclass

from evenload import compiled


def core():
    """The compiled part, in kg, m, s, N and rad."""
    return compiled.core().dynamics


def rpm(speed):
    """rad/s of a spindle speed in rev/min."""
    return speed * math.pi / 30


@dataclass(frozen=True)
class Mode:
    """A mode of vibration along one direction.

    mass: modal mass, kg, above 0. frequency: natural, undamped, Hz, above 0. damping_ratio: from 0
    to below 1; 1 % is 0.01. direction: degrees from x, counter-clockwise, in machine axes. Raises
    ValueError, in a sentence, for others.
    """

    mass: float
    frequency: float
    damping_ratio: float
    direction: float = 0.0

    def __post_init__(self):
        core().check_modes([self.in_si()])

    @classmethod
    def from_stiffness(cls, stiffness_n_per_um, frequency, damping_ratio, direction=0.0):
        """The mode of a stiffness in N/um in place of a mass."""
        if not stiffness_n_per_um > 0:
            raise ValueError("The stiffness of a mode must be above 0 N/um.")
        if not frequency > 0:
            raise ValueError("The frequency of a mode must be a number of Hz above 0.")
        mass = 1e6 * stiffness_n_per_um / (2 * math.pi * frequency) ** 2
        return cls(mass, frequency, damping_ratio, direction)

    @property
    def stiffness(self):
        """N/um."""
        return 1e-6 * self.mass * (2 * math.pi * self.frequency) ** 2

    def in_si(self):
        """The core's Mode."""
        return core().Mode(
            float(self.mass),
            2 * math.pi * float(self.frequency),
            float(self.damping_ratio),
            math.radians(float(self.direction)),
        )
