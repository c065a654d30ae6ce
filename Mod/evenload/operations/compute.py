"""The data flow of all operations: from base geometry and settings to the core's toolpath, and what
is said of it.
"""

from dataclasses import dataclass

from evenload import compiled, host, planar
from evenload import tool as tools
from evenload.operations import by_depth, checks, force, rest, stock_checks
from evenload.operations.refusal import Cancelled
from evenload.settings import parameters
from evenload.waiting import Stopped
from evenload.words import name_of

LEVEL = 1e-3  # mm: heights nearer than this are the same to a machine


@dataclass
class Computation:
    """What the last successful run worked on, for reports and pictures; it is not saved with the
    document.
    """

    floors: list  # of Floor
    regions: list  # the core's
    cuts: list  # of by_depth.Cut, in their order
    toolpath: object  # of all cuts
    tool: object  # tool.Tool
    data: object  # tool.CuttingData
    hole: tuple  # (x, y, diameter) in mm, or None
    notes: list  # sentences for the report
    own: dict  # {name: value} of results and fitted settings of its kind of operation


def run(proxy, obj):
    """The Computation of an operation. Raises ValueError with a sentence for what cannot be done,
    Cancelled where it was stopped.
    """
    core = compiled.core()
    tool, data = tools.read(obj.ToolController)
    refuse_turned_work_plane(obj)
    # Geometry first: depths follow it, and what is wrong with them then is not the cause.
    checks.for_geometry(obj)
    try:
        floors = proxy.floors(obj, tool)
        stock_checks.refuse_floors_below(obj, floors)
    except Stopped:
        raise Cancelled(_area_of_stock(obj)) from None
    checks.settings(obj, proxy.settings, tool, data)
    regions = [floor.region() for floor in floors]
    slack = max(floor.slack for floor in floors)
    standing, notes = None, []
    watch = proxy.watch()
    try:
        stock_checks.refuse_material_above(obj, core, tool, regions, watch)
        hole = checks.hole(obj, tool, floors)
        if rest.is_wanted(obj):
            standing = rest.Standing(obj, watch)
            notes += standing.notes
    except Stopped:
        raise Cancelled(_area_in_reach(obj, core, tool, regions)) from None
    arguments = _parameters(proxy, obj, tool, data, hole, slack)
    arguments["progress"] = watch
    cuts = by_depth.clear(proxy, obj, core, tool, floors, arguments, standing)
    if cuts[-1].toolpath.report.termination == by_depth.CANCELLED:
        raise Cancelled(_area_in_reach(obj, core, tool, regions))
    toolpath = by_depth.joined(cuts)
    _check_entries(tool, toolpath)
    of_depths, found = by_depth.notes(cuts)
    notes += spindle_notes(obj, data) + of_depths + _floor_notes(floors)
    notes += stock_checks.notes_of(obj) + force.notes(obj, tool) + found
    own = proxy.results_of(cuts)
    return Computation(floors, regions, cuts, toolpath, tool, data, hole, notes, own)


def refuse_turned_work_plane(obj):
    """Raises ValueError where an operation's work plane is not the job's."""
    turned = host.turned_work_plane(obj)
    if turned is not None:
        raise ValueError(
            "The work plane '%s' is turned, and EvenLoad cuts along the job's own axes: choose "
            "another, or turn the model in a job of its own." % turned.Label
        )


def _area_of_stock(obj):
    """mm2: the most that can stay uncut, where it is not known yet what is in reach."""
    box = host.parent_job(obj).Stock.Shape.BoundBox
    return box.XLength * box.YLength


def area_of(obj, done):
    """What the path of a Computation clears, in mm2."""
    return _area_in_reach(obj, compiled.core(), done.tool, done.regions)


def _area_in_reach(obj, core, tool, regions):
    """What a path would clear, in mm2."""
    ground = core.reachable_ground(regions, tool.diameter, obj.StockToLeave.Value)
    return sum(region.area for region in ground)


def _floor_notes(floors):
    notes = [note for floor in floors for note in floor.notes]
    beside = {}  # faces by how far FinalDepth, to which they are cut then, lies from them
    for floor in floors:
        above = round(floor.z - floor.depth, 4)
        if floor.is_face and abs(above) > LEVEL:
            beside.setdefault(above, []).extend(floor.parts)
    for above, parts in beside.items():
        what = "below %s: the tool cuts into it." if above > 0 else "above %s: the rest stays."
        notes.append("FinalDepth lies %g mm " % abs(above) + what % name_of(parts))
    return notes


def _parameters(proxy, obj, tool, data, hole, slack):
    """Keyword arguments of the core's generators, but for heights of cuts; mm, rad, mm/min. slack:
    what the regions may be too large by, for which the tool keeps away from the walls.
    """
    return {
        **parameters.of(obj, proxy.settings),
        "tool_diameter": tool.diameter,
        "cut_mode": core_cut_mode(obj, data),
        "feed": data.feed,
        "plunge_feed": data.plunge_feed,
        "maximum_feed": max(60 * obj.MaximumFeed.Value, data.feed),
        "rapid_feed": data.rapid_feed or tools.ASSUMED_RAPID,
        "entry_point": hole[:2] if hole else None,
        "hole_diameter": hole[2] if hole else 0.0,
        "stock_to_leave": obj.StockToLeave.Value + slack,
        "tolerance": obj.Tolerance.Value - 2 * slack,
        "safe_height": obj.SafeHeight.Value,
        "clearance_height": obj.ClearanceHeight.Value,
        **force.parameters(obj, tool, data),
    }


def core_cut_mode(obj, data):
    """The cut mode as the core has it, whose spindle turns clockwise."""
    if data.spindle != tools.REVERSE:
        return obj.CutMode.lower()
    return "conventional" if obj.CutMode == "Climb" else "climb"


def _check_entries(tool, toolpath):
    """A tool that does not cut at its centre can only go down in a helix or a hole, or beside
    the material.
    """
    if tool.centre_cutting:
        return
    x = y = None
    for kind, nx, ny, nz, sweep, *_ in toolpath.moves:
        if kind == planar.ENTRY and not sweep and x is not None and (nx, ny) != (x, y):
            raise ValueError(
                "The tool '%s' does not cut at its centre and cannot enter by a ramp near "
                "(%g, %g): set a pre-drilled hole, or take a tool that cuts at its centre."
                % (tool.name, nx, ny)
            )
        x, y = nx, ny


def spindle_notes(obj, data):
    """Sentences on a spindle that turns the other way, or not at all."""
    controller = obj.ToolController.Label
    if data.spindle == tools.REVERSE:
        return [
            "The spindle of '%s' turns counter-clockwise, as its SpindleDir says: the path goes "
            "the other way round, so that it cuts as %s." % (controller, obj.CutMode.lower())
        ]
    if data.spindle == tools.STANDING:
        return ["The spindle of '%s' does not turn: set its SpindleDir." % controller]
    return []
