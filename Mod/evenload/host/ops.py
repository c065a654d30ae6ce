"""FreeCAD's operations, dressups and arrays, and what they share with ours."""

import contextlib
import importlib

import FreeCAD

from evenload.host.versions import MOVED, cam


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


def surface_features():
    """The same for operations on surfaces, which have faces alone, and no levels."""
    op = cam().op
    return (
        op.FeatureTool
        | op.FeatureDepths
        | op.FeatureHeights
        | op.FeatureBaseFaces
        | op.FeatureCoolant
    )


def register_operation(name, create, properties):
    """Tells the SetupSheet of an operation, so that jobs and templates can keep defaults for it."""
    cam().setup_sheet.RegisterOperation(name, create, properties)


def freecads(kind, name, job, controller):
    """One of FreeCAD's own operations as a new one of a job; kind: 'Adaptive', 'PocketShape',
    'Profile', 'Drilling', 'Custom', ...
    """
    module = importlib.import_module(("Path.Op." if MOVED else "PathScripts.Path") + kind)
    FreeCAD.setActiveDocument(job.Document.Name)
    with chosen_tool_controller(controller):
        op = module.Create(name, parentJob=job)
    op.ToolController = controller
    return op


def freecads_adaptive(name, job, controller):
    """FreeCAD's own Adaptive as a new operation of a job: for comparisons."""
    return freecads("Adaptive", name, job, controller)


def array(operation):
    """FreeCAD's array of an operation, as a new document object that is in no job yet."""
    module = importlib.import_module(("Path.Op.Gui." if MOVED else "PathScripts.Path") + "Array")
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
    while has_path(getattr(obj, "Base", None)):
        obj = obj.Base
    return obj


def has_path(obj):
    """Whether something is a document object with the property Path, which is not read: FreeCAD
    copies a path that is read.
    """
    return isinstance(obj, FreeCAD.DocumentObject) and "Path" in obj.PropertiesList


def all_under(obj):
    """An operation, dressup or array, and all that it is made from, however deep."""
    result, waiting = [], [obj]
    while waiting:
        item = waiting.pop()
        if item in result or not has_path(item):
            continue
        result.append(item)
        below = getattr(item, "Base", None)
        # Arrays have a list of operations, operations one of base geometry.
        waiting += [b for b in (below if isinstance(below, list) else [below]) if b is not None]
    return result


def operations(job):
    """The job's operations in their order, dressed ones as their dressups."""
    return list(job.Operations.Group)


def with_path(job):
    """The operations of a job that have a path, in their order; none of no job."""
    return [each for each in operations(job) if path_size(each) > 1] if job else []


def path_size(obj):
    """The number of commands of the path of a document object; 0 of one without a path. FreeCAD
    copies a path that is read, which takes 16 ms for 30 000 commands, and asks each command of ours
    whether it can work whenever something is clicked: so numbers are kept until a path changes.
    """
    if _Sizes.known is None:
        _Sizes.known = _Sizes()
        FreeCAD.addDocumentObserver(_Sizes.known)
    return _Sizes.known.of(obj)


class _Sizes:
    known = None  # the one that FreeCAD tells of changes

    def __init__(self):
        self._sizes = {}

    def of(self, obj):
        key = obj.Document.Name, obj.Name
        if key not in self._sizes:
            has_path = "Path" in obj.PropertiesList and hasattr(obj.Path, "Size")
            self._sizes[key] = obj.Path.Size if has_path else 0
        return self._sizes[key]

    def slotChangedObject(self, obj, prop):
        if prop == "Path":
            self._sizes.pop((obj.Document.Name, obj.Name), None)

    def _forget_all(self, *_):
        self._sizes.clear()

    slotCreatedObject = slotDeletedObject = slotDeletedDocument = _forget_all
    slotUndoDocument = slotRedoDocument = slotFinishRestoreDocument = _forget_all


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
