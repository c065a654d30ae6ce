"""What the dock Inspect does: points on the picked faces, what measured points say of them."""

import contextlib
import dataclasses
import os

import FreeCAD
import FreeCADGui
import numpy
from PySide import QtCore, QtGui

from evenload import face_inspection, inspection
from evenload.face_inspection import html_report, mesh, picture
from evenload.face_inspection.evaluation import IN, OPEN, OUT
from evenload.face_inspection.measured import DMIS
from evenload.face_inspection.probing_program import Probe, probing_program
from evenload.gui import colours, files, view3d
from evenload.gui.inspection_dock import ALIGNED, DEVIATION, InspectionDock
from evenload.gui.inspection_node import InspectionNode
from evenload.gui.observer import Observer
from evenload.gui.slots import slot, telling_slot
from evenload.settings.sentences import shown, shown_name

_translate = FreeCAD.Qt.translate

POINT_FILES = "CSV (*.csv);;DMIS (%s)" % " ".join("*" + each for each in DMIS)
ALL_POINT_FILES = "*.csv " + " ".join("*" + each for each in DMIS)
MEASURED = 1  # the number of the tab with measured points
SHADES = {IN: colours.GOOD, OUT: colours.BAD, OPEN: colours.CAUTION}
# Of the objects whose faces are picked: what changes these faces.
PROPERTIES = ("Shape", "Placement")


def selected_faces(document):
    """[(object, names of its faces), ...] of what is selected in a document."""
    found = []
    for selected in FreeCADGui.Selection.getSelectionEx(document):
        names = [name for name in selected.SubElementNames if name.startswith("Face")]
        if names:
            found.append((selected.Object, names))
    return found


