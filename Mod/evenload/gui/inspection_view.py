"""What the dock Inspect does: points on the picked faces, what measured points say of them."""

import os

import FreeCAD
import FreeCADGui
import numpy
from PySide import QtCore

from evenload import face_inspection, inspection
from evenload.face_inspection import mesh, picture
from evenload.face_inspection.measured import DMIS
from evenload.face_inspection.probing_program import Probe, probing_program
from evenload.gui import colours, files, view3d
from evenload.gui.inspection_dock import MEASURED, PREDICTED, TO_MEASURE, InspectionDock
from evenload.gui.inspection_labels import name, tell, telling, unit
from evenload.gui.inspection_measured import PROPERTIES, Measuring
from evenload.gui.inspection_node import InspectionNode
from evenload.gui.inspection_predicted import Predicting
from evenload.gui.inspection_selection import selected_faces
from evenload.gui.length_box import UnitsWatch
from evenload.gui.observer import Observer
from evenload.gui.slots import slot, telling_slot
from evenload.settings.sentences import shown_name

_translate = FreeCAD.Qt.translate

POINT_FILES = "CSV (*.csv);;DMIS (%s)" % " ".join("*" + each for each in DMIS)


class InspectionView(Measuring, Predicting):
    """The dock and the node in the scene of one document; `closed` is called when the user closes
    the dock, or the document or an object with picked faces ends. Raises ValueError for faces that
    cannot be inspected.
    """

    def __init__(self, document, base, closed):
        self.faces = face_inspection.picked(base)
        self._scene = view3d.scene_of(document)
        self.document, self.base, self._closed = document, base, closed
        Measuring.__init__(self)
        Predicting.__init__(self)
        self.samples = self._observer = None
        self._mesh = None  # of the faces, when it is first needed
        self.node, self.dock = InspectionNode(), InspectionDock(self)
        self._scene.addChild(self.node.root)
        for rows, act in (
            (self.dock.samples, self.sample),
            (self.dock.evaluation, self.evaluate),
            (self.dock.alignment, self.evaluate),
            (self.dock.tolerance, self.judge),
            (self.dock.cutting, self.predict),
        ):
            rows.changed.connect(slot(act))
        self.dock.tabs.currentChanged.connect(slot(self._tab_chosen))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))
        self._units = UnitsWatch(self.dock, self.follow_units)
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.timeout.connect(slot(self._read_again))
        self.dock.show()
        self._take(base)

    def remove(self):
        """Removes it from the scene and the window."""
        self._units.end()
        self.forget_datum()
        FreeCAD.removeDocumentObserver(self._observer)
        self._scene.removeChild(self.node.root)
        self.dock.hide()
        self.dock.deleteLater()

    def follow_units(self):
        """Shows all lengths in the units that the user has chosen by now."""
        if self.dock.follow_units(unit()):
            self.sample()
            self.evaluate()
            self.predict()

    # ---- faces ----

    def take_selection(self):
        """Inspects the selected faces in place of those before."""
        base = selected_faces(self.document.Name)
        try:
            face_inspection.picked(base)
        except ValueError as error:
            tell(self.dock.faces, str(error), colours.BAD)
            return
        FreeCADGui.Selection.clearSelection()
        self._take(base)

    def _take(self, base):
        self.base, self.faces, self._mesh = base, face_inspection.picked(base), None
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
        objects = [obj for obj, _ in base]
        self._observer = Observer(objects, PROPERTIES, telling_slot(self._changed))
        FreeCAD.addDocumentObserver(self._observer)
        name(self.dock.faces, shown_name(self.faces.name))
        self.offer_planes()
        self.show_round_face()
        self.sample()
        self.evaluate()

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
        else:
            self.read_later()

    def read_later(self):
        """Reads faces and datum anew, when FreeCAD has done what it does."""
        self._again.start()

    def _read_again(self):
        try:
            self._take(self.base)
        except ValueError as error:  # a face that the changed model has no more
            self.samples = self.found = None
            self.node.clear()
            self._enable()
            tell(self.dock.faces, str(error), colours.BAD)

    def _dock_shown(self, is_shown):
        """A dock that is closed takes its colours with it; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()

    # ---- points to measure ----

    def sample(self):
        """Spreads points over the faces as the dock says."""
        asked, self.samples = self.dock.samples, None
        with telling(self.dock.told_samples):
            self.samples = face_inspection.sample(
                *(self.faces, asked.count.value(), asked.pattern.currentData()),
                *(asked.spacing.currentData(), asked.margin.mm()),
            )
            told = _translate("EvenLoad", "%d points") % len(self.samples.points)
            tell(self.dock.told_samples, told)
        self.show()

    def save_points(self):
        path = files.asked_name(self.dock, "Save Points", POINT_FILES, ".csv")
        if path:
            is_dmis = os.path.splitext(path)[1].lower() in DMIS
            write = inspection.write_dmis if is_dmis else inspection.write_csv
            with telling(self.dock.told_samples):
                write(path, self.samples.points, self.samples.normals, "mm")

    def save_picture(self):
        path = files.asked_name(self.dock, "Save Picture", files.PICTURES, ".png")
        if path:
            with telling(self.dock.told_samples):
                picture.save_samples(self.faces, self.samples, path, unit())

    def save_probing(self):
        path = files.asked_name(
            self.dock, "Save Probing Program", "G-code (*.ngc *.nc *.gcode)", ".ngc"
        )
        if not path:
            return
        asked = self.dock.samples
        with telling(self.dock.told_samples):
            probe = Probe(diameter=asked.ball.mm())
            text = probing_program(self.faces, self.samples, probe, asked.post.currentData())
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)

    # ---- what is shown ----

    def _tab_chosen(self):
        self.follow_units()
        if self.dock.tabs.currentIndex() == PREDICTED:
            self.offer_operations()
        self.show()

    def show(self):
        """Shows in the 3D view what the open tab is about."""
        self.node.clear()
        if self.dock.tabs.currentIndex() == MEASURED:
            if self.found is not None:
                self._show_map()
        elif self.dock.tabs.currentIndex() == TO_MEASURE and self.samples is not None:
            self.node.show_samples(self.samples, self.faces.size())
        self._enable()

    def _show_map(self):
        found, points = self.found, self.found.measured.points
        largest = float(numpy.abs(found.deviations).max()) or 1.0
        if self._mesh is None:
            self._mesh = mesh.mesh_of(self.faces)
        triangles = self._mesh
        corners = triangles.corners.reshape(-1, 3)
        values = mesh.between(corners, points, found.deviations)
        size = self.faces.size()
        self.node.show_map(triangles, size, values, points, found.is_beyond, largest)
        legend = self.dock.legend
        legend.has_beyond = found.is_beyond is not None and bool(found.is_beyond.any())
        legend.show_deviations(largest)

    def _enable(self):
        dock = self.dock
        for widget in (dock.save_points, dock.save_picture, dock.probing):
            widget.setEnabled(self.samples is not None)
        for widget in (dock.save_report, dock.save_map, dock.legend):
            widget.setEnabled(self.found is not None)
        dock.legend.setVisible(self.found is not None)
