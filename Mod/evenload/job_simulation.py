"""What the simulator needs to know of an operation, read from its FreeCAD Job: any Path operation,
EvenLoad's, FreeCAD's own, or a dressup of one.

What must stay, the part, is taken from here:

- EvenLoad's operations say themselves what they clear: the stock outside of their floors must stay,
  and StockToLeave along its walls. Open sides of a floor have nothing beyond them. Below, a floor
  that is a face of the model must stay, and below outlines, and faces deeper than FinalDepth, what
  lies under FinalDepth with StockToLeaveAxial on it. Whatever of the job's models stands above
  a face must stay, too. In outlines that were drawn the model does not matter: it may be a block
  without the pocket in it.
- For any other operation it is the Job's model: where it is all level and upright as it is, else as
  what stands above each level of the path. What remains between that and the stock counts as rest,
  also where another operation is meant to take it.
- An operation on geometry that is not the model's, such as a sketch, may well cut the model. As for
  a model that is no stack of sections, nothing can be said of its part then, and a note says so.
"""

import math
from dataclasses import dataclass

import Part
from FreeCAD import Vector

from evenload import body, commands, compiled, host, planar
from evenload import tool as tools
from evenload.floor import ABOVE_FLOOR, listed
from evenload.operations.settings import HOLE_ENTRIES

MOST_LEVELS = 200  # of a path at which a model that leans is looked at; roughing has fewer
SAME_LEVEL = 1e-3  # mm: moves nearer in height are at one level
LEAST_COVER = 1e-3  # mm2: less of a model over a floor is rounding
# mm: how far beyond a floor's open sides nothing must stay. More than BESIDE of open_edges.py, from
# where on that has seen that there is nothing, and than the tolerance of curves.
BEYOND = 0.1
# Share of a tool's diameter between looks at its load where that does not matter; what it sweeps is
# exact at any.
COARSE = 0.25
ABOVE = 1.0  # mm: above the stock, where the tool that stands for a hole's drill comes from


@dataclass
class Setup:
    """All that `simulate` needs; mm, rad, mm/min, rev/min."""

    label: str  # of the operation
    moves: list  # of (kind, x, y, z, sweep, cx, cy, feed); the first says where the tool is
    lines: list  # for each move, the number of its command in the operation's path, from 1; 0: none
    stock: list  # of the core's Region: seen from above
    blocks: object  # the stock as [(Region, top), ...], or a HeightMap where it leans
    top: float
    bottom: float
    tool: object  # tool.Tool
    cutting: dict  # spindle_speed where it is known, rapid_feed
    part: object  # [(Region, top), ...]: columns from the bottom that must stay; None: unknown
    earlier: list  # of (moves, tool diameter): what has been cut before, in this order
    notes: list  # sentences on what could not be taken as it is

    def simulate(
        self,
        resolution=None,
        step=0.1,
        material=None,
        machine=None,
        progress=None,
        fixtures=None,
    ):
        """The Simulation; see `of`."""
        from evenload.simulation import simulate

        cutting = dict(self.cutting)
        if material is not None:
            cutting["material"] = material
            cutting["helix_angle_deg"] = self.tool.helix_angle
        result = simulate(
            self.moves,
            self.blocks,
            self.top,
            self.bottom,
            self.tool.diameter,
            teeth=self.tool.teeth,
            part=self.part,
            cutting=cutting,
            machine=machine,
            resolution=resolution,
            step=step,
            infer_kinds=True,
            earlier=self.earlier,
            lines=self.lines,
            progress=progress,
            fixtures=fixtures,
        )
        result.notes[:0] = self.notes
        return result


def of(
    operation,
    resolution=None,
    step=0.1,
    material=None,
    machine=None,
    progress=None,
    after_earlier=True,
    fixtures=None,
):
    """The Simulation of a Path operation in its Job.

    resolution: distance in mm of the stock's rows, None: by the tool; step: along the path, in mm;
    material: name or coefficients, None for no forces; machine: name, file or dictionary of a
    machine's limits, None for programmed times only; progress: callable(share) -> bool, False stops
    it; after_earlier: whether the job's earlier active operations have cut before; fixtures: what
    must not be touched, as `simulate` takes it. Raises ValueError with a sentence
    for an operation that cannot be simulated.
    """
    setup = read(operation, after_earlier)
    return setup.simulate(resolution, step, material, machine, progress, fixtures)


