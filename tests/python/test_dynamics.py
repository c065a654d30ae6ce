"""evenload.dynamics: reference values, units, laws, and what is refused."""

import math

import numpy
import pytest
from dynamics_cases import REFERENCE, case, helical, modes
from evenload import dynamics
from evenload.dynamics import Frf, Mode, charts

pytestmark = pytest.mark.core

STABILITY = REFERENCE["stability"]

# ---- stability ----


@pytest.mark.parametrize("row", STABILITY["multipliers"], ids=lambda row: row["case"])
def test_the_spectral_radius_is_the_reference_s(row):
    radius = case(row["case"]).spectral_radius(row["rpm"], row["ap_mm"])
    assert radius == pytest.approx(row["rho"], abs=1e-4)
    accurate = case(row["case"]).spectral_radius(row["rpm"], row["ap_mm"], accuracy=1e-6)
    assert accurate == pytest.approx(row["rho"], abs=2e-6)
    largest = case(row["case"]).multipliers(row["rpm"], row["ap_mm"])[0]
    assert abs(largest) == pytest.approx(accurate, abs=1e-5)


@pytest.mark.parametrize("row", STABILITY["critical_depths"], ids=lambda row: row["case"])
def test_critical_depths_are_the_reference_s(row):
    milling = case(row["case"])
    found = [milling.critical_depth(speed, 10) for speed in row["rpm"]]
    assert found == pytest.approx(row["ap_mm"], rel=2e-5)


def test_no_depth_is_critical_where_all_are_stable():
    assert case("half_down").critical_depth(15000, 2.5) == math.inf


def test_arrays_broadcast():
    milling = case("half_down")
    radii = milling.spectral_radius(numpy.array([[5000], [8000]]), numpy.array([0.2, 0.5, 0.9]))
    assert radii.shape == (2, 3)
    assert radii[0, 1] == pytest.approx(milling.spectral_radius(5000, 0.5), abs=1e-12)


def test_the_chart_has_the_reference_s_rows():
    rows = STABILITY["chart"]["rows"]
    low, high, columns = STABILITY["chart"]["rpm"]
    top, bottom, lines = STABILITY["chart"]["ap_mm_from_top"]
    speeds = numpy.linspace(low, high, columns)
    depths = numpy.linspace(top, bottom, lines)
    chart = case("islands").chart((9000, 22000), (0.3, 8))
    stable = chart.is_stable(*numpy.meshgrid(speeds, depths))
    for row, line in zip(rows, stable):
        for sign, is_stable in zip(row, line):
            assert sign == "?" or (sign == ".") == is_stable


def test_the_chart_s_curves_lie_on_the_boundary_and_close_around_islands():
    milling = case("islands")
    chart = milling.chart((9000, 22000), (0.3, 5))
    closed = [curve for curve in chart.curves if (curve[0] == curve[-1]).all()]
    assert len(chart.curves) == 4 and len(closed) == 3
    for curve, kinds, frequencies in zip(chart.curves, chart.kind, chart.chatter_frequency):
        assert curve.shape == (len(kinds), 2) and frequencies.shape == (len(kinds),)
        radii = milling.spectral_radius(*curve[::20].T, accuracy=1e-6)
        assert radii == pytest.approx(numpy.ones(len(radii)), abs=2e-3)
    for wanted, speed in ((STABILITY["crossings"][0], 11800), (STABILITY["crossings"][1], 20000)):
        found = crossings(chart, speed)
        assert found == pytest.approx([depth for depth in wanted["ap_mm"] if depth < 5], rel=0.005)
    assert chart.evaluations < 7000 and chart.seconds > 0 and chart.efficiency > 2


def crossings(chart, speed):
    """Depths at which the curves pass a speed."""
    found = []
    for curve in chart.curves:
        for (n0, a0), (n1, a1) in zip(curve, curve[1:]):
            if (n0 < speed) != (n1 < speed):
                found.append(a0 + (a1 - a0) * (speed - n0) / (n1 - n0))
    return sorted(found)


