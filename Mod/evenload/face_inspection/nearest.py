"""Faces as a part of evenload.inspection: the nearest places on them, exact on the B-rep."""

import numpy
import Part

from evenload.face_inspection.faces import vectors

# Surfaces of which OpenCASCADE tells the nearest place in closed form, in microseconds.
CLOSED_FORM = (Part.Plane, Part.Cylinder, Part.Cone, Part.Sphere, Part.Toroid)
MOST_STEPS = 12  # of Newton's; three or four are usual
STILL = 1e-13  # of the surface's size: a step that is as good as none
POLE = 1e-12  # of the product of both tangents: where they vanish or coincide there is no step


class FacesPart:
    """The part that PickedFaces are, for one set of points: (points, numbers) -> (feet, normals).

    A place is looked for on each face whose box is near enough, by its surface, and counts where
    the face is not trimmed away. Points beyond the border are told by the surface of the nearest
    face, prolonged: so the deviation stays along the normal, and a point near an edge does not
    become a point of the edge. The face and the parameters of each number are remembered, as where
    the next search begins.
    """

    def __init__(self, faces):
        self._faces = [_Face(face) for face in faces.faces]
        self._lows, self._highs = faces.box()
        self._homes, self._places = {}, {}

    def __call__(self, points, numbers):
        feet, normals, _ = self._all(points, numbers)
        return feet, normals

    def distances(self, points):
        """How far n x 3 points lie from the faces, trimmed as they are; not negative."""
        return self._all(points, range(len(points)))[2]

    def places(self, points):
        """[(face, (u, v)), ...]: where on which face n x 3 points have their nearest places. They
        need not be those of the call before.
        """
        self._homes.clear()
        self._places.clear()
        self._all(points, range(len(points)))
        homes = (self._homes[number] for number in range(len(points)))
        return [
            (self._faces[home].face, self._places[number, home])
            for number, home in enumerate(homes)
        ]

    def _all(self, points, numbers):
        points = numpy.asarray(points, dtype=float).reshape(-1, 3)
        feet, normals = numpy.empty_like(points), numpy.empty_like(points)
        distances = numpy.empty(len(points))
        between = numpy.maximum(self._lows[None] - points[:, None], points[:, None] - self._highs)
        gaps = numpy.linalg.norm(numpy.maximum(between, 0), axis=2)
        for row, (point, number) in enumerate(zip(vectors(points), numbers)):
            home, distances[row] = self._nearest(point, int(number), gaps[row])
            face, place = self._faces[home], self._places[int(number), home]
            feet[row], normals[row] = face.surface.value(*place), face.face.normalAt(*place)
        return feet, normals, distances

    def _nearest(self, point, number, gaps):
        """(number of the face, distance); the place on its surface is in self._places."""
        home = self._homes.get(number)
        order = sorted(range(len(self._faces)), key=lambda k: (k != home, gaps[k]))
        found, least = None, numpy.inf
        for k in order:
            if gaps[k] >= least:
                continue
            place = self._place(k, point, number)
            distance = (self._faces[k].surface.value(*place) - point).Length
            if distance < least and self._faces[k].face.isPartOfDomain(*place):
                found, least = k, distance
        if found is None:
            found, least = self._beyond(point, number, gaps)
        self._homes[number] = found
        return found, least

    def _place(self, k, point, number):
        """Parameters of the place on the surface of face k that is nearest to a point."""
        place = self._faces[k].place(point, self._places.get((number, k)))
        self._places[number, k] = place
        return place

    def _beyond(self, point, number, gaps):
        """The same for a point whose nearest place is on no face but at an edge."""
        vertex, found, least = Part.Vertex(point), None, numpy.inf
        for k in numpy.argsort(gaps, kind="stable").tolist():
            if gaps[k] >= least:
                break
            distance, _, infos = self._faces[k].face.distToShape(vertex)
            if distance < least:
                found, least, (kind, _, place) = k, distance, infos[0][:3]
        if kind == "Face":  # OpenCASCADE found what lies beyond the seam of a closed surface
            self._places[number, found] = place
        return found, least


class _Face:
    def __init__(self, face):
        self.face, self.surface = face, face.Surface
        self._size = face.BoundBox.DiagonalLength

    def place(self, point, start):
        """Parameters of the nearest place; start: of one near by, None where none is known."""
        if isinstance(self.surface, CLOSED_FORM):
            return self.surface.parameter(point)
        if start is not None:
            place = self._refined(point, start)
            if place is not None:
                return place
        whole = self.surface.parameter(point)
        return self._refined(point, whole) or whole

    def _refined(self, point, start):
        """By Newton's steps, which go on beyond the ends of a spline; None where they do not end.

        OpenCASCADE's own search takes some milliseconds on splines.
        """
        u, v = start
        for _ in range(MOST_STEPS):
            away = self.surface.value(u, v) - point
            du, dv, duu, duv, dvv = (
                self.surface.getDN(u, v, *order)
                for order in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
            )
            a, b = du.dot(du) + away.dot(duu), du.dot(dv) + away.dot(duv)
            d = dv.dot(dv) + away.dot(dvv)
            determinant = a * d - b * b
            # Where both are not positive it is no least distance, or none that Newton finds.
            if not (a > 0 and determinant > POLE * du.dot(du) * dv.dot(dv)):
                return None
            along_u, along_v = away.dot(du), away.dot(dv)
            step_u = (b * along_v - d * along_u) / determinant
            step_v = (b * along_u - a * along_v) / determinant
            u, v = u + step_u, v + step_v
            if (du * step_u + dv * step_v).Length < STILL * self._size:
                return u, v
        return None
