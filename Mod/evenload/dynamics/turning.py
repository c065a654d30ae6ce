"""Turning: speeds for interrupted cuts, and the limit with a flank that rubs."""

import math

from evenload.dynamics.modes import core, rpm

ORDERS = {None: 0, 1: 1, 2: 2, "exact": 3}


def interrupted_turning_speeds(slot_mm, frequency, damping_ratio=0, enter=0, exit=0, count=5):
    """Cutting speeds in m/min, the fastest first, at which a slot leaves the least vibration.

    slot_mm: its width, mm. frequency: natural, Hz. damping_ratio: from 0 to below 1. enter, exit:
    how slowly the force comes back after the slot and falls before it, time constant times natural
    angular frequency; 0 = at once. count: how many speeds. Raises ValueError for others.
    [Bachrathy 2013, thesis 1].
    """
    speeds = core().interrupted_turning_speeds(
        1e-3 * slot_mm,
        2 * math.pi * frequency,
        float(damping_ratio),
        float(enter),
        float(exit),
        int(count),
    )
    return [60 * speed for speed in speeds]


def turning_limit(
    mode, speed, diameter, coefficient, flank_coefficient=0.0, flank_length=0.0, order="exact"
):
    """(width of cut in mm, chatter frequency in Hz): the least that chatters; inf where none does.

    mode: across the cut surface. speed: rev/min. diameter: of the work, mm. coefficient: N/mm2.
    flank_coefficient: N/mm3, force per volume that the flank displaces. flank_length: of its
    contact, mm. order: None without flank, 1 classical damping, 2, or "exact", the short
    regenerative effect. Raises ValueError for others. [Bachrathy 2013, thesis 6].
    """
    if order not in ORDERS:
        raise ValueError('The order of the flank is None, 1, 2 or "exact", not %r.' % (order,))
    width, frequency = core().turning_limit(
        mode.in_si(),
        1e6 * coefficient,
        1e9 * flank_coefficient,
        1e-3 * flank_length,
        1e-3 * diameter,
        rpm(speed),
        ORDERS[order],
    )
    return 1e3 * width, frequency / (2 * math.pi)
