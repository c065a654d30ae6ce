"""The surface that an operation leaves, as colours on the faces in the 3D view, and its dock."""

import FreeCAD
import numpy
from PySide import QtCore

from evenload import surface_simulation, units
from evenload.gui import (
    colours,
    files,
    preferences,
    surface_measures,
    surface_task,
    view3d,
)
from evenload.gui.length_box import UnitsWatch
from evenload.gui.observer import Observer
from evenload.gui.running import Running
from evenload.gui.slots import slot, telling_slot
from evenload.gui.surface_dock import SurfaceDock
from evenload.gui.surface_measures import MEASURES
from evenload.gui.surface_node import SurfaceNode
from evenload.gui.values import told

_translate = FreeCAD.Qt.translate

PICTURED = {"tip_share": "tip share"}  # by its word, where that is not the key


class SurfaceView:
    """Of one operation. closed: called when it is to be removed. Raises ValueError with a sentence
    where there is no 3D view.
    """

    def __init__(self, operation, closed):
        self.operation, self._closed = operation, closed
        self.known = self.node = None
        self._scene = view3d.scene_of(operation.Document)
        self.dock = SurfaceDock(self, operation.Label)
        self.task = Running(self.dock, self.dock.show_progress, self._refuse, found=self._take)
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.timeout.connect(slot(self.simulate))
        self.dock.choice.currentIndexChanged.connect(slot(self._choose))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))
        self._observer = Observer([operation], ("Path",), telling_slot(self._changed))
        FreeCAD.addDocumentObserver(self._observer)
        self._units = UnitsWatch(self.dock, self._show_units)
        self.dock.show()
        self.simulate()

    def remove(self):
        """Removes it from the scene and the window, and stops what is under way."""
        self._again.stop()  # it would read a document that may be closed
        self._units.end()
        self.task.cancel()
        FreeCAD.removeDocumentObserver(self._observer)
        self._forget()
        self.dock.hide()
        self.dock.deleteLater()

    # ---- simulating ----

    def simulate(self):
        """Simulates the operation in a thread, in place of what is under way."""
        self.dock.tell("")
        try:
            question = surface_simulation.read(self.operation, material=preferences.material())
        except ValueError as error:
            self.task.cancel()
            self._refuse(str(error))
            return
        self.task.run(lambda: surface_task.results(question, self.task.done))

    def cancel(self):
        """Stops the simulation; what is known stays. Where nothing is, it closes."""
        self.task.cancel()
        if self.known is None:
            self._closed()
            return
        self.dock.tell(_translate("EvenLoad", "The simulation was cancelled."), colours.CAUTION)

    def _refuse(self, sentence):
        self._forget()
        self.dock.tell(sentence, colours.BAD)

    def _take(self, known):
        if self.known is None or self.known.found is not known.found:
            self._forget()
            self.node = SurfaceNode(known.found)
            self._scene.addChild(self.node.root)
        self.known = known
        self._list()
        self._choose()
        self.dock.tell("\n".join([*known.found.notes, *known.refusals]))

    def _forget(self):
        if self.node is not None:
            self._scene.removeChild(self.node.root)
        self.known = self.node = None
        self._list()
        self.dock.show_figures([])
        self.dock.show_scale(None, 0.0, False)

    # ---- what is shown ----

    def _list(self):
        values = self.known.values if self.known else {}
        self.dock.list_measures([each for each in MEASURES if each.key in values])
        for widget in (self.dock.choice, self.dock.fly, self.dock.picture):
            widget.setEnabled(self.known is not None)

    @property
    def measure(self):
        """The SurfaceMeasure that is shown, None without any."""
        key = self.dock.choice.currentData()
        return next((each for each in MEASURES if each.key == key), None)

    def values(self):
        """The cells' values of what is shown, in mm or as shares."""
        return self.known.values[self.measure.key]

    def _choose(self):
        if self.known is None or self.measure is None:
            return
        values, found = self.values(), self.known.found
        largest = surface_measures.largest_of(values)
        is_bare = found.is_picked & ~found.is_covered
        bare = self.node.shown(is_bare.astype(float)) > 0
        bare &= self.measure.key != "gouge"
        colours_of = surface_measures.colours_of
        self.node.colour(colours_of(self.node.shown(values), bare, largest, preferences.scale()))
        self.dock.show_scale(self.measure, largest, bool(bare.any()))
        self.dock.show_figures(self._figures())

    def _figures(self):
        """[(what, value), ...] of the whole surface."""
        found, height, rows = self.known.found, units.ROUGHNESS, []

        def add(name, value):
            rows.append((_translate("EvenLoad", name), value))

        if found.max_cusp is not None:
            add("Cusps, mean", told(height, found.mean_cusp))
            add("95 % of cusps below", told(height, found.cusp_95))
            add("Highest cusp", told(height, found.max_cusp))
        if found.wish_share is not None:
            add("Within 10 % of the wish", "%.0f %%" % (100 * found.wish_share))
        add("Largest gouge", told(height, found.gouge_mm))
        add("Not cut", told(units.AREA, found.uncovered_area))
        largest = numpy.nanmax(self.values()) if numpy.isfinite(self.values()).any() else 0.0
        add("Largest shown", told(self.measure.quantity, largest))
        return rows

    def fly(self):
        """Goes to the place with the largest value of what is shown."""
        values = self.values()
        if not numpy.isfinite(values).any():
            return
        row, column = numpy.unravel_index(numpy.nanargmax(values), values.shape)
        found = self.known.found
        place = found.x[column], found.y[row], found.z_at(row, column)
        document = self.operation.Document
        view3d.fly_to(document, map(float, place), found.question.tool.diameter)

    def save(self):
        """Writes the picture of what is shown."""
        path = files.asked_name(self.dock, "Save Picture", files.PICTURES, ".png")
        if path:
            what = PICTURED.get(self.measure.key, self.measure.key)
            files.write(lambda: self.known.found.picture(path, what), self.dock.tell)

    def _show_units(self):
        self._choose()
        self.dock.told.follow_units()

    # ---- what happens meanwhile ----

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
        else:
            self._again.start()

    def _dock_shown(self, is_shown):
        """A dock that its user has closed takes the colours with it; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()
