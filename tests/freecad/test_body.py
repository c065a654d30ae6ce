"""Bodies as what stands over the plane, against closed forms."""

import math

import numpy
import Part
import pytest
from evenload import compiled
from evenload.geometry import body, in_plane
from evenload.geometry.floor import inside
from FreeCAD import Vector

pytestmark = pytest.mark.between

BOX = Part.makeBox(60, 40, 20)


def _tilted():
    box = Part.makeBox(10, 10, 30)
    box.rotate(Vector(0, 0, 0), Vector(0, 1, 0), 30)
    return box


def _frustum():
    low = Part.makePolygon(
        [Vector(x, y, 0) for x, y in ((0, 0), (50, 0), (50, 30), (0, 30), (0, 0))]
    )
    high = Part.makePolygon(
        [Vector(x, y, 20) for x, y in ((3, 3), (47, 3), (47, 27), (3, 27), (3, 3))]
    )
    return Part.makeLoft([low, high], True)


def _skewed():
    ellipse = Part.Ellipse(Vector(0, 0, 0), 8, 5).toShape()
    return Part.Face(Part.Wire(ellipse)).extrude(Vector(4, 0, 10))


SLANTED = 10 * math.cos(math.radians(30)) + 30 * math.sin(math.radians(30))
STANDING = {
    "a block": (BOX, 5, 2400),
    "a block at its top": (BOX, 20, 0),
    "round a pocket": (BOX.cut(Part.makeBox(40, 20, 6, Vector(10, 10, 14))), 14.01, 1600),
    "the lips of a T-slot": (
        BOX.cut(Part.makeBox(60, 10, 20, Vector(0, 15, 6))).cut(
            Part.makeBox(60, 20, 5, Vector(0, 10, 6))
        ),
        6.01,
        60 * 30,
    ),
    "a cone": (Part.makeCone(10, 5, 20), 10, math.pi * 7.5**2),
    "a cone on its tip": (Part.makeCone(5, 10, 20), 1, math.pi * 10**2),
    "round a conical hole": (
        BOX.cut(Part.makeCone(5, 10, 20, Vector(30, 20, 0))),
        10,
        2400 - math.pi * 7.5**2,
    ),
    "a sphere below its middle": (Part.makeSphere(10, Vector(0, 0, 5)), 1, math.pi * 100),
    "a sphere above its middle": (Part.makeSphere(10, Vector(0, 0, 5)), 10, math.pi * 75),
    "a cylinder that lies": (Part.makeCylinder(5, 30, Vector(0, 0, 5), Vector(1, 0, 0)), 1, 300),
    "over a cross hole": (
        BOX.cut(Part.makeCylinder(5, 99, Vector(-9, 20, 10), Vector(1, 0, 0))),
        1,
        2400,
    ),
    "a torus": (Part.makeTorus(10, 3), -2, math.pi * (13**2 - 7**2)),
    "a frustum half way up": (_frustum(), 10, 47 * 27),
    "a block that leans": (_tilted(), -8, 10 * SLANTED),
    "a cylinder that leans": (_skewed(), 0.001, math.pi * 40 + 4 * 10),
}


def _stepped():
    """A plate with a T-slot, a deep step and a round hole."""
    plate = Part.makeBox(80, 50, 20).cut(Part.makeBox(80, 10, 20, Vector(0, 20, 6)))
    plate = plate.cut(Part.makeBox(80, 20, 5, Vector(0, 15, 6)))
    plate = plate.cut(Part.makeBox(10, 6, 30, Vector(40, 40, 12)))
    return plate.cut(Part.makeCylinder(5, 30, Vector(15, 8, 10)))


@pytest.mark.parametrize("askew", [3e-9, 1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 1e-5])
@pytest.mark.parametrize("along", [Vector(1, 0, 0), Vector(1, 1, 0), Vector(1, 0.3, 0)])
def test_what_lies_askew_by_rounding_stands_where_it_would_stand_straight(askew, along):
    shape = _stepped()
    shape.rotate(Vector(20, 15, 0), along, math.degrees(askew))
    for z, area in ((3, 4000), (6.01, 3200), (11.5, 3200 - 25 * math.pi), (19.9, 3061.46)):
        faces = body.Body(shape).standing(z)
        assert sum(face.Area for face in faces) == pytest.approx(area, abs=0.05)


