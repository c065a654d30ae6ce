"""What measured points say of picked faces: a form error, its certificate, a verdict."""

import math
from dataclasses import dataclass

import numpy

from evenload import inspection
from evenload.face_inspection.measured import check_nearness, of_faces
from evenload.face_inspection.nearest import FacesPart
from evenload.inspection.fits import KINDS as FEATURES
from evenload.inspection.profiles import MOTIONS

PROFILE = "profile"
KINDS = (PROFILE, *FEATURES)
ERRORS = {  # what the zone of each is called [ISO 1101]
    PROFILE: "profile of a surface",
    "line": "straightness",
    "plane": "flatness",
    "circle": "roundness",
    "sphere": "sphericity",
    "cylinder": "cylindricity",
}
STRAIGHT = 1e-6  # of the points' extent: what lies nearer to one line tells no surface
IN, OUT, OPEN = "in tolerance", "out of tolerance", "not decided"


@dataclass(frozen=True)
class Evaluation:
    """A form error of measured points.

    faces: the PickedFaces; measured: the MeasuredPoints; kind: one of KINDS; zone: width of the
    narrowest zone, mm; tolerance: mm, None where none is asked; deviations: signed distances, mm,
    of each point from the faces after the motion of a profile, or from the feature that was fitted;
    found: the Profile or the Fit; left_out: number of points of the file that were nearer to
    other faces.
    """

    faces: object
    measured: object
    kind: str
    zone: float
    tolerance: object
    deviations: numpy.ndarray
    found: object
    left_out: int = 0

    @property
    def verdict(self):
        """IN, OUT or OPEN; None without a tolerance. The zone holds all points, proved or not; but
        only a proved one shows that none narrower does.
        """
        if self.tolerance is None:
            return None
        if self.zone <= self.tolerance:
            return IN
        return OUT if self.found.is_proved else OPEN

    @property
    def is_beyond(self):
        """For each point whether it lies beyond the tolerance: half of it about the faces, or about
        the middle of a feature's zone. None without a tolerance.
        """
        if self.tolerance is None:
            return None
        return numpy.abs(self.deviations) > 0.5 * self.tolerance

    @property
    def sentences(self):
        """What it comes to, one sentence each: the error, the certificate, the verdict."""
        found = self.found
        told = ["The %s is %.4f mm, of %d points." % (self.error, self.zone, len(self.deviations))]
        if getattr(found, "radius", None) is not None:
            told[0] = told[0][:-1] + ", at a radius of %.4f mm." % found.radius
        if found.is_proved:
            told.append(
                "No zone near by is narrower (contacts: %d; balance of their forces: %.0e)."
                % (len(found.contacts), found.imbalance)
            )
        else:
            told.append("That it is the narrowest zone is not proved: take it for an upper bound.")
        if self.left_out:
            told.append("Points nearer to other faces, left out: %d." % self.left_out)
        if self.verdict == IN:
            told.append("It keeps the tolerance of %.4f mm." % self.tolerance)
        elif self.verdict == OUT:
            told.append("It exceeds the tolerance of %.4f mm." % self.tolerance)
        elif self.verdict == OPEN:
            told.append(
                "Whether the tolerance of %.4f mm is kept is not decided: measure more points."
                % self.tolerance
            )
        return told

    @property
    def error(self):
        """What the zone is called, as 'flatness'."""
        return ERRORS[self.kind]


def evaluate(faces, measured, kind=PROFILE, tolerance=None, free=None, datum=None, all_points=True):
    """The Evaluation of MeasuredPoints against PickedFaces.

    kind: "profile", against the faces themselves, or a feature that is fitted by minimum zone:
    "line", "plane", "circle", "sphere", "cylinder". tolerance: width of the zone allowed, mm. free:
    motions of a profile that are left free, of "tx", "ty", "tz", "rx", "ry", "rz"; None: all, or
    none with a datum. datum: (point, normal) of the datum plane. all_points: False leaves out those
    that other faces of the same objects are nearer to, as where one file is of many faces. Raises
    ValueError, in a sentence, for points that are too few, on one line, or far from the faces, and
    as fit() and profile() do.
    """
    if kind not in KINDS:
        raise ValueError("What is evaluated is %s, not %r." % (", ".join(KINDS), kind))
    if tolerance is not None and not (math.isfinite(tolerance) and tolerance > 0):
        raise ValueError("The tolerance is a width above 0, not %r." % (tolerance,))
    if kind != PROFILE and not (free is None and datum is None):
        raise ValueError("Only a profile has free motions or a datum: take these out.")
    part, left_out = FacesPart(faces), 0
    if not all_points:
        measured, left_out = of_faces(faces, part, measured)
        part = FacesPart(faces)  # the points have other numbers now
    check_nearness(faces, part, measured)
    if kind != PROFILE:
        found = inspection.fit(measured.points, kind)
        zone = found.zone
        return Evaluation(faces, measured, kind, zone, tolerance, found.deviations, found, left_out)
    _check_number(measured.points, free, datum)
    found = inspection.profile(measured.points, part, free, datum)
    width = found.width
    return Evaluation(faces, measured, kind, width, tolerance, found.deviations, found, left_out)


def datum_of(faces):
    """(point, normal) of the datum plane that PickedFaces are. Raises ValueError for what is no
    single plane.
    """
    if len(faces.faces) != 1 or not faces.faces[0].Surface.isPlanar():
        raise ValueError("The datum is one plane face, not %s." % faces.name)
    face = faces.faces[0]
    return tuple(face.CenterOfMass), tuple(
        face.normalAt(*face.Surface.parameter(face.CenterOfMass))
    )


def _check_number(points, free, datum):
    """Few points fit any face: they must be more than the motions that are free."""
    if free is None:
        free = () if datum is not None else MOTIONS
    motions = len((free,) if isinstance(free, str) else tuple(free))
    if len(points) <= motions:
        raise ValueError(
            "%d points fit any face by %d free motions: measure %d or more, or leave fewer free."
            % (len(points), motions, motions + 1)
        )
    if not motions:
        return
    sizes = numpy.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if sizes[1] <= STRAIGHT * sizes[0]:
        raise ValueError("All points lie on one line: spread them over the faces.")
