"""The stability chart of a cut over all feed directions of its path, from coarse to fine.

A grid in place of curves: the boundary is that of the largest of many radii, which has kinks. A
finer grid evaluates only the nodes of cells through which the boundary goes, follows it from there
into cells where it was overlooked, and looks only in those directions that were the worst around
and those beside them. Needs no FreeCAD.
"""

import math
from dataclasses import dataclass

import numpy

from evenload import waiting
from evenload.dynamics import directions

FIRST = 41, 15  # nodes of speeds and depths of the first grid
LEVELS = 3  # grids, each twice as fine as that before
MOST_DIRECTIONS = 24
STRIDE = 3  # every third of them for the first grid: finer ones look at those beside the worst
NEARLY = 0.98  # a radius above which a finer grid looks closely
ENOUGH = 1.0  # a radius beyond which the first grid looks at no further direction
ACCURACY = 1e-2


@dataclass
class Field:
    """Largest multipliers over spindle speeds (rev/min) and depths (mm).

    radii: array of depths x speeds; where it is 1 or more the cut is unstable in some direction.
    Away from the boundary it is that of the first such direction. share: of all levels, how far
    this one is.
    """

    speeds: numpy.ndarray
    depths: numpy.ndarray
    radii: numpy.ndarray
    share: float

    def limits(self):
        """mm: for each speed the least depth at which the cut is unstable; inf where it is none."""
        found = numpy.full(len(self.speeds), math.inf)
        for column, radii in enumerate(self.radii.T):
            unstable = numpy.flatnonzero(radii >= 1)
            if len(unstable):
                found[column] = self._crossing(radii, unstable[0])
        return found

    def _crossing(self, radii, row):
        if row == 0:
            return float(self.depths[0])
        low, high = radii[row - 1], radii[row]
        share = (1 - low) / (high - low)
        return float(self.depths[row - 1] + share * (self.depths[row] - self.depths[row - 1]))


def levels(cut, speeds, depths):
    """Yields the Field of a Cut after each grid; speeds, depths: (low, high), above 0.

    Asks `waiting` whether to go on every some hundredths of a second, and raises waiting.Stopped.
    """
    grid = _Grid(cut, speeds, depths)
    for level in range(LEVELS):
        if level:
            grid.halve()
        yield Field(grid.speeds, grid.depths, grid.radii, (level + 1) / LEVELS)


class _Grid:
    """Nodes with their radii, and which direction each of them has from."""

    def __init__(self, cut, speeds, depths):
        chosen = directions.spread(cut.seen_directions, MOST_DIRECTIONS)
        milling = cut.milling(flute_length=None)
        self.turned = [milling.changed(feed_direction=float(d)) for d in chosen]
        self.beside = 1 if len(chosen) > MOST_DIRECTIONS // STRIDE else 0
        self.speeds, self.depths = (
            numpy.linspace(low, high, nodes) for (low, high), nodes in zip((speeds, depths), FIRST)
        )
        shape = len(self.depths), len(self.speeds)
        self.radii, self.worst = numpy.zeros(shape), numpy.zeros(shape, dtype=int)
        self.known = numpy.zeros(shape, dtype=bool)
        wanted = numpy.zeros((len(chosen), *shape), dtype=bool)
        wanted[:: STRIDE if self.beside else 1] = True
        self._evaluate(wanted, ENOUGH)

    def halve(self):
        """Twice as many cells along both axes."""
        unstable, largest = self._corners_unstable(), _corners_of(self.radii).max(0)
        near = (unstable.any(0) | (largest > NEARLY)) & ~unstable.all(0)
        wanted = _between(self._directions_of(near))
        self.speeds, self.depths = (_with_middles(axis) for axis in (self.speeds, self.depths))
        radii = _with_middles(_with_middles(self.radii).T).T
        self.worst = numpy.repeat(numpy.repeat(self.worst, 2, 0), 2, 1)[:-1, :-1]
        self.known = numpy.zeros(radii.shape, dtype=bool)
        self.known[::2, ::2] = True
        self.radii = radii
        while wanted.any():
            self._evaluate(wanted, math.inf)
            unstable = self._corners_unstable()
            cells = self._directions_of(unstable.any(0) & ~unstable.all(0))
            wanted = _nodes_of(cells) & ~self.known
        self.beside = 0  # from now on the worst directions are known as finely as there are any

    def _corners_unstable(self):
        return _corners_of(self.radii) >= 1

    def _directions_of(self, cells):
        """For each direction and cell whether it is to be looked at in these cells."""
        worst = _corners_of(self.worst)
        own = numpy.stack([(worst == k).any(0) & cells for k in range(len(self.turned))])
        for step in range(1, self.beside + 1):
            own = own | numpy.roll(own, step, 0) | numpy.roll(own, -step, 0)
        return own

    def _evaluate(self, wanted, enough):
        """The largest radius of these directions at these nodes, and of what was known of them."""
        n, a = numpy.meshgrid(self.speeds, self.depths)
        nodes = wanted.any(0)
        self.radii[nodes & ~self.known] = 0.0  # was interpolated
        self.known |= nodes
        for k, milling in enumerate(self.turned):
            rows, columns = numpy.nonzero(wanted[k] & (self.radii < enough))
            for start in range(0, len(rows), directions.CHUNK):
                waiting.go_on()
                some = rows[start : start + directions.CHUNK], columns[start:][: directions.CHUNK]
                found = milling.spectral_radius(n[some], a[some], ACCURACY)
                larger = found > self.radii[some]
                at = some[0][larger], some[1][larger]
                self.radii[at], self.worst[at] = found[larger], k


def _corners_of(nodes):
    """The values at the four corners of each cell, the corners first."""
    return numpy.stack([nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, :-1], nodes[1:, 1:]])


def _nodes_of(cells):
    """For each direction the nodes at the corners of these cells."""
    count, rows, columns = cells.shape
    found = numpy.zeros((count, rows + 1, columns + 1), dtype=bool)
    for down in (0, 1):
        for right in (0, 1):
            found[:, down : down + rows, right : right + columns] |= cells
    return found


def _between(cells):
    """For each direction the nodes of the grid twice as fine that lie in or at these cells."""
    count, rows, columns = cells.shape
    found = numpy.zeros((count, 2 * rows + 1, 2 * columns + 1), dtype=bool)
    for down in range(3):
        for right in range(3):
            found[:, down : down + 2 * rows - 1 : 2, right : right + 2 * columns - 1 : 2] |= cells
    return found


def _with_middles(rows):
    """Rows with the means of neighbours between them."""
    found = numpy.empty((2 * len(rows) - 1, *rows.shape[1:]))
    found[::2], found[1::2] = rows, 0.5 * (rows[:-1] + rows[1:])
    return found
