"""The commands in the Path / CAM workbench: light, so that FreeCAD starts as fast as without us."""

from importlib import import_module

import FreeCAD
import FreeCADGui

from evenload import compiled, host
from evenload.gui import manual
from evenload.settings.properties import is_ours
from evenload.settings.sentences import shown


class Command:
    """What is done by a module of evenload.gui, and for what: in a document with a job, it creates
    an operation and opens its panel, or opens a window.
    """

    def __init__(self, module, icon, menu_text, tool_tip, page, keys, does="create"):
        """module: of evenload.gui, does: its function, icon: a name without the file's ending;
        page: its name in the documentation, keys: its shortcut at first.
        """
        self.module, self.does, self.page = module, does, page
        self.resources = {
            "Pixmap": icon,
            "MenuText": menu_text,
            "ToolTip": tool_tip,
            "WhatsThis": manual.address(page),
            "Accel": keys,
        }

    def GetResources(self):
        """In English: FreeCAD translates them, in a context of the command's name, and does so
        anew where the user takes another language.
        """
        return dict(self.resources)

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


def _selected_paths():
    """The selected operations, dressups and arrays; none where anything else is selected, or one of
    them has no path.
    """
    selected = FreeCADGui.Selection.getSelection()
    return selected if all(map(_has_path, selected)) else []


def _has_path(obj):
    return host.path_size(obj) > 0 and not hasattr(obj, "Operations")  # no job


def _selected_path():
    """The one selected operation, dressup or array that has a path; None without."""
    selected = _selected_paths()
    return selected[0] if len(selected) == 1 else None


class OfTwoPaths(Command):
    """For two selected operations, dressups or arrays that have paths, or for one whose job has
    another.
    """

    def IsActive(self):
        selected = _selected_paths()
        if len(selected) == 1:
            return any(each != selected[0] for each in host.with_path(host.parent_job(selected[0])))
        return len(selected) == 2

    def arguments(self):
        return _selected_paths()


class OfJob(Command):
    """For the selected job, or the only one, where an operation of it has a path."""

    def IsActive(self):
        return _chosen_job() is not None

    def arguments(self):
        return (_chosen_job(),)


def _chosen_job():
    """The selected job or that of the selected operations, or the only one of the document; None
    without, or without a path in it.
    """
    doc = FreeCAD.ActiveDocument
    jobs = [o for o in doc.Objects if getattr(o, "Operations", None) is not None] if doc else []
    selected = FreeCADGui.Selection.getSelection()
    owners = [o if o in jobs else host.parent_job(o) for o in selected if o in jobs or _has_path(o)]
    chosen = list(dict.fromkeys(owner for owner in owners if owner is not None)) or jobs
    return chosen[0] if len(chosen) == 1 and host.with_path(chosen[0]) else None


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


# Two keys, as FreeCAD has them; the first is that of no command in 0.20, 1.0 and 1.1.
COMMANDS = {
    "EvenLoad_Adaptive": Command(
        "adaptive",
        "EvenLoad_Adaptive",
        "EvenLoad Adaptive",
        "Clears pockets at constant engagement of the tool",
        page="adaptive_operation",
        keys="Y, A",
    ),
    "EvenLoad_Trochoid": Command(
        "trochoid",
        "EvenLoad_Trochoid",
        "EvenLoad Trochoid",
        "Cuts slots by trochoids at constant engagement of the tool",
        page="trochoid_operation",
        keys="Y, T",
    ),
    "EvenLoad_LameSpiral": Command(
        "lame_spiral",
        "EvenLoad_LameSpiral",
        "EvenLoad Lamé Spiral",
        "Clears round, square and many-sided pockets, and round islands of such shapes, by spirals",
        page="lame_spiral_operation",
        keys="Y, L",
    ),
    "EvenLoad_ShowLoad": OfPath(
        "load_view",
        "EvenLoad_ShowLoad",
        "EvenLoad Show Load",
        "Colours the path of the selected operation by engagement, removal rate, feed, chip "
        "thickness or force, or takes the colours away again",
        page="load_view",
        keys="Y, W",
        does="toggle",
    ),
    "EvenLoad_ShowSurface": OfPath(
        "surface",
        "EvenLoad_ShowSurface",
        "EvenLoad Show Surface",
        "Colours the faces below the selected operation by cusps, gouges, what is left, chip "
        "thickness or the tip's share, or takes the colours away again",
        page="surface_view",
        keys="Y, V",
        does="toggle",
    ),
    "EvenLoad_Simulation": OfPath(
        "simulation",
        "EvenLoad_Simulation",
        "EvenLoad Simulation",
        "Shows engagement, removal rate and force of the selected operation over time, beside "
        "another one if wished, with a cursor in the 3D view",
        page="simulation_window",
        keys="Y, S",
        does="show",
    ),
    "EvenLoad_Compare": OfTwoPaths(
        "simulation",
        "EvenLoad_Compare",
        "EvenLoad Compare",
        "Shows the load of two selected operations over time on one scale; of one, asks which "
        "other one to set beside it",
        page="simulation_window",
        keys="Y, C",
        does="compare",
    ),
    "EvenLoad_Report": OfJob(
        "report",
        "EvenLoad_Report",
        "EvenLoad Report",
        "Simulates the operations of the job, writes a report to print and opens it in the browser",
        page="simulation_window",
        keys="Y, R",
        does="write",
    ),
    "EvenLoad_Finishing": Command(
        "finishing",
        "EvenLoad_Finishing",
        "EvenLoad Finishing",
        "Finishes faces by passes of a ball end, bull-nosed or flat tool",
        page="finishing_operation",
        keys="Y, F",
    ),
    "EvenLoad_FinishingAdvisor": OfFinishing(
        "advisor",
        "EvenLoad_FinishingAdvisor",
        "EvenLoad Finishing Advisor",
        "Compares ten strategies for the selected faces or finishing operation by time, chips, "
        "cusps, tip and force, and makes an operation of one",
        page="finishing_advisor",
        keys="Y, D",
        does="show",
    ),
    "EvenLoad_StabilityChart": Command(
        "stability",
        "EvenLoad_StabilityChart",
        "EvenLoad Stability Chart",
        "Shows at which spindle speeds and depths an operation chatters, and finds the best cut",
        page="stability_chart",
        keys="Y, B",
    ),
    "EvenLoad_Optimise": OfCut(
        "optimise",
        "EvenLoad_Optimise",
        "EvenLoad Optimise",
        "Suggests engagement angle, step down, spindle speed and feeds within what tool and "
        "machine stand, beside what is set now",
        page="optimisation",
        keys="Y, O",
        does="show",
    ),
    "EvenLoad_Inspect": OfFaces(
        "inspection",
        "EvenLoad_Inspect",
        "EvenLoad Inspect",
        "Tells where to measure the selected faces, and how far measured points lie from them",
        page="inspect",
        keys="Y, I",
    ),
}
