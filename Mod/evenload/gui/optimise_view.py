"""The dock Optimise: what is set now beside what tool and machine allow, of one operation."""

import FreeCAD
from PySide import QtCore

from evenload import host
from evenload.gui import colours, preferences, steps
from evenload.gui import optimise_inputs as asking
from evenload.gui.length_box import UnitsWatch
from evenload.gui.observer import bits_of, own_properties
from evenload.gui.optimise_dock import OptimiseDock
from evenload.gui.optimise_task import Edited, computed
from evenload.gui.running import Running
from evenload.gui.slots import slot, telling_slot
from evenload.operations.base import SENTENCES
from evenload.operations.checks import DEPTHS
from evenload.settings.labels import told
from evenload.stability import taking
from evenload.suggestion import cut as cuts
from evenload.suggestion import kept, search

_translate = FreeCAD.Qt.translate

DELAY = 200  # ms without a change until it is looked whether what is shown still holds
FOLLOWED = (  # besides settings and depths: of operation, tool controller and base geometry
    *("Base", "ToolController", "ExpressionEngine", "Shape", "Placement"),
    *("SpindleSpeed", "SpindleDir", "HorizFeed", "VertFeed", "HorizRapid", "Tool"),
)


class OptimiseView:
    """closed: called when it is to be removed."""

    def __init__(self, operation, closed):
        self.operation, self._closed = operation, closed
        self.cut = self.asked = self.now = self.found = self.chosen = None
        self.dock = OptimiseDock(self)
        self.task = Running(
            self.dock, self.dock.show_progress, self._refuse, completed=self._take_results
        )
        self._observer = None
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.setInterval(DELAY)
        self._units = UnitsWatch(self.dock, self._units_changed)
        self._connect()
        self.dock.limits.machine.show_machine(preferences.machine())
        self.dock.limits.show_values(material=operation.Material)
        self.dock.show()
        self.show_operation()

    def _connect(self):
        dock = self.dock
        self._again.timeout.connect(slot(self._look_again))
        for box in (dock.limits, dock.tool, dock.to_try):
            box.changed.connect(slot(self._inputs_changed))
        dock.limits.machine.taken.connect(slot(self._inputs_changed))
        dock.chosen.connect(telling_slot(self.choose))
        dock.visibilityChanged.connect(telling_slot(self._dock_shown))

    def remove(self):
        """Removes it from the window, and stops what is under way."""
        self.task.cancel()
        self._again.stop()
        self._units.end()
        self._stop_observing()
        self.dock.hide()
        self.dock.deleteLater()

    # ---- the operation ----

    def show_operation(self):
        """Reads operation and tool, and shows what is known of the tool."""
        self._observe(*self._sources())
        self._forget()
        if self._read():
            self.dock.tool.show_values(**self._limits_known)
            self._ask()

    def _read(self):
        """Whether the operation can be read; tells why not."""
        try:
            self.cut = cuts.read(self.operation)
            self._limits_known = kept.of(self.operation.ToolController, self.cut)
        except SENTENCES as error:
            self.cut = None
            self._refuse(str(error))
        return self.cut is not None

    def _ask(self):
        self.dock.tell(
            _translate("EvenLoad", "Suggest looks for the quickest cut within these limits.")
        )

    def _forget(self):
        """Shows no suggestion any more."""
        self.task.cancel()
        self.now = self.found = self.chosen = None
        self.dock.show_nothing()

    # ---- computing ----

    def suggest(self):
        """Computes what is set now and what is suggested, in place of what is under way."""
        machine = self.dock.limits.machine.machine()
        if machine == "":
            return  # it is being asked for
        self._forget()
        if not self._read():
            return
        try:
            self.asked = self._asked(machine)
        except ValueError as error:
            self._refuse(str(error))
            return
        self._keep()
        self.dock.tell(_translate("EvenLoad", "Computing"))
        cut, asked, done = self.cut, self.asked, self.task.done
        self.task.run(lambda: computed(cut, asked, done))

    def _asked(self, machine):
        limits, tool = self.dock.limits, asking.tool_of(self.dock.tool)
        if tool["least_speed"] > tool["most_speed"]:
            raise ValueError(_translate("EvenLoad", "The surface speeds must rise."))
        return search.Asked(
            **tool,
            material=limits.material.currentData(),
            machine=machine,
            **{name: getattr(limits, name).value() or None for name in asking.KEPT},
            **self.dock.to_try.values(),
        )

    def _keep(self):
        """Keeps what was asked for the next time; of the tool in the document, unless a panel is
        open: then it is kept when it is taken.
        """
        asking.keep_limits(self.dock.limits)
        self.dock.to_try.keep()
        controller, limits = self.operation.ToolController, asking.tool_of(self.dock.tool)
        if not kept.changed(controller, self.cut, limits) or steps.refusal(self.operation):
            return
        name = _translate("EvenLoad", "Limits of a tool")
        with steps.step(self.operation.Document, self.operation, name):
            kept.keep(controller, self.cut, limits)

    def cancel(self):
        """Stops what is under way."""
        self._forget()
        self.dock.tell(_translate("EvenLoad", "The suggestion was cancelled."), colours.CAUTION)

    def _refuse(self, sentence):
        self._forget()
        self.dock.tell(told(sentence), colours.BAD)

    def _take_results(self, results):
        self.now, self.found = results
        if self.found.best is None:
            self._refuse("\n".join([self.found.why, *self._notes()]))
            return
        self._list()
        self.choose(self.found.best)

    def _list(self):
        self.dock.show_candidates(self.found.ranked(), self.asked.machine is not None)

    def choose(self, candidate):
        """Compares a candidate with what is set now."""
        if candidate is self.chosen:
            return
        self.chosen = candidate
        self.dock.compare(self.now, candidate)
        others = taking.sharers(self.operation)
        shared = _translate("EvenLoad", "%s: the same tool controller.") % ", ".join(others)
        self.dock.tell("\n".join(self._notes()), named=shared if others else "")

    def _notes(self):
        notes = [*self.cut.notes, *(self.found.notes if self.found else ())]
        if self.cut.modes is None:
            notes.append(
                _translate("EvenLoad", "Chatter is not looked at: the tool has no modes of it.")
            )
        if not self.cut.spindle_speed > 0:
            notes.append(_translate("EvenLoad", "The tool controller has no spindle speed now."))
        return notes

    # ---- what the user does ----

    def take(self):
        """Sets the chosen candidate in operation and tool controller: in a panel that is open as
        what was edited there, else as one step, and computes the path.
        """
        chosen, asked = self.chosen, self.asked
        refusal = steps.refusal(self.operation)
        if refusal:
            self.dock.tell(refusal, colours.BAD)
            return
        numbers = {
            "speed": chosen.spindle_speed,
            "depth": None if asked.keeps_depth else chosen.axial_depth,
            "engagement_deg": None if asked.keeps_angle else chosen.engagement_deg,
            "feed": search.feed_of(chosen),
        }
        page = steps.page_of(self.operation)
        self._again.stop()
        self._stop_observing()  # a long recompute lets the window go on, and what is taken is shown
        try:
            self._set(numbers, page)
        finally:
            self._observe(*self._sources())
        if page is None and not self.operation.isValid():
            self._refuse(self.operation.Report or self.operation.getStatusString())
            return
        if not self._read():
            return
        self.now = chosen
        self.dock.compare(self.now, chosen)
        self.dock.tell(
            _translate("EvenLoad", "Taken into the panel.")
            if page is not None
            else _translate("EvenLoad", "Taken: Undo sets what was before.")
        )

    def _set(self, numbers, page):
        controller, document = self.operation.ToolController, self.operation.Document
        with steps.step(document, self.operation, _translate("EvenLoad", "EvenLoad Optimise")):
            limits = asking.tool_of(self.dock.tool)
            kept.keep(controller, self.cut, limits, always=kept.SPEEDS)
            taking.take_open(self.operation, **numbers)
            if page is None:
                document.recompute()
            else:
                page.show_taken()

    def _inputs_changed(self):
        if self.found is not None or self.task.is_busy:
            self._forget()
        if self.cut is not None:
            self._ask()

    def _units_changed(self):
        self.dock.tool.follow_units()
        self.dock.told.follow_units()
        if self.chosen is not None:
            self._list()
            self.dock.compare(self.now, self.chosen)

    # ---- what happens meanwhile ----

    def _sources(self):
        """(operation and tool controller, without which there is nothing to show; what else the
        figures come from)
        """
        controller = host.controller_of(self.operation)
        controllers = [controller] if controller is not None else []
        bases = [obj for obj, _ in self.operation.Base]
        return [self.operation, *controllers], [*bits_of(controllers), *bases]

    def _observe(self, objects, used):
        self._stop_observing()
        settings = [row.name for row in self.operation.Proxy.settings]
        bits = bits_of(objects[1:])
        followed = {*FOLLOWED, *settings, *DEPTHS, *own_properties(bits)}
        self._observer = Edited(objects, followed, telling_slot(self._changed), used)
        FreeCAD.addDocumentObserver(self._observer)

    def _stop_observing(self):
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
        else:
            self._again.start()

    def _look_again(self):
        """After a change: figures of what is no longer set are not shown."""
        objects, used = self._sources()
        if not self._observer.is_of(*objects, *used):
            self.show_operation()
            return
        before = self.cut.state() if self.cut is not None else None
        if self._read() and self.cut.state() != before:
            self._forget()
            self.dock.tool.show_values(**self._limits_known)
            self._ask()

    def _dock_shown(self, is_shown):
        """A dock that its user closes takes all with it; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()
