"""The commands in the Path / CAM workbench: light, so that FreeCAD starts as fast as without us."""

from importlib import import_module

import FreeCAD
import FreeCADGui

from evenload import compiled, host
from evenload.settings.properties import is_ours
from evenload.settings.sentences import shown


class Command:
    """What is done by a module of evenload.gui, and for what: in a document with a job, it creates
    an operation and opens its panel, or opens a window.
    """

    def __init__(self, module, icon, menu_text, tool_tip, does="create"):
        """module: of evenload.gui, does: its function, icon: a name without the file's ending."""
        self.module, self.does = module, does
        self.resources = icon, menu_text, tool_tip

    def GetResources(self):
        """In English: FreeCAD translates them, in a context of the command's name, and does so
        anew where the user takes another language.
        """
        return dict(zip(("Pixmap", "MenuText", "ToolTip"), self.resources))

    def IsActive(self):
        doc = FreeCAD.ActiveDocument
        return doc is not None and any(o.Name.startswith("Job") for o in doc.Objects)

    def Activated(self):
        missing = compiled.missing()
        if missing:
            FreeCAD.Console.PrintError(shown(missing) + "\n")
            return
        # Not before: these modules load matplotlib, the simulator and the Path / CAM workbench.
        module = import_module("evenload.gui." + self.module)
        getattr(module, self.does)(*self.arguments())

    def arguments(self):
        """Those of the module's function."""
        return ()


class OfPath(Command):
    """For the selected operation, dressup or array that has a path."""

    def IsActive(self):
        return _selected_path() is not None

    def arguments(self):
        return (_selected_path(),)


def _selected_path():
    """The one selected operation, dressup or array that has a path; None without."""
    selected = FreeCADGui.Selection.getSelection()
    if len(selected) != 1 or hasattr(selected[0], "Operations"):  # a job
        return None
    path = getattr(selected[0], "Path", None)
    return selected[0] if getattr(path, "Size", 0) > 0 else None


class OfCut(OfPath):
    """For one of our operations that clears floors, or a dressup of one, that has a path."""

    def IsActive(self):
        found = _selected_path()
        return found is not None and is_ours(host.operation_under(found))


class OfFaces(Command):
    """For the selected faces, in a job or not."""

    def IsActive(self):
        return any(
            name.startswith("Face")
            for selected in FreeCADGui.Selection.getSelectionEx()
            for name in selected.SubElementNames
        )


class OfFinishing(OfFaces):
    """For a selected operation EvenLoad Finishing, or for selected faces where there is a job."""

    def IsActive(self):
        selected = FreeCADGui.Selection.getSelection()
        if len(selected) == 1 and _is_finishing(selected[0]):
            return True
        return Command.IsActive(self) and super().IsActive()


def _is_finishing(obj):
    """By the name of its class's module, which documents keep: importing it takes its time."""
    return type(getattr(obj, "Proxy", None)).__module__ == "evenload.operations.finishing"


COMMANDS = {
    "EvenLoad_Adaptive": Command(
        "adaptive",
        "EvenLoad_Adaptive",
        "EvenLoad Adaptive",
        "Clears pockets at constant engagement of the tool",
    ),
    "EvenLoad_Trochoid": Command(
        "trochoid",
        "EvenLoad_Trochoid",
        "EvenLoad Trochoid",
        "Cuts slots by trochoids at constant engagement of the tool",
    ),
    "EvenLoad_LameSpiral": Command(
        "lame_spiral",
        "EvenLoad_LameSpiral",
        "EvenLoad Lamé Spiral",
        "Clears round, square and many-sided pockets, and round islands of such shapes, by spirals",
    ),
    "EvenLoad_ShowLoad": OfPath(
        "load_view",
        "EvenLoad_ShowLoad",
        "EvenLoad Show Load",
        "Colours the path of the selected operation by engagement, removal rate, feed, chip "
        "thickness or force, or takes the colours away again",
        does="toggle",
    ),
    "EvenLoad_Simulation": OfPath(
        "simulation",
        "EvenLoad_Simulation",
        "EvenLoad Simulation",
        "Shows engagement, removal rate and force of the selected operation over time, beside "
        "another one if wished, with a cursor in the 3D view",
        does="show",
    ),
    "EvenLoad_Finishing": Command(
        "finishing",
        "EvenLoad_Finishing",
        "EvenLoad Finishing",
        "Finishes faces by passes of a ball end, bull-nosed or flat tool",
    ),
    "EvenLoad_FinishingAdvisor": OfFinishing(
        "advisor",
        "EvenLoad_FinishingAdvisor",
        "EvenLoad Finishing Advisor",
        "Compares ten strategies for the selected faces or finishing operation by time, chips, "
        "cusps, tip and force, and makes an operation of one",
        does="show",
    ),
    "EvenLoad_StabilityChart": Command(
        "stability",
        "EvenLoad_StabilityChart",
        "EvenLoad Stability Chart",
        "Shows at which spindle speeds and depths an operation chatters, and finds the best cut",
    ),
    "EvenLoad_Optimise": OfCut(
        "optimise",
        "EvenLoad_Optimise",
        "EvenLoad Optimise",
        "Suggests engagement angle, step down, spindle speed and feeds within what tool and "
        "machine stand, beside what is set now",
        does="show",
    ),
    "EvenLoad_Inspect": OfFaces(
        "inspection",
        "EvenLoad_Inspect",
        "EvenLoad Inspect",
        "Tells where to measure the selected faces, and how far measured points lie from them",
    ),
}