class InspectionView:
    """The dock and the node in the scene of one document; `closed` is called when the user closes
    the dock, or the document or an object with picked faces ends. Raises ValueError for faces that
    cannot be inspected.
    """

    def __init__(self, document, base, closed):
        self.faces = face_inspection.picked(base)
        self._scene = view3d.scene_of(document)
        self.document, self._base, self._closed = document, base, closed
        self.samples = self.found = None
        self._path, self._observer = "", None
        self._mesh = None  # of the faces, when it is first needed
        self.node, self.dock = InspectionNode(), InspectionDock(self)
        self.dock.samples.show_values(ball=Probe.diameter)
        self._scene.addChild(self.node.root)
        self.dock.samples.changed.connect(slot(self.sample))
        self.dock.evaluation.changed.connect(slot(self.evaluate))
        self.dock.tolerance.changed.connect(slot(self.judge))
        self.dock.tabs.currentChanged.connect(slot(self.show))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.timeout.connect(slot(self._read_again))
        self.dock.show()
        self._take(base)

    def remove(self):
        """Removes it from the scene and the window."""
        FreeCAD.removeDocumentObserver(self._observer)
        self._scene.removeChild(self.node.root)
        self.dock.hide()
        self.dock.deleteLater()

    # ---- faces ----

    def take_selection(self):
        """Inspects the selected faces in place of those before."""
        base = selected_faces(self.document.Name)
        try:
            face_inspection.picked(base)
        except ValueError as error:
            self._tell(self.dock.faces, str(error), colours.BAD)
            return
        FreeCADGui.Selection.clearSelection()
        self._take(base)

    def _take(self, base):
        self._base, self.faces, self._mesh = base, face_inspection.picked(base), None
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
        objects = [obj for obj, _ in base]
        self._observer = Observer(objects, PROPERTIES, telling_slot(self._changed))
        FreeCAD.addDocumentObserver(self._observer)
        self._tell(self.dock.faces, shown_name(self.faces.name))
        self.sample()
        self.evaluate()

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
        else:
            self._again.start()

    def _read_again(self):
        try:
            self._take(self._base)
        except ValueError as error:  # a face that the changed model has no more
            self.samples = self.found = None
            self.node.clear()
            self._enable()
            self._tell(self.dock.faces, str(error), colours.BAD)

    def _dock_shown(self, is_shown):
        """A dock that is closed takes its colours with it; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()

    # ---- points to measure ----

    def sample(self):
        """Spreads points over the faces as the dock says."""
        asked, self.samples = self.dock.samples, None
        with self._telling(self.dock.told_samples):
            self.samples = face_inspection.sample(
                *(self.faces, asked.count.value(), asked.pattern.currentData()),
                *(asked.spacing.currentData(), asked.margin.value()),
            )
            told = _translate("EvenLoad", "%d points") % len(self.samples.points)
            self._tell(self.dock.told_samples, told)
        self.show()

    def save_points(self):
        path = self._asked_name("Save Points", POINT_FILES, ".csv")
        if path:
            is_dmis = os.path.splitext(path)[1].lower() in DMIS
            write = inspection.write_dmis if is_dmis else inspection.write_csv
            with self._telling(self.dock.told_samples):
                write(path, self.samples.points, self.samples.normals, "mm")

    def save_picture(self):
        path = self._asked_name("Save Picture", files.PICTURES, ".png")
        if path:
            with self._telling(self.dock.told_samples):
                picture.save_samples(self.faces, self.samples, path)

    def save_probing(self):
        path = self._asked_name("Save Probing Program", "G-code (*.ngc *.nc *.gcode)", ".ngc")
        if not path:
            return
        asked = self.dock.samples
        with self._telling(self.dock.told_samples):
            probe = Probe(diameter=asked.ball.value())
            text = probing_program(self.faces, self.samples, probe, asked.post.currentData())
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)

    # ---- measured points ----

    def open_points(self):
        title = _translate("EvenLoad", "Open Measured Points")
        path, _ = QtGui.QFileDialog.getOpenFileName(
            self.dock,
            title,
            self._path,
            "%s (%s)" % (_translate("EvenLoad", "Points"), ALL_POINT_FILES),
        )
        if path:
            self._path = path
            self._tell(self.dock.file, os.path.basename(path))
            self.evaluate()

    def evaluate(self):
        """Reads the measured points and evaluates them as the dock says."""
        self.found = None
        if self._path:
            asked = self.dock.evaluation
            kind = asked.kind.currentData()
            with self._telling(self.dock.told):
                measured = face_inspection.read_points(self._path, asked.radius.value())
                is_aligned = kind == ALIGNED
                self.found = face_inspection.evaluate(
                    *(self.faces, measured, "profile" if is_aligned else kind),
                    free=() if is_aligned else None,
                    all_points=asked.points.currentData(),
                )
        self.judge()

    def judge(self):
        """Holds what was evaluated against the tolerance."""
        if self.found is not None:
            tolerance = self.dock.tolerance.width.value() or None
            self.found = dataclasses.replace(self.found, tolerance=tolerance)
            shade = SHADES.get(self.found.verdict)
            self._tell(self.dock.told, "\n".join(self.found.sentences), shade)
        self.show()

    def save_report(self):
        path = self._asked_name("Save Report", "HTML (*.html)", ".html")
        if path:
            with self._telling(self.dock.told):
                html_report.write_report(self.found, path, os.path.basename(self._path))

    def save_map(self):
        path = self._asked_name("Save Picture", files.PICTURES, ".png")
        if path:
            with self._telling(self.dock.told):
                picture.save_map(self.found, path)

    # ---- what is shown ----

    def show(self):
        """Shows in the 3D view what the open tab is about."""
        self.node.clear()
        if self.dock.tabs.currentIndex() == MEASURED:
            if self.found is not None:
                self._show_map()
        elif self.samples is not None:
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
        legend.show_scale(DEVIATION, -largest, largest, None)

    def _enable(self):
        dock = self.dock
        for widget in (dock.save_points, dock.save_picture, dock.probing):
            widget.setEnabled(self.samples is not None)
        for widget in (dock.save_report, dock.save_map, dock.legend):
            widget.setEnabled(self.found is not None)
        dock.legend.setVisible(self.found is not None)

    def _asked_name(self, *asked):
        return files.asked_name(self.dock, *asked)

    @contextlib.contextmanager
    def _telling(self, label):
        """While something takes its time; why it cannot be is told in a label."""
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            yield
        except ValueError as error:
            self._tell(label, str(error), colours.BAD)
        except OSError as error:
            self._tell(label, files.refusal(error), colours.BAD)
        finally:
            QtGui.QApplication.restoreOverrideCursor()

    @staticmethod
    def _tell(label, text, colour=None):
        label.setText(shown(text))
        shade = "color: %s" % colours.shade(colour, label) if colour else ""
        label.setStyleSheet(shade)
