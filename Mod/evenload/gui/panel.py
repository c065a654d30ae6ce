"""What the panels of all operations share: base geometry, settings, results."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import host
from evenload import tool as tools
from evenload.gui import bound_fields, fields, load_view, optimise, preferences, recording, view3d
from evenload.gui.base_page import BaseGeometryPage
from evenload.gui.preview_page import PreviewPage
from evenload.gui.slots import slot
from evenload.gui.status import FAILED
from evenload.gui.stepping import Stepping
from evenload.operations.base import SENTENCES
from evenload.settings.sentences import shown
from evenload.settings.setting import UNITS
from evenload.settings.table import HOLE_ENTRIES

_gui = host.gui()
_translate = FreeCAD.Qt.translate

NARROWEST_BUTTON = 36  # pixels beside the frame
NARROW = "; icon-size: 0px; padding-left: 6px; padding-right: 6px"
BESIDE_BUTTONS_TEXT = 36  # pixels: icon, frame, what is between buttons
EDITED = (QtGui.QAbstractSpinBox, QtGui.QLineEdit)  # widgets that tell when their text is done


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


class OperationPage(PreviewPage):
    """The operation's settings and results.

    What is edited goes into the properties at once, so that the two that follow each other can; the
    path is computed at Apply and OK.
    """

    taskPanelBaseGeometryPage = BaseGeometryPage
    steppings = ()  # until FreeCAD has the page connected

    # ---- what FreeCAD calls ----

    def initPage(self, obj):
        super().initPage(obj)
        for name, widget in self.widgets.items():
            setting = self.settings[name]
            if setting.type in UNITS and not setting.is_fine:
                self.boxes[name] = _gui.util.QuantitySpinBox(widget, obj, name)

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
        self.steppings = []
        self.form.toolController.activated.connect(slot(self._tool_chosen))
        self.form.coolantController.activated.connect(slot(self._coolant_chosen))
        self.load.clicked.connect(slot(self.toggle_view))
        if self.engagement is not None:
            self.engagement.share.editingFinished.connect(slot(self._share_edited))
            self.steppings.append(Stepping(self.engagement.share, self._share_edited))
        for name, widget in self.widgets.items():
            take = slot(self._take, name)
            if name in self.boxes or isinstance(widget, EDITED):
                widget.editingFinished.connect(take)
                if not isinstance(widget, QtGui.QLineEdit):
                    self.steppings.append(Stepping(widget, self._take, name))
            elif name in self.points:
                for box in self.points[name]:
                    box.editingFinished.connect(take)
                    self.steppings.append(Stepping(box, self._take, name))
            elif isinstance(widget, QtGui.QComboBox):
                widget.activated.connect(take)
            elif isinstance(widget, fields.TakenObjects):
                widget.clicked.connect(take)
            else:
                widget.toggled.connect(take)

        for name in self.boxes:
            # FreeCAD writes its text anew whenever a field comes into view.
            fields.edit_of(self.widgets[name]).textChanged.connect(slot(self._show_unset, name))
        if self.suggest is not None:
            self.suggest.clicked.connect(slot(self._suggest))
        if self.kind.fitted:
            self.again.clicked.connect(slot(self._fit_again))

    def updateData(self, obj, prop):
        super().updateData(obj, prop)
        if prop in (*self.result_names, *self.kind.fitted):
            self._refresh.start()

    def refresh(self):
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
        for each in self.steppings:
            each.end()
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

    def _tool_chosen(self):
        self.updateToolController(self.obj, self.form.toolController)
        self._show_new_tool()

    def _show_new_tool(self):
        self._show_settings(self.obj)
        self.setDirty()

    def _coolant_chosen(self):
        self.updateCoolant(self.obj, self.form.coolantController)
        self.setDirty()

    def _share_edited(self):
        if self.engagement.take_share(self.obj):
            self._show_settings(self.obj)
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

    def _take(self, name):
        """Takes what is edited in one widget into its property, and shows what follows from it."""
        obj, widget = self.obj, self.widgets[name]
        if name in self.shown and self._texts(name) == self.shown[name]:
            return  # what is shown is rounded, and is no new value until it is edited
        if name in self.boxes:
            changed = self.boxes[name].updateProperty()
            if not changed:  # a value beyond the limits, or the same: what holds is shown again
                self._show_settings(obj)
        else:
            value = fields.value_of(widget, self.points.get(name))
            if value is None:
                told = _translate("EvenLoad", "%s takes numbers, as 0; 0.1; 0.4; 1.")
                FreeCAD.Console.PrintError(told % self.labels[name].text() + "\n")
                self._show_settings(obj)
                return
            before = getattr(obj, name)
            changed = fields.differs(before, value)
            if changed and name in self.points:
                value = FreeCAD.Vector(*value, before.z)
            if changed:
                setattr(obj, name, value)
        if changed:
            self._show_settings(obj)
            self.setDirty()

    # ---- what it shows ----

    def _show_settings(self, obj):
        for name, widget in self.widgets.items():
            value, setting = getattr(obj, name), self.settings[name]
            if name in self.boxes:
                host.show_value(self.boxes[name])
                fields.set_step(widget, setting.type)
                self._show_unset(name)
            else:
                fields.show(widget, value, self.points.get(name))
        self.shown = {
            name: self._texts(name)
            for name, setting in self.settings.items()
            if setting.is_fine or name in self.boxes or name in self.points
        }
        held = bound_fields.held(obj, self.boxes)
        for setting in self.kind.settings:
            matters = setting.matters_to(obj)
            self.widgets[setting.name].setEnabled(matters and setting.name not in held)
            self.labels[setting.name].setEnabled(matters)
            self.widgets[setting.name].setToolTip(bound_fields.tip_of(setting, held))
        if self.engagement is not None:
            self.engagement.show_cut(obj)
        if self.hole is not None:
            self.hole.button.setEnabled(obj.Entry in HOLE_ENTRIES)
        if self.open_side is not None:
            self.open_side.button.setEnabled(obj.Entry == "Automatic")
        if self.kind.fitted:
            self.again.setEnabled(any(name in obj.OwnValues for name in self.kind.fitted))

    def _show_unset(self, name):
        if self.settings[name].unset:
            fields.show_unset(self.widgets[name], self.settings[name].unset)

    def _texts(self, name):
        """What the boxes for a quantity or a point show."""
        return [box.property("text") for box in self.points.get(name, [self.widgets[name]])]

    def _show_refusal(self, refusal):
        self._show_settings(self.obj)  # the value that is refused may come from elsewhere
        self.status.show(FAILED, refusal)
        for name in self._fields_of(refusal)[:1]:
            self._go_to_field(name)
