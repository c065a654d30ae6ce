"""The window Simulation: the load of one or two operations over time, with a cursor that is linked
with the tool in the 3D view.
"""

import html

import FreeCAD
from PySide import QtCore

from evenload import host
from evenload.gui import (
    colours,
    files,
    load_view,
    picking,
    preferences,
    simulation_task,
    view3d,
)
from evenload.gui.length_box import UnitsWatch
from evenload.gui.observer import observer_of_paths
from evenload.gui.running import Running
from evenload.gui.simulation_dock import SimulationDock
from evenload.gui.simulation_node import COLOURED, RunInView
from evenload.gui.simulation_report import JobReport, asked_file
from evenload.gui.slots import slot, telling_slot
from evenload.pictures import load_rows
from evenload.pictures.figure import save
from evenload.simulation.limits import limits_of
from evenload.simulation.table import write_csv
from evenload.words import shortened

_translate = FreeCAD.Qt.translate


class SimulationView:
    """Of one operation, and another beside it where one is given or chosen. closed: called when it
    is to be removed.
    """

    def __init__(self, operation, closed, against=None):
        self.operation, self._closed = operation, closed
        self.runs = []
        self._view = view3d.view_of(operation.Document)
        self._scene = self._view.getSceneGraph()
        self.in_view = RunInView(self._scene)
        self._clicks = picking.Clicks(telling_slot(self._view_clicked))
        self._observer = None
        self.dock = SimulationDock(self)
        self.report = JobReport(self.dock)
        self.task = Running(self.dock, self.dock.show_progress, self._refuse, completed=self._take)
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._connect()
        self._units = UnitsWatch(self.dock, self._show_units)
        self._scene.addChild(self._clicks.root)
        listed = host.with_path(host.parent_job(operation))
        self.dock.list_operations(listed, operation, against)
        self.dock.asked.machine.show_machine(preferences.machine())
        self._show_defaults()
        self.dock.show()
        self.simulate()

    def _connect(self):
        dock = self.dock
        self._again.timeout.connect(slot(self.simulate))
        dock.asked.machine.taken.connect(slot(self.simulate))
        dock.asked.changed.connect(slot(self._asked_changed))
        dock.limits.changed.connect(slot(self._limits_changed))
        dock.slider.valueChanged.connect(telling_slot(self._slid))
        dock.plot.placed.connect(telling_slot(self.place))
        dock.visibilityChanged.connect(telling_slot(self._dock_shown))

    def remove(self):
        """Removes it from the scene and the window, and stops what is under way."""
        self._again.stop()  # it would read a document that may be closed
        self._units.end()
        self.task.cancel()
        self.report.task.cancel()
        self._observe([])
        self._scene.removeChild(self._clicks.root)
        self.in_view.show(None)
        self.dock.hide()
        self.dock.deleteLater()

    # ---- what is asked ----

    def _show_defaults(self):
        """The material and the limits of the operation."""
        material = simulation_task.material_of(self.operation) or preferences.material()
        self.dock.asked.show_values(material=material)
        try:
            degrees, rate = limits_of(self.operation)
        except ValueError:  # without a tool: the simulation tells why there is none
            degrees = rate = None
        self.dock.limits.show_values(
            engagement_deg=degrees or 0.0, removal_rate=rate or 0.0, force_peak=0.0
        )

    def _asked_changed(self):
        chosen = self.dock.asked.operation.currentData()
        if chosen != self.operation.Name:
            found = self.operation.Document.getObject(chosen)
            if found is None:  # deleted since
                self.dock.forget(chosen, self.operation.Name)
                return
            self.operation = found
            self._show_defaults()
        self.simulate()

    def operations(self):
        """The one or two operations that are asked for."""
        names = [self.dock.asked.operation.currentData(), self.dock.asked.against.currentData()]
        found = [self.operation.Document.getObject(name) for name in dict.fromkeys(names) if name]
        return [each for each in found if each is not None]

    def limits(self):
        """{key of a row: its limit in the simulation's unit, or None}"""
        asked = self.dock.limits
        return {
            "engagement_deg": asked.engagement_deg.value() or None,
            "removal_rate": asked.removal_rate.mm() or None,
            "force_peak": asked.force_peak.value() or None,
        }

    def _limits_changed(self):
        self.dock.plot.show_limits(self.limits())
        self.in_view.show_limit(self.limits()[COLOURED.key])

    # ---- simulating ----

    def simulate(self):
        """Simulates what is asked for in a thread, in place of what is under way."""
        asked = self.dock.asked
        machine = asked.machine.machine()
        if machine == "":
            return  # it is being asked for
        operations = self.operations()
        self._observe(operations)
        self.report.task.cancel()  # what it tells of may have changed
        try:
            setups = simulation_task.setups_of(operations, asked.material.currentData(), machine)
        except ValueError as error:
            self.task.cancel()
            self._refuse(str(error))
            return
        self.dock.tell("")
        self.task.run(lambda: simulation_task.simulated(setups, self.task.done))

    def cancel(self):
        """Stops simulation and report; what was there before stays, and is told to be that."""
        told = _translate("EvenLoad", "The simulation was cancelled.")
        if not self.task.is_busy:
            told = _translate("EvenLoad", "The report was cancelled.")
        elif self.runs:
            told = _translate("EvenLoad", "Cancelled: what is shown was simulated before.")
        self.task.cancel()
        self.report.task.cancel()
        self.dock.tell(told, colours.CAUTION)

    def _refuse(self, sentence):
        self.runs = []
        self.in_view.show(None)
        self.dock.plot.show_message(sentence)
        self.dock.values.clear()
        self.dock.show_totals([])
        self.dock.tell(sentence, colours.BAD)

    def _take(self, runs):
        self.runs = runs
        self.in_view.show_limit(self.limits()[COLOURED.key])
        self.dock.plot.show_runs(runs, self.limits())
        self.dock.show_totals(runs)
        self.dock.tell("\n".join(dict.fromkeys(s for run in runs for s in run.simulation.notes)))
        self.place(self.dock.plot.active, 0)

    # ---- what is shown ----

    @property
    def run(self):
        """The Run whose path is in the 3D view, None without any."""
        return self.runs[self.dock.plot.active] if self.runs else None

    def place(self, number, sample):
        """Shows the tool of a run at a sample, in the plots and in the 3D view."""
        run = self.runs[number]
        self.dock.plot.show_cursor(number, sample)
        if self.in_view.run is not run:
            self.in_view.show(run)
        self.in_view.show_tool_at(sample)
        slider = self.dock.slider
        blocked = slider.blockSignals(True)
        slider.setRange(0, len(run.time) - 1)
        slider.setValue(sample)
        slider.blockSignals(blocked)
        self._tell_values()

    def _tell_values(self):
        """Tells what there is at the cursor of the run whose path is in the 3D view."""
        run, plot = self.run, self.dock.plot
        told = load_view.values_at(run.simulation, plot.cursors[plot.active], run.time)
        self.dock.values.setText("<b>%s</b>%s" % (html.escape(shortened(run.name)), told))

    def _show_units(self):
        """Shows all in the units that the user has chosen by now."""
        self.dock.limits.follow_units()
        self.dock.told.follow_units()
        self.dock.plot.follow_units()
        if self.runs:
            self.dock.show_totals(self.runs)
            self._tell_values()

    def _slid(self, sample):
        if self.runs:
            self.place(self.dock.plot.active, sample)

    def fly(self):
        """Goes to the place of the largest engagement."""
        if self.run is None:
            return
        found = self.run.simulation
        number = self.in_view.worst()
        if number is not None:
            self.place(self.dock.plot.active, number)
            place = found.x[number], found.y[number], found.z[number]
            document = self.operation.Document
            view3d.fly_to(document, map(float, place), found.tool_diameter)

    def _view_clicked(self, pixel, size):
        """Moves the cursor to the place of the path that a click into the 3D view is on."""
        if self.run is None:
            return
        camera = self._view.getCameraNode()
        sample = picking.sample_at(camera, size, pixel, self.run.simulation)
        if sample is not None:
            self.place(self.dock.plot.active, sample)

    # ---- files ----

    def save_picture(self):
        path = self._asked_name("Save Picture", files.PICTURES, ".png")
        if path:
            plot = self.dock.plot
            drawn = load_rows.picture(self.runs, plot.limits, plot.span)
            files.write(lambda: save(drawn, path), self.dock.tell)

    def save_table(self):
        path = self._asked_name("Save Table", "CSV (*.csv)", ".csv")
        if path:
            rows = [(run.name, run.simulation) for run in self.runs]
            files.write(lambda: write_csv(path, rows), self.dock.tell)

    def save_report(self):
        job, machine = host.parent_job(self.operation), self.dock.asked.machine.machine()
        path = asked_file(self.dock) if self.runs else ""
        if path and job is not None:
            self.report.start(job, self.dock.asked.material.currentData(), machine, path)

    def _asked_name(self, *asked):
        return files.asked_name(self.dock, *asked) if self.runs else ""

    # ---- what happens meanwhile ----

    def _observe(self, operations):
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None
        if operations:
            self._observer = observer_of_paths(operations, telling_slot(self._changed))
            FreeCAD.addDocumentObserver(self._observer)

    def _changed(self, is_gone):
        if is_gone:
            self._closed()
        else:
            self._again.start()

    def _dock_shown(self, is_shown):
        """A dock that its user closes takes all with it; one behind others does not."""
        if not is_shown and self.dock.isHidden():
            self._closed()
