"""The load view: a dock that colours an operation's path by what the simulator tells of it.

There is one at most. Until its command runs nothing of it exists; closing it removes all of it.
"""

import FreeCAD
from PySide import QtCore

from evenload import host
from evenload.gui import colours, load_colours, preferences, simulation_task, steps, view3d
from evenload.gui.length_box import UnitsWatch
from evenload.gui.load_colours import KIND, MEASURES, WALL
from evenload.gui.load_dock import LoadDock
from evenload.gui.load_legend import NAMES
from evenload.gui.load_node import LoadNode
from evenload.gui.measure_dock import table_of
from evenload.gui.observer import observer_of_paths
from evenload.gui.running import Running
from evenload.gui.slots import slot, telling_slot
from evenload.gui.values import told
from evenload.settings.properties import is_ours
from evenload.settings.sentences import shown
from evenload.simulation import job
from evenload.words import clock

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
    """Shows the load of an operation in its document's 3D view, once it is simulated. None, with a
    sentence in the report view, where it cannot be.
    """
    close()
    try:
        _shown.append(LoadView(operation))
    except ValueError as error:
        FreeCAD.Console.PrintError(shown(str(error)) + "\n")
        return None
    return _shown[-1]


def close():
    """Removes the load view, if there is one."""
    while _shown:
        _shown.pop().remove()


def stand_back(operation, is_back):
    """Hides the load of an operation while the preview in its panel shows another path, or shows it
    again.
    """
    for view in _shown:
        if host.operation_under(view.operation) is operation:
            view.stand_back(is_back)


def values_at(found, number, time):
    """What a Simulation tells at a sample, as rich text; time: s of all samples."""
    kind = WALL if found.walls is not None and found.walls[number] else int(found.kind[number])
    rows = [
        (_translate("EvenLoad", "Time"), clock(float(time[number]))),
        (_translate("EvenLoad", KIND.title), _translate("EvenLoad", NAMES[kind])),
    ]
    for each in MEASURES:
        values = load_colours.values_of(each, found)
        if each is not KIND and values is not None:
            rows.append(
                (_translate("EvenLoad", each.title), told(each.quantity, float(values[number])))
            )
    return table_of(rows)


