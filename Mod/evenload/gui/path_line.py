"""A path as a Coin node: a line whose vertices have colours of their own."""

import numpy
from pivy import coin

from evenload.gui.nodes import unlit

WIDTH = 3  # pixels: wider than FreeCAD's own line
NEARER = 1e-3  # of the depth that is seen, about a pixel: what lies as deep lies behind it


class PathLine:
    """`root` is what goes into a scene; it has a vertex for each place, in their order."""

    def __init__(self, points):
        """points: n x 3, mm."""
        self.root = coin.SoSeparator()
        self.colours, self._binding = coin.SoBaseColor(), coin.SoMaterialBinding()
        style = coin.SoDrawStyle()
        style.lineWidth = WIDTH
        self.vertices = coin.SoVertexProperty()
        self.vertices.vertex.setValues(0, len(points), points.astype(numpy.float32))
        self.line = coin.SoLineSet()
        self.line.vertexProperty = self.vertices
        self.line.numVertices.setValue(len(points))
        in_front = coin.SoDepthBuffer()
        in_front.range.setValue(0.0, 1.0 - NEARER)
        for node in (unlit(), in_front, style, self.colours, self._binding, self.line):
            self.root.addChild(node)

    def colour(self, colours):
        """Gives the vertices their colours, n x 3 of 0 to 1; one colour, 1 x 3, is that of all."""
        is_one = len(colours) == 1
        value = coin.SoMaterialBinding.OVERALL if is_one else coin.SoMaterialBinding.PER_VERTEX
        self._binding.value = value
        # Packed colours of vertices would take a third; but pivy keeps a copy of them for ever.
        self.colours.rgb.setNum(len(colours))
        self.colours.rgb.setValues(0, len(colours), colours.astype(numpy.float32))
