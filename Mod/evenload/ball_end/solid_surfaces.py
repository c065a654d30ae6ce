"""What leaves the faces of a ball-end tool's chip, and how far points are from it: written apart
from the solids of OpenCASCADE's, so that their faces are told by it and their volumes judged.

Needs no FreeCAD. Lengths in the model's mm; points are rows of x, y, z from the ball's centre.
"""

import math
from dataclasses import dataclass

import numpy

from evenload.ball_end.sections import Piece

TRIES = 6  # of Newton's method, which begins within a ball's radius and doubles its digits


@dataclass(frozen=True)
class Ball:
    """kind: `tool`, within which the chip lies, or `previous`, outside of which it does."""

    kind: str
    centre: tuple
    radius: float

    def above(self, points):
        """How far points stand out of the chip over the face that this leaves."""
        off = numpy.linalg.norm(points - numpy.array(self.centre), axis=1) - self.radius
        return off if self.kind == "tool" else -off


@dataclass(frozen=True)
class Way:
    """What the ball sweeps whose centre goes straight in plan, over a section made of pieces.

    start: the ball's centre beside the tool's, in plan; feed: of length 1, in plan; y, z: of the
    model's origin in the section.
    """

    pieces: list
    start: tuple
    feed: tuple
    y: float
    z: float
    radius: float
    kind = "pass"

    def above(self, points):
        """As of a Ball."""
        pieces = self.pieces
        if abs(self.feed[1]) < 1e-12:  # one line along the section's ordinate
            y = self.y + self.start[1]
            piece = next(p for p in pieces if p.ordinates[0] <= y <= p.ordinates[1])
            pieces = [Piece((0.0, piece.height(y)), math.inf, -math.inf, math.inf)]
        return self.radius - numpy.min([self._from(each, points) for each in pieces], axis=0)

    def _from(self, piece, points):
        """Distances of points from the centres over one piece of the section.

        The foot on it by Newton's method: the centre's derivatives by its way in plan are those of
        an arc's height, h' = -(y - m)/(h - n) and h'' = -(1 + h'^2)/(h - n) from its middle m, n.
        """
        start, feed = numpy.array(self.start), numpy.array(self.feed)
        ends = -math.inf, math.inf
        if abs(feed[1]) > 1e-12:
            ends = sorted((each - self.y - start[1]) / feed[1] for each in piece.ordinates)
        beside = points[:, :2] - start
        along = numpy.clip(beside @ feed, *ends)
        height, slope, bend = self._height(piece, start[1] + along * feed[1])
        if piece.is_arc:
            for _ in range(TRIES):
                over = points[:, 2] - height
                rise = beside @ feed - along + over * slope * feed[1]
                fall = 1 + (slope**2 - over * bend) * feed[1] ** 2
                along = numpy.clip(along + rise / fall, *ends)
                height, slope, bend = self._height(piece, start[1] + along * feed[1])
        off = beside - along[:, None] * feed
        return numpy.sqrt((off**2).sum(axis=1) + (points[:, 2] - height) ** 2)

    def _height(self, piece, y):
        """(z, its first and its second derivative by y) of the centres."""
        if not piece.is_arc:
            level = numpy.full(len(y), piece.middle[1] - self.z)
            return level, 0 * level, 0 * level
        aside = self.y + y - piece.middle[0]
        over = math.copysign(1, piece.radius) * numpy.sqrt(piece.radius**2 - aside**2)
        slope = -aside / over
        return over + piece.middle[1] - self.z, slope, -(1 + slope**2) / over


@dataclass(frozen=True)
class Stock:
    """Over a section made of pieces; y, z: of the model's origin in it."""

    pieces: list
    y: float
    z: float
    kind = "stock"

    def above(self, points):
        """As of a Ball; of the piece that is nearest, or of what continues it."""
        y, z = points[:, 1] + self.y, points[:, 2] + self.z
        found = numpy.array([_over(piece, y, z) for piece in self.pieces])
        nearest = numpy.abs(found).argmin(axis=0)
        return found[nearest, numpy.arange(len(points))]


def _over(piece, y, z):
    m, n = piece.middle
    if not piece.is_arc:
        return z - n
    return math.copysign(1, piece.radius) * (numpy.hypot(y - m, z - n) - abs(piece.radius))
