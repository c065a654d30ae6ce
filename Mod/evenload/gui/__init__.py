"""What FreeCAD's GUI shows of us: commands, panels and view providers.

This module and `command` are light, for FreeCAD runs them at its start; everything else is imported
when a command runs or an operation is there.
"""

import FreeCAD
import FreeCADGui

from evenload import host, translation, units, window
from evenload.gui import command
from evenload.gui.icons import ICONS, LANGUAGES


def start():
    """Registers the commands and puts them into the Path / CAM workbench; from now on operations
    are shown.
    """
    FreeCADGui.addIconPath(ICONS)
    FreeCADGui.addLanguagePath(LANGUAGES)
    FreeCADGui.updateLocale()  # FreeCAD has looked for translations before it runs this
    translation.translator = FreeCAD.Qt.translate
    units.shows_inches = _shows_inches
    for name, instance in command.COMMANDS.items():
        FreeCADGui.addCommand(name, instance)
    host.add_to_workbench(list(command.COMMANDS))
    FreeCADGui.addPreferencePage(PreferencesPage, "EvenLoad")
    window.show, window.watch = _show, _watch


class PreferencesPage:
    """The page EvenLoad of FreeCAD's preferences, as FreeCAD asks for it."""

    def __init__(self, parent=None):
        # Here, for FreeCAD's start needs none of its widgets.
        from evenload.gui import preferences_page

        self._widgets = preferences_page.PageWidgets()
        self.form = self._widgets.form

    def loadSettings(self):
        self._widgets.show()

    def saveSettings(self):
        self._widgets.keep()


def _show(operation):
    from evenload.gui import views  # here, for it loads the Path / CAM workbench

    views.attach(operation)


def _watch(title):
    from evenload.gui import progress  # here, for FreeCAD's start needs none

    return progress.Watch(title)


def _shows_inches():
    from evenload.gui import fields  # here, for FreeCAD's start needs no widgets

    return fields.shows_inches()
