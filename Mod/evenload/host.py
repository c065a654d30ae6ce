"""The only file that knows FreeCAD's versions: 0.20 (PathScripts, workbench "Path"), 1.0 (Path.Op,
workbench "CAM") and 1.1 (tool bits are assets).
"""

import contextlib
import functools
import importlib
import io
import os
import tempfile
from types import SimpleNamespace

import FreeCAD

_VERSION = tuple(int(number) for number in FreeCAD.Version()[:2])
_MOVED = _VERSION >= (0, 21)  # PathScripts.PathOp has become Path.Op.Base, and so on
_CAM = _VERSION >= (1, 0)  # the workbench Path has become CAM
_ASSETS = _VERSION >= (1, 1)  # Path.Tool.Bit has become Path.Tool.toolbit, and shapes are assets

WORKBENCH = "CAMWorkbench" if _CAM else "PathWorkbench"
MENU = "&CAM" if _CAM else "&Path"
TOOLBAR = "New Operations"
NEIGHBOUR = "CAM_Adaptive" if _CAM else "Path_Adaptive"  # our commands stand beside this one
INACTIVE_ICON = ":/icons/CAM_OpActive.svg" if _CAM else ":/icons/Path_OpActive.svg"
# Whether FreeCAD ends its list of tool controllers with "Copy ..." and "New tool controller...". It
# acts on them only in a form that has a box editToolController in a QGridLayout.
LIST_MAKES_CONTROLLERS = _ASSETS


@functools.lru_cache(maxsize=None)
def cam():
    """FreeCAD's modules for operations and jobs, by short names. The first call takes 0.7 s."""
    import PathScripts.PathUtils as utils

    if _MOVED:
        import Path.Base.SetupSheet as setup_sheet
        import Path.Main.Job as job
        import Path.Main.Stock as stock
        import Path.Op.Base as op
        import Path.Preferences as preferences
        import Path.Tool.Controller as controller

        bit = importlib.import_module("Path.Tool." + ("toolbit" if _ASSETS else "Bit"))
    else:
        import PathScripts.PathJob as job
        import PathScripts.PathOp as op
        import PathScripts.PathPreferences as preferences
        import PathScripts.PathSetupSheet as setup_sheet
        import PathScripts.PathStock as stock
        import PathScripts.PathToolBit as bit
        import PathScripts.PathToolController as controller
    return SimpleNamespace(
        utils=utils,
        setup_sheet=setup_sheet,
        job=job,
        stock=stock,
        op=op,
        preferences=preferences,
        bit=bit,
        controller=controller,
    )


def operation_base():
    """The class that FreeCAD's operations derive from."""
    return cam().op.ObjectOp


def features():
    """What our operations share with FreeCAD's: tool, depths, heights, faces and edges, coolant."""
    op = cam().op
    return (
        op.FeatureTool
        | op.FeatureDepths
        | op.FeatureHeights
        | op.FeatureStepDown
        | op.FeatureBaseFaces
        | op.FeatureBaseEdges
        | op.FeatureCoolant
    )


def register_operation(name, create, properties):
    """Tells the SetupSheet of an operation, so that jobs and templates can keep defaults for it."""
    cam().setup_sheet.RegisterOperation(name, create, properties)


def freecads(kind, name, job, controller):
    """One of FreeCAD's own operations as a new one of a job, for comparisons; kind: 'Adaptive',
    'PocketShape', 'Profile', 'Drilling', ...
    """
    module = importlib.import_module(("Path.Op." if _MOVED else "PathScripts.Path") + kind)
    FreeCAD.setActiveDocument(job.Document.Name)
    with chosen_tool_controller(controller):
        op = module.Create(name, parentJob=job)
    op.ToolController = controller
    return op


def freecads_adaptive(name, job, controller):
    """FreeCAD's own Adaptive as a new operation of a job: for comparisons."""
    return freecads("Adaptive", name, job, controller)


def dressup(name):
    """FreeCAD's module of a dressup, with its Create(operation); name: 'Boundary', 'Dogbone' or
    'Tags'.
    """
    if _MOVED:
        gui = "Gui." if name == "Dogbone" else ""
        return importlib.import_module("Path.Dressup.%s%s" % (gui, name))
    old = {
        "Boundary": "PathDressupPathBoundary",
        "Dogbone": "PathDressupDogbone",
        "Tags": "PathDressupHoldingTags",
    }
    return importlib.import_module("PathScripts." + old[name])


def array(operation):
    """FreeCAD's array of an operation, as a new document object that is in no job yet."""
    module = importlib.import_module(("Path.Op.Gui." if _MOVED else "PathScripts.Path") + "Array")
    made = operation.Document.addObject("Path::FeaturePython", "Array")
    module.ObjectArray(made)
    made.Base = [operation]
    return made


