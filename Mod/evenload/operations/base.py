"""What all operations have in common, as FreeCAD's proxies: properties, base geometry and depths,
and what becomes of a computed path. `compute` has the way from there to the path.
"""

import math

import FreeCAD
import Path

from evenload import commands, host, waiting, window
from evenload import tool as tools
from evenload.geometry import shape
from evenload.operations import chatter, checks, compute, computing, job_model, rest
from evenload.operations.following import assign
from evenload.operations.refusal import Cancelled, Refusal
from evenload.settings import properties
from evenload.settings.labels import told
from evenload.settings.notes import CHECKED
from evenload.settings.results import HIDDEN_SETTINGS, RESULT_SETTINGS
from evenload.settings.table import REST_MACHINING, SETTINGS
from evenload.simulation import proof
from evenload.words import clock

SENTENCES = (ValueError, ImportError)  # exceptions that say all that the user needs


class Operation(computing.Computing):
    """Proxy of an operation. A subclass says in `generate` which of the core's strategies it is."""

    name = ""  # under which the SetupSheet knows the operation
    settings = SETTINGS
    results = RESULT_SETTINGS
    fitted = ()  # names of settings that show what was chosen for the geometry, unless they are set

    # Restored proxies come into being without __init__.
    last = None
    _wished_controller = None

    def __init_subclass__(cls):
        cls.fitted = tuple(row.name for row in cls.settings if row.fitted)

    def __init__(self, obj, name, parentJob=None, toolController=None):
        self._wished_controller = toolController
        super().__init__(obj, self.name or name, parentJob)
        if isinstance(obj, FreeCAD.DocumentObject):
            self.set_side_step(obj)  # the SetupSheet has set its defaults in the meantime

    # ---- properties ----

    def opFeatures(self, obj):
        return host.features()

    def initOperation(self, obj):
        if isinstance(obj, FreeCAD.DocumentObject):
            for row in (*self.settings, *self.results, *HIDDEN_SETTINGS):
                properties.add(obj, row)
            self._set_editor_modes(obj)
            return
        # FreeCAD's stand-in for an operation, which the SetupSheet asks.
        for row in self.settings:
            if row.in_setup_sheet():
                properties.add_to_prototype(obj, row)

    def _set_editor_modes(self, obj):
        for setting in self.results:
            obj.setEditorMode(setting.name, 1)  # read-only
        for setting in HIDDEN_SETTINGS:
            obj.setEditorMode(setting.name, 2)

    def opOnDocumentRestored(self, obj):
        self.is_changing = True
        try:
            self.initOperation(obj)
        finally:
            self.is_changing = False
        show(obj)

    def setDefaultValues(self, obj):
        with host.chosen_tool_controller(self._wished_controller):
            return super().setDefaultValues(obj)

    def opSetDefaultValues(self, obj, job):
        if self._wished_controller is not None:
            obj.ToolController = self._wished_controller
        obj.OpToolDiameter = tools.diameter(obj.ToolController)
        self.follow_tool(obj)
        self.set_side_step(obj)

    def opOnChanged(self, obj, prop):
        if not self.is_wish(obj):
            return
        if prop in self.own_names() and hasattr(obj, "OwnValues"):
            if prop not in obj.OwnValues:
                obj.OwnValues = obj.OwnValues + [prop]
        elif prop == "ToolController":
            self.follow_tool(obj)
        elif prop == "EngagementAngle":
            self.set_side_step(obj)
        elif prop == "SideStep":
            self.set_angle(obj)
        elif prop == REST_MACHINING.name and hasattr(obj, "EarlierOperations"):
            job = host.parent_job(obj)
            if job is not None:
                rest.link_all(job)

    # ---- base geometry and depths ----

    def sanitizeBase(self, obj):
        """FreeCAD would clear base geometry that is no longer there, and stumbles over whole
        sketches; we keep it, and say in execute what is missing.
        """
        return False

    def addBase(self, obj, base, sub):
        """Adds a face, an edge or, with sub '', a whole sketch; of what the job's models are made
        from, their own faces and edges. Doubles are left out.
        """
        entries = [(o, name) for o, names in obj.Base for name in (names or ("",))]
        if self._setBaseAndStock(obj, True):
            base, sub = job_model.of(self.job, base, sub)
        if (base, sub) not in entries:
            obj.Base = [*entries, (base, sub)]

    def updateDepths(self, obj, ignoreErrors=False):
        """OpStartDepth: the top of the stock. OpFinalDepth: the lowest of the base geometry, or
        the top of the model.
        """
        if not self._setBaseAndStock(obj, ignoreErrors):
            return False
        box = self.stock.Shape.BoundBox
        assign(obj, "OpStockZMin", box.ZMin)
        assign(obj, "OpStockZMax", box.ZMax)
        levels = shape.heights(obj.Base)
        tops = [m.Shape.BoundBox.ZMax for m in self.model if not m.Shape.isNull()]
        final = min(levels) if levels else max(tops, default=box.ZMin)
        start = max([box.ZMax, *tops])
        if start <= final + 1e-4:
            start = final + (obj.StepDown.Value or 1.0)
        assign(obj, "OpFinalDepth", final)
        assign(obj, "OpStartDepth", start)
        return True

    def refusal(self, obj):
        """The sentence why no path can be computed with an operation's settings, None where one
        may be; its geometry is not looked at, nor depths that follow it.
        """
        try:
            self._check_job(obj)
            self.check_settings(obj, *self.read_tool(obj))
        except SENTENCES as error:
            return told(str(error))
        return None

    def check_settings(self, obj, tool, data):
        """Raises ValueError for settings that no path can be computed with."""
        checks.as_set(obj, self.settings, tool, data)

    # ---- running ----

    def execute(self, obj):
        """Computes the path. On any error and when it is cancelled the path is emptied, Report says
        why, and the operation becomes invalid.
        """
        self.last = None
        try:
            if obj.Active:
                self._check_job(obj)
                self.follow_tool(obj)
            else:
                self._clear_results(obj)
            with self._asked_all_along(obj):
                result = super().execute(obj)
                self.let_the_window_work()
                if self.last is not None and not len(self.last.toolpath):
                    obj.Path = Path.Path()  # without the rapid at its end
                elif self.last is not None:
                    self._prove(obj)
                    self._tell_cycle_time(obj)
            return result
        except Exception as error:
            ours = not isinstance(error, SENTENCES)
            sentence = "EvenLoad failed: %s." % host.named(error) if ours else told(str(error))
            self.empty(obj, sentence)
            rest.empty_after(obj)
            if ours:
                raise
            if isinstance(error, Cancelled):
                self.tell_cancelled(obj, error)
                obj.Path = Path.Path([Path.Command(NOTHING_IS_CUT)])
            raise Refusal(sentence) from None

    def tell_cancelled(self, obj, error):
        """Sets the results of an operation that was stopped, after they were cleared."""
        obj.UncutArea = error.uncut_area

    def empty(self, obj, why):
        """Leaves nothing that could pass for a computed operation: no path, no times, no results;
        Report says why.
        """
        self.last = None
        obj.Path = Path.Path()
        obj.CycleTime = ""
        self._clear_results(obj)
        obj.Report = why

    def opExecute(self, obj):
        done = self.computed(obj)
        # FreeCAD itself ends every operation at the clearance height.
        last = obj.ClearanceHeight.Value
        self.commandlist.extend(commands.from_moves(done.toolpath, left_out_from=last))
        self.let_the_window_work()  # FreeCAD's own part, which follows, asks nobody
        self.last = done
        self._set_results(obj, done)

    def _prove(self, obj):
        """Refuses a path with faults, and says in Report whether it was checked, and chatters."""
        try:
            faults = proof.check(obj) if obj.Check else []
            warnings = [] if faults else chatter.notes(obj)
        except waiting.Stopped:
            raise Cancelled(compute.area_of(obj, self.last)) from None
        if faults:
            raise ValueError(faults[0].sentence)
        said = CHECKED if obj.Check else proof.UNCHECKED
        obj.Report = "\n".join(filter(None, [*map(told, warnings), obj.Report, said]))

    def _tell_cycle_time(self, obj):
        """FreeCAD's estimate knows no feeds but the tool controller's; the job sums up ours."""
        obj.CycleTime = clock(obj.CuttingTime)
        self.job.Proxy.getCycleTime()

    def result_values(self, done):
        """{name: value} of the results of a Computation, and of fitted settings; mm, degrees, s."""
        report = done.toolpath.report
        return {
            "MaxEngagement": math.degrees(report.max_engagement),
            "CuttingTime": report.cutting_time,
            "IdealTime": report.ideal_time,
            "RemovedVolume": report.removed_volume,
            "UncutArea": report.uncut_area,
            "Passes": report.passes,
            "Links": report.links,
            "Retracts": report.retracts,
            **done.own,
        }

    def _set_results(self, obj, done):
        for name, value in self.result_values(done).items():
            self.quietly(obj, name, value)
        obj.Report = "\n".join(map(told, done.notes))

    def _clear_results(self, obj):
        for setting in self.results:
            setattr(obj, setting.name, setting.value)


NOTHING_IS_CUT = "(Cancelled: nothing is cut here)"  # what is posted for a cancelled operation


def show(obj):
    """With a GUI, gives an operation that a script made its view provider. The SetupSheet's
    stand-in for an operation is shown nowhere.
    """
    if window.show is not None and isinstance(obj, FreeCAD.DocumentObject):
        window.show(obj)
