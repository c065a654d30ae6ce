"""The path of a preview in the 3D view, and what becomes of the operation's own path meanwhile.

Both are Coin nodes in the operation's own, so that they show in all views of its document; none of
its properties is touched.
"""

import numpy
from pivy import coin

from evenload.gui.nodes import unpickable
from evenload.gui.path_line import PathLine
from evenload.planar import CUT, ENTRY, LINK, RAPID

NAME = "EvenLoadPreview"  # of all nodes of a preview
# Red, green, blue of 0 to 1; on FreeCAD's blue ground they are told from its own green paths.
COLOURS = {
    RAPID: (0.97, 0.60, 0.60),
    LINK: (0.75, 0.75, 0.75),
    ENTRY: (0.95, 0.35, 0.80),
    CUT: (1.00, 0.72, 0.10),
}
GREY = numpy.full((1, 3), 0.40)
# FreeCAD's line of a path has colours of its own for kinds of moves: more are there than it needs.
MOST_COLOURS = 16


def colours_of(kinds):
    """The colours, n x 3 of 0 to 1, of places of a path by the kinds of their moves."""
    colours = numpy.empty((len(kinds), 3))
    for kind, colour in COLOURS.items():
        colours[kinds == kind] = colour
    return colours


class PreviewNode:
    """The nodes of one operation's preview."""

    def __init__(self, view_object):
        """That of the operation."""
        self._root = view_object.RootNode
        self._over = coin.SoGroup()  # whose nodes hold for the operation's path, too
        self._over.setName(NAME)
        self._own = coin.SoSeparator()
        self._own.setName(NAME)
        self._root.insertChild(self._over, 0)
        self._root.insertChild(self._own, 0)
        self.line = None  # the PathLine that shows
        self._is_stored_shown = True  # that of the operation itself

    def remove(self):
        """Takes all of it out of the scene; the operation's path shows as ever."""
        for node in (self._own, self._over):
            self._root.removeChild(node)

    def show(self, points, colours):
        """Shows a path in place of all others. points: n x 3, mm; colours: as
        colours_of() tells them.
        """
        self._own.removeAllChildren()
        self._over.removeAllChildren()
        self._over.addChild(_invisible())
        self.line, self._is_stored_shown = None, False
        if len(points):
            self.line = PathLine(points)
            self.line.colour(colours)
            self._own.addChild(unpickable())
            self._own.addChild(self.line.root)

    def grey(self):
        """Greys the path that shows: that of the last preview, or else the operation's own."""
        if self.line is not None:
            self.line.colour(GREY)
        elif self._is_stored_shown:
            self._over.removeAllChildren()
            self._over.addChild(_grey())


def _grey():
    material = coin.SoMaterial()
    grey = numpy.repeat(GREY, MOST_COLOURS, axis=0).astype(numpy.float32)
    material.diffuseColor.setValues(0, MOST_COLOURS, grey)
    material.setOverride(True)
    return material


def _invisible():
    style = coin.SoDrawStyle()
    style.style = coin.SoDrawStyle.INVISIBLE
    style.setOverride(True)
    return style
