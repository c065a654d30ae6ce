"""Finishing: parallel passes of a ball end, bull-nosed or flat tool over picked faces."""

import math
from dataclasses import dataclass

from evenload import compiled, host
from evenload import tool as tools
from evenload.geometry import facets, guides
from evenload.operations import base, checks, chip_control, compute, job_model, registry
from evenload.operations.following import assign
from evenload.operations.refusal import Cancelled
from evenload.operations.seen import settings_of
from evenload.settings import parameters, ranges
from evenload.settings.notes import KEPT_OFF
from evenload.settings.results import FINISHING_RESULTS
from evenload.settings.table import BETWEEN_GUIDES, EVEN_CUSPS, FINISHING
from evenload.waiting import Stopped

NAME = "EvenLoad Finishing"
COARSEST = (
    0.05  # mm by which triangles leave fixtures, for which the tool stays as much further off
)


@dataclass
class Task:
    """The operation as it was read: what the core needs, and no document."""

    facets: object  # facets.Facets
    settings: object  # by their names, as settings_of() of seen.py has them
    tool: object  # tool.Tool
    data: object  # tool.CuttingData
    arguments: dict  # of the core's finish()
    notes: list  # sentences for the report

    def run(self, watch):
        """The Computation. watch: callable(share) -> whether to go on, or None. Raises ValueError
        with a sentence for what cannot be done, Cancelled where it was stopped.
        """
        mesh, asked = self.facets.mesh, chip_control.path_watch(self.settings, watch)
        finish = compiled.core().surface.finish(mesh, **self.arguments, progress=asked)
        if finish.toolpath.report.termination == "cancelled":
            raise Cancelled(0.0)
        toolpath, said = chip_control.fed(
            finish, mesh, self.settings, self.tool, self.data, self.arguments, watch
        )
        notes = self.notes + _notes(self.settings, self.tool, toolpath) + said + [KEPT_OFF]
        return Computation(self.facets, toolpath, finish, self.tool, self.data, notes)

    def is_same(self, other):
        """Whether another task makes the same path: it must be of the same triangles, which are
        made anew for each task.
        """
        return self is other


@dataclass
class Computation:
    """What the last successful run worked on; it is not saved with the document."""

    facets: object  # facets.Facets
    toolpath: object  # the core's
    finish: object  # the core's Finish
    tool: object  # tool.Tool
    data: object  # tool.CuttingData
    notes: list  # sentences for the report


