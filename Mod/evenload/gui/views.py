"""View providers: icon, panel and selection of our operations."""

import os

from evenload import host
from evenload.gui import ICONS

_gui = host.gui()


class Gate:
    """What can be selected while a panel is open: level faces, edges, sketches."""

    def allow(self, doc, obj, sub):
        shape = getattr(obj, "Shape", None)
        if shape is None or shape.isNull():
            return False
        if is_outline(obj) or sub.startswith("Edge"):
            return True
        if not sub.startswith("Face"):
            return False
        box = shape.getElement(sub).BoundBox
        return box.ZLength < 1e-6


def is_outline(obj):
    """Whether an object is base geometry as a whole: a sketch, or wires without a solid."""
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        return False
    return obj.isDerivedFrom("Sketcher::SketchObject") or not (shape.Solids or shape.Shells)


def select():
    """FreeCAD calls this when a panel opens; it removes the gate itself."""
    import FreeCADGui

    FreeCADGui.Selection.addSelectionGate(Gate())


class ViewProvider(_gui.op.ViewProvider):
    """Documents refer to this class, and to those derived from it, by module and name: both stay.
    Nothing else is saved. This one is the adaptive operation's.
    """

    panel_module = "evenload.gui.adaptive"
    icon = "EvenLoad_Adaptive.svg"
    OpName = "EvenLoad Adaptive"

    # Restored view providers come into being without __init__.
    deleteOnReject = False
    panel = None
    vobj = None
    Object = None

    def __init__(self, vobj):
        vobj.Proxy = self

    @property
    def OpIcon(self):
        """FreeCAD hands this to the panel."""
        return os.path.join(ICONS, self.icon)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads

    def getIcon(self):
        return self.OpIcon if self.Object is None or self.Object.Active else host.INACTIVE_ICON

    def getTaskPanelOpPage(self, obj):
        from importlib import import_module

        return import_module(self.panel_module).OperationPage(obj, 0)

    def getSelectionFactory(self):
        return select


class TrochoidViewProvider(ViewProvider):
    panel_module = "evenload.gui.trochoid"
    icon = "EvenLoad_Trochoid.svg"
    OpName = "EvenLoad Trochoid"


class LameSpiralViewProvider(ViewProvider):
    panel_module = "evenload.gui.lame_spiral"
    icon = "EvenLoad_LameSpiral.svg"
    OpName = "EvenLoad Lame Spiral"


PROVIDERS = {each.OpName: each for each in (TrochoidViewProvider, LameSpiralViewProvider)}


def attach(obj):
    """Gives an operation and its job the view providers that they lack when a script made them."""
    view = obj.ViewObject
    if view is not None and not isinstance(view.Proxy, ViewProvider):
        PROVIDERS.get(obj.Proxy.name, ViewProvider)(view)
    job = host.parent_job(obj)
    if job is not None:
        host.show_job(job)
