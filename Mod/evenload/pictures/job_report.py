"""A report of the simulations of a job as one HTML file, made to be printed. Needs no FreeCAD.

It is in the user's language where it is made in FreeCAD's window, else in English.
"""

from dataclasses import dataclass, field

from evenload import units
from evenload.pictures import html_page, load_rows, simulation_pictures
from evenload.pictures.figure import save
from evenload.settings.sentences import shown
from evenload.simulation.means import worst_force
from evenload.translation import filled, translate
from evenload.words import MOST_NAMES, clock, listed

MOST_INCIDENTS = 50  # of an operation, that are listed one by one
# With places for the units of removal rate and rest, and of lengths.
HEAD = (
    *("Operation", "Tool", "Time", "On the machine", "Engagement, \u00b0"),
    *("Removal rate, %s", "Force, N", "Rest, %s", "Incidents"),
)
AXES = "x, %s", "y, %s", "z, %s"  # the same in each language
INCIDENT_HEAD = ("Incident", "Command", *AXES, "Amount, %s")
KINDS = ("Gouge", "Fixture", "Rapid in material", "Plunge in material")  # the core's, of incidents


@dataclass
class Reported:
    """An operation of the job. run: None where it could not be simulated, and why in `notes`."""

    name: str
    tool: str = ""
    run: object = None  # a load_rows.Run
    stock: object = ()  # in the words that `simulate` takes, as the part
    part: object = ()  # None: what must stay is not known
    limits: dict = field(default_factory=dict)  # as load_rows.draw takes them
    notes: list = field(default_factory=list)  # sentences in English


def report_of(job, reported, machine="", material=""):
    """The report as a text. job: its name; reported: of Reported, in their order; machine and
    material: their names, '' without.
    """
    parts = [_verdict(reported), _facts(reported, machine, material), _table(reported)]
    for each in reported:
        parts += _section(each)
    return html_page.page(translate("Simulation of %s") % job, parts)


def _verdict(reported):
    count = sum(len(each.run.simulation.incidents) for each in reported if each.run)
    unknown = [each.name for each in reported if each.run is None]
    if count:
        return html_page.verdict("bad", translate("Incidents: %d, see below.") % count)
    if not reported:
        return html_page.verdict("open", translate("The job has no active operation."))
    if unknown:
        return html_page.verdict("open", translate("Not simulated: %s.") % _listed(unknown))
    unchecked = [each.name for each in reported if each.part is None]
    if unchecked:
        words = translate("No incidents; what must stay is not known for %s.")
        return html_page.verdict("open", words % _listed(unchecked))
    return html_page.verdict("good", translate("No gouge, no rapid or plunge in material."))


def _listed(names):
    """As listed(), in the user's language."""
    names = list(dict.fromkeys(names))
    beyond = len(names) - MOST_NAMES
    if beyond <= 0:
        return listed(names)
    return filled(translate("%1 and %2 more"), (listed(names[:MOST_NAMES]), str(beyond)))


def _facts(reported, machine, material):
    found = [each.run.simulation for each in reported if each.run]
    time = clock(sum(each.time_total_s for each in found))
    rows = [(translate("Time at the programmed feeds"), time)]
    if machine:
        times = (each.machine_time_total_s for each in found)
        rows.append((translate("Time on the machine"), "%s, %s" % (clock(sum(times)), machine)))
    if material:
        rows.append((translate("Material of the forces"), material))
    left_out = translate("Tool changes, dwells of the spindle, coolant")
    rows.append((translate("Not in the times"), left_out))
    return html_page.facts(rows)


def _table(reported):
    rows = [
        _row(each, each.run.simulation) if each.run else (each.name, each.tool, *("",) * 7)
        for each in reported
    ]
    head = _head(HEAD, units.LARGE_RATE.shown.name, units.AREA.shown.name)
    bad = {n for n, each in enumerate(reported) if each.run and each.run.simulation.incidents}
    return html_page.heading(translate("Operations")) + html_page.table(head, rows, bad)


def _head(texts, *names):
    """Translated texts, with the names of units in their places."""
    names = iter(names)
    told = map(translate, texts)
    return [each % next(names) if "%s" in each else each for each in told]


def _row(reported, found):
    machine, force = found.machine_time_total_s, worst_force(found)
    return (
        *(reported.name, reported.tool, clock(found.time_total_s)),
        "" if machine is None else clock(machine),
        "%.1f" % found.max_engagement_deg,
        "%.3g" % (found.removal_rate_peak / units.LARGE_RATE.shown.size),
        "" if force is None else "%.0f" % force,
        units.AREA.shown.figure(found.rest_area),
        "%d" % len(found.incidents),
    )


def _section(reported):
    parts = [html_page.heading(reported.name)]
    parts.append(html_page.sentences(map(shown, reported.notes)))
    if reported.run is None:
        return parts
    found, name = reported.run.simulation, reported.name
    parts.append(_incidents(found))
    parts += [
        html_page.picture(
            lambda file: save(load_rows.picture([reported.run], reported.limits), file),
            translate("Load of %s over time") % name,
        ),
        html_page.picture(
            lambda file: simulation_pictures.path(found, file),
            translate("Engagement along %s") % name,
        ),
        html_page.picture(
            lambda file: simulation_pictures.rest(found, file, reported.stock, reported.part or ()),
            translate("Rest and incidents of %s") % name,
        ),
    ]
    return parts


def _incidents(found):
    if not found.incidents:
        return html_page.sentences([translate("No incidents.")])
    length = units.LENGTH.shown
    rows = [
        (translate(what.capitalize()), "%d" % line, *map(length.figure, (x, y, z, amount)))
        for what, x, y, z, _, line, amount in found.incidents[:MOST_INCIDENTS]
    ]
    more = len(found.incidents) - len(rows)
    told = html_page.sentences([translate("Not listed: %d more.") % more]) if more else ""
    return (
        html_page.table(_head(INCIDENT_HEAD, *4 * (length.name,)), rows, set(range(len(rows))))
        + told
    )
