"""How faces lie and bend where the ball touches them, exact on the B-rep."""

import math

import numpy

from evenload import waiting
from evenload.ball_end.loads import Bends
from evenload.geometry.facets import TURN

ORDERS = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))  # of the derivatives by both parameters
POLE = 1e-9  # of the product of both tangents: where they vanish or coincide
NUDGE = 1e-3  # of the way from a pole to the middle of the face


def bends_at(part, points, normals, allowance):
    """(Bends, n booleans) of the faces' offset by an allowance in mm, at n x 3 contacts on them.

    part: the faces as a face_inspection.FacesPart. normals: n x 3, of the triangles that stand for
    the faces. The booleans: whether the face looks there where its triangle does; at an edge, which
    has no curvature, it does not.
    """
    found = []
    for face, place in part.places(points):
        waiting.go_on()
        found.append(_derivatives(face, place))
    by_u, by_v, *second = numpy.array(found).reshape(-1, len(ORDERS), 3).transpose(1, 0, 2)
    outward = numpy.cross(by_u, by_v)
    outward /= numpy.linalg.norm(outward, axis=1)[:, None]
    alike = (outward * normals).sum(axis=1)
    outward *= numpy.sign(alike)[:, None]
    first_way = by_u / numpy.linalg.norm(by_u, axis=1)[:, None]
    frame = numpy.stack([first_way, numpy.cross(outward, first_way)], axis=2)  # n x 3 x 2
    tangents = numpy.einsum("nki,nkj->nij", frame, numpy.stack([by_u, by_v], axis=2))
    uu, uv, vv = ((each * outward).sum(axis=1) for each in second)
    bent = numpy.stack([numpy.stack([uu, uv], axis=1), numpy.stack([uv, vv], axis=1)], axis=1)
    inverse = numpy.linalg.inv(tangents)
    # Convex is positive, so that the second fundamental form is turned round.
    values, vectors = numpy.linalg.eigh(-inverse.transpose(0, 2, 1) @ bent @ inverse)
    values = values / (1 + allowance * values)
    directions = numpy.einsum("nki,ni->nk", frame, vectors[:, :, 0])
    is_face = (numpy.abs(alike) > math.cos(TURN / 2)) & (outward[:, 2] > 0)
    return Bends(outward, values[:, 0], values[:, 1], directions), is_face


def _derivatives(face, place):
    """The ORDERS of derivatives, at a pole of those beside it."""
    surface, (u, v) = face.Surface, place
    found = [surface.getDN(u, v, *order) for order in ORDERS]
    if found[0].cross(found[1]).Length > POLE * max(1.0, found[0].Length) * found[1].Length:
        return found
    low_u, high_u, low_v, high_v = face.ParameterRange
    u, v = u + NUDGE * ((low_u + high_u) / 2 - u), v + NUDGE * ((low_v + high_v) / 2 - v)
    return [surface.getDN(u, v, *order) for order in ORDERS]
