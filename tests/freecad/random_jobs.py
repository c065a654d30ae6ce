"""Random jobs, from seeds: parts and stocks of all kinds that a mill gets, and operations on them.

Kinds: prisms with pockets, castings, overhangs, second models, drilled and arrayed operations
before, chains of rest machining. A seed gives the same job always.
"""

import importlib
import math
import random
from dataclasses import dataclass, field

import FreeCAD
import Part
from FreeCAD import Vector
from models import sketch_of
from occt_judge import Move

KINDS = ("prism", "casting", "overhang", "second model", "earlier", "rest")
OPERATIONS = ("adaptive", "adaptive", "trochoid", "lame_spiral")
WIDTH, DEPTH, HEIGHT = 70.0, 50.0, 20.0  # mm: of the block all begin with


@dataclass
class Job:
    kind: str
    job: object
    operations: list  # of document objects: ours, to be judged
    models: list  # shapes in place
    stock: object  # shape in place
    earlier: list = field(default_factory=list)  # of (moves, tool radius): what was drilled before


def make(doc, seed):
    """The Job of a seed, in a document of its own; nothing is recomputed yet."""
    random_ = random.Random(seed)
    kind = KINDS[seed % len(KINDS)]
    part, others, blank = PARTS[kind](random_)
    place = _placement(random_)
    for shape in (part, *others, *([blank] if blank else [])):
        shape.Placement = place.multiply(shape.Placement)
    return _job(doc, random_, kind, part, others, blank, place)


def _placement(random_):
    """Most parts lie askew, some far away."""
    if random_.random() < 0.3:
        return FreeCAD.Placement()
    far = random_.choice((0, 10, 1000))
    base = Vector(*(far * random_.uniform(-1, 1) for _ in range(3)))
    return FreeCAD.Placement(base, FreeCAD.Rotation(Vector(0, 0, 1), random_.uniform(0, 360)))


# ---- parts ----


def _outline(random_, x, y, size):
    """A face in z = 0 about (x, y)."""
    kind = random_.choice(("rectangle", "circle", "polygon", "slot", "cross"))
    if kind == "circle":
        return Part.Face(Part.Wire(Part.makeCircle(size / 2, Vector(x, y, 0))))
    if kind == "polygon":
        count = random_.randint(3, 7)
        radii = [size / 2 * random_.uniform(0.7, 1.0) for _ in range(count)]
        turns = [2 * math.pi * (k + random_.uniform(-0.2, 0.2)) / count for k in range(count)]
        points = [Vector(x + r * math.cos(t), y + r * math.sin(t), 0) for r, t in zip(radii, turns)]
        return Part.Face(Part.makePolygon([*points, points[0]]))
    a, b = size, size * random_.uniform(0.45, 0.9)
    face = _box(x, y, a, b)
    if kind == "slot":
        ends = [
            Part.Face(Part.Wire(Part.makeCircle(b / 2, Vector(x + e, y, 0))))
            for e in (-a / 2, a / 2)
        ]
        return face.fuse(ends).removeSplitter().Faces[0]
    if kind == "cross":
        return face.fuse(_box(x, y, b, a)).removeSplitter().Faces[0]
    return face


def _box(x, y, a, b):
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
    return Part.Face(
        Part.makePolygon([Vector(x + i * a / 2, y + j * b / 2, 0) for i, j in corners])
    )


def _sunk(face, depth, top=HEIGHT):
    """The body of a pocket of some depth below a height."""
    solid = face.extrude(Vector(0, 0, depth + 5))
    solid.translate(Vector(0, 0, top - depth))
    return solid


def _pocketed(random_, block=None):
    """A block with one or two pockets, some of them open at a side, stepped, or with an island."""
    block = block or Part.makeBox(WIDTH, DEPTH, HEIGHT)
    x, y = random_.uniform(22, 48), random_.uniform(20, 30)
    if random_.random() < 0.35:
        x = random_.choice((2.0, WIDTH - 2.0))  # it runs out at the side
    size = random_.uniform(18, 34)
    depth = random_.uniform(2, 9)
    face = _outline(random_, x, y, size)
    if random_.random() < 0.3:
        hole = Part.Face(Part.Wire(Part.makeCircle(random_.uniform(2, 4), Vector(x, y, 0))))
        face = face.cut(hole).Faces[0]
    part = block.cut(_sunk(face, depth))
    if random_.random() < 0.4:
        inner = _outline(random_, x + random_.uniform(-2, 2), y, size * 0.5)
        part = part.cut(_sunk(inner, depth + random_.uniform(1, 4)))
    return part.removeSplitter()


def _prism(random_):
    return _pocketed(random_), [], None


