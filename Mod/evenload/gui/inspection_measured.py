"""The tab of the dock Inspect for measured points: what they say of the faces."""

import dataclasses
import os

import FreeCAD
from PySide import QtGui

from evenload import face_inspection
from evenload.face_inspection import html_report, picture
from evenload.face_inspection.evaluation import IN, OPEN, OUT, PROFILE
from evenload.face_inspection.measured import DMIS
from evenload.gui import colours, files
from evenload.gui import inspection_selection as selection
from evenload.gui.inspection_alignment import NO_DATUM
from evenload.gui.inspection_labels import name, tell, telling, unit
from evenload.gui.observer import Observer
from evenload.gui.slots import telling_slot

_translate = FreeCAD.Qt.translate

ALL_POINT_FILES = "*.csv " + " ".join("*" + each for each in DMIS)
SHADES = {IN: colours.GOOD, OUT: colours.BAD, OPEN: colours.CAUTION}
PROPERTIES = ("Shape", "Placement")  # of what a datum is picked from: what changes it

ENDED = "The datum of the inspection is no longer there: it goes on without one."


class Measuring:
    """What an InspectionView does with measured points. It has `document`, `base`, `faces`, `dock`,
    `prediction` and show(); `found` is the Evaluation, None where there is none.
    """

    def __init__(self):
        self.found = None
        self._path = ""
        self._picked = None  # (object, name of its face) of a datum that was picked
        self._datum_observer = None

    # ---- the datum ----

    def offer_planes(self):
        """Lists the plane faces among those that are inspected, and the datum that was picked."""
        planes = face_inspection.plane_faces(self.base)
        if self._picked is not None and self._picked not in planes:
            planes.append(self._picked)
        listed = [(selection.told(*each), selection.key_of(*each)) for each in planes]
        datum = self.dock.alignment.datum
        before = datum.name()
        datum.offer(listed)
        if datum.name() != before:
            self.dock.alignment.show_motions()
            FreeCAD.Console.PrintWarning(_translate("EvenLoad", ENDED) + "\n")

    def pick_datum(self):
        """Takes the plane that is selected for the datum."""
        with telling(self.dock.told):
            picked = selection.selected_plane(self.document.Name)
            face_inspection.datum_at(*picked)  # or it is none
            self._pick(picked)
            self.offer_planes()
            self.dock.alignment.datum.choose(selection.key_of(*picked))

    def _pick(self, picked):
        """Takes a datum, or None, and follows its object."""
        if self._datum_observer is not None:
            FreeCAD.removeDocumentObserver(self._datum_observer)
            self._datum_observer = None
        self._picked = picked
        if picked is not None:
            changed = telling_slot(self._datum_changed)
            self._datum_observer = Observer([picked[0]], PROPERTIES, changed)
            FreeCAD.addDocumentObserver(self._datum_observer)

    def _datum_changed(self, is_gone):
        if is_gone:  # not read at once: its document may be closing
            self._pick(None)
        self.read_later()

    def forget_datum(self):
        """Lets go of the object that a datum was picked from."""
        self._pick(None)

    # ---- evaluation ----

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
            name(self.dock.file, os.path.basename(path))
            self.evaluate()

    def evaluate(self):
        """Reads the measured points and evaluates them as the dock says."""
        self.found = None
        asked = self.dock.evaluation
        kind = asked.kind.currentData()
        self.dock.alignment.setVisible(kind == PROFILE)
        if self._path:
            with telling(self.dock.told):
                measured = face_inspection.read_points(self._path, asked.radius.mm())
                free, datum = self._alignment() if kind == PROFILE else (None, None)
                self.found = face_inspection.evaluate(
                    *(self.faces, measured, kind),
                    free=free,
                    datum=datum,
                    all_points=asked.points.currentData(),
                )
        self.judge()

    def _alignment(self):
        """(names of the free motions, (point, normal) of the datum or None)."""
        free, key = self.dock.alignment.value()
        if key == NO_DATUM:
            return free, None
        return free, face_inspection.datum_at(*selection.plane_at(self.document, key))

    def judge(self):
        """Holds what was evaluated against the tolerance."""
        if self.found is not None:
            tolerance = self.dock.tolerance.width.mm() or None
            self.found = dataclasses.replace(self.found, tolerance=tolerance)
            shade = SHADES.get(self.found.verdict)
            tell(self.dock.told, "\n".join(self.found.told(unit())), shade)
        self.show()

    # ---- files ----

    def save_report(self):
        path = files.asked_name(self.dock, "Save Report", "HTML (*.html)", ".html")
        if path:
            with telling(self.dock.told):
                source = os.path.basename(self._path)
                html_report.write_report(self.found, path, source, unit(), self.prediction)

    def save_map(self):
        path = files.asked_name(self.dock, "Save Picture", files.PICTURES, ".png")
        if path:
            with telling(self.dock.told):
                picture.save_map(self.found, path, unit())
