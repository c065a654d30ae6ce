"""The finishing operation's panel."""

import FreeCAD

from evenload.gui import panel
from evenload.gui.base_page import SurfaceGeometryPage
from evenload.operations import finishing
from evenload.words import clock

_translate = FreeCAD.Qt.translate


class OperationPage(panel.OperationPage):
    kind = finishing.Finishing
    taskPanelBaseGeometryPage = SurfaceGeometryPage

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
