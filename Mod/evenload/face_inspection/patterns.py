"""Where to measure: patterns of points on picked faces. Source: [Varga 2023, ch. 5]."""

import math
from dataclasses import dataclass

import FreeCAD
import numpy
import Part

from evenload import inspection

LEAST = 49  # points: the source found fewer to tell too little, whatever the pattern
MOST = 100_000
PATTERNS = ("Halton-Zaremba", "matrix")
SPACINGS = ("arc length", "plan")
STEPS = 200  # chords by which lengths along a face are told
SPARSEST = 1000  # of a pattern's points one must fall on the faces
UPRIGHT = 1e-6  # of a normal: what a line from above does not meet


@dataclass(frozen=True)
class Samples:
    """points, normals: n x 3, exact on the faces, normals out of the part; faces: for each point
    the number of its face among the picked ones.
    """

    points: numpy.ndarray
    normals: numpy.ndarray
    faces: numpy.ndarray


def sample(faces, count=LEAST, pattern="Halton-Zaremba", spacing="arc length", margin=0.0):
    """Samples of PickedFaces: `count` points, or the least number above it that the pattern has.

    pattern: "Halton-Zaremba" or "matrix". spacing: "arc length": even along each face, the count
    shared among the faces by area; "plan": even as seen from above, over all faces together. No
    point is nearer than `margin` mm to the border of the faces. A pattern's places stand in the
    middle of their cells, so that none lies on the border; where faces are trimmed, it gets as many
    more points as are lost. Raises ValueError, in a sentence, for words and numbers that are none,
    and where the faces have no room.
    """
    if isinstance(count, bool) or count != int(count) or not 1 <= count <= MOST:
        raise ValueError("The number of points is 1 to %d, not %s." % (MOST, count))
    if pattern not in PATTERNS:
        raise ValueError("The pattern is %s, not %r." % (" or ".join(PATTERNS), pattern))
    if spacing not in SPACINGS:
        raise ValueError("The spacing is by %s, not %r." % (" or ".join(SPACINGS), spacing))
    if not (math.isfinite(margin) and margin >= 0):
        raise ValueError("The margin is a length of at least 0, not %r." % (margin,))
    if spacing == "plan":
        groups = [_fill(int(count), pattern, _Plan(faces, margin))]
    else:
        shares = _shares([face.Area for face in faces.faces], int(count))
        groups = [
            _fill(share, pattern, _Along(faces, number, margin))
            for number, share in enumerate(shares)
        ]
    found = [place for group in groups for place in group]
    points, normals = [], []
    for number, place in found:
        points.append(tuple(faces.faces[number].valueAt(*place)))
        normals.append(tuple(faces.faces[number].normalAt(*place)))
    return Samples(
        numpy.array(points), numpy.array(normals), numpy.array([number for number, _ in found])
    )


def _shares(areas, count):
    """A number of points for each face, by area, at least one."""
    wanted = numpy.array(areas) / sum(areas) * count
    shares = numpy.maximum(1, numpy.floor(wanted)).astype(int)
    for k in numpy.argsort(shares - wanted, kind="stable"):
        if shares.sum() >= count:
            break
        shares[k] += 1
    return [int(share) for share in shares]


def _fill(count, pattern, ground):
    """The places of a pattern on a ground, [(number of the face, (u, v)), ...], at least count."""
    asked = count
    while True:
        found = [place for place in map(ground.at, _unit(asked, pattern)) if place is not None]
        if len(found) >= count:
            return found
        if asked > SPARSEST * max(count, 10) or (asked > SPARSEST and not found):
            raise ValueError(ground.no_room)
        share = max(len(found), 1) / asked
        asked += max(1, math.ceil((count - len(found)) / share))


def _unit(count, pattern):
    """At least count places in the unit square, in the middle of their cells."""
    if pattern == "matrix":
        side = math.isqrt(count - 1) + 1
        return inspection.matrix(side * side) + 0.5 / side
    digits = max(1, (count - 1).bit_length())
    return inspection.halton_zaremba(count, digits) + [0.5 / count, 0.5 ** (digits + 1)]


