"""Models: blocks with pockets."""

import json
import math
from pathlib import Path

import Part
from FreeCAD import Vector

DEPTH, MARGIN, BLOCK = 3.0, 10.0, 12.0  # mm: of pockets, of the block around and below them
CORPUS = Path(__file__).resolve().parents[1] / "corpus"


def wire(chain, closed=True):
    """A wire through (x, y, bulge) in z = 0."""
    edges = []
    for (x0, y0, bulge), (x1, y1, _) in zip(chain, chain[1:] + (chain[:1] if closed else [])):
        start, end = Vector(x0, y0, 0), Vector(x1, y1, 0)
        if not bulge:
            edges.append(Part.makeLine(start, end))
            continue
        middle = (start + end) / 2 + Vector(y1 - y0, x0 - x1, 0) * (bulge / 2)
        edges.append(Part.Arc(start, middle, end).toShape())
    return Part.Wire(edges)


def rectangle(x0, y0, x1, y1):
    return [(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)]


def circle(x, y, radius):
    return [(x + radius, y, 1), (x - radius, y, 1)]


SQUARE = rectangle(0, 0, 30, 30)


def face_of(outer, islands=()):
    face = Part.Face(wire(outer))
    for island in islands:
        face = face.cut(Part.Face(wire(island)))
    return face


def block_with(*faces, depth=DEPTH):
    """A block with its top at z = 0 and a pocket of each face."""
    box = faces[0].BoundBox
    for face in faces[1:]:
        box.add(face.BoundBox)
    block = Part.makeBox(
        box.XLength + 2 * MARGIN,
        box.YLength + 2 * MARGIN,
        BLOCK,
        Vector(box.XMin - MARGIN, box.YMin - MARGIN, -BLOCK),
    )
    for face in faces:
        block = block.cut(face.extrude(Vector(0, 0, -depth)))
    return block


def sketch_of(doc, chain, z=-DEPTH, name="Sketch", closed=True):
    """A sketch object with the chain's lines and arcs at a height."""
    sketch = doc.addObject("Sketcher::SketchObject", name)
    for edge in wire(chain, closed).Edges:
        if isinstance(edge.Curve, Part.Circle):
            middle = edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2)
            ends = edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)
            sketch.addGeometry(Part.Arc(ends[0], middle, ends[1]), False)
        else:
            sketch.addGeometry(Part.LineSegment(*(v.Point for v in edge.Vertexes)), False)
    sketch.Placement.Base = Vector(0, 0, z)
    doc.recompute()
    return sketch


def body_with_pockets(doc, width, length, pockets):
    """A PartDesign body: a plate 12 mm thick, from z = 0 up, with pockets in its top, made in their
    order. pockets: of (name, x, y, width, length, depth).
    """
    body = doc.addObject("PartDesign::Body", "Body")
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile = _rectangle_in(body, "Outline", rectangle(0, 0, width, length), 0)
    pad.Length = BLOCK
    for name, x, y, a, b, depth in pockets:
        pocket = body.newObject("PartDesign::Pocket", name)
        outline = rectangle(x, y, x + a, y + b)
        pocket.Profile = _rectangle_in(body, name + "Sketch", outline, BLOCK)
        pocket.Length = depth
    return body


def _rectangle_in(body, name, chain, z):
    sketch = body.newObject("Sketcher::SketchObject", name)
    for edge in wire(chain).Edges:
        sketch.addGeometry(Part.LineSegment(*(v.Point for v in edge.Vertexes)), False)
    sketch.Placement.Base.z = z
    return sketch


def floors_of(shape, z=-DEPTH):
    """Names of the level faces at a height."""
    return [
        "Face%d" % n
        for n, f in enumerate(shape.Faces, 1)
        if abs(f.BoundBox.ZMin - z) < 1e-6 and abs(f.BoundBox.ZMax - z) < 1e-6
    ]


def corpus_case(name):
    """A case of the corpus, as its file has it."""
    return json.loads((CORPUS / (name + ".json")).read_text())


def case_model(case):
    """The solid of a corpus case; its floor lies axial_depth below z = 0, the top of the stock."""
    outer, depth = case["outer"], case["axial_depth"]
    if not case.get("open"):
        return block_with(face_of(outer, case["islands"]), depth=depth)
    solid = Part.Face(wire(outer)).extrude(Vector(0, 0, depth - BLOCK))
    solid.translate(Vector(0, 0, -depth))
    for island in case["islands"]:
        boss = Part.Face(wire(island)).extrude(Vector(0, 0, depth))
        boss.translate(Vector(0, 0, -depth))
        solid = solid.fuse(boss)
    return solid.removeSplitter()


def with_rectangle(width, length, height, x, y, depth, margin=8.0):
    """A block from z = 0 up, `margin` mm wider all round than a pocket of x by y mm in its top."""
    block = Part.makeBox(width, length, height)
    return block.cut(Part.makeBox(x, y, depth, Vector(margin, margin, height - depth)))


def zigzag_stroke(width, depth=1.0):
    """A plate with a stroke of a letter in its top, which is at z = 0."""
    corners = [Vector(*c, -depth) for c in ((4, 4), (12, 6), (5, 9), (13, 12), (6, 15))]
    stroke = Part.Face(Part.makePolygon(corners).makeOffset2D(width / 2).Wires[0])
    return Part.makeBox(20, 20, 3, Vector(0, 0, -3)).cut(stroke.extrude(Vector(0, 0, depth)))


def ring_of_lines(count, gap, z=0.0):
    """Lines round an ellipse, as in imported drawings; the last ends `gap` mm off the first."""
    angles = [2 * math.pi * k / count for k in range(count)]
    points = [Vector(30 + 20 * math.cos(a), 30 + 15 * math.sin(a), z) for a in angles]
    points.append(points[0] + Vector(gap, 0, 0))
    return Part.Compound([Part.makeLine(a, b) for a, b in zip(points, points[1:])])
