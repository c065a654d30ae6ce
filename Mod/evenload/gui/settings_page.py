"""What an operation's page shows of the settings, and takes from their fields."""

import FreeCAD
from PySide import QtGui

from evenload import host
from evenload.gui import bound_fields, fields
from evenload.gui.length_box import UnitsWatch
from evenload.gui.preview_page import PreviewPage
from evenload.gui.rounded_length import RoundedLength, is_rounded
from evenload.gui.stepping import Stepping
from evenload.gui.slots import slot
from evenload.operations.following import bound
from evenload.operations.seen import Seen
from evenload.settings.setting import LENGTH, POINT, UNITS
from evenload.settings.table import HOLE_ENTRIES

_gui = host.gui()
_translate = FreeCAD.Qt.translate

EDITED = (QtGui.QAbstractSpinBox, QtGui.QLineEdit)  # widgets that tell when their text is done


class SettingsPage(PreviewPage):
    """A page whose fields are the operation's settings.

    What is edited goes into the properties at once, so that the two that follow each other can; the
    path is computed at Apply and OK.
    """

    steppings, units_watch = (), None  # until FreeCAD has the page connected
    lengths = {}  # the RoundedLength of each field, by settings
    has_ended = False  # whether nothing that is done in the fields is taken any more
    units = None  # what quantities were shown in
    is_bound_anew = False  # whether expressions have changed since their values were taken

    def initPage(self, obj):
        super().initPage(obj)
        for name, widget in self.widgets.items():
            setting = self.settings[name]
            if setting.type in UNITS and not setting.is_fine:
                self.boxes[name] = _gui.util.QuantitySpinBox(widget, obj, name)
        self.lengths = {
            name: [
                RoundedLength(box, self.settings[name].range, obj.evalExpression)
                for box in self._boxes(name)
            ]
            for name in (*self.boxes, *self.points)
            if self.settings[name].type in (LENGTH, POINT)
        }

    def connect_fields(self):
        """Has what is done in the fields taken."""
        self.steppings = []
        self.units_watch = UnitsWatch(self.form, self._units_changed)
        if self.engagement is not None:
            self.engagement.share.editingFinished.connect(slot(self._share_edited))
            self.steppings.append(Stepping(self.engagement.share, self._share_edited))
        for name, widget in self.widgets.items():
            take = slot(self._take, name)
            if name in (*self.boxes, *self.points):
                for box in self._boxes(name):
                    box.editingFinished.connect(take)
                    self.steppings.append(Stepping(box, self._take_step, name))
                    # FreeCAD writes its text anew whenever a field comes into view.
                    fields.edit_of(box).textChanged.connect(slot(self._show_text, name))
            elif isinstance(widget, EDITED):
                widget.editingFinished.connect(take)
                if not isinstance(widget, QtGui.QLineEdit):
                    self.steppings.append(Stepping(widget, self._take, name))
            elif isinstance(widget, QtGui.QComboBox):
                widget.activated.connect(take)
            elif isinstance(widget, fields.TakenObjects):
                widget.clicked.connect(take)
            else:
                widget.toggled.connect(take)

    def end_fields(self):
        """From now on nothing that is done in the fields is taken: Cancel may still go through
        them.
        """
        self.has_ended = True
        if self.units_watch is not None:
            self.units_watch.end()
        for each in self.steppings:
            each.end()

    # ---- what is taken ----

    def take_expressions(self):
        """Has settings the values of their expressions at once, as FreeCAD does in a recompute."""
        try:
            seen = Seen(self.obj)
        except ValueError:
            return  # the preview says which one cannot be evaluated
        for name in bound(self.obj) & {*self.settings}:
            value = getattr(seen, name)
            if hasattr(value, "Value") and value != getattr(self.obj, name):
                setattr(self.obj, name, value)

    def _share_edited(self):
        if not self.has_ended and self.engagement.take_share(self.obj):
            self._show_settings(self.obj)
            self.setDirty()

    def _take_step(self, name):
        """Takes what arrows, keys or the wheel have added; it is called, too, when FreeCAD has
        written a text anew, that of an expression among them.
        """
        if self.has_ended or self._units_changed():
            return
        if not is_rounded(self.settings[name].type):
            self._take(name)
        elif name not in bound(self.obj) and any(e.is_edited for e in self.lengths[name]):
            if not self._take_lengths(name):
                self._show_field(name)  # it stays at a limit

    def _take_lengths(self, name):
        """Sets a length or a point to what was edited in its fields; tells whether that is new."""
        held = self._lengths(name)
        lengths = [each.edited(length) for each, length in zip(self.lengths[name], held)]
        if lengths == held:
            return False
        if name in self.points:
            lengths = [FreeCAD.Vector(*lengths, getattr(self.obj, name).z)]
        setattr(self.obj, name, lengths[0])
        self._show_settings(self.obj)
        self.setDirty()
        return True

    def _take(self, name):
        """Takes what is edited in one widget into its property, and shows what follows from it."""
        if self.has_ended or self._units_changed():
            return
        obj, widget = self.obj, self.widgets[name]
        if name in self.shown and self._texts(name) == self.shown[name]:
            return  # what is shown is rounded, and is no new value until it is edited
        if name in self.lengths and is_rounded(self.settings[name].type):
            if name not in bound(obj) and not self._take_lengths(name):
                self._show_field(name)  # in place of what is no length, or beyond the limits
            return
        if name in self.boxes:
            changed = self.boxes[name].updateProperty()
            if not changed:  # a value beyond the limits, or the same: what holds is shown again
                self._show_settings(obj)
        else:
            value = self._point(name) if name in self.points else fields.value_of(widget)
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

    def _point(self, name):
        """(x, y) as the fields of a point hold them. One that is not edited shows a rounded number,
        and keeps its own.
        """
        edits = zip(self._boxes(name), self._lengths(name), self.shown.get(name, (None, None)))
        return tuple(
            held if box.property("text") == shown else float(box.property("rawValue"))
            for box, held, shown in edits
        )

    # ---- what it shows ----

    def _units_changed(self):
        """Shows all anew where the user has chosen other units or decimals since; tells whether."""
        if self.has_ended or self.units == fields.units_shown():
            return False
        self._show_settings(self.obj)
        self.show_status()
        return True

    def _show_settings(self, obj):
        self.units, self.shown = fields.units_shown(), {}
        for name in self.widgets:
            self._show_field(name)
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

    def _show_field(self, name):
        widget, setting = self.widgets[name], self.settings[name]
        if name in self.boxes:
            host.show_value(self.boxes[name])
        else:
            fields.show(widget, getattr(self.obj, name), self.points.get(name))
        if name in (*self.boxes, *self.points):
            for box in self._boxes(name):
                fields.set_step(box, setting.type)
            for each, length in zip(self.lengths.get(name, ()), self._lengths(name)):
                each.show(length, is_rounded(setting.type))
            self._show_text(name)
        if setting.is_fine or name in self.boxes or name in self.points:
            self.shown[name] = self._texts(name)

    def _show_text(self, name):
        """Shows a quantity or a point as we want it, where FreeCAD's fields have their own way."""
        if self.has_ended or self.units != fields.units_shown():
            return
        setting = self.settings[name]
        if setting.unset and name in self.boxes:
            fields.show_unset(self.widgets[name], setting.unset, getattr(self.obj, name).Value)
        if is_rounded(setting.type):
            for each, length in zip(self.lengths[name], self._lengths(name)):
                each.look(length)

    def _lengths(self, name):
        """What the fields of a length or a point are to hold, mm."""
        value = getattr(self.obj, name)
        return [value.x, value.y] if name in self.points else [value.Value]

    def _boxes(self, name):
        """The fields of a quantity or a point."""
        return self.points.get(name, [self.widgets[name]])

    def _texts(self, name):
        """What the boxes for a quantity or a point show."""
        return [box.property("text") for box in self._boxes(name)]
