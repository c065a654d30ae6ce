"""What the panels of all operations share: base geometry, settings, results."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import host
from evenload import tool as tools
from evenload.gui import fields, load_view, optimise, preferences, recording, view3d
from evenload.gui.base_page import BaseGeometryPage
from evenload.gui.settings_page import SettingsPage
from evenload.gui.slots import slot
from evenload.gui.status import FAILED
from evenload.operations.base import SENTENCES
from evenload.settings.sentences import shown

_gui = host.gui()
_translate = FreeCAD.Qt.translate

NARROWEST_BUTTON = 36  # pixels beside the frame
NARROW = "; icon-size: 0px; padding-left: 6px; padding-right: 6px"
BESIDE_BUTTONS_TEXT = 36  # pixels: icon, frame, what is between buttons


def create(operation):
    """Creates the operation of a module for what is selected and opens its panel, in one undoable
    step. None where there is no job for it, or where the user cancels the choice of the job or of
    its tool controller.
    """
    doc = FreeCAD.ActiveDocument
    job = host.job_for_selection()
    if job is None:
        return None
    name = _translate("EvenLoad", operation.NAME)
    doc.openTransaction(_translate("EvenLoad", "Create %s") % name)
    try:
        obj = operation.Create(operation.NAME.replace(" ", ""), parentJob=job)
        obj.ViewObject.Proxy.deleteOnReject = True  # Cancel in its first panel takes it away again
        obj.ViewObject.Visibility = True
        preferences.set_defaults(obj)
    except host.no_tool_chosen():
        doc.abortTransaction()
        return None
    except SENTENCES as error:
        doc.abortTransaction()
        told = _translate("EvenLoad", "%s was not created: %s") % (name, shown(str(error)))
        FreeCAD.Console.PrintError(told + "\n")
        return None
    except Exception:  # a bug, which keeps its traceback
        doc.abortTransaction()
        raise
    doc.commitTransaction()
    obj.ViewObject.Document.setEdit(obj.ViewObject, 0)
    return obj


class OperationPage(SettingsPage):
    """The operation's settings and results, and what the user does with them."""

    taskPanelBaseGeometryPage = BaseGeometryPage

    # ---- what FreeCAD calls ----

    def setFields(self, obj):
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)
        self._show_settings(obj)
        self.show_status()

    def getFields(self, obj):
        self.updateToolController(obj, self.form.toolController)
        self.updateCoolant(obj, self.form.coolantController)
        for name in self.widgets:
            self._take(name)

    def registerSignalHandlers(self, obj):
        super().registerSignalHandlers(obj)
        self.form.toolController.activated.connect(slot(self._tool_chosen))
        self.form.coolantController.activated.connect(slot(self._coolant_chosen))
        self.load.clicked.connect(slot(self.toggle_view))
        self.connect_fields()
        if self.suggest is not None:
            self.suggest.clicked.connect(slot(self._suggest))
        if self.kind.fitted:
            self.again.clicked.connect(slot(self._fit_again))

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop in (*self.result_names, *self.kind.fitted):
            self._refresh.start()
        elif prop == "ExpressionEngine" and self.is_followed:
            self.is_bound_anew = True
            self._refresh.start()
            self.setDirty()

    def refresh(self):
        if self.is_bound_anew:
            self.is_bound_anew = False
            self.take_expressions()
        self._show_settings(self.obj)
        super().refresh()

    def modifyStandardButtons(self, buttonBox):
        """Has FreeCAD's buttons take less than the 80 pixels and more that each would have at
        least: they would make the panel wider than FreeCAD's narrow dock, which cuts off its right.
        """
        texts = [button.text() for button in buttonBox.buttons()]
        needed = sum(fields.width_of(buttonBox, text) + BESIDE_BUTTONS_TEXT for text in texts)
        # Languages with long words need the room of the icons, and of what FreeCAD 1.1's own style
        # leaves around the words.
        narrow = "" if needed <= fields.ROOM else NARROW
        style = "QPushButton { min-width: %dpx%s }" % (NARROWEST_BUTTON, narrow)
        buttonBox.setStyleSheet(style)

    def cleanupPage(self, obj):
        super().cleanupPage(obj)
        self._refresh.stop()
        self.end_fields()
        for pick in (self.hole, self.open_side):
            if pick is not None:
                pick.end()

    def setDirty(self):
        super().setDirty()
        self.show_status()

    def setClean(self):
        super().setClean()
        self.marks.clear()
        self._refresh.start()

    def resetToolController(self, job, tc):
        """FreeCAD calls this for a tool controller that the user has just made."""
        super().resetToolController(job, tc)
        if self.obj is not None:
            self._show_new_tool()

    def may_close(self):
        """Takes what is edited, and tells whether it can be used: a panel with values that no path
        can be computed from is not left by OK, and says what is wrong. What it is
        left with is told to FreeCAD's macro recorder.
        """
        self.getFields(self.obj)
        refusal = self.obj.Proxy.refusal(self.obj)
        if refusal:
            self._show_refusal(refusal)
        self.is_accepted = not refusal
        if self.is_accepted:
            recording.record(self.obj)
        return self.is_accepted

    # ---- what the user does ----

    def updateToolController(self, obj, combo):
        """Takes what is chosen; without any tool controller in the job the refusal says so."""
        if host.parent_job(obj) is not None and host.parent_job(obj).Tools.Group:
            super().updateToolController(obj, combo)

    def _tool_chosen(self):
        self.updateToolController(self.obj, self.form.toolController)
        self._show_new_tool()

    def _show_new_tool(self):
        self._show_settings(self.obj)
        self.setDirty()

    def _coolant_chosen(self):
        self.updateCoolant(self.obj, self.form.coolantController)
        self.setDirty()

    def _fit_again(self):
        self.obj.Proxy.follow_tool(self.obj, again=self.kind.fitted)
        self._show_settings(self.obj)
        self.setDirty()

    def take_hole(self, hole):
        x, y, diameter = hole
        self.obj.EntryPoint = FreeCAD.Vector(x, y, self.obj.EntryPoint.z)
        if diameter is not None:
            self.obj.HoleDiameter = diameter
        self._show_settings(self.obj)
        self.setDirty()

    def take_open_side(self, place):
        self.obj.ChooseOpenSide = True
        self.obj.OpenSideAt = FreeCAD.Vector(*place, self.obj.OpenSideAt.z)
        self._show_settings(self.obj)
        self.setDirty()

    def toggle_view(self):
        """Shows what the simulator tells of the path, or ends that."""
        load_view.toggle(self.obj)

    def _suggest(self):
        optimise.show(self.obj)

    def show_taken(self):
        """Shows what was set in operation and tool controller while the panel is open."""
        self.obj.Proxy.follow_tool(self.obj)
        controller = self.obj.ToolController
        if controller is not None and self.form.toolController.currentText() != controller.Label:
            self.setupToolController(self.obj, self.form.toolController)
        host.show_controller(self)
        self._show_new_tool()
        self.preview.restart()  # it does not follow the tool controller

    def follow(self, piece):
        """Goes to the place or the field that a note names."""
        if piece.field:
            self._go_to_field(piece.field)
            return
        x, y, z = piece.place
        z = self.obj.FinalDepth.Value if z is None else z
        view3d.fly_to(self.obj.Document, (x, y, z), tools.diameter(self.obj.ToolController))

    def _go_to_field(self, name):
        """Shows and marks the field of a property of the operation, on whichever page it is."""
        if name in self.widgets:
            for fold in self.folds.values():
                if fold.isAncestorOf(self.widgets[name]):
                    fold.unfold()
            self.marks.set(self.labels[name])
            self.widgets[name].setEnabled(True)  # it may have to be mended without having an effect
            self.widgets[name].setFocus()
            # What was unfolded must have its place first.
            QtGui.QApplication.sendPostedEvents(None, QtCore.QEvent.LayoutRequest)
            self.area.ensureWidgetVisible(self.widgets[name])
        elif self.parent is not None:
            host.show_field(self.parent, name)

    def _show_refusal(self, refusal):
        self._show_settings(self.obj)  # the value that is refused may come from elsewhere
        self.status.show(FAILED, refusal)
        for name in self._fields_of(refusal)[:1]:
            self._go_to_field(name)
