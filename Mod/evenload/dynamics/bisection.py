"""Multi-dimensional bisection: where functions of a few parameters are 0."""

import inspect
from dataclasses import dataclass, field

import numpy

from evenload.dynamics.modes import core


@dataclass
class Bisection:
    """What mdbm() found, in D axes.

    points: n x D, one for each cell that holds the set. cells: n x D, their lowest corners.
    component: n numbers; cells that share a corner have the same. components: how many there are.
    curves: list of m x D arrays, connected; closed ones end where they begin; only where there is
    one equation fewer than axes. evaluations: of the function, distinct places.
    evaluations_by_level: after the first grid and each halving. brute_force: nodes of a grid as
    fine as the last. efficiency: 1/(D_P - D_F), D_P = ln(evaluations)/ln(nodes per side of it).
    """

    points: numpy.ndarray
    cells: numpy.ndarray
    component: numpy.ndarray
    curves: list = field(repr=False)
    evaluations: int = 0
    evaluations_by_level: list = None
    brute_force: float = 0.0
    efficiency: float = 0.0

    @property
    def components(self):
        return len(set(self.component.tolist()))


def mdbm(function, axes, iterations, constraint=None, threads=None, dimension=None, progress=None):
    """The set of places within a box at which `function` is 0 [Bachrathy & Stepan 2012].

    function: takes one number for each axis, or all in one array where it has one parameter; it
    returns a number, or a sequence of one for each equation. axes: one to four (low, high, cells),
    cells of the first grid: it decides what may be overlooked. iterations: how often cells are
    halved. constraint: a function of the same arguments; only what is above 0 counts. threads:
    functions of Python run on one, and more would give the same. dimension: of the set, for
    `efficiency`, by default the number of axes less that of equations. progress: is asked with the
    share done, and answers whether to go on; where not, the core's Cancelled is raised. Returns a
    Bisection; raises ValueError for boxes that are none.
    """
    box = [_axis(axis) for axis in axes]
    if not box:
        raise ValueError("The bisection takes one to four axes, each (low, high, cells).")
    if iterations < 0:
        raise ValueError("The number of halvings must not be negative.")
    call = _caller(function, len(box))
    check = _caller(constraint, len(box)) if constraint else None
    first = numpy.atleast_1d(call([low for low, _, _ in box]))
    equations = len(first)

    def values(place):
        found = [float(value) for value in numpy.atleast_1d(call(place))]
        if check:
            found.append(float(check(place)))
        return found

    wanted = float(len(box) - equations if dimension is None else dimension)
    found = core().mdbm(values, equations, bool(check), box, int(iterations), wanted, progress)
    return Bisection(
        points=found["points"],
        cells=found["cells"],
        component=numpy.array(found["components"], dtype=int),
        curves=list(found["curves"]),
        evaluations=int(found["evaluations_by_level"][-1]),
        evaluations_by_level=list(found["evaluations_by_level"]),
        brute_force=found["brute_force"],
        efficiency=found["efficiency"],
    )


def _axis(axis):
    numbers = list(axis)
    if len(numbers) != 3:
        raise ValueError("Each axis of the bisection is (low, high, cells).")
    return float(numbers[0]), float(numbers[1]), int(numbers[2])


def _caller(function, count):
    """The function with all its arguments in one list."""
    if count > 1:
        try:
            parameters = inspect.signature(function).parameters.values()
        except (TypeError, ValueError):
            parameters = ()
        kinds = [p.kind for p in parameters if p.default is p.empty]
        named = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
        if len(kinds) == 1 and kinds[0] in named:
            return lambda place: function(numpy.array(place))
    return lambda place: function(*place)
