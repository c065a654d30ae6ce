"""What the panels of all operations share: base geometry, settings, results."""


import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload import host
from evenload.gui.base_page import BaseGeometryPage
from evenload.gui.slots import slot
from evenload.operations.base import SENTENCES
from evenload.settings.setting import BOOL, CHOICE, INTEGER, NUMBER, NUMBERS, POINT, UNITS
from evenload.settings.table import boxes_of

_gui = host.gui()
_translate = FreeCAD.Qt.translate

NARROWEST = 70  # pixels of an entry field: the panel is to fit into FreeCAD's narrow dock
DECIMALS = 4  # of numbers without a unit
MOST = 1_000_000  # of what is counted: no value that a macro set may be cut short here
EDITED = (QtGui.QAbstractSpinBox, QtGui.QLineEdit)  # widgets that tell when their text is done


def values_in(text):
    """The numbers in a text: between semicolons, where commas may be decimal ones, or else between
    commas or blanks. None where it holds anything else.
    """
    words = text.replace(",", ".").split(";") if ";" in text else text.replace(",", " ").split()
    try:
        return [float(word) for word in words if word.strip()]
    except ValueError:
        return None


def create(operation):
    """Creates the operation of a module for what is selected and opens its panel, in one undoable
    step. None where there is no job for it, or where the user cancels the choice of the job or of
    its tool controller.
    """
    doc = FreeCAD.ActiveDocument
    job = host.job_for_selection()
    if job is None:
        return None
    doc.openTransaction("Create " + operation.NAME)
    try:
        obj = operation.Create(operation.NAME.replace(" ", ""), parentJob=job)
        obj.ViewObject.Proxy.deleteOnReject = True  # Cancel in its first panel takes it away again
        obj.ViewObject.Visibility = True
    except host.no_tool_chosen():
        doc.abortTransaction()
        return None
    except SENTENCES as error:
        doc.abortTransaction()
        FreeCAD.Console.PrintError("%s was not created: %s\n" % (operation.NAME, error))
        return None
    except Exception:  # a bug, which keeps its traceback
        doc.abortTransaction()
        raise
    doc.commitTransaction()
    obj.ViewObject.Document.setEdit(obj.ViewObject, 0)
    return obj