class Finishing(base.Operation):
    """Proxy of the finishing operation. Documents refer to this class by its module and name: both
    stay.
    """

    name = NAME
    settings = FINISHING
    results = FINISHING_RESULTS

    def opFeatures(self, obj):
        return host.surface_features()

    # ---- settings ----

    def opOnChanged(self, obj, prop):
        super().opOnChanged(obj, prop)
        if not self.is_wish(obj):
            return
        if prop in ("Stepover", "ToolController"):
            self._set_cusp_height(obj)
        elif prop == "CuspHeight":
            self._set_stepover(obj)

    def follow_tool(self, obj, again=()):
        super().follow_tool(obj, again)
        # A cusp height that is asked for and cannot be stays, to be refused.
        can_be = not wants_even_cusps(obj) or 0 < obj.CuspHeight.Value <= _end_radius(obj)
        if "Stepover" not in obj.OwnValues or can_be:
            self._set_cusp_height(obj)

    def _set_cusp_height(self, obj):
        corner, stepover = _end_radius(obj), obj.Stepover.Value
        height = cusp_height_of(stepover, corner) if stepover / 2 <= corner else 0.0
        self.quietly(obj, "CuspHeight", height)

    def _set_stepover(self, obj):
        corner, height = _end_radius(obj), obj.CuspHeight.Value
        if 0 < height <= corner:
            self.quietly(obj, "Stepover", stepover_of(height, corner))
        if "Stepover" not in obj.OwnValues:
            obj.OwnValues = obj.OwnValues + ["Stepover"]

    # ---- depths ----

    def updateDepths(self, obj, ignoreErrors=False):
        """OpStartDepth: the top of stock and models. OpFinalDepth: the bottom of the models, below
        which the tool's tip never goes.
        """
        if not self._setBaseAndStock(obj, ignoreErrors):
            return False
        box = self.stock.Shape.BoundBox
        models = [m.Shape.BoundBox for m in self.model if not m.Shape.isNull()]
        for name, value in (
            ("OpStockZMin", box.ZMin),
            ("OpStockZMax", box.ZMax),
            ("OpFinalDepth", min((m.ZMin for m in models), default=box.ZMin)),
            ("OpStartDepth", max([box.ZMax, *(m.ZMax for m in models)])),
        ):
            assign(obj, name, value)
        return True

    def check_settings(self, obj, tool, data):
        check(obj, tool)
        chip_control.check(obj, tool, data)

    # ---- running ----

    def read_tool(self, obj):
        return tools.read(obj.ToolController, takes_balls=True)

    def result_values(self, done):
        report = done.toolpath.report
        return {
            "CuttingTime": report.cutting_time,
            "Passes": report.passes,
            "Links": report.links,
            "Retracts": report.retracts,
            "PathLength": report.cut_length + report.link_length,
            "LeastStepover": done.finish.least_stepover,
            "LargestStepover": done.finish.largest_stepover,
        }

    def tell_cancelled(self, obj, error):
        """There is no more to tell."""

    def _prove(self, obj):
        """The path was made from the models themselves, all of them."""

    def read(self, op, seen=None):
        obj = op if seen is None else seen
        tool, data = self.read_tool(obj)
        compute.refuse_turned_work_plane(obj)
        self.check_settings(obj, tool, data)
        job = host.parent_job(op)
        picked = of_models(job, obj.Base)
        faces, lines = faces_of(picked), _lines(picked, obj.Strategy)
        try:
            found = facets.of(faces, job.Model.Group, obj.Tolerance.Value)
        except Stopped:
            raise Cancelled(0.0) from None
        _check_heights(obj, found)
        return Task(
            found,
            settings_of(obj, self.settings),
            tool,
            data,
            {**arguments_of(obj, tool, data, found), **lines, **_fixtures(obj, job)},
            compute.spindle_notes(obj, data),
        )


def cusp_height_of(stepover, radius):
    """mm between two passes of a level face, up to twice the radius of the tool's end apart."""
    half = stepover / 2
    return radius - math.sqrt((radius - half) * (radius + half))


def stepover_of(cusp_height, radius):
    """mm between two passes of a level face that leave a cusp, no higher than the radius."""
    return 2 * math.sqrt(cusp_height * (2 * radius - cusp_height))


def _end_radius(obj):
    return tools.end_radius(obj.ToolController) if obj.ToolController else 0.0


def wants_even_cusps(obj):
    """Whether the passes' distances follow a cusp height."""
    return obj.Spacing == EVEN_CUSPS


def of_models(job, picked):
    """Base geometry in which faces of the job's originals, as macros name them, are its models'."""
    return [
        (model, [element])
        for obj, names in picked
        for name in names or ("",)
        for model, element in (job_model.of(job, obj, name),)
    ]


def faces_of(base):
    """The faces of base geometry, which may have guides beside them; all of it where there is none,
    to be refused.
    """
    return [(obj, names) for obj, names in base if names[0].startswith("Face")] or base


def _lines(base, strategy):
    """{"guides": the lines of what is no face} where the strategy has guides; others leave them
    aside.
    """
    if strategy not in BETWEEN_GUIDES:
        return {}
    return {"guides": guides.of([each for each in base if not each[1][0].startswith("Face")])}


