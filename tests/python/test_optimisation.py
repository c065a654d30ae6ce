"""evenload.optimise: its figures against whole simulations, its order, its limits, its refusals."""

import dataclasses
import inspect
import math
import threading
from types import SimpleNamespace

import evenload
import numpy
import pytest
from evenload import compiled, machines, materials, optimisation, planar
from evenload.dynamics import Milling, vibration
from evenload.optimisation import inputs, scaled_path

core = compiled.core()
SIX = {
    "diameter": 6,
    "teeth": 2,
    "cutting_length": 12,
    "max_chip_thickness": 0.04,
    "surface_speed": (100, 150),
}
TEN = {
    **SIX,
    "diameter": 10,
    "teeth": 3,
    "cutting_length": 20,
    "max_chip_thickness": 0.06,
    "surface_speed": (100, 200),
}
BOX = (0, 0, 32, 24)
ROUND = [(-15, 0, 1.0), (15, 0, 1.0)]
METAL = "Al7075-T6"
FEW = {"depth": 6, "engagement_deg": (50, 80), "axial_depths": (6, 2.5), "spindle_speeds": (6000,)}
OPTIONS = inspect.signature(optimisation.optimise).parameters


def optimised(region=BOX, tools=(SIX,), material=METAL, machine=None, **options):
    return evenload.optimise(region, list(tools), material, machine, **{**FEW, **options})


def task_of(region=BOX, tools=(SIX,), **options):
    given = {name: parameter.default for name, parameter in OPTIONS.items()}
    given.update(FEW, region=region, tools=list(tools), materials=METAL, **options)
    return inputs.checked(core, **given)


def generated(candidate, region, control="constant feed", **options):
    """The core's own path for a candidate, as an operation with its settings computes it."""
    diameter, feed = candidate.diameter, candidate.feed
    return core.clear_pocket(
        [core.Region(region)],
        tool_diameter=diameter,
        engagement_angle=math.radians(candidate.engagement_deg),
        feed_control=control,
        feed=feed,
        plunge_feed=0.5 * feed,
        link_feed=options.pop("link_feed", 5000.0),
        maximum_feed=2 * feed,
        roll_radius=0.15 * diameter,
        minimum_radius=0.15 * diameter,
        helix_diameter=0.9 * diameter,
        levels=[-candidate.axial_depth * (k + 1) for k in range(candidate.levels)],
        safe_height=scaled_path.SAFE,
        clearance_height=scaled_path.CLEARANCE,
        **options,
    )


def simulated(candidate, region, path, machine=None, **options):
    """The simulator's run of a whole path, at its own resolution."""
    return evenload.simulate(
        path,
        core.Region(region),
        0,
        -candidate.axial_depth * candidate.levels,
        candidate.diameter,
        candidate.teeth,
        cutting={"material": METAL, "spindle_speed": candidate.spindle_speed},
        machine=machine,
        **options,
    )


def worst(run, values):
    """The largest mean over 0.1 mm of cuts and entries, piece by piece of the path."""
    result, window = 0.0, []
    for i in range(1, len(values)):
        if run.kind[i] != run.kind[i - 1] or run.kind[i] < planar.ENTRY:
            window = []
            continue
        window.append((run.length[i], 0.5 * (values[i] + values[i - 1])))
        while len(window) > 1 and sum(length for length, _ in window[1:]) >= 0.1:
            window.pop(0)
        length = sum(length for length, _ in window)
        area = sum(length * mean for length, mean in window)
        area -= max(0.0, length - 0.1) * window[0][1]
        result = max(result, area / 0.1)
    return result


def chain(box):
    x0, y0, x1, y1 = box
    return [(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)]


# ---- the figures are true ----


