"""The path of a simulation as a Coin node: a line through all samples, and the tool at a place."""

import numpy
from pivy import coin

from evenload.gui.nodes import unpickable
from evenload.gui.path_line import PathLine

TOOL_COLOUR, TOOL_TRANSPARENCY = (0.91, 0.64, 0.24), 0.45
TOOL_HEIGHT = 3.0  # tool diameters


class LoadNode:
    """`root` is what goes into a scene. Its line has a vertex for each sample, in their order."""

    def __init__(self, simulation):
        self.root = coin.SoSwitch()
        self.root.setName("EvenLoadLoad")
        self.show(True)
        self.path = PathLine(numpy.stack([simulation.x, simulation.y, simulation.z], axis=1))
        self.root.addChild(unpickable())
        self.root.addChild(self.path.root)
        self.root.addChild(self._tool(simulation))
        self.show_tool_at(simulation, 0)

    def show(self, is_shown):
        """Shows or hides all of it."""
        self.root.whichChild = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE

    def show_tool_at(self, simulation, number):
        """Moves the tool to a sample."""
        x, y, z = (float(values[number]) for values in (simulation.x, simulation.y, simulation.z))
        height = TOOL_HEIGHT * simulation.tool_diameter
        self._place.translation.setValue(x, y, z + 0.5 * height)

    def _tool(self, simulation):
        part = coin.SoSeparator()
        material = coin.SoMaterial()
        material.diffuseColor.setValue(*TOOL_COLOUR)
        material.transparency.setValue(TOOL_TRANSPARENCY)
        self._place = coin.SoTranslation()
        upright = coin.SoRotationXYZ()
        upright.axis, upright.angle = coin.SoRotationXYZ.X, 0.5 * numpy.pi
        cylinder = coin.SoCylinder()
        cylinder.radius = 0.5 * simulation.tool_diameter
        cylinder.height = TOOL_HEIGHT * simulation.tool_diameter
        for node in (material, self._place, upright, cylinder):
            part.addChild(node)
        return part