def test_threads_give_the_same_chart():
    charts_of = [
        case("iso_down").chart((5000, 9000, 12), (0.2, 4, 8), tolerance=0.02, threads=threads)
        for threads in (1, 2)
    ]
    assert charts_of[0].evaluations == charts_of[1].evaluations
    for a, b in zip(charts_of[0].curves, charts_of[1].curves):
        assert (a == b).all()


def test_levels_come_one_by_one_and_can_be_cancelled():
    levels = list(case("half_down").chart_levels((5000, 25000, 16), (0.1, 4, 8), 1 / 64))
    assert len(levels) == 4  # half of the first grid's lines, the grid, two halvings
    at_once = case("half_down").chart((5000, 25000, 16), (0.1, 4, 8), tolerance=1 / 64)
    assert levels[-1].evaluations == at_once.evaluations
    counts = [level.evaluations for level in levels]
    assert counts == sorted(set(counts))
    with pytest.raises(Exception, match="Cancelled"):
        case("half_down").chart((5000, 25000), (0.1, 4), progress=lambda done: False)


def test_progress_is_told_and_never_turns_back():
    shares = []
    case("half_down").chart(
        (5000, 25000, 16),
        (0.1, 4, 8),
        tolerance=1 / 64,
        progress=lambda done: shares.append(done) or True,
    )
    assert shares == sorted(shares) and 0.5 < shares[-1] <= 1


def test_the_worst_feed_direction_is_that_of_all_directions():
    milling = case("asym_helix")
    worst, direction = milling.worst_spectral_radius(7000, 2)
    assert worst == pytest.approx(1.59, abs=0.01) and direction == pytest.approx(90, abs=15)
    tangents = [0, 90, 150]
    assert milling.worst_spectral_radius(7000, 2, tangents)[0] == pytest.approx(worst, rel=0.01)


def test_the_chatter_frequency_is_that_of_the_strongest_vibration():
    assert case("half_down").chatter(5000, 0.8472035) == ("Hopf", pytest.approx(897.4168, abs=0.01))
    assert case("half_down").chatter(15000, 2.596238) == ("flip", pytest.approx(750, abs=0.01))


# ---- frequency domain ----

EMFS = REFERENCE["frequency_domain"]["emfs"]


@pytest.mark.parametrize("row", EMFS, ids=lambda row: "%s-%d" % (row["case"], row["rpm"]))
def test_the_multi_frequency_solution_is_the_reference_s(row):
    harmonics, depths, frequencies = row["K"][:3], row["ap_mm_K"], row["chatter_Hz_K"]
    for count, depth, frequency in zip(harmonics, depths, frequencies):
        found = charts.limit(case(row["case"]), row["rpm"], depth, frequency, count)
        assert found == pytest.approx((depth, frequency), rel=1e-6)


@pytest.mark.parametrize("row", REFERENCE["frequency_domain"]["zeroth_order"])
def test_the_zeroth_order_is_the_reference_s(row):
    found = charts.zeroth_order(case(row["case"]), row["chatter_Hz"])
    assert [depth for depth, _ in found] == pytest.approx(row["ap_mm"], rel=1e-6)
    assert [phase for _, phase in found] == pytest.approx(row["phase_rad"], rel=1e-6)


def test_zeroth_order_lobes_have_their_closed_form_s_least_depth():
    chart = case("slot").chart((3000, 20000), (0, 3), method="zeroth-order")
    least = min(curve[:, 1].min() for curve in chart.curves)
    expected = REFERENCE["frequency_domain"]["zeroth_order_slot_least_mm"]
    assert least == pytest.approx(expected, rel=1e-4)
    assert chart.is_stable(9000, 0.29) and not chart.is_stable(9000, 2.9)


def test_the_multi_frequency_chart_is_that_of_the_multipliers():
    milling = case("half_down")
    chart = milling.chart(
        (12000, 18000, 10), (0.3, 4, 8), method="multi-frequency", tolerance=0.03, harmonics=6
    )
    for curve in chart.curves:
        depth = [milling.critical_depth(speed, 10) for speed in curve[::25, 0]]
        # Curves go on within unstable ground.
        assert (curve[::25, 1] > 0.97 * numpy.array(depth)).all()
    assert chart.is_stable(15000, 2.5) and not chart.is_stable(15000, 2.75)


