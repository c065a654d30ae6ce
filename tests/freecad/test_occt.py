"""Regions from shapes: what _occt reads from faces, wires and sketches, and what it refuses."""
import math
import random
import sysconfig

import FreeCAD
import Part
import pytest
from evenload import compiled
from FreeCAD import Vector

_occt = compiled.occt()
TOLERANCE = 0.005


def regions(shape, tolerance=TOLERANCE):
    return _occt.regions_from_brep(shape.exportBrepToString(), tolerance)


def refusal(shape):
    with pytest.raises(_occt.ShapeError) as caught:
        regions(shape)
    return caught.value


def pieces(chain):
    """(start, end, bulge) of every piece of a closed chain."""
    for (x0, y0, bulge, _), (x1, y1, _, _) in zip(chain, chain[1:] + chain[:1]):
        yield (x0, y0), (x1, y1), bulge


def area(chain):
    total = 0.0
    for (x0, y0), (x1, y1), bulge in pieces(chain):
        total += 0.5 * (x0 * y1 - x1 * y0)
        if bulge:
            sweep = 4 * math.atan(bulge)
            radius = math.hypot(x1 - x0, y1 - y0) / (2 * math.sin(sweep / 2))
            total += 0.5 * radius**2 * (sweep - math.sin(sweep))
    return total


def points(chain, per_piece=8):
    for (x0, y0), (x1, y1), bulge in pieces(chain):
        dx, dy = x1 - x0, y1 - y0
        for i in range(per_piece):
            t = i / per_piece
            if not bulge:
                yield x0 + t * dx, y0 + t * dy
                continue
            k = (1 - bulge**2) / (4 * bulge)
            cx, cy = (x0 + x1) / 2 - k * dy, (y0 + y1) / 2 + k * dx
            angle = math.atan2(y0 - cy, x0 - cx) + 4 * math.atan(bulge) * t
            radius = math.hypot(x0 - cx, y0 - cy)
            yield cx + radius * math.cos(angle), cy + radius * math.sin(angle)


def kinks(chain):
    """The change of direction at every vertex, in radians."""
    directions = []
    for (x0, y0), (x1, y1), bulge in pieces(chain):
        chord, half = math.atan2(y1 - y0, x1 - x0), 2 * math.atan(bulge)
        directions.append((chord - half, chord + half))
    for before, after in zip(directions, directions[1:] + directions[:1]):
        yield abs(math.remainder(after[0] - before[1], 2 * math.pi))


def spline(corners):
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(x, y, 0) for x, y in corners], PeriodicFlag=True)
    return curve


def plate():
    """A plate of 60 x 40 mm at z = 7 with rounded corners, a round hole and a slot."""
    solid = Part.makeBox(60, 40, 7)
    solid = solid.makeFillet(
        5, [e for e in solid.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
    )
    solid = solid.cut(Part.makeCylinder(4, 7, Vector(15, 20, 0)))
    return solid.cut(Part.makeBox(20, 6, 7, Vector(30, 17, 0)))


def level_faces(solid, z):
    return [f for f in solid.Faces if f.BoundBox.ZLength < 1e-9 and abs(f.BoundBox.ZMin - z) < 1e-9]


def test_a_face_gives_its_outline_and_islands_exactly():
    (face,) = level_faces(plate(), 7)
    ((z, outer, islands),) = regions(face)
    assert z == pytest.approx(7, abs=1e-12)
    assert len(outer) == 8 and sorted(map(len, islands)) == [2, 4]
    assert abs(area(outer)) - sum(abs(area(i)) for i in islands) == pytest.approx(
        face.Area, rel=1e-12
    )
    bulges = sorted(abs(v[2]) for v in outer)
    assert bulges == pytest.approx([0] * 4 + [math.tan(math.pi / 8)] * 4, abs=1e-12)
    assert all(not v[3] for v in outer)


def test_a_face_that_looks_down_gives_the_same_as_one_that_looks_up():
    (up,), (down,) = level_faces(plate(), 7), level_faces(plate(), 0)
    (above,), (below,) = regions(up), regions(down)
    assert abs(area(above[1])) == pytest.approx(abs(area(below[1])), rel=1e-12)
    assert below[0] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("degrees", [0, 17, 90, 200])
def test_placements_are_followed(degrees):
    (face,) = level_faces(plate(), 7)
    face.Placement = FreeCAD.Placement(
        Vector(1000, -500, -12), FreeCAD.Rotation(Vector(0, 0, 1), degrees)
    )
    ((z, outer, islands),) = regions(face)
    assert z == pytest.approx(-5, abs=1e-9)
    assert abs(area(outer)) - sum(abs(area(i)) for i in islands) == pytest.approx(
        face.Area, rel=1e-9
    )
    for x, y in points(outer):
        assert Part.Vertex(x, y, -5).distToShape(face.OuterWire)[0] < 1e-9


def test_a_mirrored_face_keeps_its_arcs():
    (face,) = level_faces(plate(), 7)
    mirrored = face.mirror(Vector(0, 0, 0), Vector(1, 0, 0))
    ((_, outer, islands),) = regions(mirrored)
    assert abs(area(outer)) - sum(abs(area(i)) for i in islands) == pytest.approx(
        face.Area, rel=1e-12
    )


def test_a_full_circle_becomes_two_half_circles():
    ((_, outer, islands),) = regions(Part.makeCircle(5, Vector(3, 4, 0)))
    assert islands == []
    assert [abs(v[2]) for v in outer] == pytest.approx([1, 1], abs=1e-12)
    assert abs(area(outer)) == pytest.approx(25 * math.pi, rel=1e-12)


def test_an_arc_of_more_than_a_half_circle_is_split():
    arc = Part.Arc(Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 10), 0, 1.7 * math.pi).toShape()
    chord = Part.makeLine(arc.Vertexes[0].Point, arc.Vertexes[1].Point)
    ((_, outer, _),) = regions(Part.Compound([arc, chord]))
    assert len(outer) == 3
    expected = 50 * (1.7 * math.pi - math.sin(1.7 * math.pi))
    assert abs(area(outer)) == pytest.approx(expected, rel=1e-12)


