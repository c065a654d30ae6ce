"""The load view: a dock that colours an operation's path by what the simulator tells of it.

There is one at most. Until its command runs nothing of it exists; closing it removes all of it.
"""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host, simulation
from evenload.gui import load_colours, manual, preferences, progress, view3d
from evenload.gui.load_legend import Legend
from evenload.gui.length_box import UnitsWatch
from evenload.gui.load_node import LoadNode
from evenload.gui.observer import Observer
from evenload.gui.slots import slot, telling_slot
from evenload.gui.values import told
from evenload.settings.properties import is_ours
from evenload.settings.sentences import shown
from evenload.waiting import Stopped
from evenload.words import clock

NAME = "EvenLoadLoadView"  # of the dock
MOST_SAMPLES = 100_000  # along the path's length; longer paths are looked at more coarsely
FINEST = 0.1  # mm between samples
# Of the table of values at the slider's place: what it is, the value.
ROW = '<tr><td style="padding-right: 12px">%s</td><td align="right">%s</td></tr>'
OVER = 2.0  # degrees above the engagement angle from which on it stands out

_translate = FreeCAD.Qt.translate
_shown = []  # the LoadView that is there


def toggle(operation):
    """Shows the load of an operation, or hides it where it is the one that is shown."""
    before = _shown[0].operation if _shown else None
    close()
    if operation is not None and operation is not before:
        show(operation)


def show(operation):
    """Shows the load of an operation in its document's 3D view. None, with a sentence in the report
    view, where it cannot be simulated, or where that is stopped.
    """
    close()
    found = _told(lambda: simulated(operation))
    view = _told(lambda: LoadView(operation, found)) if found is not None else None
    if view is not None:
        _shown.append(view)
    return view


def _told(make):
    """What make() returns; None, with its sentence in the report view, where there is none."""
    try:
        return make()
    except ValueError as error:
        FreeCAD.Console.PrintError(shown(str(error)) + "\n")
        return None


def close():
    """Removes the load view, if there is one."""
    while _shown:
        _shown.pop().remove()


def simulated(operation):
    """The Simulation of an operation, None where the user stops it. Raises ValueError."""
    with progress.Watch(operation.Label) as watch:
        try:
            result = simulation.of(
                operation,
                step=step_of(operation),
                material=material_of(operation),
                progress=watch,
            )
        except Stopped:
            return None
    return None if result.cancelled else result


def step_of(operation):
    """mm between the samples along an operation's path."""
    return max(FINEST, operation.Path.Length / MOST_SAMPLES)


def material_of(operation):
    """The material whose force is shown: that of ours, the one that is preferred for others; None
    without a spindle speed.
    """
    controller = host.controller_of(operation)
    if controller is None or not controller.SpindleSpeed > 0:
        return None
    inner = host.operation_under(operation)
    return inner.Material if is_ours(inner) else preferences.material()


def values_at(found, number, time):
    """What a Simulation tells at a sample, as rich text; time: s of all samples."""
    rows = [(_translate("EvenLoad", "Time"), clock(float(time[number])))]
    for each in load_colours.MEASURES:
        values = load_colours.values_of(each, found)
        if each is not load_colours.KIND and values is not None:
            rows.append(
                (_translate("EvenLoad", each.title), told(each.quantity, float(values[number])))
            )
    return "<table>%s</table>" % "".join(ROW % row for row in rows)