class OperationPage(_gui.op.TaskPanelPage):
    """The operation's settings and results.

    What is edited goes into the properties at once, so that the two that follow each other can; the
    path is computed at Apply and OK.
    """

    taskPanelBaseGeometryPage = BaseGeometryPage
    kind = None  # the operation's proxy class

    def getForm(self):
        self.settings = {setting.name: setting for setting in self.kind.settings}
        self.result_names = [setting.name for setting in self.kind.results]
        self.boxes, self.points = {}, {}
        self.shown = {}  # texts of the boxes for quantities
        self.widgets = {}
        form = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(form)
        head = self._head(form)
        layout.addWidget(head)
        for title, settings in boxes_of(self.kind.settings):
            layout.addWidget(self._box(title, settings))
        if self.kind.fitted:
            self.again = QtGui.QPushButton(_translate("EvenLoad", "Fit all again"))
            self.again.setToolTip(
                _translate("EvenLoad", "What was set shall follow the geometry again")
            )
            layout.addWidget(self.again)
        self.results = QtGui.QLabel()
        self.results.setWordWrap(True)
        self.results.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(self.results)
        layout.addStretch(1)
        area = QtGui.QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QtGui.QFrame.NoFrame)
        area.setWidget(form)
        area.toolController = form.toolController  # FreeCAD looks for it in the outermost widget
        area.coolantController = form.coolantController
        if host.LIST_MAKES_CONTROLLERS:
            area.editToolController = QtGui.QCheckBox(_translate("EvenLoad", "Edit"))
            head.layout().addWidget(area.editToolController, 0, 2)
        return area

    def _head(self, form):
        """The choice of the tool controller and of the coolant, which FreeCAD knows by the form."""
        form.toolController = self._combo_box()
        form.coolantController = self._combo_box()
        head = QtGui.QWidget()
        grid = QtGui.QGridLayout(head)  # in which FreeCAD 1.1 shows the tool controller's editor
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(1, 1)
        for row, (title, widget) in enumerate(
            (("Tool controller", form.toolController), ("Coolant", form.coolantController))
        ):
            grid.addWidget(QtGui.QLabel(_translate("EvenLoad", title)), row, 0)
            grid.addWidget(widget, row, 1)
        return head

    def _box(self, title, settings):
        """A box with a row for each of some settings."""
        box = QtGui.QGroupBox(_translate("EvenLoad", title))
        rows = QtGui.QFormLayout(box)
        for setting in settings:
            widget = self._widget(setting)
            widget.setToolTip(_translate("EvenLoad", setting.doc))
            rows.addRow(_translate("EvenLoad", setting.label), widget)
            self.widgets[setting.name] = widget
        return box

    def _widget(self, setting):
        name, kind = setting.name, setting.type
        if kind == CHOICE:
            widget = self._combo_box()
            for choice in setting.value:
                widget.addItem(_translate("EvenLoad", choice), choice)
            return widget
        if kind == BOOL:
            return QtGui.QCheckBox()
        if kind == POINT:
            widget = QtGui.QWidget()
            row = QtGui.QHBoxLayout(widget)
            row.setContentsMargins(0, 0, 0, 0)
            self.points[name] = [self._spin_box(), self._spin_box()]
            for box in self.points[name]:
                box.setProperty("unit", "mm")
                row.addWidget(box)
            return widget
        if setting.is_fine:
            widget = QtGui.QDoubleSpinBox()
            widget.setDecimals(4)
            widget.setSingleStep(0.001)
            widget.setMaximum(10.0)
            widget.setSuffix(" mm")
            return widget
        if kind == NUMBERS:
            widget = QtGui.QLineEdit()
            widget.setMinimumWidth(NARROWEST)
            return widget
        if kind == INTEGER:
            widget = QtGui.QSpinBox()
            widget.setMaximum(MOST)
            return widget
        if kind == NUMBER:
            widget = QtGui.QDoubleSpinBox()
            widget.setDecimals(DECIMALS)
            widget.setSingleStep(0.05)
            return widget
        return self._spin_box()

    @staticmethod
    def _spin_box():
        box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        box.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        box.setMinimumWidth(NARROWEST)
        return box

    @staticmethod
    def _combo_box():
        box = QtGui.QComboBox()
        box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumWidth(NARROWEST)
        return box

    def initPage(self, obj):
        for name, widget in self.widgets.items():
            setting = self.settings[name]
            if setting.type in UNITS and not setting.is_fine:
                self.boxes[name] = _gui.util.QuantitySpinBox(widget, obj, name)

    def setFields(self, obj):
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)
        self._show_settings(obj)
        self._show_results(obj)

    def getFields(self, obj):
        self.updateToolController(obj, self.form.toolController)
        self.updateCoolant(obj, self.form.coolantController)
        for name in self.widgets:
            self._take(name)

    def registerSignalHandlers(self, obj):
        self.form.toolController.activated.connect(slot(self._tool_chosen))
        self.form.coolantController.activated.connect(slot(self._coolant_chosen))
        for name, widget in self.widgets.items():
            take = slot(self._take, name)
            if name in self.boxes or isinstance(widget, EDITED):
                widget.editingFinished.connect(take)
            elif name in self.points:
                for box in self.points[name]:
                    box.editingFinished.connect(take)
            elif isinstance(widget, QtGui.QComboBox):
                widget.activated.connect(take)
            else:
                widget.toggled.connect(take)

        if self.kind.fitted:
            self.again.clicked.connect(slot(self._fit_again))

    def updateData(self, obj, prop):
        if prop in (*self.result_names, *self.kind.fitted):
            self._show_settings(obj)
            self._show_results(obj)

    def resetToolController(self, job, tc):
        """FreeCAD calls this for a tool controller that the user has just made."""
        super().resetToolController(job, tc)
        if self.obj is not None:
            self._show_new_tool()

    def _tool_chosen(self):
        self.updateToolController(self.obj, self.form.toolController)
        self._show_new_tool()

    def _show_new_tool(self):
        self._show_settings(self.obj)
        self.setDirty()

    def _coolant_chosen(self):
        self.updateCoolant(self.obj, self.form.coolantController)
        self.setDirty()

    def _take(self, name):
        """Takes what is edited in one widget into its property, and shows what follows from it."""
        obj, widget = self.obj, self.widgets[name]
        if name in self.shown and self._texts(name) == self.shown[name]:
            changed = False  # what is shown is rounded, and is no new value until it is edited
        elif name in self.boxes:
            changed = self.boxes[name].updateProperty()
        else:
            if name in self.points:
                x, y = (float(box.property("rawValue")) for box in self.points[name])
                value = FreeCAD.Vector(x, y, getattr(obj, name).z)
            elif isinstance(widget, QtGui.QComboBox):
                value = widget.itemData(widget.currentIndex())
            elif isinstance(widget, QtGui.QAbstractSpinBox):
                value = widget.value()
            elif isinstance(widget, QtGui.QLineEdit):
                value = values_in(widget.text())
            else:
                value = widget.isChecked()
            before = getattr(obj, name)
            before = getattr(before, "Value", before)
            # What is shown of a number is rounded.
            changed = (round(before, DECIMALS) if isinstance(before, float) else before) != value
            if value is None:
                FreeCAD.Console.PrintError(
                    "%s takes numbers, as 0; 0.1; 0.4; 1.\n" % self.settings[name].label
                )
            elif changed:
                setattr(obj, name, value)
        if changed:
            self._show_settings(obj)
            self.setDirty()

    def _show_settings(self, obj):
        for name, widget in self.widgets.items():
            value = getattr(obj, name)
            if name in self.boxes:
                host.show_value(self.boxes[name])
            elif name in self.points:
                for box, number in zip(self.points[name], (value.x, value.y)):
                    box.setProperty("rawValue", number)
            else:
                blocked = widget.blockSignals(True)
                if isinstance(widget, QtGui.QComboBox):
                    widget.setCurrentIndex(widget.findData(value))
                elif isinstance(widget, QtGui.QAbstractSpinBox):
                    widget.setValue(getattr(value, "Value", value))
                elif isinstance(widget, QtGui.QLineEdit):
                    widget.setText("; ".join("%.12g" % each for each in value))
                else:
                    widget.setChecked(value)
                widget.blockSignals(blocked)
        self.shown = {name: self._texts(name) for name in (*self.boxes, *self.points)}
        for setting in self.kind.settings:
            if setting.when:
                choice, wanted = setting.when
                self.widgets[setting.name].setEnabled(getattr(obj, choice) in wanted)
        if self.kind.fitted:
            self.again.setEnabled(any(name in obj.OwnValues for name in self.kind.fitted))

    def _texts(self, name):
        """What the boxes for a quantity or a point show."""
        return [box.property("text") for box in self.points.get(name, [self.widgets[name]])]

    def _fit_again(self):
        self.obj.Proxy.follow_tool(self.obj, again=self.kind.fitted)
        self._show_settings(self.obj)
        self.setDirty()

    def _show_results(self, obj):
        lines = []
        if obj.CuttingTime > 0:
            lines.append(
                _translate("EvenLoad", "Time %.1f s (ideal %.1f s), largest engagement %.1f°")
                % (obj.CuttingTime, obj.IdealTime, obj.MaxEngagement.Value)
            )
        lines += obj.Report.splitlines()
        self.results.setText("\n".join(lines))