@pytest.mark.core
@pytest.mark.parametrize("control", inputs.FEED_CONTROLS)
@pytest.mark.parametrize("machine", [None, "hobby_router_grbl"])
def test_time_force_torque_power_and_chips_are_those_of_a_whole_simulation(control, machine):
    options = {"feed_control": control, "spindle_speeds": (7900,), "link_feed": 5000}
    tool = {**SIX, "surface_speed": (100, 200)}
    profile = machine and {
        "max_feed_mm_min": 5000,
        "acceleration_mm_s2": 400,
        "junction_deviation_mm": 0.01,
        "rapid_feed_mm_min": 5000,
    }
    found = optimised(tools=[tool], machine=profile, **options)
    assert len(found.candidates) == 4 and not any(c.refused for c in found.candidates)
    for candidate in found.candidates:
        path = generated(candidate, chain(BOX), control)
        run = simulated(candidate, chain(BOX), path, profile)
        assert candidate.time_s == pytest.approx(run.time_total_s, rel=0.01)
        if machine:
            assert candidate.machine_time_s == pytest.approx(run.machine_time_total_s, rel=0.02)
        assert candidate.force_peak_n == pytest.approx(worst(run, run.force_peak), rel=0.02)
        assert candidate.torque_peak_nm == pytest.approx(worst(run, run.torque_peak), rel=0.02)
        assert candidate.power_w == pytest.approx(worst(run, run.power_mean), rel=0.02)
        assert candidate.h_max_mm == pytest.approx(worst(run, run.h_max), rel=0.02)
        assert candidate.left_area_mm2 == pytest.approx(run.stock.area, abs=0.1)
        assert candidate.ratio == pytest.approx(
            path.report.cutting_time / path.report.ideal_time, rel=0.01
        )


def test_in_a_round_pocket_the_force_is_the_simulator_s_own_peak():
    (candidate,) = optimised(ROUND, engagement_deg=60, axial_depths=(6,)).candidates
    run = simulated(candidate, ROUND, generated(candidate, ROUND))
    assert candidate.force_peak_n == pytest.approx(run.force_peak_max, rel=0.02)


@pytest.mark.parametrize("region", [chain(BOX), ROUND])
@pytest.mark.parametrize("levels", [1, 2, 5])
def test_levels_put_together_are_the_core_s_own_moves(region, levels):
    height = 6 / levels
    task = task_of(region)
    path = scaled_path.ScaledPath(
        core, task.regions, task.tools[0], 60, {height}, task, lambda share: True
    )
    candidate = SimpleNamespace(
        diameter=6.0, feed=path.feed, engagement_deg=60, axial_depth=height, levels=levels
    )
    expected = generated(candidate, region, link_feed=task.link_feed).moves
    moves = path.moves(height, levels, path.feed)
    assert len(moves) == len(expected)
    assert numpy.allclose(moves, numpy.array(expected), rtol=0, atol=1e-9)


def test_two_rooms_are_cleared_one_after_the_other_at_all_levels():
    rooms = [chain(BOX), [(x + 50, y, b) for x, y, b in chain(BOX)]]
    task = task_of(rooms)
    path = scaled_path.ScaledPath(
        core, task.regions, task.tools[0], 60, {3.0, 1.5}, task, lambda share: True
    )
    moves = path.moves(1.5, 4, path.feed)
    first, second = moves[moves[:, 1] < 40], moves[moves[:, 1] > 40]
    assert first[:, 3].min() == second[:, 3].min() == -6
    assert (numpy.diff(moves[:, 1] > 40) != 0).sum() == 1
    both = optimised(rooms, engagement_deg=60).candidates[0]
    one = optimised(rooms[0], engagement_deg=60).candidates[0]
    assert both.time_s == pytest.approx(2 * one.time_s, rel=0.01)


def test_the_times_are_those_of_the_moves():
    task = task_of()
    path = scaled_path.ScaledPath(
        core, task.regions, task.tools[0], 60, {0.5}, task, lambda share: True
    )
    profile = core.MachineProfile(**machines.load("machining_centre"))
    programmed, machine = path.times(0.5, 12, 800.0, profile)
    moves = scaled_path._listed(path.moves(0.5, 12, 800.0))
    assert programmed == pytest.approx(core.programmed_time(moves, task.rapid_feed), rel=1e-9)
    assert programmed < machine == pytest.approx(sum(core.machine_time(moves, profile)[-1][:2]))


# ---- the best, and the order ----


def test_the_best_is_the_fastest_within_the_limits():
    found = optimised(tools=[SIX, TEN], spindle_speeds=None, max_force=150)
    allowed = [c for c in found.candidates if not c.refused]
    assert found.best is found.ranked()[0] and found.best in allowed
    assert found.best.time_s == min(c.time_s for c in allowed)
    assert len(found.candidates) == 2 * 2 * 2 * inputs.SPEEDS
    assert found.best.tool in found.table().splitlines()[1]


def test_with_a_machine_its_times_decide():
    slow = {"max_feed_mm_min": 6000, "acceleration_mm_s2": 20}
    found = optimised(tools=[SIX, TEN], machine=slow)
    assert all(c.machine_time_s > c.time_s for c in found.candidates)
    assert found.best.machine_time_s == min(c.machine_time_s for c in found.candidates)