def _casting(random_):
    """Stock that is no box: drafted, round, with a recess, wider above, or a turned bar."""
    part = _pocketed(random_)
    kind = random_.choice(("draft", "recess", "wider above", "bar", "boss"))
    if kind == "draft":
        blank = _frustum(-6, -6, -2, HEIGHT + random_.uniform(0, 3))
    elif kind == "wider above":
        blank = _frustum(-1, -8, 0, HEIGHT + 2)
    elif kind == "recess":
        blank = Part.makeBox(WIDTH, DEPTH, HEIGHT).cut(
            _sunk(_box(35, 25, 30, 20), random_.uniform(1, 12))
        )
    elif kind == "bar":
        blank = Part.makeCylinder(32, WIDTH + 4, Vector(-2, DEPTH / 2, HEIGHT / 2), Vector(1, 0, 0))
    else:
        blank = Part.makeBox(WIDTH + 4, DEPTH + 4, HEIGHT, Vector(-2, -2, 0))
        blank = blank.fuse(
            Part.makeCone(9, 5, 5, Vector(*(random_.uniform(15, 40) for _ in "xy"), HEIGHT))
        )
    return part, [], blank


def _frustum(low, high, z0, z1):
    """A block that reaches so far beyond the part's sides at its bottom and its top."""

    def outline(by, z):
        a, b = abs(by), abs(by)
        points = [(-a, -b), (WIDTH + a, -b), (WIDTH + a, DEPTH + b), (-a, DEPTH + b), (-a, -b)]
        return Part.makePolygon([Vector(x, y, z) for x, y in points])

    return Part.makeLoft([outline(low, z0), outline(high, z1)], True)


def _overhang(random_):
    """A T-slot, a dovetail, a cross hole through a wall, or a lip over a pocket."""
    part = Part.makeBox(WIDTH, DEPTH, HEIGHT)
    kind = random_.choice(("T-slot", "dovetail", "cross hole", "lip"))
    width = random_.uniform(9, 14)
    if kind == "T-slot":
        upper = Part.makeBox(WIDTH, width, 20, Vector(0, 25 - width / 2, 8))
        lower = Part.makeBox(WIDTH, width + 10, 5, Vector(0, 20 - width / 2, 8))
        part = part.cut(upper).cut(lower)
    elif kind == "dovetail":
        rise, lean = HEIGHT - 9, random_.uniform(2, 4)
        points = [
            (-width / 2 - lean, 9),
            (width / 2 + lean, 9),
            (width / 2, 9 + rise),
            (-width / 2, 9 + rise),
        ]
        face = Part.Face(Part.makePolygon([Vector(0, 25 + y, z) for y, z in [*points, points[0]]]))
        part = part.cut(face.extrude(Vector(WIDTH, 0, 0)))
    elif kind == "cross hole":
        part = _pocketed(random_)
        part = part.cut(
            Part.makeCylinder(random_.uniform(1, 3), 200, Vector(-50, 25, 15), Vector(1, 0, 0))
        )
    else:
        part = part.cut(_sunk(_box(35, 25, 36, 26), 10))
        lip = Part.makeBox(36, random_.uniform(3, 8), 3, Vector(17, 12, HEIGHT - 3))
        part = part.fuse(lip)
    return part.removeSplitter(), [], None


def _second_model(random_):
    """A pin in a pocket, a clamp over it, or a plate beside an open side."""
    part = _pocketed(random_)
    kind = random_.choice(("pin", "clamp", "plate"))
    if kind == "pin":
        other = Part.makeCylinder(
            random_.uniform(2, 5), HEIGHT, Vector(random_.uniform(25, 45), 25, 3)
        )
    elif kind == "clamp":
        other = Part.makeBox(
            random_.uniform(15, 40), 12, 6, Vector(-8, random_.uniform(5, 30), HEIGHT)
        )
    else:
        other = Part.makeBox(12, DEPTH, 15, Vector(random_.choice((-13, WIDTH + 1)), 0, 0))
    return part, [other], None


PARTS = {
    "prism": _prism,
    "casting": _casting,
    "overhang": _overhang,
    "second model": _second_model,
    "earlier": _prism,
    "rest": _prism,
}


# ---- jobs ----


def level_faces(shape):
    """{name: z} of the level faces that look up, without the highest."""
    top = shape.BoundBox.ZMax
    return {
        "Face%d" % n: face.BoundBox.ZMax
        for n, face in enumerate(shape.Faces, 1)
        if face.BoundBox.ZLength < 1e-6
        and face.normalAt(0, 0).z > 0
        and face.BoundBox.ZMax < top - 1e-3
    }


def _job(doc, random_, kind, part, others, blank, place):
    from evenload import host

    objects = []
    for number, shape in enumerate([part, *others]):
        obj = doc.addObject("Part::Feature", "Part" if number == 0 else "Other")
        obj.Shape = shape
        objects.append(obj)
    doc.recompute()
    diameter = random_.choice((3.0, 4.0, 6.0, 6.0, 8.0))
    job, controller = host.create_job(doc, objects, diameter, 600, 10000, 2)
    if blank is not None:
        set_stock(doc, job, blank)
    elif random_.random() < 0.3:
        host.set_stock_margin(job, random_.uniform(0.5, 3))
    made = Job(kind, job, [], [m.Shape for m in job.Model.Group], job.Stock.Shape)
    base = _base(doc, random_, job, kind, place)
    if kind == "earlier":
        _drill_and_array(doc, random_, made, controller, base)
    if kind == "rest":
        larger = host.create_tool(
            "endmill", {"Diameter": diameter + random_.choice((2, 4)), "Flutes": 2}
        )
        controller = _with_tool(doc, job, controller, larger)
        made.operations.append(_operation(random_, job, controller, base, "adaptive"))
        small = job.Tools.Group[0]
        op = _operation(random_, job, small, base, "adaptive")
        op.UseRestMachining = True
        made.operations.append(op)
    else:
        op = _operation(random_, job, controller, base, random_.choice(OPERATIONS))
        if kind == "earlier" and hasattr(op, "UseRestMachining"):
            op.UseRestMachining = True
        made.operations.append(op)
    return made