def parent_job(obj):
    """The job that an operation belongs to, or None."""
    return cam().utils.findParentJob(obj)


def job_for_selection():
    """With a GUI, the active document's job, of several the one that the selection or else the user
    tells. None where there is none, or where the user cancels.
    """
    jobs = cam().utils.GetJobs()
    return cam().utils.UserInput.chooseJob(jobs) if len(jobs) > 1 else next(iter(jobs), None)


def no_tool_chosen():
    """What FreeCAD raises where the user cancels the choice of an operation's tool controller."""
    return cam().op.PathNoTCException


def operation_under(obj):
    """The operation that a dressup dresses, through any number of them; an operation itself."""
    while hasattr(getattr(obj, "Base", None), "Path"):
        obj = obj.Base
    return obj


def all_under(obj):
    """An operation, dressup or array, and all that it is made from, however deep."""
    result, waiting = [], [obj]
    while waiting:
        item = waiting.pop()
        if item in result or not hasattr(item, "Path"):
            continue
        result.append(item)
        below = getattr(item, "Base", None)
        # Arrays have a list of operations, operations one of base geometry.
        waiting += [b for b in (below if isinstance(below, list) else [below]) if b is not None]
    return result


def operations(job):
    """The job's operations in their order, dressed ones as their dressups."""
    return list(job.Operations.Group)


def call_after_recompute(function):
    """Has function(document) called after each recompute of a document, from now on."""

    class Observer:
        def slotRecomputedDocument(self, doc):
            function(doc)

    FreeCAD.addDocumentObserver(Observer())


def is_active(obj):
    """Whether an operation, or the one that a dressup dresses, takes part in the job."""
    return bool(getattr(operation_under(obj), "Active", True))


def turned_work_plane(obj):
    """The work plane of an operation, which FreeCAD has from 26.3 on, where it is turned against
    the job; else None. Base geometry and path are in its frame then.
    """
    plane = getattr(obj, "Workplane", None)
    if plane is None or plane.Placement.Rotation.isSame(FreeCAD.Rotation(), 1e-9):
        return None
    return plane


def controller_of(obj):
    """The tool controller of an operation or of the one that a dressup dresses; None without."""
    return getattr(operation_under(obj), "ToolController", None)


def cutting_levels(top, step_down, final_depth):
    """The z of each level in mm, descending; the last is final_depth itself. step_down > 0,
    final_depth < top.
    """
    levels = [
        float(z) for z in cam().utils.depth_params(top, top, top, step_down, 0.0, final_depth)
    ]
    between = [z for z in levels if final_depth + 1e-6 < z < top - 1e-6]
    return between + [float(final_depth)]


@contextlib.contextmanager
def chosen_tool_controller(controller):
    """While this lasts, FreeCAD takes `controller` where it would ask the user; without one, and
    without a user to ask, the job's first.
    """

    class Choice:
        def selectedToolController(self):
            return controller

        def chooseToolController(self, controllers):
            return controller or controllers[0]

        def __getattr__(self, name):
            return getattr(before, name)

    utils = cam().utils
    before = utils.UserInput
    if controller is not None or before is None:
        utils.UserInput = Choice()
    try:
        yield
    finally:
        utils.UserInput = before


def create_job(doc, models, tool_diameter, feed, spindle_speed, flutes):
    """A job with one flat end mill. Returns (job, tool controller).

    models: list of document objects; tool_diameter mm; feed mm/min, horizontal and vertical;
    spindle_speed rev/min; flutes: number of teeth. The stock is the models' bounding box.
    """
    for name, value in (
        ("tool_diameter", tool_diameter),
        ("feed", feed),
        ("spindle_speed", spindle_speed),
    ):
        if not value > 0:
            raise ValueError("%s must be positive, not %r." % (name, value))
    if not models:
        raise ValueError("A job needs at least one model.")
    FreeCAD.setActiveDocument(doc.Name)
    job = cam().job.Create("Job", list(models))
    if FreeCAD.GuiUp:
        show_job(job)
    controller = job.Tools.Group[0] if job.Tools.Group else cam().controller.Create()
    if not job.Tools.Group:
        job.Proxy.addToolController(controller)
    controller.Label = "TC: Default Tool"  # FreeCAD 1.1 calls it a 5mm Endmill, whatever it holds
    replaced = controller.Tool
    controller.Tool = create_tool("endmill", {"Diameter": tool_diameter, "Flutes": int(flutes)})
    if getattr(replaced, "Document", None) is doc:
        _remove_tool(replaced)
    controller.SpindleSpeed = float(spindle_speed)
    controller.HorizFeed = controller.VertFeed = "%.9g mm/min" % feed
    set_rapid_feed(controller, 5000.0)
    set_stock_margin(job, 0.0)
    doc.recompute()
    return job, controller


