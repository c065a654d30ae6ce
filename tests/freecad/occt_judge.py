"""A judge of paths by OpenCASCADE's booleans: the tool's swept body against models and stock.

It shares nothing with the addon: commands are followed here, swept bodies are solids. Slow, so of
the moves that come near what they must not touch only each EVERY-th is put to it, and all those
that points of the models' edges find too near.
"""

import math

import numpy
import Part
from FreeCAD import Vector

GOUGE = 0.005  # mm beyond the tolerance
TOUCH = 0.02  # mm: the rim of a tool may touch what stands
LEAST = 1e-4  # mm3: less is rounding of the booleans
HIGH = 1000.0  # mm: tools reach as far up
FLAT = 1e-6  # mm
NEAR = 0.06  # mm: moves that stay further away from points of a model touch none of it
SUSPECT = 0.002  # mm: moves that come nearer than is allowed, or miss it by so little
DENSE = 0.1  # mm between these points
EVERY = 8


class Move:
    """A move from `start` to `end`, with the centre and the sweep of an arc."""

    def __init__(self, name, start, end, centre=None, sweep=0.0):
        self.is_rapid = name == "G0"
        self.start, self.end, self.centre, self.sweep = start, end, centre, sweep
        self.low = min(start.z, end.z)

    def point(self, t):
        if self.centre is None:
            return self.start + (self.end - self.start) * t
        arm = self.start - self.centre
        turn = self.sweep * t
        return Vector(
            self.centre.x + arm.x * math.cos(turn) - arm.y * math.sin(turn),
            self.centre.y + arm.x * math.sin(turn) + arm.y * math.cos(turn),
            self.start.z + t * (self.end.z - self.start.z),
        )

    def length(self):
        flat = math.hypot(self.end.x - self.start.x, self.end.y - self.start.y)
        if self.centre is not None:
            radius = math.hypot(self.start.x - self.centre.x, self.start.y - self.centre.y)
            flat = abs(self.sweep) * radius
        return flat

    def is_level(self):
        return abs(self.start.z - self.end.z) < FLAT


def moves_of(commands):
    """The moves of FreeCAD's Path commands from where x, y and z are known on."""
    at, moves = {}, []
    for command in commands:
        p = command.Parameters
        if command.Name not in ("G0", "G1", "G2", "G3"):
            continue
        before = dict(at)
        at.update({k: v for k, v in p.items() if k in "XYZ"})
        if len(before) < 3:
            continue
        start = Vector(before["X"], before["Y"], before["Z"])
        end = Vector(at["X"], at["Y"], at["Z"])
        centre, sweep = None, 0.0
        if command.Name in ("G2", "G3"):
            centre = Vector(start.x + p["I"], start.y + p["J"], 0)
            first = math.atan2(start.y - centre.y, start.x - centre.x)
            last = math.atan2(end.y - centre.y, end.x - centre.x)
            sweep = (last - first) % (2 * math.pi) or 2 * math.pi
            if command.Name == "G2":
                sweep = -((first - last) % (2 * math.pi) or 2 * math.pi)
        if (end - start).Length > FLAT or centre is not None:
            moves.append(Move(command.Name, start, end, centre, sweep))
    return moves


def swept(move, radius, raised=0.0):
    """The solids that a flat tool sweeps along a move, at the lower of its ends."""
    z = move.low + raised
    discs = [Part.makeCylinder(radius, HIGH, Vector(p.x, p.y, z)) for p in (move.start, move.end)]
    length = move.length()
    if length < FLAT:
        return discs[:1]
    if move.centre is None:
        along = Vector(move.end.x - move.start.x, move.end.y - move.start.y, 0) / length
        side = Vector(-along.y, along.x, 0) * radius
        a, b = Vector(move.start.x, move.start.y, z), Vector(move.end.x, move.end.y, z)
        face = Part.Face(Part.makePolygon([a - side, b - side, b + side, a + side, a - side]))
        return [*discs, face.extrude(Vector(0, 0, HIGH))]
    arm = math.hypot(move.start.x - move.centre.x, move.start.y - move.centre.y)
    first = math.degrees(math.atan2(move.start.y - move.centre.y, move.start.x - move.centre.x))
    if move.sweep < 0:
        first += math.degrees(move.sweep)
    base = Vector(move.centre.x, move.centre.y, z)
    degrees = math.degrees(abs(move.sweep))
    band = Part.makeCylinder(arm + radius, HIGH, base, Vector(0, 0, 1), degrees)
    band.rotate(base, Vector(0, 0, 1), first)
    if arm > radius + FLAT:
        inner = Part.makeCylinder(arm - radius, HIGH, base)
        band = band.cut(inner)
    return [*discs, band]


def gouges(moves, models, radius, tolerance):
    """[(mm3, move), ...] of moves that cut deeper into a model than is allowed."""
    allowed = GOUGE + tolerance
    found, near = [], 0
    for model in models:
        points = _surface(model)
        for move in moves:
            if move.low + allowed >= model.BoundBox.ZMax:
                continue
            away = _distance(move, points) - radius
            near += away < NEAR
            if away > NEAR or (away > SUSPECT - allowed and near % EVERY):
                continue
            if not move.is_level() and move.length() > FLAT:
                continue  # helices and ramps go where a level turn goes after them, at its depth
            cut = [solid.common(model) for solid in swept(move, radius - allowed, allowed)]
            volume = sum(shape.Volume for shape in _solid(cut))
            if volume > LEAST:
                found.append((volume, move))
    return found


