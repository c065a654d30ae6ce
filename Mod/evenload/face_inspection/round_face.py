"""What predictions need to know of the faces: how they are bent."""

import math
from dataclasses import dataclass

import Part


@dataclass(frozen=True)
class RoundFace:
    """nature: "CX", convex, or "CV", concave; radius: mm; axis: direction of its axis."""

    nature: str
    radius: float
    axis: tuple

    def feed_direction(self, angle):
        """Degrees, 0 to 90, from the axis as it is seen from above to passes at an angle in degrees
        from x.
        """
        along = math.degrees(math.atan2(self.axis[1], self.axis[0]))
        turned = (angle - along) % 180
        return min(turned, 180 - turned)


def round_face(faces):
    """The RoundFace that the largest cylinder among PickedFaces is; None where none is one."""
    found = [face for face in faces.faces if isinstance(face.Surface, Part.Cylinder)]
    if not found:
        return None
    face = max(found, key=lambda each: each.Area)
    low_u, high_u, low_v, high_v = face.ParameterRange
    middle = 0.5 * (low_u + high_u), 0.5 * (low_v + high_v)
    surface = face.Surface
    outwards = (face.valueAt(*middle) - surface.Center).dot(face.normalAt(*middle))
    return RoundFace("CX" if outwards > 0 else "CV", surface.Radius, tuple(surface.Axis))
