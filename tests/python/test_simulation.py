"""evenload.simulate: what its arrays and figures mean."""

import json
import math

import numpy
import pytest
from evenload import machines
from simulated_paths import BELOW, CUT, DEPTH, ENTRY, FEED, GOUGED, LINK, RADIUS, RAPID, SPEED, STAR
from simulated_paths import UP
from simulated_paths import climb, line_at, middle, same_load, simulated, spiral, written

# ---- the record ----


def test_all_arrays_have_one_length():
    run = simulated(climb(60), BELOW, cutting=STAR, machine="linuxcnc_mill")
    size = len(run.x)
    arrays = {k: v for k, v in vars(run).items() if isinstance(v, numpy.ndarray)}
    assert len(arrays) == 27
    assert arrays.pop("arcs").shape == (run.first_arc[-1], 3)
    assert arrays.pop("first_arc").shape == (size + 1,)
    assert {v.shape for v in arrays.values()} == {(size,)}
    assert not any(numpy.isnan(v).any() for v in arrays.values())
    assert run.length[abs(run.x) < 30].max() <= 0.1 + 1e-9  # beside the stock it is one step
    assert len(simulated(climb(60), BELOW, step=1.0).x) < size / 3


def test_samples_lie_along_the_path_from_each_move_s_start_to_its_end():
    run = simulated(climb(60), BELOW)
    for number, before, to in ((1, climb(60)[0], climb(60)[1]), (2, *climb(60)[1:])):
        own = run.move == number
        places = numpy.stack([run.x, run.y, run.z], axis=1)[own]
        assert places[0] == pytest.approx(before[1:4]) and places[-1] == pytest.approx(to[1:4])
        assert run.length[own][0] == 0
        steps = numpy.linalg.norm(numpy.diff(places, axis=0), axis=1)
        assert run.length[own][1:] == pytest.approx(steps)
        assert set(run.feed[own]) == {to[7]} and set(run.kind[own]) == {to[0]}


@pytest.mark.parametrize("degrees", range(10, 171, 20))
def test_a_straight_cut_touches_one_arc_on_its_right(degrees):
    run = simulated(climb(degrees), BELOW)
    i = middle(run)
    assert run.engagement_deg[i] == pytest.approx(degrees, abs=0.2)
    ((right, left, depth),) = run.arcs_at(i)
    assert right == -90 and left == pytest.approx(degrees - 90, abs=0.2)
    assert depth == run.axial_depth[i] == DEPTH
    assert run.max_engagement_deg == pytest.approx(degrees, abs=0.2)


def test_conventional_milling_touches_the_left():
    backwards = [UP, (LINK, 40, 1.5, -DEPTH, 0, 0, 0, 600), (CUT, -40, 1.5, -DEPTH, 0, 0, 0, FEED)]
    run = simulated([(*UP[:1], 40, 0, 5, 0, 0, 0, 0), *backwards[1:]], BELOW)
    ((right, left, _),) = run.arcs_at(middle(run))
    assert right == pytest.approx(30, abs=0.2) and left == 90


def test_a_slot_is_one_arc_and_contact_on_both_sides_two():
    run = simulated(line_at(0))
    ((right, left, _),) = run.arcs_at(middle(run))
    assert (right, left) == pytest.approx((-90, 90), abs=0.01)
    run = simulated(line_at(0), [(-30, 2.5, 30, 30), (-30, -30, 30, -2.5)])
    theta = math.degrees(math.acos(2.5 / RADIUS))
    right, left = run.arcs_at(middle(run))
    assert right == pytest.approx([-90, theta - 90, DEPTH], abs=0.2)
    assert left == pytest.approx([90 - theta, 90, DEPTH], abs=0.2)
    assert run.engagement_deg[middle(run)] == pytest.approx(2 * theta, abs=0.2)


@pytest.mark.parametrize("degrees", (20, 60, 90, 130, 180))
@pytest.mark.parametrize("teeth", (1, 3))
def test_chips_are_as_thick_as_their_closed_forms_say(degrees, teeth):
    run = simulated(climb(degrees), BELOW, teeth=teeth, cutting={"spindle_speed": SPEED})
    i, theta, per_tooth = middle(run), math.radians(degrees), FEED / SPEED / teeth
    assert run.feed_per_tooth[i] == pytest.approx(per_tooth, rel=1e-12)
    # [Jacsó 2021]; 0.2 degrees of engagement are 2 % of the thickness at 20 degrees.
    thickest = per_tooth * math.sin(min(theta, math.pi / 2))
    mean = per_tooth * (1 - math.cos(theta)) / theta
    assert run.h_max[i] == pytest.approx(thickest, rel=0.01)
    assert run.h_mean[i] == pytest.approx(mean, rel=0.01)
    assert run.force_peak is run.force_peak_max is run.torque_peak is None


