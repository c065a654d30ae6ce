"""Points as arrays, and units of length."""

import numpy

MM_PER = {"mm": 1.0, "inch": 25.4}
SHOWN = {"mm": ("mm", 4), "inch": ("in", 6)}  # how a unit is written, and decimals of deviations


def points_of(given, widths=(3,)):
    """An n x width array of finite numbers; raises ValueError, in a sentence, for others."""
    try:
        points = numpy.asarray(given, dtype=float)
    except (TypeError, ValueError):
        points = None
    if points is None or points.ndim != 2 or points.shape[1] not in widths:
        raise ValueError(
            "Points are rows of %s numbers." % " or ".join("%d" % width for width in widths)
        )
    if not numpy.isfinite(points).all():
        row = int(numpy.argmin(numpy.isfinite(points).all(axis=1)))
        raise ValueError("Point %d has a coordinate that is not a number: leave it out." % row)
    return points


def normals_of(given, count):
    """A count x 3 array of length 1 each; raises ValueError, in a sentence, for others."""
    normals = points_of(given)
    lengths = numpy.linalg.norm(normals, axis=1)
    if len(normals) != count or not (lengths > 1e-9).all():
        raise ValueError("Each point needs a normal, and a normal needs a length above 0.")
    return normals / lengths[:, None]


def mm_per(unit):
    """mm of a unit; raises ValueError for any but "mm" and "inch"."""
    if unit not in MM_PER:
        raise ValueError("The unit of the points is mm or inch, not %r: state which." % (unit,))
    return MM_PER[unit]


def given(points, normals, unit):
    """(points, normals, mm of the unit) as they are written into a file. Raises ValueError, in a
    sentence, for what is none.
    """
    points = points_of(points)
    return points, normals_of(normals, len(points)), mm_per(unit)


def length_told(length, unit="mm", finer=0):
    """A length in mm as it is told in a unit, such as '0.0100 mm'; finer: more decimals than of
    deviations, or fewer.
    """
    name, decimals = SHOWN[unit]
    return "%.*f %s" % (decimals + finer, length / mm_per(unit), name)
