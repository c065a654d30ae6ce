"""Regressions of the mean chip thickness: the source's, and its models fitted to other chips."""

import warnings
from collections import namedtuple
from dataclasses import dataclass

import numpy

RADIUS = 45.0  # mm, of the source's parts
# What fit() is given: a number for each chip; nature -1 concave, 1 convex; normal in degrees, from
# the tool's axis to the part's normal at the tool's place in plan.
Rows = namedtuple("Rows", "nature feed_direction feed_per_tooth stepover normal mean_thickness")
TERMS = {
    "constant": lambda r: numpy.ones_like(r.nature),
    "nature": lambda r: r.nature,
    "feed_direction": lambda r: r.feed_direction,
    "feed_per_tooth": lambda r: r.feed_per_tooth,
    "stepover": lambda r: r.stepover,
    "stepover squared": lambda r: r.stepover**2,
    "normal": lambda r: r.normal,
    "normal squared": lambda r: r.normal**2,
}
_SHARED = ("constant", "nature", "feed_direction", "feed_per_tooth", "stepover")
MODELS = {
    "E0": (*_SHARED, "normal"),
    "E1": (*_SHARED, "normal squared"),
    "E2": (*_SHARED, "stepover squared", "normal squared"),
}
HALF = ("constant", "feed_direction", "feed_per_tooth", "stepover", "normal squared")  # of E3
# [Varga 2023, table 7], mm and degrees, in the order of the terms.
PUBLISHED = {
    "E0": (-0.00498697, -0.00042513, 0.00000416, 0.0837394, 0.0159158, -0.00000007),
    "E1": (-0.00531952, -0.00042513, 0.00000416, 0.0837394, 0.0159158, 0.00000113),
    "E2": (-0.0062177, -0.00042513, 0.00000416, 0.0843990, 0.023567, -0.015391, 0.00000113),
}
RANGE = {
    "feed_direction": (0.0, 90.0, "degrees"),
    "feed_per_tooth": (0.08, 0.16, "mm"),
    "stepover": (0.15, 0.35, "mm"),
    "normal": (-27.82, 27.82, "degrees"),
}
SLACK = 1e-9


class OutsideRange(UserWarning):
    """A regression is asked for values that lie beyond the chips that it was fitted to."""


@dataclass(frozen=True)
class Fit:
    """A fitted model: coefficients and standard_errors by term, in mm and degrees; r_squared and
    adjusted_r_squared, 0 to 1; sum_of_squares of the residuals, mm2; rows, how many there were.
    """

    coefficients: dict
    standard_errors: dict
    r_squared: float
    adjusted_r_squared: float
    sum_of_squares: float
    rows: int

    def at(self, nature, feed_direction, feed_per_tooth, stepover, normal):
        """Mean thickness in mm, as regression(), without its range."""
        rows = _rows((nature, feed_direction, feed_per_tooth, stepover, normal, 0.0))
        return sum(c * TERMS[term](rows) for term, c in self.coefficients.items())


def regression(model, nature, feed_direction, feed_per_tooth, stepover, normal):
    """Mean chip thickness in mm by the source's "E0", "E1" or "E2"; numbers, or arrays.

    nature: "CV" or -1, concave, "CX" or 1, convex. feed_direction: degrees from the cylinder's
    axis. normal: degrees, of the part at the tool's place in plan, asin(y/45). Fitted to a tool of
    10 mm, an axial depth of 0.3 mm and the ranges in RANGE; beyond them it warns by OutsideRange,
    and what would be negative is 0. Raises ValueError for a model or nature that is none. Source:
    [Varga 2023, table 7]; E3 is left out, it contradicts E1 (docs/chip_model.md).
    """
    if model not in MODELS:
        raise ValueError("The regression is E0, E1 or E2, not %r." % (model,))
    rows = _rows((nature, feed_direction, feed_per_tooth, stepover, normal, 0.0))
    for name, (low, high, unit) in RANGE.items():
        values = getattr(rows, name)
        if numpy.any((values < low - SLACK) | (values > high + SLACK)):
            warnings.warn(
                "%s was fitted to %s from %g to %g %s; here it is a guess."
                % (model, name.replace("_", " "), low, high, unit),
                OutsideRange,
                stacklevel=2,
            )
    found = sum(c * TERMS[term](rows) for term, c in zip(MODELS[model], PUBLISHED[model]))
    found = numpy.maximum(found, 0.0)
    return float(found) if found.ndim == 0 else found


