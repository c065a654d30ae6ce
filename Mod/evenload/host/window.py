"""FreeCAD's window: for evenload.gui, and for what is made while there is one."""

import importlib
import importlib.util
from types import SimpleNamespace

from evenload.host.versions import ASSETS, CAM, MOVED

WORKBENCH = "CAMWorkbench" if CAM else "PathWorkbench"
MENU = "&CAM" if CAM else "&Path"
TOOLBAR = "New Operations"
NEIGHBOUR = "CAM_Adaptive" if CAM else "Path_Adaptive"  # our commands stand beside this one
INACTIVE_ICON = ":/icons/CAM_OpActive.svg" if CAM else ":/icons/Path_OpActive.svg"
# Whether FreeCAD ends its list of tool controllers with "Copy ..." and "New tool controller...". It
# acts on them only in a form that has a box editToolController in a QGridLayout.
LIST_MAKES_CONTROLLERS = ASSETS


def gui():
    """FreeCAD's GUI modules under one roof: op (panels), util (spin boxes), selection."""
    if MOVED:
        import Path.Base.Gui.Util as util
        import Path.Op.Gui.Base as op
        import Path.Op.Gui.Selection as selection
    else:
        import PathScripts.PathGui as util
        import PathScripts.PathOpGui as op
        import PathScripts.PathSelection as selection
    return SimpleNamespace(op=op, util=util, selection=selection)


def show_value(box):
    """Brings one of FreeCAD's controllers of a spin box up to date with its property, or with the
    expression of that, where it can be evaluated.
    """
    update = box.updateWidget if ASSETS else box.updateSpinBox
    try:
        update()
    except (
        ArithmeticError,
        RuntimeError,
        ValueError,
    ):  # as FreeCAD passes on what went wrong in it
        update(getattr(box.obj, box.prop))


def show_controller(page):
    """Shows the tool controller's values anew in a page of an operation's panel that edits these,
    too, as FreeCAD 1.1 has it: as they are shown they are set when the panel closes.
    """
    editor = getattr(page, "tcEditor", None)
    if editor is not None:
        editor.updateUi()


FIELDS = {
    "StartDepth": "startDepth",
    "FinalDepth": "finalDepth",
    "StepDown": "stepDown",
    "SafeHeight": "safeHeight",
    "ClearanceHeight": "clearanceHeight",
}


def show_field(panel, name):
    """Shows the field that an operation's panel has for one of FreeCAD's own properties, on
    whichever page it is; tells whether there is one.
    """
    for page in panel.featurePages:
        field = getattr(page.form, FIELDS.get(name, ""), None)
        if field is not None:
            if hasattr(panel.form, "setCurrentWidget"):  # pages in one box, as by default
                panel.form.setCurrentWidget(page.form)
            field.setFocus()
            return True
    return False


def show_job(job):
    """Gives a job and what belongs to it the view providers that they lack when a script made them.

    FreeCAD itself does this only for jobs that its own command makes.
    """
    if MOVED:
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


def show_help(address):
    """Opens a page of a documentation as FreeCAD does for What's This: by its module Help, which
    1.0 and 1.1 bring along and 0.20 has as an addon, or in the browser.
    """
    if importlib.util.find_spec("Help") is not None:
        importlib.import_module("Help").show(address)
        return
    from PySide import QtCore, QtGui

    QtGui.QDesktopServices.openUrl(QtCore.QUrl(address))


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

    def with_ours(append):
        def appended(place, names):
            at = names.index(NEIGHBOUR) + 1 if NEIGHBOUR in names else None
            append(place, names if at is None else [*names[:at], *commands, *names[at:]])

        return appended

    def initialize_with_ours():
        appending = {name: getattr(workbench, name) for name in ("appendToolbar", "appendMenu")}
        for name, append in appending.items():
            setattr(workbench, name, with_ours(append))
        try:
            initialize()
        finally:
            for name in appending:
                delattr(workbench, name)  # the class's own stands again

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
