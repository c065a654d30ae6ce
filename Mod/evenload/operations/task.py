"""What computing a path takes, once it has been read from the document: from there on no document
is needed, and any thread may do it.
"""

from dataclasses import dataclass

from evenload import compiled, planar
from evenload.operations import by_depth, rest, stock_checks
from evenload.operations.refusal import Cancelled
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


@dataclass
class Task:
    """An operation that clears floors, as it was read."""

    proxy: object  # the operation's, of which only its kind matters
    settings: object  # by their names, as settings_of() of seen.py has them
    floors: list  # of Floor
    regions: list  # the core's
    tool: object  # tool.Tool
    data: object  # tool.CuttingData
    hole: tuple  # (x, y, diameter) in mm, or None
    arguments: dict  # of the core's generators, but for heights of cuts
    before: object  # simulation.earlier.Before; None where it does not matter what was cut before
    starts_below: bool  # whether what was cut before must have taken all above StartDepth
    is_rest: bool  # whether only what is left then is to be cut
    spindle_notes: list  # sentences for the report
    notes: list  # others of what was read

    def run(self, watch):
        """The Computation. watch: callable(share) -> whether to go on, or None. Raises ValueError
        with a sentence for what cannot be done, Cancelled where it was stopped.
        """
        core, standing, notes = compiled.core(), None, []
        try:
            if self.starts_below:
                stock_checks.refuse_left_above(
                    self.settings, self.before, core, self.tool, self.regions, watch
                )
            if self.is_rest:
                standing = rest.Standing(self.settings, self.before, watch)
                notes += self.before.notes
        except Stopped:
            raise Cancelled(self.area()) from None
        arguments = {**self.arguments, "progress": watch}
        cuts = by_depth.clear(
            self.proxy, self.settings, core, self.tool, self.floors, arguments, standing
        )
        if cuts[-1].toolpath.report.termination == by_depth.CANCELLED:
            raise Cancelled(self.area())
        return self._computation(cuts, notes)

    def _computation(self, cuts, notes):
        toolpath = by_depth.joined(cuts)
        _check_entries(self.tool, toolpath)
        of_depths, found = by_depth.notes(cuts)
        notes += self.spindle_notes + of_depths + _floor_notes(self.floors) + self.notes + found
        return Computation(
            self.floors,
            self.regions,
            cuts,
            toolpath,
            self.tool,
            self.data,
            self.hole,
            notes,
            self.proxy.results_of(cuts),
        )

    def area(self):
        """mm2 that its path would clear."""
        return area_in_reach(self.settings, self.tool, self.regions)

    def is_same(self, other):
        """Whether another task makes the same path. Two that depend on what was cut before are
        never taken for the same.
        """
        return self.before is None and other.before is None and self._key() == other._key()

    def _key(self):
        arguments = dict(self.arguments)
        force = arguments.pop("force_coefficients", None)
        floors = [
            (f.name, f.z, f.depth, f.outer, f.islands, f.slack, f.notes, f.is_face, f.parts)
            for f in self.floors
        ]
        return (
            type(self.proxy),
            vars(self.settings),
            floors,
            self.tool,
            self.data,
            self.hole,
            arguments,
            force and (force.ktc, force.krc, force.kte, force.kre),
            self.spindle_notes + self.notes,
        )


def area_in_reach(settings, tool, regions):
    """mm2 of regions that a tool reaches, StockToLeave off their walls."""
    ground = compiled.core().reachable_ground(regions, tool.diameter, settings.StockToLeave.Value)
    return sum(region.area for region in ground)


def _floor_notes(floors):
    notes = [note for floor in floors for note in floor.notes]
    beside = {}  # faces by how far FinalDepth, to which they are cut then, lies from them
    for floor in floors:
        above = round(floor.z - floor.depth, 4)
        if floor.is_face and abs(above) > LEVEL:
            beside.setdefault(above, []).extend(floor.parts)
    for above, parts in beside.items():
        if above > 0:
            said = "FinalDepth lies %g mm below %s: the tool cuts into it."
        else:
            said = "FinalDepth lies %g mm above %s: the rest stays."
        notes.append(said % (abs(above), name_of(parts)))
    return notes


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
