"""A job's stock as the simulator has it, and what must stay of it.

What must stay, the part, is taken from here:

- EvenLoad's operations say themselves what they clear: the stock outside of their floors must stay,
  and StockToLeave along its walls. Open sides of a floor have nothing beyond them. Below, a floor
  that is a face of the model must stay, and below outlines, and faces that are not cut down to
  themselves, what lies under the depth that is cut with StockToLeaveAxial on it. Whatever of the
  job's models stands above a face must stay, too. In outlines that were drawn the model does not
  matter: it may be a block without the pocket in it.
- For any other operation it is the Job's model: where it is all level and upright as it is, else as
  what stands above each level of the path. What remains between that and the stock counts as rest,
  also where another operation is meant to take it.
- An operation on geometry that is not the model's, such as a sketch, may well cut the model. As for
  a model that is no stack of sections, nothing can be said of its part then, and a note says so.
"""

import math

import Part
from FreeCAD import Vector

from evenload import compiled, host
from evenload.geometry import body
from evenload.geometry.floor import ABOVE_FLOOR
from evenload.settings.properties import is_ours
from evenload.words import listed

MOST_LEVELS = 200  # of a path at which a model that leans is looked at; roughing has fewer
SAME_LEVEL = 1e-3  # mm: moves nearer in height are at one level
LEAST_COVER = 1e-3  # mm2: less of a model over a floor is rounding
# mm: how far beyond a floor's open sides nothing must stay. More than BESIDE of open_edges, from
# where on that has seen that there is nothing, and than the tolerance of curves.
BEYOND = 0.1


def stock_of(stock):
    """(outline as [Region, ...], [(Region, top), ...] or a HeightMap, top, bottom) of a job's
    stock.
    """
    found = body.of(stock.Shape)
    top, bottom = found.box.ZMax, found.box.ZMin
    try:
        outline = _level_regions(Part.Compound(found.standing(bottom + SAME_LEVEL)))
        blocks = found.prisms() or found.map
    except ValueError as error:
        raise ValueError("The stock '%s' cannot be read: %s." % (stock.Label, error)) from None
    if not outline:
        raise ValueError("The stock '%s' is empty: give the job another one." % stock.Label)
    return outline, blocks, top, bottom


def part_of(job, operation, tool, stock, top, bottom, moves, notes):
    """[(Region, top), ...]: columns from the bottom that must stay; None where that is unknown, and
    `notes` gets a sentence on why. tool: a tool.Tool; stock, top, bottom: as stock_of tells them;
    moves: of the operation's path.
    """
    inner = host.operation_under(operation)
    if is_ours(inner):
        return _outside_floors(job, inner, tool, stock, top)
    models = list(job.Model.Group)
    others = [obj for obj in _base_objects(inner) if obj not in models]
    if others:
        notes.append(
            "'%s' works on %s, which is not of the model: what must stay is not known."
            % (inner.Label, listed(["'%s'" % obj.Label for obj in others], " and ", "others"))
        )
        return None
    heights = {round(m[3] / SAME_LEVEL) for m, n in zip(moves, moves[1:]) if m[3] == n[3]}
    levels = [z for z in (SAME_LEVEL * each for each in sorted(heights)) if bottom < z < top]
    return _model(_bodies(job), levels, bottom, notes)


def _bodies(job):
    return [each for _, each in body.models_of(job)]


def _base_objects(operation):
    """The objects that a foreign operation works on."""
    found = []
    for name in ("Base", "BaseShapes"):
        for item in getattr(operation, name, None) or []:
            found.append(item[0] if isinstance(item, tuple) else item)
    return list(dict.fromkeys(found))


def _outside_floors(job, op, tool, stock, top):
    """The part of one of our operations."""
    last = op.Proxy.last
    floors = last.floors if last is not None else op.Proxy.floors(op, tool)
    whole = Part.Compound([_face(region.outer, region.islands) for region in stock])
    grounds = [_ground(floor) for floor in floors]
    walls = _level_regions(whole.cut(grounds))
    if walls and op.StockToLeave.Value > 0:
        grown = compiled.core().offset(walls, op.StockToLeave.Value)
        walls = _level_regions(whole.common([_face(r.outer, r.islands) for r in grown]))
    part = [(wall, top) for wall in walls]
    for floor, ground in zip(floors, grounds):
        final = floor.depth + op.StockToLeaveAxial.Value
        height = max(floor.z, final) if floor.is_face else final
        deeper = [g for f, g in zip(floors, grounds) if f.depth < floor.depth - SAME_LEVEL]
        own = ground.common(whole)
        own = own.cut(deeper) if deeper else own
        part += [(region, height) for region in _level_regions(own)]
        if floor.of_solid:
            part += _above(job, ground, max(final, floor.z))
    return part


