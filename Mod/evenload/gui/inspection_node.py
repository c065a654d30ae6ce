"""Measuring points and deviations as a Coin node."""

import numpy
from pivy import coin

from evenload.face_inspection.mesh import nearest_of
from evenload.gui import load_colours, preferences
from evenload.gui.nodes import unlit, unpickable

POINT, BAD = (0.11, 0.44, 0.65), load_colours.BEYOND
NEEDLE = 0.02  # of the faces' extent: length of the normals that are shown
ABOVE = 1e-3  # of it: how far the colours lie above the face, which would show through else
RAISED = 6e-3  # of it: how far points do, whose marks would sink into the face
NEEDLE_WIDTH = 1.5  # pixels


class InspectionNode:
    """`root` is what goes into a scene; `points` and `colours` hold what is shown, or nothing."""

    def __init__(self):
        self.root = coin.SoSeparator()
        self.root.setName("EvenLoadInspection")
        self.colours, self.points = coin.SoSeparator(), coin.SoSeparator()
        for node in (unpickable(), unlit(), self.colours, self.points):
            self.root.addChild(node)

    def clear(self):
        self.colours.removeAllChildren()
        self.points.removeAllChildren()

    def show_samples(self, samples, size):
        """Points with their normals. size: the faces' extent, mm."""
        self.clear()
        ends = samples.points + NEEDLE * size * samples.normals
        pairs = numpy.stack([samples.points, ends], axis=1).reshape(-1, 3)
        style = coin.SoDrawStyle()
        style.lineWidth = NEEDLE_WIDTH
        needles = coin.SoLineSet()
        needles.numVertices.setValues(0, len(samples.points), [2] * len(samples.points))
        self.points.addChild(style)
        self.points.addChild(_coloured(needles, pairs, numpy.tile(POINT, (len(pairs), 1))))
        raised = samples.points + RAISED * size * samples.normals
        self._mark(raised, numpy.tile(POINT, (len(raised), 1)))

    def show_map(self, mesh, size, values, points, is_beyond, largest):
        """Triangles of a FaceMesh in the colours of values, one for each of their corners, and the
        measured points. size: the faces' extent, mm; is_beyond: for each point whether it stands
        out, or None; largest: value at the scale's end, and with a minus at its beginning.
        """
        self.clear()
        corners = (mesh.corners + ABOVE * size * mesh.normals[:, None]).reshape(-1, 3)
        both_sides = coin.SoShapeHints()
        both_sides.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING
        triangles = coin.SoFaceSet()
        shares = 0.5 + 0.5 * values / largest
        triangles.numVertices.setValues(0, len(mesh.corners), [3] * len(mesh.corners))
        self.colours.addChild(both_sides)
        shades = load_colours.on_scale(shares, preferences.scale())
        self.colours.addChild(_coloured(triangles, corners, shades))
        marks = numpy.zeros((len(points), 3))
        if is_beyond is not None:
            marks[is_beyond] = BAD
        normals = mesh.normals[nearest_of(points, mesh.corners.mean(axis=1))]
        self._mark(points + RAISED * size * normals, marks)

    def _mark(self, points, colours):
        markers = coin.SoMarkerSet()
        markers.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_7_7
        self.points.addChild(_coloured(markers, points, colours))


def _coloured(shape, points, colours):
    """A group with a shape whose vertices are points, in colours of their own."""
    group, colour, binding = coin.SoSeparator(), coin.SoBaseColor(), coin.SoMaterialBinding()
    colour.rgb.setValues(0, len(points), numpy.asarray(colours, numpy.float32))
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    vertices = coin.SoVertexProperty()
    vertices.vertex.setValues(0, len(points), numpy.asarray(points, numpy.float32))
    shape.vertexProperty = vertices
    for node in (colour, binding, shape):
        group.addChild(node)
    return group
