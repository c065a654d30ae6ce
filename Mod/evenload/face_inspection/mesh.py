"""Picked faces as small triangles, and deviations between the points where they were measured."""

from dataclasses import dataclass

import numpy

from evenload.face_inspection.faces import vectors

FINENESS = 40  # triangles along the diagonal of the faces, at least
FLATNESS = 1e-3  # of that diagonal, by which triangles may leave the faces
SLACK = 1.5  # of that length: a diagonal of a piece is cut no more
SPLINTER = 1e-9  # of the largest triangle: what is less has no direction
SAME = 6  # decimals of a mm: corners of neighbouring triangles are one
ROUNDING = 1e-12  # of the squares of two places: what their distance has less of is rounding
MOST_PAIRS = 4_000_000  # of corners and points that are looked at together


@dataclass(frozen=True)
class FaceMesh:
    """corners: t x 3 x 3, of triangles; normals: t x 3, out of the part; areas: t, mm2."""

    corners: numpy.ndarray
    normals: numpy.ndarray
    areas: numpy.ndarray


def mesh_of(faces):
    """The FaceMesh of PickedFaces, whose triangles are no longer than a part of their extent."""
    size = faces.size()
    corners, normals, areas = [], [], []
    for face in faces.faces:
        points, triangles = face.tessellate(FLATNESS * size)
        points = numpy.array([tuple(point) for point in points])
        split = _refined(points[numpy.array(triangles)], size / FINENESS)
        across = numpy.cross(split[:, 1] - split[:, 0], split[:, 2] - split[:, 0])
        doubled = numpy.linalg.norm(across, axis=1)
        is_one = doubled > SPLINTER * doubled.max()
        split, across, doubled = split[is_one], across[is_one], doubled[is_one]
        across /= doubled[:, None]
        largest = int(doubled.argmax())
        looks_out = _looks_out(face, split[largest].mean(axis=0), across[largest])
        corners.append(split)
        normals.append(across if looks_out else -across)
        areas.append(0.5 * doubled)
    return FaceMesh(*map(numpy.concatenate, (corners, normals, areas)))


def between(corners, points, values):
    """Values, one for each of n x 3 corners, from those at the points: means that weigh by the
    fourth power of the distance, and so come to a point's own value there.
    """
    corners, back = numpy.unique(numpy.round(corners, SAME), axis=0, return_inverse=True)
    found = numpy.empty(len(corners))
    for some, squares in _squares(corners, points):
        # By the nearest, or the power of small distances would be beyond all numbers.
        weights = (squares.min(axis=1, keepdims=True) / squares) ** 2
        found[some] = (weights @ values) / weights.sum(axis=1)
    return found[back.ravel()]


def nearest_of(points, places):
    """For each of n x 3 points the number of the nearest of m x 3 places."""
    found = numpy.empty(len(points), dtype=int)
    for some, squares in _squares(points, places):
        found[some] = squares.argmin(axis=1)
    return found


def _squares(corners, points):
    """Squares of the distances of all corners from all points, part by part: (slice, squares)."""
    step = max(1, MOST_PAIRS // len(points))
    for begin in range(0, len(corners), step):
        some = slice(begin, begin + step)
        sizes = (corners[some] ** 2).sum(axis=1)[:, None] + (points**2).sum(axis=1)
        squares = sizes - 2 * corners[some] @ points.T
        yield some, numpy.maximum(squares, ROUNDING * sizes)


def _refined(triangles, longest):
    """Triangles cut into pieces of about that length at the most.

    Twice across the longest edge of each: after that no piece is long in any direction. Halving
    edges instead would make a hundred splinters of each narrow triangle.
    """
    for _ in range(2):
        edges = numpy.linalg.norm(triangles - numpy.roll(triangles, -1, axis=1), axis=2)
        is_long = edges.max(axis=1) > SLACK * longest
        pieces = [
            _cut_across(numpy.roll(triangle, -edge, axis=0), longest)
            for triangle, edge in zip(triangles[is_long], edges[is_long].argmax(axis=1))
        ]
        triangles = numpy.concatenate([triangles[~is_long], *pieces])
    return triangles


def _cut_across(triangle, longest):
    """Triangles that make up one, cut across its first edge, which is its longest."""
    a, b, c = triangle
    length = numpy.linalg.norm(b - a)
    # Where along the edge the third corner stands.
    corner = min(max((c - a) @ (b - a) / length**2, 0.0), 1.0)
    cuts = numpy.linspace(0, 1, max(1, int(numpy.ceil(length / longest))) + 1)
    cuts = numpy.union1d(cuts, corner)
    near = a + cuts[:, None] * (b - a)
    far = numpy.stack([numpy.interp(cuts, [0, corner, 1], [a[k], c[k], b[k]]) for k in range(3)], 1)
    first = numpy.stack([near[:-1], near[1:], far[1:]], axis=1)
    second = numpy.stack([near[:-1], far[1:], far[:-1]], axis=1)
    return numpy.concatenate([first, second])


def _looks_out(face, place, normal):
    """Whether a triangle of a face, at a place, turns as the face does: out of the part."""
    at = face.Surface.parameter(*vectors([place]))
    return numpy.dot(normal, tuple(face.normalAt(*at))) > 0
