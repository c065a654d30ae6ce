"""Spirals, passes between guides and the arcs that lead into passes: of the core, on the source's
test parts (finishing_cases.py).
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
RAPID, LINK, ENTRY, CUT = 0, 1, 2, 3
SPIRALS = ("spiral inwards", "spiral outwards")


@pytest.fixture(scope="module")
def surface():
    return compiled.core().surface


@pytest.fixture(scope="module")
def parts(surface):
    return {
        convex: surface.FacetMesh(*cases.triangles(convex, DEFLECTION)) for convex in (True, False)
    }


@pytest.fixture(scope="module")
def walled(surface):
    """A level face of 40 x 20 mm with a wall of 10 mm at x = 30."""
    points = [(x, y, z) for x, z in ((0, 0), (30, 0), (30, 10), (40, 10)) for y in (0, 20)]
    triangles = [(k, k + 2, k + 3) for k in (0, 2, 4)] + [(k, k + 3, k + 1) for k in (0, 2, 4)]
    return surface.FacetMesh(points, triangles, [k in (0, 3) for k in range(6)])


def fine(**others):
    return options(**{"tolerance": TOLERANCE - DEFLECTION, "deflection": DEFLECTION, **others})


def off(moves, is_convex, kinds=(CUT, LINK)):
    return cases.distance(cases.places_along(moves, kinds) + [0, 0, BALL], is_convex) - BALL


def steps(moves, *kinds):
    """[(kind, start, end), ...] of the moves of some kinds, arcs as lines."""
    moves = cases.as_lines(moves)
    pairs = zip(moves, moves[1:])
    return [(m[0], numpy.array(b[1:4]), numpy.array(m[1:4])) for b, m in pairs if m[0] in kinds]


# ---- spirals ----


@pytest.mark.parametrize("pattern", SPIRALS)
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_a_spiral_is_one_path_within_the_tolerance(surface, parts, is_convex, pattern):
    found = surface.finish(parts[is_convex], **fine(pattern=pattern, stepover=2.0))
    moves = found.toolpath.moves
    distance = off(moves, is_convex)
    assert distance.min() > -0.2 * TOLERANCE and distance.max() < TOLERANCE
    # Where a turn lies on the part as a whole, nothing but cuts, and every place is half a stepover
    # from one of them at the most.
    at_cuts = [k for k, move in enumerate(moves) if move[0] == CUT]
    whole = moves[at_cuts[0] - 1 : at_cuts[-1] + 1]  # without the ways there and back
    inside = [s for s in steps(whole, RAPID, LINK, ENTRY, CUT) if norm(s[2]) < 39]
    assert {kind for kind, *_ in inside} == {CUT}
    radii = numpy.array([norm(end) for _, _, end in inside])
    assert (numpy.diff(radii) * (1 if pattern == "spiral outwards" else -1) > -1e-3).all()
    cut = cuts_of(moves)
    for place in numpy.random.default_rng(1).uniform(-39, 39, (200, 2)):
        assert to_cuts(place, *cut) < 1.0 + 0.01
    assert found.least_stepover == found.largest_stepover == 2.0


def norm(place):
    return math.hypot(place[0], place[1])


def cuts_of(moves):
    """(starts, ends) in plan of the cuts."""
    return tuple(numpy.array([s[k][:2] for s in steps(moves, CUT)]) for k in (1, 2))


def to_cuts(place, starts, ends):
    """mm from a place in plan to the nearest of the cuts."""
    ways = ends - starts
    along = numpy.einsum("ij,ij->i", place - starts, ways)
    shares = numpy.clip(along / numpy.maximum((ways**2).sum(axis=1), 1e-12), 0, 1)
    return numpy.linalg.norm(place - starts - shares[:, None] * ways, axis=1).min()


@pytest.mark.parametrize("mode", ["climb", "conventional"])
@pytest.mark.parametrize("pattern", SPIRALS)
def test_spirals_turn_as_the_cut_mode_says(surface, parts, pattern, mode):
    moves = surface.finish(parts[True], **fine(pattern=pattern, stepover=5.0, cut_mode=mode))
    # To climb, what stands must be on the right: the middle of a spiral inwards, turning clockwise.
    is_clockwise = (pattern == "spiral inwards") == (mode == "climb")
    for _, start, end in steps(moves.toolpath.moves, CUT):
        turn = start[0] * end[1] - start[1] * end[0]
        assert turn <= 1e-9 if is_clockwise else turn >= -1e-9


# ---- even cusps ----


def stands_at(moves, places):
    """What stands at places of the part, in mm: how far the nearest of the balls is from them."""
    points = cases.places_along(moves, (CUT,), 0.05)
    centres = points[:, :3] + [0, 0, BALL]
    size = 0.5
    cells = numpy.floor(centres[:, :2] / size).astype(int)
    keys = cells[:, 0] * 100003 + cells[:, 1]
    order = numpy.argsort(keys, kind="stable")
    centres, keys = centres[order], keys[order]
    result = []
    for place in places:
        home = numpy.floor(place[:2] / size).astype(int)
        near = []
        for i in range(-8, 9):
            row = (home[0] + i) * 100003 + home[1]
            low, high = numpy.searchsorted(keys, (row - 8, row + 9))
            near.append(centres[low:high])
        result.append(numpy.linalg.norm(numpy.vstack(near) - place, axis=1).min() - BALL)
    return numpy.array(result)


@pytest.mark.parametrize("pattern", ["contours inwards", "contours outwards", *SPIRALS])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_even_cusps_are_nowhere_higher_than_the_wish(surface, is_convex, pattern):
    wish = 0.02
    mesh = surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
    # Lines of 0.5 um: what stands is what the distances leave.
    arguments = fine(pattern=pattern, cusp_height=wish, tolerance=0.0005)
    found = surface.finish(mesh, **arguments)
    plan_ = numpy.random.default_rng(5).uniform(-40, 40, (3000, 2))
    places = numpy.column_stack([plan_, cases.height(plan_[:, 1], is_convex)])
    stands = stands_at(found.toolpath.moves, places)
    assert stands.max() < 1.12 * wish
    # Places are spread evenly across strips, on which cusps rise as a square: those above 0.81 of
    # the wish are a tenth where all cusps are as high as that.
    assert 0.06 < (stands > 0.81 * wish).mean() < 0.12
    assert found.least_stepover < 0.8 * found.largest_stepover


@pytest.mark.parametrize("pattern", ["contours inwards", "spiral inwards"])
def test_rows_of_even_cusps_are_the_same_on_any_number_of_threads(surface, parts, pattern):
    one, three = (
        surface.finish(parts[True], **fine(pattern=pattern, cusp_height=0.1, threads=n))
        for n in (1, 3)
    )
    assert one.toolpath.moves == three.toolpath.moves
    assert one.toolpath.report.passes > 10


def test_contours_of_even_cusps_reach_into_sharp_corners_and_the_middle(surface):
    # A level triangle whose corners are as sharp as 26 degrees.
    mesh = surface.FacetMesh([(0, 0, 0), (40, 0, 0), (6, 18, 0)], [(0, 1, 2)], [True])
    wish = 0.05
    arguments = fine(pattern="contours inwards", cusp_height=wish, top=1.0)
    found = surface.finish(mesh, **arguments)
    shares = numpy.random.default_rng(4).dirichlet((1, 1, 1), 2000)
    places = shares @ numpy.array([(0, 0, 0), (40, 0, 0), (6, 18, 0)])
    assert stands_at(found.toolpath.moves, places).max() < 1.12 * wish
    level = 2 * math.sqrt(wish * (2 * BALL - wish))
    assert found.least_stepover == pytest.approx(level, rel=0.01)


# ---- between guides ----

BOTTOM, TOP = [(-40, -40), (40, -40)], [(40, 40), (-40, 40)]
ARC = [(40 * math.sin(a), 20 - 8 * math.cos(a)) for a in numpy.linspace(-1.2, 1.2, 60)]


@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_between_straight_guides_passes_are_parallel(surface, parts, is_convex):
    arguments = fine(pattern="between guides", guides=[BOTTOM, TOP], stepover=2.0)
    found = surface.finish(parts[is_convex], **arguments)
    moves, report = found.toolpath.moves, found.toolpath.report
    assert report.passes == 40 and report.links == 39 and report.retracts == 0
    ordinates = sorted({round(end[1], 6) for _, _, end in steps(moves, CUT)})
    assert ordinates == pytest.approx([-39 + 2 * k for k in range(40)])
    assert found.least_stepover == found.largest_stepover == 2.0
    distance = off(moves, is_convex)
    assert distance.min() > -0.2 * TOLERANCE and distance.max() < TOLERANCE


def test_passes_change_from_one_guide_to_the_other(surface, parts):
    line = [(-35.0, -20.0), (35.0, -20.0)]
    found = surface.finish(
        parts[True], **fine(pattern="between guides", guides=[line, ARC[::-1]], stepover=1.5)
    )
    widest = max(math.dist(a, b) for a, b in zip(shared(line), shared(ARC)))
    count = math.ceil(widest / 1.5)
    assert found.toolpath.report.passes == count
    assert found.largest_stepover == pytest.approx(widest / count, rel=1e-3)
    assert found.least_stepover < found.largest_stepover
    middle = numpy.array([p for p in shared(line)]), numpy.array([p for p in shared(ARC)])
    cuts = cuts_of(found.toolpath.moves)
    for k in (0, count // 2, count - 1):
        wanted = middle[0] + (k + 0.5) / count * (middle[1] - middle[0])
        for place in wanted[5:-5:10]:
            assert to_cuts(place, *cuts) < 0.01
    distance = off(found.toolpath.moves, True)
    assert distance.min() > -0.2 * TOLERANCE and distance.max() < TOLERANCE


def ring(radius, begin, sense):
    """Corners of a closed guide around the origin, the first at an angle in degrees."""
    angles = math.radians(begin) + sense * numpy.linspace(0, 2 * math.pi, 121)
    return [tuple(radius * numpy.array((math.cos(a), math.sin(a)))) for a in angles]


@pytest.mark.parametrize("begin", [0, 180, 77])
@pytest.mark.parametrize("sense", [1, -1])
def test_closed_guides_go_round_in_step(surface, parts, begin, sense):
    guides = [ring(30, 0, 1), ring(20, begin, sense)]
    arguments = fine(pattern="between guides", guides=guides, stepover=2.1)
    found = surface.finish(parts[True], **arguments)
    assert found.toolpath.report.passes == 5
    radii = [math.hypot(*end[:2]) for _, _, end in steps(found.toolpath.moves, CUT)]
    assert 20.9 < min(radii) and max(radii) < 29.1


def shared(line, count=200):
    """Places at even shares of a line's length."""
    line = numpy.array(line)
    along = numpy.concatenate(
        [[0], numpy.cumsum(numpy.linalg.norm(numpy.diff(line, axis=0), axis=1))]
    )
    at = numpy.linspace(0, along[-1], count)
    return numpy.stack([numpy.interp(at, along, line[:, k]) for k in (0, 1)], axis=1)