def read(operation, after_earlier=True):
    """The Setup of a Path operation in its Job. Raises ValueError with a sentence."""
    job = host.parent_job(operation)
    if job is None:
        raise ValueError("'%s' belongs to no job: put it into one." % operation.Label)
    if job.Stock is None or job.Stock.Shape.isNull():
        raise ValueError("The job '%s' has no stock: give it one." % job.Label)
    tool, data = tools.read(host.controller_of(operation))
    notes = []
    moves, lines = _moves(operation)
    if len(moves) < 2:
        raise ValueError("'%s' has no path to simulate: recompute it first." % operation.Label)
    if tool.bull_nosed:
        notes.append("The tool '%s' is simulated with sharp corners." % tool.name)
    stock, blocks, top, bottom = _stock(job.Stock)
    cutting = {"rapid_feed": data.rapid_feed or tools.ASSUMED_RAPID}
    if data.spindle_speed > 0:
        cutting["spindle_speed"] = data.spindle_speed
    else:
        notes.append("The tool controller has no spindle speed: there is no chip thickness.")
    if data.spindle == tools.REVERSE:
        notes.append("The spindle turns counter-clockwise: it is simulated as if clockwise.")
    earlier = (
        cut_before(operation, notes)
        if after_earlier
        else _hole(host.operation_under(operation), top)
    )
    part = _part(job, operation, tool, stock, top, bottom, moves, notes)
    found = (
        operation.Label,
        moves,
        lines,
        stock,
        blocks,
        top,
        bottom,
        tool,
        cutting,
        part,
        earlier,
        notes,
    )
    return Setup(*found)


class Stopped(Exception):
    """Whoever was asked whether to go on does not want to."""


def stock_before(operation, resolution, progress=None):
    """(DexelStock, notes): what the job's earlier active operations leave for an operation.

    progress: callable(share) -> bool, False stops it; nothing but 0 is told, for more work follows.
    Raises ValueError with a sentence, Stopped where it was stopped.
    """
    core, notes = compiled.core(), []
    _, blocks, _, bottom = _stock(host.parent_job(operation).Stock)
    stock = core.DexelStock(blocks, bottom, resolution)
    answers = []

    def ask(_):
        answers.append(progress is None or progress(0.0))
        return answers[-1]

    for moves, diameter in cut_before(operation, notes):
        step = COARSE * diameter
        core.simulate(
            moves, stock, tool_diameter=diameter, step=step, find_rest=False, progress=ask
        )
        if not all(answers):
            raise Stopped()
    return stock, notes


# ---- path ----


def _moves(operation):
    """(moves, numbers of their commands) of an operation's path."""
    inner = host.operation_under(operation)
    clearance = getattr(inner, "ClearanceHeight", None)
    found = operation.Path.Commands
    heights = [c.Parameters["Z"] for c in found if "Z" in c.Parameters]
    z = max([clearance.Value if clearance else 0.0, *heights])
    controller = host.controller_of(operation)
    try:
        return commands.to_moves(found, z, 60 * controller.HorizFeed.Value)
    except ValueError as error:
        raise ValueError("'%s': %s" % (operation.Label, error)) from None


def cut_before(operation, notes):
    """[(moves, tool diameter), ...] of the job's active operations before one, in their order, and
    of the holes drilled for them and for it; `notes` gets a sentence on each that is left out.
    Raises ValueError for a path that cannot be followed.
    """
    result, job = [], host.parent_job(operation)
    top = job.Stock.Shape.BoundBox.ZMax
    inner = host.operation_under(operation)
    for other in host.operations(job):
        if inner in host.all_under(other):  # also where the job has but its dressup or array
            break
        controller = host.controller_of(other)
        if not host.is_active(other) or controller is None or not controller.Tool:
            continue
        kind, diameter = tools.other_shape(controller), tools.diameter(controller)
        if not diameter > 0 or (kind and not tools.is_drill(controller)):
            notes.append(
                "'%s' is left out: its tool is %s, which the simulator cannot follow."
                % (other.Label, kind or "without a diameter")
            )
            continue
        moves, _ = _moves(other)
        result += _hole(host.operation_under(other), top)
        if len(moves) < 2:
            continue
        result += [
            ([(*m[:3], m[3] + above, *m[4:]) for m in moves], width)
            for above, width in tools.discs(controller)
        ]
    return result + _hole(inner, top)


def _hole(operation, top):
    """The pre-drilled hole of one of our operations as what its drill did: [(moves, diameter)]."""
    if not _is_ours(operation) or operation.Entry not in HOLE_ENTRIES:
        return []
    diameter, at = operation.HoleDiameter.Value, operation.EntryPoint
    if not diameter > 0:
        return []
    feed = 60 * operation.ToolController.VertFeed.Value
    ends = ((planar.RAPID, top + ABOVE, 0.0), (planar.CUT, operation.FinalDepth.Value, feed))
    return [([(kind, at.x, at.y, z, 0.0, 0.0, 0.0, f) for kind, z, f in ends], diameter)]


def _is_ours(operation):
    from evenload.operations import base

    return isinstance(getattr(operation, "Proxy", None), base.Operation)


# ---- stock and part ----


def _stock(stock):
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


def _part(job, operation, tool, stock, top, bottom, moves, notes):
    inner = host.operation_under(operation)
    if _is_ours(inner):
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
    final = op.FinalDepth.Value + op.StockToLeaveAxial.Value
    for floor, ground in zip(floors, grounds):
        height = max(floor.z, final) if floor.is_face else final
        part += [(region, height) for region in _level_regions(ground.common(whole))]
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
