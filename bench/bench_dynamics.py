# Milling dynamics: errors against the values of an independent computation
# (tests/dynamics_reference.json), what charts cost, and the classical semi-discretisation, a
# product of matrices on a full grid, beside them at the same error.
import sys
import time
from pathlib import Path

import numpy
from evenload import dynamics
from evenload.dynamics import beams, charts, motions
from timing import best_time

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))
import dynamics_cases  # noqa: E402
import semi_discretisation  # noqa: E402
from dynamics_cases import REFERENCE, case, helical  # noqa: E402

ACCURATE, CHART = 1e-6, 1e-3
FULL = 512  # nodes per side that a chart equals


def stability():
    rows = REFERENCE["stability"]["multipliers"]
    for name, accuracy in (("accurate", ACCURATE), ("chart", CHART)):
        errors = [
            abs(case(r["case"]).spectral_radius(r["rpm"], r["ap_mm"], accuracy) - r["rho"])
            for r in rows
        ]
        yield "dynamics.multipliers.error_%s" % name, max(errors), ""
    errors = [
        abs(case(r["case"]).critical_depth(n, 10) / a - 1)
        for r in REFERENCE["stability"]["critical_depths"]
        for n, a in zip(r["rpm"], r["ap_mm"])
    ]
    yield "dynamics.critical_depths.error", 100 * max(errors), "%"
    rows = REFERENCE["stability"]["crossings"]
    errors = [
        abs(case("islands").spectral_radius(r["rpm"], a, ACCURATE) - 1)
        for r in rows
        for a in r["ap_mm"]
    ]
    yield "dynamics.islands.radius_less_1_at_crossings", max(errors), ""
    rows = REFERENCE["frequency_domain"]["emfs"]
    errors = [
        abs(charts.limit(case(r["case"]), r["rpm"], a, f, k)[0] / a - 1)
        for r in rows
        for k, a, f in list(zip(r["K"], r["ap_mm_K"], r["chatter_Hz_K"]))[:3]
    ]
    yield "dynamics.multi_frequency.error", max(errors), ""
    errors = [
        abs(found[0] / a - 1)
        for r in REFERENCE["frequency_domain"]["zeroth_order"]
        for found, a in zip(charts.zeroth_order(case(r["case"]), r["chatter_Hz"]), r["ap_mm"])
    ]
    yield "dynamics.zeroth_order.error", max(errors), ""


def surfaces():
    errors = {"surface_location_error": [], "roughness": [], "waviness": []}
    keys = ("sle_um", "roughness_um", "waviness_um")
    for row in REFERENCE["surface"]["surface"]:
        found = helical(row["cut"]).surface(row["rpm"], row["ap_mm"], 0.1)
        for (name, into), key in zip(errors.items(), keys):
            into.append(abs(1e3 * getattr(found, name) - row[key]))
    for name, into in errors.items():
        yield "dynamics.surface.%s_error" % name, max(into), "um"
    trivial = helical("down").surface(9220, helical("down").helix_pitch / 2, 0.1)
    yield "dynamics.surface.trivial_waviness", 1e3 * trivial.waviness, "um"
    speeds, depths = numpy.linspace(5000, 15000, 100), numpy.linspace(0.1, 6, 60)
    grid = best_time(lambda: helical("up").surface_map(speeds, depths, 0.1, threads=1), 3)
    yield "dynamics.surface.map_100_60", grid, "s"


def motions_and_more():
    errors = []
    for row in REFERENCE["process_damping"]["turning"]:
        for key, order in (("None", None), ("1", 1), ("2", 2), ("exact", "exact")):
            mode = dynamics.Mode(0.5, 200, 0.03)
            found = dynamics.turning_limit(mode, row["rpm"], 50, 1000, 1.5e4, 0.05, order)
            errors.append(abs(1e3 * found[0] / row[key][0] - 1))
    yield "dynamics.turning.limit_error", max(errors), ""
    errors = []
    for row in REFERENCE["process_damping"]["milling"]:
        milling = dynamics.Milling(
            dynamics_cases.modes("slot"),
            2,
            600,
            200,
            "conventional",
            0.25,
            process_damping=4e5,
            flank_friction=0.3,
        )
        orbit = milling.forced_orbits(row["rpm"], [row["ap_mm"]], 0.05, chip="circular")
        errors.append(abs(orbit.at(row["ap_mm"])[0].spectral_radius / row["rho"] - 1))
    yield "dynamics.flank.radius_error", 100 * max(errors), "%"
    errors = [
        abs(
            dynamics.interrupted_turning_speeds(5, 1200, r["xi"], r["eps_enter"], r["eps_exit"])[0]
            / (60 * r["v_opt_m_s"])
            - 1
        )
        for r in REFERENCE["interrupted_turning"]["points"]
    ]
    yield "dynamics.interrupted_turning.error", max(errors), ""
    modes = dynamics_cases.modes("slot")
    milling = dynamics.Milling(modes, 3, 600, 400, "conventional", 0.35)
    folds = milling.forced_orbits(9266.1, [0.1, 2.4], 0.2).folds
    rows = REFERENCE["fold"]["folds"]
    errors = [abs(fold.depth / row["ap_mm"] - 1) for fold, row in zip(folds, rows)]
    yield "dynamics.folds.depth_error", 100 * max(errors), "%"
    yield "dynamics.folds.multiplier_less_1", max(min(abs(f.multipliers - 1)) for f in folds), ""
    deviation = motions.thickness_deviation(milling, 9266.1, 1.0, 0.2)
    yield "dynamics.folds.thickness_deviation", deviation, ""
    material, slender = (580, 14450, 0.22), REFERENCE["slender_tool"]
    found = beams.clamped_frequencies([(60, 10)], material)[:3]
    errors = [abs(f / expected - 1) for f, expected in zip(found, slender["timoshenko"])]
    yield "dynamics.slender.frequency_error", max(errors), ""
    holder = [dynamics.Mode.from_stiffness(20, 900, 0.03)]
    tip = dynamics.couple(holder, [(60, 10)], (*material, 0.003), frequencies=[1000, 2300])
    errors = [abs(1e6 * tip.at(f) / complex(*slender["modal_%dHz" % f]) - 1) for f in (1000, 2300)]
    yield "dynamics.slender.receptance_error", max(errors), ""
    lines = numpy.arange(1.0, 2001.0)
    coupling = best_time(lambda: dynamics.couple(holder, [(60, 10)], material, frequencies=lines))
    yield "dynamics.slender.tip_2000_lines", coupling, "s"


