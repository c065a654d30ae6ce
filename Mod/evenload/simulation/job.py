"""What the simulator needs to know of an operation, read from its FreeCAD Job: any Path operation,
EvenLoad's, FreeCAD's own, or a dressup of one.
"""

from dataclasses import dataclass

from evenload import host
from evenload import tool as tools
from evenload.simulation import earlier, part, run

# Loads are those of upright edges, and stock is made of levels.
BALL = (
    "'%s' has a ball end mill, whose loads are not simulated: EvenLoad Show Surface, or "
    "evenload.surface_simulation, tells what it leaves on the faces."
)


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
        cutting = dict(self.cutting)
        if material is not None:
            cutting["material"] = material
            cutting["helix_angle_deg"] = self.tool.helix_angle
        result = run.simulate(
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


def read(operation, after_earlier=True, without=()):
    """The Setup of a Path operation in its Job. without: names of earlier operations that have not
    cut before, such as one that it is compared with. Raises ValueError with a sentence.
    """
    job = host.parent_job(operation)
    if job is None:
        raise ValueError("'%s' belongs to no job: put it into one." % operation.Label)
    if job.Stock is None or job.Stock.Shape.isNull():
        raise ValueError("The job '%s' has no stock: give it one." % job.Label)
    controller = host.controller_of(operation)
    if controller is not None and controller.Tool and tools.is_ball(controller):
        raise ValueError(BALL % operation.Label)
    tool, data = tools.read(controller)
    notes = []
    moves, lines = earlier.moves_of(operation)
    if not host.is_active(operation):
        raise ValueError("'%s' is not active: activate it first." % operation.Label)
    if len(moves) < 2:
        raise ValueError("'%s' has no path to simulate: recompute it first." % operation.Label)
    if tool.bull_nosed:
        notes.append("The tool '%s' is simulated with sharp corners." % tool.name)
    stock, blocks, top, bottom = part.stock_of(job.Stock)
    cutting = {"rapid_feed": data.rapid_feed or tools.ASSUMED_RAPID}
    if data.spindle_speed > 0:
        cutting["spindle_speed"] = data.spindle_speed
    else:
        notes.append("The tool controller has no spindle speed: there is no chip thickness.")
    if data.spindle == tools.REVERSE:
        notes.append("The spindle turns counter-clockwise: it is simulated as if clockwise.")
    cuts = (
        earlier.cut_before(operation, notes, without)
        if after_earlier
        else earlier.hole_of(host.operation_under(operation), top)
    )
    must_stay = part.part_of(job, operation, tool, stock, top, bottom, moves, notes)
    return Setup(
        operation.Label,
        moves,
        lines,
        stock,
        blocks,
        top,
        bottom,
        tool,
        cutting,
        must_stay,
        cuts,
        notes,
    )
