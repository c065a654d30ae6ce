"""Whether an operation fits into its stock: floors within it, and nothing above StartDepth."""

from evenload import host
from evenload.geometry import body
from evenload.simulation import rest_resolution

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


def place_above(op, tool, regions):
    """(x, y, z) of the highest place of the stock above StartDepth within an operation's regions,
    None without one: the earlier operations must have cut there.
    """
    start = op.StartDepth.Value + FILM
    stock = body.of(host.parent_job(op).Stock.Shape)
    places = [stock.highest_over(region, start, tool.diameter) for region in regions]
    return max(filter(None, places), key=lambda place: place[2], default=None)


def refuse_left_above(settings, before, core, tool, regions, progress):
    """Raises ValueError with the place where material stands above StartDepth within regions, after
    all that was cut before, a simulation.earlier.Before. progress: as for its stock.
    """
    dexels = before.stock(rest_resolution(settings.SideStep.Value), progress)
    start = settings.StartDepth.Value + FILM
    left = dexels.standing(start, core.reachable_ground(regions, tool.diameter, 0.0))
    if sum(region.area for region in left) >= LEAST * tool.diameter**2:
        refuse_above(settings, *left[0].outer[0][:2])


def refuse_above(op, x, y, z=None):
    """Raises ValueError for material above StartDepth at a place, up to a height, all in mm."""
    up_to = "" if z is None else " up to %g mm," % round(z, 3)
    raise ValueError(
        "Material stands%s above StartDepth (%g mm), near (%.3f, %.3f): raise StartDepth, or clear "
        "it before." % (up_to, op.StartDepth.Value, x, y)
    )
