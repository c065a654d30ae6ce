"""A report of an evaluation as one HTML file, with its picture in it, made to be printed."""

from evenload.face_inspection.evaluation import IN, OUT
from evenload.face_inspection.picture import save_map
from evenload.pictures import html_page

VERDICTS = {IN: "good", OUT: "bad"}


def write_report(evaluation, path, source=""):
    """Writes the report of an Evaluation; source: the name of the file of points. The same
    evaluation gives the same bytes.
    """
    html_page.write(report_of(evaluation, source), path)


def report_of(evaluation, source=""):
    """The report as a text."""
    parts = [
        _verdict(evaluation),
        html_page.sentences(evaluation.sentences),
        _facts(evaluation, source),
        "<h2>Deviations</h2>",
        html_page.picture(lambda file: save_map(evaluation, file), "Map of the deviations"),
        _certificate(evaluation),
        _points(evaluation),
    ]
    return html_page.page("Inspection of %s" % evaluation.faces.name, parts)


def _verdict(evaluation):
    if evaluation.verdict is None:
        return ""
    kind = VERDICTS.get(evaluation.verdict, "open")
    return html_page.verdict(kind, evaluation.verdict.capitalize())


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
    return html_page.facts(rows)


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
    return "<h2>Certificate</h2>" + html_page.sentences([told]) + html_page.table(head, rows)


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
    return "<h2>Points</h2>" + html_page.table(head, rows, bad)


def _numbers(value):
    if hasattr(value, "__len__"):
        return ", ".join("%.6f" % float(each) for each in value)
    return "%.5f" % value
