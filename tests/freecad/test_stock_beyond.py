"""Floors with sides that have no wall go on where stock stands beyond these."""

import math
import random
import time

import numpy
import Part
import pytest
from evenload import compiled, planar, simulation
from evenload.geometry import floor, ground_beside, shape, stock_beyond
from FreeCAD import Vector
from models import face_of, floors_of, rectangle, sketch_of

pytestmark = pytest.mark.between

TOOL, Z = 6.0, -3.0


def block(x0, y0, x1, y1, top=0.0, bottom=-10.0):
    return Part.makeBox(x1 - x0, y1 - y0, top - bottom, Vector(x0, y0, bottom))


def floors_in(doc, part, stock, levels=(Z,), others=(), **options):
    """All floors at some heights of a part in its stock; others: more base geometry."""
    obj = doc.addObject("Part::Feature", "Part")
    obj.Shape = part
    names = tuple(name for z in levels for name in floors_of(part, z))
    return shape.floors([(obj, names), *others], [part], stock, TOOL, 0.005, **options)


def floor_of(doc, part, stock, **options):
    """The one floor at Z of a part in its stock."""
    (found,) = floors_in(doc, part, stock, **options)
    return found


def cleared(bench, part, margin=0.0):
    """The operation that clears all floors at Z, in a box of stock that is larger than the part by
    a margin, and its simulation.
    """
    on = bench(part, tool=TOOL)
    for side in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos"):
        setattr(on.job.Stock, side, margin)
    op = on.operation([(on.model, tuple(floors_of(part, Z)))], FinalDepth=Z, StepDown=-Z)
    on.done(op)
    return op, simulation.of(op)


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
    note = "".join(floor.notes)
    if margin == 1:
        assert note == ""  # nothing is left, nor is anything cleared far away
    else:
        assert note.startswith("Face3 of Part has stock beyond 3 sides without a wall, the first")
        distance = round(math.sqrt(2) * margin, 3)
        assert note.endswith("to the edge of the stock, up to %g mm from the face." % distance)


def test_a_step_without_stock_beyond_is_left_as_it_is(doc):
    floor = floor_of(doc, step(), block(0, 0, 40, 30))
    assert floor.region().area == pytest.approx(800) and floor.notes == []
    assert is_open(floor, 20, 0) and not is_open(floor, 20, 20)


def test_in_much_larger_stock_a_step_goes_on_by_the_tools_radius_and_is_closed(doc):
    floor = floor_of(doc, step(), block(-100, -100, 140, 130))
    assert box_of(floor) == [-3, -3, 43, 20]
    assert not any(vertex[3] for vertex in floor.outer)
    (note,) = floor.notes
    assert note.endswith("up to 3 mm from the face, and what lies further out stays.")


def test_it_goes_on_by_the_diameter_where_a_boss_at_the_edge_leaves_no_way_round(doc):
    floor = floor_of(doc, step([(15, 0.5, 25, 10)]), block(-100, -100, 140, 130))
    assert box_of(floor) == [-6, -6, 46, 20]


def test_a_slot_across_the_stock_leaves_a_floor_in_one_piece(doc):
    stock = block(-1, -1, 41, 31).cut(block(18, -2, 22, 21, bottom=-5))
    floor = floor_of(doc, step(), stock)
    assert floor.region().area == pytest.approx(42 * 21 - 4) and floor.notes == []


@pytest.mark.parametrize("end, box", [(-4.5, [-6, -6, 46, 20]), (-8, [-3, -3, 43, 20])])
def test_a_slot_that_ends_in_much_larger_stock_is_no_obstacle(doc, end, box):
    stock = block(-100, -100, 140, 130).cut(block(18, end, 22, 20, bottom=-5))
    assert box_of(floor_of(doc, step(), stock)) == box


def test_a_gap_in_the_stock_is_no_island(doc):
    stock = block(-10, -10, 50, 40).cut(block(18, -8, 22, 20, bottom=-5))
    floor = floor_of(doc, step(), stock)
    assert floor.islands == [] and floor.region().area == pytest.approx(60 * 30)


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
    assert box_of(floor)[3] == 19
    assert not is_open(floor, 20, 19)


