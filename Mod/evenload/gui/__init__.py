"""What FreeCAD's GUI shows of us: commands, panels and view providers.

This module and `command` are light; everything else is imported when a command runs.
"""

import os

ADDON = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(__file__))))
ICONS = os.path.join(ADDON, "Resources", "icons")


def start():
    """Registers the commands and puts them into the Path / CAM workbench."""
    import FreeCADGui

    from evenload import host
    from evenload.gui import command

    FreeCADGui.addIconPath(ICONS)
    for name, instance in command.COMMANDS.items():
        FreeCADGui.addCommand(name, instance)
    host.add_to_workbench(list(command.COMMANDS))
