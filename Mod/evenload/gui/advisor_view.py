"""What the dock Finishing Advisor does: compares strategies, and makes an operation of one."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import advisor
from evenload import tool as tools
from evenload.gui import colours, preferences, steps
from evenload.gui.advisor_dock import AdvisorDock
from evenload.gui.advisor_table import name_of
from evenload.gui.advisor_task import answers, observer_of, preferred_settings
from evenload.gui.length_box import UnitsWatch
from evenload.gui.running import Running
from evenload.gui.slots import slot, telling_slot
from evenload.operations import finishing
from evenload.operations.base import SENTENCES
from evenload.settings.labels import told
from evenload.settings.sentences import shown_name
from evenload.settings.table import EVEN_CUSPS
from evenload.words import name_of as name_of_faces

_translate = FreeCAD.Qt.translate

SHARE = 0.05  # of the tool's diameter: the stepover at first, as the operation has it


class AdvisorView:
    """The dock for an operation EvenLoad Finishing, or for faces of a job, [(object, names of its
    faces), ...]. closed: called when it is to be removed. Raises ValueError without faces.
    """

    def __init__(self, job, faces, operation, closed):
        if operation is None and not faces:
            raise ValueError(
                _translate(
                    "EvenLoad",
                    "Select the faces that are to be finished, or a finishing operation.",
                )
            )
        self.job, self.faces, self.operation, self._closed = job, faces, operation, closed
        self.rows = []
        self._shown = None  # of the operation
        self.dock = AdvisorDock(self)
        self.task = Running(self.dock, self._progressed, self._refuse, found=self._take)
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._show_defaults()
        self._connect()
        self._observer = None
        self._units = UnitsWatch(self.dock, self.dock.follow_units)
        self.dock.show()
        self.compare()

    def _connect(self):
        asked = self.dock.asked
        asked.Stepover.valueChanged.connect(slot(self._stepover_set))
        asked.CuspHeight.valueChanged.connect(slot(self._cusp_height_set))
        asked.controller.currentIndexChanged.connect(slot(self._stepover_set))
        asked.changed.connect(slot(self._compare_soon))
        asked.machine.taken.connect(slot(self._compare_soon))
        self._again.timeout.connect(slot(self.compare))
        self.dock.table.selectionModel().selectionChanged.connect(slot(self._enable))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))

    def remove(self):
        """Removes it from the window, and stops what is under way."""
        self.task.cancel()
        self._again.stop()
        self._units.end()
        self._stop_observing()
        self.dock.hide()
        self.dock.deleteLater()

    # ---- what is asked ----

    def _show_defaults(self):
        """The operation's settings, or those of a new one."""
        self.dock.list_controllers(self.job.Tools.Group)
        self.dock.asked.machine.show_machine(preferences.machine())
        operation = self.operation
        if operation is not None:
            self._show_operation()
            name, lengths = operation.Label, {}
        else:
            balls = [each for each in self.job.Tools.Group if _has_ball(each)]
            if balls:
                self.dock.asked.show_values(controller=balls[0].Name)
            stepover = SHARE * tools.diameter(self.controller())
            lengths = {"Stepover": stepover, "CuspHeight": self._cusp_height(stepover)}
            faces = [(obj.Label, each) for obj, names in self.faces for each in names]
            name = shown_name(name_of_faces(faces))
        self.dock.faces.setText(name)
        self.dock.show_lengths(stock=advisor.STOCK, **lengths)
        title, tip = (
            ("Make Operation", "Makes an operation EvenLoad Finishing of the chosen strategy")
            if operation is None
            else ("Set Operation", "Gives the operation the chosen strategy")
        )
        self.dock.make.setText(_translate("EvenLoad", title))
        self.dock.make.setToolTip(_translate("EvenLoad", tip))

    def _show_operation(self):
        """Shows what the operation has, unless that is what it had before."""
        operation = self.operation
        controller = operation.ToolController and operation.ToolController.Name
        lengths = operation.Stepover.Value, operation.CuspHeight.Value
        values = controller, operation.Spacing, lengths
        if values == self._shown:
            return
        self._shown = values
        self.dock.asked.show_values(controller=controller, Spacing=operation.Spacing)
        self.dock.show_lengths(Stepover=lengths[0], CuspHeight=lengths[1])

    def controller(self):
        """The tool controller that is chosen, None without any."""
        name = self.dock.asked.controller.currentData()
        return self.job.Document.getObject(name) if name else None

    def _end_radius(self):
        return tools.end_radius(self.controller()) if self.controller() is not None else 0.0

    def _cusp_height(self, stepover):
        radius = self._end_radius()
        return finishing.cusp_height_of(stepover, radius) if stepover / 2 <= radius else 0.0

    def _stepover_set(self):
        self.dock.show_lengths(CuspHeight=self._cusp_height(self.dock.asked.Stepover.mm()))

    def _cusp_height_set(self):
        height, radius = self.dock.asked.CuspHeight.mm(), self._end_radius()
        if 0 < height <= radius:
            self.dock.show_lengths(Stepover=finishing.stepover_of(height, radius))

    def _settings(self):
        """{name: value} of the operation's settings that the dock has, lengths in mm."""
        lengths = self.dock.lengths()
        spacing = self.dock.asked.Spacing.currentData()
        found = {"Spacing": spacing, "Stepover": lengths["Stepover"]}
        if spacing == EVEN_CUSPS:
            found["CuspHeight"] = lengths["CuspHeight"]
        return found

    # ---- comparing ----

    def _compare_soon(self):
        """When all that follows a change has followed it."""
        self._again.start()

    def compare(self):
        """Compares the strategies as the dock asks, in place of what is under way."""
        asked = self.dock.asked
        if asked.machine.machine() == "":
            return  # it is being asked for
        self._observe()
        preferred = preferred_settings() if self.operation is None else {}
        self._show([])
        self.dock.tell("")
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            question = advisor.read(
                self.job if self.operation is None else self.operation,
                self.faces if self.operation is None else None,
                controller=self.controller(),
                stock=self.dock.lengths()["stock"],
                material=asked.material.currentData(),
                machine=asked.machine.machine(),
                **{**preferred, **self._settings()},
            )
        except ValueError as error:
            self.task.cancel()
            self._refuse(str(error))
            return
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        self.task.run(lambda: answers(question, self.task.done))

    def cancel(self):
        """Stops the comparison; the strategies that are known stay."""
        self.task.cancel()
        self.dock.tell(_translate("EvenLoad", "The comparison was cancelled."), colours.CAUTION)

    def _progressed(self, share):
        self.dock.show_progress(share)

    def _take(self, row):
        self._show([*self.rows, row])

    def _refuse(self, sentence):
        self.dock.tell(told(sentence), colours.BAD)

    def _show(self, rows):
        self.rows = rows
        self.dock.show_rows(rows)
        self._enable()

    def _enable(self):
        chosen = self.dock.chosen()
        self.dock.make.setEnabled(chosen is not None and not chosen.refusal)

    # ---- the operation ----

    def make(self):
        """Makes an operation of the chosen row, or sets the one that is compared; one undoable
        step, or in that one's open panel a part of its edit.
        """
        chosen, document = self.dock.chosen(), self.job.Document
        if chosen is None:
            return
        refusal = steps.refusal(self.operation)
        if refusal:
            self.dock.tell(refusal, colours.BAD)
            return
        page = steps.page_of(self.operation)
        name = _translate("EvenLoad", "EvenLoad Finishing Advisor")
        try:
            with steps.step(document, self.operation, name):
                operation = self.operation or self._created()
                self._set(operation, chosen.strategy)
                if page is None:
                    document.recompute()
                    self._again.stop()  # what is compared is what it has now
        except SENTENCES as error:
            self._refuse(str(error))
            return
        if page is not None:
            page.show_taken()
            self.dock.tell(_translate("EvenLoad", "Taken into the panel."), colours.GOOD)
        elif operation.isValid():
            done = _translate("EvenLoad", "%s cuts by %s.")
            named = done % (operation.Label, name_of(chosen.strategy))
            self.dock.tell("", colours.GOOD, named)
        else:
            self._refuse(operation.Report)

    def _created(self):
        operation = finishing.Create(
            finishing.NAME.replace(" ", ""), parentJob=self.job, toolController=self.controller()
        )
        operation.ViewObject.Visibility = True
        preferences.set_defaults(operation)
        operation.Base = finishing.of_models(self.job, self.faces)
        return operation

    def _set(self, operation, strategy):
        if operation.ToolController != self.controller():
            operation.ToolController = self.controller()
        for name, value in {**self._settings(), **strategy.settings}.items():
            setattr(operation, name, value)

    # ---- what happens meanwhile ----

    def _observe(self):
        """Follows what is compared, with the tool bits that there are now."""
        self._stop_observing()
        self._observer = observer_of(self.job, self.operation, telling_slot(self._changed))
        FreeCAD.addDocumentObserver(self._observer)

    def _stop_observing(self):
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
            return
        if self.operation is not None:
            self._show_operation()
        else:
            self._stepover_set()  # the ball may be another
        self._compare_soon()

    def _dock_shown(self, is_shown):
        """A dock that its user closes ends; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()


def _has_ball(controller):
    return controller.Tool is not None and tools.end_radius(controller) > 0
