"""Bad input: one sentence that names the thing and the remedy, an empty path, and nothing lost."""

import re
import FreeCAD
import Part
import pytest
from conftest import reopened
from models import DEPTH, SQUARE, block_with, face_of, floors_of, rectangle
from FreeCAD import Vector


def lines_sketch(doc, corners, name="Outline"):
    sketch = doc.addObject("Sketcher::SketchObject", name)
    for a, b in zip(corners, corners[1:]):
        sketch.addGeometry(Part.LineSegment(Vector(*a, 0), Vector(*b, 0)), False)
    sketch.Placement.Base = Vector(0, 0, -DEPTH)
    doc.recompute()
    return sketch


def change(bench, op, **properties):
    """Sets properties, asserts a refusal, sets them back, asserts a path; returns the sentence."""
    before = {name: getattr(op, name) for name in properties}
    bench.set(op, **properties)
    sentence = bench.refused(op)
    bench.set(op, **before)
    bench.done(op)
    return sentence


@pytest.mark.parametrize(
    "properties, words",
    [
        ({"EngagementAngle": 0}, ["EngagementAngle", "0 and 180"]),
        ({"EngagementAngle": 180}, ["EngagementAngle is 180", "0 and 180"]),
        ({"EngagementAngle": -20}, ["EngagementAngle is -20", "0 and 180"]),
        ({"SideStep": 0}, ["SideStep", "diameter of 6 mm"]),
        ({"SideStep": 6}, ["SideStep is 6 mm", "diameter of 6 mm"]),
        ({"StartDepth": -3}, ["StartDepth (-3 mm)", "FinalDepth (-3 mm)", "raise StartDepth"]),
        ({"StartDepth": -5}, ["StartDepth (-5 mm)", "raise StartDepth"]),
        ({"StepDown": 0}, ["StepDown is 0 mm", "positive"]),
        ({"SafeHeight": -1}, ["SafeHeight (-1 mm)", "StartDepth (0 mm)", "raise it"]),
        ({"ClearanceHeight": 1}, ["ClearanceHeight (1 mm)", "SafeHeight (3 mm)", "raise it"]),
        ({"FinalDepth": -31}, ["31 mm", "cutting length of 30 mm", "longer tool"]),
        ({"LinkFeed": 0}, ["LinkFeed is 0 mm/min", "positive"]),
        ({"MaximumFeed": "100 mm/min"}, ["MaximumFeed is 100 mm/min", "255 mm/min"]),
        ({"RollRadius": 0}, ["RollRadius is 0 mm", "positive"]),
        ({"MinimumRadius": 0}, ["MinimumRadius is 0 mm", "positive"]),
        ({"HelixDiameter": 0}, ["HelixDiameter is 0 mm", "positive"]),
        ({"Tolerance": 0}, ["Tolerance is 0 mm", "positive"]),
        ({"HelixAngle": 0}, ["HelixAngle is 0", "0 and 90"]),
        ({"HelixAngle": 90}, ["HelixAngle is 90", "0 and 90"]),
        ({"Entry": "Predrilled hole"}, ["'Predrilled hole'", "set EntryPoint and HoleDiameter"]),
        (
            {"HoleDiameter": 4, "EntryPoint": Vector(15, 15, 0)},
            ["HoleDiameter (4 mm)", "diameter of 6 mm", "larger hole"],
        ),
        (
            {"HoleDiameter": 8, "EntryPoint": Vector(-5, 15, 0)},
            ["EntryPoint (-5, 15)", "lies outside Face", "move it inside"],
        ),
        (
            {"Entry": "Predrilled hole", "HoleDiameter": 8, "EntryPoint": Vector(40, 15, 0)},
            ["EntryPoint (40, 15)", "lies outside Face", "move it inside"],
        ),
        (
            {"Entry": "Predrilled hole", "HoleDiameter": 8, "EntryPoint": Vector(1, 15, 0)},
            ["EntryPoint", "walls"],
        ),
        ({"Base": []}, ["no base geometry", "pick a face or a sketch"]),
        ({"ToolController": None}, ["no tool", "choose a tool controller"]),
    ],
    ids=lambda value: ",".join("%s=%s" % i for i in value.items()) if type(value) is dict else "",
)
def test_settings_out_of_range_are_refused(square, properties, words):
    op = square.done(square.operation())
    sentence = change(square, op, **properties)
    for word in words:
        assert word in sentence


