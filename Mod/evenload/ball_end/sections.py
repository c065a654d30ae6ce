"""The sections of parts that are bent one way, and of their offsets, as lines and arcs.

Written apart from the core's, so that solids made of them judge it. Needs no FreeCAD. A section
lies in the plane of y and z; its normal leans by N from z towards y, (sin N, cos N).
"""

import math
from dataclasses import dataclass

from evenload.ball_end.surfaces import in_core

DOME, FILLET, FLAT, HALF = 45.0, 10.0, 10.0, 40.0  # mm [Varga 2023, 3.1]
STEEPEST = math.radians(85)  # a cylinder's lean at both ends
FAR = 1e4  # mm, more than any part has


@dataclass(frozen=True)
class Piece:
    """A level line, or an arc about `middle` (y, z) from lean to lean, in mm and rad, in the order
    of y. radius: > 0 convex, < 0 concave; infinite: a line through `middle` between ordinates.
    """

    middle: tuple
    radius: float
    begin: float
    end: float

    @property
    def is_arc(self):
        return math.isfinite(self.radius)

    def offset(self, distance):
        """The piece that runs `distance` mm outside of this one."""
        y, z = self.middle
        if self.is_arc:
            return Piece(self.middle, self.radius + distance, self.begin, self.end)
        return Piece((y, z + distance), self.radius, self.begin, self.end)

    @property
    def ordinates(self):
        """(from, to) in y."""
        if not self.is_arc:
            return self.begin, self.end
        return tuple(
            self.middle[0] + self.radius * math.sin(lean) for lean in (self.begin, self.end)
        )

    def height(self, y):
        """z at an ordinate of the piece."""
        if not self.is_arc:
            return self.middle[1]
        drop = math.sqrt(max(self.radius**2 - (y - self.middle[0]) ** 2, 0))
        return self.middle[1] + math.copysign(drop, self.radius)

    def normal(self, y):
        """(y, z) at an ordinate of the piece, outwards."""
        if not self.is_arc:
            return 0.0, 1.0
        sine = (y - self.middle[0]) / self.radius
        return sine, math.sqrt(1 - sine**2)


def section(surface):
    """[Piece, ...] of a surface as in ball_end.chip, but for patches, which are not bent one way.

    Raises ValueError, in a sentence, for others.
    """
    in_core(surface)  # refuses what is none
    kind, *given = surface
    if kind == "plane":
        return [Piece((0.0, 0.0), math.inf, -FAR, FAR)]
    if kind == "cylinder":
        return [_arc((0.0, 0.0), float(given[0]), -STEEPEST, STEEPEST)]
    if kind == "test part":
        return _test_part(1 if given[0] == "CX" else -1)
    raise ValueError("A patch is bent two ways: solids are made on parts that are bent one way.")


def _test_part(sign):
    lean = math.asin((HALF - FLAT) / (DOME + FILLET))
    level = (DOME + FILLET) * math.cos(lean)
    flat = sign * (level - FILLET)
    beside = HALF - FLAT
    return [
        Piece((0.0, flat), math.inf, -FAR, -beside),
        _arc((-beside, sign * level), -sign * FILLET, 0, lean),
        _arc((0.0, 0.0), sign * DOME, -lean, lean),
        _arc((beside, sign * level), -sign * FILLET, -lean, 0),
        Piece((0.0, flat), math.inf, beside, FAR),
    ]


def _arc(middle, radius, begin, end):
    """The arc from angle to angle of the place from `middle`, in the order of y."""
    if radius > 0:
        return Piece(middle, radius, begin, end)
    return Piece(middle, radius, -begin, -end)