def check(obj, tool):
    """Raises ValueError for settings that cannot be used, and for a distance of passes that the
    tool cannot have.
    """
    ranges.check(obj, FINISHING)
    if obj.Stepover.Value > tool.diameter:
        raise ValueError(
            "Stepover is %g mm, more than the tool's diameter of %g mm: lower it."
            % (obj.Stepover.Value, tool.diameter)
        )
    if not wants_even_cusps(obj):
        return
    corner = tool.end_radius
    if not corner > 0:
        raise ValueError(
            "Spacing is '%s', but the tool '%s' has a flat end, which leaves steps: take a ball "
            "end mill, or another Spacing." % (EVEN_CUSPS, tool.name)
        )
    if not 0 < obj.CuspHeight.Value <= corner:
        raise ValueError(
            "CuspHeight is %g mm: it must lie between 0 and the %g mm of the tool's radius at its "
            "end." % (obj.CuspHeight.Value, corner)
        )


def _fixtures(obj, job):
    """{keyword: value} of the core's finish(), of what the tool keeps off besides the models."""
    if not obj.Fixtures:
        return {}
    try:
        mesh, deflection, top = facets.fixtures(
            obj.Fixtures, job.Model.Group, max(obj.Tolerance.Value, COARSEST)
        )
    except Stopped:
        raise Cancelled(0.0) from None
    clearance = obj.FixtureClearance.Value + deflection
    if obj.SafeHeight.Value < top + clearance:
        raise ValueError(
            "SafeHeight (%g mm) lies below the top of the fixtures and their clearance (%g mm): "
            "raise it." % (obj.SafeHeight.Value, round(top + clearance, 3))
        )
    return {"fixtures": mesh, "fixture_clearance": clearance}


def _check_heights(obj, found):
    start, final = obj.StartDepth.Value, obj.FinalDepth.Value
    if not start > final:
        raise ValueError(
            "StartDepth (%g mm) does not lie above FinalDepth (%g mm): raise StartDepth or lower "
            "FinalDepth." % (start, final)
        )
    checks.heights(obj, start)
    if obj.SafeHeight.Value < found.highest:
        raise ValueError(
            "SafeHeight (%g mm) lies below the top of the models (%g mm): raise it."
            % (obj.SafeHeight.Value, round(found.highest, 3))
        )


def arguments_of(obj, tool, data, found):
    """Keyword arguments of the core's finish(), but for `progress`; mm, rad, mm/min."""
    arguments = {
        **parameters.of(obj, FINISHING),
        "tool_diameter": tool.diameter,
        "corner_radius": tool.end_radius,
        "tolerance": obj.Tolerance.Value - found.deflection,
        "deflection": found.deflection,
        "floor": obj.FinalDepth.Value,
        "top": obj.StartDepth.Value,
        "safe_height": obj.SafeHeight.Value,
        "clearance_height": obj.ClearanceHeight.Value,
        "feed": data.feed,
        "plunge_feed": data.plunge_feed,
        "rapid_feed": data.rapid_feed or tools.ASSUMED_RAPID,
        "cut_mode": compute.core_cut_mode(obj, data),
    }
    if wants_even_cusps(obj):
        arguments["cusp_height"] = obj.CuspHeight.Value
    return arguments


def _notes(obj, tool, toolpath):
    lowest = min(move[3] for move in toolpath.moves)
    depth = obj.StartDepth.Value - lowest
    notes = []
    if tool.cutting_length and depth > tool.cutting_length + 1e-6:
        notes.append(
            "The path goes %g mm below StartDepth, and the tool '%s' cuts over %g mm of its "
            "length: see that its shank stays off the part."
            % (round(depth, 3), tool.name, tool.cutting_length)
        )
    if lowest <= obj.FinalDepth.Value + 1e-6:
        notes.append(
            "FinalDepth (%g mm) keeps the tool's tip up: lower it if more of the faces is to be "
            "reached." % obj.FinalDepth.Value
        )
    return notes


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new finishing operation, as a document object; see registry.create for the arguments."""
    return registry.create(Finishing, name, obj, parentJob, toolController)


registry.register(Finishing, Create)
