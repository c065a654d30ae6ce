"""What the window Simulation shows in the 3D view."""

from evenload.gui import load_colours, preferences
from evenload.gui.areas_node import AreasNode
from evenload.gui.load_node import LoadNode
from evenload.gui.load_view import OVER

COLOURED = load_colours.MEASURES[0]  # by what the path is coloured


class RunInView:
    """The path of a Run, coloured by engagement, its tool, and areas of rest and gouges. `run`: the
    one that is shown, None without any.
    """

    def __init__(self, scene):
        self._scene, self._limit = scene, None
        self.run = self.node = self.areas = None

    def show(self, run):
        """Shows another Run in place of the one before; None: nothing."""
        if self.node is not None:
            self._scene.removeChild(self.node.root)
            self._scene.removeChild(self.areas.root)
        self.run, self.node, self.areas = run, None, None
        if run is not None:
            self.node = LoadNode(run.simulation)
            self.show_limit(self._limit)
            self.areas = AreasNode(run.simulation)
            self._scene.addChild(self.areas.root)
            self._scene.addChild(self.node.root)

    def show_limit(self, limit):
        """Cuts far above this engagement angle in degrees stand out; None: there is no limit."""
        self._limit = limit
        if self.run is None:
            return
        found = self.run.simulation
        least, largest = load_colours.range_of(COLOURED, found)
        above = None if limit is None else limit + OVER
        shades = load_colours.colours_of(
            COLOURED, found, least, largest, above, preferences.scale()
        )
        self.node.path.colour(shades)

    def show_tool_at(self, sample):
        self.node.show_tool_at(self.run.simulation, sample)

    def worst(self):
        """The number of the sample of a cut with the largest engagement, None without any."""
        return load_colours.worst_of(COLOURED, self.run.simulation)