def test_threads_find_bit_by_bit_what_one_alone_finds():
    options = dict(tools=[SIX, TEN], spindle_speeds=None, max_force=150)
    one, many = optimised(workers=1, **options), optimised(workers=4, **options)
    assert [dataclasses.astuple(c) for c in one.candidates] == [
        dataclasses.astuple(c) for c in many.candidates
    ]


def test_candidates_come_in_the_order_of_tools_angles_levels_and_speeds():
    found = optimised(tools=[TEN, SIX], engagement_deg=(80, 50), spindle_speeds=(4500, 4000))
    order = [(c.diameter, c.engagement_deg, c.levels, c.spindle_speed) for c in found.candidates]
    assert order == [
        (d, a, n, s) for d in (10, 6) for a in (80, 50) for n in (1, 3) for s in (4500, 4000)
    ]


# ---- limits ----


@pytest.mark.parametrize(
    "limit, share", [("max_force", 0.9), ("max_torque", 0.85), ("max_power", 0.8)]
)
def test_a_limit_lowers_the_feed_to_just_within_it(limit, share):
    figure = {"max_force": "force_peak_n", "max_torque": "torque_peak_nm", "max_power": "power_w"}
    (free,) = optimised(engagement_deg=60, axial_depths=6).candidates
    allowed = share * getattr(free, figure[limit])
    (held,) = optimised(engagement_deg=60, axial_depths=6, **{limit: allowed}).candidates
    assert free.bound_by == "chip thickness" and held.bound_by == limit[4:]
    assert free.h_max_mm == pytest.approx(SIX["max_chip_thickness"])
    assert 0.995 * allowed <= getattr(held, figure[limit]) <= allowed * (1 + 1e-9)
    assert held.feed < free.feed and held.time_s > free.time_s and not held.refused


def test_a_material_of_each_tool_s_own_changes_its_force_alone():
    hard = {"ktc": 3000, "krc": 1200, "kte": 20, "kre": 20}
    found = optimised(tools=[SIX, SIX], material=[METAL, hard])
    soft, firm = found.candidates[:4], found.candidates[4:]
    assert all(b.force_peak_n > 2 * a.force_peak_n for a, b in zip(soft, firm))
    assert [a.time_s for a in soft] == [b.time_s for b in firm]


def test_the_machine_s_feed_spindle_speed_and_power_are_limits():
    machine = {"max_feed_mm_min": 300, "acceleration_mm_s2": 500, "spindle_speed_rev_min": 7000}
    found = optimised(machine=machine, spindle_speeds=(6000, 7500))
    assert {c.bound_by for c in found.candidates if not c.refused} == {"machine feed"}
    assert all(c.feed == pytest.approx(300) for c in found.candidates if not c.refused)
    fast = [c for c in found.candidates if c.spindle_speed == 7500]
    assert fast and all(c.refused_by == "spindle speed" for c in fast)
    machine.update(max_feed_mm_min=9000, spindle_power_w=50)
    found = optimised(machine=machine)
    assert {c.bound_by for c in found.candidates} == {"power", "chip thickness"}
    assert all(c.refused or c.power_w <= 50 * (1 + 1e-9) for c in found.candidates)


def test_at_a_constant_removal_rate_no_feed_passes_the_machine_s():
    machine = {"max_feed_mm_min": 500, "acceleration_mm_s2": 500}
    found = optimised(machine=machine, feed_control="constant removal rate", engagement_deg=60)
    for candidate in found.candidates:
        assert candidate.bound_by == "machine feed" and candidate.feed < 500


def test_where_no_candidate_is_allowed_the_answer_says_which_limit_refuses_most():
    found = optimised(max_force=5)
    assert found.best is None and not found.ranked()
    assert found.why.startswith(
        "No candidate is within the limits: the force refuses most, 4 of 4, as in: At the least "
        "chip of 0.008 mm the force of the tool of 6 mm at 50°, 6 mm deep, is above 5 N."
    )
    assert found.why in found.table()
    assert all(c.force_peak_n > 5 and c.feed_per_tooth for c in found.candidates)