def test_without_a_spindle_speed_there_are_no_chips():
    run = simulated(climb(60), BELOW)
    for values in (run.h_max, run.h_mean, run.feed_per_tooth):
        assert len(values) == len(run.x) and numpy.isnan(values).all()


@pytest.mark.parametrize("width", (0.5, 1.5, 3.0, 6.0))
def test_the_removal_rate_is_width_times_depth_times_feed(width):
    run = simulated(line_at(RADIUS - width), BELOW)
    expected = width * DEPTH * FEED
    assert run.removal_rate[middle(run)] == pytest.approx(expected, rel=5e-3)
    # Where the tool leaves the stock's corner, dexels are less exact.
    assert run.removal_rate_peak == pytest.approx(expected, rel=0.01)
    x, y, z = run.removal_rate_peak_at
    assert -33 <= x <= 33 and (y, z) == (RADIUS - width, -DEPTH)


def test_removal_rates_add_up_to_the_volume_removed():
    run = simulated(spiral())
    minutes = numpy.diff(run.time_s) / 60
    by_rate = ((run.removal_rate[1:] + run.removal_rate[:-1]) / 2 * minutes)[run.kind[1:] == CUT]
    cut = run.removed_volume_total - run.removed_volume[run.kind == ENTRY][-1]
    assert by_rate.sum() == pytest.approx(cut, rel=0.01)
    assert (numpy.diff(run.removed_volume) >= 0).all()
    assert run.removed_volume[-1] == run.removed_volume_total
    assert run.removed_volume_total == pytest.approx(DEPTH * run.removed_area, rel=1e-3)
    assert run.stock.volume == pytest.approx(3600 * DEPTH - run.removed_volume_total, rel=1e-6)


def test_the_star_s_straight_cut_needs_the_99_newtons_measured():
    run = simulated(climb(60), BELOW, cutting=STAR)
    i = middle(run)
    assert run.force_peak[i] == pytest.approx(99, abs=1)
    assert run.force_peak_max == run.force_peak[run.kind == CUT].max()
    assert run.force_peak_max == pytest.approx(99, abs=1) and len(run.force_peak_max_at) == 3
    assert run.power_mean[i] == pytest.approx(run.torque_mean[i] * SPEED * 2 * math.pi / 60)
    # The mean power is the tangential force times the cutting speed: K_tc times the removal rate.
    assert run.power_mean[i] == pytest.approx(1169.3 * run.removal_rate[i] / 60 / 1000, rel=1e-3)
    assert 0 < run.force_mean[i] < run.force_peak[i]
    assert max(run.force_x_peak[i], run.force_y_peak[i]) <= run.force_peak[i]
    assert not run.force_peak[run.engagement_deg == 0].any()


def test_forces_are_in_the_machine_s_axes():
    turned = [(k, -y, x, z, s, cx, cy, f) for k, x, y, z, s, cx, cy, f in climb(60)]
    along_x = simulated(climb(60), BELOW, cutting=STAR)
    along_y = simulated(turned, (0, -30, 30, 30), cutting=STAR)
    i, j = middle(along_x), int(numpy.argmin(abs(along_y.y) + 99 * (along_y.kind != CUT)))
    assert along_x.force_x_peak[i] == pytest.approx(along_y.force_y_peak[j], rel=1e-3)
    assert along_x.force_y_peak[i] == pytest.approx(along_y.force_x_peak[j], rel=1e-3)
    assert abs(along_x.force_x_peak[i] - along_x.force_y_peak[i]) > 1


def test_a_material_may_be_a_dictionary_and_twice_as_hard():
    soft, hard = ({"ktc": k, "krc": k / 3} for k in (500, 1000))
    runs = [simulated(climb(60), BELOW, cutting={**STAR, "material": m}) for m in (soft, hard)]
    assert runs[1].force_peak == pytest.approx(2 * runs[0].force_peak)
    straight = simulated(climb(60), BELOW, cutting={**STAR, "helix_angle_deg": 0})
    assert straight.force_peak_max > simulated(climb(60), BELOW, cutting=STAR).force_peak_max


# ---- times and lengths ----


def test_dwells_count_in_the_total_times(tmp_path):
    text = "S3000 M3\nG0 X-40 Y1.5 Z5\nG1 Z-3 F600\nG4 P30\nX40 F400\n"
    run = simulated(written(tmp_path, text), BELOW, machine="linuxcnc_mill")
    assert run.time_total_s == pytest.approx(run.time_s[-1] + 30)
    assert run.machine_time_total_s == pytest.approx(run.machine_time_s[-1] + 30)
    assert "Dwells of 30 s" in run.notes[-1]


