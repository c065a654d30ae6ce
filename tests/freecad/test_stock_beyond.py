"""Floors with sides that have no wall go on where stock stands beyond these."""

import math

import Part
import pytest
from evenload import shape
from FreeCAD import Vector
from models import face_of, floors_of, rectangle

TOOL, Z = 6.0, -3.0


def block(x0, y0, x1, y1, top=0.0, bottom=-10.0):
    return Part.makeBox(x1 - x0, y1 - y0, top - bottom, Vector(x0, y0, bottom))


def floor_of(doc, part, stock):
    """The one floor at Z of a part in its stock."""
    obj = doc.addObject("Part::Feature", "Part")
    obj.Shape = part
    names = tuple(floors_of(part, Z))
    (found,) = shape.floors([(obj, names)], [part], stock, TOOL, 0.005)
    return found


def step(bosses=()):
    """40 by 20 mm, with a wall along its far side."""
    part = block(0, 0, 40, 30).cut(block(0, 0, 40, 20, bottom=Z))
    for boss in bosses:
        part = part.fuse(block(*boss, bottom=Z))
    return part.removeSplitter()


def box_of(floor):
    points = [vertex[:2] for vertex in floor.outer]
    return [pytest.approx(f(p[k] for p in points)) for f in (min, max) for k in (0, 1)]


def is_open(floor, x, y):
    """Whether the piece of the outer chain whose middle is nearest to (x, y) is open."""
    pairs = zip(floor.outer, floor.outer[1:] + floor.outer[:1])
    return min((math.dist(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), (x, y)), a[3]) for a, b in pairs)[
        1
    ]


@pytest.mark.parametrize("margin", [1.0, 5.0, 10.0])
def test_a_step_goes_on_to_the_edge_of_stock_that_ends_near_it_and_is_open_there(doc, margin):
    floor = floor_of(doc, step(), block(-margin, -margin, 40 + margin, 30 + margin))
    assert box_of(floor) == [-margin, -margin, 40 + margin, 20]
    assert is_open(floor, 20, -margin) and is_open(floor, -margin, 5)
    assert not is_open(floor, 20, 20)
    (note,) = floor.notes
    assert "stock beyond 3 of its open sides" in note and note.endswith("cleared beyond them.")


def test_a_step_without_stock_beyond_is_left_as_it_is(doc):
    floor = floor_of(doc, step(), block(0, 0, 40, 30))
    assert floor.region().area == pytest.approx(800) and floor.notes == []
    assert is_open(floor, 20, 0) and not is_open(floor, 20, 20)


def test_in_much_larger_stock_a_step_goes_on_by_the_tools_radius_and_is_closed(doc):
    floor = floor_of(doc, step(), block(-100, -100, 140, 130))
    assert box_of(floor) == [-3, -3, 43, 20]
    assert not any(vertex[3] for vertex in floor.outer)


def test_it_goes_on_by_the_diameter_where_a_boss_at_the_edge_leaves_no_way_round(doc):
    floor = floor_of(doc, step([(15, 0.5, 25, 10)]), block(-100, -100, 140, 130))
    assert box_of(floor) == [-6, -6, 46, 20]


def test_a_floor_of_which_the_stock_holds_two_pieces_stays_as_it_is(doc):
    stock = block(-1, -1, 41, 31).cut(block(18, -2, 22, 21, bottom=-5))  # an old slot across it
    floor = floor_of(doc, step(), stock)
    assert floor.region().area == pytest.approx(800)
    (note,) = floor.notes
    assert note.endswith("it is cleared no further than them.")


def test_nothing_is_cleared_beyond_a_thin_wall(doc):
    part = block(0, 0, 40, 30).cut(block(1, -1, 40, 20, bottom=Z))  # its wall ends with the step
    floor = floor_of(doc, part, block(-20, -0.5, 41, 30))
    assert box_of(floor) == [1, -0.5, 41, 20]
    assert is_open(floor, 41, 10)


def test_walls_that_rise_from_a_fillet_keep_their_foot(doc):
    part = step()
    (foot,) = [
        edge
        for edge in part.Edges
        if abs(edge.BoundBox.YMin - 20) < 1e-6
        and abs(edge.BoundBox.YMax - 20) < 1e-6
        and abs(edge.BoundBox.ZMin - Z) < 1e-6
        and abs(edge.BoundBox.ZMax - Z) < 1e-6
    ]
    part = part.makeFillet(1.0, [foot])
    floor = floor_of(doc, part, block(-1, -1, 41, 31))
    assert box_of(floor)[0] == -1 and is_open(floor, 20, -1)
    inner = [y for x, y, *_ in floor.outer if 0 <= x <= 40 and y > 10]
    assert inner and max(inner) == pytest.approx(19, abs=0.1)
    assert not is_open(floor, 20, 19)


def test_a_floor_with_nothing_but_bosses_is_cleared_to_the_edge_of_the_stock(bench):
    gear = []
    for k in range(12):
        for turn, radius in ((-0.17, 21), (-0.14, 30), (0.14, 30), (0.17, 21)):
            angle = math.pi * k / 6 + turn
            gear.append((radius * math.cos(angle), radius * math.sin(angle), 0))
    bosses = [rectangle(-14, -14, -4, -6), rectangle(5, -8, 18, 4)]  # beside the teeth
    floor = face_of(gear).extrude(Vector(0, 0, -7)).translated(Vector(0, 0, Z))
    part = floor.fuse([block(*boss[0][:2], *boss[2][:2], bottom=Z) for boss in bosses])
    part = part.removeSplitter()
    on = bench(part, tool=TOOL)
    op = on.operation([(on.model, tuple(floors_of(part, Z)))], FinalDepth=Z)
    on.done(op)
    assert op.UncutArea.Value == 0
    box = part.BoundBox
    left = sum(face_of(boss).Area for boss in bosses)
    assert op.Proxy.last.regions[0].area == pytest.approx(box.XLength * box.YLength - left)
    assert all(vertex[3] for vertex in op.Proxy.last.floors[0].outer)
