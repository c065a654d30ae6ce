"""Patterns of measuring points on the unit square. Source: [Varga 2023, ch. 5]."""

import math

import numpy


def matrix(n):
    """n equidistant points in [0, 1), n x 2: a square matrix, row by row from the origin.

    Raises ValueError where n is no square: which rows should be short is left to the caller.
    """
    n = _count(n)
    side = math.isqrt(n)
    if side * side != n:
        raise ValueError(
            "A matrix has as many rows as columns: take %d or %d points."
            % (side**2, (side + 1) ** 2)
        )
    steps = numpy.arange(side) / side
    return numpy.stack([numpy.tile(steps, side), numpy.repeat(steps, side)], axis=-1)


def halton_zaremba(n, digits=None):
    """n points of the Halton-Zaremba sequence in [0, 1), n x 2.

    x = i/n; y mirrors i's binary digits at the point, every second digit, from the second on,
    turned over. digits: how many count, leading zeros among them; None: as few as hold n, the
    source's example has 6 for 36. Raises ValueError for n < 1 and for digits that cannot tell n
    points apart.
    """
    n = _count(n)
    least = max(1, (n - 1).bit_length())
    digits = least if digits is None else digits
    if isinstance(digits, bool) or digits != int(digits) or not least <= digits <= 52:
        raise ValueError("%d points need %d to 52 digits, not %s." % (n, least, digits))
    number = numpy.arange(n)
    y = numpy.zeros(n)
    for j in range(int(digits)):
        digit = (number >> j) & 1
        y += (digit if j % 2 == 0 else 1 - digit) * 2.0 ** (-j - 1)
    return numpy.stack([number / n, y], axis=-1)


def _count(n):
    if isinstance(n, bool) or not isinstance(n, (int, numpy.integer)) or n < 1:
        raise ValueError("The number of points is a whole number above 0, not %r." % (n,))
    return int(n)
