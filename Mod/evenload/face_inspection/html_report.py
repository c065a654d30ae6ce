"""A report of an evaluation as one HTML file, with its picture in it, made to be printed."""

import base64
import html
import io

from evenload.face_inspection.evaluation import IN, OUT
from evenload.face_inspection.picture import save_map

VERDICTS = {IN: "good", OUT: "bad"}
STYLE = """
body { font: 10pt/1.4 sans-serif; color: #202124; max-width: 180mm; margin: 10mm auto; }
h1 { font-size: 16pt; margin: 0 0 2mm; } h2 { font-size: 12pt; margin: 6mm 0 2mm; }
img { width: 100%; max-width: 150mm; display: block; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 0.6mm 2mm; border-bottom: 0.2mm solid #dadce0; }
th:first-child, td:first-child { text-align: left; }
thead { display: table-header-group; } tr { break-inside: avoid; }
.facts td:last-child { text-align: left; width: 75%; }
.verdict { font-size: 13pt; font-weight: bold; padding: 2mm 3mm; border: 0.5mm solid; }
.good { color: #137333; } .bad { color: #b3261e; } .open { color: #7a4f00; }
tr.bad td { font-weight: bold; }
@page { margin: 15mm; } @media print { body { margin: 0; max-width: none; } }
"""


def write_report(evaluation, path, source=""):
    """Writes the report of an Evaluation; source: the name of the file of points.

    The same evaluation gives the same bytes: a browser prints the day itself.
    """
    with open(path, "w", encoding="utf-8") as file:
        file.write(report_of(evaluation, source))


def report_of(evaluation, source=""):
    """The report as a text."""
    title = "Inspection of %s" % evaluation.faces.name
    parts = [
        "<h1>%s</h1>" % html.escape(title),
        _verdict(evaluation),
        "".join("<p>%s</p>" % html.escape(each) for each in evaluation.sentences),
        _facts(evaluation, source),
        '<h2>Deviations</h2><img alt="Map of the deviations" src="data:image/png;base64,%s">'
        % _picture(evaluation),
        _certificate(evaluation),
        _points(evaluation),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>%s</title>'
        "<style>%s</style></head>\n<body>%s</body></html>\n"
        % (html.escape(title), STYLE, "\n".join(parts))
    )


def _verdict(evaluation):
    if evaluation.verdict is None:
        return ""
    kind = VERDICTS.get(evaluation.verdict, "open")
    return '<p class="verdict %s">%s</p>' % (kind, evaluation.verdict.capitalize())


def _picture(evaluation):
    data = io.BytesIO()
    save_map(evaluation, data)
    return base64.b64encode(data.getvalue()).decode("ascii")


def _facts(evaluation, source):
    found, deviations = evaluation.found, evaluation.deviations
    rows = [
        ("Faces", ", ".join("%s of %s" % (n, label) for label, n in evaluation.faces.parts)),
        ("Points", "%d%s" % (len(deviations), ", of " + source if source else "")),
        (evaluation.error.capitalize(), "%.5f mm" % evaluation.zone),
    ]
    if evaluation.tolerance is not None:
        rows.append(("Tolerance", "%.5f mm" % evaluation.tolerance))
    rows.append(("Deviations", "%.5f to %.5f mm" % (deviations.min(), deviations.max())))
    for name, title, unit in (("radius", "Radius", " mm"), ("point", "Place", " mm")):
        value = getattr(found, name, None)
        if value is not None:
            rows.append((title, _numbers(value) + unit))
    if getattr(found, "direction", None) is not None:
        rows.append(("Direction", _numbers(found.direction)))
    if hasattr(found, "shift"):
        rows.append(("Shift of the points", _numbers(found.shift) + " mm"))
        rows.append(("Turn of the points", "; ".join(map(_numbers, found.turn))))
    cells = "".join("<tr><td>%s</td><td>%s</td></tr>" % tuple(map(html.escape, r)) for r in rows)
    return '<table class="facts">%s</table>' % cells


def _certificate(evaluation):
    found = evaluation.found
    names = evaluation.measured.names
    rows = [
        (names[number], "outer" if side > 0 else "inner", "%.6f" % multiplier)
        for number, side, multiplier in zip(found.contacts, found.sides, found.multipliers)
    ]
    proved = "proved" if found.is_proved else "not proved"
    told = "The minimum zone is %s; what is left of the forces' balance is %.1e." % (
        proved,
        found.imbalance,
    )
    head = ("Contact, point", "Bound", "Multiplier")
    return "<h2>Certificate</h2><p>%s</p>%s" % (told, _table(head, rows))


def _points(evaluation):
    measured, beyond = evaluation.measured, evaluation.is_beyond
    rows = [
        (name, *("%.4f" % each for each in point), "%+.5f" % deviation)
        for name, point, deviation in zip(
            measured.names, measured.points.tolist(), evaluation.deviations
        )
    ]
    bad = set() if beyond is None else {row for row, is_bad in enumerate(beyond) if is_bad}
    head = ("Point", "x, mm", "y, mm", "z, mm", "Deviation, mm")
    return "<h2>Points</h2>" + _table(head, rows, bad)


def _table(head, rows, bad=()):
    lines = ["<tr>%s</tr>" % "".join("<th>%s</th>" % html.escape(each) for each in head)]
    body = [
        "<tr%s>%s</tr>"
        % (
            ' class="bad"' if number in bad else "",
            "".join("<td>%s</td>" % html.escape(each) for each in row),
        )
        for number, row in enumerate(rows)
    ]
    return "<table><thead>%s</thead><tbody>%s</tbody></table>" % (lines[0], "\n".join(body))


def _numbers(value):
    if hasattr(value, "__len__"):
        return ", ".join("%.6f" % float(each) for each in value)
    return "%.5f" % value