@pytest.mark.parametrize(
    "guides, sentence",
    [
        ([], "need two"),
        ([BOTTOM], "need two"),
        ([BOTTOM, [(0, -60), (0, 60)]], "cross each other"),
        ([BOTTOM, [(-40, -45), (40, -35)]], "cross each other"),
        ([BOTTOM, BOTTOM], "cross each other"),
        ([BOTTOM, [(1, 1), (1, 1)]], "has no length"),
        ([BOTTOM, [(1, 1)]], "has no length"),
    ],
)
def test_guides_that_cannot_be_are_refused(surface, parts, guides, sentence):
    arguments = fine(pattern="between guides", guides=guides, stepover=2.0)
    with pytest.raises(ValueError, match=sentence):
        surface.finish(parts[True], **arguments)


# Across the slopes of both parts, of different widths, and along them with the widest way level.
WIDENING = [(-40, -40), (40, -40)], [(-40, 10), (40, 40)]
ALONG = [(-40, -40), (-40, 40)], [(10, -40), (40, 40)]


@pytest.mark.parametrize("guides", [WIDENING, ALONG, WIDENING[::-1]])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_between_guides_the_highest_cusp_is_the_wish(surface, parts, is_convex, guides):
    wish = 0.02
    arguments = dict(pattern="between guides", guides=guides, cusp_height=wish, tolerance=0.0005)
    found = surface.finish(parts[is_convex], **fine(**arguments))
    count = found.toolpath.report.passes
    stands = stands_at(found.toolpath.moves, places_between(*guides, is_convex))
    assert stands.max() < 1.03 * wish  # lines are up to 0.0005 mm above the part
    # Some place needs that many passes: cusps are as the square of the distance. Few of the random
    # places are near it, and on a crest.
    assert stands.max() * (count / (count - 1)) ** 2 > 0.8 * wish
    level = 2 * math.sqrt(wish * (2 * BALL - wish))
    assert found.largest_stepover <= (1 if guides == ALONG else 0.85) * level