def _surface(shape):
    """Points of a shape's edges and faces, n x 3, dense enough to tell what is near."""
    points = [p for edge in shape.Edges if not edge.Degenerated for p in _along(edge)]
    vertices, _ = shape.tessellate(0.05)
    points += vertices
    return numpy.array([tuple(p) for p in points])


def _along(edge):
    return edge.discretize(Number=max(2, math.ceil(edge.Length / DENSE) + 1))


def _distance(move, points):
    """mm from a move to the nearest of the points that lie higher, seen from above."""
    high = points[points[:, 2] > move.low + FLAT]
    if not len(high):
        return math.inf
    if move.centre is None:
        return float(_from_line(move, high[:, :2]).min())
    count = max(2, math.ceil(move.length() / DENSE) + 1)
    places = numpy.array([tuple(move.point(k / (count - 1)))[:2] for k in range(count)])
    reach = numpy.hypot(*(high[:, :2] - places[0]).T) < move.length() + 20
    away = numpy.hypot(*(high[reach, None, :2] - places[None]).transpose(2, 0, 1))
    return float(away.min(initial=math.inf))


def _from_line(move, points):
    """mm from each of the points, n x 2, to a straight move, seen from above."""
    along = numpy.array([move.end.x - move.start.x, move.end.y - move.start.y])
    arms = points - (move.start.x, move.start.y)
    share = numpy.clip(arms @ along / max(along @ along, FLAT**2), 0, 1)
    return numpy.hypot(*(arms - share[:, None] * along).T)


def collisions(moves, stock, radius, earlier=()):
    """[(mm3, move), ...] of rapids and straight plunges that meet what stands of the stock.

    earlier: [(moves, radius), ...] of what has been cut before.
    """
    found = []
    cut = [(move, r) for path, r in earlier for move in path]
    for move in moves:
        plunges = move.length() < FLAT and move.end.z < move.start.z - FLAT
        if (move.is_rapid or plunges) and move.low < stock.BoundBox.ZMax - TOUCH:
            left = _standing(move, stock, radius - TOUCH, cut)
            if left > LEAST:
                found.append((left, move))
        cut.append((move, radius))
    return found


def _standing(move, stock, radius, cut):
    """mm3 of the stock in the way of a move after what has been cut."""
    left = _solid([solid.common(stock) for solid in swept(move, radius, TOUCH)])
    if not left:
        return 0.0
    box = left[0].BoundBox
    for solid in left[1:]:
        box.add(solid.BoundBox)
    waiting = [
        (before, r)
        for before, r in cut
        if not before.is_rapid
        and (before.is_level() or before.length() < FLAT)
        and before.low <= move.low + TOUCH  # what a higher cut leaves is still in the way
        and _may_meet(before, r, box)
    ]
    while left:
        # The move that clears most of the corners of what is left comes first, or thousands of
        # slivers would have to be cut. What no move clears a corner of stands.
        corners = numpy.array([tuple(p)[:2] for solid in left for p in solid.tessellate(0.05)[0]])
        cleared = [_cleared(before, r, corners) for before, r in waiting]
        if max(cleared, default=0) == 0:
            return sum(solid.Volume for solid in left)
        for solid in swept(*waiting.pop(cleared.index(max(cleared)))):
            left = _solid([each.cut(solid) for each in left])
    return 0.0


def _solid(shapes):
    """The shapes but those of which booleans have left nothing, or what rounding leaves."""
    return [shape for shape in shapes if not shape.isNull() and shape.Volume > LEAST]


def _cleared(move, radius, points):
    """How many of the points, n x 2, a move clears, seen from above."""
    if move.centre is None:
        return int((_from_line(move, points) < radius - FLAT).sum())
    arms = points - (move.centre.x, move.centre.y)
    first = math.atan2(move.start.y - move.centre.y, move.start.x - move.centre.x)
    turn = (numpy.arctan2(arms[:, 1], arms[:, 0]) - first) * math.copysign(1, move.sweep)
    arm = math.hypot(move.start.x - move.centre.x, move.start.y - move.centre.y)
    away = numpy.abs(numpy.hypot(*arms.T) - arm)
    away[turn % (2 * math.pi) > abs(move.sweep)] = math.inf
    for end in (move.start, move.end):
        away = numpy.minimum(away, numpy.hypot(*(points - (end.x, end.y)).T))
    return int((away < radius - FLAT).sum())


def _may_meet(move, radius, box):
    count = max(2, math.ceil(move.length()) + 1)
    points = [move.point(k / (count - 1)) for k in range(count)]
    reach = radius + 1.0
    return (
        min(p.x for p in points) - reach < box.XMax
        and max(p.x for p in points) + reach > box.XMin
        and min(p.y for p in points) - reach < box.YMax
        and max(p.y for p in points) + reach > box.YMin
    )
