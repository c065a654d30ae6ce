"""Parts as they come from other programs: of many features, through STEP, turned in their job."""

import random

import FreeCAD
import Import
import Part
import pytest
import random_jobs
from evenload import host, proof
from evenload.operations import adaptive
from evenload.settings.notes import CHECKED
from FreeCAD import Placement, Rotation, Vector

pytestmark = pytest.mark.between

PARTS = 60
ON_EACH_FREECAD = 20  # of them, since shapes and STEP depend on its OpenCASCADE
WIDTH, DEPTH, HEIGHT = 80.0, 60.0, 30.0
TURNS = [
    Rotation(),
    Rotation(Vector(0, 0, 1), 37),
    Rotation(Vector(1, 0, 0), 90),
    Rotation(Vector(0, 1, 0), -90),
    Rotation(Vector(1, 0, 0), 180),
]


def _feature(random_, part):
    """The part with one more of what machined parts have."""
    kind = random_.choice(
        ("pocket", "pocket", "step", "slot", "hole", "blind hole", "boss", "chamfer", "fillet")
    )
    x, y = random_.uniform(15, WIDTH - 15), random_.uniform(15, DEPTH - 15)
    depth, size = random_.uniform(3, 12), random_.uniform(10, 26)
    if kind == "pocket":
        pocket = Part.makeBox(
            size, size * 0.8, depth + 1, Vector(x - size / 2, y - 9, HEIGHT - depth)
        )
        upright = [e for e in pocket.Edges if e.BoundBox.ZLength > depth]
        return part.cut(pocket.makeFillet(random_.uniform(2, 4), upright))
    if kind == "step":
        return part.cut(
            Part.makeBox(WIDTH, random_.uniform(5, 15), depth, Vector(0, 0, HEIGHT - depth))
        )
    if kind == "slot":
        return part.cut(Part.makeBox(WIDTH, 8, depth, Vector(0, y, HEIGHT - depth)))
    if kind in ("hole", "blind hole"):
        low = 0 if kind == "hole" else HEIGHT - depth
        return part.cut(Part.makeCylinder(random_.uniform(2, 6), HEIGHT, Vector(x, y, low)))
    if kind == "boss":
        return part.fuse(Part.makeCylinder(random_.uniform(3, 7), 5, Vector(x, y, HEIGHT - 1)))
    around = [e for e in part.Edges if e.BoundBox.ZMin > HEIGHT - 1e-6 and e.Length > 20]
    edge = [random_.choice(around)] if around else []
    try:
        if edge and kind == "chamfer":
            return part.makeChamfer(1.0, edge)
        return part.makeFillet(1.0, edge) if edge else part
    except Part.OCCError:  # where others are too near for it
        return part


def imported(doc, seed, folder):
    """The part of a seed after a way through a STEP file, as a document object."""
    random_ = random.Random(1000 + seed)
    part = Part.makeBox(WIDTH, DEPTH, HEIGHT)
    for _ in range(random_.randint(3, 8)):
        changed = _feature(random_, part).removeSplitter()
        part = changed if changed.isValid() and len(changed.Solids) == 1 else part
    made = doc.addObject("Part::Feature", "Made")
    made.Shape = part
    file = str(folder / "part.step")
    Import.export([made], file)
    doc.removeObject(made.Name)
    Import.insert(file, doc.Name)
    return next(obj for obj in doc.Objects if getattr(obj, "Shape", None) and obj.Shape.Solids)


@pytest.mark.parametrize(
    "seed",
    [
        pytest.param(seed, marks=pytest.mark.core if seed >= ON_EACH_FREECAD else ())
        for seed in range(PARTS)
    ],
)
def test_a_part_has_a_checked_path_or_a_sentence(seed, tmp_path):
    doc = FreeCAD.newDocument("Imported")
    try:
        part = imported(doc, seed, tmp_path)
        job, controller = host.create_job(doc, [part], 5.0, 600, 9000, 2)
        model = job.Model.Group[0]
        model.Placement = Placement(Vector(0, 0, 0), TURNS[seed % len(TURNS)]).multiply(
            model.Placement
        )
        host.set_stock_margin(job, 1.0)
        doc.recompute()
        floors = random_jobs.level_faces(model.Shape)
        if not floors:  # turned so that only its outer sides are level
            floors = {"Face1": 0.0}
        name = random.Random(seed).choice(sorted(floors))
        op = adaptive.Create("Operation", parentJob=job, toolController=controller)
        op.Base = [(model, (name,))]
        doc.recompute()
        if op.isValid():
            assert CHECKED in op.Report and proof.check(op) == []
        else:
            assert op.Path.Commands == [] and len(op.Report) > 20
            assert "EvenLoad failed" not in op.Report
            assert not op.Report.startswith("The path "), op.Report
    finally:
        FreeCAD.closeDocument(doc.Name)
