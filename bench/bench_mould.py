# Finishing on real faces: a mould-like part of about 200 faces, 300 x 200 mm, and the source's test
# parts by each strategy; judged by the parts' own faces.
import itertools
import sys
import time
from pathlib import Path

import finishing_judge as judge
import FreeCAD
import mould_part
import numpy
from evenload import host
from evenload.geometry import facets
from evenload.operations import finishing
from evenload.settings.table import BETWEEN_GUIDES, FINISHING

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "freecad"))
import finishing_parts  # noqa: E402

STRATEGIES = next(row.value for row in FINISHING if row.name == "Strategy")
BALL, STEPOVER, TOLERANCE = 10.0, 0.5, 0.01  # mm
LEAST_UP = 0.02  # z of the normals of faces that are finished: walls with draft are among them
PLACES, PER_FACE = 10000, 60
# Figures in the table: name, meaning, form.
ROWS = [
    ("picked_faces", "faces that are finished", "{:.0f}"),
    ("total", "operation recomputed, all in all", "{:.1f} s"),
    ("total_of_cores", "the same, as work of all cores", "{:.1f} s"),
    ("triangulation", "of it, triangles of the part", "{:.1f} s"),
    ("triangles", "triangles", "{:.0f}"),
    ("triangles_off", "by which these leave the part", "{:.2f} µm"),
    ("path_length", "path in cut", "{:.1f} m"),
    ("largest_gouge", "deepest gouge at 10 000 places", "{:.2f} µm"),
    ("places_in_reach", "places within the ball's reach", "{:.0f}"),
    ("places_left", "of these, where more is left than passes leave", "{:.0f}"),
    ("most_left_of_allowed", "the most that is left, of what passes may leave", "{:.1f} %"),
]


class Job:
    """A job on a shape, with a finishing operation on its upper faces that a ball end mill does."""

    def __init__(self, shape, names, **settings):
        self.doc = FreeCAD.newDocument("Bench")
        part = self.doc.addObject("Part::Feature", "Part")
        part.Shape = shape
        self.doc.recompute()
        job, controller = host.create_job(self.doc, [part], BALL, 1650, 5100, 4)
        controller.Tool = host.create_tool("ballend", {"Diameter": BALL})
        self.doc.recompute()
        self.models = job.Model.Group
        self.faces = [(self.models[0], tuple(names))]
        self.op = finishing.Create("Finish", parentJob=job, toolController=controller)
        self.op.Base = self.faces
        for name, value in {"Tolerance": TOLERANCE, "LeadRadius": 0.0, **settings}.items():
            setattr(self.op, name, value)

    def computed(self):
        """(what the operation computed, seconds of recomputing the operation, those of all cores
        that it worked, which other programs do not lengthen much)
        """
        start, work = time.perf_counter(), time.process_time()
        self.op.touch()
        self.doc.recompute()
        seconds, work = time.perf_counter() - start, time.process_time() - work
        if not self.op.isValid():
            raise ValueError(self.op.Report)
        return self.op.Proxy.last, seconds, work

    def close(self):
        FreeCAD.closeDocument(self.doc.Name)


def mould():
    shape = mould_part.part()
    names = finishing_parts.upper(shape, LEAST_UP)
    yield "mould.faces", len(shape.Faces), ""
    yield "mould.picked_faces", len(names), ""
    job = Job(shape, names, Stepover=STEPOVER)
    start = time.perf_counter()
    found = facets.of(job.faces, job.models, TOLERANCE)
    yield "mould.triangulation", time.perf_counter() - start, "s"
    yield "mould.triangles", len(found.mesh), ""
    yield "mould.triangles_off", 1000 * found.deflection, "um"
    done, seconds, work = job.computed()
    yield "mould.total", seconds, "s"
    yield "mould.total_of_cores", work, "s"
    job.close()
    starts, ends = judge.cuts(done.toolpath)
    yield "mould.path_length", numpy.linalg.norm(ends - starts, axis=1).sum() / 1000, "m"
    tips = judge.places(starts, ends, PLACES)
    yield "mould.largest_gouge", 1000 * judge.gouges(shape, BALL / 2, tips).max(), "um"
    points, normals = judge.samples(shape, names, PER_FACE)
    is_in_reach = judge.reachable(shape, BALL / 2, points, normals, TOLERANCE)
    points, normals = points[is_in_reach], normals[is_in_reach]
    yield "mould.places_in_reach", len(points), ""
    left = judge.left_at(points, BALL / 2, starts, ends)
    allowed = judge.left_between(found.mesh, points, normals, BALL / 2, STEPOVER) + TOLERANCE
    yield "mould.places_left", int((left > allowed).sum()), ""
    yield "mould.most_left_of_allowed", 100 * (left / allowed).max(), "%"


def rims(shape):
    """The names of the two upper edges along x at the ends of a test part."""
    for y in (-finishing_parts.HALF, finishing_parts.HALF):
        at_end = {
            "Edge%d" % number: edge.BoundBox.ZMax
            for number, edge in enumerate(shape.Edges, 1)
            if all(abs(vertex.Y - y) < 1e-6 for vertex in edge.Vertexes)
            and edge.BoundBox.ZLength < 1e-6
        }
        yield max(at_end, key=at_end.get)


def test_parts():
    """Each strategy on both of the source's test parts."""
    for is_convex, strategy in itertools.product((True, False), STRATEGIES):
        shape = finishing_parts.part(is_convex)
        job = Job(shape, finishing_parts.upper(shape), Strategy=strategy, Stepover=1.0)
        if strategy in BETWEEN_GUIDES:
            job.op.Base = [*job.faces, *((job.models[0], [edge]) for edge in rims(shape))]
        done, *_ = job.computed()
        job.close()
        tips = judge.places(*judge.cuts(done.toolpath), PLACES)
        deep = judge.gouges(shape, BALL / 2, tips)
        part = "CX" if is_convex else "CV"
        yield _figure(part, strategy, "largest"), 1000 * deep.max(), "um"
        beyond = int((deep > TOLERANCE).sum())
        yield _figure(part, strategy, "beyond_tolerance"), beyond, ""


def figures():
    yield from mould()
    yield from test_parts()


def table(values):
    """The tables of docs/finishing.md."""
    yield "| the mould-like part | measured |"
    yield "|---|---|"
    for name, meaning, form in ROWS:
        yield "| %s | %s |" % (meaning, form.format(values["mould.%s" % name]))
    yield ""
    yield "| deepest gouge at 10 000 places | CX | CV |"
    yield "|---|---|---|"
    for strategy in STRATEGIES:
        deepest = [values[_figure(part, strategy, "largest")] for part in ("CX", "CV")]
        yield "| %s | %.2f µm | %.2f µm |" % (strategy, *deepest)


def _figure(part, strategy, name):
    return "gouges.%s.%s.%s" % (part, strategy.lower().replace(" ", "_"), name)
