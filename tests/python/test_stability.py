"""What an operation's stability is made of: modes as they are kept, feed directions of a path, the
chart over them all, the verdict.
"""

import dataclasses
import json
import math

import numpy
import pytest
from evenload import compiled, machines, materials, planar, waiting
from evenload.dynamics import Frf, Mode, directions, vibration
from evenload.stability import choice, cut, field, picture

core = compiled.core()

X = {"stiffness_n_per_um": 8, "frequency_hz": 900, "damping_ratio": 0.02}
Y = {"mass_kg": 0.21, "frequency_hz": 1150, "damping_ratio": 0.018, "direction_deg": 90}


def a_cut(**changes):
    rows = vibration.load([X, Y]).modes
    values = {
        "label": "pocket",
        "modes": rows,
        "teeth": 2,
        "diameter": 10.0,
        "helix_angle": 30.0,
        "flute_length": 22.0,
        "engagement_deg": 60.0,
        "cut_mode": "climb",
        "material": materials.load("Stability test case"),
        "speed": 6366.0,
        "depth": 5.0,
        "feed_per_tooth": 0.05,
        "directions": directions.ALL,
    }
    return cut.Cut(**{**values, **changes})


# ---- modes as they are kept ----


def test_modes_come_back_from_their_text_and_from_their_file(tmp_path):
    found = vibration.load({"name": "long tool", "note": "20 mm out", "modes": [X, Y]})
    found.save(tmp_path / "spindle.json")
    for again in (vibration.load(found.text()), vibration.load("spindle.json", str(tmp_path))):
        assert (again.name, again.note) == ("long tool", "20 mm out")
        for before, after in zip(found.modes, again.modes):
            assert dataclasses.astuple(after) == pytest.approx(dataclasses.astuple(before), 1e-8)


def test_tap_tests_of_a_file_are_fitted(tmp_path):
    for axis, row in (("x", X), ("y", Y)):
        (mode,) = vibration.load([row]).modes
        frf = Frf.of_modes([dataclasses.replace(mode, direction=0.0)], numpy.arange(400, 1800, 2.0))
        rows = ["frequency Hz, real um/N, imag um/N"]
        rows += ["%g,%g,%g" % (f, v.real, v.imag) for f, v in zip(frf.frequencies, 1e6 * frf.xx)]
        (tmp_path / ("tap_%s.csv" % axis)).write_text("\n".join(rows))
    taps = [{"file": "tap_%s.csv" % a, "axis": a + a, "unit": "um/N"} for a in "xy"]
    (tmp_path / "spindle.json").write_text(json.dumps({"tap_tests": taps}))
    found = vibration.load(str(tmp_path / "spindle.json"))
    assert [mode.frequency for mode in found.modes] == pytest.approx([900, 1150], rel=1e-4)
    assert [mode.direction for mode in found.modes] == [0, 90]
    assert len(found.fits) == 2


@pytest.mark.parametrize(
    "what, sentence",
    [
        ([], "has no mode"),
        ([{**X, "mass_kg": 1}], "either stiffness_n_per_um or mass_kg"),
        ([{**Y, "mass_kg": -1}], "mass"),
        ([{**X, "stiffness_n_per_um": -1}], "stiffness of a mode must be above 0"),
        ([{**X, "damping_ratio": -0.01}], "damping"),
        ([{**X, "damping_ratio": "little"}], "must be a number"),
        ([{"stiffness_n_per_um": 8, "frequency_hz": 900}], "has no damping_ratio"),
        ([{**X, "frequency": 900}], "unknown key 'frequency'"),
        ([7], "give an object"),
        ({"mode": [X]}, "unknown key 'mode'"),
        ({"modes": X}, "must be a list"),
        ({"tap_tests": [{"axis": "xx"}]}, "has no file"),
        ({"tap_tests": [{"file": "nowhere.csv"}]}, "there is no file"),
        ({"tap_tests": [{"file": "nowhere.csv", "modes": "two"}]}, "cannot be 'two'"),
        ("{", "no JSON"),
        ("nowhere.json", "cannot be read"),
        (7, "not 7"),
    ],
)
def test_modes_that_cannot_be_are_refused_in_a_sentence(what, sentence):
    with pytest.raises(ValueError, match=sentence) as error:
        vibration.load(what)
    assert "\n" not in str(error.value)


def test_a_tap_test_without_a_unit_is_asked_for_it(tmp_path):
    rows = ["%g,%g,%g" % (f, 1.0, -1.0) for f in range(100, 200)]
    (tmp_path / "tap.csv").write_text("frequency,real,imag\n" + "\n".join(rows))
    with pytest.raises(ValueError, match="unit"):
        vibration.load({"tap_tests": [{"file": "tap.csv"}]}, str(tmp_path))


