"""What the map of a surface needs of an operation, read from its FreeCAD job."""

import math
from dataclasses import dataclass
from functools import cached_property

from evenload import advisor, compiled, host
from evenload import tool as tools
from evenload.geometry import facets
from evenload.operations import finishing
from evenload.operations.finishing import Finishing
from evenload.simulation import earlier

STOCK = advisor.STOCK  # mm that stand on the faces before
TOLERANCE = 0.005  # mm: to which triangles stand for the part, where nobody says
# Of a cusp's height, of which triangles leave the part by a tenth then; where faces bend in two
# directions so many would take minutes.
CUSP_SHARE = 0.1
LEAST_TOLERANCE = 0.0005  # mm: finer triangles are hardly to be had
NO_FACES = "Chips are told along an EvenLoad Finishing only."


@dataclass(frozen=True)
class Question:
    """An operation as it was read: no document is needed from here on. mm, mm/min, rev/min."""

    label: str
    models: object  # facets.Models
    tolerance: float  # to which triangles stand for the part
    moves: list  # as the core has them
    tool: object  # tool.Tool
    spindle_speed: float  # 0 where it is not known
    stock: float  # across the surface
    allowance: float  # that the operation is to leave on the part
    wish: float  # cusp height, 0 where there is none
    stepover: float  # in plan, the least; 0 where it is not known
    largest_stepover: float  # in plan; 0 where it is not known
    is_whole: bool  # whether all of the picked faces is to be cut, or what the path comes over
    loads: object  # advisor.Question, for the chips along the path; a sentence why there are none

    @cached_property
    def triangles(self):
        """The facets.Triangles, made where they are first asked for, in any thread. Raises
        ValueError with a sentence.
        """
        return self.models.triangles(self.tolerance)

    @cached_property
    def height_map(self):
        """The core's HeightMap of the triangles, which many maps ask."""
        return compiled.core().HeightMap(self.triangles.points, self.triangles.numbers)


def read(operation, stock=None, tolerance=None, wish=None, material=None):
    """The Question of a Path operation with a ball end, a bull-nosed or a flat end mill.

    Of an EvenLoad Finishing its faces are looked at, of any other operation whatever of the models
    looks up below its path. stock: mm that the cut before has left above what this one leaves,
    across the surface, None: STOCK; tolerance: mm to which triangles stand for the part; wish: cusp
    height in mm, None: that of a Finishing with even cusps; material: as materials.load takes it,
    None: the first of ours. Raises ValueError with a sentence for what cannot be simulated.
    """
    job = host.parent_job(operation)
    if job is None:
        raise ValueError("'%s' belongs to no job: put it into one." % operation.Label)
    tool, data = tools.read(host.controller_of(operation), takes_balls=True)
    moves, _ = earlier.moves_of(operation)
    if len(moves) < 2:
        raise ValueError("'%s' has no path to simulate: recompute it first." % operation.Label)
    stock = STOCK if stock is None else stock
    if not (math.isfinite(stock) and stock > 0):
        raise ValueError("The stock on the faces is %g mm: it must be more than 0." % stock)
    inner = host.operation_under(operation)
    is_ours = isinstance(getattr(inner, "Proxy", None), Finishing)
    base, allowance = None, 0.0
    if is_ours:
        base = finishing.faces_of(finishing.of_models(job, inner.Base))
        allowance = inner.Allowance.Value
    if tolerance is None:
        tolerance = _tolerance(inner, job.Model.Group) if is_ours else TOLERANCE
    if not tolerance >= LEAST_TOLERANCE:
        raise ValueError(
            "The tolerance is %g mm: it must be at least %g mm." % (tolerance, LEAST_TOLERANCE)
        )
    loads = _loads(inner, stock, material) if is_ours else NO_FACES
    models = facets.read(base, job.Model.Group) if isinstance(loads, str) else loads.models
    return Question(
        operation.Label,
        models,
        float(tolerance),
        moves,
        tool,
        data.spindle_speed,
        stock + allowance,
        allowance,
        _wish(inner) if wish is None and is_ours else float(wish or 0.0),
        inner.LeastStepover.Value if is_ours else 0.0,
        inner.LargestStepover.Value if is_ours else 0.0,
        is_ours,
        loads,
    )


def _tolerance(operation, models):
    """mm: no coarser than the operation's own, and finer where its cusps are low."""
    wished = min(TOLERANCE, operation.Tolerance.Value)
    cusp = operation.CuspHeight.Value
    if cusp > 0 and not any(facets.is_round(model.Shape) for model in models):
        wished = min(wished, CUSP_SHARE * cusp)
    return max(LEAST_TOLERANCE, wished)


def _wish(operation):
    """mm; a stepover that stays the same wishes for none."""
    return operation.CuspHeight.Value if finishing.wants_even_cusps(operation) else 0.0


def _loads(operation, stock, material):
    """The advisor's Question, or its sentence why there is no chip."""
    try:
        return advisor.read(operation, stock=stock, material=material)
    except ValueError as error:
        return str(error)
