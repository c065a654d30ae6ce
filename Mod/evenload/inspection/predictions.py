"""The source's regressions of form errors of its milled test parts."""

import math
import warnings
from dataclasses import dataclass

from evenload.inspection.points import SHOWN, length_told, mm_per

# [Varga 2023, pp. 86-87]: constant, nature, feed direction in degrees, Rz in um; errors in mm.
PUBLISHED = {
    "Cyl": (0.01283, -0.0116325, 0.00014485, 0.002323),
    "SPE": (0.0147, -0.0124, 0.000132, 0.00245),
    "SPE_A": (0.0551, -0.0207, 0.000521, -0.0049),
    "SPE_AR": (0.0146, -0.0128, 0.000058, 0.00357),
}
ADJUSTED_R_SQUARED = {"Cyl": 0.956, "SPE": 0.944, "SPE_A": 0.969, "SPE_AR": 0.865}
MEANINGS = {
    "Cyl": "cylindricity",
    "SPE": "profile of a surface",
    "SPE_A": "profile of a surface in the datum",
    "SPE_AR": "profile of the round face in the datum",
}
ZIG_ZAG = "Zig-zag"
SAME = 0.02  # share by which values count as the source's, which rounds its own feeds so


class OutsideRange(UserWarning):
    """A regression is asked for values beyond the parts that it was fitted to."""


def predict(error, nature, feed_direction, rz):
    """A form error in mm of the source's test part, by its regression.

    error: "Cyl", cylindricity of R45; "SPE", profile without a datum; "SPE_A", with the plane as
    datum; "SPE_AR", that on R45 alone. nature: "CX" or "CV". feed_direction: degrees from the
    cylinder's axis, 0 to 90. rz: roughness Rz in um. Ten parts, zig-zag at 0.08 mm per tooth,
    stepover 0.15 mm, axial depth 0.3 mm, 5100 rev/min: beyond 0 to 90 degrees it warns by
    OutsideRange, and what would be negative is 0. Raises ValueError for words that are none, and
    for numbers that are not finite. Source: [Varga 2023, pp. 86-87].
    """
    if error not in PUBLISHED:
        raise ValueError("The errors are %s, not %r." % (", ".join(PUBLISHED), error))
    if nature not in ("CX", "CV"):
        raise ValueError('The nature is "CX" or "CV", not %r.' % (nature,))
    if not (math.isfinite(feed_direction) and math.isfinite(rz) and rz >= 0):
        raise ValueError("Feed direction and Rz must be numbers, and Rz not below 0.")
    if not 0 <= feed_direction <= 90:
        warnings.warn(
            "%s was fitted to feed directions from 0 to 90 degrees; here it is a guess." % error,
            OutsideRange,
            stacklevel=2,
        )
    constant, of_nature, of_direction, of_rz = PUBLISHED[error]
    sign = 1 if nature == "CX" else -1
    return max(0.0, constant + of_nature * sign + of_direction * feed_direction + of_rz * rz)


@dataclass(frozen=True)
class Cut:
    """How a face is finished. stepover, feed_per_tooth, depth (what is taken off), tool_radius and
    face_radius in mm, spindle_speed in rev/min; passes: "Zig-zag", or another strategy's name.
    """

    stepover: float
    feed_per_tooth: float
    depth: float
    tool_radius: float
    face_radius: float
    spindle_speed: float
    passes: str = ZIG_ZAG

    def differences(self, unit="mm"):
        """[words, ...] on what is another than on the source's parts; lengths told in a unit."""
        told = []
        for name in ("stepover", "feed_per_tooth", "depth", "tool_radius", "face_radius"):
            here, there = getattr(self, name), getattr(SOURCE, name)
            if abs(here - there) > SAME * there:
                lengths = tuple("%.4g" % (each / mm_per(unit)) for each in (here, there))
                words = (name.replace("_", " "), *lengths, SHOWN[unit][0])
                told.append("%s %s, not %s %s" % words)
        if abs(self.spindle_speed - SOURCE.spindle_speed) > SAME * SOURCE.spindle_speed:
            speeds = self.spindle_speed, SOURCE.spindle_speed
            told.append("spindle speed %.0f rev/min, not %.0f" % speeds)
        if self.passes != ZIG_ZAG:
            told.append("passes %s, not %s" % (self.passes, ZIG_ZAG))
        return told


# All of the source's parts were finished so [Varga 2023, p. 74].
SOURCE = Cut(0.15, 0.08, 0.3, 5.0, 45.0, 5100.0)


@dataclass(frozen=True)
class Prediction:
    """What the source's regressions say of a face. errors: {name of PUBLISHED: mm}; nature,
    feed_direction, rz: as of predict(); cut: a Cut.
    """

    errors: dict
    nature: str
    feed_direction: float
    rz: float
    cut: Cut

    def sentences(self, unit="mm"):
        """What it comes to, one sentence each, with its warnings; lengths told in a unit."""
        told = [
            "Predicted %s: %s." % (MEANINGS[name], length_told(error, unit))
            for name, error in self.errors.items()
        ]
        return told + self.warnings(unit)

    def warnings(self, unit="mm"):
        """Sentences on what makes it a guess; none within what the source measured."""
        differences = self.cut.differences(unit)
        if not differences:
            return []
        return ["Outside of what the source measured, a guess: %s." % "; ".join(differences)]


def prediction(nature, feed_direction, rz, cut):
    """The Prediction of all form errors of a face that is finished by a Cut.

    nature, feed_direction, rz: as of predict(), with feed directions from 0 to 90 degrees. The
    regressions know no other cut than the source's: what differs is told, not reckoned. Raises
    ValueError as predict() does, and for another feed direction.
    """
    if not 0 <= feed_direction <= 90:
        raise ValueError("The feed direction is 0 to 90 degrees from the cylinder's axis.")
    errors = {name: predict(name, nature, feed_direction, rz) for name in PUBLISHED}
    return Prediction(errors, nature, feed_direction, rz, cut)