def test_loose_edges_are_joined_in_any_order_and_sense():
    corners = [Vector(*c, -3) for c in [(0, 0), (30, 0), (30, 10), (12, 10), (12, 25), (0, 25)]]
    edges = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        edges.append(Part.makeLine(a, b) if len(edges) % 2 else Part.makeLine(b, a))
    random.Random(4).shuffle(edges)
    ((z, outer, _),) = regions(Part.Compound(edges))
    assert z == pytest.approx(-3)
    assert len(outer) == 6
    assert abs(area(outer)) == pytest.approx(30 * 10 + 12 * 15)


def test_ends_that_nearly_meet_are_joined():
    edges = [
        Part.makeLine(Vector(0, 0, 0), Vector(10, 0, 0)),
        Part.makeLine(Vector(10.0005, 0, 0), Vector(5, 8, 0)),
        Part.makeLine(Vector(5, 8, 0), Vector(0, 0.0005, 0)),
    ]
    ((_, outer, _),) = regions(Part.Compound(edges))
    assert len(outer) == 3


def test_a_tiny_edge_between_others_does_no_harm():
    corners = [(0, 0), (10, 0), (10.0004, 0.0002), (10, 10), (0, 10), (0, 0)]
    ((_, outer, _),) = regions(Part.makePolygon([Vector(*c, 0) for c in corners]))
    assert abs(area(outer)) == pytest.approx(100, rel=1e-3)


def test_wires_are_nested_in_turns():
    circles = [Part.makeCircle(r) for r in (5, 20, 3, 10)] + [Part.makeCircle(2, Vector(40, 0, 0))]
    found = regions(Part.Compound([Part.Wire([c]) for c in circles]))
    radii = [
        (math.sqrt(abs(area(o)) / math.pi), [math.sqrt(abs(area(i)) / math.pi) for i in islands])
        for _, o, islands in found
    ]
    assert [r[0] for r in radii] == pytest.approx([5, 20, 2])
    assert [r[1] for r in radii] == [pytest.approx([3]), pytest.approx([10]), []]


def test_wires_at_different_heights_are_not_nested():
    found = regions(Part.Compound([Part.makeCircle(20), Part.makeCircle(5, Vector(0, 0, -4))]))
    assert [(z, len(islands)) for z, _, islands in found] == [(0, 0), (-4, 0)]


def test_faces_and_sketches_come_together():
    (face,) = level_faces(plate(), 7)
    found = regions(Part.Compound([Part.makeCircle(3, Vector(100, 0, 7)), face]))
    assert [len(islands) for _, _, islands in found] == [2, 0]


