"""The ground round a floor, divided between those of its sides that have walls and the others.

Ground belongs to the side that is nearest. What lies outside a convex corner is as near to both
its sides; it belongs to the wall.
"""

import math

import numpy
import Part

from evenload import compiled
from evenload.geometry.floor import edge_points, faces_within, inside, wire_of
from evenload.planar import flattened

SMOOTH = 1e-6  # rad: less is no corner
TINY = 1e-30  # mm2: keeps the direction of a mere point from being a division by nothing
AS_NEAR = 1e-6  # mm: less is no difference between two distances
OVER = 1.01  # share: lines that divide end beyond what they divide
LONGEST = 10.0  # times the ground's width: such a line into an acute notch, whose end is filled
SCANS, PER_WIDTH = 16, 4  # lines across a piece of ground, and places looked at on each


def beside_bare(floor, walled, distance):
    """Faces, at the floor's height, of the ground within `distance` mm of a floor's outer chain
    that belongs to those of its pieces which are not `walled`, a truth value each. The floor's
    islands do not matter. The chain goes counter-clockwise.

    Ground that lines from the ends of walls leave in one piece is not divided further: it belongs
    to the sides to which the greater part of it is nearer.
    """
    border = [wire_of(chain, floor.z) for chain in around(floor, distance)]
    ring = faces_within([*border, wire_of(floor.outer, floor.z)])
    lines = _dividing_lines(floor, walled, distance)
    if not lines:
        return [] if all(walled) else ring
    nearest = _Nearest(floor.outer, walled)
    return [face for face in split(ring, lines) if nearest.is_bare(face)]


def around(floor, distance):
    """The chains that bound a floor and all the ground within `distance` mm of it. The floor's
    islands do not matter.
    """
    core = compiled.core()
    grown = core.offset([core.Region(floor.outer, [])], distance)
    return [list(chain) for region in grown for chain in [region.outer, *region.islands]]


def split(faces, edges):
    """The faces that the edges divide others into. Edges take much less time than faces would."""
    result = []
    for face in faces:
        near = [edge for edge in edges if edge.BoundBox.intersect(face.BoundBox)]
        # FreeCAD names no pieces of a face that stays whole.
        pieces = (face.generalFuse(near)[1][0] if near else []) or [face]
        result += [each for piece in pieces for each in piece.Faces]
    return [_without_loose_edges(face) for face in result]


def _without_loose_edges(face):
    """A face without edges within it that divide nothing."""
    if not any(edge.Orientation == "Internal" for edge in face.Edges):
        return face
    wires = [w for w in face.Wires if all(e.Orientation != "Internal" for e in w.Edges)]
    return faces_within(wires)[0]


def border_of(face):
    """(starts, ends) of chords of a face's edges, in no order."""
    points = [edge_points(edge) for edge in face.Edges]
    return numpy.vstack([p[:-1] for p in points]), numpy.vstack([p[1:] for p in points])


def middle(face):
    """(x, y) within a level face: of some places, that which is farthest away from its edges."""
    starts, ends = border_of(face)
    places = [at for _, at in _samples(face, 1)]
    return max(places, key=lambda at: _distances(starts, ends, numpy.array(at)).min())


def _samples(face, per_width):
    """[(width in mm, (x, y))] of places within a level face along lines across it; per_width: how
    many of them share each width that the face has there.
    """
    border, box, result = border_of(face), face.BoundBox, []
    for k in range(SCANS):
        y = box.YMin + (k + 0.5) / SCANS * box.YLength
        ends = numpy.sort(_crossings(*border, y))
        for start, end in zip(ends[::2], ends[1::2]):
            width = (end - start) / per_width
            result += [(width, (start + (n + 0.5) * width, y)) for n in range(per_width)]
    return result


def _crossings(starts, ends, y):
    """mm: where lines cross one along x."""
    (x0, y0), (x1, y1) = starts.T, ends.T
    at = (y0 > y) != (y1 > y)
    return x0[at] + (x1 - x0)[at] * (y - y0[at]) / (y1 - y0)[at]