def create_tool(shape, properties):
    """A tool bit of one of FreeCAD's shapes ('endmill', 'bullnose', ...) in the active document.

    properties: {name: value}; lengths in mm. Raises ValueError for a shape or a property that
    FreeCAD does not have.
    """
    make = _tool_of_asset if _ASSETS else _tool_of_file
    tool = make(shape, properties)
    if FreeCAD.GuiUp:
        tool.ViewObject.Visibility = False
    return tool


def _tool_of_file(shape, properties):
    file = shape + ".fcstd"
    if cam().bit.findToolShape(file) is None:
        raise _no_such_shape(shape)
    attributes = {"shape": file, "name": shape, "parameter": properties, "attribute": {}}
    tool = cam().bit.Factory.CreateFromAttrs(attributes, "Tool")
    unknown = [name for name in properties if not hasattr(tool, name)]
    if unknown:
        _remove_tool(tool)
        raise _no_such_property(shape, unknown[0])
    return tool


def _tool_of_asset(shape, properties):
    from Path.Tool.camassets import cam_assets
    from Path.Tool.shape import ToolBitShape

    doc = FreeCAD.ActiveDocument  # reading a shape opens a document of its own
    asset = cam_assets.get_or_none(ToolBitShape.resolve_name(shape))
    if asset is None:
        raise _no_such_shape(shape)
    # FreeCAD itself would give the tool any other property too.
    for name in properties:
        if name not in asset.get_parameters():
            raise _no_such_property(shape, name)
    attributes = {"name": shape, "parameter": properties}
    return cam().bit.ToolBit.from_shape(asset, attributes).attach_to_doc(doc)


def _no_such_shape(shape):
    return ValueError("FreeCAD has no tool shape '%s': 'endmill' is one." % shape)


def _no_such_property(shape, name):
    return ValueError("A tool of the shape '%s' has no %s." % (shape, name))


def _remove_tool(tool):
    """Takes a tool bit out of its document, with the body by which FreeCAD 1.1 shows it."""
    doc, body = tool.Document, getattr(tool, "BitBody", None) if _ASSETS else None
    if body is not None:
        tool.BitBody = None
        body.removeObjectsFromDocument()
        doc.removeObject(body.Name)
    doc.removeObject(tool.Name)


def set_rapid_feed(controller, feed):
    """Sets a tool controller's rapid feeds, in mm/min; at first they follow the SetupSheet."""
    for name in ("HorizRapid", "VertRapid"):
        controller.setExpression(name, None)
        setattr(controller, name, "%.9g mm/min" % feed)


def set_stock_margin(job, margin):
    """Makes the job's stock the models' bounding box, larger by `margin` mm to all sides."""
    before = job.Stock
    extra = FreeCAD.Vector(margin, margin, margin)
    job.Stock = cam().stock.CreateFromBase(job, neg=extra, pos=extra)
    if before is not None and not before.InList:
        job.Document.removeObject(before.Name)
    if FreeCAD.GuiUp:
        job.Stock.ViewObject.Visibility = False


def post_processors():
    """The names of the post-processors that this FreeCAD has."""
    return cam().preferences.allAvailablePostProcessors()


def post(job, processor, arguments):
    """The G-code of the whole job, as text.

    processor: a name such as 'linuxcnc' or 'grbl'; arguments: its command line, e.g.
    '--no-show-editor --precision 4'. Raises ValueError for a processor that does not exist or
    fails, and for arguments that it refuses.
    """
    known = post_processors()
    if processor not in known:
        raise ValueError(
            "There is no post-processor '%s': this FreeCAD has %s."
            % (processor, ", ".join(sorted(known)))
        )
    try:
        with contextlib.redirect_stderr(io.StringIO()):  # post-processors print how to use them
            if _MOVED:
                texts = _post_modern(job, processor, arguments)
            else:
                texts = _post_old(job, processor, arguments)
    except SystemExit:  # what they do about arguments that they do not know
        texts = []
    except Exception as error:  # of FreeCAD's and other people's post-processors
        raise ValueError(
            "The post-processor '%s' failed (%s): choose another, or mend it."
            % (processor, named(error))
        ) from error
    if not texts or any(text is None for text in texts):
        raise ValueError(
            "The post-processor '%s' refuses the arguments '%s'." % (processor, arguments)
        )
    return "".join(texts)


