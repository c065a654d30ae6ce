"""A path through stock: `simulate`, and how finely it looks. Needs no FreeCAD."""

import math

import numpy

from evenload import compiled, machines
from evenload.simulation import taking
from evenload.simulation.inputs import (
    Source,
    check_number,
    check_within,
    cutting_data,
    earlier_cuts,
    prisms_of,
)
from evenload.simulation.result import Simulation, simulation_of

RAPID_FEED = 5000.0  # mm/min, where neither the cutting data nor a machine has one
# mm between dexels where nobody says, and so many across the tool: the engagement of a tool of
# 0.5 mm in a stroke of 0.6 mm is within a degree then; with 0.05 mm it was 8 too large.
COARSEST, FINEST, IN_TOOL = 0.05, 0.005, 50
# mm between the dexels in which rest machining sees what is left, and so many in the width of a
# cut: of films thinner than what lies between dexels only pieces are seen, and fed for.
COARSEST_REST, FINEST_REST, REST_IN_CUT = 0.05, 0.02, 16
EARLIER = 0.25  # of the time that a mm of path takes: one that was cut before, about


def simulate(
    source,
    stock,
    top,
    bottom,
    tool_diameter,
    teeth=1,
    part=None,
    cutting=None,
    machine=None,
    resolution=None,
    step=0.1,
    *,
    fixtures=None,
    earlier=(),
    infer_kinds=None,
    lines=None,
    progress=None,
):
    """Runs a path through stock; returns a Simulation.

    source: the path of a G-code file, a Toolpath of the core, or a list of moves (kind, x, y, z,
        sweep, cx, cy, feed), the first of which says where the tool is; mm, rad, mm/min.
    stock: a Region, a box (xmin, ymin, xmax, ymax), a closed chain [(x, y, bulge), ...], or a list
        of these, from `bottom` to `top` or, as (what, height), to another height; or the upper side
        of a body as the core's HeightMap; or a Simulation, whose remaining stock is taken with its
        top, bottom and resolution.
    part: what must stay, in the same words; None or an empty list: nothing must stay. fixtures:
        what must not be touched, likewise.
    cutting: {"material": see materials.load, "spindle_speed": rev/min, "helix_angle_deg",
        "rapid_feed": mm/min}, each as far as known. A G-code file's own spindle speed is taken
        where there is none here.
    machine: see machines.load.
    resolution: mm between dexels, None: by the tool, see default_resolution.
    step: mm of path between samples at the most.
    earlier: [(source, tool diameter), ...]: cut beforehand.
    infer_kinds: whether links and entries are told from cuts by what the moves do; None: in G-code.
    lines: for each of the moves a line to be reported with it.
    progress: callable(share) -> bool, False cancels; there are no samples where that is while what
        was cut beforehand is taken away.

    Raises ValueError with a sentence, which names the move or the line, for what cannot be used.
    """
    core = compiled.core()
    sizes = {"tool_diameter": tool_diameter, "top": top, "bottom": bottom}
    if resolution is not None:
        sizes["resolution"] = resolution
    for name, value in {**sizes, "step": step}.items():
        check_number(name, value)
    if resolution is None:
        resolution = default_resolution(tool_diameter)
    if isinstance(teeth, bool) or not isinstance(teeth, (int, numpy.integer)):
        raise ValueError("teeth must be a whole number, not %r." % (teeth,))
    path = Source(core, source, lines)
    data = cutting_data(core, cutting, path)
    profile = None
    if machine is not None:
        limits = machines.load(machine)
        data.setdefault("rapid_feed", limits["rapid_feed"])
        limits["rapid_feed"] = min(limits["rapid_feed"], data["rapid_feed"])
        profile = core.MachineProfile(**limits)
    data.setdefault("rapid_feed", RAPID_FEED)

    stock_regions = []
    if isinstance(stock, Simulation):
        dexels = stock.stock.copy()
        top, bottom = dexels.top, dexels.bottom
        prisms = prisms_of(core, part, top, "The part", may_be_none=True)
    else:
        prisms = prisms_of(core, part, top, "The part", may_be_none=True)
        if isinstance(stock, core.HeightMap):
            blocks = stock
        else:
            blocks = prisms_of(core, stock, top, "The stock")
            stock_regions = [region for region, _ in blocks]
        dexels = core.DexelStock(blocks, bottom, resolution)
        check_within(dexels, prisms)
    before = earlier_cuts(core, earlier)
    goes_on, told = _take(before, dexels, path.moves, progress)

    record, figures, cancelled = core.simulate(
        path.moves if goes_on else taking.listed(path.moves)[:1] * 2,
        dexels,
        tool_diameter=tool_diameter,
        teeth=teeth,
        step=step,
        infer_kinds=path.is_gcode if infer_kinds is None else infer_kinds,
        part=prisms,
        fixtures=prisms_of(core, fixtures, top, "The fixture", may_be_none=True),
        machine=profile,
        find_rest=goes_on,
        progress=told,
        **data,
    )
    speed = data.get("spindle_speed", 0.0)
    result = simulation_of(record, figures, path.lines, speed * teeth)
    if fixtures is None:
        result.fixture_mm = None
    if cancelled or not goes_on:  # the rest was not looked for
        result.cancelled = True
        result.rest_area = result.rest_depth = result.unreachable_area = math.nan
    if path.dwell_s:
        result.time_total_s += path.dwell_s
        if result.machine_time_total_s is not None:
            result.machine_time_total_s += path.dwell_s
    result.stock, result.stock_regions, result.part = dexels, stock_regions, prisms
    result.tool_diameter, result.top, result.bottom = float(tool_diameter), dexels.top, bottom
    result.notes = [
        *path.notes,
        *("Earlier cut: " + note for cut, _ in before for note in cut.notes),
    ]
    return result


def default_resolution(tool_diameter):
    """mm between the dexels of a stock that a tool is simulated in."""
    return max(FINEST, min(COARSEST, tool_diameter / IN_TOOL))


def rest_resolution(cut_width):
    """mm between the dexels of a stock that is to be cleared by cuts `cut_width` mm wide, > 0."""
    return max(FINEST_REST, min(COARSEST_REST, cut_width / REST_IN_CUT))


def _take(before, dexels, moves, progress):
    """Takes what was cut before out of the stock. Gives whether to go on, and who is to be told of
    the progress of the moves then.
    """
    cuts = [(cut.moves, diameter) for cut, diameter in before]
    if not cuts or progress is None:
        return taking.take(dexels, cuts, lambda _: True), progress
    length = EARLIER * sum(taking.length_of(each) for each, _ in cuts)
    begin = length / max(length + taking.length_of(moves), 1e-9)
    if not taking.take(dexels, cuts, lambda share: progress(begin * share)):
        return False, None
    return True, lambda share: progress(begin + (1 - begin) * share)