def test_a_tool_without_diameter_is_refused(square):
    op = square.done(square.operation())
    for diameter in (0, -2):  # FreeCAD makes the second one 0, too
        square.controller.Tool.Diameter = diameter
        sentence = square.refused(op)
        assert "diameter of the tool" in sentence and "is 0 mm: set it" in sentence
    square.controller.Tool.Diameter = 6
    square.done(op)


@pytest.mark.parametrize(
    "shape, word",
    [
        ("ballend", "a ball end mill"),
        ("v-bit", "a V bit"),
        ("chamfer", "a chamfering tool"),
        ("drill", "a drill"),
        ("probe", "a probe"),
        ("slittingsaw", "a slitting saw"),
        ("thread-mill", "a thread mill"),
    ],
)
def test_tools_that_are_no_end_mills_are_refused(square, shape, word):
    from evenload import host

    op = square.done(square.operation())
    good = square.controller.Tool
    square.controller.Tool = host.create_tool(shape, {"Diameter": 6})
    sentence = square.refused(op)
    assert word in sentence and "choose a flat or bull-nosed end mill" in sentence
    square.controller.Tool = good
    square.done(op)


def test_a_bull_nosed_tool_is_taken(square):
    from evenload import host

    op = square.operation()
    square.controller.Tool = host.create_tool("bullnose", {"Diameter": 6})
    square.done(op)


def test_unknown_tool_shapes_and_properties_are_named(square):
    from evenload import host

    before = len(square.doc.Objects)
    with pytest.raises(ValueError, match="no tool shape 'spoon'"):
        host.create_tool("spoon", {})
    with pytest.raises(ValueError, match="'endmill' has no Weight"):
        host.create_tool("endmill", {"Weight": 1})
    assert len(square.doc.Objects) == before


@pytest.mark.parametrize("name, word", [("HorizFeed", "horizontal"), ("VertFeed", "vertical")])
def test_a_feed_of_zero_is_refused(square, name, word):
    op = square.done(square.operation())
    setattr(square.controller, name, 0)
    sentence = square.refused(op)
    assert "The %s feed of the tool controller" % word in sentence
    assert "is 0: set its %s." % name in sentence
    setattr(square.controller, name, "255 mm/min")
    square.done(op)


def test_a_tool_that_does_not_cut_at_its_centre_makes_no_ramp(square):
    op = square.done(square.operation(Entry="Ramp"))
    tool = square.controller.Tool
    tool.addProperty("App::PropertyBool", "CentreCutting", "Attributes")
    sentence = square.refused(op)
    assert "does not cut at its centre" in sentence and "pre-drilled hole" in sentence
    op.Entry = "Helix"
    square.done(op)


def test_a_pocket_too_small_for_the_tool_names_the_largest_that_fits(bench):
    b = bench(block_with(face_of(rectangle(0, 0, 5, 20))))
    op = b.operation()
    sentence = b.refused(op)
    assert "6 mm" in sentence and "largest" in sentence
    named = float(re.search(r"fits has ([0-9.]+) mm", sentence).group(1))
    assert 4.99 < named < 5  # it must really fit: a hair less than the slot
    b.controller.Tool.Diameter = 4
    b.done(op)


# ---- geometry ----


def test_a_tilted_face_is_named(square):
    box = square.doc.addObject("Part::Box", "Wedge")
    box.Placement.Rotation = FreeCAD.Rotation(Vector(1, 0, 0), 10)
    square.doc.recompute()
    op = square.operation(base=[(box, ("Face6",))])
    assert square.refused(op) == "Face6 of Wedge is tilted: pick a face parallel to XY."
    op.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    square.done(op)


def test_a_round_face_is_named(square):
    cylinder = square.doc.addObject("Part::Cylinder", "Cylinder")
    square.doc.recompute()
    op = square.operation(base=[(cylinder, ("Face1",))])
    assert square.refused(op) == ("Face1 of Cylinder is not flat: pick a flat face parallel to XY.")


def test_an_open_sketch_is_named_and_can_be_closed(square):
    sketch = lines_sketch(square.doc, [(0, 0), (30, 0), (30, 20), (0, 20), (0, 0.5)])
    op = square.operation(base=[(sketch, "")])
    sentence = square.refused(op)
    assert sentence.startswith("Outline: ") and "open" in sentence and "close it" in sentence
    sketch.addGeometry(Part.LineSegment(Vector(0, 0.5, 0), Vector(0, 0, 0)), False)
    square.doc.recompute()
    square.done(op)


def test_a_sketch_that_crosses_itself_is_named(square):
    sketch = lines_sketch(square.doc, [(0, 0), (30, 20), (30, 0), (0, 10), (0, 0)])
    sentence = square.refused(square.operation(base=[(sketch, "")]))
    assert (
        sentence.startswith("Outline: ") and "crosses" in sentence and "(10, 6.66667)" in sentence
    )


