"""View providers: icon, panel and selection of our operations."""

import os

import FreeCAD

from evenload import host
from evenload.gui import adaptive, finishing, lame_spiral, trochoid
from evenload.gui.icons import ICONS
from evenload.gui.selection import select, select_surfaces
from evenload.gui.slots import telling_slot
from evenload.gui.wrappers import forget_the_dead
from evenload.translation import translate

_gui = host.gui()


class ViewProvider(_gui.op.ViewProvider):
    """Documents refer to this class, and to those derived from it, by module and name: both stay.
    Nothing else is saved. This one is the adaptive operation's.
    """

    page = adaptive.OperationPage
    icon = "EvenLoad_Adaptive.svg"
    title = "EvenLoad Adaptive"

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

    @property
    def OpName(self):
        """That of the operation's page."""
        return translate(self.title)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads

    def getIcon(self):
        return self.OpIcon if self.Object is None or self.Object.Active else host.INACTIVE_ICON

    def getTaskPanelOpPage(self, obj):
        """FreeCAD calls this before it makes the widgets of the panel's other pages."""
        forget_the_dead()
        return self.page(obj, 0)

    def getSelectionFactory(self):
        return select

    def setupTaskPanel(self, panel):
        """FreeCAD calls this with the panel that it is about to show."""
        document = panel.obj.Document.Name
        accept = _unless_refused(panel.accept, panel.featurePages[-1].may_close)
        panel.accept = _in_document(document, accept)
        panel.reject = _in_document(document, telling_slot(panel.reject))
        panel.clicked = _in_document(document, telling_slot(panel.clicked))
        obj, panel.obj = panel.obj, _Unbound(panel.obj)
        try:
            super().setupTaskPanel(panel)
        finally:
            panel.obj = obj


class TrochoidViewProvider(ViewProvider):
    page = trochoid.OperationPage
    icon = "EvenLoad_Trochoid.svg"
    title = "EvenLoad Trochoid"


class LameSpiralViewProvider(ViewProvider):
    page = lame_spiral.OperationPage
    icon = "EvenLoad_LameSpiral.svg"
    title = "EvenLoad Lamé Spiral"


class FinishingViewProvider(ViewProvider):
    page = finishing.OperationPage
    icon = "EvenLoad_Finishing.svg"
    title = "EvenLoad Finishing"

    def getSelectionFactory(self):
        return select_surfaces


class _Unbound:
    """An operation as FreeCAD's panel is to see it while it is set up: it stumbles over expressions
    of single numbers of a place, and over those that cannot be evaluated, and would set nothing.
    """

    ExpressionEngine = ()

    def __init__(self, obj):
        self._obj = obj

    def __getattr__(self, name):
        return getattr(self._obj, name)


def _unless_refused(accept, may_close):
    """What FreeCAD calls at OK: the panel stays open where it may not close. Bound methods, whose
    objects are not kept alive.
    """
    accept, may_close = telling_slot(accept), telling_slot(may_close)
    return lambda: accept() if may_close() else False


def _in_document(name, call):
    """The same while a document, by its name, is the active one: FreeCAD's panels, and the lines
    that its macro recorder gets, look for everything in the active document, which may be another
    one by then.
    """

    def called(*arguments):
        before = FreeCAD.ActiveDocument.Name if FreeCAD.ActiveDocument is not None else ""
        if before == name or name not in FreeCAD.listDocuments():
            return call(*arguments)
        FreeCAD.setActiveDocument(name)
        try:
            return call(*arguments)
        finally:
            if before in FreeCAD.listDocuments():
                FreeCAD.setActiveDocument(before)

    return called


PROVIDERS = {  # by the names of operations
    "EvenLoad Trochoid": TrochoidViewProvider,
    "EvenLoad Lame Spiral": LameSpiralViewProvider,
    "EvenLoad Finishing": FinishingViewProvider,
}


def attach(obj):
    """Gives an operation and its job the view providers that they lack when a script made them."""
    view = obj.ViewObject
    if view is not None and not isinstance(view.Proxy, ViewProvider):
        PROVIDERS.get(obj.Proxy.name, ViewProvider)(view)
    job = host.parent_job(obj)
    if job is not None:
        host.show_job(job)
