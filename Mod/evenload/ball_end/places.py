"""Places along a path, and how far from each of them an earlier pass has cut. Needs no FreeCAD."""

from dataclasses import dataclass

import numpy

from evenload import compiled
from evenload.planar import CUT, as_lines

REACH = 1.5  # of the largest stepover: a pass further away is no neighbour
GOLDEN = (5**0.5 - 1) / 2  # whose multiples are even within 1, however many they are


@dataclass(frozen=True)
class Places:
    """n places on the cuts of a path, one in each n-th of their length. tips: n x 3, of the tool's
    tip, mm; ways: n x 3, of length 1, along the feed; feeds: mm/min; left, right: mm in plan across
    the feed to where an earlier pass has cut, infinite where there is none; length: mm, of all
    cuts.
    """

    tips: numpy.ndarray
    ways: numpy.ndarray
    feeds: numpy.ndarray
    left: numpy.ndarray
    right: numpy.ndarray
    length: float

    @property
    def uncut(self):
        """Where material stands beside the feed, in the words of ball_end.chip."""
        is_left, is_right = numpy.isfinite(self.left), numpy.isfinite(self.right)
        return numpy.select(
            [is_left & is_right, is_left, is_right], ["strip", "right", "left"], "slot"
        )

    @property
    def stepovers(self):
        """mm in plan to the earlier pass, of two to the further one; infinite without one."""
        both = numpy.isfinite(self.left) & numpy.isfinite(self.right)
        return numpy.where(
            both, numpy.maximum(self.left, self.right), numpy.minimum(self.left, self.right)
        )

    def only(self, chosen):
        """Those that an array of n booleans chooses."""
        arrays = (self.tips, self.ways, self.feeds, self.left, self.right)
        return Places(*(each[chosen] for each in arrays), self.length)


def places_along(moves, count, stepover):
    """`count` Places on the cuts of moves as the core has them; stepover: mm in plan, the largest.

    Raises ValueError for a path that cuts nothing.
    """
    rows = as_lines(moves)
    is_cut = rows[1:, 0] == CUT
    starts, ends = rows[:-1, 1:4][is_cut], rows[1:, 1:4][is_cut]
    lengths = numpy.linalg.norm(ends - starts, axis=1)
    if not lengths.sum() > 0:
        raise ValueError("The path of this strategy cuts nothing.")
    until = numpy.cumsum(lengths)
    # Not all in the middle of their shares: passes of one length would be met at the same places.
    # Nor is the first one the beginning of the path, at the border of the faces.
    within = (numpy.arange(count) + 0.5) * GOLDEN % 1
    along = (numpy.arange(count) + within) / count * until[-1]
    own = numpy.minimum(numpy.searchsorted(until, along, side="right"), len(until) - 1)
    ways = (ends - starts)[own] / lengths[own, None]
    tips = starts[own] + (along - until[own] + lengths[own])[:, None] * ways
    left, right = earlier_beside(
        starts[:, :2], ends[:, :2], tips[:, :2], ways[:, :2], own, stepover
    )
    return Places(tips, ways, rows[1:, 7][is_cut][own], left, right, float(until[-1]))


def earlier_beside(starts, ends, tips, ways, own, stepover):
    """(left, right) of Places: mm in plan to where the line across the feed meets segments, whose
    starts and ends are n x 2, before each place's own, no further off than REACH of the stepover.
    """
    segments = numpy.hstack([starts, ends])
    wanted = numpy.column_stack([tips, ways, own])
    return compiled.core().surface.earlier_beside(segments, wanted, REACH * stepover).T