@pytest.mark.parametrize("shape, z, area", STANDING.values(), ids=STANDING)
def test_the_ground_over_which_a_body_stands(shape, z, area):
    faces = body.Body(shape).standing(z)
    assert sum(face.Area for face in faces) == pytest.approx(area, rel=5e-4, abs=1e-6)
    for i, face in enumerate(faces):
        assert all(face.common(other).Area < 1e-6 for other in faces[:i])


@pytest.mark.parametrize("shape, z, area", STANDING.values(), ids=STANDING)
def test_standing_ground_and_heights_agree(shape, z, area):
    each = body.Body(shape)
    polygons = each.outlines(z)[1]
    box = shape.BoundBox
    random_ = numpy.random.default_rng(1)
    points = random_.uniform((box.XMin, box.YMin), (box.XMax, box.YMax), (200, 2))
    tops = numpy.array([each.map.top_at(x, y) for x, y in points])
    stands = inside(points, polygons)
    # Near a border, or where a slope passes the height, rounding decides.
    sure = numpy.abs(tops - z) > 0.05
    border = numpy.vstack([numpy.zeros((0, 2)), *polygons])
    away = numpy.array([numpy.hypot(*(border - p).T).min(initial=9.0) for p in points])
    sure &= away > 0.3
    assert (stands == (tops > z))[sure].all()
    assert sure.sum() > 50 or z == box.ZMax


def test_a_prismatic_body_is_the_same_as_its_prisms():
    shape = STANDING["round a pocket"][0]
    each = body.Body(shape)
    stock = compiled.core().DexelStock(each.prisms(), 0.0, 0.5)
    assert stock.volume == pytest.approx(shape.Volume, rel=1e-6)
    assert body.Body(_frustum()).prisms() is None


def test_a_body_that_leans_has_its_volume_in_dexels():
    stock = compiled.core().DexelStock(body.Body(_frustum()).map, 0.0, 0.1)
    assert stock.volume == pytest.approx(_frustum().Volume, rel=5e-3)
    assert stock.volume > _frustum().Volume  # where in doubt it stands


def test_a_body_is_remembered_as_long_as_its_shape_is_the_same():
    moved = BOX.copy()
    assert body.of(BOX) is body.of(BOX)
    moved.translate(Vector(1, 0, 0))
    assert body.of(moved) is not body.of(BOX) and body.of(moved).box.XMin == 1


def test_points_of_edges_are_near_each_other_and_uprights_have_their_upper_end():
    points = body.Body(BOX).edge_points((-1, -1, -1), (99, 99, 99), 0.5)
    top = points[abs(points[:, 2] - 20) < 1e-9]
    assert len(top) >= 2 * (60 + 40) / 0.5
    assert all(min(abs(z), abs(z - 20)) < 1e-9 for z in points[:, 2])
    cone = body.Body(Part.makeCone(10, 5, 20))
    section = cone.section_points([10], (-99, -99, -1), (99, 99, 99), 0.5)
    assert numpy.hypot(section[:, 0], section[:, 1]) == pytest.approx(7.5, abs=1e-6)


def test_a_countersink_has_no_more_triangles_than_its_distance_asks_for():
    """FreeCAD's own tessellation makes 13 000 of it: parts with dozens of them took a minute."""
    cone = Part.makeCone(1, 3, 9)
    points, triangles = in_plane.triangles_of(cone, body.COARSE)
    assert len(triangles) < 2500
    middles = [sum((points[k] for k in triangle), Vector()) / 3 for triangle in triangles]
    assert max(cone.distToShape(Part.Vertex(p))[0] for p in middles[::7]) < 1.1 * body.COARSE
