# Finishing paths judged by the part's own faces, not by triangles: how deep the ball cuts into
# them, and whether it reaches each of their places.
import math
import random

import FreeCAD
import numpy
import Part
from evenload import compiled
from evenload.planar import CUT, as_lines

AROUND = (-1, 0, 1)
LONGEST = 2.0  # mm, of the pieces in which a path is looked through
SLACK = 0.01  # mm beyond the ball in which faces are looked for
PHASES = 60  # ways in which two passes may run beside a place
FLOOR = -1000.0  # mm, below all parts


class Judge:
    """Distances from a shape, by those of its faces that are near."""

    def __init__(self, shape, radius):
        self._shape, self._radius = shape, radius
        self._faces = shape.Faces
        boxes = [face.BoundBox for face in self._faces]
        self._low = numpy.array([(b.XMin, b.YMin, b.ZMin) for b in boxes])
        self._high = numpy.array([(b.XMax, b.YMax, b.ZMax) for b in boxes])

    def gouge(self, centre):
        """mm by which a ball about a centre cuts into the shape; not below -SLACK, and infinite for
        one that is all within it.
        """
        beyond = numpy.maximum(self._low - centre, centre - self._high)
        away = numpy.linalg.norm(numpy.maximum(beyond, 0), axis=1)
        deepest, at = -SLACK, Part.Vertex(*centre)
        for number in numpy.argsort(away):
            if away[number] > self._radius - deepest:
                break
            off = self._faces[number].distToShape(at)[0]
            deepest = max(deepest, self._radius - off)
        is_within = deepest == -SLACK and self._shape.isInside(FreeCAD.Vector(*centre), 1e-6, True)
        return math.inf if is_within else deepest


def cuts(toolpath):
    """(starts, ends), n x 3 each, of the cuts of a Toolpath of the core's; chords stand for arcs,
    which they leave by 2 um at the most.
    """
    rows = as_lines(toolpath.moves)
    is_cut = rows[1:, 0] == CUT
    return rows[:-1, 1:4][is_cut], rows[1:, 1:4][is_cut]


def places(starts, ends, count, seed=1):
    """count x 3 random places on segments, even over their length."""
    source = numpy.random.default_rng(seed)
    lengths = numpy.linalg.norm(ends - starts, axis=1)
    chosen = source.choice(len(starts), count, p=lengths / lengths.sum())
    return starts[chosen] + source.random((count, 1)) * (ends - starts)[chosen]


def gouges(shape, radius, tips):
    """mm, n of them: how deep a ball cuts into a shape at places of its tip."""
    judge = Judge(shape, radius)
    return numpy.array([judge.gouge(tip + (0, 0, radius)) for tip in tips])


def samples(shape, names, count, seed=2):
    """(points, normals out of the part): on each named face about `count` random places, even over
    its parameters.
    """
    source, found = random.Random(seed), []
    for name in names:
        face = shape.getElement(name)
        u0, u1, v0, v1 = face.ParameterRange
        for _ in range(count):
            u, v = source.uniform(u0, u1), source.uniform(v0, v1)
            if face.isPartOfDomain(u, v):
                found.append((*face.valueAt(u, v), *face.normalAt(u, v)))
    rows = numpy.array(found)
    return rows[:, :3], rows[:, 3:]


def reachable(shape, radius, points, normals, tolerance):
    """Which of the places a ball touches without cutting into the shape; from above all it can."""
    judge = Judge(shape, radius)
    return numpy.array(
        [
            normal[2] > 0 and judge.gouge(point + radius * normal) < tolerance
            for point, normal in zip(points, normals)
        ]
    )


def left_at(points, radius, starts, ends):
    """mm that the ball leaves over each point, its tip along segments; infinite far off them."""
    counts = numpy.maximum(1, numpy.ceil(numpy.linalg.norm(ends - starts, axis=1) / LONGEST))
    number = numpy.repeat(numpy.arange(len(starts)), counts.astype(int))
    firsts = numpy.cumsum(counts) - counts
    share = (numpy.arange(len(number)) - firsts[number]) / counts[number]
    steps = (ends - starts)[number]
    begin = starts[number] + share[:, None] * steps + (0, 0, radius)
    step = steps / counts[number][:, None]
    cells = {}
    size = radius + LONGEST
    for row, key in enumerate(map(tuple, numpy.floor(begin[:, :2] / size).astype(int))):
        cells.setdefault(key, []).append(row)
    found = numpy.full(len(points), math.inf)
    for row, point in enumerate(points):
        x, y = numpy.floor(point[:2] / size).astype(int)
        near = [k for i in AROUND for j in AROUND for k in cells.get((x + i, y + j), ())]
        if near:
            found[row] = _distance(point, begin[near], step[near]) - radius
    return found


def _distance(point, begin, step):
    """Of a point from the nearest of some segments."""
    along = ((point - begin) * step).sum(axis=1) / numpy.maximum((step**2).sum(axis=1), 1e-18)
    at = begin + numpy.clip(along, 0, 1)[:, None] * step
    return math.sqrt(((point - at) ** 2).sum(axis=1).min())


def left_between(mesh, points, normals, radius, stepover):
    """mm that passes along x, a stepover apart in plan, may leave at places, wherever they run: by
    how low the ball can go beside each place.
    """
    count = 2 * PHASES + 1
    beside = stepover * numpy.linspace(-1, 1, count)
    centres = numpy.repeat(points + radius * normals, count, axis=0)
    centres[:, 1] += numpy.tile(beside, len(points))
    found = compiled.core().surface.contacts(mesh, 2 * radius, radius, centres[:, :2], FLOOR)
    centres[:, 2] = found[:, 0] + radius
    away = numpy.linalg.norm(numpy.repeat(points, count, axis=0) - centres, axis=1) - radius
    away = away.reshape(len(points), count)
    # A pass to the left, and the one a stepover to the right of it.
    return numpy.minimum(away[:, : PHASES + 1], away[:, PHASES:]).max(axis=1)
