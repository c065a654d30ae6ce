"""What makes a kind of operation one of FreeCAD's: its registration, new ones, and those that
FreeCAD leaves out.
"""

import FreeCAD

from evenload import host
from evenload.operations import dressed
from evenload.operations.base import Operation, show


def register(proxy_class, create):
    """Tells FreeCAD of a kind of operation, so that jobs and templates can keep defaults for it."""
    names = [setting.name for setting in proxy_class.settings if setting.in_setup_sheet()]
    host.register_operation(proxy_class.name, create, lambda: names)


def create(proxy_class, name, obj=None, parentJob=None, toolController=None):
    """A new operation of a proxy class: what every operation's Create does.

    name: of the new document object; obj: one to use instead; parentJob: the job, needed when there
    are several; toolController: one of the job's, needed when there are several and nobody can be
    asked. Nothing is left in the document when it fails.
    """
    made = obj is None
    if made:
        doc = parentJob.Document if parentJob else FreeCAD.ActiveDocument
        FreeCAD.setActiveDocument(doc.Name)
        obj = doc.addObject("Path::FeaturePython", name)
    try:
        obj.Proxy = proxy_class(obj, name, parentJob, toolController)
    except Exception:
        if made:
            obj.Document.removeObject(obj.Name)
        raise
    show(obj)
    return obj


def _is_ours(obj):
    return isinstance(getattr(obj, "Proxy", None), Operation)


def _compute_left_out(doc):
    """Computes the operations that FreeCAD has left out because their tool controller failed: 1.1
    does so where it has no tool, and would keep the path that was for another tool.
    """
    for obj in doc.Objects:
        if not _is_ours(obj):
            continue
        controller = host.controller_of(obj)
        if controller is not None and not controller.isValid() and obj.isValid():
            obj.recompute()


host.call_after_recompute(_compute_left_out)
host.call_after_recompute(lambda doc: dressed.empty_far_ones(doc, _is_ours))