@pytest.mark.parametrize("tolerance", [0.05, 0.005, 0.0002])
@pytest.mark.parametrize(
    "curve",
    [
        Part.Ellipse(Vector(0, 0, 0), 20, 8),
        Part.Ellipse(Vector(5, 5, 0), 20, 0.8),
        spline([(0, 0), (10, 3), (14, 12), (3, 9), (-6, 14), (-4, 2)]),
        Part.OffsetCurve(Part.Ellipse(Vector(0, 0, 0), 20, 12), 3, Vector(0, 0, 1)),
    ],
    ids=["ellipse", "flat ellipse", "spline", "offset"],
)
def test_other_curves_become_smooth_arcs_within_tolerance(curve, tolerance):
    edge = curve.toShape()
    ((_, outer, _),) = regions(edge, tolerance)
    assert max(kinks(outer)) < 1e-4
    for x, y in points(outer):
        assert edge.distToShape(Part.Vertex(x, y, 0))[0] <= tolerance
    for p in edge.discretize(200):
        assert min(math.hypot(p.x - x, p.y - y) for x, y in points(outer, 64)) < tolerance + 0.1
    assert len(outer) < 200 * (0.005 / tolerance) ** (1 / 3)


def test_random_splines_become_smooth_arcs_within_tolerance():
    source = random.Random(11)
    for _ in range(10):
        n = source.randint(4, 12)
        corners = [
            (
                source.uniform(8, 30) * math.cos(2 * math.pi * k / n),
                source.uniform(8, 30) * math.sin(2 * math.pi * k / n),
            )
            for k in range(n)
        ]
        edge = spline(corners).toShape()
        ((_, outer, _),) = regions(edge)
        assert max(kinks(outer)) < 1e-4
        off = max(edge.distToShape(Part.Vertex(x, y, 0))[0] for x, y in points(outer, 4))
        assert off <= TOLERANCE


def test_a_spline_that_is_a_circle_or_a_line_is_read_as_one():
    circle = Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 10).toBSpline(0, math.pi / 2).toShape()
    lines = Part.BSplineCurve()
    lines.buildFromPolesMultsKnots(
        [Vector(0, 10, 0), Vector(0, 0, 0), Vector(10, 0, 0)], [2, 1, 2], [0, 1, 2], False, 1
    )
    ((_, outer, _),) = regions(Part.Compound([circle, lines.toShape()]))
    assert len(outer) == 3
    assert abs(area(outer)) == pytest.approx(25 * math.pi, rel=1e-9)


def test_a_corner_inside_a_spline_stays_sharp():
    curve = Part.BSplineCurve()
    poles = [Vector(*p, 0) for p in [(0, 0), (10, -4), (20, 0), (24, 10), (20, 20)]]
    curve.buildFromPolesMultsKnots(poles, [3, 2, 3], [0, 1, 2], False, 2)
    closing = Part.makePolygon([Vector(20, 20, 0), Vector(0, 20, 0), Vector(0, 0, 0)])
    ((_, outer, _),) = regions(Part.Compound([curve.toShape(), closing]))
    sharp = [k for k in kinks(outer) if k > 1e-4]
    assert len(sharp) == 4
    assert min(math.hypot(v[0] - 20, v[1]) for v in outer) < 1e-12


def test_a_face_inside_a_face_by_a_slit_is_read_without_the_slit():
    square = Part.Face(
        Part.makePolygon([Vector(*c, 0) for c in [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)]])
    )
    slit = Part.makeLine(Vector(0, 10, 0), Vector(9, 10, 0))
    pieces_of_it = square.generalFuse([slit])[0].Faces
    ((_, outer, islands),) = regions(pieces_of_it[0])
    assert islands == []
    assert abs(area(outer)) == pytest.approx(400)


def test_a_tilted_face_is_refused_with_its_angle_and_place():
    box = Part.makeBox(10, 10, 10)
    tilted = level_faces(box, 10)[0].copy()
    tilted.rotate(Vector(0, 0, 0), Vector(1, 0, 0), 12.5)
    error = refusal(Part.Compound(level_faces(box, 0) + [tilted]))
    assert (error.reason, error.index) == ("tilted", 1)
    assert "12.5 degrees" in str(error)
    assert isinstance(error, ValueError)


@pytest.mark.parametrize(
    "shape, reason",
    [
        (Part.makeCylinder(5, 10).Faces[0], "not planar"),
        (Part.makeSphere(5).Faces[0], "not planar"),
        (Part.makeBox(1, 1, 1), "tilted"),
        (Part.makeCircle(5, Vector(0, 0, 0), Vector(0.3, 0, 1)), "tilted"),
        (Part.makePolygon([Vector(0, 0, 0), Vector(9, 0, 0), Vector(9, 9, 0)]), "open"),
        (Part.makeLine(Vector(0, 0, 0), Vector(9, 0, 0)), "open"),
        (Part.Compound([]), "empty"),
        (Part.Vertex(1, 2, 3), "empty"),
        (Part.Compound([Part.makeCircle(5), Part.makeCircle(5, Vector(4, 0, 0))]), "crossing"),
        (
            Part.Compound(
                [
                    Part.makePolygon(
                        [Vector(0, 0, 0), Vector(9, 0, 0), Vector(9, 9, 0), Vector(0, 0, 0)]
                    ),
                    Part.makeLine(Vector(9, 0, 0), Vector(20, 0, 0)),
                ]
            ),
            "branching",
        ),
    ],
    ids=[
        "cylinder",
        "sphere",
        "box",
        "tilted circle",
        "open wire",
        "line",
        "nothing",
        "vertex",
        "crossing",
        "branching",
    ],
)
def test_what_bounds_no_level_region_is_refused(shape, reason):
    error = refusal(shape)
    assert error.reason == reason
    assert str(error).endswith(".")


