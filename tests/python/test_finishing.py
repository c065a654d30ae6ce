"""Finishing paths of the core on the source's test parts, judged by the distance from their lines
and arcs (finishing_cases.py).
"""

import math

import finishing_cases as cases
import numpy
import pytest
from evenload import compiled
from finishing_cases import TOLERANCE, options

pytestmark = pytest.mark.core

BALL = 5.0
DEFLECTION = TOLERANCE / 10
CUT, LINK, RAPID = 3, 1, 0
DOME, FILLET, LEAN = cases.DOME, cases.FILLET, cases.LEAN


@pytest.fixture(scope="module")
def surface():
    return compiled.core().surface


@pytest.fixture(scope="module")
def parts(surface):
    return {
        convex: surface.FacetMesh(*cases.triangles(convex, DEFLECTION)) for convex in (True, False)
    }


def fine(**others):
    return options(**{"tolerance": TOLERANCE - DEFLECTION, "deflection": DEFLECTION, **others})


def ball_off(moves, is_convex, kinds=(CUT, LINK)):
    places = cases.places_along(moves, kinds)
    return cases.distance(places + [0, 0, BALL], is_convex) - BALL


@pytest.mark.parametrize("boundary", ["tool contact", "tool centre"])
@pytest.mark.parametrize("angle", [0, 22.5, 45, 90, 200])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_the_path_is_within_the_tolerance(surface, parts, is_convex, angle, boundary):
    arguments = fine(angle=math.radians(angle), stepover=1.7, boundary=boundary)
    found = surface.finish(parts[is_convex], **arguments)
    off = ball_off(found.toolpath.moves, is_convex)
    assert off.min() > -0.2 * TOLERANCE and off.max() < TOLERANCE
    assert found.toolpath.report.retracts == 0
    assert found.largest_stepover == pytest.approx(found.least_stepover) and (
        0.8 < found.largest_stepover <= 1.7
    )


@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_passes_cover_the_part_with_few_lines(surface, parts, is_convex):
    found = surface.finish(parts[is_convex], **fine(angle=math.pi / 2, stepover=2.0))
    report = found.toolpath.report
    developed = 80 * 2 * (DOME * LEAN + FILLET * LEAN + 10) / 2.0
    assert report.passes == 40 and report.links == 39
    assert report.cut_length == pytest.approx(developed, rel=1e-3)
    # Within these bounds no arc can do with fewer lines.
    below, above = 0.05 * (TOLERANCE - DEFLECTION), 0.95 * (TOLERANCE - DEFLECTION)
    side = 1 if is_convex else -1
    least = 0
    for radius in (DOME + side * BALL, FILLET - side * BALL):
        least += 2 * LEAN / (2 * math.acos((radius - below) / (radius + above)))
    lines = sum(move[0] == CUT for move in found.toolpath.moves) / 40
    assert lines <= 1.2 * (least + 4)


def test_the_height_of_cusps_is_that_of_the_closed_form_on_the_flat(surface, parts):
    found = surface.finish(parts[True], **fine(stepover=0.8))
    ordinates = pass_ordinates(found.toolpath.moves)
    flat = ordinates[ordinates > 31]
    for before, after in zip(flat, flat[1:]):
        stands = BALL - math.sqrt(BALL**2 - ((after - before) / 2) ** 2)
        assert stands == pytest.approx(found.largest_stepover**2 / (8 * BALL), rel=0.05)


def pass_ordinates(moves):
    return numpy.array(sorted({round(move[2], 6) for move in moves if move[0] == CUT}))


def centre_height(y, is_convex):
    """Of a ball's centre on the part."""
    side = 1 if is_convex else -1
    y, dome, fillet = numpy.abs(y), DOME + side * BALL, FILLET - side * BALL
    on_dome = numpy.sqrt(numpy.maximum(dome**2 - y**2, 0))
    in_fillet = cases.CENTRE - numpy.sqrt(numpy.maximum(fillet**2 - (y - 30) ** 2, 0))
    level = cases.LEVEL + side * BALL
    z = numpy.where(y <= dome * math.sin(LEAN), on_dome, numpy.where(y <= 30, in_fillet, level))
    return side * z


def cusps(ordinates, is_convex):
    """What stands between neighbouring passes along x: where two balls meet, off the part."""
    result = []
    for a, b in zip(ordinates, ordinates[1:]):
        first, second = (numpy.array((y, centre_height(y, is_convex))) for y in (a, b))
        half, (dy, dz) = numpy.linalg.norm(second - first) / 2, second - first
        down = numpy.array((dz, -dy)) / (2 * half)
        meet = (first + second) / 2 + math.sqrt(BALL**2 - half**2) * down
        result.append(cases.distance(numpy.array([(0, *meet)]), is_convex)[0])
    return numpy.array(result)