def test_a_machine_may_have_modes():
    profile = {"max_feed_mm_min": 6000, "acceleration_mm_s2": 800, "name": "mill", "modes": [X]}
    found = vibration.load(machines.modes(profile))
    assert found.name == "mill" and found.modes[0].frequency == 900
    assert machines.load(profile)["name"] == "mill"
    assert machines.modes("linuxcnc_mill") is None


# ---- feed directions ----


def line(x, y, kind=planar.CUT, z=0.0):
    return kind, x, y, z, 0.0, 0.0, 0.0, 100.0


def test_lines_have_one_direction_whichever_way_they_go():
    there_and_back = [line(0, 0), line(10, 10), line(0, 0), line(0, 7, planar.RAPID)]
    assert directions.of_moves(there_and_back).tolist() == [45]


def test_what_goes_down_has_no_feed_direction():
    assert not len(directions.of_moves([line(0, 0), line(1, 0, z=-1.0), line(1, 0, z=-2.0)]))


@pytest.mark.parametrize("sweep", [math.pi / 2, -math.pi / 2])
def test_arcs_have_all_directions_between_their_ends(sweep):
    end = math.cos(sweep), math.sin(sweep)
    arc = planar.CUT, *end, 0.0, sweep, 0.0, 0.0, 100.0
    first, last = (0, 90) if sweep < 0 else (90, 180)
    wanted = sorted({degrees % 180 for degrees in range(first, last + 1)})
    assert directions.of_moves([line(1, 0), arc]).tolist() == wanted


def test_a_circle_has_all_directions():
    circle = planar.CUT, 1.0, 0.0, 0.0, 2 * math.pi, 0.0, 0.0, 100.0
    assert directions.of_moves([line(1, 0), circle]).tolist() == directions.ALL.tolist()


def test_the_worst_direction_is_that_of_all_one_by_one():
    milling = a_cut().milling()
    speeds, depths = numpy.array([6000.0, 9000.0]), numpy.array([[3.0], [6.0]])
    radii, worst = directions.worst_radii(milling, speeds, depths)
    for row, depth in enumerate(depths[:, 0]):
        for column, speed in enumerate(speeds):
            radius, direction = milling.worst_spectral_radius(speed, depth)
            assert radii[row, column] == pytest.approx(radius, abs=1e-6)
            assert worst[row, column] == direction


def test_the_limit_is_the_least_of_all_directions():
    milling = a_cut().milling()
    limit = directions.limit_depth(milling, 7000, 15)
    each = [milling.changed(feed_direction=d).critical_depth(7000, 15) for d in range(0, 180, 4)]
    assert limit == pytest.approx(min(each), rel=2e-3)
    assert directions.limit_depth(milling, 7000, 0.9 * limit) == math.inf


def test_without_a_level_cut_there_is_no_direction_to_look_at():
    with pytest.raises(ValueError, match="no level cut"):
        directions.worst_radii(a_cut().milling(), 6000, 1, [])


# ---- the chart ----


@pytest.mark.parametrize("some", [directions.ALL, numpy.array([30.0]), numpy.arange(20.0)])
def test_the_chart_agrees_with_the_exact_limits(some):
    one = a_cut(directions=some, flute_length=None)
    *_, found = field.levels(one, (4000, 12000), (0.05, 12))
    assert found.share == 1
    limits, seen = found.limits(), 0
    for column in range(8, len(found.speeds), 17):
        exact = directions.limit_depth(one.milling(), found.speeds[column], 12, some)
        if math.isfinite(exact) and math.isfinite(limits[column]):
            assert limits[column] == pytest.approx(exact, rel=0.01)
            seen += 1
        else:
            assert exact == limits[column] or max(found.radii[:, column]) > 0.97
    assert seen >= 4


def test_a_chart_stops_when_it_is_told_to():
    asked = []

    def watch(_):
        asked.append(1)
        return len(asked) < 3

    with waiting.asking(watch), pytest.raises(waiting.Stopped):
        list(field.levels(a_cut(), (4000, 12000), (0.05, 12)))
    assert len(asked) == 3


def test_thin_lobes_are_followed_between_the_nodes_of_the_first_grid():
    one = a_cut(directions=numpy.array([30.0]), flute_length=None)
    *_, found = field.levels(one, (3000, 12000), (0.05, 20))
    radii = one.milling(feed_direction=30.0).spectral_radius(
        *numpy.meshgrid(found.speeds, found.depths)
    )
    wrong = (radii >= 1) != (found.radii >= 1)
    assert (wrong & (abs(radii - 1) > 0.02)).mean() < 0.002


# ---- the verdict ----


def test_an_unstable_cut_is_told_with_its_remedies():
    one = a_cut(depth=8.0)
    verdict = cut.judged(one)
    assert not verdict.is_stable and verdict.spectral_radius > 1
    worst = one.milling().worst_spectral_radius(one.speed, one.depth)
    assert (verdict.spectral_radius, verdict.feed_direction) == worst
    shallower = dataclasses.replace(one, depth=0.99 * verdict.limit_depth)
    assert cut.judged(shallower).is_stable
    assert cut.judged(dataclasses.replace(one, speed=verdict.stable_speed)).is_stable
    assert "chatters near %.0f Hz" % verdict.chatter_hz in verdict.sentence
    assert "at %.0f rev/min" % verdict.stable_speed in verdict.sentence


