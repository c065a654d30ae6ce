"""The commands in the Path / CAM workbench: light, so that FreeCAD starts as fast as without us."""

from importlib import import_module

import FreeCAD

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
    "EvenLoad_StabilityChart": Command(
        "stability",
        "EvenLoad_StabilityChart",
        "EvenLoad Stability Chart",
        "Shows at which spindle speeds and depths an operation chatters, and finds the best cut",
    ),
}