def _post_modern(job, processor, arguments):
    from Path.Post.Processor import PostProcessorFactory

    before = job.PostProcessorArgs
    job.PostProcessorArgs = arguments
    try:
        sections = PostProcessorFactory.get_post_processor(job, processor).export()
    finally:
        job.PostProcessorArgs = before
    return [text for _, text in sections] if sections else []


def _post_old(job, processor, arguments):
    import FreeCADGui  # noqa: F401  PathPost needs it at import, without a GUI too
    from PathScripts.PathPost import CommandPathPost
    from PathScripts.PathPostProcessor import PostProcessor

    texts = []
    for objects in CommandPathPost().buildPostList(job):
        handle, name = tempfile.mkstemp(suffix=".ngc")
        os.close(handle)
        try:
            PostProcessor.load(processor).export(objects, name, arguments)
            with open(name) as file:
                texts.append(file.read() or None)
        finally:
            os.remove(name)
    return texts


def text_of(error):
    """What an exception says, without the dot at its end; FreeCAD's own carry a dictionary."""
    first = error.args[0] if error.args else ""
    text = first.get("sErrMsg", "") if isinstance(first, dict) else str(error)
    return " ".join(text.split()).rstrip(".")


def named(error):
    """An exception's kind and what it says."""
    return "%s: %s" % (type(error).__name__, text_of(error))


# ---- GUI: imported by evenload.gui only ----


def gui():
    """FreeCAD's GUI modules under one roof: op (panels), util (spin boxes), selection."""
    if _MOVED:
        import Path.Base.Gui.Util as util
        import Path.Op.Gui.Base as op
        import Path.Op.Gui.Selection as selection
    else:
        import PathScripts.PathGui as util
        import PathScripts.PathOpGui as op
        import PathScripts.PathSelection as selection
    return SimpleNamespace(op=op, util=util, selection=selection)


def show_value(box):
    """Brings one of FreeCAD's controllers of a spin box up to date with its property."""
    (box.updateWidget if _ASSETS else box.updateSpinBox)()


def show_job(job):
    """Gives a job and what belongs to it the view providers that they lack when a script made them.

    FreeCAD itself does this only for jobs that its own command makes.
    """
    if _MOVED:
        import Path.Base.Gui.IconViewProvider as icon
        import Path.Main.Gui.Job as job_gui
        import Path.Tool.Gui.Controller as controller_gui
    else:
        import PathScripts.PathIconViewProvider as icon
        import PathScripts.PathJobGui as job_gui
        import PathScripts.PathToolControllerGui as controller_gui
    for resource, name in (
        *((model, "BaseGeometry") for model in job.Model.Group),
        (job.Stock, "Stock"),
        (job.SetupSheet, "SetupSheet"),
    ):
        # Its Job panel asks for onEdit, which the view of Draft's clone has not.
        if resource is not None and not hasattr(resource.ViewObject.Proxy, "onEdit"):
            icon.Attach(resource.ViewObject, name)
            resource.ViewObject.Visibility = False
    for controller in job.Tools.Group:
        if not hasattr(controller.ViewObject.Proxy, "getIcon"):
            controller_gui.ViewProvider(controller.ViewObject)
    view = job.ViewObject
    if not hasattr(view.Proxy, "getIcon"):
        view.addExtension("Gui::ViewProviderGroupExtensionPython")
        view.Proxy = job_gui.ViewProvider(view)
        # FreeCAD takes it for the view of a job that is just being made, and Cancel in its first
        # panel would delete the job with all its operations.
        view.Proxy.deleteOnReject = False


def add_to_workbench(commands):
    """Puts commands beside FreeCAD's own in the Path / CAM workbench's menu and toolbar."""
    import FreeCADGui

    if hasattr(FreeCADGui, "addWorkbenchManipulator"):
        FreeCADGui.addWorkbenchManipulator(_Manipulator(commands))
        return
    workbench = FreeCADGui.listWorkbenches().get(WORKBENCH)
    if workbench is None:
        return
    initialize = workbench.Initialize

    def initialize_with_ours():
        initialize()
        workbench.appendToolbar(TOOLBAR, list(commands))
        workbench.appendMenu([MENU], list(commands))

    workbench.Initialize = initialize_with_ours


class _Manipulator:
    """What FreeCAD 1.0 asks when it fills menus and toolbars; it answers for every workbench,
    FreeCAD skips where the neighbour is missing.
    """

    def __init__(self, commands):
        self.commands = list(commands)

    def modifyMenuBar(self):
        return [{"insert": c, "menuItem": NEIGHBOUR, "after": ""} for c in self.commands]

    def modifyToolBars(self):
        return [{"insert": c, "toolItem": NEIGHBOUR, "after": ""} for c in self.commands]