def fit(rows, model=None):
    """Least squares of the source's models: {"E0", "E1", "E2", "E3 CV", "E3 CX": Fit}.

    rows: Rows, a mapping with the same keys, or n x 6 numbers in their order, thickness in mm.
    model: one of these names, then its Fit alone. E3 is E1 for concave and for convex parts apart,
    and is there where rows have both. Raises ValueError where rows are too few or all alike.
    """
    rows = _rows(rows)
    if model is not None:
        return _fit_one(model, rows)
    names = list(MODELS)
    if numpy.unique(rows.nature).size == 2:
        names += ["E3 CV", "E3 CX"]
    return {name: _fit_one(name, rows) for name in names}


def _fit_one(model, rows):
    if model in MODELS:
        return _least_squares(MODELS[model], rows)
    if model not in ("E3 CV", "E3 CX"):
        raise ValueError("The models are E0, E1, E2, E3 CV and E3 CX, not %r." % (model,))
    chosen = rows.nature == (1 if model == "E3 CX" else -1)
    return _least_squares(HALF, Rows(*(column[chosen] for column in rows)))


def _least_squares(terms, rows):
    values = numpy.atleast_1d(rows.mean_thickness)
    matrix = numpy.stack([TERMS[term](rows) for term in terms], axis=-1)
    size = numpy.linalg.norm(matrix, axis=0)
    freedom = len(values) - len(terms)
    # Columns of very different size are scaled before their rank is judged.
    if freedom < 1 or not size.all() or numpy.linalg.matrix_rank(matrix / size) < len(terms):
        raise ValueError(
            "These chips are too few or too much alike to fit %s to them." % ", ".join(terms)
        )
    q, r = numpy.linalg.qr(matrix / size)
    inverse = numpy.linalg.inv(r)
    found = inverse @ (q.T @ values) / size
    squares = float(((values - matrix @ found) ** 2).sum())
    total = float(((values - values.mean()) ** 2).sum())
    errors = numpy.sqrt(squares / freedom * (inverse**2).sum(axis=1)) / size
    return Fit(
        dict(zip(terms, found.tolist())),
        dict(zip(terms, errors.tolist())),
        1 - squares / total,
        1 - squares / freedom / (total / (len(values) - 1)),
        squares,
        len(values),
    )


def _rows(given):
    """Rows of arrays of one shape."""
    if hasattr(given, "keys"):
        given = [given[name] for name in Rows._fields]
    elif not isinstance(given, tuple):
        given = numpy.asarray(given, dtype=float).T
    if len(given) != len(Rows._fields):
        raise ValueError("Rows have six columns: %s." % ", ".join(Rows._fields))
    nature = numpy.asarray(given[0])
    if nature.dtype.kind in "UO":
        nature = numpy.where(nature == "CX", 1, numpy.where(nature == "CV", -1, 0))
    if not numpy.isin(nature, (-1, 1)).all():
        raise ValueError('The nature is "CV" or -1, concave, or "CX" or 1, convex.')
    columns = [numpy.asarray(column, dtype=float) for column in (nature, *given[1:])]
    if not all(numpy.isfinite(column).all() for column in columns):
        raise ValueError("Directions, feeds, stepovers, normals and thicknesses must be numbers.")
    return Rows(*numpy.broadcast_arrays(*columns))
