"""Places along a path, and how far from each of them an earlier pass has cut. Needs no FreeCAD."""

from dataclasses import dataclass

import numpy

from evenload.planar import CUT, as_lines

REACH = 1.5  # of the largest stepover: a pass further away is no neighbour
OWN = 0.02  # of the reach: nearer than this it is the same pass
AROUND = numpy.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])  # cells
GOLDEN = (5**0.5 - 1) / 2  # whose multiples are even within 1, however many they are
CELLS = 1 << 32  # more than there are in a row


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
    left, right = _earlier(tips[:, :2], ways[:, :2], own, starts[:, :2], ends[:, :2], stepover)
    return Places(tips, ways, rows[1:, 7][is_cut][own], left, right, float(until[-1]))


def _earlier(tips, ways, own, starts, ends, stepover):
    """(left, right) of Places: where the line across the feed meets earlier segments in plan."""
    reach = REACH * stepover
    near = _Near(tips, starts, ends, reach)
    found = numpy.full((2, len(tips)), numpy.inf)
    for row in numpy.flatnonzero(numpy.hypot(*ways.T) > 0):
        segments = near.segments(row)
        segments = segments[segments < own[row]]
        x, y = ways[row] / numpy.hypot(*ways[row])
        turned = numpy.array([[x, -y], [y, x]])  # its columns: along the feed, to its left
        found[:, row] = _crossed(
            (starts[segments] - tips[row]) @ turned, (ends[segments] - tips[row]) @ turned, reach
        )
    return found


def _crossed(starts, ends, reach):
    """[to the left, to the right] where segments cross the line across the feed, nearest to it."""
    crosses = (starts[:, 0] <= 0) != (ends[:, 0] <= 0)
    (u0, v0), (u1, v1) = starts[crosses].T, ends[crosses].T
    across = v0 - u0 * (v1 - v0) / (u1 - u0)
    return [
        side[(side > OWN * reach) & (side < reach)].min(initial=numpy.inf)
        for side in (across, -across)
    ]


class _Near:
    """Which segments come near to which tips: by points on them, in square cells."""

    def __init__(self, tips, starts, ends, reach):
        # Half of what points on a segment are apart, and the reach itself.
        self._size = 1.5 * reach
        self._cells = numpy.floor(tips / self._size).astype(numpy.int64)
        wanted = numpy.unique([_key(self._cells + around) for around in AROUND])
        counts = numpy.ceil(numpy.hypot(*(ends - starts).T) / reach).astype(int)
        counts = numpy.maximum(counts, 1)
        segments = numpy.repeat(numpy.arange(len(starts)), counts)
        number = numpy.arange(len(segments)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
        share = ((number + 0.5) / counts[segments])[:, None]
        points = starts[segments] + share * (ends - starts)[segments]
        keys = _key(numpy.floor(points / self._size).astype(numpy.int64))
        is_near = numpy.isin(keys, wanted)
        order = numpy.argsort(keys[is_near], kind="stable")
        self._keys, self._segments = keys[is_near][order], segments[is_near][order]

    def segments(self, row):
        """Numbers of the segments near a tip, each once."""
        keys = [_key(self._cells[row] + around) for around in AROUND]
        lows, highs = (
            numpy.searchsorted(self._keys, keys, side=side) for side in ("left", "right")
        )
        return numpy.unique(
            numpy.concatenate([self._segments[low:high] for low, high in zip(lows, highs)])
        )


def _key(cells):
    """One number for the two of each cell."""
    return cells[..., 0] * CELLS + cells[..., 1]