def _above(job, ground, z):
    """[(Region, top), ...] of what stands above the height z on a ground, of any model."""
    part = []
    for model in _bodies(job):
        standing = model.standing(z + ABOVE_FLOOR)
        cover = ground.common(standing) if standing else None
        if cover and cover.Area > LEAST_COVER:
            part += [(region, model.box.ZMax) for region in _level_regions(cover)]
    return part


def _ground(floor):
    """A floor's face, and what lies beyond its open sides."""
    face, beyond = _face(floor.outer, floor.islands), _beyond(floor)
    return face.multiFuse(beyond) if beyond else face


def _level_regions(faces):
    """The Regions of a shape's faces, those that adjoin each other as one."""
    faces = faces.removeSplitter().Faces
    return body.regions_of(Part.Compound(faces)) if faces else []


def _face(outer, islands=()):
    """The level face within a chain of (x, y, bulge, ...) and outside of the island chains."""
    face = Part.Face(_wire(outer))
    return face.cut([Part.Face(_wire(island)) for island in islands]) if islands else face


def _wire(chain):
    pairs = zip(chain, [*chain[1:], chain[0]])
    return Part.Wire([_edge(before, after[:2], before[2]) for before, after in pairs])


def _edge(start, end, bulge):
    a, b = Vector(*start[:2], 0), Vector(*end, 0)
    if not bulge:
        return Part.makeLine(a, b)
    chord = b - a
    return Part.Arc(a, (a + b) / 2 + Vector(chord.y, -chord.x, 0) * (bulge / 2), b).toShape()


def _beyond(floor):
    """Faces that cover the ground beside a floor's open sides, up to BEYOND, and round the corners
    between two of them.
    """
    chain = floor.outer  # counter-clockwise where it has open sides
    result = []
    for before, piece, after in zip([chain[-1], *chain[:-1]], chain, [*chain[1:], chain[0]]):
        if not piece[3]:
            continue
        result.append(_band(piece, after))
        if before[3]:
            result.append(Part.Face(Part.Wire([Part.makeCircle(BEYOND, Vector(*piece[:2], 0))])))
    return result


def _band(piece, after):
    """The face between a piece of a chain and what lies BEYOND to its right."""
    (x0, y0, bulge, *_), (x1, y1, *_) = piece, after
    half = 2 * math.atan(bulge)
    along = math.atan2(y1 - y0, x1 - x0)
    corners = [
        (x + BEYOND * math.sin(angle), y - BEYOND * math.cos(angle))
        for x, y, angle in ((x0, y0, along - half), (x1, y1, along + half))
    ]
    radius = 0.5 * math.hypot(x1 - x0, y1 - y0) / math.sin(half) if bulge else math.inf
    if -2 * BEYOND < radius < 0:  # too tight a hollow for a band: all of it
        return Part.Face(Part.Wire([_edge(piece, (x1, y1), bulge), _edge((x1, y1), (x0, y0), 0)]))
    edges = [
        _edge((x0, y0), (x1, y1), bulge),
        _edge((x1, y1), corners[1], 0),
        _edge(corners[1], corners[0], -bulge),
        _edge(corners[0], (x0, y0), 0),
    ]
    return Part.Face(Part.Wire(edges))


def _model(bodies, levels, bottom, notes):
    """The bodies as [(Region, top), ...] between the `levels` of a path, the lowest first; None,
    with a note, where they lean and there are too many levels.
    """
    part = []
    for each in bodies:
        prisms = each.prisms()
        if prisms is not None:
            part += [(region, top) for region, top in prisms if top > bottom]
            continue
        if len(levels) > MOST_LEVELS:
            notes.append(
                "The path has more than %d levels and the model leans: no part is taken."
                % MOST_LEVELS
            )
            return None
        try:
            for low, high in zip([bottom, *levels], [*levels, each.box.ZMax]):
                standing = Part.Compound(each.standing(low + ABOVE_FLOOR))
                part += [(region, high) for region in _level_regions(standing)]
        except ValueError as error:
            notes.append("What must stay of the model is not known: %s." % error)
            return None
    return part