class LoadView:
    """What shows the load of one operation: the node in the scene, and the dock."""

    def __init__(self, operation, found):
        self.operation, self.found, self.node = operation, found, None
        self._scene = view3d.scene_of(operation.Document)
        self._make_dock()
        self._observer = Observer([operation], ("Path",), telling_slot(self._changed))
        FreeCAD.addDocumentObserver(self._observer)
        self._units = UnitsWatch(self.dock, self._show_units)
        self._take(found)

    def remove(self):
        """Removes it from the scene and the window."""
        FreeCAD.removeDocumentObserver(self._observer)
        self._units.end()
        self._scene.removeChild(self.node.root)
        self.dock.hide()
        self.dock.deleteLater()

    def fly_to_worst(self):
        """Goes to the place with the largest value of what is shown."""
        number = load_colours.worst_of(self.measure, self.found)
        if number is not None:
            self.slider.setValue(number)
            place = self.found.x[number], self.found.y[number], self.found.z[number]
            document = self.operation.Document
            view3d.fly_to(document, map(float, place), self.found.tool_diameter)

    # ---- the dock ----

    def _make_dock(self):
        window = FreeCADGui.getMainWindow()
        self.dock = manual.Dock(_translate("EvenLoad", "Load of %s") % self.operation.Label, window)
        self.dock.setObjectName(NAME)
        self.dock.set_page("load_view")
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        self.choice = QtGui.QComboBox()
        self.legend = Legend()
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setToolTip(_translate("EvenLoad", "Moves the tool along the path"))
        self.told = QtGui.QLabel()
        self.told.setTextFormat(QtCore.Qt.RichText)
        self.worst = QtGui.QPushButton(_translate("EvenLoad", "Fly to the worst"))
        self.worst.setToolTip(_translate("EvenLoad", "Shows the place with the largest value"))
        for widget in (self.choice, self.legend, self.slider, self.told, self.worst):
            column.addWidget(widget)
        column.addStretch(1)
        self.dock.setWidget(content)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, self.dock)
        self.dock.show()
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.timeout.connect(slot(self._simulate_again))
        self.choice.currentIndexChanged.connect(slot(self._choose))
        self.slider.valueChanged.connect(slot(self._show_place))
        self.worst.clicked.connect(slot(self.fly_to_worst))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))

    def _take(self, found):
        """Shows a simulation of the operation in place of the one before, by the same measure."""
        if self.node is not None:
            self._scene.removeChild(self.node.root)
        self.found, self.node = found, LoadNode(found)
        self._scene.addChild(self.node.root)
        before = self.choice.itemData(self.choice.currentIndex())
        blocked = self.choice.blockSignals(True)
        self.choice.clear()
        for measure in load_colours.MEASURES:
            if measure is load_colours.KIND or self._has(measure):
                self.choice.addItem(_translate("EvenLoad", measure.title), measure.key)
        self.choice.setCurrentIndex(max(0, self.choice.findData(before)))
        self.choice.blockSignals(blocked)
        self.slider.setRange(0, len(found.x) - 1)
        self._choose()

    def _has(self, measure):
        return load_colours.values_of(measure, self.found) is not None

    @property
    def measure(self):
        """The Measure that is shown."""
        key = self.choice.itemData(self.choice.currentIndex())
        return next(each for each in load_colours.MEASURES if each.key == key)

    def _limit(self):
        """What the operation is not to exceed of what is shown, None where it says nothing."""
        inner = host.operation_under(self.operation)
        if self.measure.key == "engagement_deg" and is_ours(inner):
            return inner.EngagementAngle.Value + OVER
        return None

    def _choose(self):
        measure, limit = self.measure, self._limit()
        least, largest = load_colours.range_of(measure, self.found)
        scale = preferences.scale()
        colours = load_colours.colours_of(measure, self.found, least, largest, limit, scale)
        self.node.path.colour(colours)
        self.legend.show_scale(measure, least, largest, limit)
        self.worst.setEnabled(load_colours.worst_of(measure, self.found) is not None)
        self._show_place()

    def _show_place(self):
        number = self.slider.value()
        self.node.show_tool_at(self.found, number)
        self.told.setText(values_at(self.found, number, self.found.time_s))

    def _show_units(self):
        self.legend.update()
        self._show_place()

    # ---- what happens meanwhile ----

    def _dock_shown(self, is_shown):
        """A dock that its user has closed takes the colours with it; one behind others does not."""
        if not is_shown and self.dock.isHidden() and self in _shown:
            close()

    def _changed(self, is_gone):
        if is_gone:
            close()
        else:
            self._again.start()

    def _simulate_again(self):
        """Shows the operation as it is computed now; where there is no path now, nothing."""
        has_path = host.path_size(self.operation) > 1
        found = _told(lambda: simulated(self.operation)) if has_path else None
        if found is None:
            close()
        else:
            self._take(found)
