"""The HTML report of a job: read in FreeCAD's thread, simulated, drawn and written in another."""

import FreeCAD

from evenload import host, materials, units, waiting
from evenload.gui import colours, files, simulation_task
from evenload.gui.running import Running
from evenload.gui.slots import telling_slot
from evenload.pictures import html_page
from evenload.pictures.job_report import Reported, report_of
from evenload.simulation.limits import limits_of

_translate = FreeCAD.Qt.translate

SIMULATED = 0.7  # of the progress: what has been done when all is simulated, about


def asked_file(parent):
    """The file that a report is to be written into, '' where the user cancels."""
    return files.asked_name(parent, "Save Report", "HTML (*.html)", ".html")


class JobReport:
    """Of one job at a time. dock: a widget that shows the progress and tells what becomes of it;
    written: a bound method that gets the file when it is there, and is not kept alive.
    """

    def __init__(self, dock, written=None):
        self._dock, self._written = dock, written and telling_slot(written)
        self.task = Running(dock, dock.show_progress, self._refuse, found=self._tell)

    def start(self, job, material, machine, path):
        """Simulates the active operations of a job and writes the report into a file."""
        active = [each for each in host.operations(job) if host.is_active(each)]
        read = [_read(each, material, machine) for each in active]
        facts = job.Label, machine or "", materials.load(material)["name"]
        self.task.run(lambda: _written(read, facts, path, self.task.done))

    def _refuse(self, sentence):
        self._dock.tell(sentence, colours.BAD)

    def _tell(self, path):
        self._dock.tell(_translate("EvenLoad", "The report is written."))
        if self._written:
            self._written(path)


def _read(operation, material, machine):
    """(Reported of an operation, without a run yet; its setup, None where it cannot be simulated,
    as the notes say)
    """
    try:
        (setup,) = simulation_task.setups_of([operation], material, machine)
        degrees, rate = limits_of(operation)
    except ValueError as error:
        return Reported(operation.Label, notes=[str(error)]), None
    read, unit = setup[1], units.LENGTH.shown
    reported = Reported(
        operation.Label,
        "%s, \u00d8 %.5g %s" % (read.tool.name, read.tool.diameter / unit.size, unit.name),
        stock=read.stock,
        part=read.part,
        limits={"engagement_deg": degrees, "removal_rate": rate},
    )
    return reported, setup


def _written(read, facts, path, told):
    """The task that yields the file of the report once it is written. read: what _read() says of
    each operation; facts: names of job, machine and material; told: gets the share that is done.
    """
    job, machine, material = facts
    setups = [setup for _, setup in read if setup is not None]
    runs = simulation_task.simulated(setups, lambda share: told(SIMULATED * share))
    for reported, setup in read:
        if setup is not None:
            reported.run = next(runs)
            reported.notes = reported.run.simulation.notes
    waiting.go_on(SIMULATED)
    told(SIMULATED)
    text = report_of(job, [reported for reported, _ in read], machine, material)
    waiting.go_on(1.0)  # who has cancelled by now gets no file
    try:
        html_page.write(text, path)
    except OSError as error:
        raise ValueError(files.refusal(error)) from None
    yield path