def test_ground_behind_a_wall_beside_a_notched_side_is_left_alone(bench):
    part = step().cut(Part.makeCylinder(4, 20, Vector(40, 14, -15)))
    op, run = cleared(bench, part, 1.0)
    assert box_of(op.Proxy.last.floors[0]) == [-1, -1, 41, 20]
    assert run.rest_area == 0 and run.gouge_mm == 0


def test_a_thin_wall_is_not_passed_through_a_notch_beside_it(doc):
    part = block(0, 0, 40, 22).cut(block(0, 0, 40, 20, bottom=Z))
    part = part.cut(Part.makeCylinder(5, 20, Vector(40, 14, -15)))
    floor = floor_of(doc, part, block(-5, -5, 45, 27))
    assert box_of(floor) == [-5, -5, 45, 20]


def test_a_shelf_goes_on_between_walls_that_run_on_past_it(bench):
    part = block(-10, -40, 50, 30).cut(block(0, 0, 40, 20, bottom=Z))
    part = part.cut(block(0, -30, 40, 0, bottom=-6))
    op, run = cleared(bench, part)
    assert box_of(op.Proxy.last.floors[0]) == [0, -3, 40, 20]
    assert run.rest_area == 0 and run.gouge_mm == 0


def test_a_side_where_the_ground_ends_at_walls_goes_on_no_further_than_it_must(doc):
    part = block(-10, -20, 50, 30).cut(block(0, 0, 40, 20, bottom=Z))
    part = part.cut(block(0, -8, 40, 0, bottom=-6))
    assert box_of(floor_of(doc, part, block(-10, -20, 50, 30))) == [0, -3, 40, 20]


def plateaus(gap, walls=False, boss=False):
    """Two floors at Z, 20 mm wide, 25 and 27 mm long with a gap of so many mm between them."""
    start = 25 + gap
    end = start + 27
    part = block(0, 0, end, 20, top=-6)
    part = part.fuse([block(x0, 0, x1, 20, top=Z, bottom=-7) for x0, x1 in [(0, 25), (start, end)]])
    if walls:
        part = part.fuse([block(0, 0, 3, 20, bottom=-7), block(end - 3, 0, end, 20, bottom=-7)])
    if boss:
        part = part.fuse(block(8, 8, 12, 12, bottom=-4))
    return part.removeSplitter()


def test_two_floors_that_meet_when_they_go_on_become_one(bench):
    op, run = cleared(bench, plateaus(4, walls=True))
    (found,) = op.Proxy.last.floors
    assert box_of(found) == [3, 0, 53, 20] and found.notes == []
    assert found.name == "Face6, Face7 of Model-Part"
    assert run.rest_area == 0 and run.gouge_mm == 0
    assert op.RemovedVolume.Value == pytest.approx(3000, rel=1e-3)


def test_a_floor_within_another_that_has_gone_on_is_part_of_it(bench):
    op, run = cleared(bench, plateaus(8, boss=True))
    (found,) = op.Proxy.last.floors
    assert found.region().area == pytest.approx(1184) and found.notes == []
    assert all(vertex[3] for vertex in found.outer)
    assert op.RemovedVolume.Value == pytest.approx(3552, rel=1e-3)
    assert run.rest_area < 0.1 and run.gouge_mm == 0


def test_two_floors_without_walls_are_cleared_as_one(doc):
    found = floor_of(doc, plateaus(8), block(0, 0, 60, 20))
    assert found.region().area == pytest.approx(1200) and found.notes == []
    assert all(vertex[3] for vertex in found.outer)


def test_two_floors_that_do_not_meet_stay_two_and_report_names_what_stays(doc):
    found = floors_in(doc, plateaus(8, walls=True), block(0, 0, 60, 20))
    # FreeCAD 0.20 and 1.0 number the two faces differently.
    found.sort(key=lambda floor: min(vertex[0] for vertex in floor.outer))
    assert [box_of(floor) for floor in found] == [[3, 0, 28, 20], [30, 0, 57, 20]]
    for each in found:
        (note,) = each.notes
        assert note.startswith(each.name) and note.endswith("what lies further out stays.")


