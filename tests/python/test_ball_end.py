"""evenload.ball_end: chips against closed forms and reference values, the source's regressions."""

import math
import warnings

import numpy
import pytest
from ball_end_cases import KEYS, VECTORS, figures, on_the_plane, table, vector_chip
from evenload import ball_end, waiting
from evenload.ball_end import regressions, source

pytestmark = pytest.mark.core

WITHIN = {"V": 1e-3, "A_tool": 2e-3, "A_prev": 2e-3, "h_tool": 2e-3, "h_m": 2e-3, "h_max": 1e-2}


def cylinder_chip(radius=45, feed=0.12, stepover=0.15, direction=45, position=0, **more):
    return ball_end.chip(("cylinder", radius), 10, feed, stepover, 0.3, direction, position, **more)


# ---- chips ----


@pytest.mark.parametrize("feed, stepover", [*source.PAIRS, (0.08, None), (0.2, None), (0.12, 0.6)])
@pytest.mark.parametrize("direction", [0, 67.5])
def test_on_the_plane_chips_are_those_of_the_closed_form(feed, stepover, direction):
    uncut = "slot" if stepover is None else "left"
    found = ball_end.chip(("plane",), 10, feed, stepover or 1, 0.3, direction, uncut=uncut)
    volume, tool, before = on_the_plane(feed, stepover)
    assert found.volume == pytest.approx(volume, rel=1e-4)
    assert found.tool_face == pytest.approx(tool, rel=1e-4)
    assert found.previous_face == pytest.approx(before, rel=1e-4)
    assert found.mean_thickness == pytest.approx(volume / before, rel=2e-4)
    assert found.mean_thickness_tool == pytest.approx(volume / tool, rel=2e-4)


@pytest.mark.parametrize("row", VECTORS, ids=lambda row: "R%g, %g, %g, %g/%g, %s" % row[:6])
def test_chips_on_cylinders_are_the_reference_s(row):
    found = figures(vector_chip(row))
    for key, expected in zip(KEYS, row[6:]):
        assert found[key] == pytest.approx(expected, rel=WITHIN[key]), key


def test_the_reference_s_table_is_met():
    wanted, found = table()
    for key in KEYS:
        assert len(wanted[key]) == 90
        assert found[key] == pytest.approx(wanted[key], rel=WITHIN[key]), key
    assert found["tip_V"] == pytest.approx(wanted["tip_V"], abs=0.006)


def by_rays(feed, stepover, direction, position, radius, uncut, rings=240):
    """V, A_tool, h_max and the tip's share by rays from the ball's centre, convex or concave."""
    ball, allowance, angle = 5.0, 0.3, math.radians(direction)
    along = numpy.array([math.cos(angle), math.sin(angle)])
    left = numpy.array([-along[1], along[0]])
    way = radius + ball if radius > 0 else -radius - ball
    sign = 1 if radius > 0 else -1

    def centre(step):
        x, y = step[..., 0], position + step[..., 1]
        return numpy.stack([x, y, sign * numpy.sqrt(way**2 - y * y)], axis=-1)

    start = centre(numpy.zeros(2))
    normal = sign * start / way
    across = numpy.cross(normal, (1.0, 0, 0))
    reach = 0.46
    share = (numpy.arange(rings) + 0.5) / rings
    polar = numpy.arccos(1 - share**2 * (1 - math.cos(reach)))
    round_, polar = numpy.meshgrid((numpy.arange(2 * rings) + 0.5) / rings * math.pi, polar)
    weight = (2 * share * (1 - math.cos(reach)) / rings * math.pi / rings)[:, None] + 0 * polar
    tangent = numpy.cos(round_)[..., None] * (1.0, 0, 0) + numpy.sin(round_)[..., None] * across
    rays = numpy.sin(polar)[..., None] * tangent - numpy.cos(polar)[..., None] * normal

    def leaves(place):
        ahead = rays @ (place - start)
        away = (place - start) @ (place - start)
        return ahead + numpy.sqrt(numpy.maximum(ahead**2 + ball**2 - away, 0))

    begin = leaves(centre(-feed * along))
    for side in {"right": [1], "left": [-1], "strip": [1, -1], "slot": []}[uncut]:
        for s in numpy.linspace(-1.3, 1.3, 400):
            begin = numpy.maximum(begin, leaves(centre(side * stepover * left + s * along)))
    a = (rays[..., 1:] ** 2).sum(axis=-1)
    b = rays[..., 1:] @ start[1:]
    root = numpy.sqrt(
        numpy.maximum(b * b - a * (way**2 - (abs(radius) + sign * allowance) ** 2), 0)
    )
    begin = numpy.maximum(begin, numpy.where(root > 0, (-b - sign * root) / a, 9))
    cut = begin < ball
    volume = (weight * (ball**3 - begin**3) / 3)[cut]
    tip = numpy.hypot(rays[..., 0], rays[..., 1])[cut] < 0.2
    return (
        volume.sum(),
        ball**2 * weight[cut].sum(),
        (ball - begin[cut]).max(),
        volume[tip].sum() / volume.sum(),
    )