def test_at_a_feed_that_is_given_the_figures_are_its_own():
    options = {"engagement_deg": 60, "axial_depths": 6}
    (free,) = optimised(**options).candidates
    (same,) = optimised(feed=free.feed, **options).candidates
    assert same.bound_by == "" and not same.refused
    for name in ("feed_per_tooth", "time_s", "force_peak_n", "power_w", "h_max_mm"):
        assert getattr(same, name) == pytest.approx(getattr(free, name), rel=1e-9), name
    (slow,) = optimised(feed=0.5 * free.feed, **options).candidates
    assert slow.h_max_mm == pytest.approx(0.5 * free.h_max_mm) and slow.time_s > free.time_s
    (fast,) = optimised(feed=2 * free.feed, **options).candidates
    assert fast.h_max_mm == pytest.approx(2 * free.h_max_mm) and fast.time_s < free.time_s
    assert fast.refused_by == "chip thickness"
    assert fast.refused == (
        "At %.5g mm/min the tools' chip thickness of the tool of 6 mm at 60°, 6 mm deep, is above "
        "0.04 mm." % (2 * free.feed)
    )
    (heavy,) = optimised(feed=free.feed, max_force=0.9 * free.force_peak_n, **options).candidates
    assert heavy.refused_by == "force" and heavy.force_peak_n == pytest.approx(free.force_peak_n)


def test_a_depth_beyond_the_cutting_length_is_refused():
    found = optimised(depth=14, axial_depths=(14, 7))
    deep = [c for c in found.candidates if c.levels == 1]
    assert deep and all(
        c.refused == "14 mm is deeper than the cutting length of 6 mm, z 2, 12 mm." for c in deep
    )
    assert found.best.levels == 2


def test_what_a_tool_leaves_can_be_limited():
    found = optimised(tools=[SIX, TEN], axial_depths=6, engagement_deg=60)
    small, large = found.candidates
    corners = [(4 - math.pi) * radius**2 for radius in (3.0, 5.0)]
    assert [small.left_area_mm2, large.left_area_mm2] == pytest.approx(corners, abs=0.35)
    limited = optimised(tools=[SIX, TEN], axial_depths=6, engagement_deg=60, max_left_area=12)
    assert [c.refused_by for c in limited.candidates] == ["", "left area"]


def test_a_tool_that_does_not_fit_is_refused_and_no_tool_that_fits_is_an_error():
    slot = (0, 0, 40, 8)
    found = optimised(slot, tools=[TEN, SIX])
    assert {c.refused_by for c in found.candidates if c.diameter == 10} == {"tool size"}
    assert found.best.diameter == 6
    with pytest.raises(ValueError, match="10 mm does not fit .* the largest tool that fits"):
        optimised(slot, tools=[TEN])


def test_a_hole_saves_the_helix():
    hole = (16, 12, 10)
    bare = optimised(engagement_deg=60, axial_depths=6).candidates[0]
    drilled = optimised(engagement_deg=60, axial_depths=6, hole=hole).candidates[0]
    assert drilled.time_s < bare.time_s - 5


def test_where_nothing_is_left_to_cut_an_error_says_so():
    with pytest.raises(ValueError, match="6 mm touches no material: check the region and the"):
        optimised([(-5, 0, 1.0), (5, 0, 1.0)], hole=(0, 0, 12))


def test_a_pocket_that_the_helix_clears_alone_has_loads_of_the_helix():
    found = optimised([(-3.6, 0, 1.0), (3.6, 0, 1.0)], engagement_deg=60)
    assert all(c.force_peak_n > 0 and c.h_max_mm > 0 and c.time_s > 0 for c in found.candidates)


# ---- progress ----


def test_progress_rises_to_one_in_the_calling_thread():
    shares, threads = [], set()

    def watch(share):
        shares.append(share)
        threads.add(threading.current_thread())
        return True

    optimised(progress=watch)
    assert shares == sorted(shares) and shares[-1] == pytest.approx(1.0)
    assert threads == {threading.main_thread()}


def test_cancelling_returns_what_is_ready():
    calls = []
    found = optimised(workers=1, progress=lambda share: calls.append(share) or share < 0.5)
    assert found.cancelled and len(found.candidates) == 2
    assert found.best in found.candidates
    assert optimised(progress=lambda share: False).candidates == []


def test_an_error_in_progress_stops_the_work_and_comes_through():
    def fail(share):
        raise RuntimeError("closed")

    with pytest.raises(RuntimeError, match="closed"):
        optimised(progress=fail)


# ---- inputs ----


