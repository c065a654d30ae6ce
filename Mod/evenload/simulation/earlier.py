"""What was cut before an operation: its own path's moves, those of the job's earlier operations and
of the holes drilled for them, and the stock that they leave.
"""

import hashlib
from collections import OrderedDict
from dataclasses import dataclass

from evenload import commands, compiled, host, planar
from evenload import tool as tools
from evenload.settings.properties import is_ours
from evenload.settings.table import HOLE_ENTRIES
from evenload.simulation import part, taking
from evenload.waiting import Stopped

MOST_KEPT = 150_000  # moves of paths that were followed: some 50 MB
_followed = (
    OrderedDict()
)  # moves and numbers by what they follow from, those asked for last at its end
ABOVE = 1.0  # mm: above the stock, where the tool that stands for a hole's drill comes from


@dataclass
class Before:
    """A job's stock and what cuts it before an operation, as read from the document."""

    blocks: object  # [(Region, top in mm), ...] or a HeightMap
    bottom: float  # mm
    cuts: list  # of (moves, tool diameter in mm), in their order
    notes: list  # sentences on what is left out

    def stock(self, resolution, progress=None):
        """The DexelStock that is left, its dexels `resolution` mm apart.

        progress: callable(share) -> bool, False stops it; nothing but 0 is told, for more work
        follows. Raises waiting.Stopped where it was stopped.
        """
        stock = compiled.core().DexelStock(self.blocks, self.bottom, resolution)
        if not taking.take(stock, self.cuts, lambda _: progress is None or progress(0.0)):
            raise Stopped()
        return stock


def before(operation):
    """What comes Before an operation: the stock, the job's earlier active operations. Raises
    ValueError with a sentence for what cannot be read.
    """
    notes = []
    _, blocks, _, bottom = part.stock_of(host.parent_job(operation).Stock)
    return Before(blocks, bottom, cut_before(operation, notes), notes)


def moves_of(operation):
    """(moves, numbers of their commands) of an operation's path. Neither list may be changed: who
    asks again gets the same ones.
    """
    clearance = getattr(host.operation_under(operation), "ClearanceHeight", None)
    height, path = clearance.Value if clearance else 0.0, operation.Path
    feed = 60 * host.controller_of(operation).HorizFeed.Value
    # To write a path takes a tenth of the time that it takes to follow it.
    key = hashlib.sha256(path.toGCode().encode()).digest(), height, feed
    if key not in _followed:
        try:
            _followed[key] = _followed_now(path.Commands, height, feed)
        except ValueError as error:
            raise ValueError("'%s': %s" % (operation.Label, error)) from None
    _followed.move_to_end(key)
    while len(_followed) > 1 and sum(len(moves) for moves, _ in _followed.values()) > MOST_KEPT:
        _followed.popitem(last=False)
    return _followed[key]


def _followed_now(found, clearance, feed):
    heights = [c.Parameters["Z"] for c in found if "Z" in c.Parameters]
    return commands.to_moves(found, max([clearance, *heights]), feed)


def all_before(operation):
    """The operations of its job before one, active or not, in their order; none without a job."""
    inner, result, job = host.operation_under(operation), [], host.parent_job(operation)
    for other in host.operations(job) if job is not None else ():
        if inner in host.all_under(other):  # also where the job has but its dressup or array
            break
        result.append(other)
    return result


def cut_before(operation, notes, without=()):
    """[(moves, tool diameter), ...] of the job's active operations before one, in their order, and
    of the holes drilled for them and for it; `notes` gets a sentence on each that is left out.
    without: names of operations that count as not cut. Raises ValueError for a path that cannot be
    followed.
    """
    result, job = [], host.parent_job(operation)
    top = job.Stock.Shape.BoundBox.ZMax
    for other in all_before(operation):
        if other.Name in without:
            continue
        controller = host.controller_of(other)
        if not host.is_active(other) or controller is None or not controller.Tool:
            continue
        kind, diameter = tools.other_shape(controller), tools.diameter(controller)
        is_known = not kind or tools.is_drill(controller) or tools.is_ball(controller)
        if not (diameter > 0 and is_known):
            notes.append(
                "'%s' is left out: its tool is %s, which the simulator cannot follow."
                % (other.Label, kind or "without a diameter")
            )
            continue
        moves, _ = moves_of(other)
        result += hole_of(host.operation_under(other), top)
        if len(moves) < 2:
            continue
        result += [
            ([(*m[:3], m[3] + above, *m[4:]) for m in moves], width)
            for above, width in tools.discs(controller)
        ]
    return result + hole_of(host.operation_under(operation), top)


def hole_of(operation, top):
    """The pre-drilled hole of one of our operations as what its drill did: [(moves, diameter)]."""
    if not is_ours(operation) or operation.Entry not in HOLE_ENTRIES:
        return []
    diameter, at = operation.HoleDiameter.Value, operation.EntryPoint
    if not diameter > 0:
        return []
    feed = 60 * operation.ToolController.VertFeed.Value
    ends = ((planar.RAPID, top + ABOVE, 0.0), (planar.CUT, operation.FinalDepth.Value, feed))
    return [([(kind, at.x, at.y, z, 0.0, 0.0, 0.0, f) for kind, z, f in ends], diameter)]
