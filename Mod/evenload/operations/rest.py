"""Rest machining: what the earlier operations of its job leave for an operation.

FreeCAD recomputes objects in the order of their links, and operations have none to each other. So
an operation with UseRestMachining links to all before it, in EarlierOperations: it is recomputed
after them, and again whenever one of them changes.
"""

import FreeCAD
import Path

from evenload import host
from evenload.floor import SAME_HEIGHT
from evenload.operations.settings import REST_MACHINING


def is_wanted(op):
    """Whether an operation clears only what others left; not every kind can."""
    return getattr(op, REST_MACHINING.name, False)


def starts_below(op, job):
    """Whether an operation starts below the top of the stock, where others must have cut before."""
    return job.Stock.Shape.BoundBox.ZMax > op.StartDepth.Value + SAME_HEIGHT


def link_all(job):
    """Sets EarlierOperations of all the job's operations to what comes before them now.

    All at once, so that operations which changed places never depend on each other.
    """
    earlier, wanted = [], []
    for item in host.operations(job):
        inner = host.operation_under(item)
        if hasattr(inner, "EarlierOperations"):
            links = list(earlier) if is_wanted(inner) or starts_below(inner, job) else []
            wanted.append((inner, links))
        earlier.append(item)
    changed = [(op, links) for op, links in wanted if op.EarlierOperations != links]
    for op, _ in changed:
        op.EarlierOperations = []
    for op, links in changed:
        op.EarlierOperations = links


def standing(op, core, tool, regions, levels, slack):
    """([[Region, ...] for each level], notes): where material stands within the tool's reach.

    Raises ValueError with a sentence where the earlier operations' paths cannot be relied upon.
    """
    from evenload import job_simulation
    from evenload.simulation import rest_resolution

    wait_for_earlier(op)
    stock, notes = job_simulation.stock_before(op, rest_resolution(op.SideStep.Value))
    reach = core.reachable_ground(regions, tool.diameter, op.StockToLeave.Value + slack)
    return [stock.standing(z, reach) for z in levels], notes


def wait_for_earlier(op):
    """Links an operation to those before it; raises ValueError where one is not up to date."""
    link_all(host.parent_job(op))
    for earlier in op.EarlierOperations:
        if host.is_active(earlier) and _is_waiting(earlier):
            raise ValueError(
                "The path of '%s', which comes before '%s', is not up to date: recompute the "
                "document once more." % (earlier.Label, op.Label)
            )


def empty_after(failed):
    """Empties the paths of rest machining that rely on an operation which failed: FreeCAD leaves
    them as they were.
    """
    job = host.parent_job(failed)
    for item in host.operations(job) if job is not None else ():
        op = host.operation_under(item)
        if failed in map(host.operation_under, getattr(op, "EarlierOperations", [])):
            op.Path = Path.Path()
            op.Report = "'%s', which comes before '%s', failed: mend it and recompute." % (
                failed.Label,
                op.Label,
            )


def _is_waiting(item):
    """Whether an operation, or one that its dressups dress, is still to be recomputed."""
    while isinstance(item, FreeCAD.DocumentObject) and hasattr(item, "Path"):
        if "Touched" in item.State or not item.isValid():
            return True
        item = getattr(item, "Base", None)
    return False
