"""What an operation's page has of the live preview: its choice, and what the status tells of it."""

import FreeCAD

from evenload import host
from evenload.gui import page_form, preferences, preview
from evenload.gui.slots import telling_slot
from evenload.gui.status import FAILED, PREVIEW, WAITING, figures_of, state_of, values_of
from evenload.operations.checks import DEPTHS
from evenload.settings.labels import told
from evenload.settings.notes import fields_of

_translate = FreeCAD.Qt.translate

UP_TO_DATE = ["Up-to-date"]  # the State of a document object that no recompute computes


class PreviewPage(page_form.FormPage):
    """A page whose status tells of the operation, or of the preview while there is one."""

    preview = None  # until FreeCAD has made the page, and calls setClean for it
    is_followed = False  # whether what changes now is the user's doing: FreeCAD sets depths first
    is_accepted = False  # whether the panel closes by OK

    # ---- what FreeCAD calls ----

    def initPage(self, obj):
        # FreeCAD has not set the depths yet, which touches the operation.
        self.was_computed = obj.State == UP_TO_DATE
        others = "Base", "ToolController", "Active", "ExpressionEngine"
        self.followed = {*self.settings, *DEPTHS, *others}
        self.before = self._followed_values(obj)
        self.preview = preview.Preview(obj, self.show_status, self.form)

    def registerSignalHandlers(self, obj):
        self.live.toggled.connect(telling_slot(self._live_toggled))
        self.is_followed = True
        if not self.was_computed:
            self.preview.restart()

    def updateData(self, obj, prop):
        if self.is_followed and prop in self.followed:
            self.preview.restart()

    def setClean(self):
        """Apply, whose recompute takes what the preview shows, and does the rest itself."""
        super().setClean()
        if self.preview is not None and self.preview.state != preview.SHOWN:
            self.preview.clear()

    def cleanupPage(self, obj):
        """FreeCAD calls this as the panel closes; the operation may be gone by then."""
        is_there = self.preview.close(is_kept=self.is_accepted)
        if not is_there or not self.was_computed or self.is_accepted:
            return
        # An undo while the panel was open ends the step that Cancel takes back.
        if self._followed_values(obj) == self.before:
            # All of it is as it was, the path too: there is nothing to compute.
            obj.purgeTouched()

    def _followed_values(self, obj):
        """{property: its value} of all that the path follows."""
        return {name: getattr(obj, name) for name in sorted(self.followed) if hasattr(obj, name)}

    # ---- what it shows ----

    def figures(self, values):
        """What the status tells of the results of a path, see status.figures_of()."""
        return figures_of(values)

    def show_status(self):
        obj, shown = self.obj, self.preview
        if shown.state is None:
            state, sentence = state_of(obj, self.isdirty)
            self.status.show(state, sentence, *self._stored())
            self._mark(obj.Report if not obj.isValid() and not self.isdirty else "")
        elif shown.state == preview.REFUSED:
            self.status.show(FAILED, shown.sentence)
            self._mark(shown.sentence)
        elif shown.state == preview.COMPUTING:
            computing = _translate("EvenLoad", "Changed: computing the path")
            self.status.show(WAITING, computing, *(self._previewed() or self._stored()))
            self.marks.clear()
        else:
            sentence = _translate("EvenLoad", "Preview: Apply checks and stores the path")
            self.status.show(PREVIEW, sentence, *self._previewed())
        self.load.setEnabled(host.path_size(obj) > 1)

    def _stored(self):
        """(figures, sentences) of the operation's own path."""
        said = self.obj.Report.splitlines() if self.obj.isValid() else []
        return self.figures(values_of(self.obj)), said

    def _previewed(self):
        """The same of the last preview; None without one."""
        done = self.preview.done
        if done is None:
            return None
        return self.figures(self.obj.Proxy.result_values(done)), list(map(told, done.notes))

    def _mark(self, sentence):
        """Marks the first field of this page that a sentence names."""
        for name in self._fields_of(sentence)[:1]:
            self.marks.set(self.labels[name])

    def _fields_of(self, sentence):
        """Those fields of this page that a sentence names."""
        return [name for name in fields_of(sentence) if name in self.labels]

    def _live_toggled(self, is_wanted):
        preferences.keep_live_preview(is_wanted)
        if not is_wanted:
            self.preview.clear()
        elif self.isdirty or not self.was_computed:
            self.preview.restart()
