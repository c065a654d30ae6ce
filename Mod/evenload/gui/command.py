"""The commands in the Path / CAM workbench: light, so that FreeCAD starts as fast as without us."""

from importlib import import_module

import FreeCAD
import FreeCADGui

from evenload import compiled


def _translated(text):
    return FreeCAD.Qt.translate("EvenLoad", text)


class Command:
    """Creates an operation for what is selected and opens its panel, or opens a window."""

    def __init__(self, panel, icon, menu_text, tool_tip):
        self.panel = panel  # module in evenload.gui whose function `create` does it
        self.resources = icon, menu_text, tool_tip

    def GetResources(self):
        icon, menu_text, tool_tip = self.resources
        return {
            "Pixmap": icon,
            "MenuText": _translated(menu_text),
            "ToolTip": _translated(tool_tip),
        }

    def IsActive(self):
        doc = FreeCAD.ActiveDocument
        return doc is not None and any(o.Name.startswith("Job") for o in doc.Objects)

    def Activated(self):
        missing = compiled.missing()
        if missing:
            FreeCAD.Console.PrintError(missing + "\n")
            return
        # Not before: panels load the Path / CAM workbench.
        import_module("evenload.gui." + self.panel).create()


class _OfPath:
    """A command on the selected operation's path: `show` gets the operation."""

    def IsActive(self):
        return _selected_path() is not None

    def Activated(self):
        missing = compiled.missing()
        if missing:
            FreeCAD.Console.PrintError(missing + "\n")
            return
        # What shows it is not imported before: it loads the simulator and the workbench.
        self.show(_selected_path())


class ShowLoad(_OfPath):
    """Colours the path of the selected operation by its load, or takes the colours away again."""

    def GetResources(self):
        return {
            "Pixmap": "EvenLoad_ShowLoad",
            "MenuText": _translated("EvenLoad Show Load"),
            "ToolTip": _translated(
                "Colours the path of the selected operation by engagement, removal rate, feed, "
                "chip thickness or force, or takes the colours away again"
            ),
        }

    def show(self, operation):
        import_module("evenload.gui.load_view").toggle(operation)


class Simulation(_OfPath):
    """Opens the window that shows the load of the selected operation over time."""

    def GetResources(self):
        return {
            "Pixmap": "EvenLoad_Simulation",
            "MenuText": _translated("EvenLoad Simulation"),
            "ToolTip": _translated(
                "Shows engagement, removal rate and force of the selected operation over time, "
                "beside another one if wished, with a cursor in the 3D view"
            ),
        }

    def show(self, operation):
        import_module("evenload.gui.simulation").show(operation)


def _selected_path():
    """The one selected operation, dressup or array that has a path; None without."""
    selected = FreeCADGui.Selection.getSelection()
    if len(selected) != 1 or hasattr(selected[0], "Operations"):  # a job
        return None
    path = getattr(selected[0], "Path", None)
    return selected[0] if getattr(path, "Size", 0) > 0 else None


class Inspect:
    """Opens the dock that tells where to measure the selected faces, and what points say."""

    def GetResources(self):
        return {
            "Pixmap": "EvenLoad_Inspect",
            "MenuText": _translated("EvenLoad Inspect"),
            "ToolTip": _translated(
                "Tells where to measure the selected faces, and how far measured points lie from "
                "them"
            ),
        }

    def IsActive(self):
        return any(
            name.startswith("Face")
            for selected in FreeCADGui.Selection.getSelectionEx()
            for name in selected.SubElementNames
        )

    def Activated(self):
        missing = compiled.missing()
        if missing:
            FreeCAD.Console.PrintError(missing + "\n")
            return
        # Not before: it loads matplotlib and the Path / CAM workbench.
        import_module("evenload.gui.inspection").create()


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
    "EvenLoad_ShowLoad": ShowLoad(),
    "EvenLoad_Simulation": Simulation(),
    "EvenLoad_Finishing": Command(
        "finishing",
        "EvenLoad_Finishing",
        "EvenLoad Finishing",
        "Finishes faces by passes of a ball end, bull-nosed or flat tool",
    ),
    "EvenLoad_StabilityChart": Command(
        "stability",
        "EvenLoad_StabilityChart",
        "EvenLoad Stability Chart",
        "Shows at which spindle speeds and depths an operation chatters, and finds the best cut",
    ),
    "EvenLoad_Inspect": Inspect(),
}