def places_between(first, second, is_convex, count=6000):
    """Places that a ball touches whose axis is at random places between straight guides."""
    share, part = numpy.random.default_rng(7).uniform(0, 1, (2, count, 1))
    ends = [numpy.array(g[0]) + share * (numpy.array(g[1]) - g[0]) for g in (first, second)]
    axes = ends[0] + part * (ends[1] - ends[0])
    y = numpy.linspace(-40, 40, 100001)
    lean = -numpy.gradient(cases.height(y, is_convex), y)
    touched = numpy.interp(axes[:, 1], y + BALL * lean / numpy.hypot(lean, 1), y)
    return numpy.column_stack([axes[:, 0], touched, cases.height(touched, is_convex)])


def test_guides_by_cusps_are_the_same_on_any_number_of_threads(surface, parts):
    arguments = dict(pattern="between guides", guides=WIDENING, cusp_height=0.1)
    one, three = (surface.finish(parts[True], **fine(**arguments, threads=n)) for n in (1, 3))
    assert one.toolpath.moves == three.toolpath.moves


def test_a_cusp_height_of_too_many_passes_between_guides_is_refused(surface, parts):
    arguments = dict(pattern="between guides", guides=WIDENING, cusp_height=1e-9)
    with pytest.raises(ValueError, match="makes too many passes"):
        surface.finish(parts[True], **fine(**arguments))