class LoadView:
    """What shows the load of one operation: the node in the scene, and the dock. Raises ValueError
    with a sentence where it cannot be simulated, or where there is no 3D view.
    """

    def __init__(self, operation):
        self.operation, self.found, self.node = operation, None, None
        self._angle, self._is_stale = None, False  # whether the colours are those of another path
        setup = job.read(operation)
        self._is_back = steps.shows_preview(host.operation_under(operation))
        self._scene = view3d.scene_of(operation.Document)
        self.dock = LoadDock(self, operation.Label)
        self.task = Running(self.dock, self.dock.show_progress, self._refuse, found=self._take)
        self._observer = None
        self._again = QtCore.QTimer(self.dock)
        self._again.setSingleShot(True)
        self._again.timeout.connect(slot(self.simulate))
        self.dock.choice.currentIndexChanged.connect(slot(self._choose))
        self.dock.slider.valueChanged.connect(slot(self._show_place))
        self.dock.visibilityChanged.connect(telling_slot(self._dock_shown))
        self._units = UnitsWatch(self.dock, self._show_units)
        self.dock.show_path([], 0)
        self.dock.show()
        self._start(setup)

    def remove(self):
        """Removes it from the scene and the window, and stops what is under way."""
        self._again.stop()  # it would read a document that may be closed
        self._units.end()
        self.task.cancel()
        self._observe(None)
        self._forget()
        self.dock.hide()
        self.dock.deleteLater()

    # ---- simulating ----

    def simulate(self):
        """Simulates the operation as it is now in a thread, in place of what is under way."""
        try:
            setup = job.read(self.operation)
        except ValueError as error:
            self.task.cancel()
            self._observe(self.operation)
            self._refuse(str(error))
            return
        self._start(setup)

    def _start(self, setup):
        self._observe(self.operation)
        self._show_name()
        self._tell_where_it_is()
        self._is_stale = True
        self._show_node()
        inner = host.operation_under(self.operation)
        if "Touched" not in inner.State:  # else its path was computed with another one
            self._angle = inner.EngagementAngle.Value if is_ours(inner) else None
        options = {
            "step": simulation_task.step_of(self.operation),
            "material": simulation_task.material_of(self.operation),
        }
        self.task.run(lambda: simulation_task.loads(setup, options, self.task.done))

    def cancel(self):
        """Stops the simulation. What was there before is that of another path, and is forgotten;
        where nothing was, it closes.
        """
        self.task.cancel()
        if self.found is None:
            close()
            return
        self._forget()
        self.dock.tell(_translate("EvenLoad", "The simulation was cancelled."), colours.CAUTION)

    def _refuse(self, sentence):
        self._forget()
        self.dock.tell(sentence, colours.BAD)

    def _forget(self):
        if self.node is not None:
            self._scene.removeChild(self.node.root)
        self.found = self.node = None
        self.dock.show_path([], 0)

    def _take(self, found):
        """Shows a simulation of the operation in place of the one before, by the same measure."""
        if self.node is not None:
            self._scene.removeChild(self.node.root)
        self.found, self.node = found, LoadNode(found)
        self._is_stale = False
        self._show_node()
        self._scene.addChild(self.node.root)
        blocked = self.dock.slider.blockSignals(True)
        self.dock.show_path([each for each in MEASURES if self._has(each)], len(found.x))
        self.dock.slider.blockSignals(blocked)
        self._choose()

    # ---- what is shown ----

    def _has(self, measure):
        return measure is KIND or load_colours.values_of(measure, self.found) is not None

    @property
    def measure(self):
        """The Measure that is shown, None without any."""
        key = self.dock.choice.currentData()
        return next((each for each in MEASURES if each.key == key), None)

    def limit(self):
        """What the path is not to exceed of what is shown, None where nothing is known of that."""
        is_engagement = self.measure.key == "engagement_deg"
        return self._angle + OVER if is_engagement and self._angle is not None else None

    def _choose(self):
        if self.found is None:
            return
        measure, limit = self.measure, self.limit()
        least, largest = load_colours.range_of(measure, self.found)
        scale = preferences.scale()
        shown_colours = load_colours.colours_of(measure, self.found, least, largest, limit, scale)
        self.node.path.colour(shown_colours)
        self.dock.legend.show_scale(measure, least, largest, limit)
        self.dock.fly.setEnabled(load_colours.worst_of(measure, self.found) is not None)
        self._show_place()

    def _show_place(self):
        if self.found is not None:
            number = self.dock.slider.value()
            self.node.show_tool_at(self.found, number)
            self.dock.values.setText(values_at(self.found, number, self.found.time_s))

    def fly(self):
        """Goes to the place with the largest value of what is shown."""
        number = load_colours.worst_of(self.measure, self.found)
        if number is not None:
            self.dock.slider.setValue(number)
            place = self.found.x[number], self.found.y[number], self.found.z[number]
            document = self.operation.Document
            view3d.fly_to(document, map(float, place), self.found.tool_diameter)

    def stand_back(self, is_back):
        """Hides the colours while another path is shown in their place, or shows them again."""
        if is_back == self._is_back:
            return
        self._is_back = is_back
        self._show_node()
        if self.found is not None or self.task.is_busy:  # else it is told why there is none
            self._tell_where_it_is()

    def _show_node(self):
        if self.node is not None:
            self.node.show(not self._is_back and not self._is_stale)

    def _tell_where_it_is(self):
        told = _translate("EvenLoad", "The preview is shown; Apply or Cancel brings the load back.")
        self.dock.tell(told if self._is_back else "", colours.QUIET)

    def _show_units(self):
        self.dock.legend.update()
        self.dock.told.follow_units()
        self._show_place()

    # ---- what happens meanwhile ----

    def _observe(self, operation):
        """Follows an operation and those that cut before it; None: no more."""
        if self._observer is not None:
            FreeCAD.removeDocumentObserver(self._observer)
            self._observer = None
        if operation is not None:
            renamed = slot(self._show_name)
            self._observer = observer_of_paths([operation], telling_slot(self._changed), renamed)
            FreeCAD.addDocumentObserver(self._observer)

    def _show_name(self):
        self.dock.name(self.operation.Label)

    def _dock_shown(self, is_shown):
        """A dock that its user has closed takes the colours with it; one behind others does not."""
        if not is_shown and self.dock.isHidden() and self in _shown:
            close()

    def _changed(self, is_gone):
        if is_gone:
            close()
        else:
            self._again.start()
