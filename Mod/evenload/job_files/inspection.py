"""The section `inspection` of a job: points to measure on faces, and what measured points say."""

import os

from evenload import face_inspection, inspection
from evenload.face_inspection.probing_program import Probe, probing_program
from evenload.job_files import outputs, report
from evenload.job_files.keys import PROBE_KEYS, check_keys

OF_SAMPLES = ("csv", "dmis", "picture", "probing")  # outputs that need points to measure
OF_MEASURED = ("map", "report")  # and those that need measured points
NEED_MEASURED = (*OF_MEASURED, "ball_radius", "points_of", "feature", "free", "datum", "tolerance")
POINTS_OF = ("file", "faces")
NEED_SAMPLES = ("points", "pattern", "spacing", "margin")


def check(wishes, number):
    """Raises ValueError, in a sentence, for a section whose keys do not belong together; None for
    no section.
    """
    if wishes is None:
        return
    where = "Job %d, inspection" % number
    check_keys(wishes.get("probe", {}), PROBE_KEYS, where + ", probe")
    samples = [key for key in OF_SAMPLES if key in wishes]
    if not samples and "measured" not in wishes:
        raise ValueError(
            "%s: nothing is asked: name %s, or the file of points 'measured'."
            % (where, ", ".join("'%s'" % key for key in OF_SAMPLES))
        )
    if wishes.get("points_of", "file") not in POINTS_OF:
        raise ValueError(
            "%s: 'points_of' is %s, not '%s'."
            % (where, " or ".join("'%s'" % each for each in POINTS_OF), wishes["points_of"])
        )
    for needing, is_there, remedy in (
        (NEED_MEASURED, "measured" in wishes, "'measured'"),
        (NEED_SAMPLES, bool(samples), "'csv', 'dmis', 'picture' or 'probing'"),
        (("probe",), "probing" in wishes, "'probing'"),
    ):
        idle = [key for key in needing if key in wishes]
        if idle and not is_there:
            raise ValueError("%s: '%s' needs %s beside it." % (where, idle[0], remedy))


def inputs(wishes):
    """{what it is: name} of the files that a section reads."""
    return {"its measured points": wishes["measured"]} if "measured" in wishes else {}


def files(wishes, number):
    """{key: (name, what it is, for sentences)} of the section's outputs."""
    return {
        "inspection_" + key: (wishes[key], "Job %d, inspection: the %s" % (number, key))
        for key in (*OF_SAMPLES, *OF_MEASURED)
        if key in wishes
    }


def of(wishes, base_of, posting, folder):
    """(figures, {key of files(): function that writes it into a file}) of a checked section.

    base_of: gives base geometry for names; posting: (post-processor, arguments).
    Raises ValueError, in a sentence, for what cannot be measured or evaluated.
    """
    faces = face_inspection.picked(base_of(wishes["faces"]))
    figures, writing = {}, {}
    if any(key in wishes for key in OF_SAMPLES):
        writing.update(_samples(wishes, faces, posting))
    if "measured" in wishes:
        figures, of_measured = _evaluation(wishes, faces, base_of, folder)
        writing.update(of_measured)
    return figures, writing


def _samples(wishes, faces, posting):
    named = {"points": "count"}
    options = {named.get(key, key): wishes[key] for key in NEED_SAMPLES if key in wishes}
    samples = face_inspection.sample(faces, **options)
    # Before anything is written: not all points can be probed from above.
    program = None
    if "probing" in wishes:
        probe = Probe(**wishes.get("probe", {}))
        program = probing_program(faces, samples, probe, *posting)

    def draw(path):
        # Here, because a job without pictures needs no matplotlib.
        from evenload.face_inspection import picture

        picture.save_samples(faces, samples, path)

    points = samples.points, samples.normals
    return {
        "inspection_csv": lambda path: inspection.write_csv(path, *points, "mm"),
        "inspection_dmis": lambda path: inspection.write_dmis(path, *points, "mm"),
        "inspection_picture": draw,
        "inspection_probing": lambda path: outputs.write(path, program),
    }


def _evaluation(wishes, faces, base_of, folder):
    source = os.path.join(folder, wishes["measured"])
    measured = face_inspection.read_points(source, wishes.get("ball_radius", 0.0))
    datum = None
    if "datum" in wishes:
        datum = face_inspection.datum_of(face_inspection.picked(base_of([wishes["datum"]])))
    found = face_inspection.evaluate(
        *(faces, measured, wishes.get("feature", "profile"), wishes.get("tolerance")),
        *(wishes.get("free"), datum, wishes.get("points_of", "file") == "file"),
    )

    def draw(path):
        # Here, because a job without pictures needs no matplotlib.
        from evenload.face_inspection import picture

        picture.save_map(found, path)

    def write_report(path):
        # Here, because its picture needs matplotlib.
        from evenload.face_inspection import html_report

        html_report.write_report(found, path, os.path.basename(source))

    return report.inspected(found), {"inspection_map": draw, "inspection_report": write_report}
