"""What the ball feels along a path: places, cusps and force against closed forms, chips against
those of known surfaces.
"""

import math

import numpy
import pytest
from ball_end_cases import VECTORS, on_the_plane, vector_chip
from evenload import materials
from evenload.ball_end import loads, places
from evenload.planar import CUT, LINK, RAPID

pytestmark = pytest.mark.core

BALL, STOCK, SPEED, TEETH = 5.0, 0.3, 5100.0, 4


def cutting(material="Al6082-T6"):
    return loads.Cutting(2 * BALL, TEETH, SPEED, STOCK, materials.load(material))


def one_place(way, feed, stepover, uncut="right"):
    """A Places of one: stepover mm in plan to the pass on the other side, feed mm in plan."""
    way = numpy.array(way, float) / numpy.linalg.norm(way)
    per_tooth = feed / numpy.hypot(*way[:2])
    sides = {"right": (stepover, math.inf), "left": (math.inf, stepover), "slot": (math.inf,) * 2}
    left, right = sides[uncut]
    feeds = numpy.array([per_tooth * SPEED * TEETH])
    return places.Places(
        numpy.zeros((1, 3)), way[None], feeds, numpy.array([left]), numpy.array([right]), 1.0
    )


def bends(normal, first, second, direction):
    rows = (numpy.array([each], float) for each in (normal, first, second, direction))
    return loads.Bends(*rows)


LEVEL = bends((0, 0, 1), 0, 0, (1, 0, 0))


def on_cylinder(row):
    """(way, Bends) of a row of VECTORS: on a cylinder along x, at the tool's ordinate."""
    radius, position, direction = row[:3]
    sine = position / (radius + BALL)
    angle = math.radians(direction)
    normal = numpy.array((0, sine, math.sqrt(1 - sine**2)))
    level = numpy.array((math.cos(angle), math.sin(angle), 0))
    level[2] = -level @ normal / normal[2]
    return level, bends(normal, 0, 1 / radius, (1, 0, 0))


def moves(points, kind=CUT, feed=1000.0):
    return [(kind, *point, 0.0, 0.0, 0.0, feed) for point in points]


def zig_zag(passes, length=40.0, stepover=0.5):
    found = moves([(0, 0, 50)], RAPID)
    for number in range(passes):
        ends = [(0, number * stepover, 0), (length, number * stepover, 0)]
        start, end = ends if number % 2 == 0 else ends[::-1]
        found += moves([start], LINK) + moves([end])
    return found


# ---- places ----


