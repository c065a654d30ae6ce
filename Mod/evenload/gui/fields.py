"""The fields of panels: a widget for each kind of setting, with its limits and its step."""

import FreeCAD
import FreeCADGui
from PySide import QtGui

from evenload.gui.slots import slot
from evenload.units import INCH
from evenload.settings.setting import (
    ANGLE,
    BOOL,
    CHOICE,
    INTEGER,
    LENGTH,
    LINKS,
    NUMBER,
    NUMBERS,
    POINT,
    SPEED,
)

# Pixels that a row has in FreeCAD's dock as it is at first, 264 wide, beside a scroll bar: panels
# are to fit into it.
ROOM = 214
NARROWEST = 70  # pixels of a field
SPACING = 6  # pixels between a label and its field
# What quantities must have room for, with metric units and with inches, and pixels: of frame and
# margins, of arrows besides, of FreeCAD's icon.
LONGEST = {
    ANGLE: 2 * ("180.00 °",),
    LENGTH: ("00.00 mm", "0.0000 in"),
    SPEED: 2 * ("0000.00 mm/min",),
}
FRAME, AROUND, ICON = 12, 28, 12
DECIMALS = 4  # of numbers without a unit
MOST = 1_000_000  # of what is counted: no value that a macro set may be cut short here
# What one press of an arrow adds, in FreeCAD's own units, with metric units and with inches.
STEPS = {
    ANGLE: (1.0, 1.0),
    LENGTH: (0.05, 0.002 * INCH),
    POINT: (0.05, 0.002 * INCH),
    SPEED: (10 / 60, 0.5 * INCH / 60),
}
FINE_STEPS = 0.001, 0.0001 * INCH  # mm
FINE_DECIMALS = 4, 6  # in mm, in inches
FINE_MOST = 10.0  # mm
UNITS = "User parameter:BaseApp/Preferences/Units"
DIMENSIONS = {ANGLE: "Angle", LENGTH: "Length", POINT: "Length", SPEED: "Velocity"}


def widget_of(setting):
    """The field of a setting of any kind but POINT, for which there is `point_of`."""
    if setting.type == CHOICE:
        widget = combo_box()
        for choice in setting.value:
            widget.addItem(FreeCAD.Qt.translate("EvenLoad", choice), choice)
        make_room_for_choices(widget)
        return widget
    if setting.type == BOOL:
        return QtGui.QCheckBox(FreeCAD.Qt.translate("EvenLoad", setting.label))
    if setting.type == NUMBERS:
        widget = QtGui.QLineEdit()
        widget.setMinimumWidth(ROOM)
        if setting.unset:
            widget.setPlaceholderText(FreeCAD.Qt.translate("EvenLoad", setting.unset))
        return widget
    if setting.type == LINKS:
        return TakenObjects()
    if setting.is_fine:
        return FineBox()
    if setting.type == INTEGER:
        widget = QtGui.QSpinBox()
        widget.setMaximum(MOST)
    elif setting.type == NUMBER:
        widget = QtGui.QDoubleSpinBox()
        widget.setDecimals(DECIMALS)
        widget.setSingleStep(0.05)
    else:
        return quantity_box(setting.type, setting.range)
    if setting.unset:
        widget.setSpecialValueText(FreeCAD.Qt.translate("EvenLoad", setting.unset))
    if setting.range and setting.range.high is not None:
        widget.setMaximum(setting.range.high)
    widget.setMinimumWidth(NARROWEST)
    return widget


def point_of():
    """(a widget with two fields, the two): for X and Y of a place."""
    widget = QtGui.QWidget()
    row = QtGui.QHBoxLayout(widget)
    row.setContentsMargins(0, 0, 0, 0)
    boxes = [quantity_box(LENGTH), quantity_box(LENGTH)]
    for box in boxes:
        box.setProperty("unit", "mm")
        box.setMinimumWidth(NARROWEST)  # without FreeCAD's icon
        row.addWidget(box)
    return widget, boxes


def quantity_box(kind, limits=None):
    """FreeCAD's field for a quantity of a kind, which takes no value beyond the limits of a Range.
    Limits are in mm and degrees, and 0 the only one of speeds.
    """
    box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
    box.setMinimumWidth(needed_by(kind, box))
    if limits is not None:
        box.setProperty("minimum", float(limits.low))
        if limits.high is not None:
            box.setProperty("maximum", float(limits.high))
    return box


def needed_by(kind, widget):
    """Pixels that a quantity's field needs, in the font of a widget."""
    return max(NARROWEST, width_of(widget, LONGEST[kind][shows_inches()]) + AROUND + ICON)


def narrowest(field):
    """Pixels that a field must have at least."""
    return field.minimumWidth() or field.minimumSizeHint().width()


def combo_box():
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumWidth(NARROWEST)
    return box


def make_room_for_choices(box):
    """Has a box be as wide as the longest of its choices, as far as panels have room."""
    box.setMinimumWidth(min(max(NARROWEST, _needed_by_choices(box)), ROOM))


def _needed_by_choices(box):
    """Pixels that the longest choice of a box needs."""
    policy = box.sizeAdjustPolicy()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToContents)
    result = box.sizeHint().width()
    box.setSizeAdjustPolicy(policy)
    return result


def value_of(widget):
    """What a field but that of a quantity or a point holds; None where it cannot be read."""
    if isinstance(widget, QtGui.QComboBox):
        return widget.itemData(widget.currentIndex())
    if isinstance(widget, TakenObjects):
        return widget.objects
    if isinstance(widget, FineBox):
        return widget.mm()
    if isinstance(widget, QtGui.QAbstractSpinBox):
        return widget.value()
    if isinstance(widget, QtGui.QLineEdit):
        return values_in(widget.text())
    return widget.isChecked()


