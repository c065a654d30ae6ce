"""evenload.dynamics: surfaces, orbits and turning against reference values."""

import numpy
import pytest
from dynamics_cases import REFERENCE, helical, modes
from evenload import dynamics
from evenload.dynamics import Milling, Mode, motions

pytestmark = pytest.mark.core

# ---- surface ----

SURFACE = REFERENCE["surface"]


@pytest.mark.parametrize("row", SURFACE["surface"])
def test_surface_figures_are_the_reference_s(row):
    surface = helical(row["cut"], row["aD"]).surface(row["rpm"], row["ap_mm"], 0.1)
    for name, key in (
        ("surface_location_error", "sle_um"),
        ("least", "sle_min_um"),
        ("most", "sle_max_um"),
        ("roughness", "roughness_um"),
        ("waviness", "waviness_um"),
    ):
        expected = row[key]
        tolerance = max(0.002, 1e-4 * abs(expected))
        assert 1e3 * getattr(surface, name) == pytest.approx(expected, abs=tolerance), name
    assert surface.is_stable
    profile = surface.profile([0, row["ap_mm"]], numpy.linspace(0, 0.1, 5))
    assert profile.shape == (2, 5)
    assert profile.max() <= surface.most + 1e-6


@pytest.mark.parametrize("row", SURFACE["optimal_depths"], ids=lambda row: str(row["k"]))
def test_optimal_depths_are_the_reference_s(row):
    milling = helical("down")
    depths = milling.optimal_depths(row["rpm"], 922, 13)
    assert depths.trivial == pytest.approx([12.56637])
    assert depths.non_trivial[row["j"] - 1] == pytest.approx(row["ap_mm"], rel=1e-6)
    waves = [
        1e3 * milling.surface(row["rpm"], share * row["ap_mm"], 0.1).waviness
        for share in (0.75, 1, 1.25)
    ]
    assert waves == pytest.approx(row["waviness_um"], rel=1e-3)
    assert milling.surface(row["rpm"], depths.trivial[0], 0.1).waviness < 1e-9


def test_the_map_of_surface_errors_has_the_single_ones():
    found = helical("up").surface_map([9000, 9220], [1.0, 1.5], 0.1)
    assert found.shape == (2, 2)
    assert 1e3 * found[0, 0] == pytest.approx(-13.38444, abs=0.002)
    assert 1e3 * found[1, 1] == pytest.approx(42.0466, abs=0.004)


# ---- orbits ----


def test_orbits_have_the_reference_s_folds():
    row = REFERENCE["fold"]
    milling = Milling(modes("slot"), 3, 600, 400, "conventional", 0.35)
    depths = [point["ap_mm"] for point in row["branch"]]
    orbits = milling.forced_orbits(9266.1, [*depths, 2.4], 0.2)
    assert len(orbits.folds) == 2
    for fold, expected in zip(orbits.folds, row["folds"]):
        assert fold.depth == pytest.approx(expected["ap_mm"], rel=1e-4)
        assert fold.amplitude == pytest.approx(expected["amplitude_mm"], rel=1e-4)
        assert min(abs(fold.multipliers - 1)) < 1e-4
    assert orbits.boundaries[0].depth == pytest.approx(row["first_loss_mm"], rel=1e-4)
    for point in row["branch"]:
        (found,) = orbits.at(point["ap_mm"])
        assert found.amplitude == pytest.approx(point["amplitude_mm"], rel=1e-4)
        assert found.spectral_radius == pytest.approx(point["rho"], abs=1e-5)
    assert orbits.bistable == pytest.approx((1.54391, 2.295498), rel=1e-4)
    assert len(orbits.depth) == len(orbits.amplitude) == len(orbits.is_stable)
    assert milling.critical_depth(9266.1, 5) == pytest.approx(row["linear_limit_mm"], rel=1e-4)
    deviation = motions.thickness_deviation(milling, 9266.1, 1.0, 0.2)
    assert deviation == pytest.approx(row["thickness_deviation"], rel=row["tol_deviation"])


def test_the_exact_path_of_the_tooth_before_changes_the_orbit_a_little():
    milling = Milling(modes("slot"), 3, 600, 400, "conventional", 0.35)
    plain = milling.forced_orbits(9266.1, [0.5], 0.2).at(0.5)[0]
    exact = milling.forced_orbits(9266.1, [0.5], 0.2, chip="state-dependent").at(0.5)[0]
    assert exact.amplitude != plain.amplitude
    assert exact.amplitude == pytest.approx(plain.amplitude, rel=0.05)


@pytest.mark.parametrize("row", REFERENCE["process_damping"]["milling"])
def test_the_flank_lets_go(row):
    milling = Milling(
        modes("slot"), 2, 600, 200, "conventional", 0.25, process_damping=4e5, flank_friction=0.3
    )
    orbits = milling.forced_orbits(row["rpm"], [row["ap_mm"]], 0.05, chip="circular")
    (found,) = orbits.at(row["ap_mm"])
    assert found.spectral_radius == pytest.approx(row["rho"], rel=2e-3)
    assert 1e3 * found.amplitude == pytest.approx(row["amplitude_um"], rel=2e-4)
    linear = milling.spectral_radius(row["rpm"], row["ap_mm"])
    assert linear == pytest.approx(row["rho_linear"], abs=1e-4)


# ---- turning ----


@pytest.mark.parametrize("row", REFERENCE["interrupted_turning"]["points"])
def test_speeds_of_interrupted_turning_are_the_reference_s(row):
    speeds = dynamics.interrupted_turning_speeds(
        5, 1200, row["xi"], row["eps_enter"], row["eps_exit"]
    )
    assert speeds[row["j"] - 1] == pytest.approx(60 * row["v_opt_m_s"], rel=1e-6)
    assert len(speeds) == 5 and speeds == sorted(speeds, reverse=True)


@pytest.mark.parametrize("row", REFERENCE["process_damping"]["turning"])
def test_limits_of_turning_are_the_reference_s(row):
    for key, order in (("None", None), ("1", 1), ("2", 2), ("exact", "exact")):
        found = dynamics.turning_limit(
            Mode(0.5, 200, 0.03), row["rpm"], 50, 1000, 1.5e4, 0.05, order
        )
        assert found == pytest.approx((row[key][0] / 1e3, row[key][1]), rel=1e-5)