@pytest.mark.parametrize(
    "case",
    [
        (0.12, 0.15, 45, 21, 45, "left"),
        (0.1, 0.25, 110, 7, 45, "slot"),
        (0.05, 0.4, 200, -12, -45, "strip"),
        (0.2, 0.15, 45, 6, -45, "strip"),
        (0.12, 0.3, 30, 9, -45, "right"),
        (0.16, 0.35, -70, 6, 20, "right"),
    ],
    ids=str,
)
def test_rays_from_the_ball_s_centre_see_the_same_chip(case):
    feed, stepover, direction, position, radius, uncut = case
    volume, face, thickness, tip = by_rays(*case)
    found = cylinder_chip(radius, feed, stepover, direction, position, uncut=uncut)
    assert found.volume == pytest.approx(volume, rel=3e-3)
    assert found.tool_face == pytest.approx(face, rel=4e-3)
    assert thickness <= found.max_thickness * (1 + 1e-9)
    assert found.max_thickness == pytest.approx(thickness, rel=0.03)
    assert found.tip_share == pytest.approx(tip, abs=0.006)


def test_a_mirrored_cut_has_the_same_chip_and_a_scaled_one_the_same_shape():
    one = cylinder_chip(position=17, direction=30)
    other = cylinder_chip(position=-17, direction=-30, uncut="left")
    turned = cylinder_chip(position=17, direction=150, uncut="left")
    for twin in (other, turned):
        assert twin.volume == pytest.approx(one.volume, rel=1e-6)
        assert twin.edge == pytest.approx(one.edge, abs=1e-3)
    large = ball_end.chip(("cylinder", 90), 20, 0.24, 0.3, 0.6, 30, 34)
    assert large.volume == pytest.approx(8 * one.volume, rel=1e-6)
    assert large.max_thickness == pytest.approx(2 * one.max_thickness, rel=1e-6)


def test_steps_on_the_surface_do_not_know_its_slope():
    for steps in ("centre", "surface"):
        flat, steep = (cylinder_chip(position=y, steps=steps) for y in (0, 21))
        assert steep.volume == pytest.approx(flat.volume, rel=1e-6)
        assert steep.mean_thickness == pytest.approx(flat.mean_thickness, rel=1e-5)
    along = {steps: cylinder_chip(direction=0, steps=steps) for steps in ("centre", "surface")}
    # A step across on the part is 50/45 of it on the centres.
    wide = cylinder_chip(direction=0, stepover=0.15 * 50 / 45, steps="centre")
    assert along["surface"].volume == pytest.approx(wide.volume, rel=1e-5)
    assert along["centre"].volume < along["surface"].volume


def test_the_test_parts_are_their_cylinders_and_planes():
    for part, sign in (("CX", 1), ("CV", -1)):
        on_part = ball_end.chip(("test part", part), 10, 0.12, 0.15, 0.3, 45, 10)
        assert on_part.volume == pytest.approx(cylinder_chip(45 * sign, position=10).volume)
        flat = ball_end.chip(("test part", part), 10, 0.12, 0.15, 0.3, 45, -35)
        plane = ball_end.chip(("plane",), 10, 0.12, 0.15, 0.3, 45)
        assert flat.volume == pytest.approx(plane.volume, rel=1e-6)
    fillet = ball_end.chip(("test part", "CX"), 10, 0.12, 0.15, 0.3, 45, 28)
    assert 11.1e-3 < fillet.volume < 11.6e-3
    assert fillet.mean_thickness == pytest.approx(10.3e-3, rel=0.03)


def test_a_patch_has_the_chips_of_planes_cylinders_and_spheres():
    def patch(*numbers, direction=45.0):
        return ball_end.chip(("patch", *numbers), 10, 0.12, 0.15, 0.3, direction, steps="surface")

    plane = ball_end.chip(("plane",), 10, 0.12, 0.15, 0.3, 45)
    assert patch(0, 0).mean_thickness == pytest.approx(plane.mean_thickness, rel=1e-6)
    slope = math.degrees(math.asin(21 / 50))
    leaning = patch(0, 1 / 45, slope, 90)
    cylinder = cylinder_chip(position=21, steps="surface")
    assert leaning.volume == pytest.approx(cylinder.volume, rel=1e-6)
    assert leaning.edge == pytest.approx(cylinder.edge, abs=1e-3)
    spheres = [patch(-0.02, -0.02, direction=angle).volume for angle in (0, 30, 77)]
    assert spheres == pytest.approx([spheres[0]] * 3, rel=1e-4)
    # A saddle lies between the dome and the trough.
    dome, saddle, trough = (patch(0.02, k).tool_face for k in (0.02, -0.02, -0.04))
    assert dome < saddle < trough