def test_a_measured_response_stands_for_modes():
    frf = Frf.of_modes(modes("half_down"))
    measured = case("half_down", modes=frf)
    assert measured.critical_depth(5000, 5) == pytest.approx(0.8472, rel=0.005)
    with pytest.raises(ValueError, match="needs modes: fit them"):
        measured.spectral_radius(5000, 0.5)


# ---- the best cut ----


def test_the_best_cut_is_stable_with_its_margin_and_leaves_a_straight_wall():
    box = ((6000, 15000), (0.1, 6))
    found = dynamics.best(helical("down"), box, surface_limit=0.02)
    assert found.spectral_radius <= 0.9 + 1e-9
    assert abs(found.surface_location_error) <= 0.02
    both = [
        dynamics.best(helical("down"), box, surface_limit=0.02, cut_modes=[mode])
        for mode in ("climb", "conventional")
    ]
    assert found.removal_rate == max(row.removal_rate for row in both)
    free = dynamics.best(helical("down"), box)
    assert free.removal_rate >= found.removal_rate
    rate = found.depth * 0.8 * 2 * 0.1 * found.speed
    assert found.removal_rate == pytest.approx(rate)
    assert dynamics.best(helical("down"), ((6000, 6100), (20, 30)), margin=0.999) is None


# ---- modes and bad input ----


def test_a_mode_of_a_stiffness_has_its_mass():
    mode = Mode.from_stiffness(20, 900, 0.03, 90)
    assert mode.mass == pytest.approx(2e7 / (2 * math.pi * 900) ** 2)
    assert mode.stiffness == pytest.approx(20) and mode.direction == 90


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({"modes": []}, "no mode"),
        ({"teeth": 0}, "at least one tooth"),
        ({"immersion": 0}, "immersion must lie above 0"),
        ({"immersion": 1.2}, "immersion must lie above 0"),
        ({"cut_mode": "up"}, "cut_mode is"),
        ({"tooth_angles": [100, 200]}, "sum to 360"),
        ({"helix_pitch": -1}, "lead of the helix"),
        ({"helix_pitch": 10, "helix_angle": 30}, "not both"),
        ({"diameter": 0}, "diameter"),
        ({"tangential": -600}, "tangential"),
        ({"tangential": math.nan}, "tangential"),
        ({"process_damping": -1}, "Process damping"),
    ],
)
def test_processes_that_cannot_be_are_refused(arguments, words):
    with pytest.raises(ValueError, match=words) as refusal:
        case("slot", **arguments)
    assert str(refusal.value).count(". ") == 0 and str(refusal.value).endswith(".")


@pytest.mark.parametrize(
    "numbers, words", [((-1, 900, 0.01), "mass"), ((1, 0, 0.01), "frequency"), ((1, 9, -1), "damp")]
)
def test_modes_that_cannot_be_are_refused(numbers, words):
    with pytest.raises(ValueError, match=words):
        Mode(*numbers)


def test_cuts_that_cannot_be_are_refused():
    milling = case("slot")
    for speed, depth in ((0, 1), (-5, 1), (5000, -1), (math.nan, 1)):
        with pytest.raises(ValueError):
            milling.spectral_radius(speed, depth)
    with pytest.raises(ValueError, match="method of a chart"):
        milling.chart((1, 2), (0, 1), method="guess")
    with pytest.raises(ValueError, match="rising grid"):
        milling.chart((5000, 4000, 3000, 2000), (0, 1))
    with pytest.raises(ValueError, match="feed per tooth"):
        milling.surface(5000, 1, 0)
    with pytest.raises(ValueError, match="chip is"):
        milling.forced_orbits(5000, [1], 0.1, chip="other")
    short = case("slot", flute_length=5)
    with pytest.raises(ValueError, match="beyond the tool's flutes, 5 mm"):
        short.spectral_radius(5000, [1, 6])
    assert short.spectral_radius(5000, 0.2) == milling.spectral_radius(5000, 0.2)