def test_a_floor_goes_on_over_a_lower_one_beside_it_and_that_stays_as_it_is(doc):
    part = block(-10, -40, 50, 30).cut(block(0, 0, 40, 20, bottom=Z))
    part = part.cut(block(0, -30, 40, 0, bottom=-6))
    found = floors_in(doc, part, block(-10, -40, 50, 30), levels=(Z, -6))
    assert [box_of(floor) for floor in found] == [[0, -TOOL, 40, 20], [0, -30, 40, 0]]
    assert found[1].notes == []


def one_depth(z, is_face):
    return Z / 2


def test_a_floor_leaves_one_at_another_height_alone_that_is_cut_as_deep(doc):
    part = block(-10, -40, 50, 30).cut(block(0, 0, 40, 20, bottom=Z))
    part = part.cut(block(0, -30, 40, 0, bottom=-6))
    stock = block(-10, -40, 50, 30)
    found = floors_in(doc, part, stock, levels=(Z, -6), depth_of=one_depth)
    assert [box_of(floor) for floor in found] == [[0, 0, 40, 20], [0, -30, 40, 0]]
    (note,) = found[0].notes
    assert "no further than that side" in note and "another face" in note


def test_floors_that_meet_over_a_lower_one_become_one_and_that_goes_on_as_they_do(doc):
    part = block(0, 0, 60, 30).cut(block(0, 0, 60, 20, bottom=Z))
    part = part.cut(block(25, 0, 33, 20, bottom=-6))
    found = floors_in(doc, part, block(-1, -1, 61, 31), levels=(Z, -6))
    assert [box_of(floor) for floor in found] == [[-1, -1, 61, 20], [25, -1, 33, 20]]
    assert [floor.notes for floor in found] == [[], []]


def test_a_floor_that_would_meet_one_at_another_height_that_has_gone_on_stays_as_it_is(doc):
    part = block(0, 0, 60, 30).cut(block(0, 0, 60, 20, bottom=Z))
    part = part.cut(block(25, 0, 33, 20, bottom=-6))
    stock = block(-1, -1, 61, 31)
    found = floors_in(doc, part, stock, levels=(Z, -6), depth_of=one_depth)
    assert [box_of(floor)[1] for floor in found] == [-1, -1, 0]
    (note,) = found[2].notes
    assert note.startswith(found[2].name) and found[0].name in note
    assert found[2].outer[0][3] is False


def test_a_floor_leaves_a_sketch_beside_it_alone(doc):
    sketch = sketch_of(doc, rectangle(10, -12, 30, -2), z=Z)
    found = floors_in(doc, step(), block(-100, -100, 140, 130), others=[(sketch, ("",))])
    assert box_of(found[0]) == [-3, -3, 43, 20] and box_of(found[1]) == [10, -12, 30, -2]
    assert found[0].region().area == pytest.approx(1054.137 - 20, abs=0.01)


def test_an_operation_that_cannot_take_it_gets_no_outline_open_beside_walls(doc):
    for margin in (1, 30):
        stock = block(-margin, -margin, 40 + margin, 30 + margin)
        floor = floor_of(doc, step(), stock, partly_open=False)
        assert box_of(floor) == [-3, -3, 43, 20]
        assert not any(vertex[3] for vertex in floor.outer)
        assert len(floor.notes) == (margin > TOOL)


def test_of_a_post_beyond_nothing_is_cleared_where_a_line_cuts_off_less_than_chords_show(doc):
    post = Part.makeCylinder(2, 6, Vector(45, 21.997, -6))  # the ground ends at y = 20 there
    part = step().fuse([block(-30, -30, 70, 50, top=-6), post]).removeSplitter()
    found = floor_of(doc, part, block(-10, -10, 50, 40))
    assert box_of(found) == [-10, -10, 50, 20]
    section = Part.Face(Part.Wire(Part.Circle(Vector(45, 21.997, Z), Vector(0, 0, 1), 2).toShape()))
    assert floor.face_of(found).common(section).Area < 1e-9


def test_edges_that_divide_nothing_leave_no_trace_in_a_face():
    face = face_of(rectangle(0, 0, 10, 10))
    loose, across = (Part.makeLine((5, 5, 0), (5, y, 0)) for y in (8, 20))
    (whole,) = ground_beside.split([face], [loose])
    assert len(whole.Edges) == 4 and whole.Area == pytest.approx(100)
    (whole,) = ground_beside.split([face], [across])
    assert all(edge.Orientation != "Internal" for edge in whole.Edges)
    assert whole.Area == pytest.approx(100)


