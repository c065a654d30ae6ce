"""The profile of any surface: how far measured points lie from a part."""

from dataclasses import dataclass

import numpy

from evenload import compiled
from evenload.inspection.points import normals_of, points_of

MOTIONS = ("tx", "ty", "tz", "rx", "ry", "rz")
IN_DATUM = ("tx", "ty", "rz")  # in the datum's frame, whose z is its normal
FARTHEST = 0.1  # share of the points' extent: whoever lies farther needs an alignment first


@dataclass(frozen=True)
class Profile:
    """A profile error.

    width: of the zone about the part that holds all points, 2 max |deviation|, mm. shift: mm;
    turn: 3 x 3; a point p goes to pivot + turn (p - pivot) + shift, pivot the part's origin or the
    datum's point. deviations: signed distances after that motion, positive outside. contacts,
    sides, multipliers, imbalance, is_proved: as of a Fit.
    """

    width: float
    shift: numpy.ndarray
    turn: numpy.ndarray
    deviations: numpy.ndarray
    contacts: numpy.ndarray
    sides: numpy.ndarray
    multipliers: numpy.ndarray
    imbalance: float
    is_proved: bool


def profile(points, part, free=None, datum=None):
    """The Profile of measured points on a part: the least width over the motions left free.

    points: n x 3, mm. part: a function as in parts.py: test_part(...), AtPoints(...) or one of
    yours. free: of "tx", "ty", "tz", shifts, and "rx", "ry", "rz", turns about axes through the
    part's origin; None: all six, or none with a datum. datum: (point, normal) of the datum plane in
    which the points have been aligned: then only shifts in it, tx and ty, and a turn about its
    normal, rz, may be free. The zone is symmetric about the part [ISO 1101], so that no motion is
    the source's SPE_A. Raises ValueError, in a sentence, for motions that are none or that leave
    the datum, and for points farther from the part than a tenth of their own extent.
    """
    points = points_of(points)
    if not len(points):
        raise ValueError("There are no points: give one at least.")
    axes, pivot = numpy.eye(3), numpy.zeros(3)
    if datum is not None:
        pivot, axes = _frame(datum)
    free = _motions(free, datum is not None)
    feet, _ = part(points, numpy.arange(len(points)))
    farthest = float(numpy.linalg.norm(points - feet, axis=1).max())
    extent = float(numpy.linalg.norm(numpy.ptp(points, axis=0)))
    if len(points) > 1 and not farthest <= FARTHEST * extent:
        raise ValueError(
            "The points lie up to %.3g mm from the part: align them with it first." % farthest
        )
    found = compiled.core().inspection.profile(
        points, part, [each in free for each in MOTIONS], axes, pivot
    )
    return Profile(
        found.width,
        found.shift,
        found.turn,
        found.deviations,
        found.contacts,
        found.sides,
        found.multipliers,
        found.imbalance,
        found.is_proved,
    )


def _motions(free, has_datum):
    if free is None:
        return () if has_datum else MOTIONS
    free = (free,) if isinstance(free, str) else tuple(free)
    for each in free:
        if each not in MOTIONS:
            raise ValueError("The motions are %s, not %r." % (", ".join(MOTIONS), each))
        if has_datum and each not in IN_DATUM:
            raise ValueError(
                "%s would leave the datum plane: only tx, ty and rz may be free." % each
            )
    return free


def _frame(datum):
    """(point, axes in columns) of a datum plane; its x lies along the part's x or y."""
    try:
        point, normal = datum
    except (TypeError, ValueError):
        raise ValueError("The datum is a point and a normal, three numbers each.") from None
    point, normal = points_of([point])[0], normals_of([normal], 1)[0]
    x = numpy.eye(3)[0 if abs(normal[0]) < 0.9 else 1]
    x = x - normal * (normal @ x)
    x /= numpy.linalg.norm(x)
    return point, numpy.stack([x, numpy.cross(normal, x), normal], axis=1)