def test_the_uncut_side_decides_on_the_tip_s_share():
    right, left = (cylinder_chip(position=10.5, uncut=side) for side in ("right", "left"))
    assert right.volume == pytest.approx(left.volume, rel=0.02)
    assert abs(right.tip_share - left.tip_share) > 0.5
    strip, slot = (cylinder_chip(uncut=side) for side in ("strip", "slot"))
    assert strip.volume < right.volume < slot.volume


def test_the_edge_tells_diameters_and_cutting_speeds():
    found = cylinder_chip(position=21)
    assert found.local_diameters == pytest.approx((4.01, 6.52), abs=0.01)
    assert found.cutting_speeds(5100)[1] == pytest.approx(math.pi * 6.52 * 5.1, rel=2e-3)
    assert cylinder_chip().edge[0] == 0


# ---- many chips ----


def test_many_chips_are_the_single_ones_on_any_number_of_threads():
    positions, parts = numpy.arange(-20.0, 21, 10), [("test part", "CX"), ("test part", "CV")]
    surfaces = [parts[i % 2] for i in range(5)]
    many, alone = (
        ball_end.chips(surfaces, 10, 0.12, 0.15, 0.3, [[0], [45]], positions, threads=n)
        for n in (0, 1)
    )
    assert many.volume.shape == (2, 5) and many.edge.shape == (2, 5, 2)
    for name in ("volume", "previous_face", "max_thickness", "edge", "tip_share"):
        assert (getattr(many, name) == getattr(alone, name)).all()
    single = ball_end.chip(surfaces[3], 10, 0.12, 0.15, 0.3, 45, positions[3])
    assert many.volume[1, 3] == single.volume
    assert many.mean_thickness[1, 3] == single.mean_thickness
    assert many.cutting_speeds(5000).shape == (2, 5, 2)


def test_whoever_waits_hears_the_share_and_may_stop_it():
    told = []

    def watch(share):
        told.append(share)
        return len(told) < 4

    with pytest.raises(waiting.Stopped), waiting.asking(watch):
        ball_end.chips(("plane",), 10, 0.1, 0.2, 0.3, numpy.zeros(500))
    assert len(told) == 4 and told == sorted(told) and told[-1] < 0.5


# ---- regressions ----


@pytest.fixture(scope="module")
def fits():
    return ball_end.fit(ball_end.source_rows())


@pytest.mark.parametrize("model", ["E0", "E1", "E2"])
def test_the_source_s_chips_give_its_regressions(fits, model):
    found = fits[model]
    assert found.rows == 780
    for term, published in zip(regressions.MODELS[model], regressions.PUBLISHED[model]):
        if term == "normal":
            assert abs(found.coefficients[term]) < found.standard_errors[term]
        else:
            assert found.coefficients[term] == pytest.approx(published, rel=0.03), term
    share = {"E0": 0.966, "E1": 0.974, "E2": 0.975}[model]
    assert found.adjusted_r_squared == pytest.approx(share, abs=0.002)
    squares = {"E0": 2.965e-4, "E1": 2.24e-4, "E2": 2.22e-4}[model]
    assert found.sum_of_squares == pytest.approx(squares, rel=0.02)


def test_standard_errors_are_the_source_s(fits):
    published = (8.968e-5, 1.933e-5, 6.1e-7, 5.387e-4, 2.155e-4, 7.25e-8)
    assert list(fits["E1"].standard_errors.values()) == pytest.approx(published, rel=0.02)


def test_both_halves_of_e3_fit_better_than_e1(fits):
    assert fits["E3 CV"].coefficients["feed_per_tooth"] == pytest.approx(0.08819, rel=0.01)
    assert fits["E3 CX"].coefficients["feed_per_tooth"] == pytest.approx(0.07930, rel=0.01)
    both = fits["E3 CV"].sum_of_squares + fits["E3 CX"].sum_of_squares
    assert both == pytest.approx(1.75e-4, rel=0.01)
    assert both < fits["E1"].sum_of_squares


def test_the_published_regression_has_its_values():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = ball_end.regression("E1", "CX", [0, 90], 0.08, 0.15, 0)
        assert 1e3 * found == pytest.approx([3.3419, 3.7163], abs=1e-4)
        assert 1e3 * ball_end.regression("E1", "CV", 45, 0.16, 0.35, 15.5) == pytest.approx(
            14.5331, abs=1e-4
        )
        assert ball_end.regression("E2", -1, 45, 0.12, 0.15, 0) == pytest.approx(
            ball_end.regression("E1", "CV", 45, 0.12, 0.15, 0), rel=0.05
        )


