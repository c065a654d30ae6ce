"""Rest, gouges and other incidents of a Simulation as coloured areas and marks in Coin."""

import numpy
from pivy import coin

from evenload.gui.nodes import unlit, unpickable
from evenload.pictures import areas
from evenload.pictures.simulation_pictures import INCIDENTS, REST_COLOUR

GOUGE_COLOUR = next(colour for name, _, _, colour in INCIDENTS if name == "gouge")
ABOVE = 0.05  # mm that areas lie above what they are on, which would show through else
ABOVE_ALL = 0.1  # mm: marks, of the tip's place


class AreasNode:
    """`root` is what goes into a scene; `rest`, `gouges`: SoFaceSets; `marks`: SoMarkerSets."""

    def __init__(self, simulation):
        self.root = coin.SoSeparator()
        self.root.setName("EvenLoadAreas")
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING
        hints.faceType = coin.SoShapeHints.UNKNOWN_FACE_TYPE  # outlines may be hollow
        for node in (unpickable(), unlit(), hints):
            self.root.addChild(node)
        self.rest = self._faces(areas.rest_areas(simulation), REST_COLOUR)
        self.gouges = self._faces(areas.gouge_areas(simulation), GOUGE_COLOUR)
        self.marks = [self._marks(simulation, row) for row in INCIDENTS]

    def _faces(self, polygons, colour):
        faces = coin.SoFaceSet()
        points = numpy.concatenate([*polygons, numpy.empty((0, 3))]) + (0, 0, ABOVE)
        faces.vertexProperty = _vertices(points, colour)
        faces.numVertices.setValues(0, len(polygons), [len(each) for each in polygons])
        if polygons:  # an empty set would take vertices that others have left
            self.root.addChild(faces)
        return faces

    def _marks(self, simulation, row):
        beginning, _, _, colour = row
        places = [each[1:4] for each in simulation.incidents if each[0].startswith(beginning)]
        marks = coin.SoMarkerSet()
        marks.vertexProperty = _vertices(numpy.reshape(places, (-1, 3)) + (0, 0, ABOVE_ALL), colour)
        marks.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_7_7
        if places:
            self.root.addChild(marks)
        return marks


def _vertices(points, colour):
    vertices = coin.SoVertexProperty()
    vertices.vertex.setValues(0, len(points), numpy.asarray(points, numpy.float32))
    vertices.orderedRGBA = (int(colour[1:], 16) << 8) | 255
    vertices.materialBinding = coin.SoVertexProperty.OVERALL
    return vertices