def test_an_operation_brings_its_region_its_depth_and_its_hole():
    last = SimpleNamespace(regions=[core.Region(chain(BOX))], cuts=[None], hole=(16, 12, 10))
    operation = SimpleNamespace(
        Proxy=SimpleNamespace(last=last),
        Label="Pocket",
        StartDepth=SimpleNamespace(Value=2.0),
        FinalDepth=SimpleNamespace(Value=-4.0),
    )
    found = optimised(operation, depth=None)
    same = optimised(hole=(16, 12, 10))
    assert [c.time_s for c in found.candidates] == [c.time_s for c in same.candidates]
    last.cuts = [None, None]
    with pytest.raises(ValueError, match="'Pocket' lie at several depths"):
        optimised(operation)
    operation.Proxy.last = None
    with pytest.raises(ValueError, match="'Pocket' has not been computed: recompute"):
        optimised(operation)


def test_without_a_depth_the_shortest_cutting_length_is_taken_and_noted():
    found = optimised(tools=[TEN, SIX], depth=None, axial_depths=None, engagement_deg=60)
    assert found.notes == ["The pocket was taken as 12 mm deep, the shortest cutting length."]
    assert {c.levels * c.axial_depth for c in found.candidates} == {12.0}


def test_speeds_span_what_tool_and_machine_allow():
    machine = {"max_feed_mm_min": 9000, "acceleration_mm_s2": 500, "spindle_speed_rev_min": 7000}
    found = optimised(machine=machine, spindle_speeds=None, engagement_deg=60, axial_depths=6)
    speeds = [c.spindle_speed for c in found.candidates]
    assert speeds[0] == pytest.approx(100e3 / (6 * math.pi)) and speeds[-1] == 7000
    assert numpy.diff(speeds) == pytest.approx([(7000 - speeds[0]) / 4] * 4)


@pytest.mark.parametrize(
    "changes, sentence",
    [
        ({"tools": []}, "tools must be a list of at least one tool, not []."),
        ({"tools": [7]}, "Tool 1 is 7: give a dictionary."),
        ({"tools": [{**SIX, "flutes": 2}]}, "Tool 1 has the unknown key 'flutes': its keys are "),
        ({"tools": [{"diameter": 6}]}, "Tool 1 has no teeth: give it one."),
        ({"tools": [SIX, {"diameter": 6, "teeth": 2}]}, "Tool 2 has no cutting_length: give it "),
        ({"tools": [{**SIX, "diameter": math.nan}]}, "diameter of tool 1 must be a number above"),
        ({"tools": [{**SIX, "teeth": 1.5}]}, "teeth of tool 1 must be a whole number above 0"),
        ({"tools": [{**SIX, "surface_speed": (9, 2)}]}, "surface_speed of tool 1 must be m/min"),
        ({"feed": 0}, "feed must be a number above 0, not 0"),
        ({"tools": [{**SIX, "min_chip_thickness": 1}]}, "is above its max_chip_thickness."),
        ({"tools": [{**SIX, "helix_angle_deg": 90}]}, "helix_angle_deg of tool 1 must be 0 or"),
        ({"material": [METAL, METAL]}, "There are 2 materials for 1 tools: give one for all,"),
        ({"material": "oak"}, "There is no material 'oak': choose one of "),
        ({"machine": "lathe"}, "There is no machine 'lathe': choose one of "),
        ({"depth": math.inf}, "depth must be a number above 0, not inf."),
        ({"engagement_deg": ()}, "engagement_deg is empty: give at least one number."),
        ({"engagement_deg": (60, 180)}, "engagement_deg must be below 180, not 180."),
        ({"axial_depths": (1, math.nan)}, "axial_depths must be a number above 0, not nan."),
        ({"spindle_speeds": "fast"}, "spindle_speeds must be a number above 0, not 'f'."),
        ({"max_force": 0}, "max_force must be a number above 0, not 0."),
        ({"max_power": math.nan}, "max_power must be a number above 0, not nan."),
        ({"hole": (0, 0)}, "hole must be (x, y, diameter) in mm, not (0, 0)."),
        ({"maximum_feed": 0.5}, "maximum_feed is a share of the feed: 1 or more, not 0.5."),
        ({"feed_control": "constant force"}, "feed_control must be one of 'constant feed', "),
        ({"cut_mode": "up"}, "cut_mode must be one of 'climb', 'conventional', not 'up'."),
        ({"workers": 0}, "workers must be a whole number of 1 or more, not 0."),
        ({"region": (chain(BOX), 3)}, "The region has a height: give it without, and its depth"),
        ({"region": "pocket"}, "The region is 'pocket': give a Region, a box "),
    ],
)
def test_what_cannot_be_used_is_refused_with_a_sentence(changes, sentence):
    with pytest.raises(ValueError) as caught:
        optimised(**changes)
    assert sentence in str(caught.value)
    assert str(caught.value).endswith(".") and "\n" not in str(caught.value)