def test_the_machine_is_never_faster_than_the_program():
    moves = [*line_at(0), (RAPID, 40, 0, 5, 0, 0, 0, 0), (RAPID, -40, 0, 5, 0, 0, 0, 0)]
    for cutting in ({"rapid_feed": 1000}, {"rapid_feed": 20000}, {}):
        run = simulated(moves, cutting=cutting, machine="machining_centre")
        assert run.machine_time_total_s >= run.time_total_s


def test_a_part_beside_its_stock_is_refused_within_the_stock_s_box_too():
    ell = [(0, 0, 0), (30, 0, 0), (30, 10, 0), (10, 10, 0), (10, 20, 0), (0, 20, 0)]
    with pytest.raises(ValueError, match="does not contain the part: 48 mm2"):
        simulated(climb(60), ell, part=(20, 12, 28, 18))
    with pytest.raises(ValueError, match="does not contain the part"):
        simulated(climb(60), ell, part=(5, 5, 15, 18))
    simulated(climb(60), ell, part=[ell])


def test_the_programmed_time_is_the_sum_of_lengths_over_feeds():
    moves = [*line_at(0), (RAPID, 40, 0, 5, 0, 0, 0, 0), (RAPID, -40, 0, 5, 0, 0, 0, 0)]
    run = simulated(moves, cutting={"rapid_feed": 4000})
    assert run.time_total_s == pytest.approx(60 * (8 / 600 + 80 / FEED + (8 + 80) / 4000))
    assert run.time_s[-1] == run.time_total_s
    assert numpy.diff(run.time_s) == pytest.approx(60 * run.length[1:] / run.feed[1:])
    assert (run.link_mm, run.cut_mm, run.rapid_mm) == pytest.approx((8, 80, 88))
    assert run.air_mm == pytest.approx(80 - 60 - RADIUS, abs=0.2)
    assert run.entry_mm == 0 and run.machine_time_s is run.machine_time_total_s is None
    # Without a rapid feed: 5000 mm/min, or the machine's.
    assert simulated(moves).feed.max() == 5000
    machine = "machining_centre"
    assert simulated(moves, machine=machine).feed.max() == machines.load(machine)["rapid_feed"]


def test_an_arc_is_as_long_as_it_turns():
    start = [(RAPID, 10, 0, 5, 0, 0, 0, 0)]
    run = simulated([*start, (ENTRY, -10, 0, 0, math.pi, 0, 0, 300)])
    assert run.entry_mm == pytest.approx(math.hypot(10 * math.pi, 5))
    half = int(numpy.argmin(abs(run.x)))
    assert run.y[half] == pytest.approx(10, abs=0.01) and run.z[half] == pytest.approx(
        2.5, abs=0.05
    )


@pytest.mark.parametrize("name", machines.names())
def test_the_machine_is_never_faster_than_programmed(name):
    run = simulated(spiral(), machine=name)
    assert len(run.machine_time_s) == len(run.time_s)
    assert (numpy.diff(run.machine_time_s) > -1e-9).all()
    assert (run.machine_time_s >= run.time_s - 1e-9).all()
    assert run.machine_time_total_s == run.machine_time_s[-1] > run.time_total_s


def test_a_machine_may_be_a_name_a_file_or_a_dictionary(tmp_path):
    slow = {"max_feed_mm_min": 120, "acceleration_mm_s2": 50}
    path = written(tmp_path, json.dumps(slow), "slow.json")
    for machine in (slow, path, str(path)):
        run = simulated(line_at(0), machine=machine)
        # Two lines at 2 mm/s, each from rest to rest or slower.
        assert run.machine_time_total_s == pytest.approx((8 + 80) / 2 + 2 * 2 / 50, rel=1e-6)


# ---- progress ----


def test_progress_grows_up_to_one():
    shares = []
    run = simulated(spiral(), progress=lambda share: shares.append(share) or True)
    assert shares == sorted(shares) and len(shares) > 4 and shares[-1] == 1
    assert 0 < shares[0] < 0.3 and not run.cancelled
    assert same_load(run, simulated(spiral()))


