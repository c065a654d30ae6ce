"""The window Stability chart: an operation's cut, what vibrates, the chart, the best cut."""

import dataclasses

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host, materials, units
from evenload.gui import stability_inputs as inputs
from evenload.gui import manual, steps
from evenload.gui.colours import BAD, GOOD, QUIET
from evenload.gui.length_box import UnitsWatch
from evenload.gui.slots import slot
from evenload.gui.stability_layout import button, lay_out
from evenload.gui.stability_modes import ModesBox
from evenload.gui.stability_task import chart_of
from evenload.gui.told import Told
from evenload.gui.stability_view import ChartView
from evenload.gui.worker import Refused, Worker
from evenload.stability import choice, picture, taking
from evenload.stability import cut as cuts
from evenload.stability import operation as stability

_translate = FreeCAD.Qt.translate

LOOK = 20  # ms between looks at what the thread has found
LEAST_DEPTH = 0.002  # of the chart's largest: where it begins


class StabilityWindow(manual.Dialog):
    """Of one operation; others of the job can be chosen. `closed` is told at its end."""

    closed = QtCore.Signal()

    def __init__(self, operation, parent=None):
        super().__init__(parent or FreeCADGui.getMainWindow())
        self.setWindowTitle(_translate("EvenLoad", "Stability chart"))
        self.set_page("stability_chart")
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.operation = self.read = self.best = None
        self._beside_best = ()  # the removal rate then, mm3/min, and the best cut's force, N
        self.worker, self.searcher = Worker(), Worker()
        self.view, self.modes = ChartView(), ModesBox()
        self.cut, self.chart, self.limits = (
            inputs.cut_box(),
            inputs.chart_box(),
            inputs.limits_box(),
        )
        self.operations = inputs.combo(())
        self.best_button = button("Best", "Finds the cut that removes most", self.find_best)
        self.apply_button = button(
            "Apply", "Sets spindle speed, feeds, step down and cut mode", self.apply
        )
        self.close_button = button("Close", "Closes the window", self.leave)
        self.told, self.found = Told(), Told()
        lay_out(self)
        self.timer = QtCore.QTimer(self)
        self.timer.setInterval(LOOK)
        self.timer.timeout.connect(slot(self._look))
        self._units = UnitsWatch(self, self.follow_units)
        self._connect()
        self._list_operations(operation)
        self.show_operation(operation)

    def _connect(self):
        self.operations.activated.connect(slot(self._operation_chosen))
        self.modes.changed.connect(slot(self._modes_changed))
        self.cut.changed.connect(slot(self.recompute))
        self.chart.changed.connect(slot(self.recompute))
        self.view.chosen.connect(slot(self._point_chosen))
        self.view.taken.connect(slot(self.apply))

    # ---- the operation ----

    def _list_operations(self, operation):
        job = host.parent_job(operation)
        for each in host.operations(job) if job else [operation]:
            if host.controller_of(each) is not None:
                self.operations.addItem(each.Label, each.Name)

    def _operation_chosen(self):
        if self._closed_if_gone():
            return
        chosen = self.operation.Document.getObject(self.operations.currentData())
        if chosen is None or host.controller_of(chosen) is None:  # deleted since
            self.operations.removeItem(self.operations.currentIndex())
            self.operations.setCurrentIndex(self.operations.findData(self.operation.Name))
            return
        self.show_operation(chosen)

    def show_operation(self, operation):
        """Reads an operation and shows its chart."""
        self.searcher.cancel()  # it looks for the best cut of another one
        self.operation, self.best = operation, None
        self.found.tell("")
        self.operations.setCurrentIndex(self.operations.findData(operation.Name))
        try:
            kept = stability.kept(host.controller_of(operation))
            problem = ""
        except ValueError as error:  # what somebody wrote into the property
            kept, problem = None, str(error)
        self.modes.show_modes(kept.modes if kept else [], name=kept.name if kept else "")
        self.modes.problem = problem
        if self._read():
            self._show_ends()
        self.recompute()

    def _read(self):
        """Whether the operation can be read; shows its cut."""
        self.read = None
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)  # others' are simulated
        try:
            found = stability.read_without_modes(self.operation)
            cuts.check(found)
        except ValueError as error:
            self.told.tell(str(error), BAD)
            self.view.show_message(str(error))
            return False
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        self.read = cut = found
        self.cut.show_values(
            speed=cut.speed,
            depth=cut.depth,
            cut_mode=cut.cut_mode,
            engagement=cut.engagement_deg,
            material=cut.material["name"],
        )
        return True

    def _show_ends(self):
        (low, high), (_, deepest) = picture.box_of(self.read)
        self.chart.show_values(from_speed=low, to_speed=high, to_depth=deepest)
        self.limits.show_values(margin=100 * choice.MARGIN)

    def asked(self):
        """The Cut as it is set in the window."""
        return dataclasses.replace(
            self.read,
            modes=list(self.modes.modes),
            speed=self.cut.speed.value(),
            depth=self.cut.value_of("depth"),
            cut_mode=self.cut.cut_mode.currentData(),
            engagement_deg=self.cut.engagement.value(),
            material=materials.load(self.cut.material.currentData()),
            process_damping=1e3 * self.cut.damping.value(),
        )

    # ---- computing ----

    def recompute(self):
        """Draws the chart and judges the cut anew, in place of what is under way."""
        self.worker.cancel()
        self.apply_button.setEnabled(self.read is not None)
        self.best_button.setEnabled(self.read is not None and bool(self.modes.modes))
        if self.read is None:
            return
        missing = self.modes.problem or (not self.modes.modes and self._what_to_do())
        if missing:
            self.view.show_message(missing)
            self.told.tell(missing, BAD if self.modes.problem else QUIET)
            return
        cut, box = self.asked(), self._box()
        if box[0][0] >= box[0][1]:
            self.told.tell(_translate("EvenLoad", "The chart's speeds must rise."), BAD)
            return
        self.view.show_points((self.read.speed, self.read.depth), (cut.speed, cut.depth), None)
        self.told.tell(_translate("EvenLoad", "Computing"), QUIET)
        self.worker.start(lambda: chart_of(cut, box))
        self.timer.start()

    @staticmethod
    def _what_to_do():
        return _translate(
            "EvenLoad",
            "Load a tap test, open a file with modes, or add a mode: the chart follows from what"
            " vibrates at the tool's tip.",
        )

    def _box(self):
        deepest = self.chart.value_of("to_depth")
        speeds = self.chart.from_speed.value(), self.chart.to_speed.value()
        return speeds, (LEAST_DEPTH * deepest, deepest)

    def find_best(self):
        """Looks for the best cut within the chart and the limits."""
        cut, (speeds, (_, deepest)) = self.asked(), self._box()
        limits = {
            "margin": self.limits.margin.value() / 100,
            "surface_limit": self.limits.value_of("error") or None,
            "force_limit": self.limits.force.value() or None,
        }
        self.found.tell(_translate("EvenLoad", "Searching"))

        def search():
            yield "best", choice.best_of(cut, speeds, deepest, **limits)

        self.searcher.start(search)
        self.timer.start()

    def _look(self):
        if self._closed_if_gone():
            return
        # Asked first, so that nothing comes after what is taken.
        is_done = not (self.worker.is_busy or self.searcher.is_busy)
        if is_done:
            self.timer.stop()
        for result in self.worker.results():
            self._show(result, self.told.tell)
        for result in self.searcher.results():
            self._show(result, self.found.tell)

    def _closed_if_gone(self):
        """Whether the operation or its document is gone: then the window closes, too."""
        try:
            is_gone = self.operation.Document is None
        except ReferenceError:
            is_gone = True
        if is_gone:
            self.close()
        return is_gone

    def _show(self, result, tell):
        if isinstance(result, Refused):
            tell(result.sentence, BAD)
            return
        kind, found = result
        if kind == "field":
            self.view.show_field(found)
        elif kind == "stable":
            self.view.show_points(self.view.operation, self.view.point, found)
        elif kind == "verdict":
            self.told.tell(
                "\n".join([found.sentence, *self.read.notes, *self.modes.notes]),
                GOOD if found.is_stable else BAD,
                self._shared(),
            )
        else:
            self._show_best(found)

    def _shared(self):
        """The other operations with this tool controller, in a sentence."""
        others = taking.sharers(self.operation)
        shared = _translate("EvenLoad", "%s: the same tool controller.") % ", ".join(others)
        return shared if others else ""

    def _show_best(self, found):
        self.best = found
        if found is None:
            self.found.tell(_translate("EvenLoad", "No cut in the chart keeps the limits."))
            return
        force = choice.force_at(self.asked(), found.depth)
        self._beside_best = self.read.removal_rate, force
        self._tell_best()
        self._show_chosen(found.speed, found.depth, cut_mode=found.cut_mode)

    def _tell_best(self):
        self.found.tell("", named=_told_of(self.best, *self._beside_best))

    def follow_units(self):
        """Shows all in the units that the user has chosen by now."""
        for rows in (self.cut, self.chart, self.limits):
            rows.follow_units()
        self.view.follow_units()
        self.told.follow_units()
        if self.best is not None:
            self._tell_best()

    # ---- what the user does ----

    def _point_chosen(self):
        self._show_chosen(*self.view.point)

    def _show_chosen(self, speed, depth, **others):
        """Shows a cut that was chosen in the chart, rounded: so it is judged and taken."""
        self.cut.show_values(speed=speed, depth=self.cut.depth.rounded(depth), **others)
        self.recompute()

    def _modes_changed(self):
        if self._closed_if_gone():
            return
        controller = host.controller_of(self.operation)
        if not self.modes.problem and controller is not None:
            refusal = steps.refusal(self.operation)
            if refusal:
                self.told.tell(refusal, BAD)
                return
            name = _translate("EvenLoad", "Modes of vibration")
            with steps.step(self.operation.Document, self.operation, name):
                stability.keep(controller, self.modes.vibration())
        self.recompute()

    def apply(self):
        """Takes the cut into the operation and its tool controller, and computes the path."""
        if self._closed_if_gone():
            return
        if self.read is None:
            return
        refusal = steps.refusal(None)
        if refusal:
            self.told.tell(refusal, BAD)
            return
        asked = self.asked()
        wanted = {
            name: getattr(asked, name)
            for name in ("speed", "depth", "cut_mode", "engagement_deg")
            if inputs.differs(name, getattr(self.read, name), getattr(asked, name))
        }
        taking.take(self.operation, **wanted)
        if not self.operation.isValid():
            why = getattr(self.operation, "Report", "") or self.operation.getStatusString()
            self.told.tell(why, BAD)
            return
        if self._read():
            self.recompute()

    def leave(self):
        self.close()

    def closeEvent(self, event):
        self.timer.stop()
        self._units.end()
        self.worker.cancel()
        self.searcher.cancel()
        super().closeEvent(event)
        self.closed.emit()


def _told_of(best, rate_now, force):
    """What the best cut is, in a sentence. rate_now: mm3/min of the operation's own; force: N."""
    rate, error = units.LARGE_RATE.shown, units.ERROR.shown
    told = _translate("EvenLoad", "Removes %.3g %s, now %.3g; location error %s, force %.0f N.")
    return told % (
        *(best.removal_rate / rate.size, rate.name, rate_now / rate.size),
        *(error.told(best.surface_location_error), force),
    )
