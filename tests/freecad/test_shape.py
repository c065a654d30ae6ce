"""Base geometry becomes the same regions in whatever order it was picked."""

from itertools import permutations

import Part
import pytest
from evenload import planar
from evenload.geometry import open_edges, shape
from FreeCAD import Vector
from models import circle, face_of, rectangle

pytestmark = pytest.mark.between


def faces_of(doc, name, *chains, z=0.0):
    """An object whose Face1, Face2, ... are the chains' faces at a height."""
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = Part.Compound([face_of(chain).translated(Vector(0, 0, z)) for chain in chains])
    return obj


def floors(base):
    return shape.floors(base, [], None, 6.0, 0.005)


LEFT, MIDDLE, RIGHT = (rectangle(x, 0, x + 10, 20) for x in (0, 10, 20))


@pytest.mark.parametrize("order", permutations(["Face1", "Face2", "Face3"]), ids=",".join)
def test_a_row_of_faces_is_one_region_in_whatever_order_it_was_picked(doc, order):
    row = faces_of(doc, "Row", LEFT, MIDDLE, RIGHT)
    (floor,) = floors([(row, order)])
    assert floor.name == "Face1, Face2, Face3 of Row"
    assert floor.region().area == pytest.approx(600) and floor.islands == []
    assert floor.outer == floors([(row, ("Face1", "Face2", "Face3"))])[0].outer
    assert len(floor.outer) == 4


@pytest.mark.parametrize("order", permutations(range(4)))
def test_faces_round_a_gap_are_one_region_with_an_island(doc, order):
    sides = [
        rectangle(0, 0, 30, 10),
        rectangle(0, 20, 30, 30),
        rectangle(0, 10, 10, 20),
        rectangle(20, 10, 30, 20),
    ]
    frame = faces_of(doc, "Frame", *sides)
    (floor,) = floors([(frame, ["Face%d" % (k + 1) for k in order])])
    assert floor.region().area == pytest.approx(800)
    assert len(floor.outer) == 4 and [len(island) for island in floor.islands] == [4]


@pytest.mark.parametrize("order", permutations(range(3)))
def test_faces_of_several_objects_are_one_region(doc, order):
    objects = [faces_of(doc, *item) for item in (("A", LEFT), ("B", MIDDLE), ("C", RIGHT))]
    (floor,) = floors([(objects[k], ("Face1",)) for k in order])
    assert floor.name == "Face1 of A and Face1 of B and Face1 of C"
    assert floor.region().area == pytest.approx(600)


def test_faces_are_named_by_number_and_regions_come_as_they_were_picked(doc):
    row = faces_of(doc, "Row", *(rectangle(3 * k, 0, 3 * k + 3, 20) for k in range(10)))
    first, second = floors([(row, ("Face10", "Face2", "Face1", "Face9", "Face8"))])
    assert first.name == "Face8, Face9, Face10 of Row"
    assert second.name == "Face1, Face2 of Row"


@pytest.mark.parametrize(
    "chain, z",
    [
        (rectangle(10, 20, 20, 40), 0),  # touches at a corner
        (rectangle(10, 0, 20, 20), 0.5),  # at another height
        (circle(40, 10, 5), 0),  # far away
    ],
)
def test_faces_that_share_no_edge_stay_apart(doc, chain, z):
    a, b = faces_of(doc, "A", LEFT), faces_of(doc, "B", chain, z=z)
    assert [f.name for f in floors([(a, ("Face1",)), (b, ("Face1",))])] == [
        "Face1 of A",
        "Face1 of B",
    ]


def test_the_edges_of_an_object_belong_together_though_others_were_picked_between(doc):
    a, b = faces_of(doc, "A", LEFT), faces_of(doc, "B", RIGHT)
    halves = ("Edge1", "Edge3"), ("Edge2", "Edge4")
    first, second = floors([(a, halves[0]), (b, ("Face1",)), (a, halves[1])])
    assert first.name == "4 edges of A" and not first.is_face
    assert first.region().area == pytest.approx(200)
    assert second.name == "Face1 of B"


def test_points_of_a_chain_stay_near_its_arcs():
    for chain in (circle(3, 4, 5), [(0, 0, -0.4), (10, 0, 3.0), (4, 8, 0)]):
        points = planar.flattened(chain)
        area = face_of(chain).Area
        assert abs(_area(points)) == pytest.approx(area, abs=0.3)
        wire = face_of(chain).OuterWire
        for a, b in zip(points, [*points[1:], points[0]]):
            middle = Part.Vertex(*(a + b) / 2, 0)
            assert wire.distToShape(middle)[0] <= planar.DEFLECTION + 1e-9


def _area(points):
    pairs = zip(points, [*points[1:], points[0]])
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2


def judged(solid, name, found=None):
    """The one floor of a solid's face: as it is, or with what enclosed() says set to `found`."""
    with pytest.MonkeyPatch.context() as patch:
        if found is not None:
            patch.setattr(open_edges, "enclosed", lambda *_: found)
        made = shape.floors([(solid, (name,))], [solid.Shape], solid.Shape, 6.0, 0.005)
    return made[0]


def solid_of(doc, made):
    obj = doc.addObject("Part::Feature", "Solid")
    obj.Shape = made
    return obj


def name_of_floor(solid, z):
    levels = [face.BoundBox for face in solid.Shape.Faces]
    (number,) = [k for k, b in enumerate(levels, 1) if max(abs(b.ZMin - z), abs(b.ZMax - z)) < 1e-6]
    return "Face%d" % number


@pytest.mark.parametrize(
    "cut_away",
    [rectangle(10, 10, 40, 30), circle(25, 20, 12), rectangle(-5, 10, 40, 30)],
    ids=["closed", "round", "open on the left"],
)
def test_walls_that_stand_on_a_floors_edges_count_as_sections_of_the_model_do(doc, cut_away):
    pocket = face_of(cut_away).extrude(Vector(0, 0, 10)).translated(Vector(0, 0, 6))
    post = Part.makeCylinder(2, 4, Vector(25, 20, 6))
    solid = solid_of(doc, Part.makeBox(50, 40, 10).cut(pocket.cut(post)))
    name = name_of_floor(solid, 6)
    quick, slow = judged(solid, name), judged(solid, name, found=False)
    assert (quick.outer, quick.islands, quick.notes) == (slow.outer, slow.islands, slow.notes)
    assert len(quick.islands) == 1
    assert quick.enclosed == all(not piece[3] for piece in slow.outer)


def test_a_face_that_looks_down_is_refused(doc):
    block = solid_of(doc, Part.makeBox(50, 40, 10))
    with pytest.raises(ValueError, match="looks down: pick a face that looks up"):
        judged(block, name_of_floor(block, 0))


def test_a_floor_with_sloping_or_shallow_walls_is_left_to_the_sections(doc):
    sloping = Part.makeBox(50, 40, 10).cut(Part.makeCone(8, 10, 4, Vector(25, 20, 6)))
    shallow = Part.makeBox(50, 40, 10).cut(Part.makeCylinder(8, 0.015, Vector(25, 20, 9.985)))
    for made, z in ((sloping, 6), (shallow, 9.985)):
        solid = solid_of(doc, made)
        assert not judged(solid, name_of_floor(solid, z)).enclosed