def ellipse():
    return Part.Face(Part.Wire(Part.Ellipse(Vector(20, 8, Z), 7, 4).toShape()))


@pytest.mark.parametrize(
    "boss", [Part.makeCone(6, 4, 3, Vector(20, 9, Z)), ellipse().extrude(Vector(0, 0, 3))]
)
def test_islands_of_the_floor_stay_exactly_as_they_are(doc, boss):
    part = step().fuse(boss).removeSplitter()
    alone, beyond = (floor_of(doc, part, block(-m, -m, 40 + m, 30 + m)) for m in (0, 1))
    assert beyond.islands == alone.islands and beyond.slack == alone.slack
    assert beyond.region().area == pytest.approx(alone.region().area + 82)


def test_a_curve_that_stands_beyond_is_followed_within_the_tolerance_that_the_tool_allows_for(doc):
    post = ellipse().translated(Vector(0, -17, -3)).extrude(Vector(0, 0, 6))
    part = step().fuse([block(-30, -30, 70, 30, top=-6), post]).removeSplitter()
    found = floor_of(doc, part, block(-10, -10, 50, 30))
    straight = floor_of(doc, step(), block(-5, -5, 45, 30))
    assert straight.slack == 0 and found.slack == 0.005 * floor.CURVE_SHARE


@pytest.mark.parametrize("kind", ["core", "FreeCAD"])
def test_a_floor_stays_as_it_is_where_the_ground_beyond_has_errors(doc, monkeypatch, kind):
    def fail(*_):
        if kind == "core":
            core = compiled.core()
            core.Region([(0, 0, 0), (9, 9, 0), (9, 0, 0), (0, 9, 0)], [])  # crosses itself
        raise Part.OCCError("no such face")

    monkeypatch.setattr(stock_beyond, "beside_bare", fail)
    found = floor_of(doc, step(), block(-1, -1, 41, 31))
    assert found.region().area == pytest.approx(800) and not found.grown
    (note,) = found.notes
    assert note.startswith("Face3 of Part has stock beyond 3 sides") and "not cleared" in note


def zigzag(pieces):
    """A step with a wall along its far side and so many pieces along its near one."""
    near = [(200 * i / pieces, -(i % 2), 0) for i in range(pieces + 1)]
    low = face_of(near + [(200, 20, 0), (0, 20, 0)]).extrude(Vector(0, 0, -7))
    return low.translated(Vector(0, 0, Z)).fuse(block(0, 20, 200, 30)).removeSplitter()


def test_the_time_grows_little_faster_than_the_number_of_edges(doc):
    times = []
    for pieces in (50, 200):
        part, stock = zigzag(pieces), block(-1, -5, 201, 31)
        start = time.process_time()
        assert floor_of(doc, part, stock).region().area == pytest.approx(202 * 25)
        times.append(time.process_time() - start)
    assert times[1] < 12 * times[0]  # 4 times as many; strip by strip it was 64 times the time


@pytest.mark.parametrize("at_once", [50, floor.AT_ONCE])
def test_points_are_found_inside_whichever_way_rays_go(monkeypatch, at_once):
    monkeypatch.setattr(floor, "AT_ONCE", at_once)
    chance = random.Random(1)
    points = numpy.array([(chance.uniform(-1, 21), chance.uniform(-1, 3)) for _ in range(300)])
    near = [(0.2 * i, chance.uniform(0, 1), 0) for i in range(100)]
    chains = [near + [(20, 2, 0.3), (0, 2, 0)], rectangle(5.03, 1.2, 9.1, 1.7)]
    found = floor.inside(points, [planar.flattened(chain) for chain in chains])
    (face,) = face_of(chains[0], chains[1:]).Faces
    expected = [face.isInside(Vector(*point, 0), 1e-9, True) for point in points]
    edges = Part.Compound(face.Wires)
    near_edge = [edges.distToShape(Part.Vertex(*p, 0))[0] < 0.006 for p in points]
    assert all(near_edge[k] or found[k] == expected[k] for k in range(len(points)))
    assert 100 < sum(found) < 250


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
    assert "to the edge of the stock" in op.Report  # at its corners that is far from the teeth
