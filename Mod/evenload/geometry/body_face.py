"""A face of a body: which way it looks, and its parts above a height."""

import math

import FreeCAD
import Part

from evenload.geometry.in_plane import FLAT, LEVEL

# mm: planes that stand over a strip no wider than this are upright: files round directions.
STRIP = 1e-6
SIGHTINGS = 7  # places along each side of a face where its inclination is looked at
OVER = 1.0  # mm by which boxes that cut a face reach beyond it


class BodyFace:
    """A face of a body, and which way it looks."""

    def __init__(self, shape):
        self.shape = shape
        self.box = shape.BoundBox
        surface = shape.Surface
        self.is_upright = is_upright(surface) or self._stands_over_a_strip(surface)
        is_level = isinstance(surface, Part.Plane) and abs(surface.Axis.z) > 1 - LEVEL
        self.looks_up = is_level and shape.normalAt(0, 0).z > 0
        self.is_askew = is_level and math.hypot(surface.Axis.x, surface.Axis.y) > LEVEL
        self.leans = not (is_level or self.is_upright)
        # Heights at which it turns over, if its axis is upright, or level.
        round_ = isinstance(surface, (Part.Sphere, Part.Toroid, Part.Cylinder))
        self.turning = [surface.Center.z] if round_ and self.leans else []

    def _stands_over_a_strip(self, surface):
        if not isinstance(surface, Part.Plane) or abs(surface.Axis.z) > 0.5:
            return False
        return abs(surface.Axis.z) * self.box.ZLength < STRIP

    def parts_above(self, z):
        """[(part of the face above z, its _inclination), ...]"""
        low, high = max(z, self.box.ZMin), self.box.ZMax
        ends = [low, *(z for z in self.turning if low + FLAT < z < high - FLAT), high]
        parts = [
            part for a, b in zip(ends, ends[1:]) for part in _between(self.shape, self.box, a, b)
        ]
        return [(part, _inclination(part)) for part in parts]


def is_upright(surface):
    """Whether a face's surface stands upright all over."""
    if isinstance(surface, Part.Plane):
        return abs(surface.Axis.z) < LEVEL
    if isinstance(surface, Part.Cylinder):
        return abs(surface.Axis.z) > 1 - LEVEL
    if isinstance(surface, Part.SurfaceOfExtrusion):
        return abs(surface.Direction.z) > 1 - LEVEL
    return False


def _between(face, box, low, high):
    """The parts of a face between two heights."""
    if box.ZMin > low - FLAT and box.ZMax < high + FLAT:
        return [face]
    corner = FreeCAD.Vector(box.XMin - OVER, box.YMin - OVER, low)
    slab = Part.makeBox(box.XLength + 2 * OVER, box.YLength + 2 * OVER, high - low, corner)
    return face.common(slab).Faces


def _inclination(face):
    """1 for a face that looks up wherever it is looked at, -1 for one that looks down, 0 for one
    that does both.
    """
    u0, u1, v0, v1 = face.ParameterRange
    shares = [(k + 0.5) / SIGHTINGS for k in range(SIGHTINGS)]
    z = [face.normalAt(u0 + a * (u1 - u0), v0 + b * (v1 - v0)).z for a in shares for b in shares]
    looks_up, looks_down = max(z) > LEVEL, min(z) < -LEVEL
    return int(looks_up) - int(looks_down) if looks_up != looks_down else 0
