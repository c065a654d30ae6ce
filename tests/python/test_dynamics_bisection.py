"""evenload.dynamics.mdbm: known sets, with as few evaluations as the reference needs."""

import math

import numpy
import pytest
from dynamics_cases import REFERENCE, case
from evenload.dynamics import mdbm

pytestmark = pytest.mark.core


def circle(x, y):
    return x * x + y * y - 1


def two_circles(x, y):
    return circle(x, y) * ((x - 1.37) ** 2 + (y - 1.41) ** 2 - 0.07**2)


def tori(x, y, z):
    return (
        (math.hypot(x, y) - 1) ** 2 + z * z - 0.16,
        (math.hypot(y, z) - 1) ** 2 + (x - 0.9) ** 2 - 0.16,
    )


def weierstrass(x, y):
    return y - sum(0.5**k * math.cos(3**k * math.pi * x) for k in range(24))


def island_chart(n, a):
    return case("islands").spectral_radius(n, a) - 1


FUNCTIONS = {
    "circle": circle,
    "two circles": two_circles,
    "two circles, coarse": two_circles,
    "tori": tori,
    "Weierstrass": weierstrass,
    "chart": island_chart,
}
SETS = {row["name"]: row for row in REFERENCE["bisection"]["sets"]}


@pytest.mark.parametrize("name", SETS)
def test_sets_are_found_with_the_reference_s_evaluations(name):
    row = SETS[name]
    found = mdbm(FUNCTIONS[name], row["axes"], row["halvings"], dimension=row["D_F"])
    assert found.components == row["components"]
    for ours, theirs in zip(found.evaluations_by_level, row["evaluations"]):
        assert ours <= 1.25 * theirs
    assert found.evaluations == found.evaluations_by_level[-1] < found.brute_force
    assert found.brute_force == row["brute_force"]
    assert found.efficiency == pytest.approx(row["E"], rel=0.05)
    assert len(found.points) == len(found.cells) == len(found.component)


def test_the_curves_of_two_tori_have_their_length():
    row = SETS["tori"]
    found = mdbm(tori, row["axes"], row["halvings"])
    length = sum(
        numpy.linalg.norm(numpy.diff(curve, axis=0), axis=1).sum() for curve in found.curves
    )
    expected = REFERENCE["bisection"]["tori_curve_length"]
    assert length == pytest.approx(expected, rel=REFERENCE["bisection"]["tol_rel_length"])
    assert all((curve[0] == curve[-1]).all() for curve in found.curves)


def test_points_of_a_circle_lie_on_it():
    row = SETS["circle"]
    found = mdbm(circle, row["axes"], row["halvings"])
    assert abs(numpy.hypot(*found.points.T) - 1).max() <= 1.05 * row["largest_error"]


def test_a_function_of_one_array_is_called_so():
    found = mdbm(lambda place: place @ place - 1, SETS["circle"]["axes"], 3)
    assert found.evaluations == SETS["circle"]["evaluations"][3]


def test_only_what_the_constraint_allows_is_found():
    found = mdbm(circle, SETS["circle"]["axes"], 5, constraint=lambda x, y: y)
    assert found.points[:, 1].min() > -1e-6
    assert found.evaluations < SETS["circle"]["evaluations"][5]


def test_one_axis_gives_roots():
    found = mdbm(lambda x: math.cos(x), [(0, 10, 7)], 10)
    expected = [0.5 * math.pi, 1.5 * math.pi, 2.5 * math.pi]
    assert sorted(found.points.ravel()) == pytest.approx(expected, abs=1e-5)


def test_four_axes_are_the_most():
    found = mdbm(lambda *x: sum(v * v for v in x) - 1, [(-1.5, 1.6, 3)] * 4, 1)
    assert found.points.shape[1] == 4
    assert numpy.linalg.norm(found.points, axis=1) == pytest.approx(1, abs=0.15)
    with pytest.raises(ValueError, match="one to four axes"):
        mdbm(lambda *x: 0.0, [(0, 1, 1)] * 5, 1)
    with pytest.raises(ValueError, match="one to four axes"):
        mdbm(lambda: 0.0, [], 1)


def test_errors_of_the_function_come_through_and_work_can_be_cancelled():
    def fails(x, y):
        raise ZeroDivisionError("no value here")

    with pytest.raises(ZeroDivisionError):
        mdbm(fails, SETS["circle"]["axes"], 2)
    with pytest.raises(Exception, match="Cancelled"):
        mdbm(circle, SETS["circle"]["axes"], 2, progress=lambda done: False)
