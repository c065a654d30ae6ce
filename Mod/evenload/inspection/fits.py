"""Features through measured points."""

from dataclasses import dataclass

import numpy

from evenload import compiled
from evenload.inspection.points import points_of

METHODS = ("minimum zone", "least squares")
KINDS = ("line", "plane", "circle", "sphere", "cylinder")
# The core's numbers of kinds, for points in the plane and in space.
PLANAR = {"line": 0, "circle": 3}
SPATIAL = {"line": 1, "plane": 2, "circle": 3, "sphere": 4, "cylinder": 5}


@dataclass(frozen=True)
class Fit:
    """A feature through points; lengths in the unit of the points.

    kind, method: as given. zone: width of the zone that holds all points, a diameter for a line in
    space. point: on the line, plane or axis nearest to the points' mean, or the centre of a circle
    or sphere; 2 or 3 numbers. direction: of the line or axis, or normal to a plane or circle, of
    length 1, its largest number positive; None for spheres and for circles in the plane. radius:
    None for lines and planes. deviations: signed distance of each point from the feature, positive
    outside, on the side of a plane's direction or to the left of a line's; never negative for a
    line in space. rms: of these.

    The proof of a minimum zone: contacts, numbers of the points that touch it; sides, 1 where they
    touch its outer bound and -1 its inner one; multipliers >= 0 of sum 1, forces along their
    normals that balance each other; imbalance, what is left of these forces, 0 but for rounding;
    is_proved: whether all that holds, so that no neighbouring zone is narrower. Of least squares
    there are no contacts, and is_proved says that the squares' sum is stationary.
    """

    kind: str
    method: str
    zone: float
    point: numpy.ndarray
    direction: object
    radius: object
    deviations: numpy.ndarray
    contacts: numpy.ndarray
    sides: numpy.ndarray
    multipliers: numpy.ndarray
    imbalance: float
    is_proved: bool

    @property
    def rms(self):
        return float(numpy.sqrt(numpy.mean(self.deviations**2)))


def fit(points, kind, method="minimum zone"):
    """The Fit of a feature to points.

    points: n x 3 numbers in one unit of length, or n x 2 for lines and circles in the plane. kind:
    "line", "plane", "circle", "sphere" or "cylinder". A circle's points in space are first
    projected on the plane of least squares through them; their flatness is fit(points, "plane").
    method: "minimum zone", as ISO 1101 defines form errors, or "least squares". Raises ValueError,
    in a sentence, for a kind or method that is none, points that are too few or not finite, and
    points that do not determine the feature. docs/inspection.md has the method and what is_proved
    proves.
    """
    if kind not in KINDS:
        raise ValueError("The kind of a feature is %s, not %r." % (", ".join(KINDS), kind))
    if method not in METHODS:
        raise ValueError("The method is minimum zone or least squares, not %r." % (method,))
    points = points_of(points, (2, 3))
    is_spatial = points.shape[1] == 3
    numbers = SPATIAL if is_spatial else PLANAR
    if kind not in numbers:
        raise ValueError("A %s needs points of three coordinates." % kind)
    if not is_spatial:
        points = numpy.column_stack([points, numpy.zeros(len(points))])
    found = compiled.core().inspection.fit(
        numbers[kind], method == "minimum zone", points, is_spatial
    )
    size = 3 if is_spatial else 2
    has_direction = kind != "sphere" and (is_spatial or kind == "line")
    return Fit(
        kind,
        method,
        found.zone,
        found.point[:size],
        found.direction[:size] if has_direction else None,
        found.radius if kind in ("circle", "sphere", "cylinder") else None,
        found.deviations,
        found.contacts,
        found.sides,
        found.multipliers,
        found.imbalance,
        found.is_proved,
    )