def set_stock(doc, job, blank):
    """Makes a solid the job's stock."""
    stock = doc.addObject("Part::Feature", "Blank")
    stock.Shape = blank
    stock.addProperty("App::PropertyString", "StockType", "Stock")
    stock.StockType = "Unknown"
    before, job.Stock = job.Stock, stock
    doc.removeObject(before.Name)
    doc.recompute()


def _with_tool(doc, job, controller, tool):
    """A second controller with another tool and the same data."""
    from evenload import host

    made = host.cam().controller.Create("Larger", tool=tool)
    made.HorizFeed, made.VertFeed = controller.HorizFeed, controller.VertFeed
    host.set_rapid_feed(made, 5000.0)
    made.SpindleSpeed = controller.SpindleSpeed
    job.Proxy.addToolController(made)
    return made


def _base(doc, random_, job, kind, place):
    """Base geometry: a floor of the model, two of them, or an outline drawn on a block."""
    model = job.Model.Group[0]
    floors = list(level_faces(model.Shape))
    if kind == "prism" and random_.random() < 0.25:
        half = random_.uniform(8, 14)
        chain = [(35 - half, 18, 0), (35 + half, 18, 0), (35 + half, 34, 0), (35 - half, 34, 0)]
        sketch = sketch_of(doc, chain, z=HEIGHT - 4)
        sketch.Placement = place.multiply(sketch.Placement)
        doc.recompute()
        return [(sketch, "")]
    names = random_.sample(floors, min(len(floors), random_.choice((1, 1, 2))))
    return [(model, tuple(names))]


def _operation(random_, job, controller, base, kind):
    module = importlib.import_module("evenload.operations." + kind)
    op = module.Create("Operation", parentJob=job, toolController=controller)
    op.Base = base
    _set(op, StepDown=random_.uniform(2, 12))
    op.EngagementAngle = random_.choice((40, 60, 60, 90))
    op.CutMode = random_.choice(("Climb", "Climb", "Conventional"))
    op.Entry = random_.choice(("Automatic", "Automatic", "Helix", "Ramp"))
    if random_.random() < 0.2:
        op.StockToLeave = random_.uniform(0.1, 0.5)
    if random_.random() < 0.15:
        op.StockToLeaveAxial = random_.uniform(0.1, 0.5)
    op.Arcs = random_.random() > 0.15
    op.OrderBy = random_.choice(("Region", "Depth"))
    if random_.random() < 0.15:  # what a user may do to the depths
        job.Document.recompute()
        if random_.random() < 0.5:
            _set(op, StartDepth=op.StartDepth.Value - random_.uniform(0.5, 3))
        else:
            _set(op, FinalDepth=op.FinalDepth.Value + random_.uniform(-1, 1))
    return op


def _set(op, **values):
    for name, value in values.items():
        op.setExpression(name, None)
        setattr(op, name, value)


def _drill_and_array(doc, random_, made, controller, base):
    """Holes drilled by a cycle before, once in a path of their own and once as an array of it."""
    from evenload import host

    job = made.job
    box = job.Model.Group[0].Shape.BoundBox
    top, depth = box.ZMax, random_.uniform(2, 8)
    x, y = box.Center.x + random_.uniform(-8, 8), box.Center.y + random_.uniform(-8, 8)
    first = host.freecads("Custom", "Bore", job, controller)
    cycle = random_.choice(("G81", "G85", "G83"))
    peck = " Q2" if cycle == "G83" else ""
    first.Gcode = [
        "G0 Z%g" % (top + 5),
        "G0 X%.3f Y%.3f" % (x, y),
        "%s X%.3f Y%.3f Z%.3f R%.3f%s F100" % (cycle, x, y, top - depth, top + 1, peck),
        "G80",
        "G0 Z%g" % (top + 5),
    ]
    shift = Vector(random_.uniform(5, 9), 0, 0)
    array = host.array(first)
    array.Copies, array.Offset = 1, shift
    job.Proxy.addOperation(array)
    doc.recompute()
    radius = controller.Tool.Diameter.Value / 2
    for place in (Vector(x, y, 0), Vector(x, y, 0) + shift):
        down = Move("G1", place + Vector(0, 0, top + 1), place + Vector(0, 0, top - depth))
        made.earlier.append(([down], radius))
