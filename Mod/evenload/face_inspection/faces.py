"""The faces that are inspected, as they stand in the world."""

from dataclasses import dataclass

import FreeCAD
import numpy
import Part

from evenload.geometry.items import element_of, placed
from evenload.words import name_of


@dataclass(frozen=True)
class PickedFaces:
    """parts: (label of the object, name of the face) of each; faces: their shapes, in that order,
    with normals out of the part. border: edges that only one of the faces has, a Part.Compound;
    None where there is none, as of a sphere. whole: the objects that they belong to.
    """

    parts: list
    faces: list
    border: object
    whole: object

    @property
    def name(self):
        """Such as 'Face7, Face9 of Model'."""
        return name_of(self.parts)

    def box(self):
        """(lows, highs) of the faces, n x 3 each."""
        boxes = [face.BoundBox for face in self.faces]
        lows = [(box.XMin, box.YMin, box.ZMin) for box in boxes]
        highs = [(box.XMax, box.YMax, box.ZMax) for box in boxes]
        return numpy.array(lows), numpy.array(highs)

    def size(self):
        """The diagonal of the box around all faces."""
        lows, highs = self.box()
        return float(numpy.linalg.norm(highs.max(axis=0) - lows.min(axis=0)))

    def is_within(self, point, margin):
        """Whether a point of the faces lies `margin` away from their border at least."""
        if self.border is None or margin <= 0:
            return True
        return self.border.distToShape(Part.Vertex(point))[0] >= margin


def picked(base):
    """The PickedFaces of [(document object, name of a face or several), ...].

    Each face counts once. Raises ValueError, in a sentence, for what is no face and where there is
    none.
    """
    parts, faces, whole = [], [], []
    for obj, names in base:
        shape = placed(obj)
        whole.append(shape)
        for name in (names,) if isinstance(names, str) else tuple(names):
            if shape is None or not name.startswith("Face"):
                raise ValueError(
                    "%s of %s is no face: pick the faces that are measured."
                    % (name or "All", obj.Label)
                )
            face = element_of(shape, name)
            if face is None:
                raise ValueError("There is no %s on %s: pick the faces anew." % (name, obj.Label))
            if (obj.Label, name) not in parts:
                parts.append((obj.Label, name))
                faces.append(face)
    if not faces:
        raise ValueError("No face is picked: pick the faces that are measured.")
    for part, face in zip(parts, faces):
        _check_surface(part, face)
    return PickedFaces(parts, faces, _border(faces), Part.Compound(whole))


def vectors(points):
    """FreeCAD's vectors of n x 3 numbers."""
    return [FreeCAD.Vector(*map(float, point)) for point in points]


def _check_surface(part, face):
    try:
        face.Surface
    except (TypeError, Part.OCCError):
        raise ValueError(
            "%s of %s has a surface that FreeCAD does not tell: leave it out." % (part[1], part[0])
        ) from None


def _border(faces):
    """Edges that belong to one face alone. A seam, as of a cylinder, is in its face twice."""
    counts = []
    for edge in (edge for face in faces for edge in _edges_with_seams(face)):
        for entry in counts:
            if entry[0].isSame(edge):
                entry[1] += 1
                break
        else:
            counts.append([edge, 1])
    alone = [edge for edge, count in counts if count == 1 and edge.Length > 0]
    return Part.Compound(alone) if alone else None


def _edges_with_seams(face):
    return [edge for wire in face.Wires for edge in wire.OrderedEdges if not edge.Degenerated]