def test_edges_that_do_not_close_are_named(square):
    op = square.operation(base=[(square.model, ("Edge1", "Edge2"))])
    sentence = square.refused(op)
    assert sentence.startswith("Edge1, Edge2 of ") and sentence.count(":") >= 1


def test_a_whole_solid_is_refused(square):
    sentence = square.refused(square.operation(base=[(square.model, "")]))
    assert "is a solid: pick faces of it, or a sketch" in sentence


@pytest.mark.parametrize("name", ["Face99", "Edge999", "Vertex1", "Nonsense"])
def test_an_unknown_base_name_is_named_and_kept(square, name):
    op = square.operation()
    op.Base = [(square.model, (name,))]
    sentence = square.refused(op)
    assert name in sentence and "pick" in sentence
    assert [tuple(names) for _, names in op.Base] == [(name,)]
    op.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    square.done(op)


def test_an_object_without_a_shape_is_named(square):
    group = square.doc.addObject("App::FeaturePython", "Nothing")
    assert "Nothing" in square.refused(square.operation(base=[(group, "")]))


# ---- nothing is lost ----


def test_a_failed_operation_saves_reopens_and_works_when_mended(square, tmp_path):
    op = square.done(square.operation(RollRadius=0.7))
    op.EngagementAngle = 200
    square.refused(op)
    name = op.Name
    base = [tuple(names) for _, names in op.Base]
    with reopened(square.doc, tmp_path / "failed.FCStd") as doc:
        op = doc.getObject(name)
        assert op.Path.Commands == [] and "EngagementAngle is 200" in op.Report
        assert [tuple(names) for _, names in op.Base] == base
        op.touch()
        doc.recompute()
        assert not op.isValid()
        op.EngagementAngle = 60
        doc.recompute()
        assert op.isValid() and len(op.Path.Commands) > 10 and "200" not in op.Report
        assert op.RollRadius.Value == pytest.approx(0.7)


def test_a_failed_operation_leaves_no_motion_in_the_posted_program(square):
    from evenload import host

    op = square.done(square.operation())
    op.EngagementAngle = 200
    square.refused(op)
    text = host.post(square.job, "linuxcnc", "--no-show-editor")
    assert "G1" not in text.replace("G17", "") and "G2 " not in text and "G3 " not in text


def test_the_other_operations_of_a_document_still_recompute(square):
    bad = square.operation(EngagementAngle=200)
    good = square.operation()
    square.doc.recompute()
    assert not bad.isValid()
    assert good.isValid() and len(good.Path.Commands) > 10


def test_a_job_without_tool_controllers_leaves_nothing_behind(square):
    from evenload.operations import adaptive

    square.job.Tools.Group = []
    before = len(square.doc.Objects)
    with pytest.raises(Exception):
        adaptive.Create("Operation", parentJob=square.job)
    assert len(square.doc.Objects) == before


def test_a_tree_without_the_compiled_modules_says_so_in_one_sentence(square, monkeypatch):
    from evenload import compiled

    op = square.done(square.operation())

    def not_built(*arguments):
        raise compiled.NotBuiltError(
            "EvenLoad's compiled modules are missing: run './run install'."
        )

    monkeypatch.setattr(compiled, "core", not_built)
    assert "compiled modules are missing" in square.refused(op)
    monkeypatch.undo()
    square.done(op)


def test_an_error_of_our_own_is_told_from_a_users_mistake(square, monkeypatch):
    op = square.done(square.operation())
    monkeypatch.setattr(type(op.Proxy), "generate", lambda *arguments: {}["missing"])
    op.touch()
    square.doc.recompute()
    assert not op.isValid() and op.Path.Commands == []
    assert op.Report == "EvenLoad failed: KeyError: 'missing'."


def test_create_job_checks_its_arguments(doc):
    from evenload import host

    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(SQUARE))
    for wrong in ({"tool_diameter": 0}, {"feed": -1}, {"spindle_speed": 0}):
        good = {"tool_diameter": 6, "feed": 255, "spindle_speed": 6366, "flutes": 1, **wrong}
        with pytest.raises(ValueError, match="%s must be positive" % list(wrong)[0]):
            host.create_job(doc, [part], **good)
    with pytest.raises(ValueError, match="at least one model"):
        host.create_job(doc, [], 6, 255, 6366, 1)
    assert [o.Name for o in doc.Objects] == ["Part"]
