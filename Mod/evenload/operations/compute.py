"""What the computing of an operation that clears floors takes from the document: base geometry,
settings, tool, what was cut before.
"""

from evenload import host
from evenload import tool as tools
from evenload.operations import checks, force, rest, stock_checks
from evenload.operations.refusal import Cancelled
from evenload.operations.seen import settings_of
from evenload.operations.task import Task, area_in_reach
from evenload.settings import parameters
from evenload.simulation import earlier
from evenload.waiting import Stopped


def read(proxy, op, seen=None):
    """The Task of an operation. seen: the operation as Seen where nothing may be touched, or None.
    Raises ValueError with a sentence for what cannot be done, Cancelled where it was stopped.
    """
    obj = op if seen is None else seen
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
    try:
        above = stock_checks.place_above(obj, tool, regions)
        matters = above is not None or rest.is_wanted(obj)
        before = earlier.before(op) if matters else None
    except Stopped:
        raise Cancelled(area_in_reach(obj, tool, regions)) from None
    if above is not None and not before.cuts:
        stock_checks.refuse_above(obj, *above)
    if matters:
        rest.wait_for_earlier(op, is_linked=seen is None)
    hole = checks.hole(obj, tool, floors)
    checks.open_side(obj, floors)
    return Task(
        proxy,
        settings_of(obj, proxy.settings),
        floors,
        regions,
        tool,
        data,
        hole,
        _parameters(proxy, obj, tool, data, hole, slack),
        before,
        above is not None,
        rest.is_wanted(obj),
        spindle_notes(obj, data),
        stock_checks.notes_of(obj) + force.notes(obj, tool),
    )


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
    return area_in_reach(obj, done.tool, done.regions)


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
        "open_side": checks.open_side_at(obj),
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