@pytest.mark.parametrize(
    "values, word",
    [
        ((0, 0.2, 0.15, 0), "feed per tooth from 0.08 to 0.16 mm"),
        ((0, 0.08, 0.5, 0), "stepover from 0.15 to 0.35 mm"),
        ((120, 0.08, 0.15, 0), "feed direction from 0 to 90 degrees"),
        ((0, 0.08, 0.15, 33.06), "normal from -27.82 to 27.82 degrees"),
    ],
)
def test_values_beyond_the_range_are_warned_of(values, word):
    with pytest.warns(ball_end.OutsideRange, match=word):
        ball_end.regression("E1", "CX", *values)


def test_beyond_the_range_no_thickness_is_negative():
    with pytest.warns(ball_end.OutsideRange):
        assert ball_end.regression("E1", "CX", 0, 0.04, 0.1, 0) == 0


def test_a_fit_finds_the_model_that_made_its_rows():
    grid = numpy.array(numpy.meshgrid((-1, 1), (0, 90), (0.08, 0.16), (0.15, 0.25, 0.35), (0, 20)))
    columns = grid.reshape(5, -1)
    rows = numpy.column_stack([*columns, ball_end.regression("E2", *columns)])
    found = ball_end.fit(rows, "E2")
    assert list(found.coefficients.values()) == pytest.approx(regressions.PUBLISHED["E2"], rel=1e-6)
    assert found.sum_of_squares < 1e-20
    assert found.at("CX", 45, 0.12, 0.2, 10) == pytest.approx(
        ball_end.regression("E2", "CX", 45, 0.12, 0.2, 10)
    )
    as_mapping = dict(zip(regressions.Rows._fields, rows.T))
    assert ball_end.fit(as_mapping, "E2") == found


# ---- bad input ----


@pytest.mark.parametrize(
    "changes, sentence",
    [
        ({"surface": ("cone",)}, "A surface is"),
        ({"surface": "plane"}, "A surface is"),
        ({"surface": ("cylinder", 0)}, "radius of a cylinder"),
        ({"surface": ("cylinder", -4)}, "ball does not fit"),
        ({"surface": ("patch", -0.3, 0), "steps": "centre"}, "ball does not fit"),
        ({"surface": ("patch", 0, 0)}, "not in plan"),
        ({"surface": ("patch", 0, 0), "steps": "centre", "position": 1}, "its position is 0"),
        ({"tool_diameter": 0}, "tool's diameter"),
        ({"feed_per_tooth": 0}, "feed per tooth must lie"),
        ({"feed_per_tooth": math.nan}, "feed per tooth must lie"),
        ({"feed_per_tooth": 4}, "feed per tooth is too large"),
        ({"stepover": 10}, "stepover must lie"),
        ({"axial_depth": 5}, "axial depth"),
        ({"feed_direction": math.inf}, "feed direction"),
        ({"position": 50, "surface": ("test part", "CX")}, "beyond the surface"),
        ({"position": 49, "surface": ("cylinder", 45)}, "too steep"),
        ({"uncut": "up"}, "uncut is right, left, strip or slot, not up"),
        ({"steps": "arc"}, "measured in plan, centre or surface"),
        ({"stepover": [1, 2]}, "One chip takes one number"),
        ({"stepover": "wide"}, "arguments of chips are numbers"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(changes, sentence):
    arguments = {
        **{"surface": ("plane",), "tool_diameter": 10, "feed_per_tooth": 0.1, "stepover": 0.2},
        **{"axial_depth": 0.3, "feed_direction": 0},
        **changes,
    }
    with pytest.raises(ValueError, match=sentence) as refused:
        ball_end.chip(**arguments)
    assert str(refused.value).endswith(".") and str(refused.value).count(". ") == 0


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda: ball_end.regression("E3", "CX", 0, 0.1, 0.2, 0), "E0, E1 or E2"),
        (lambda: ball_end.regression("E1", "flat", 0, 0.1, 0.2, 0), "nature"),
        (lambda: ball_end.regression("E1", "CX", 0, math.nan, 0.2, 0), "must be numbers"),
        (lambda: ball_end.fit([[1, 0, 0.1, 0.2, 0, 0.01]]), "too few"),
        (lambda: ball_end.fit([[1, 2, 3]]), "six columns"),
        (lambda: ball_end.fit(numpy.ones((9, 6)), "E4"), "models are"),
    ],
)
def test_bad_rows_are_refused_in_one_sentence(call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call()
