"""Passes that go on beyond the picked faces: of the core, on the source's test part and on planes.
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
LINK, CUT = 1, 3
GUIDES = [[(-40, -40), (40, -40)], [(40, 40), (-40, 40)]]
PATTERNS = (
    {"pattern": "zig-zag", "angle": 0.5},
    {"pattern": "one way", "angle": 1.5},
    {"pattern": "zig-zag", "cusp_height": 0.1},
    {"pattern": "contours inwards"},
    {"pattern": "contours outwards", "cusp_height": 0.1},
    {"pattern": "spiral inwards"},
    {"pattern": "spiral outwards", "cusp_height": 0.1},
    {"pattern": "between guides", "guides": GUIDES},
    {"pattern": "one way between guides", "guides": GUIDES},
)


@pytest.fixture(scope="module")
def surface():
    return compiled.core().surface


def fine(**others):
    return options(**{"tolerance": TOLERANCE - DEFLECTION, "deflection": DEFLECTION, **others})


def strips(surface, ends, picked):
    """A mesh of rectangles 20 mm wide side by side, over y = 0 to 30, from [(x, z), ...]."""
    points = [(x, y, z) for x, z in ends for y in (0, 30)]
    triangles, flags = [], []
    for k in range(len(ends) - 1):
        a = 2 * k
        triangles += [(a, a + 2, a + 3), (a, a + 3, a + 1)]
        flags += [k in picked] * 2
    return surface.FacetMesh(points, triangles, flags)


def cut_places(found):
    return cases.places_along(found.toolpath.moves, (CUT,))


@pytest.mark.parametrize("others", PATTERNS, ids=[" ".join(map(str, p.values())) for p in PATTERNS])
@pytest.mark.parametrize("boundary", ["tool contact", "tool centre"])
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_all_patterns_go_on_and_stay_as_near(surface, is_convex, boundary, others):
    mesh = surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
    extension = 3.0
    found = surface.finish(
        mesh, **fine(stepover=1.5, extension=extension, boundary=boundary, **others)
    )
    places = cut_places(found)
    # The part's section, carried on in x as it is, and its flats in y.
    off = cases.distance(places + [0, 0, BALL], is_convex) - BALL
    assert off.min() > -0.2 * TOLERANCE and off.max() < TOLERANCE
    most = numpy.abs(places[:, :2]).max(axis=0)
    assert (most > 40 + extension - 1.6).all() and (most < 40 + extension + 1e-3).all()


def test_without_an_extension_passes_end_with_the_faces(surface):
    mesh = surface.FacetMesh(*cases.triangles(True, DEFLECTION))
    assert numpy.abs(cut_places(surface.finish(mesh, **fine()))[:, :2]).max() < 40 + 1e-3


def test_passes_follow_what_goes_on_and_no_further_than_they_shall(surface):
    fall = 20 * math.tan(math.radians(10))
    mesh = strips(surface, [(0, 0), (20, 0), (40, -fall)], {0})
    places = cut_places(surface.finish(mesh, **fine(stepover=2.0, extension=5.0, top=1.0)))
    # The ball touches the slope where its centre's foot lies.
    lean = BALL * math.sin(math.radians(10))
    assert places[:, 0].max() == pytest.approx(25 + lean, abs=0.01)
    beyond = places[places[:, 0] > 21 + lean]
    tip = -(beyond[:, 0] - 20) * math.tan(math.radians(10))
    tip += BALL / math.cos(math.radians(10)) - BALL
    assert beyond[:, 2] == pytest.approx(tip, abs=TOLERANCE)
    assert places[:, 0].min() == pytest.approx(-5, abs=0.01)
    assert places[places[:, 0] < 0][:, 2] == pytest.approx(0, abs=TOLERANCE)


def test_passes_go_on_level_where_the_part_falls_away_steeply(surface):
    mesh = strips(surface, [(0, 0), (20, 0), (21, -20), (40, -20)], {0})
    places = cut_places(surface.finish(mesh, **fine(stepover=2.0, extension=5.0, top=1.0)))
    assert places[:, 0].max() == pytest.approx(25, abs=0.01)
    assert places[:, 2] == pytest.approx(0, abs=TOLERANCE)


def test_passes_do_not_climb_a_wall(surface):
    mesh = strips(surface, [(0, 0), (30, 0), (30, 10), (40, 10)], {0})
    places = cut_places(surface.finish(mesh, **fine(stepover=2.0, extension=3.0, top=11.0)))
    before_it = places[(places[:, 1] > 0) & (places[:, 1] < 30)]
    assert before_it[:, 0].max() == pytest.approx(25, abs=0.01)
    assert places[:, 2] == pytest.approx(0, abs=TOLERANCE)
    assert places[:, 0].min() == pytest.approx(-3, abs=0.01)


def test_nothing_stands_over_a_lower_face_that_is_picked(surface):
    mesh = strips(surface, [(0, 0), (20, 0), (20, -6), (40, -6)], {0, 2})
    arguments = fine(stepover=2.0, extension=4.0, top=1.0)
    places = cut_places(surface.finish(mesh, **arguments))
    floor = places[(places[:, 0] > 25.05) & (places[:, 0] < 39)]
    assert len(floor) and floor[:, 2] == pytest.approx(-6, abs=TOLERANCE)


@pytest.mark.parametrize("value, sentence", [(-0.1, "must not be negative"), (math.inf, "finite")])
def test_an_extension_that_cannot_be_is_refused(surface, value, sentence):
    mesh = surface.FacetMesh(*cases.triangles(True, DEFLECTION))
    with pytest.raises(ValueError, match=sentence):
        surface.finish(mesh, **fine(extension=value))


@pytest.mark.parametrize("mode, sign", [("climb", -1), ("conventional", 1)])
def test_one_way_between_guides_goes_as_the_cut_mode_says(surface, mode, sign):
    mesh = surface.FacetMesh(*cases.triangles(True, DEFLECTION))
    arguments = fine(pattern="one way between guides", guides=GUIDES, stepover=5.0, cut_mode=mode)
    found = surface.finish(mesh, **arguments)
    for before, move in zip(found.toolpath.moves, found.toolpath.moves[1:]):
        if move[0] == CUT:
            assert sign * (move[1] - before[1]) > 0
    assert found.toolpath.report.retracts == found.toolpath.report.passes - 1 == 15
