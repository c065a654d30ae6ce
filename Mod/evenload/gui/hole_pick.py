"""Picking a hole, or a place, for the tool's entry in the 3D view."""

import math

import FreeCAD
import Part
from PySide import QtCore, QtGui

from evenload.gui import view3d
from evenload.gui.picking import Clicks
from evenload.gui.slots import slot, telling_slot
from evenload.settings.sentences import shown

NEAR = 0.05  # of its diameter: how far a hole may be from the foremost place that was clicked on
SAME = 1e-6  # mm between two vertices that are one
UPRIGHT = 1e-6  # x and y of a hole's direction at the most

_translate = FreeCAD.Qt.translate


def hole_of(shape):
    """(x, y, diameter) of the upright hole that an edge or a face belongs to, None for others."""
    if isinstance(shape, Part.Edge):
        round_one, kind = shape.Curve, Part.Circle
    elif isinstance(shape, Part.Face):
        round_one, kind = shape.Surface, Part.Cylinder
    else:
        return None
    if not isinstance(round_one, kind):
        return None
    axis, centre = round_one.Axis, round_one.Center
    if max(abs(axis.x), abs(axis.y)) > UPRIGHT:
        return None
    return centre.x, centre.y, 2 * round_one.Radius


def picked_at(view, pixel):
    """(x, y, diameter) of what is in a view at a pixel: the hole whose rim or wall it is, or a
    place alone, with None. None where nothing is.
    """
    # All that lies there, the foremost first: beside an edge that may be the face next to it.
    infos = view.getObjectsInfo(pixel) or ()
    for info in infos:
        hole = _hole_at(info)
        if hole is not None and _distance(info, infos[0]) < NEAR * hole[2]:
            return hole
    return (infos[0]["x"], infos[0]["y"], None) if infos else None


def _distance(one, other):
    return math.dist(*([info[axis] for axis in "xyz"] for info in (one, other)))


def _hole_at(info):
    """The hole that what FreeCAD tells of a pixel belongs to, None without one."""
    owner = info.get("ParentObject") or FreeCAD.getDocument(info["Document"]).getObject(
        info["Object"]
    )
    name = info.get("SubName") or info.get("Component") or ""
    shape = owner.getSubObject(name) if name else None  # where it stands in the document
    if isinstance(shape, Part.Vertex):  # a circle has one, too
        whole = owner.getSubObject(name.rpartition(".")[0])
        shapes = [edge for edge in whole.Edges if _ends_in(edge, shape)]
    else:
        shapes = [shape]
    return next(filter(None, map(hole_of, shapes)), None)


def _ends_in(edge, vertex):
    return any(vertex.Point.isEqual(each.Point, SAME) for each in edge.Vertexes)


def place_at(view, pixel):
    """(x, y) of the foremost that is in a view at a pixel; None where nothing is."""
    info = view.getObjectInfo(pixel)
    return (info["x"], info["y"]) if info else None


class PlacePick:
    """A button that stays down until a place is picked. taken: a bound method that is called with
    (x, y) and not kept alive.
    """

    found_at = staticmethod(place_at)  # what is picked by a click at a pixel of a view

    def __init__(self, document, taken, text, tooltip):
        """document: in whose 3D view a place is picked; text, tooltip: the button's."""
        self._document, self._taken = document, telling_slot(taken)
        self._clicks = Clicks(telling_slot(self._clicked))
        self._view = self._scene = None  # while picking
        self._pixel = None  # that was clicked on
        self.button = QtGui.QPushButton(text)
        self.button.setCheckable(True)
        self.button.setToolTip(tooltip)
        self.button.toggled.connect(telling_slot(self._toggled))
        # After the event: while Coin goes through the scene nothing may be taken out of it.
        self._soon = QtCore.QTimer(self.button)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(slot(self._take))

    def end(self):
        """Picks no longer."""
        scene, self._view, self._scene = self._scene, None, None
        if scene is not None:
            scene.removeChild(self._clicks.root)
        self.button.setChecked(False)

    def _toggled(self, is_on):
        if not is_on:
            self.end()
            return
        try:
            self._view = view3d.view_of(self._document)
        except ValueError as error:
            FreeCAD.Console.PrintError(shown(str(error)) + "\n")
            self.end()
            return
        # Before all else in the scene: what FreeCAD selects by this click keeps it from the rest.
        self._scene = self._view.getSceneGraph()
        self._scene.insertChild(self._clicks.root, 0)

    def _clicked(self, pixel, size):
        self._pixel = tuple(map(int, pixel))
        self._soon.start(0)

    def _take(self):
        found = self.found_at(self._view, self._pixel) if self._view is not None else None
        if found is not None:
            self._taken(found)
            self.end()


class HolePick(PlacePick):
    """The same for a hole: taken is called with (x, y, diameter or None)."""

    found_at = staticmethod(picked_at)

    def __init__(self, document, taken):
        super().__init__(
            document,
            taken,
            _translate("EvenLoad", "Pick the Hole"),
            _translate(
                "EvenLoad",
                "A click on the rim or the wall of a hole in the 3D view takes its centre and "
                "diameter, one elsewhere the place alone",
            ),
        )
