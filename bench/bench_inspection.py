# Inspection: what minimum zones and profiles cost on one core, and how exact they are where the
# optimum is known by construction.
import sys
import time
from pathlib import Path

import FreeCAD
import numpy
from evenload import face_inspection, inspection

TESTS = Path(__file__).resolve().parents[1] / "tests"
sys.path[:0] = [str(TESTS / "python"), str(TESTS / "freecad")]
import inspected  # noqa: E402
import inspection_cases  # noqa: E402

KNOWN = 200  # sets of each kind


def measured(kind, count):
    """`count` points on a feature of 20 mm, with a scatter of 10 um."""
    random = numpy.random.default_rng(0)
    turn, along = random.uniform(0, 2 * numpy.pi, count), random.uniform(-40, 40, count)
    away = random.normal(0, 0.01, count)
    if kind == "line":
        return numpy.stack([along, random.normal(0, 0.01, count), away], axis=1)
    if kind == "plane":
        return numpy.stack([along, 10 * turn, away], axis=1)
    if kind == "sphere":
        return (20 + away)[:, None] * inspection_cases.unit(random.normal(size=(count, 3)))
    ring = numpy.stack([numpy.cos(turn), numpy.sin(turn)], axis=1) * (20 + away)[:, None]
    return ring if kind == "circle" else numpy.column_stack([ring, along])


def times():
    for count in (10_000, 1_000_000):
        for kind in ("line", "plane", "circle", "sphere", "cylinder"):
            points = measured(kind, count)
            start = time.process_time()
            found = inspection.fit(points, kind)
            name = "inspection.%s.%d_points" % (kind, count)
            yield name, time.process_time() - start, "s"
            yield name + ".proved", float(found.is_proved), ""
    part = inspection.test_part("CX")
    feet, normals = part.at(inspected.X, inspected.Y)
    away = numpy.random.default_rng(1).normal(0, 0.01, len(feet))
    points = feet + away[:, None] * normals
    start = time.process_time()
    exact = inspection.profile(points, part)
    yield "inspection.profile.441_points", time.process_time() - start, "s"
    yield from on_faces(points, exact)


def on_faces(points, exact):
    """The same against FreeCAD's faces, as they are and as splines; exact: the Profile of them."""
    doc, solid = FreeCAD.newDocument("Dome"), inspected.dome(inspection.test_part("CX"))
    measured = inspected.as_measured(points)
    for name, shape in (("faces", solid), ("splines", solid.toNurbs())):
        faces = inspected.faces_of(doc, shape, inspected.upper_faces(solid))
        start = time.process_time()
        found = face_inspection.evaluate(faces, measured)
        name = "inspection.profile.441_points_on_" + name
        yield name, time.process_time() - start, "s"
        yield name + ".width_error", abs(found.zone - exact.width), "mm"
    FreeCAD.closeDocument(doc.Name)


def errors():
    for kind in inspection_cases.KINDS:
        random = numpy.random.default_rng(9)
        worst, proved = 0.0, 0
        for _ in range(KNOWN):
            points, zone = inspection_cases.known(kind, random, 1e-3)
            found = inspection.fit(points, kind.split()[-1])
            worst = max(worst, abs(found.zone / zone - 1))
            proved += found.is_proved
        name = "inspection.%s" % kind.replace(" ", "_")
        yield name + ".zone_error", worst, ""
        yield name + ".proved", 100 * proved / KNOWN, "%"


def figures():
    yield from times()
    yield from errors()


# What is required, by the end of a figure's name.
REQUIRED = {"10000_points": "0.1 s", "1000000_points": "3 s", "zone_error": "1e-9"}


def table(values):
    yield "inspection, beside what is required"
    for name, value in values.items():
        if name.startswith("inspection."):
            ends = [text for end, text in REQUIRED.items() if name.endswith("." + end)]
            yield "  %-44s %12.4g   %s" % (name, value, *(ends or [""]))