def show(widget, value, point=None):
    """Shows a property's value in a field but that of a quantity. point: the two fields of a
    POINT.
    """
    if point:
        for box, number in zip(point, (value.x, value.y)):
            box.setProperty("rawValue", number)
        return
    blocked = widget.blockSignals(True)
    if isinstance(widget, QtGui.QComboBox):
        widget.setCurrentIndex(widget.findData(value))
    elif isinstance(widget, TakenObjects):
        widget.set_objects(value)
    elif isinstance(widget, FineBox):
        widget.show_units()
        widget.set_mm(value.Value)
    elif isinstance(widget, QtGui.QAbstractSpinBox):
        widget.setValue(value)
    elif isinstance(widget, QtGui.QLineEdit):
        widget.setText("; ".join("%.12g" % each for each in value))
    else:
        widget.setChecked(value)
    widget.blockSignals(blocked)


def set_step(box, kind):
    """Has the arrows of a quantity's field add a sensible step, in the units that it shows now."""
    factor, unit = _shown_unit(kind, box.property("rawValue") or 0.0)
    box.setProperty("singleStep", float("%.3g" % (STEPS[kind][_is_inch(unit)] / factor)))


def edit_of(box):
    """Where a field's text is."""
    return box.findChild(QtGui.QLineEdit)


def show_unset(box, text, value):
    """Has a quantity's field show a text where its value is 0 and not rounded to that, unless it is
    edited.
    """
    edit = edit_of(box)
    edit.setPlaceholderText(FreeCAD.Qt.translate("EvenLoad", text))
    if value == 0 == box.property("rawValue") and not edit.hasFocus():
        blocked = edit.blockSignals(True)  # the value stays
        edit.clear()
        edit.blockSignals(blocked)


class FineBox(QtGui.QDoubleSpinBox):
    """A field for lengths that FreeCAD's decimals would round away; its values are mm."""

    # Each with metric units and with inches: names and their mm, decimals, steps in mm.
    names, factors = ("mm", "in"), (1.0, INCH)
    digits, steps = FINE_DECIMALS, FINE_STEPS

    def __init__(self, most=FINE_MOST):
        """most: mm."""
        super().__init__()
        self._most = most
        self.show_units()

    def show_units(self):
        """Takes the units that the user has chosen by now; the number stays as it is."""
        inches = shows_inches()
        self._factor, unit = self.factors[inches], self.names[inches]
        self.setDecimals(self.digits[inches])
        self.setSingleStep(self.steps[inches] / self._factor)
        self.setMaximum(self._most / self._factor)
        self.setSuffix(" " + unit)
        longest = "%.*f %s" % (self.digits[inches], 0.0, unit)
        self.setMinimumWidth(width_of(self, longest) + AROUND)

    def set_mm(self, value):
        self.setValue(value / self._factor)

    def mm(self):
        return self.value() * self._factor


class TakenObjects(QtGui.QPushButton):
    """A button that takes the objects which are selected when it is pressed, and lists them."""

    def __init__(self):
        super().__init__()
        self.setMinimumWidth(NARROWEST)
        self.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
        self.set_objects([])
        self.clicked.connect(slot(self._take))

    def set_objects(self, objects):
        self.objects = list(objects)
        names = ", ".join(each.Label for each in self.objects)
        # In a text of a button an ampersand marks a key.
        self.setText(names.replace("&", "&&") or FreeCAD.Qt.translate("EvenLoad", "none"))

    def _take(self):
        found = [each.Object for each in FreeCADGui.Selection.getSelectionEx()]
        self.set_objects(list(dict.fromkeys(found)))


def differs(before, value):
    """Whether a property's value is not the one that a field holds, where it is shown rounded."""
    if isinstance(before, FreeCAD.Vector):
        return (before.x, before.y) != value
    before = getattr(before, "Value", before)
    return (round(before, DECIMALS) if isinstance(before, float) else before) != value


def values_in(text):
    """The numbers in a text: between semicolons, where commas may be decimal ones, or else between
    commas or blanks. None where it holds anything else.
    """
    words = text.replace(",", ".").split(";") if ";" in text else text.replace(",", " ").split()
    try:
        return [float(word) for word in words if word.strip()]
    except ValueError:
        return None


def width_of(widget, text):
    """Pixels of a text in a widget."""
    return QtGui.QFontMetrics(widget.font()).boundingRect(text).width()


def units_shown():
    """How quantities are shown: the units, and the decimals that FreeCAD's preferences say."""
    units = tuple(_shown_unit(kind, INCH) for kind in DIMENSIONS)
    return (*units, decimals())


def decimals():
    """Of numbers with units, as FreeCAD's preferences say."""
    return FreeCAD.ParamGet(UNITS).GetInt("Decimals", 2)


def shows_decimal_inches():
    """Whether lengths are shown as decimal numbers of inches, not as fractions nor in feet."""
    return _shown_unit(LENGTH, INCH)[1] == "in"


def shows_inches():
    """Whether the user has chosen inches for lengths."""
    return _is_inch(_shown_unit(LENGTH, INCH)[1])


def _shown_unit(kind, value):
    """(what the unit is in FreeCAD's own, its name) in which a value of a kind is shown."""
    dimension = getattr(FreeCAD.Units, DIMENSIONS[kind])
    _, factor, unit = FreeCAD.Units.Quantity(value, dimension).getUserPreferred()
    return factor, unit


def _is_inch(unit):
    return unit.startswith(("in", "thou", "ft", "mil", '"', "'"))