def fits():
    modes = [dynamics.Mode(0.3, 620, 0.031), dynamics.Mode(0.08, 940, 0.018)]
    frf = dynamics.Frf.of_modes(modes, numpy.arange(100.0, 2000.0))
    random = numpy.random.default_rng(1)
    noise = random.normal(size=(2, frf.xx.size))
    frf.xx = frf.xx * (1 + 0.02 * (noise[0] + 1j * noise[1]))
    for name in ("frequency", "damping_ratio", "stiffness"):
        errors = [
            abs(getattr(found, name) / getattr(mode, name) - 1)
            for found, mode in zip(frf.fit(2), modes)
        ]
        yield "dynamics.fit.%s_error" % name, 100 * max(errors), "%"


def times():
    for name, milling in (("one_mode", case("half_down")), ("two_modes_helix", case("even"))):
        speeds = numpy.linspace(5000, 20000, 40)
        start = [time.process_time()]
        for speed in speeds:
            for depth in (0.3, 0.6, 0.9, 1.2, 1.5):
                milling.spectral_radius(speed, depth)
        seconds = (time.process_time() - start[0]) / (5 * len(speeds))
        yield "dynamics.%s.multiplier" % name, 1e3 * seconds, "ms"
        box = ((5000, 25000, 64), (0.1, 5, 32))
        first = next(milling.chart_levels(*box, threads=1))
        yield "dynamics.%s.first_picture" % name, first.seconds, "s"
        one = milling.chart(*box, threads=1)
        two = milling.chart(*box, threads=2)
        yield "dynamics.%s.chart" % name, one.seconds, "s"
        yield "dynamics.%s.chart_evaluations" % name, one.evaluations, ""
        yield "dynamics.%s.two_threads_faster" % name, one.seconds / two.seconds, "times"
        brute = (FULL + 1) ** 2 / one.evaluations
        yield "dynamics.%s.brute_force_evaluations" % name, brute, "times"
    yield from peer()


def peer():
    """The classical way at the error that ours has: time for one, and for a full grid."""
    row = REFERENCE["stability"]["multipliers"][1]
    milling = case(row["case"])
    start = time.process_time()
    for _ in range(50):
        ours = milling.spectral_radius(row["rpm"], row["ap_mm"], 1e-2)
    our_time = (time.process_time() - start) / 50
    our_error = abs(ours - row["rho"])
    steps, error, seconds = semi_discretisation.as_accurate(milling, row, max(our_error, 1e-3))
    yield "dynamics.peer.our_error", our_error, ""
    yield "dynamics.peer.error", error, ""
    yield "dynamics.peer.steps", steps, ""
    yield "dynamics.peer.multiplier_slower", seconds / our_time, "times"
    chart = milling.chart((5000, 25000), (0.1, 5), threads=1)
    yield "dynamics.peer.chart_slower", seconds * (FULL + 1) ** 2 / chart.seconds, "times"


def bisection():
    import test_dynamics_bisection as sets

    for name, row in sets.SETS.items():
        found = dynamics.mdbm(
            sets.FUNCTIONS[name], row["axes"], row["halvings"], dimension=row["D_F"]
        )
        word = name.replace(", ", "_").replace(" ", "_").lower()
        yield "dynamics.mdbm.%s.components" % word, found.components, ""
        yield "dynamics.mdbm.%s.evaluations" % word, found.evaluations, ""
        over = found.evaluations / row["evaluations"][-1]
        yield "dynamics.mdbm.%s.over_reference" % word, over, "times"
        yield "dynamics.mdbm.%s.efficiency" % word, found.efficiency, ""
        yield "dynamics.mdbm.%s.brute_force" % word, found.brute_force, ""


def figures():
    for part in (stability, surfaces, motions_and_more, fits, bisection, times):
        yield from part()