# ---- arcs that lead in and out ----


@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_passes_begin_and_end_tangentially(surface, parts, is_convex):
    arguments = fine(pattern="one way", angle=math.pi / 2, stepover=8.0, lead_radius=3.0)
    found = surface.finish(parts[is_convex], **arguments)
    moves = found.toolpath.moves
    arcs = off(moves, is_convex, (ENTRY, LINK))
    assert arcs.min() > -0.2 * TOLERANCE
    checked = 0
    for (kind, a, b), (after, _, d) in zip(*(steps(moves, *range(4))[k:] for k in (0, 1))):
        if (kind, after) in ((ENTRY, CUT), (CUT, LINK)):
            first, second = (b - a) / numpy.linalg.norm(b - a), (d - b) / numpy.linalg.norm(d - b)
            assert math.degrees(math.acos(min(1, first @ second))) < 6
            checked += 1
    assert checked == 2 * found.toolpath.report.passes
    heights = [end[2] - start[2] for kind, start, end in chains(moves, LINK)]
    assert heights == pytest.approx([3.0] * len(heights), abs=0.02)


def chains(moves, kind):
    """[(kind, start, end), ...] of moves of a kind that follow each other, as one."""
    found, is_on = [], False
    for each, start, end in steps(moves, *range(4)):
        if each == kind and is_on:
            found[-1] = (kind, found[-1][1], end)
        elif each == kind:
            found.append((kind, start, end))
        is_on = each == kind
    return found


def test_beside_a_wall_an_arc_is_smaller_or_missing(surface, walled):
    def heights(radius):
        arguments = options(stepover=3.0, floor=-5.0, pattern="one way", lead_radius=radius)
        moves = surface.finish(walled, **arguments).toolpath.moves
        places = cases.places_along(moves, (CUT, LINK, ENTRY))
        low = places[:, 2] < 10 - 1e-6
        assert places[low, 0].max() < 25 + 1e-3  # the ball's side stays off the wall
        return [start[0] - end[0] for _, start, end in chains(moves, LINK)]

    assert len(heights(2.0)) > 2
    assert heights(0.0) == []


def test_lead_radius_must_not_be_negative(surface, parts):
    with pytest.raises(ValueError, match="lead radius must not be negative"):
        surface.finish(parts[True], **fine(lead_radius=-1.0))
