"""The HTML report of a job: simulated in a thread, drawn and written when all of it is there."""

import FreeCAD

from evenload import host, materials, units
from evenload.gui import colours, files, simulation_task
from evenload.gui.running import Running
from evenload.gui.slots import telling_slot
from evenload.pictures import html_page
from evenload.pictures.job_report import Reported, report_of
from evenload.simulation.limits import limits_of

_translate = FreeCAD.Qt.translate


def asked_file(parent):
    """The file that a report is to be written into, '' where the user cancels."""
    return files.asked_name(parent, "Save Report", "HTML (*.html)", ".html")


class JobReport:
    """Of one job at a time. dock: a widget that shows the progress and tells what becomes of it;
    written: a bound method that gets the file when it is there, and is not kept alive.
    """

    def __init__(self, dock, written=None):
        self._dock, self._written = dock, written and telling_slot(written)
        self._job = self._machine = self._material = self._path = self._reported = None
        self.task = Running(dock, dock.show_progress, self._refuse, completed=self._write)

    def start(self, job, material, machine, path):
        """Simulates the active operations of a job and writes the report into a file."""
        self._job, self._path = job.Label, path
        self._material, self._machine = materials.load(material)["name"], machine
        self._reported = []
        setups = []
        for operation in host.operations(job):
            if host.is_active(operation):
                setups += self._read(operation, material, machine)
        self.task.run(lambda: simulation_task.simulated(setups, self.task.done))

    def _read(self, operation, material, machine):
        """[setup] of an operation, nothing where it cannot be simulated; notes what is known."""
        try:
            (setup,) = simulation_task.setups_of([operation], material, machine)
            degrees, rate = limits_of(operation)
        except ValueError as error:
            self._reported.append(Reported(operation.Label, notes=[str(error)]))
            return []
        read, unit = setup[1], units.LENGTH.shown
        self._reported.append(
            Reported(
                operation.Label,
                "%s, \u00d8 %.5g %s" % (read.tool.name, read.tool.diameter / unit.size, unit.name),
                stock=read.stock,
                part=read.part,
                limits={"engagement_deg": degrees, "removal_rate": rate},
            )
        )
        return [setup]

    def _refuse(self, sentence):
        self._dock.tell(sentence, colours.BAD)

    def _write(self, found):
        runs = iter(found)
        for each in self._reported:
            if not each.notes:
                each.run = next(runs)
                each.notes = each.run.simulation.notes
        if files.write(self._write_page, self._dock.tell):
            self._dock.tell(_translate("EvenLoad", "The report is written."))
            if self._written:
                self._written(self._path)

    def _write_page(self):
        text = report_of(self._job, self._reported, self._machine or "", self._material)
        html_page.write(text, self._path)