@pytest.mark.parametrize("wish", [0.0006, 0.002, 0.01])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_even_cusps_are_even_on_95_percent_of_the_part(surface, parts, is_convex, wish):
    found = surface.finish(parts[is_convex], **fine(cusp_height=wish))
    ordinates = pass_ordinates(found.toolpath.moves)
    stands = cusps(ordinates, is_convex)
    widths = numpy.diff(ordinates)
    even = numpy.abs(stands - wish) <= 0.1 * wish
    assert widths[even].sum() > 0.95 * widths.sum()
    assert stands.max() < 1.25 * wish  # in the strip where an arc begins
    half = found.largest_stepover / 2
    assert 40 - ordinates[-1] < half and ordinates[0] + 40 < half


def test_even_cusps_with_an_allowance_are_those_of_the_tool_itself(surface, parts):
    wish, allowance = 0.01, 0.5
    found = surface.finish(parts[True], **fine(cusp_height=wish, allowance=allowance))
    ordinates = pass_ordinates(found.toolpath.moves)
    # The offset face is level there, too. To the last pass it is as far as is left.
    flat = ordinates[ordinates > 31.5][:-1]
    for step in numpy.diff(flat):
        assert BALL - math.sqrt(BALL**2 - (step / 2) ** 2) == pytest.approx(wish, rel=0.1)


def test_passes_at_a_slant_leave_no_more_than_the_wish(surface, parts):
    found = surface.finish(parts[True], **fine(angle=math.radians(45), cusp_height=0.01))
    # Between passes at 45 degrees a place on the crest is half a stepover off at the most.
    assert (
        found.largest_stepover
        < 1.02
        * 2
        * math.sqrt(0.01 * (2 * BALL - 0.01))
        * math.sqrt(DOME / (DOME + BALL))
        * (DOME + BALL)
        / DOME
    )


@pytest.mark.parametrize("boundary", ["tool contact", "tool centre"])
@pytest.mark.parametrize("pattern", ["contours inwards", "contours outwards"])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_contours_are_closed_and_within_the_tolerance(surface, parts, is_convex, pattern, boundary):
    arguments = fine(pattern=pattern, stepover=2.0, boundary=boundary)
    found = surface.finish(parts[is_convex], **arguments)
    moves, report = found.toolpath.moves, found.toolpath.report
    off = ball_off(moves, is_convex)
    assert off.min() > -0.2 * TOLERANCE and off.max() < TOLERANCE
    assert report.passes == 20 and report.links == 19 and report.retracts == 0
    cuts = [move for move in moves if move[0] == CUT]
    sizes = [max(abs(m[1]), abs(m[2])) for m in (cuts[0], cuts[-1])]
    assert sorted(sizes, reverse=pattern == "contours inwards") == sizes
    assert max(sizes) == pytest.approx(39) and min(sizes) == pytest.approx(1)
    # The square's passes in plan, two of whose sides climb over the dome or dip into the trough.
    level = sum(8 * (39 - 2 * k) for k in range(20))
    assert level < report.cut_length < 1.05 * level


@pytest.mark.parametrize("mode, turn", [("climb", -1), ("conventional", 1)])
@pytest.mark.parametrize("pattern, way", [("contours inwards", 1), ("contours outwards", -1)])
def test_contours_turn_as_the_cut_mode_says(surface, parts, pattern, way, mode, turn):
    # Inwards, what stands is inside: to climb with it on the right the pass turns clockwise.
    moves = surface.finish(
        parts[True], **fine(pattern=pattern, stepover=8.0, cut_mode=mode)
    ).toolpath.moves
    area = 0.0
    for before, move in zip(moves, moves[1:]):
        if move[0] == CUT:
            area += before[1] * move[2] - before[2] * move[1]
    assert math.copysign(1, area) == turn * way


def test_contours_go_round_what_is_not_picked(surface):
    # A square frame of 60 mm with a hole of 20 mm in it.
    ring = [(-30, -30), (30, -30), (30, 30), (-30, 30), (-10, -10), (10, -10), (10, 10), (-10, 10)]
    triangles = []
    for k in range(4):
        n = (k + 1) % 4
        triangles += [(k, n, 4 + n), (k, 4 + n, 4 + k)]
    points = [(x, y, 0) for x, y in ring]
    mesh = surface.FacetMesh(points, triangles, [True] * 8)
    arguments = fine(pattern="contours inwards", stepover=2.0, boundary="tool centre", top=1.0)
    moves = surface.finish(mesh, **arguments).toolpath.moves
    cuts = [move for move in moves if move[0] == CUT]
    off = [math.hypot(max(abs(m[1]) - 10, 0), max(abs(m[2]) - 10, 0)) for m in cuts]
    assert min(off) == pytest.approx(1, abs=3e-3)
    assert all(move[3] == 0 for move in cuts)
    inner = [m for m in cuts if max(abs(m[1]), abs(m[2])) < 12]
    outer = [m for m in cuts if max(abs(m[1]), abs(m[2])) > 28]
    assert inner and outer


