"""Parts that answer for points with the nearest places on them.

A part is a function (points, numbers) -> (feet, normals): for m x 3 points and their numbers among
all that are inspected, the nearest points of the part and its normals there, out of the part, of
length 1, m x 3 each. Faces of a model plug in by such a function.
"""

import math

import numpy

from evenload import compiled
from evenload.inspection.points import normals_of, points_of


class AtPoints:
    """A part that is known at the points' nominal places alone, and flat around each of them.

    nominal, normals: n x 3, one for each point that is inspected, in their order. What its bend
    makes of a point's way along the surface, s^2/(2 R), is left out.
    """

    def __init__(self, nominal, normals):
        self.nominal = points_of(nominal)
        self.normals = normals_of(normals, len(self.nominal))

    def __call__(self, points, numbers):
        if len(numbers) and max(numbers) >= len(self.nominal):
            raise ValueError("Each point needs a nominal point and a normal of its own.")
        normals = self.normals[numbers]
        away = ((points - self.nominal[numbers]) * normals).sum(axis=1)
        return points - away[:, None] * normals, normals


class BentPart:
    """A section of lines and arcs with common tangents, (y, z), drawn without end along x.

    profile: start (y, z) in mm, lean of its normal from z towards y in rad, pieces (length,
    curvature), curvature > 0 convex. Beyond its ends the section goes on straight.
    """

    def __init__(self, profile):
        self.curvatures, starts, leans = [], [], []
        at, lean = numpy.array(profile.start, dtype=float), profile.lean
        for length, curvature in (*profile.pieces, (0.0, 0.0)):
            starts.append(at)
            leans.append(lean)
            self.curvatures.append(curvature)
            after = lean + curvature * length
            if curvature:
                at = at + (_outwards(after) - _outwards(lean)) / curvature
            else:
                at = at + length * numpy.array([math.cos(lean), -math.sin(lean)])
            lean = after
        self.starts, self.leans = numpy.array(starts), numpy.array(leans)

    def piece(self, points):
        """The number of the piece to which each of n x 3 points is nearest, counted from 0."""
        places = numpy.asarray(points, dtype=float)[:, 1:]
        tangents = numpy.stack([numpy.cos(self.leans), -numpy.sin(self.leans)], axis=1)
        # Pieces meet in common normals: a point belongs to the last that begins before it.
        found = numpy.zeros(len(places), dtype=int)
        for i, (start, tangent) in enumerate(zip(self.starts, tangents)):
            if i:
                found[(places - start) @ tangent >= 0] = i
        return numpy.minimum(found, len(self.curvatures) - 1)

    def __call__(self, points, numbers=None):
        points = numpy.asarray(points, dtype=float)
        pieces, places = self.piece(points), points[:, 1:]
        feet, normals = numpy.empty_like(places), numpy.empty_like(places)
        for i, (start, lean, curvature) in enumerate(zip(self.starts, self.leans, self.curvatures)):
            mine = pieces == i
            outwards = _outwards(lean)
            if curvature:
                middle = start - outwards / curvature
                arms = (places[mine] - middle) * math.copysign(1, curvature)
                normals[mine] = arms / numpy.linalg.norm(arms, axis=1, keepdims=True)
                feet[mine] = middle + normals[mine] / curvature
            else:
                away = (places[mine] - start) @ outwards
                normals[mine] = outwards
                feet[mine] = places[mine] - away[:, None] * outwards
        along = points[:, :1]
        return numpy.hstack([along, feet]), numpy.hstack([numpy.zeros_like(along), normals])

    def at(self, x, y):
        """(points, normals), n x 3 each, of the part at plan ordinates in mm."""
        x, y = numpy.broadcast_arrays(numpy.asarray(x, dtype=float), numpy.asarray(y, dtype=float))
        x, y = x.ravel(), y.ravel()
        which = numpy.searchsorted(self.starts[1:, 0], y, side="right")
        z = numpy.empty(len(y))
        for i, (start, lean, curvature) in enumerate(zip(self.starts, self.leans, self.curvatures)):
            mine = which == i
            if curvature:
                middle = start - _outwards(lean) / curvature
                rise = numpy.sqrt(curvature**-2 - (y[mine] - middle[0]) ** 2)
                z[mine] = middle[1] + math.copysign(1, curvature) * rise
            else:
                z[mine] = start[1] - (y[mine] - start[0]) * math.tan(lean)
        points = numpy.stack([x, y, z], axis=1)
        return points, self(points)[1]


def test_part(nature):
    """The source's part of 80 x 80 mm as a BentPart: "CX", a dome, or "CV", a trough.

    R45, fillets R10, flats of 10 mm; pieces 0 and 4 are the flats, 1 and 3 the fillets, 2 is R45.
    Its middle is x = y = 0, z is measured from the axis of R45. [Varga 2023, ch. 3].
    """
    if nature not in ("CX", "CV"):
        raise ValueError('The test parts are "CX" and "CV", not %r.' % (nature,))
    return BentPart(compiled.core().ball_end.test_part_profile(nature == "CX"))


test_part.__test__ = False  # no test of pytest's


def _outwards(lean):
    return numpy.array([math.sin(lean), math.cos(lean)])
