"""What an operation's page is made of: the status, the rows that show at first, the folded rest."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host
from evenload.gui import engagement, fields, manual, preferences
from evenload.gui.folds import Fold, form_in
from evenload.gui.hole_pick import HolePick, PlacePick
from evenload.gui.marks import Marks
from evenload.gui.slots import slot
from evenload.gui.status import Status
from evenload.gui.wrappers import forget_the_dead
from evenload.settings.setting import BOOL, POINT
from evenload.settings.table import sections_of

_gui = host.gui()
_translate = FreeCAD.Qt.translate

ADDED_TO = "Feeds"  # where FreeCAD's own choice of the coolant stands; without it in the last part
FITTED_IN = "Spiral"  # that whose values may be fitted again
HOLE_IN = "Entry"  # that with a hole, which may be picked


def _forget_the_panel(*_):
    """After the end of a page's widgets: once the rest of its panel is deleted, too."""
    QtCore.QTimer.singleShot(0, forget_the_dead)


class _Area(QtGui.QScrollArea):
    """Scrolls what is below the status. It asks for no height: with what it would like FreeCAD's
    own area around the page had a scroll bar too in a low window, and the two cut off the right.
    """

    def sizeHint(self):
        return self.minimumSizeHint()


class FormPage(_gui.op.TaskPanelPage):
    """A page with its widgets: `widgets` and `labels` of settings by their names, `points` of those
    that are places, `folds` by their titles.
    """

    kind = None  # the operation's proxy class
    manual_page = None  # the name of that in the documentation
    engagement = None  # the row of the engagement angle; None where an operation has none
    suggest = None  # the button that opens the dock Optimise; None where that knows no such cut
    hole = None  # the HolePick; None where an operation enters by no hole
    open_side = None  # the PlacePick; None where an operation enters over no open side

    def follow(self, piece):
        """Goes to what a Piece of a sentence in the status names."""
        raise NotImplementedError

    def take_hole(self, hole):
        """Takes a hole that was picked: (x, y, diameter or None), mm."""
        raise NotImplementedError

    def take_open_side(self, place):
        """Takes a place near an open side that was picked: (x, y), mm."""
        raise NotImplementedError

    def show_status(self):
        """Brings the status up to date."""
        raise NotImplementedError

    def refresh(self):
        """Shows what a recompute has changed."""
        self.show_status()

    def getForm(self):
        self.settings = {setting.name: setting for setting in self.kind.settings}
        self.result_names = [setting.name for setting in self.kind.results]
        self.boxes, self.points = {}, {}
        self.shown = {}  # texts of the boxes for quantities
        self.widgets, self.labels, self.folds = {}, {}, {}
        self.status = Status(self.follow)
        self.marks = Marks()
        form = manual.Widget()
        form.set_page(self.manual_page)
        form.destroyed.connect(_forget_the_panel)
        # Whether an operation is valid shows only after the recompute that sets its results, one by
        # one; what is shown then takes longer than a result.
        self._refresh = QtCore.QTimer(form)
        self._refresh.setSingleShot(True)
        self._refresh.timeout.connect(slot(self.refresh))
        whole = QtGui.QVBoxLayout(form)
        whole.setContentsMargins(0, 2, 0, 2)
        above = QtGui.QHBoxLayout()
        above.addWidget(self.status.top, 1)
        self.load = QtGui.QToolButton()
        self.load.setIcon(FreeCADGui.getIcon("EvenLoad_ShowLoad"))
        self.load.setToolTip(
            _translate("EvenLoad", "Colours the path in the 3D view by its load, or ends that")
        )
        self.load.setVisible(engagement.ANGLE in self.settings)  # the simulator knows no others
        above.addWidget(self.load, 0, QtCore.Qt.AlignTop)
        whole.addLayout(above)
        self.live = QtGui.QCheckBox(_translate("EvenLoad", "Live preview"))
        self.live.setToolTip(
            _translate("EvenLoad", "Shows the path in the 3D view while values change")
        )
        self.live.setChecked(preferences.live_preview())
        whole.addWidget(self.live)
        self.area = _Area()
        self.area.setWidgetResizable(True)
        self.area.setFrameShape(QtGui.QFrame.NoFrame)
        self.area.setWidget(self._content(form))
        whole.addWidget(self.area, 1)
        return form

    def _content(self, form):
        content = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(content)
        layout.setContentsMargins(0, 2, 0, 2)
        layout.addWidget(self.status.notes)
        layout.addWidget(self._head(form))
        first, folded = sections_of(self.kind.settings)
        layout.addWidget(self._first(first))
        titles = [title for title, _ in folded]
        for title, settings in folded:
            self.folds[title] = Fold(title, _translate("EvenLoad", title))
            entries = [self._entry(setting) for setting in settings]
            if title == (ADDED_TO if ADDED_TO in titles else titles[-1]):
                # FreeCAD looks for it in the outermost widget.
                form.coolantController = fields.combo_box()
                label = QtGui.QLabel(_translate("EvenLoad", "Coolant"))
                entries.append((label, form.coolantController))
            rows = form_in(self.folds[title].body, entries)
            layout.addWidget(self.folds[title])
            if title == ADDED_TO and engagement.ANGLE in self.settings:
                self.suggest = QtGui.QPushButton(_translate("EvenLoad", "Suggest…"))
                self.suggest.setToolTip(
                    _translate("EvenLoad", "What tool and machine allow, beside what is set now")
                )
                rows.addRow(self.suggest)
            if title == FITTED_IN:
                self.again = QtGui.QPushButton(_translate("EvenLoad", "Fit all again"))
                self.again.setToolTip(
                    _translate("EvenLoad", "What was set shall follow the geometry again")
                )
                rows.addRow(self.again)
            elif title == HOLE_IN:
                self.hole = HolePick(self.obj.Document, self.take_hole)
                rows.addRow(self.hole.button)
                if "OpenSideAt" in self.settings:
                    self.open_side = self._open_side_pick()
                    rows.addRow(self.open_side.button)
        layout.addStretch(1)
        return content

    def _open_side_pick(self):
        return PlacePick(
            self.obj.Document,
            self.take_open_side,
            _translate("EvenLoad", "Pick the Open Side"),
            _translate(
                "EvenLoad",
                "A click near an open side in the 3D view: over that side the tool comes in first",
            ),
        )

    def _head(self, form):
        """The choice of the tool controller, which FreeCAD knows by the form."""
        form.toolController = fields.combo_box()
        head = QtGui.QWidget()
        grid = QtGui.QGridLayout(head)  # in which FreeCAD 1.1 shows the tool controller's editor
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(0, 1)
        grid.addWidget(QtGui.QLabel(_translate("EvenLoad", "Tool controller")), 0, 0)
        grid.addWidget(form.toolController, 1, 0, 1, 2)
        if host.LIST_MAKES_CONTROLLERS:
            form.editToolController = QtGui.QCheckBox(_translate("EvenLoad", "Edit"))
            grid.addWidget(form.editToolController, 0, 1)
        return head

    def _first(self, settings):
        """The few rows that show at first; what has an engagement angle begins with it."""
        part = QtGui.QWidget()
        if engagement.ANGLE not in self.settings:
            form_in(part, [self._entry(setting) for setting in settings])
            return part
        angle, step = (self.settings[name] for name in (engagement.ANGLE, engagement.STEP))
        self._make(angle)
        self.engagement = engagement.EngagementRow(
            self.labels[angle.name], self.widgets[angle.name]
        )
        below = [step, *(row for row in settings if row not in (angle, step))]
        form_in(part, [(None, self.engagement), *map(self._entry, below)])
        return part

    def _entry(self, setting):
        """(label, field) of a setting, which are made; (None, field) where the field has both."""
        self._make(setting)
        label, widget = self.labels[setting.name], self.widgets[setting.name]
        return (None if label is widget else label), widget

    def _make(self, setting):
        """Makes a setting's field and label."""
        name = setting.name
        if setting.type == POINT:
            widget, self.points[name] = fields.point_of()
        else:
            widget = fields.widget_of(setting)
        widget.setToolTip(_translate("EvenLoad", setting.doc))
        self.widgets[name] = widget
        # A box to be ticked has its label in itself.
        self.labels[name] = (
            widget if setting.type == BOOL else QtGui.QLabel(_translate("EvenLoad", setting.label))
        )
