"""Selected faces and edges become those of the job's model, which may be moved in the job."""

import FreeCAD
import pytest
from evenload import host
from evenload.operations import adaptive, job_model
from FreeCAD import Vector
from models import body_with_pockets


class Plate:
    """A body with a deep and a shallow pocket, made one after the other, in a job."""

    def __init__(self, doc, group=None, x=0.0):
        pockets = [("First", 8, 10, 28, 30, 6), ("Second", 44, 10, 28, 30, 3)]
        self.body = body_with_pockets(doc, 80, 50, pockets)
        self.body.Placement.Base.x = x
        self.pockets = [doc.getObject(name) for name, *_ in pockets]
        if group is not None:
            group.addObject(self.body)
        doc.recompute()
        self.job, self.controller = host.create_job(doc, [self.body], 6, 255, 6366, 1)
        (self.model,) = self.job.Model.Group

    def operation(self, base, name):
        op = adaptive.Create("Operation", parentJob=self.job, toolController=self.controller)
        op.Proxy.addBase(op, base, name)
        return op


def face_at(obj, z):
    """The name of an object's level face at a height, all of which must be below another face."""
    (name,) = [
        "Face%d" % n
        for n, face in enumerate(obj.Shape.Faces, 1)
        if abs(face.BoundBox.ZMin - z) < 1e-6 and face.BoundBox.ZLength < 1e-6
    ]
    return name


def entries(op):
    return [(obj.Name, list(names)) for obj, names in op.Base]


@pytest.mark.parametrize("chosen", ["feature", "body", "model"])
def test_a_face_of_a_body_its_last_feature_or_the_model_is_the_models(doc, chosen):
    plate = Plate(doc)
    obj = {"feature": plate.body.Tip, "body": plate.body, "model": plate.model}[chosen]
    op = plate.operation(obj, face_at(obj, 9))
    assert entries(op) == [(plate.model.Name, [face_at(plate.model, 9)])]


def test_a_face_of_an_earlier_feature_is_found_by_its_place(doc):
    """With as many faces more in the body as there are now, names are no longer the same."""
    plate = Plate(doc, x=-300.0)
    first = plate.pockets[0]
    name = face_at(first, 6)
    assert plate.body.Shape.getElement(name).BoundBox.ZMin != pytest.approx(6)
    op = plate.operation(first, name)
    assert entries(op) == [(plate.model.Name, [face_at(plate.model, 6)])]


def test_a_face_that_the_body_no_longer_has_stays_what_it_is(doc):
    plate = Plate(doc)
    pad = plate.body.Group[0]
    top = face_at(pad, 12)  # later pockets have cut it
    assert job_model.of(plate.job, pad, top) == (pad, top)


def test_an_edge_of_a_body_is_the_models(doc):
    plate = Plate(doc)
    assert job_model.of(plate.job, plate.body.Tip, "Edge7") == (plate.model, "Edge7")


def test_a_sketch_in_a_body_stays_a_sketch(doc):
    plate = Plate(doc)
    sketch = doc.getObject("FirstSketch")
    assert job_model.of(plate.job, sketch, "") == (sketch, "")


def test_a_body_in_a_part_is_found(doc):
    plate = Plate(doc, group=doc.addObject("App::Part", "Assembly"), x=25.0)
    tip = plate.body.Tip
    name = face_at(tip, 9)
    assert job_model.of(plate.job, tip, name) == (plate.model, name)


def test_what_belongs_to_no_model_stays_what_it_is(doc):
    plate = Plate(doc)
    other = doc.addObject("Part::Box", "Other")
    doc.recompute()
    assert job_model.of(plate.job, other, "Face6") == (other, "Face6")


def test_doubles_are_left_out_whichever_way_they_were_chosen(doc):
    plate = Plate(doc)
    name = face_at(plate.model, 9)
    op = plate.operation(plate.body.Tip, name)
    for obj in (plate.body, plate.model):
        op.Proxy.addBase(op, obj, name)
    assert entries(op) == [(plate.model.Name, [name])]


def test_the_path_follows_the_model_when_it_is_moved_in_the_job(doc):
    plate = Plate(doc)
    op = plate.operation(plate.body.Tip, face_at(plate.body.Tip, 9))

    def ends():
        doc.recompute()
        assert op.isValid(), op.Report
        places = [c.Parameters["X"] for c in op.Path.Commands if "X" in c.Parameters]
        return [min(places), max(places)]

    before = ends()
    plate.model.Placement = FreeCAD.Placement(Vector(200, 0, 0), FreeCAD.Rotation())
    assert ends() == pytest.approx([x + 200 for x in before], abs=1e-3)