def test_an_allowance_stays_everywhere(surface, parts):
    found = surface.finish(parts[False], **fine(angle=1.0, stepover=2.0, allowance=0.4))
    off = ball_off(found.toolpath.moves, False)
    assert 0.4 - 0.2 * TOLERANCE < off.min() and off.max() < 0.4 + TOLERANCE


def test_rapids_are_above_everything_and_plunges_no_faster_than_they_may(surface, parts):
    moves = surface.finish(
        parts[True], **fine(pattern="one way", stepover=4.0, angle=math.pi / 2)
    ).toolpath.moves
    before = moves[0]
    assert before[0] == RAPID and before[3] == 55
    for move in moves[1:]:
        (x, y, z), (x0, y0, z0) = move[1:4], before[1:4]
        if move[0] == RAPID:
            assert min(z, z0) >= 50 and (z == z0 or (x, y) == (x0, y0)) or z > z0
        elif z < z0:
            length = math.dist((x, y, z), (x0, y0, z0))
            assert move[7] * (z0 - z) / length <= 800 * (1 + 1e-9)
        before = move
    assert before[3] == 55


@pytest.mark.parametrize("mode, sign", [("climb", -1), ("conventional", 1)])
def test_one_way_goes_as_the_cut_mode_says(surface, parts, mode, sign):
    # Passes follow each other towards +y; to climb, what stands must be on the right.
    arguments = fine(pattern="one way", stepover=5.0, cut_mode=mode)
    moves = surface.finish(parts[True], **arguments).toolpath.moves
    for before, move in zip(moves, moves[1:]):
        if move[0] == CUT:
            assert sign * (move[1] - before[1]) > 0


def test_the_same_bytes_on_any_number_of_threads(surface, parts):
    one, four = (
        surface.finish(parts[False], **fine(angle=0.4, threads=n)).toolpath.moves for n in (1, 4)
    )
    assert one == four


@pytest.mark.parametrize("others", [{}, {"cusp_height": 0.0006}])
def test_a_cancelled_path_is_empty(surface, parts, others):
    asked = []

    def progress(share):
        asked.append(share)
        return len(asked) < 5

    arguments = fine(stepover=0.15, angle=1.5, progress=progress, **others)
    found = surface.finish(parts[True], **arguments)
    assert found.toolpath.report.termination == "cancelled"
    assert found.toolpath.moves == [] and len(asked) == 5


@pytest.mark.parametrize(
    "others, sentence",
    [
        ({"stepover": 0.0}, "stepover must be positive"),
        ({"stepover": 10.1}, "no more than the tool's diameter"),
        ({"corner_radius": 5.1}, "corner's radius"),
        ({"corner_radius": 0.0, "cusp_height": 0.01}, "flat end mill leaves steps"),
        ({"cusp_height": 6.0}, "no more than the radius"),
        ({"allowance": -0.1}, "must not be negative"),
        ({"tolerance": math.nan}, "not finite"),
        ({"safe_height": 40.0}, "must not lie below the top"),
        ({"feed": 0.0}, "Feeds must be positive"),
        ({"floor": 46.0}, "touches none of the picked faces"),
        ({"stepover": 1e-5}, "too many passes"),
        ({"pattern": "spiral"}, "pattern"),
        ({"pattern": "between guides", "guides": [[], []], "cusp_height": 0.01}, "no length"),
    ],
)
def test_what_cannot_be_is_refused(surface, parts, others, sentence):
    with pytest.raises(ValueError, match=sentence):
        surface.finish(parts[True], **fine(**others))


def test_faces_that_nothing_sees_from_above_are_refused(surface):
    points, triangles, picked = cases.triangles(True)
    mesh = surface.FacetMesh(points, triangles, ~picked)
    with pytest.raises(ValueError, match="can be seen from above"):
        surface.finish(mesh, **options())


def test_a_flat_tool_keeps_off_a_wall_by_its_radius(surface):
    # A level face of 40 x 20 mm with a wall of 10 mm at x = 30.
    points = [(x, y, z) for x, z in ((0, 0), (30, 0), (30, 10), (40, 10)) for y in (0, 20)]
    triangles = [(k, k + 2, k + 3) for k in (0, 2, 4)] + [(k, k + 3, k + 1) for k in (0, 2, 4)]
    mesh = surface.FacetMesh(points, triangles, [k in (0, 3) for k in range(6)])
    moves = surface.finish(
        mesh, **options(corner_radius=0, stepover=3.0, floor=-5.0, boundary="tool contact")
    ).toolpath.moves
    cuts = [move for move in moves if move[0] == CUT]
    assert max(move[1] for move in cuts) == pytest.approx(25, abs=1e-3)
    assert {move[3] for move in cuts} == {0.0}
