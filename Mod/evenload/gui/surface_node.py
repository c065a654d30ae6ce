"""A surface as coloured faces in Coin, a little above the part."""

import math

import numpy
from pivy import coin

from evenload.gui.nodes import unlit, unpickable

MOST = 250_000  # cells that are shown; of more, each stands for some
ABOVE = 0.03  # mm that the colours lie above the part, which would show through else


class SurfaceNode:
    """`root` is what goes into a scene. `shown`: numbers of the vertices' cells, in their order."""

    def __init__(self, simulation):
        self.root = coin.SoSeparator()
        self.root.setName("EvenLoadSurface")
        self._every = max(1, math.ceil(math.sqrt(simulation.part.size / MOST)))
        self._colour = coin.SoBaseColor()
        points, quads = self._cells(simulation)
        vertices = coin.SoVertexProperty()
        vertices.vertex.setValues(0, len(points), numpy.asarray(points, numpy.float32))
        faces = coin.SoIndexedFaceSet()
        faces.vertexProperty = vertices
        faces.coordIndex.setValues(0, quads.size, quads.ravel().tolist())
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING  # seen from both sides
        for node in (unpickable(), unlit(), hints, self._colour, binding, faces):
            self.root.addChild(node)

    def _cells(self, simulation):
        """(places of the vertices, rows of their four numbers and -1)"""
        heights = simulation.part[:: self._every, :: self._every]
        x, y = numpy.meshgrid(simulation.x[:: self._every], simulation.y[:: self._every])
        is_known = numpy.isfinite(heights)
        numbers = numpy.cumsum(is_known.ravel()).reshape(heights.shape) - 1
        self._is_known = is_known
        points = numpy.column_stack([x[is_known], y[is_known], heights[is_known] + ABOVE])
        corners = [numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]]
        whole = is_known[:-1, :-1] & is_known[:-1, 1:] & is_known[1:, 1:] & is_known[1:, :-1]
        quads = numpy.stack([each[whole] for each in corners], axis=1)
        return points, numpy.column_stack([quads, numpy.full(len(quads), -1)]).astype(numpy.int32)

    def shown(self, values):
        """Those of the cells' values that vertices have, each the highest of the cells that it
        stands for.
        """
        rows, columns = values.shape
        every = self._every
        if every > 1:
            framed = numpy.full(
                (-(-rows // every) * every, -(-columns // every) * every), -numpy.inf
            )
            framed[:rows, :columns] = numpy.where(numpy.isnan(values), -numpy.inf, values)
            blocks = framed.reshape(len(framed) // every, every, -1, every)
            values = blocks.max(axis=(1, 3))
            values = numpy.where(numpy.isinf(values), numpy.nan, values)
        return values[self._is_known]

    def colour(self, colours):
        """Gives each vertex its colour, n x 3 of 0 to 1."""
        self._colour.rgb.setValues(0, len(colours), numpy.asarray(colours, numpy.float32))
