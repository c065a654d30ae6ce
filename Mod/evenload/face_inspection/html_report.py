"""A report of an evaluation as one HTML file, with its picture in it, made to be printed.

It is in the user's language where it is made in FreeCAD's window, else in English.
"""

from evenload.face_inspection.evaluation import IN, OUT, PROFILE
from evenload.face_inspection.picture import save_map
from evenload.inspection.points import SHOWN, length_told, mm_per
from evenload.inspection.predictions import ADJUSTED_R_SQUARED, MEANINGS
from evenload.pictures import html_page
from evenload.settings.sentences import shown, shown_name
from evenload.translation import filled, translate, with_capital

ROUGHNESS = {"mm": ("µm", 1.0), "inch": ("µin", 0.0254)}  # how it is written, and its µm
CERTIFICATE = "Contact, point", "Bound", "Multiplier"  # heads of its columns
VERDICTS = {IN: "good", OUT: "bad"}


def write_report(evaluation, path, source="", unit="mm", prediction=None):
    """Writes the report of an Evaluation.

    source: the name of the file of points. unit: "mm" or "inch", of all lengths. prediction: the
    Prediction of evenload.inspection that is told beside what was measured. The same evaluation
    gives the same bytes.
    """
    html_page.write(report_of(evaluation, source, unit, prediction), path)


def report_of(evaluation, source="", unit="mm", prediction=None):
    """The report as a text."""
    parts = [
        _verdict(evaluation),
        html_page.sentences(map(shown, evaluation.told(unit))),
        _facts(evaluation, source, unit),
        html_page.heading(translate("Deviations")),
        html_page.picture(
            lambda file: save_map(evaluation, file, unit), translate("Map of the deviations")
        ),
        _certificate(evaluation),
        _prediction(evaluation, prediction, unit) if prediction is not None else "",
        _points(evaluation, unit),
    ]
    title = translate("Inspection of %s") % shown_name(evaluation.faces.name)
    return html_page.page(title, parts)


def _verdict(evaluation):
    if evaluation.verdict is None:
        return ""
    kind = VERDICTS.get(evaluation.verdict, "open")
    return html_page.verdict(kind, with_capital(translate(evaluation.verdict)))


def _facts(evaluation, source, unit):
    found, deviations = evaluation.found, evaluation.deviations
    name = SHOWN[unit][0]
    count = len(deviations)
    rows = [
        (translate("Faces"), ", ".join(map(_face, evaluation.faces.parts))),
        (translate("Points"), translate("%d, of %s") % (count, source) if source else str(count)),
        (with_capital(translate(evaluation.error)), length_told(evaluation.zone, unit, 1)),
    ]
    if evaluation.tolerance is not None:
        rows.append((translate("Tolerance"), length_told(evaluation.tolerance, unit, 1)))
    ends = _number(deviations.min(), unit, 1), _number(deviations.max(), unit, 1)
    rows.append((translate("Deviations"), translate("%s to %s %s") % (*ends, name)))
    for attribute, title in (("radius", translate("Radius")), ("point", translate("Place"))):
        value = getattr(found, attribute, None)
        if value is not None:
            rows.append((title, "%s %s" % (_lengths(value, unit), name)))
    if getattr(found, "direction", None) is not None:
        rows.append((translate("Direction"), _shares(found.direction)))
    if hasattr(found, "shift"):
        free = ", ".join(evaluation.free) or translate("none, as aligned")
        rows.append((translate("Free motions"), free))
        if evaluation.datum is not None:
            point, normal = evaluation.datum
            told = _lengths(point, unit), name, _shares(normal)
            rows.append((translate("Datum plane"), translate("through %s %s, normal %s") % told))
        shift = "%s %s" % (_lengths(found.shift, unit), name)
        rows.append((translate("Shift of the points"), shift))
        rows.append((translate("Turn of the points"), "; ".join(map(_shares, found.turn))))
    return html_page.facts(rows)


def _face(part):
    """(label of an object, a face of it) in words."""
    label, face = part
    return filled(translate("%1 of %2"), (str(face), label))


def _certificate(evaluation):
    found = evaluation.found
    names = evaluation.measured.names
    rows = [
        (names[number], translate("outer" if side > 0 else "inner"), "%.6f" % multiplier)
        for number, side, multiplier in zip(found.contacts, found.sides, found.multipliers)
    ]
    told = translate(
        "The minimum zone is proved; what is left of the forces' balance is %.1e."
        if found.is_proved
        else "The minimum zone is not proved; what is left of the forces' balance is %.1e."
    )
    head = [translate(each) for each in CERTIFICATE]
    return _section(translate("Certificate"), [told % found.imbalance], head, rows)


def _section(title, sentences, head, rows):
    """A table under its heading and sentences."""
    told = html_page.sentences(sentences)
    return html_page.heading(title) + told + html_page.table(head, rows)


def _prediction(evaluation, prediction, unit):
    """The source's regressions, beside the one that was measured."""
    measured = _measured_error(evaluation)
    rows = [
        (
            with_capital(translate(MEANINGS[name])),
            _number(error, unit),
            "%.1f %%" % (100 * ADJUSTED_R_SQUARED[name]),
            _number(evaluation.zone, unit) if name == measured else "",
        )
        for name, error in prediction.errors.items()
    ]
    name = SHOWN[unit][0]
    head = (
        translate("Form error"),
        translate("Predicted, %s") % name,
        translate("R² adjusted"),
        translate("Measured, %s") % name,
    )
    told = translate(
        "By the regressions of ten milled parts, for a %s face, passes at %g° to its axis, Rz %s."
    )
    nature = translate("convex") if prediction.nature == "CX" else translate("concave")
    sign, micrometres = ROUGHNESS[unit]
    roughness = "%.4g %s" % (prediction.rz / micrometres, sign)
    told %= (nature, round(prediction.feed_direction, 2), roughness)
    sentences = [told, *map(shown, prediction.warnings(unit))]
    return _section(translate("Prediction"), sentences, head, rows)


def _measured_error(evaluation):
    """The name of the predicted error that an evaluation measured, None where it is none."""
    if evaluation.kind == "cylinder":
        return "Cyl"
    if evaluation.kind != PROFILE:
        return None
    if not evaluation.free:
        return "SPE_A"
    return "SPE" if evaluation.datum is None else None


def _points(evaluation, unit):
    measured, beyond = evaluation.measured, evaluation.is_beyond
    rows = [
        (name, *(_number(each, unit) for each in point), _number(deviation, unit, 1, "+"))
        for name, point, deviation in zip(
            measured.names, measured.points.tolist(), evaluation.deviations
        )
    ]
    bad = set() if beyond is None else {row for row, is_bad in enumerate(beyond) if is_bad}
    name = SHOWN[unit][0]
    places = ["%s, %s" % (axis, name) for axis in "xyz"]
    head = (translate("Point"), *places, translate("Deviation, %s") % name)
    return html_page.heading(translate("Points")) + html_page.table(head, rows, bad)


def _number(length, unit, finer=0, sign=""):
    """A length in mm as a number in a unit."""
    return ("%" + sign + ".*f") % (SHOWN[unit][1] + finer, length / mm_per(unit))


def _lengths(value, unit):
    """A length, or three, in mm, as numbers in a unit."""
    if hasattr(value, "__len__"):
        return ", ".join(_number(each, unit, 2) for each in value)
    return _number(value, unit, 1)


def _shares(value):
    return ", ".join("%.6f" % float(each) for each in value)