def test_the_stable_speed_is_one_that_the_spindle_can_do():
    free = cut.judged(a_cut(depth=8.0)).stable_speed
    bound = (free - 1, 2e4) if free < 6366 else (0, free + 1)
    held = cut.judged(a_cut(depth=8.0, speeds=bound)).stable_speed
    assert held == pytest.approx(free, rel=0.02)
    assert cut.judged(a_cut(depth=8.0, speeds=(6300, 6400))).stable_speed is None


def test_a_stable_cut_is_told_with_its_limit():
    verdict = cut.judged(a_cut(depth=1.0))
    assert verdict.is_stable and verdict.stable_speed is None
    assert verdict.limit_depth > 1
    assert "up to %.3g mm deep" % verdict.limit_depth in verdict.sentence


def test_a_spindle_that_turns_the_other_way_is_seen_in_a_mirror():
    slanted = [Mode.from_stiffness(8, 900, 0.02, 30)]
    mirrored = [Mode.from_stiffness(8, 900, 0.02, -30)]
    one = cut.judged(a_cut(modes=slanted, directions=numpy.array([10.0, 70.0])))
    other = cut.judged(
        a_cut(modes=mirrored, directions=numpy.array([110.0, 170.0]), is_reversed=True)
    )
    assert other.spectral_radius == pytest.approx(one.spectral_radius, rel=1e-9)
    assert other.feed_direction == 180 - one.feed_direction


@pytest.mark.parametrize(
    "changes, sentence",
    [
        ({"depth": 23.0}, "beyond the tool's flutes"),
        ({"speed": 0.0}, "no spindle speed"),
        ({"directions": numpy.array([])}, "no level cut"),
    ],
)
def test_cuts_that_cannot_be_are_refused_in_a_sentence(changes, sentence):
    with pytest.raises(ValueError, match=sentence):
        cut.judged(a_cut(**changes))


def test_the_chart_is_drawn_as_png_and_svg(tmp_path):
    one = a_cut(depth=8.0)
    for name, start in (("chart.png", b"\x89PNG"), ("chart.svg", b"<?xml")):
        picture.save(one, cut.judged(one), tmp_path / name)
        assert (tmp_path / name).read_bytes().startswith(start)


# ---- the best cut ----

BOX = (5000, 12000), 12.0


def test_the_best_cut_is_stable_with_its_margin_in_all_directions():
    one = a_cut()
    found = choice.best_of(one, *BOX)
    radius, _ = one.milling(cut_mode=found.cut_mode).worst_spectral_radius(found.speed, found.depth)
    assert found.spectral_radius == pytest.approx(radius) and radius <= 0.9 + 1e-6
    easier = choice.best_of(dataclasses.replace(one, directions=numpy.array([0.0])), *BOX)
    assert easier.removal_rate > found.removal_rate


def few(**changes):
    """A cut along a polygon."""
    return a_cut(directions=directions.spread(directions.ALL, 6), **changes)


def test_limits_of_error_force_and_spindle_make_the_best_cut_smaller():
    free = choice.best_of(few(), *BOX)
    straight = choice.best_of(few(), *BOX, surface_limit=0.01)
    assert abs(straight.surface_location_error) <= 0.01 < abs(free.surface_location_error)
    limit = 0.5 * choice.force_at(few(), free.depth)
    light = choice.best_of(few(), *BOX, force_limit=limit)
    assert choice.force_at(few(), light.depth) <= limit * (1 + 1e-9)
    slow = choice.best_of(few(speeds=(0, 7500)), *BOX)
    assert slow.speed <= 7500 < free.speed
    for held in (straight, light, slow):
        assert held.removal_rate < free.removal_rate


def test_where_no_cut_will_do_there_is_no_best_one():
    assert choice.best_of(a_cut(), *BOX, margin=0.999) is None
    assert choice.best_of(a_cut(), *BOX, force_limit=1e-6) is None
    with pytest.raises(ValueError, match="none of the chart's speeds"):
        choice.best_of(a_cut(speeds=(20000, 30000)), *BOX)


def test_the_force_is_that_of_the_mirrored_arc_too():
    one = a_cut()
    edge = core.ForceCoefficients(*(one.material[key] for key in ("ktc", "krc", "kte", "kre")))
    model = core.ForceModel(edge, 5.0, 2, math.radians(30))
    other = -math.pi / 2, math.radians(60) - math.pi / 2, 5.0
    assert model.force([other], 0.05, 6366).peak_xy == pytest.approx(choice.force_at(one, 5), 1e-3)
