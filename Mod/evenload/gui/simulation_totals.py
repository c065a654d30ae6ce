"""The table of the window Simulation: the figures of one or two runs beside each other."""

import html

import FreeCAD

from evenload import units
from evenload.gui.areas_node import GOUGE_COLOUR, REST_COLOUR
from evenload.simulation.means import worst_force
from evenload.words import clock, ends_of

_translate = FreeCAD.Qt.translate

LONGEST = 20  # characters of a run's name: as EvenLoadTrochoid001 and some more
ROW = '<tr><td style="padding-right: 10px; white-space: nowrap">%s</td>%s</tr>'
CELL = '<td align="right" style="padding-left: 8px; white-space: nowrap">%s</td>'
SIGN = '<span style="color: %s">\u25a0</span> '  # of the areas in the 3D view


def totals_of(runs):
    """The figures of Runs beside each other, as rich text."""
    found = [run.simulation for run in runs]
    rate, area, length = (each.shown for each in (units.LARGE_RATE, units.AREA, units.LENGTH))
    names = ["<b>%s</b>" % html.escape(ends_of(run.name, LONGEST)) for run in runs]
    rows = [
        ("", names),
        (_translate("EvenLoad", "Time"), [clock(each.time_total_s) for each in found]),
    ]
    if all(each.machine_time_total_s is not None for each in found):
        times = [clock(each.machine_time_total_s) for each in found]
        rows.append((_translate("EvenLoad", "On the machine"), times))
    rows += [
        (_translate("EvenLoad", "Engagement"), _figures("%.1f°", "max_engagement_deg", found)),
        (
            _translate("EvenLoad", "Removal rate, %s") % rate.name,
            _figures("%.3g", "removal_rate_peak", found, rate.size),
        ),
    ]
    forces = [worst_force(each) for each in found]
    if None not in forces:
        rows.append((_translate("EvenLoad", "Force, N"), ["%.0f" % each for each in forces]))
    rows += [
        (
            SIGN % REST_COLOUR + _translate("EvenLoad", "Rest, %s") % area.name,
            _figures("%.3g", "rest_area", found, area.size),
        ),
        (
            SIGN % GOUGE_COLOUR + _translate("EvenLoad", "Gouge, %s") % length.name,
            [length.figure(each.gouge_mm) for each in found],
        ),
        (_translate("EvenLoad", "Incidents"), ["%d" % len(each.incidents) for each in found]),
    ]
    lines = [ROW % (title, "".join(CELL % value for value in values)) for title, values in rows]
    return "<table>%s</table>" % "".join(lines)


def _figures(form, key, found, size=1.0):
    return [form % (getattr(each, key) / size) for each in found]
