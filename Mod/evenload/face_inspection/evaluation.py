"""What measured points say of picked faces: a form error, its certificate, a verdict."""

import math
from dataclasses import dataclass

import numpy

from evenload import inspection
from evenload.face_inspection.measured import check_nearness, of_faces
from evenload.face_inspection.nearest import FacesPart
from evenload.inspection.fits import KINDS as FEATURES
from evenload.inspection.points import length_told
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
JUDGED = {
    IN: "It keeps the tolerance of %s.",
    OUT: "It exceeds the tolerance of %s.",
    OPEN: "Whether the tolerance of %s is kept is not decided: measure more points.",
}


@dataclass(frozen=True)
class Evaluation:
    """A form error of measured points.

    faces: the PickedFaces; measured: the MeasuredPoints; kind: one of KINDS; zone: width of the
    narrowest zone, mm; tolerance: mm, None where none is asked; deviations: signed distances, mm,
    of each point from the faces after the motion of a profile, or from the feature that was fitted;
    found: the Profile or the Fit; left_out: number of points of the file that were nearer to
    other faces; free: names of the motions of a profile that were left free; datum: (point, normal)
    of its datum plane, or None.
    """

    faces: object
    measured: object
    kind: str
    zone: float
    tolerance: object
    deviations: numpy.ndarray
    found: object
    left_out: int = 0
    free: tuple = ()
    datum: object = None

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
        """The sentences with lengths in mm."""
        return self.told()

    def told(self, unit="mm"):
        """What it comes to, one sentence each: the error, the certificate, the verdict. unit: "mm"
        or "inch", of lengths.
        """
        found, zone = self.found, length_told(self.zone, unit)
        told = ["The %s is %s, of %d points." % (self.error, zone, len(self.deviations))]
        if getattr(found, "radius", None) is not None:
            told[0] = told[0][:-1] + ", at a radius of %s." % length_told(found.radius, unit)
        if found.is_proved:
            told.append(
                "No zone near by is narrower (contacts: %d; balance of their forces: %.0e)."
                % (len(found.contacts), found.imbalance)
            )
        else:
            told.append("That it is the narrowest zone is not proved: take it for an upper bound.")
        if self.left_out:
            told.append("Points nearer to other faces, left out: %d." % self.left_out)
        if self.verdict is not None:
            told.append(JUDGED[self.verdict] % length_told(self.tolerance, unit))
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
    free = _motions(free, datum)
    _check_number(measured.points, free)
    found = inspection.profile(measured.points, part, free, datum)
    return Evaluation(
        *(faces, measured, kind, found.width, tolerance, found.deviations, found, left_out),
        *(free, datum),
    )


def _motions(free, datum):
    """The names of the free motions; what they are where nobody says, profile() has, too."""
    if free is None:
        return () if datum is not None else MOTIONS
    return (free,) if isinstance(free, str) else tuple(free)


def _check_number(points, free):
    """Few points fit any face: they must be more than the motions that are free."""
    motions = len(free)
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
