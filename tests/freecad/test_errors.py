"""Bad input: one sentence that names the thing and the remedy, an empty path, and nothing lost."""

import re
import types

import FreeCAD
import Part
import pytest
from conftest import reopened
from evenload import tool
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
        ({"EngagementAngle": 0}, ["Engagement angle", "0 and 180"]),
        ({"EngagementAngle": 180}, ["Engagement angle is 180", "0 and 180"]),
        ({"EngagementAngle": -20}, ["Engagement angle is -20", "0 and 180"]),
        ({"SideStep": 0}, ["Side step", "diameter of 6 mm"]),
        ({"SideStep": 6}, ["Side step is 6 mm", "diameter of 6 mm"]),
        ({"StartDepth": -3}, ["Start Depth (-3 mm)", "Final Depth (-3 mm)", "raise Start Depth"]),
        ({"StartDepth": -5}, ["Start Depth (-5 mm)", "raise Start Depth"]),
        ({"StepDown": 0}, ["Step Down is 0 mm", "positive"]),
        ({"StepDown": 0.0005}, ["Step Down is 0.0005 mm", "more than 5000 levels", "raise it"]),
        (
            {"EngagementAngle": 1},
            ["Side step is 0.0004", "Tolerance of 0.005 mm", "raise Engagement"],
        ),
        ({"Tolerance": 2}, ["Side step is 1.5 mm", "Tolerance of 2 mm"]),
        ({"SafeHeight": -1}, ["Safe Height (-1 mm)", "Start Depth (0 mm)", "raise it"]),
        ({"ClearanceHeight": 1}, ["Clearance Height (1 mm)", "Safe Height (3 mm)", "raise it"]),
        ({"FinalDepth": -31}, ["31 mm", "cutting length of 30 mm", "longer tool"]),
        ({"LinkFeed": 0}, ["Link feed is 0 mm/min", "positive"]),
        ({"MaximumFeed": "100 mm/min"}, ["Maximum feed is 100 mm/min", "255 mm/min"]),
        ({"LeastLoad": 1.0}, ["Least load is 1", "between 0 and 0.95"]),
        ({"RollRadius": 0}, ["Roll radius is 0 mm", "positive"]),
        ({"MinimumRadius": 0}, ["Minimum radius is 0 mm", "positive"]),
        ({"HelixDiameter": 0}, ["Helix diameter is 0 mm", "positive"]),
        ({"Tolerance": 0}, ["Tolerance is 0 mm", "positive"]),
        ({"HelixAngle": 0}, ["Helix angle is 0", "0 and 90"]),
        ({"HelixAngle": 90}, ["Helix angle is 90", "0 and 90"]),
        (
            {"Entry": "Predrilled hole"},
            ["'Predrilled hole'", "set Hole at (EntryPoint) and Hole diameter"],
        ),
        ({"ChooseOpenSide": True}, ["No side of Face", "turn Choose the open side"]),
        (
            {"HoleDiameter": 4, "EntryPoint": Vector(15, 15, 0)},
            ["Hole diameter (4 mm)", "diameter of 6 mm", "larger hole"],
        ),
        (
            {"HoleDiameter": 8, "EntryPoint": Vector(-5, 15, 0)},
            ["Hole at (EntryPoint) is (-5, 15)", "outside Face", "move it inside"],
        ),
        ({"StockToLeaveAxial": 3}, ["Stock at the floor (StockToLeaveAxial) is 3 mm", "lower it"]),
        (
            {"Entry": "Predrilled hole", "HoleDiameter": 8, "EntryPoint": Vector(40, 15, 0)},
            ["Hole at (EntryPoint) is (40, 15)", "outside Face", "move it inside"],
        ),
        (
            {"Entry": "Predrilled hole", "HoleDiameter": 8, "EntryPoint": Vector(1, 15, 0)},
            ["Hole at (EntryPoint)", "walls"],
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


@pytest.mark.parametrize(
    "shape, kind, word",
    [
        ("taperedballnose", "TaperedBallNose", "a tapered ball end mill"),
        ("my-ball", "Ballend", "a ball end mill"),
        ("my-endmill", "Endmill", None),
        ("my-bull", "Bullnose", None),
    ],
)
def test_tools_of_freecad_1_1_are_known_by_their_types(shape, kind, word):
    bit = types.SimpleNamespace(ShapeID=shape, ShapeType=kind)
    assert tool.other_shape(types.SimpleNamespace(Tool=bit)) == word


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
    assert sentence.endswith("is 0: set its %s. Feed." % name[: -len("Feed")])
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


def test_edges_that_do_not_close_are_named(square):
    level = [
        "Edge%d" % n
        for n, edge in enumerate(square.model.Shape.Edges, 1)
        if all(abs(v.Z + DEPTH) < 1e-6 for v in edge.Vertexes)
    ]
    sentence = square.refused(square.operation(base=[(square.model, tuple(level[:3]))]))
    assert sentence.startswith(", ".join(level[:3]) + " of ")
    assert "open" in sentence and "close it" in sentence


def test_edges_that_are_not_level_are_named(square):
    sentence = square.refused(square.operation(base=[(square.model, ("Edge1", "Edge2"))]))
    assert sentence.startswith("Edge1, Edge2 of ") and "climbs by 12 mm" in sentence
    assert "pick edges and sketches that are parallel to XY" in sentence


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


def crossed(doc, op):
    sketch = lines_sketch(doc, [(0, 0), (30, 20), (30, 0), (0, 10), (0, 0)])
    op.Base = [(sketch, "")]


def uncross(doc, op):
    sketch = doc.Outline
    for k in reversed(range(sketch.GeometryCount)):
        sketch.delGeometry(k)
    for a, b in zip(SQUARE, SQUARE[1:] + SQUARE[:1]):
        sketch.addGeometry(Part.LineSegment(Vector(*a[:2]), Vector(*b[:2])), False)


def left_open(doc, op):
    sketch = lines_sketch(doc, [(0, 0), (30, 0), (30, 20), (0, 20), (0, 0.5)])
    op.Base = [(sketch, "")]


def tilted(doc, op):
    box = doc.addObject("Part::Box", "Wedge")
    box.Placement.Rotation = FreeCAD.Rotation(Vector(1, 0, 0), 10)
    op.Base = [(box, ("Face6",))]


def round_face(doc, op):
    op.Base = [(doc.addObject("Part::Cylinder", "Cylinder"), ("Face1",))]


def floor_again(doc, op):
    model = doc.Job.Model.Group[0]
    op.Base = [(model, tuple(floors_of(model.Shape)))]


def other_tool(shape):
    def change_tool(doc, op):
        from evenload import host

        op.ToolController.Tool = host.create_tool(shape, {"Diameter": 6}) if shape else None

    return change_tool


def prop(**properties):
    """Sets properties of the operation, or those of its tool that it has not."""

    def set_them(doc, op):
        for name, value in properties.items():
            setattr(op if hasattr(op, name) else op.ToolController.Tool, name, value)

    return set_them


def turned_plane(doc, op):
    """What operations have from FreeCAD 26.3 on."""
    plane = doc.addObject("App::Placement", "Tilted")
    plane.Placement.Rotation = FreeCAD.Rotation(Vector(1, 0, 0), 90)
    op.addProperty("App::PropertyLink", "Workplane")
    op.Workplane = plane


def controller_again(doc, op):
    op.ToolController = doc.Job.Tools.Group[0]


HOLE = {"Entry": "Predrilled hole", "HoleDiameter": 8, "EntryPoint": Vector(15, 15, 0)}

# What spoils a square pocket, words of the sentence about it, and what mends it.
MISTAKES = {
    "an open wire": (
        left_open,
        ["Outline: ", "open", "close it"],
        lambda doc, op: doc.Outline.addGeometry(
            Part.LineSegment(Vector(0, 0.5, 0), Vector(0, 0, 0)), False
        ),
    ),
    "a sketch that crosses itself": (crossed, ["Outline: ", "crosses", "(10, 6.66667)"], uncross),
    "a tilted face": (
        tilted,
        ["Face6 of Wedge is tilted", "pick a face parallel to XY"],
        lambda doc, op: setattr(doc.Wedge, "Placement", FreeCAD.Placement()),
    ),
    "a round face": (
        round_face,
        ["Face1 of Cylinder is not flat", "pick a flat face parallel to XY"],
        floor_again,
    ),
    "no tool controller": (
        prop(ToolController=None),
        ["has no tool", "choose a tool controller"],
        controller_again,
    ),
    "a controller without tool": (
        other_tool(None),
        ["tool controller", "has no tool", "choose one"],
        other_tool("endmill"),
    ),
    "a tool of zero diameter": (prop(Diameter=0), ["is 0 mm", "set it"], prop(Diameter=6)),
    "a tool of negative diameter": (prop(Diameter=-2), ["is 0 mm", "set it"], prop(Diameter=6)),
    "a ball end mill": (
        other_tool("ballend"),
        ["a ball end mill", "choose a flat or bull-nosed end mill"],
        other_tool("endmill"),
    ),
    "a V bit": (
        other_tool("v-bit"),
        ["a V bit", "choose a flat or bull-nosed end mill"],
        other_tool("bullnose"),
    ),
    "a depth beyond the cutting length": (
        prop(CuttingEdgeHeight=2),
        ["depth of 3 mm", "cutting length of 2 mm", "longer tool or raise Final Depth"],
        prop(CuttingEdgeHeight=30),
    ),
    "an angle of zero": (
        prop(EngagementAngle=0),
        ["Engagement angle is 0 degrees", "between 0 and 180"],
        prop(EngagementAngle=60),
    ),
    "an angle of 200 degrees": (
        prop(EngagementAngle=200),
        ["Engagement angle is 200 degrees", "between 0 and 180"],
        prop(EngagementAngle=60),
    ),
    "a pocket too small for the tool": (
        prop(Diameter=40),
        ["tool of 40 mm does not fit", "largest tool that fits has 29.99"],
        prop(Diameter=29),
    ),
    "a start below the final depth": (
        prop(StartDepth=-4),
        ["Start Depth (-4 mm)", "Final Depth (-3 mm)", "raise Start Depth or lower Final Depth"],
        prop(StartDepth=0),
    ),
    "an entry point outside": (
        prop(**{**HOLE, "EntryPoint": Vector(40, 15, 0)}),
        ["Hole at (EntryPoint) is (40, 15)", "outside", "move it inside"],
        prop(**HOLE),
    ),
    "a turned work plane": (
        turned_plane,
        ["The work plane 'Tilted' is turned", "choose another"],
        prop(Workplane=None),
    ),
    "a hole smaller than the tool": (
        prop(**{**HOLE, "HoleDiameter": 5}),
        ["Hole diameter (5 mm)", "diameter of 6 mm", "drill a larger hole"],
        prop(**HOLE),
    ),
    "an unknown face": (
        lambda doc, op: setattr(op, "Base", [(doc.Job.Model.Group[0], ("Face99",))]),
        ["no Face99", "pick the geometry anew"],
        floor_again,
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_named_saved_reopened_and_mended(square, tmp_path, mistake):
    spoil, words, mend = MISTAKES[mistake]
    op = square.done(square.operation(RollRadius=0.7))
    spoil(square.doc, op)
    sentence = square.refused(op)
    for word in words:
        assert word in sentence, sentence
    name, base = op.Name, [(o.Name, names) for o, names in op.Base]
    with reopened(square.doc, tmp_path / "spoilt.FCStd") as doc:
        op = doc.getObject(name)
        assert op.Path.Commands == [] and op.Report == sentence
        assert [(o.Name, names) for o, names in op.Base] == base
        op.touch()
        doc.recompute()
        assert not op.isValid() and op.Path.Commands == [] and op.Report == sentence
        mend(doc, op)
        doc.recompute()  # FreeCAD 1.1 computes what depends on a mended tool bit only after this
        op.touch()
        doc.recompute()
        assert op.isValid(), op.Report
        assert len(op.Path.Commands) > 10 and sentence not in op.Report
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
