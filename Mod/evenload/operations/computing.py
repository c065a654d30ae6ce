"""How an operation's proxy has its path computed: in a recompute, and for a preview."""

import contextlib

from evenload import host, waiting, window
from evenload import tool as tools
from evenload.geometry import body, depths, shape
from evenload.operations import compute, following
from evenload.operations.seen import Seen


class Computing(following.Following):
    """What all operations share of it."""

    partly_open = True  # whether it takes outlines that are open beside walls

    known = None  # (task, its Computation) that a preview has made, for runs of the same task
    # callable(share) -> bool, asked while the core works; False stops it. None: the GUI's dialog.
    progress = None
    _dialog = None

    def computed(self, obj):
        """The Computation of an operation: the known one where that is of what is asked for now."""
        task = self.read(obj)
        # It is kept: FreeCAD 1.1 may execute an operation twice in one recompute.
        if self.known is not None and self.known[0].is_same(task):
            return self.known[1]
        self.known = None
        return task.run(self.watch())

    def read(self, obj, seen=None):
        """The task of computing an operation; see compute.read()."""
        return compute.read(self, obj, seen)

    def preview(self, obj):
        """The same without touching the document, for an operation whose panel is open. Raises
        ValueError with a sentence where no path can be computed.
        """
        seen = Seen(obj)
        self._check_job(seen)
        return self.read(obj, seen)

    def read_tool(self, obj):
        """(tool.Tool, tool.CuttingData). Raises ValueError for a tool that it cannot work with."""
        return tools.read(obj.ToolController)

    def floors(self, obj, tool, slot=None):
        """The Floor of every region that the base geometry describes. slot: as for shape.floors.
        Raises ValueError with a sentence that names the geometry.
        """
        job = host.parent_job(obj)
        return shape.floors(
            obj.Base,
            [each.shape for _, each in body.models_of(job)],
            job.Stock.Shape,
            tool.diameter,
            obj.Tolerance.Value,
            slot,
            self.partly_open,
            lambda z, is_face: depths.depth_of(obj, z, is_face),
        )

    def generate(self, settings, core, regions, parameters):
        """(the core's toolpath for the regions, {name: value} of what else it tells: the results of
        this kind of operation, and its fitted settings)
        """
        raise NotImplementedError

    def results_of(self, cuts):
        """The second value of `generate` for all of an operation's cuts, by_depth.Cuts."""
        return cuts[0].own

    def watch(self):
        """What the core is to ask while it works: callable(share) -> whether to go on, or None."""
        self.let_the_window_work()  # what came before may have taken long
        return self.progress or self._dialog

    def let_the_window_work(self):
        """Between two things that take their time: with a GUI, has the window draw itself."""
        if self._dialog is not None:
            self._dialog(None)

    @contextlib.contextmanager
    def _asked_all_along(self, obj):
        """While this lasts, the GUI's dialog can be asked whether to go on: one for all that an
        operation does, so that it is there in time whatever takes long.
        """
        if self.progress is not None or window.watch is None:
            with waiting.asking(self.progress):
                yield
            return
        with window.watch(obj.Label) as self._dialog:
            try:
                with waiting.asking(self._dialog):
                    yield
            finally:
                self._dialog = None

    def _check_job(self, obj):
        job = host.parent_job(obj)
        if job is None:
            raise ValueError("'%s' belongs to no job: create it in one." % obj.Label)
        if not job.Model.Group:
            raise ValueError("The job '%s' has no model: add one to it." % job.Label)
        if job.Stock is None or job.Stock.Shape.isNull():
            raise ValueError("The job '%s' has no stock: give it one." % job.Label)
        self.read_tool(obj)
