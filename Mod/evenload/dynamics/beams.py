"""The tip's frequency response of a tool in a holder that was measured once."""

import math

import numpy

from evenload.dynamics.frf import Frf
from evenload.dynamics.modes import core

# modulus in GPa, density in kg/m3, Poisson's ratio, loss factor
MATERIALS = {
    "carbide": (580.0, 14450.0, 0.22, 0.003),
    "steel": (205.0, 7850.0, 0.29, 0.003),
    "high-speed steel": (220.0, 8100.0, 0.29, 0.003),
}
STEP = 1.0  # Hz between lines where no frequencies are asked for


def couple(holder_frf, tool_segments, material, joint=None, frequencies=None, highest=5000.0):
    """The Frf at the tip of a tool, from the holder's response and the tool's dimensions.

    holder_frf: an Frf at the holder's face, a list of Modes, or None for a rigid holder; its
    rotations are taken as 0. tool_segments: (length, diameter) in mm of each cylinder outside of
    the holder, the tip's first; a third entry is a material of its own; fluted parts have about 0.8
    of their diameter. material: a name of MATERIALS, or (modulus in GPa, density in kg/m3,
    Poisson's ratio, loss factor). joint: (N/um, N m/rad) of the clamping, None = rigid.
    frequencies: Hz, by default those of the holder, else each Hz up to `highest`. Raises ValueError
    for others. Timoshenko beams, exact in the frequency. [Bachrathy 2013, thesis 4; Schmitz &
    Donaldson 2000].
    """
    segments = [_segment(segment, material) for segment in tool_segments]
    if isinstance(holder_frf, Frf) and frequencies is None:
        frequencies = holder_frf.frequencies
    if frequencies is None:
        frequencies = numpy.arange(STEP, highest + STEP, STEP)
    frequencies = numpy.atleast_1d(numpy.asarray(frequencies, dtype=float))
    angular = 2 * math.pi * frequencies
    if holder_frf is None:
        holder = numpy.zeros((len(frequencies), 4), dtype=complex)
    elif isinstance(holder_frf, Frf):
        holder = _rows(holder_frf.receptance(), angular)
    else:
        modal = core().Receptance.of_modes([mode.in_si() for mode in holder_frf])
        holder = _rows(modal, angular)
    flexible = numpy.zeros((2, 2), dtype=complex)
    if joint is not None:
        if not min(joint) > 0:
            raise ValueError("The joint's stiffnesses must be above 0.")
        flexible[0, 0], flexible[1, 1] = 1e-6 / joint[0], 1 / joint[1]
    tips = []
    for column in (0, 3):
        roots = numpy.tile(flexible, (len(frequencies), 1, 1))
        roots[:, 0, 0] += holder[:, column]
        tips.append(numpy.array(core().tip_receptances(segments, list(roots), angular.tolist())))
    return Frf(frequencies, tips[0], tips[1])


def clamped_frequencies(tool_segments, material, highest=50000.0):
    """Natural frequencies in Hz, up to `highest`, of the segments of couple() in a rigid holder."""
    segments = [_segment(segment, material) for segment in tool_segments]
    found = core().clamped_frequencies(segments, 2 * math.pi * highest)
    return [frequency / (2 * math.pi) for frequency in found]


def _rows(receptance, angular):
    return numpy.array(receptance.at(angular.tolist())).reshape(-1, 4)


def _segment(segment, material):
    length, diameter = segment[:2]
    own = segment[2] if len(segment) > 2 else material
    if isinstance(own, str):
        if own not in MATERIALS:
            raise ValueError(
                "The tool's material is %s, or four numbers, not %r."
                % (", ".join(sorted(MATERIALS)), own)
            )
        own = MATERIALS[own]
    modulus, density, poisson, loss = (*own, 0.0)[:4]
    return core().BeamSegment(
        1e-3 * length, 1e-3 * diameter, 1e9 * modulus, float(density), float(poisson), float(loss)
    )
