"""The classical semi-discretisation [Insperger & Stepan 2011]: the product of all steps' matrices.

For one mode along x and straight teeth of even pitch; a peer to measure against, first order in the
delayed term, with the force's mean over each step.
"""

import math
import time

import numpy


def radius(milling, speed, depth, steps):
    """The spectral radius with so many steps to a tooth's period."""
    mode = milling.modes[0]
    period = 60 / speed / milling.teeth
    h = period / steps
    natural = 2 * math.pi * mode.frequency
    product = numpy.eye(steps + 2)
    for i in range(steps):
        force = _mean_force(milling, i, steps) * depth * 1e-3 * 1e6 / mode.mass
        a = numpy.zeros((4, 4))
        a[0, 1] = h
        a[1, 0] = -h * (natural**2 + force)
        a[1, 1] = -h * 2 * mode.damping_ratio * natural
        a[1, 2] = h * force
        a[2, 3] = 1
        end = _exponential(a)
        step = numpy.zeros((steps + 2, steps + 2))
        step[:2, :2] = end[:2, :2]
        # The delayed displacement goes from its oldest value to the next.
        step[:2, steps + 1] = end[:2, 2] - end[:2, 3]
        if steps > 1:
            step[:2, steps] = end[:2, 3]
        step[2, 0] = 1
        step[numpy.arange(3, steps + 2), numpy.arange(2, steps + 1)] = 1
        product = step @ product
    return abs(numpy.linalg.eigvals(product)).max()


def as_accurate(milling, row, wanted):
    """(steps, error, seconds) of the fewest steps whose error is below `wanted`."""
    steps = 20
    while True:
        start = time.process_time()
        found = radius(milling, row["rpm"], row["ap_mm"], steps)
        seconds = time.process_time() - start
        error = abs(found - row["rho"])
        if error <= wanted:
            return steps, error, seconds
        steps = int(1.4 * steps)


def _mean_force(milling, i, steps):
    """N/mm2 of displacement and depth along x, the mean over the step."""
    theta = math.radians(milling.engagement_angle)
    entry = math.pi - theta if milling.cut_mode == "climb" else 0.0
    pitch = 2 * math.pi / milling.teeth
    total = 0.0
    for tooth in range(milling.teeth):
        low, high = ((i + k) * pitch / steps + tooth * pitch for k in (0, 1))
        low, high = max(low, entry), min(high, entry + theta)
        if high > low:
            total += _integral(milling, high) - _integral(milling, low)
    return total / (pitch / steps)


def _integral(milling, angle):
    """Of Kt sin cos + Kn sin^2."""
    s = math.sin(angle)
    return 0.5 * milling.tangential * s * s + milling.normal * (
        0.5 * angle - 0.25 * math.sin(2 * angle)
    )


def _exponential(a):
    halvings = max(0, int(math.ceil(math.log2(max(1e-9, abs(a).sum(axis=1).max())))) + 2)
    a = a / 2**halvings
    result = term = numpy.eye(len(a))
    for n in range(1, 12):
        term = term @ a / n
        result = result + term
    for _ in range(halvings):
        result = result @ result
    return result