def test_a_cancelled_run_ends_where_it_was_stopped():
    whole = simulated(spiral(), cutting=STAR, machine="linuxcnc_mill")
    stopped = simulated(
        spiral(), cutting=STAR, machine="linuxcnc_mill", progress=lambda share: share < 0.5
    )
    size = len(stopped.x)
    assert stopped.cancelled and not whole.cancelled
    assert 0.2 * len(whole.x) < size < 0.8 * len(whole.x)
    for name in ("x", "engagement_deg", "force_peak", "machine_time_s", "h_mean"):
        assert numpy.array_equal(getattr(stopped, name), getattr(whole, name)[:size]), name
    assert math.isnan(stopped.rest_area) and stopped.rests == []
    assert stopped.figures()["rest_area_mm2"] is None and stopped.figures()["cancelled"]
    assert stopped.removed_volume_total == stopped.removed_volume[-1]
    assert stopped.time_total_s == whole.time_s[size - 1]


def test_what_was_cut_beforehand_has_its_part_of_the_progress():
    shares, earlier = [], [(line_at(-8), 6), (spiral(2000), 6)]
    progress = lambda share: shares.append(share) or True  # noqa: E731
    run = simulated(spiral(), earlier=earlier, progress=progress)
    assert shares == sorted(shares) and shares[-1] == 1 and not run.cancelled
    # A quarter of some 2700 mm beside 700 mm.
    before = [share for share in shares if share < 0.5]
    assert len(before) >= 3 and 0 < before[0] < 0.1
    assert max(b - a for a, b in zip(shares, shares[1:])) < 0.3
    assert same_load(run, simulated(spiral(), earlier=earlier))


def test_it_can_be_cancelled_while_what_was_cut_beforehand_is_taken_away():
    asked = []

    def progress(share):
        asked.append(share)
        return False

    stopped = simulated(
        line_at(0), earlier=[(line_at(-8), 6), (spiral(2000), 6)], progress=progress
    )
    assert len(asked) == 1 and 0 < asked[0] < 0.1
    assert stopped.cancelled and len(stopped.x) == 0 and stopped.time_total_s == 0
    assert math.isnan(stopped.rest_area) and stopped.figures()["cancelled"]
    assert stopped.stock.stands_beside(numpy.array([[0.0, 10, -DEPTH, 0]]), RADIUS).all()


def test_short_moves_ask_as_often_as_long_ones():
    """Each of these has some samples, so that not all numbers of samples come up."""
    shares = []
    run = simulated(
        spiral(4000, 0.5),
        step=1.5,
        resolution=0.05,
        progress=lambda share: shares.append(share) or True,
    )
    assert len(shares) > len(run.x) // 1100


def test_what_progress_raises_comes_through():
    with pytest.raises(ZeroDivisionError):
        simulated(spiral(), progress=lambda share: 1 / 0)


# ---- figures ----


@pytest.mark.parametrize(
    "options",
    ({}, {"cutting": STAR, "machine": "hobby_router_grbl", "part": GOUGED}),
    ids=("bare", "full"),
)
@pytest.mark.parametrize("moves", (climb(60), line_at(50), [UP, UP]), ids=("cut", "air", "nothing"))
def test_figures_are_plain_numbers_for_json(moves, options):
    run = simulated(moves, BELOW, **options)
    figures = run.figures()
    assert json.loads(json.dumps(figures, allow_nan=False)) == figures
    assert figures.pop("cancelled") is False
    assert {type(value) for value in figures.values()} <= {float, type(None)}
    other = [run.incidents, run.rests, run.rest_outlines, run.rest_at, run.gouge_at, run.notes]
    other += [run.max_engagement_at, run.removal_rate_peak_at, run.force_peak_max_at]
    json.dumps(other, allow_nan=False)
    empty = moves == [UP, UP]
    forceless = {k for k, v in figures.items() if v is None}
    if "cutting" not in options:
        assert forceless == {
            "h_max_mm",
            "force_peak_max_n",
            "torque_peak_nm",
            "power_mean_max_w",
            "machine_time_s",
            "fixture_mm",
        }
    elif not empty:
        assert forceless == {"fixture_mm"}


def test_figures_are_those_of_the_run():
    figures = simulated(climb(60), BELOW, cutting=STAR, part=GOUGED).figures()
    assert figures["max_engagement_deg"] == pytest.approx(60, abs=0.2)
    assert figures["removal_rate_peak_mm3_min"] == pytest.approx(1147.5, rel=5e-3)
    assert figures["h_max_mm"] == pytest.approx(FEED / SPEED * math.sin(math.pi / 3), rel=0.01)
    assert figures["force_peak_max_n"] == pytest.approx(99, abs=1)
    assert figures["gouge_mm"] == pytest.approx(0.05, abs=1e-6)
    assert figures["cut_mm"] == pytest.approx(80)
    assert figures["removed_volume_mm3"] == pytest.approx(270, rel=1e-3)
    assert figures["time_s"] == pytest.approx(60 * (math.hypot(8, 1.5) / 600 + 80 / FEED))