class _Along:
    """One face, by arc length: first along the middle of the face, then across it there."""

    def __init__(self, faces, number, margin):
        self.faces, self.number, self.margin = faces, number, margin
        self.face = faces.faces[number]
        self.no_room = "The margin of %g mm leaves nothing of %s of %s: take a smaller one." % (
            *(margin, faces.parts[number][1]),
            faces.parts[number][0],
        )
        self._u, self._v = (tuple(r) for r in numpy.reshape(self.face.ParameterRange, (2, 2)))
        surface = self.face.Surface
        self._is_round = [
            surface.isUPeriodic() and _is_whole(self._u, surface.UPeriod()),
            surface.isVPeriodic() and _is_whole(self._v, surface.VPeriod()),
        ]
        middle = 0.5 * sum(self._u)
        self._down = _Lengths(self.face, [(middle, v) for v in numpy.linspace(*self._v, STEPS)])
        self._across = {}

    def at(self, unit):
        """(number of the face, (u, v)) at a place of the unit square; None where there is no face,
        or its border is too near.
        """
        v = self._down.at(float(unit[1]), 0 if self._is_round[1] else self.margin)
        if v is None:
            return None
        v = float(self._v[0] + v * (self._v[1] - self._v[0]))
        if v not in self._across:
            row = [(u, v) for u in numpy.linspace(*self._u, STEPS)]
            self._across[v] = _Lengths(self.face, row)
        u = self._across[v].at(float(unit[0]), 0 if self._is_round[0] else self.margin)
        if u is None:
            return None
        place = float(self._u[0] + u * (self._u[1] - self._u[0])), v
        is_there = self.face.isPartOfDomain(*place)
        if not (is_there and self.faces.is_within(self.face.valueAt(*place), self.margin)):
            return None
        return self.number, place


class _Lengths:
    """Lengths along a row of places on a face."""

    def __init__(self, face, places):
        points = numpy.array([tuple(face.valueAt(float(u), float(v))) for u, v in places])
        steps = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
        self._lengths = numpy.concatenate([[0.0], numpy.cumsum(steps)])

    def at(self, share, margin):
        """The share of the row's parameters at a share of its length without margins; None where
        there is nothing between these.
        """
        room = self._lengths[-1] - 2 * margin
        if room <= 0:
            return 0.5 if margin == 0 else None
        length = margin + share * room
        return numpy.interp(length, self._lengths, numpy.linspace(0, 1, len(self._lengths)))


class _Plan:
    """All faces as seen from above; where one lies over another, the upper one."""

    no_room = (
        "No vertical line meets the faces within the margin: take a smaller one, or space the "
        "points by arc length."
    )

    def __init__(self, faces, margin):
        self.faces, self.margin = faces, margin
        lows, highs = faces.box()
        self._lows, self._highs = lows, highs
        # Slack of FreeCAD's boxes does not matter: what is beside the faces is left out.
        self._low = lows.min(axis=0)[:2] + margin
        self._room = highs.max(axis=0)[:2] - margin - self._low
        if not (self._room > 0).all():
            raise ValueError(self.no_room)

    def at(self, unit):
        """The same as for a face by arc length."""
        x, y = map(float, self._low + unit * self._room)
        line = Part.Line(FreeCAD.Vector(x, y, 0), FreeCAD.Vector(x, y, 1))
        found, highest = None, -math.inf
        for number, face in enumerate(self.faces.faces):
            if not (self._lows[number, :2] <= (x, y)).all():
                continue
            if not ((x, y) <= self._highs[number, :2]).all():
                continue
            for point in line.intersectCS(face.Surface)[0]:
                place = face.Surface.parameter(FreeCAD.Vector(point.X, point.Y, point.Z))
                if point.Z > highest and self._is_seen(face, place):
                    found, highest = (number, place), point.Z
        return found

    def _is_seen(self, face, place):
        if not face.isPartOfDomain(*place) or abs(face.normalAt(*place).z) < UPRIGHT:
            return False
        return self.faces.is_within(face.valueAt(*place), self.margin)


def _is_whole(ends, period):
    return ends[1] - ends[0] > (1 - 1e-9) * period
