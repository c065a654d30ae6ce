"""Whether an operation fits into its stock: floors within it, and nothing above StartDepth."""

from evenload import host
from evenload.geometry import body
from evenload.operations import rest
from evenload.simulation import earlier, rest_resolution

LEVEL = 1e-3  # mm: heights nearer than this are the same to a machine
FILM = 0.02  # mm: what stands no higher above StartDepth is none
LEAST = 0.01  # tool diameters squared of material above StartDepth that are none


def refuse_floors_below(op, floors):
    """Raises ValueError for a face under the stock's underside, or for nothing but air to cut."""
    box = host.parent_job(op).Stock.Shape.BoundBox
    for floor in floors:
        if floor.of_solid and floor.z < box.ZMin - LEVEL:
            raise ValueError(
                "%s lies %g mm below the underside of the stock: make the stock larger, or move it "
                "there." % (floor.name, round(box.ZMin - floor.z, 3))
            )
    if op.StartDepth.Value < box.ZMin + LEVEL:
        raise ValueError(
            "StartDepth (%g mm) does not lie above the underside of the stock (%g mm): there is "
            "nothing to cut." % (op.StartDepth.Value, box.ZMin)
        )


def notes_of(op):
    """What Report says of a depth below the stock."""
    below = host.parent_job(op).Stock.Shape.BoundBox.ZMin - op.FinalDepth.Value
    if below <= LEVEL:
        return []
    return ["FinalDepth lies %g mm below the underside of the stock." % round(below, 3)]


def refuse_material_above(op, core, tool, regions, progress):
    """Raises ValueError with the place where material stands above StartDepth within an operation's
    regions, after all that the job's earlier operations cut. progress: as for
    simulation.earlier.stock_before.
    """
    start = op.StartDepth.Value + FILM
    stock = body.of(host.parent_job(op).Stock.Shape)
    places = [stock.highest_over(region, start, tool.diameter) for region in regions]
    place = max(filter(None, places), key=lambda place: place[2], default=None)
    if place is None:
        return
    if not earlier.cut_before(op, []):
        _refuse(op, *place)
    rest.wait_for_earlier(op)
    resolution = rest_resolution(op.SideStep.Value)
    dexels, _ = earlier.stock_before(op, resolution, progress)
    left = dexels.standing(start, core.reachable_ground(regions, tool.diameter, 0.0))
    if sum(region.area for region in left) < LEAST * tool.diameter**2:
        return
    _refuse(op, *left[0].outer[0][:2])


def _refuse(op, x, y, z=None):
    up_to = "" if z is None else " up to %g mm," % round(z, 3)
    raise ValueError(
        "Material stands%s above StartDepth (%g mm), near (%.3f, %.3f): raise StartDepth, or clear "
        "it before." % (up_to, op.StartDepth.Value, x, y)
    )