def test_there_is_a_place_in_each_equal_share_of_the_cuts_alone():
    found = places.places_along(zig_zag(8), 80, 0.5)
    assert found.length == pytest.approx(320)
    assert (numpy.sort(found.tips[:10, 0]) // 4).tolist() == list(range(10))
    assert numpy.abs(found.ways[:, 0]).min() == 1 and set(found.feeds) == {1000.0}


def test_passes_of_one_length_are_not_met_at_the_same_places():
    found = places.places_along(zig_zag(80), 400, 0.5)  # five to each
    counts, _ = numpy.histogram(found.tips[:, 0], 20, (0, 40))
    assert counts.min() >= 15 and counts.max() <= 25


def test_earlier_passes_lie_a_stepover_beside_and_alternately():
    found = places.places_along(zig_zag(8), 80, 0.5)
    row = numpy.arange(80) // 10
    assert set(found.uncut[row == 0]) == {"slot"}
    # Passes go on to the left of the first: those to and fro have it on either side.
    assert set(found.uncut[(row > 0) & (row % 2 == 0)]) == {"left"}
    assert set(found.uncut[row % 2 == 1]) == {"right"}
    assert found.stepovers[row > 0] == pytest.approx(0.5, abs=1e-12)
    assert numpy.isinf(found.stepovers[row == 0]).all()


def test_a_pass_between_two_has_a_strip_to_cut():
    rows = [(0.0, 0), (1.0, 1), (0.4, 2)]
    path = moves([(0, 0, 50)], RAPID)
    for y, _ in rows:
        path += moves([(0, y, 0)], LINK) + moves([(40, y, 0)])
    found = places.places_along(path, 30, 0.7)
    last = numpy.arange(30) >= 20
    assert set(found.uncut[last]) == {"strip"}
    assert found.stepovers[last] == pytest.approx(0.6, abs=1e-12)


def test_around_a_square_the_pass_before_is_a_stepover_away_on_one_side():
    path = moves([(0, 0, 50)], RAPID)
    for inset in (0.0, 0.5, 1.0, 1.5):
        low, high = inset, 20 - inset
        corners = [(low, low, 0), (low, high, 0), (high, high, 0), (high, low, 0), (low, low, 0)]
        path += moves(corners[:1], LINK) + moves(corners[1:])
    found = places.places_along(path, 400, 0.5)
    inner = found.tips[:, :2].min(axis=1) > 0.4
    inner &= found.tips[:, :2].max(axis=1) < 19.6
    assert inner.sum() > 200
    assert set(found.uncut[inner]) == {"right"}  # clockwise, seen from above
    assert found.stepovers[inner] == pytest.approx(0.5, abs=1e-9)


def test_a_path_without_a_cut_is_refused():
    with pytest.raises(ValueError, match="cuts nothing"):
        places.places_along(moves([(0, 0, 0), (9, 0, 0)], LINK), 10, 0.5)


# ---- chips ----


@pytest.mark.parametrize("feed, stepover", [(0.08, 0.35), (0.12, 0.15), (0.16, 0.35)])
@pytest.mark.parametrize("uncut", ["right", "left", "slot"])
def test_on_a_plane_the_thickness_is_that_of_the_closed_form(feed, stepover, uncut):
    found = loads.loads_at(one_place((1, 2, 0), feed, stepover, uncut), LEVEL, cutting())
    volume, _, before = on_the_plane(feed, None if uncut == "slot" else stepover)
    assert found.mean_thickness[0] == pytest.approx(volume / before, rel=2e-4)
    assert found.least_speed[0] == pytest.approx(0, abs=1e-6)  # the tip is in the cut


@pytest.mark.parametrize("row", VECTORS, ids=lambda row: "R%g, %g, %g, %g/%g, %s" % row[:6])
def test_on_a_cylinder_chips_are_those_of_steps_in_plan(row):
    feed, stepover, uncut = row[3:6]
    way, bent = on_cylinder(row)
    found = loads.loads_at(one_place(way, feed, stepover, uncut), bent, cutting())
    expected = vector_chip(row)
    # Steps are laid off on the tangent, which at R10 counts.
    within = 0.006 if abs(row[0]) > 10 else 0.03
    assert found.mean_thickness[0] == pytest.approx(expected.mean_thickness, rel=within)
    assert found.max_thickness[0] == pytest.approx(expected.max_thickness, rel=2 * within)
    assert found.tip_share[0] == pytest.approx(expected.tip_share, abs=0.02)
    assert found.least_speed[0] == pytest.approx(expected.cutting_speeds(SPEED)[0], abs=1.5)


def test_a_surface_that_is_turned_has_the_same_chips():
    row = VECTORS[2]
    way, bent = on_cylinder(row)
    found = [loads.loads_at(one_place(way, *row[3:6]), bent, cutting())]
    angle = math.radians(71)
    turn = numpy.array(
        [[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]]
    )
    turned = bends(
        turn @ bent.normals[0], 1 / row[0], 0, turn @ numpy.cross(bent.normals[0], (1, 0, 0))
    )
    found.append(loads.loads_at(one_place(turn @ way, *row[3:6]), turned, cutting()))
    for name in ("mean_thickness", "max_thickness", "tip_share", "least_speed", "cusp", "force"):
        first, second = (getattr(each, name)[0] for each in found)
        assert second == pytest.approx(first, rel=1e-9), name


def test_a_place_that_the_ball_does_not_fit_into_is_left_out_with_its_reason():
    both = places.Places(
        numpy.zeros((2, 3)),
        numpy.array([(1.0, 0, 0)] * 2),
        numpy.full(2, 0.08 * SPEED * TEETH),
        numpy.full(2, 0.35),
        numpy.full(2, math.inf),
        1.0,
    )
    bent = loads.Bends(
        numpy.array([(0, 0, 1.0)] * 2),
        numpy.array([0, -0.25]),
        numpy.zeros(2),
        numpy.array([(1.0, 0, 0)] * 2),
    )
    found = loads.loads_at(both, bent, cutting())
    assert len(found.mean_thickness) == len(found.force) == 1
    assert len(found.refusals) == 1 and "ball does not fit" in found.refusals[0]
    with pytest.raises(ValueError, match="ball does not fit"):
        loads.loads_at(both.only(numpy.array([False, True])), bent.only([False, True]), cutting())


# ---- cusps ----


@pytest.mark.parametrize("stepover", [0.15, 0.35, 3.0])
def test_cusps_on_a_plane_are_those_of_the_closed_form(stepover):
    (found,) = loads.cusp_heights(numpy.array([stepover]), numpy.zeros(1), BALL)
    assert found == pytest.approx(BALL - math.sqrt(BALL**2 - stepover**2 / 4), rel=1e-12)
    if stepover < 1:
        assert found == pytest.approx(stepover**2 / (8 * BALL), rel=2e-3)


@pytest.mark.parametrize("radius", [45.0, -45.0, 10.0, -10.0])
def test_cusps_along_a_cylinder_are_those_of_the_closed_form(radius):
    half = 0.02  # rad between a pass and the cusp
    of_centres = radius + BALL
    width = 2 * abs(of_centres) * math.sin(half)
    height = math.sqrt(BALL**2 - width**2 / 4)
    cusp = of_centres * math.cos(half) - radius
    expected = cusp - height if radius > 0 else -(-cusp + height)
    (found,) = loads.cusp_heights(
        numpy.array([2 * abs(of_centres) * half]), numpy.array([1 / radius]), BALL
    )
    assert found == pytest.approx(expected, rel=1e-9)


def test_without_a_pass_beside_there_is_no_cusp():
    found = loads.loads_at(one_place((1, 0, 0), 0.08, 0.35, "slot"), LEVEL, cutting())
    assert math.isnan(found.cusp[0])


# ---- force ----


def force_by_rays(feed, stepover, coefficients, slope=0.0, downhill=0.0, size=400, around=720):
    """N: the mean size of the force on a plane that leans by a slope, downhill at an angle from the
    feed, by small pieces of the ball's surface; rad. Material stands on the feed's right.
    """
    span = 1.05 * math.acos(1 - STOCK / BALL)
    across, along = numpy.meshgrid(*2 * [numpy.linspace(-span, span, size)], indexing="ij")
    # Around the point of contact, in the frame of the feed and the plane's normal.
    u = numpy.stack([numpy.sin(along), numpy.cos(along) * numpy.sin(across)])
    u = numpy.stack([*u, -numpy.cos(along) * numpy.cos(across)])
    piece = BALL**2 * numpy.cos(along) * (2 * span / (size - 1)) ** 2
    back = -feed * u[0]
    before = back + numpy.sqrt(back**2 + BALL**2 - feed**2)
    flat, side = u[1] ** 2 + u[2] ** 2, u[1] * stepover
    beside = (side + numpy.sqrt(side**2 - flat * (stepover**2 - BALL**2))) / flat
    thickness = BALL - numpy.maximum(numpy.maximum(before, beside), (BALL - STOCK) / -u[2])
    cuts = (thickness > 0).ravel()
    u, h, piece = u.reshape(3, -1)[:, cuts], thickness.ravel()[cuts], piece.ravel()[cuts]
    # The tool's axis leans uphill in this frame.
    axis = numpy.array(
        [-math.sin(slope) * math.cos(downhill), -math.sin(slope) * math.sin(downhill)]
    )
    axis = numpy.array([*axis, math.cos(slope)])
    aside = numpy.array([1.0, 0, 0]) - axis[0] * axis
    aside /= numpy.linalg.norm(aside)
    angle = numpy.arctan2(numpy.cross(axis, aside) @ u, aside @ u)
    arm = numpy.cross(u.T, axis).T  # the way of a tooth, clockwise from above, times the sine
    sine = numpy.linalg.norm(arm, axis=0)
    # A piece at a radius is swept by an edge as long as the piece over the way that it turns.
    edge = piece / (BALL * sine) / (2 * math.pi / around)
    tangential = edge * (coefficients["ktc"] * h + coefficients["kte"]) / sine * arm
    radial = edge * (coefficients["krc"] * h + coefficients["kre"]) * u
    when = numpy.floor(angle / (2 * math.pi) * around).astype(int) % around
    tooth = numpy.array(
        [numpy.bincount(when, weights=row, minlength=around) for row in tangential + radial]
    )
    every = sum(numpy.roll(tooth, n * around // TEETH, axis=1) for n in range(TEETH))
    return float(numpy.linalg.norm(every, axis=0).mean())


def leaning(slope, downhill):
    """(way, Bends) of a plane; the feed is along x of the plane itself."""
    normal = numpy.array((0.0, 0.0, 1.0))
    axis = numpy.array((-math.sin(downhill), math.cos(downhill), 0))

    def turned(v):  # about the level axis, so that the normal leans downhill
        return (
            v * math.cos(slope)
            + numpy.cross(axis, v) * math.sin(slope)
            + axis * (axis @ v) * (1 - math.cos(slope))
        )

    way = turned(numpy.array((1.0, 0, 0)))
    return way, bends(turned(normal), 0, 0, way)


# Downhill is ahead, to the left, behind, to the right.
@pytest.mark.parametrize("slope, downhill", [(0, 0), *((25, each) for each in (0, 90, 180, 270))])
@pytest.mark.parametrize("material", ["Star test piece", "Al6082-T6"])
@pytest.mark.parametrize("feed, stepover", [(0.08, 0.35), (0.12, 0.15), (0.16, 0.35)])
def test_the_force_on_planes_is_near_that_of_small_pieces(
    feed, stepover, material, slope, downhill
):
    given = cutting(material)
    slope, downhill = math.radians(slope), math.radians(downhill)
    way, bent = leaning(slope, downhill)
    level = numpy.hypot(*way[:2])
    # one_place takes both in plan: such that they are these along the plane.
    place = one_place(way, feed * level, stepover * bent.normals[0, 2] / level)
    found = loads.loads_at(place, bent, given).force[0]
    expected = force_by_rays(feed, stepover, given.coefficients, slope, downhill)
    # Least near where material stands downhill: the tip's side cuts the thicker end of the chip.
    is_downhill = slope > 0 and math.sin(downhill) < -0.5
    assert found == pytest.approx(expected, rel=0.23 if is_downhill else 0.11)


def test_chip_force_grows_with_the_coefficients_and_not_with_the_speed():
    place = one_place((1, 0, 0), 0.08, 0.35)
    soft, hard = (
        loads.Cutting(2 * BALL, TEETH, SPEED, STOCK, {"ktc": k, "krc": k / 3, "kte": 0, "kre": 0})
        for k in (500.0, 1500.0)
    )
    first, second = (loads.loads_at(place, LEVEL, each).force[0] for each in (soft, hard))
    assert second == pytest.approx(3 * first, rel=1e-9)