def test_a_speed_that_no_tool_may_turn_at_refuses_all():
    found = optimised(spindle_speeds=(20000,))
    assert found.best is None and "the spindle speed refuses most, 4 of 4" in found.why


# ---- the core's part ----


def test_peaks_are_those_of_each_sample_s_force():
    edge = core.ForceCoefficients(600, 200, 15, 12)
    model = core.ForceModel(edge, 3.0, 2, 0.5)
    arcs = numpy.array([(-1.5, -0.5, 3.0), (-1.5, -1.0, 2.0), (0.2, 0.6, 2.0)])
    force, torque = model.peaks(arcs, [0, 1, 1, 3], [0.05, 0.05, 0.03])
    for i, (first, last, feed) in enumerate([(0, 1, 0.05), (1, 1, 0.05), (1, 3, 0.03)]):
        alone = model.force([tuple(arc) for arc in arcs[first:last]], feed, 6000)
        assert (force[i], torque[i]) == (alone.peak_xy, alone.peak_torque)
    assert force[1] == 0 < force[2]
    for first in ([0, 1, 3], [0, 2, 1, 3], [0, 1, 1, 4], [-1, 1, 1, 3]):
        with pytest.raises(ValueError, match="first_arc"):
            model.peaks(arcs, first, [0.05, 0.05, 0.03])


# ---- chatter ----

WEAK = [
    {"stiffness_n_per_um": 12, "frequency_hz": 800, "damping_ratio": 0.02},
    {"stiffness_n_per_um": 15, "frequency_hz": 1100, "damping_ratio": 0.02, "direction_deg": 90},
]
SPEEDS = (5400, 6100, 6800, 7500)
SIX_METAL = materials.load(METAL)


def test_what_chatters_in_a_direction_of_its_path_is_refused():
    free = optimised(spindle_speeds=SPEEDS)
    held = optimised(spindle_speeds=SPEEDS, modes=WEAK)
    refused = [c for c in held.candidates if c.refused_by == "chatter"]
    assert 0 < len(refused) < len(held.candidates)
    modes = vibration.load(WEAK).modes
    for before, after in zip(free.candidates, held.candidates):
        milling = Milling(
            modes,
            *(2, *(SIX_METAL[key] for key in ("ktc", "krc"))),
            engagement_angle=after.engagement_deg,
            diameter=6,
            helix_angle=30,
        )
        worst, _ = milling.worst_spectral_radius(after.spindle_speed, after.axial_depth)
        assert (worst >= 0.95) == (after.refused_by == "chatter")
        if after.refused:
            assert after.spectral_radius >= 0.95 and after.force_peak_n is None
            assert "chatters" in after.refused and after.refused.endswith(".")
        else:
            assert after.spectral_radius == pytest.approx(worst, rel=1e-6)
            assert dataclasses.replace(after, spectral_radius=None) == before
    assert "%d refused by chatter" % len(refused) in held.table()
    assert held.best.spectral_radius < 0.95


def test_a_tool_s_own_modes_go_before_those_of_all():
    stiff = [{**row, "stiffness_n_per_um": 1000} for row in WEAK]
    own = optimised(tools=({**SIX, "modes": stiff},), spindle_speeds=SPEEDS, modes=WEAK)
    assert not [c for c in own.candidates if c.refused_by == "chatter"]
    assert all(c.spectral_radius < 0.95 for c in own.candidates if not c.refused)


def test_where_all_chatters_it_says_so():
    soft = [{**WEAK[0], "stiffness_n_per_um": 0.05}]
    found = optimised(spindle_speeds=(6100,), modes=soft)
    assert found.best is None and "chatter refuses most" in found.why


def test_an_optimisation_is_cancelled_while_it_looks_for_chatter():
    asked = []

    def progress(_):
        asked.append(1)
        return False

    assert optimised(modes=WEAK, progress=progress).cancelled and asked


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"modes": []}, "modes of tool 1: .* has no mode"),
        ({"modes": [{**WEAK[0], "damping_ratio": -1}]}, "modes of tool 1: .*damping"),
        ({"modes": WEAK, "stability_margin": 1}, "stability_margin must be 0 or more and below 1"),
        ({"modes": WEAK, "stability_margin": "no"}, "not 'no'"),
    ],
)
def test_modes_and_margins_that_cannot_be_are_refused(options, sentence):
    with pytest.raises(ValueError, match=sentence):
        optimised(**options)
