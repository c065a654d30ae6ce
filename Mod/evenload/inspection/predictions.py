"""The source's regressions of form errors of its milled test parts."""

import math
import warnings

# [Varga 2023, pp. 86-87]: constant, nature, feed direction in degrees, Rz in um; errors in mm.
PUBLISHED = {
    "Cyl": (0.01283, -0.0116325, 0.00014485, 0.002323),
    "SPE": (0.0147, -0.0124, 0.000132, 0.00245),
    "SPE_A": (0.0551, -0.0207, 0.000521, -0.0049),
    "SPE_AR": (0.0146, -0.0128, 0.000058, 0.00357),
}
ADJUSTED_R_SQUARED = {"Cyl": 0.956, "SPE": 0.944, "SPE_A": 0.969, "SPE_AR": 0.865}


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