def _directions(chain, i):
    """rad: of piece i of a chain at its start and its end."""
    (x0, y0, bulge, *_), (x1, y1, *_) = chain[i], chain[(i + 1) % len(chain)]
    along, half = math.atan2(y1 - y0, x1 - x0), 2 * math.atan(bulge)
    return along - half, along + half


def _dividing_lines(floor, walled, distance):
    """Edges from where walls begin and end: at a convex corner along the normal of the side
    without a wall, at a concave one half way between both sides.
    """
    chain, lines = floor.outer, []
    for i, is_walled in enumerate(walled):
        if is_walled == walled[i - 1]:
            continue
        before, after = _directions(chain, i - 1)[1], _directions(chain, i)[0]
        turn = math.remainder(after - before, 2 * math.pi)
        length = OVER * distance
        if turn > -SMOOTH:
            along = before if is_walled else after
        else:
            along = before + 0.5 * turn
            length *= min(LONGEST, 1 / max(math.cos(0.5 * turn), 1 / LONGEST))
        x, y = chain[i][:2]
        end = (x + length * math.sin(along), y - length * math.cos(along), floor.z)
        lines.append(Part.makeLine((x, y, floor.z), end))
    return lines


class _Nearest:
    """Tells which of a chain's sides points are nearest to."""

    def __init__(self, chain, walled):
        self.start, self.end, self.walled = _segments(chain, walled)

    def is_bare(self, face):
        """Whether more of a face is nearer to sides without a wall."""
        samples = _samples(face, PER_WIDTH)
        widths = numpy.array([width for width, _ in samples])
        bare = numpy.array([self._is_bare_at(numpy.array(at)) for _, at in samples])
        return bool(widths[bare].sum() > 0.5 * widths.sum())

    def _is_bare_at(self, point):
        away = self._distances(point)
        walls = away[self.walled].min(initial=math.inf)
        return away[~self.walled].min(initial=math.inf) < walls - AS_NEAR

    def distance(self, point):
        """mm from the chain to a point."""
        return float(self._distances(point).min())

    def _distances(self, point):
        return _distances(self.start, self.end, point)


def _distances(starts, ends, point):
    """mm from a point to lines, some of which may be mere points."""
    along = ends - starts
    length2 = numpy.maximum((along**2).sum(axis=1), TINY)
    share = numpy.clip(((point - starts) * along).sum(axis=1) / length2, 0, 1)
    return numpy.linalg.norm(starts + share[:, None] * along - point, axis=1)


def _segments(chain, walled):
    """(starts, ends, whether walled) of the chords of a chain's pieces."""
    starts, ends, kinds = [], [], []
    for i, is_walled in enumerate(walled):
        piece, after = chain[i], chain[(i + 1) % len(chain)]
        # As a chain of two pieces, of which the second leads straight back.
        points = flattened([piece, (*after[:2], 0.0)])
        starts.append(points[:-1])
        ends.append(points[1:])
        kinds.append(numpy.full(len(points) - 1, bool(is_walled)))
    return numpy.vstack(starts), numpy.vstack(ends), numpy.concatenate(kinds)


def farthest(points, chains):
    """mm from floors' outer chains to that of the points (x, y) which is farthest away from the
    nearest of them, outside; 0 for none.
    """
    points = numpy.asarray(points, float).reshape(-1, 2)
    away = numpy.full(len(points), math.inf)
    for chain in chains:
        nearest = _Nearest(chain, [False] * len(chain))
        own = numpy.array([nearest.distance(point) for point in points])
        own[inside(points, [flattened(chain)])] = 0.0
        away = numpy.minimum(away, own)
    return float(away.max(initial=0.0)) if chains else 0.0


def nearest_distance(points, chain):
    """mm from a chain to the nearest of some points (x, y)."""
    nearest = _Nearest(chain, [False] * len(chain))
    return min((nearest.distance(numpy.asarray(point)) for point in points), default=math.inf)
