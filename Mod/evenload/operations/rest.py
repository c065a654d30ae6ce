"""Rest machining: what the earlier operations of its job leave for an operation.

FreeCAD recomputes objects in the order of their links, and operations have none to each other. So
an operation with UseRestMachining links to all before it, in EarlierOperations: it is recomputed
after them, and again whenever one of them changes.
"""

import Path

from evenload import host
from evenload.geometry.floor import SAME_HEIGHT
from evenload.settings.table import REST_MACHINING
from evenload.simulation import rest_resolution
from evenload.simulation.taking import COARSE


def is_wanted(op):
    """Whether an operation clears only what others left; not every kind can."""
    return getattr(op, REST_MACHINING.name, False)


def starts_below(op, job):
    """Whether an operation starts below the top of the stock, where others must have cut before."""
    stock = job.Stock.Shape if job.Stock is not None else None
    if stock is None or stock.isNull():
        return False  # said where the operation is computed
    return stock.BoundBox.ZMax > op.StartDepth.Value + SAME_HEIGHT


def link_all(job):
    """Sets EarlierOperations of all the job's operations to what comes before them now.

    All at once, so that operations which changed places never depend on each other.
    """
    wanted = _links_of(job)
    changed = [(op, links) for op, links in wanted.items() if op.EarlierOperations != links]
    for op, _ in changed:
        op.EarlierOperations = []
    for op, links in changed:
        op.EarlierOperations = links


def _links_of(job):
    """{operation: what EarlierOperations of it should be} of a job's operations as they are now."""
    earlier, wanted = [], {}
    for item in host.operations(job):
        for op in host.all_under(item):
            if op not in wanted and hasattr(op, "EarlierOperations"):
                wanted[op] = list(earlier) if is_wanted(op) or starts_below(op, job) else []
        earlier.append(item)
    return wanted


class Standing:
    """Where material stands for an operation: what earlier ones left, without what its own cuts
    have taken since.
    """

    def __init__(self, settings, before, progress):
        """settings: the operation's; before: simulation.earlier.Before; progress: as for its
        stock.
        """
        self._stock = before.stock(rest_resolution(settings.SideStep.Value), progress)

    def at(self, settings, core, tool, regions, levels, floors):
        """[[Region, ...] for each of the levels]: where material stands there within the tool's
        reach of the floors' regions.
        """
        keep_away = settings.StockToLeave.Value + max(floor.slack for floor in floors)
        reach = core.reachable_ground(regions, tool.diameter, keep_away)
        return [self._stock.standing(z, reach) for z in levels]

    def cut(self, core, tool, toolpath):
        """Takes what a toolpath of the operation's own has cut."""
        core.simulate(
            toolpath,
            self._stock,
            tool_diameter=tool.diameter,
            step=COARSE * tool.diameter,
            find_rest=False,
        )


def wait_for_earlier(op, is_linked=True):
    """Links an operation to those before it, unless that is not wanted, for it changes the
    document; raises ValueError where one is not up to date.
    """
    job = host.parent_job(op)
    if is_linked:
        link_all(job)
    for earlier in _links_of(job).get(op, op.EarlierOperations):
        if host.is_active(earlier) and any(map(_is_waiting, host.all_under(earlier))):
            raise ValueError(
                "The path of '%s', which comes before '%s', is not up to date: recompute the "
                "document once more." % (earlier.Label, op.Label)
            )


def empty_after(failed):
    """Empties what relies on an operation that failed: its dressups and arrays, and rest machining
    after it. FreeCAD leaves them as they were, to be recomputed, and posts would write them.
    """
    job = host.parent_job(failed)
    for item in host.operations(job) if job is not None else ():
        for obj in host.all_under(item):
            made_of = host.all_under(obj)
            earlier = [e for o in made_of for e in getattr(o, "EarlierOperations", [])]
            if obj is failed or not any(failed in host.all_under(o) for o in [obj, *earlier]):
                continue
            if hasattr(obj, "EarlierOperations"):
                obj.Proxy.empty(
                    obj,
                    "'%s', which comes before '%s', failed: mend it and recompute."
                    % (failed.Label, obj.Label),
                )
            else:
                obj.Path = Path.Path()
            obj.touch()  # it is out of date also where the document is saved now and opened again


def _is_waiting(item):
    """Whether an operation, dressup or array is still to be recomputed."""
    return "Touched" in item.State or not item.isValid()
