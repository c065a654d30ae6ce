"""A report of the simulations of a job as one HTML file, made to be printed. Needs no FreeCAD."""

import html
from dataclasses import dataclass, field

from evenload.pictures import html_page, load_rows, simulation_pictures
from evenload.pictures.figure import save
from evenload.words import clock, listed

MOST_INCIDENTS = 50  # of an operation, that are listed one by one
CM3 = 1e3  # mm3
HEAD = (
    *("Operation", "Tool", "Time", "On the machine", "Engagement, \u00b0"),
    *("Removal rate, cm\u00b3/min", "Force, N", "Rest, mm\u00b2", "Incidents"),
)


@dataclass
class Reported:
    """An operation of the job. run: None where it could not be simulated, and why in `notes`."""

    name: str
    tool: str = ""
    run: object = None  # a load_rows.Run
    stock: object = ()  # in the words that `simulate` takes, as the part
    part: object = ()  # None: what must stay is not known
    limits: dict = field(default_factory=dict)  # as load_rows.draw takes them
    notes: list = field(default_factory=list)  # sentences


def report_of(job, reported, machine="", material=""):
    """The report as a text. job: its name; reported: of Reported, in their order; machine and
    material: their names, '' without.
    """
    parts = [_verdict(reported), _facts(reported, machine, material), _table(reported)]
    for each in reported:
        parts += _section(each)
    return html_page.page("Simulation of %s" % job, parts)


def _verdict(reported):
    count = sum(len(each.run.simulation.incidents) for each in reported if each.run)
    unknown = [each.name for each in reported if each.run is None]
    if count:
        return html_page.verdict("bad", "Incidents: %d, see below." % count)
    if not reported:
        return html_page.verdict("open", "The job has no active operation.")
    if unknown:
        return html_page.verdict("open", "Not simulated: %s." % listed(unknown))
    unchecked = [each.name for each in reported if each.part is None]
    if unchecked:
        words = "No incidents; what must stay is not known for %s." % listed(unchecked)
        return html_page.verdict("open", words)
    return html_page.verdict("good", "No gouge, no rapid or plunge in material.")


def _facts(reported, machine, material):
    found = [each.run.simulation for each in reported if each.run]
    rows = [("Time at the programmed feeds", clock(sum(each.time_total_s for each in found)))]
    if machine:
        times = (each.machine_time_total_s for each in found)
        rows.append(("Time on the machine", "%s, %s" % (clock(sum(times)), machine)))
    if material:
        rows.append(("Material of the forces", material))
    rows.append(("Not in the times", "Tool changes, dwells of the spindle, coolant"))
    return html_page.facts(rows)


def _table(reported):
    rows = [
        _row(each, each.run.simulation) if each.run else (each.name, each.tool, *("",) * 7)
        for each in reported
    ]
    bad = {n for n, each in enumerate(reported) if each.run and each.run.simulation.incidents}
    return "<h2>Operations</h2>" + html_page.table(HEAD, rows, bad)


def _row(reported, found):
    machine, force = found.machine_time_total_s, found.force_peak_max
    return (
        *(reported.name, reported.tool, clock(found.time_total_s)),
        "" if machine is None else clock(machine),
        "%.1f" % found.max_engagement_deg,
        "%.3g" % (found.removal_rate_peak / CM3),
        "" if force is None else "%.0f" % force,
        "%.2f" % found.rest_area,
        "%d" % len(found.incidents),
    )


def _section(reported):
    parts = ["<h2>%s</h2>" % html.escape(reported.name)]
    parts.append(html_page.sentences(reported.notes))
    if reported.run is None:
        return parts
    found, name = reported.run.simulation, reported.name
    parts.append(_incidents(found))
    parts += [
        html_page.picture(
            lambda file: save(load_rows.picture([reported.run], reported.limits), file),
            "Load of %s over time" % name,
        ),
        html_page.picture(
            lambda file: simulation_pictures.path(found, file), "Engagement along %s" % name
        ),
        html_page.picture(
            lambda file: simulation_pictures.rest(found, file, reported.stock, reported.part or ()),
            "Rest and incidents of %s" % name,
        ),
    ]
    return parts


def _incidents(found):
    if not found.incidents:
        return html_page.sentences(["No incidents."])
    rows = [
        (what.capitalize(), "%d" % line, *("%.3f" % each for each in (x, y, z, amount)))
        for what, x, y, z, _, line, amount in found.incidents[:MOST_INCIDENTS]
    ]
    more = len(found.incidents) - len(rows)
    head = ("Incident", "Command", "x, mm", "y, mm", "z, mm", "Amount, mm")
    told = html_page.sentences(["Not listed: %d more." % more]) if more else ""
    return html_page.table(head, rows, set(range(len(rows)))) + told