def test_an_open_wire_is_named_with_the_place_and_size_of_its_gap():
    square = Part.makePolygon([Vector(*c, 0) for c in [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0.25)]])
    error = refusal(Part.Compound([Part.makeCircle(1, Vector(50, 0, 0)), square]))
    assert (error.reason, error.index) == ("open", 1)
    assert "(0.000, 0.000)" in str(error) and "0.25 mm" in str(error)


@pytest.mark.parametrize("text", ["", "no shape", "CASCADE Topology V1, (c) Matra-Datavision\n"])
def test_text_that_is_no_shape_is_refused(text):
    with pytest.raises(_occt.ShapeError) as caught:
        _occt.regions_from_brep(text, TOLERANCE)
    assert caught.value.reason == "unreadable"


def test_text_that_is_cut_short_is_refused():
    text = plate().exportBrepToString()
    for share in (0.1, 0.3, 0.5, 0.7, 0.9):
        with pytest.raises(_occt.ShapeError) as caught:
            _occt.regions_from_brep(text[: int(share * len(text))], TOLERANCE)
        assert caught.value.reason in ("unreadable", "kernel")


@pytest.mark.parametrize("tolerance", [0, -1, math.nan])
def test_a_tolerance_that_is_not_positive_is_refused(tolerance):
    with pytest.raises(ValueError, match="tolerance"):
        regions(Part.makeCircle(5), tolerance)


def test_the_module_was_built_for_this_freecad():
    assert _occt.OCC_VERSION == Part.OCC_VERSION
    assert _occt.__file__.endswith(sysconfig.get_config_var("EXT_SUFFIX"))


# ---- open outlines ----


def curves(*parts):
    text = Part.Compound(list(parts)).exportBrepToString()
    return _occt.curves_from_brep(text, TOLERANCE)


def test_edges_in_any_order_and_sense_are_joined_to_one_open_curve():
    a, b, c, d = Vector(0, 0, -3), Vector(9, 0, -3), Vector(9, 9, -3), Vector(20, 9, -3)
    edges = [Part.makeLine(*ends) for ends in ((c, b), (a, b), (d, c))]
    ((z, chain, closed),) = curves(*edges)
    assert z == pytest.approx(-3) and not closed
    ends = [(x, y) for x, y, _, _ in chain]
    assert ends in ([(20, 9), (9, 9), (9, 0), (0, 0)], [(0, 0), (9, 0), (9, 9), (20, 9)])


def test_an_open_arc_keeps_its_bulge():
    arc = Part.Arc(Vector(5, 0, 0), Vector(0, 5, 0), Vector(-5, 0, 0)).toShape()
    ((_, chain, closed),) = curves(arc)
    assert not closed and len(chain) == 2
    assert chain[0] == pytest.approx((5, 0, 1, False)) and chain[1][:2] == pytest.approx((-5, 0))


def test_open_curves_come_before_closed_ones():
    circle = Part.makeCircle(4, Vector(30, 0, 0))
    line = Part.makeLine(Vector(0, 0, 0), Vector(9, 0, 0))
    assert [closed for _, _, closed in curves(circle, line)] == [False, True]


def test_edges_of_faces_are_no_curves_of_their_own():
    face = Part.Face(
        Part.makePolygon([Vector(0, 0, 0), Vector(9, 0, 0), Vector(9, 9, 0)] + [Vector(0, 0, 0)])
    )
    assert curves(face) == []


def test_curves_end_where_three_edges_meet():
    meet = Vector(0, 0, 0)
    edges = [
        Part.makeLine(meet, end) for end in (Vector(5, 0, 0), Vector(0, 5, 0), Vector(-5, 0, 0))
    ]
    found = curves(*edges, Part.makeLine(Vector(5, 0, 0), Vector(9, 9, 0)))
    assert sorted(len(chain) for _, chain, _ in found) == [2, 2, 3]
    assert not any(closed for _, _, closed in found)
