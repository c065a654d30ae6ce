"""The finishing operation's panel."""

import FreeCAD
import FreeCADGui

from evenload.gui import panel, surface
from evenload.gui.base_page import SurfaceGeometryPage
from evenload.operations import finishing
from evenload.words import clock

_translate = FreeCAD.Qt.translate


class OperationPage(panel.OperationPage):
    kind = finishing.Finishing
    manual_page = "finishing_operation"
    taskPanelBaseGeometryPage = SurfaceGeometryPage

    def getForm(self):
        form = super().getForm()
        self.load.setIcon(FreeCADGui.getIcon("EvenLoad_ShowSurface"))
        self.load.setToolTip(
            _translate(
                "EvenLoad", "Colours the faces by what the path leaves on them, or ends that"
            )
        )
        self.load.setVisible(True)
        return form

    def toggle_view(self):
        surface.toggle(self.obj)

    def figures(self, values):
        if not values["CuttingTime"] > 0:
            return []
        length = FreeCAD.Units.Quantity(values["PathLength"], FreeCAD.Units.Length)
        return [
            (
                _translate("EvenLoad", "Time %s") % clock(values["CuttingTime"]),
                _translate("EvenLoad", "Cuts, links, entries and retracts at the path's own feeds"),
            ),
            (
                _translate("EvenLoad", "Path %s") % length.UserString,
                _translate("EvenLoad", "Length of cuts and of ways along the surface"),
            ),
            (
                _translate("EvenLoad", "Passes %d") % values["Passes"],
                _translate("EvenLoad", "Cuts without a break"),
            ),
            (
                _translate("EvenLoad", "Retracts %d") % values["Retracts"],
                _translate("EvenLoad", "How often the tool rises and comes down again"),
            ),
        ]


def create():
    """Creates the operation for what is selected and opens its panel."""
    return panel.create(finishing)
