"""The widgets of the dock Finishing Advisor."""

import FreeCAD
import FreeCADGui
from PySide import QtGui

from evenload import materials
from evenload.gui import colours, fields, manual
from evenload.gui.advisor_table import ON_MACHINE, REMARK, AdviceModel, table_of
from evenload.gui.docks import add_below
from evenload.gui.length_box import FineLengthBox, LengthBox
from evenload.gui.machine_box import MachineBox
from evenload.gui.shaded import Shaded
from evenload.gui.stability_inputs import Rows, combo
from evenload.gui.stability_layout import button, scrolled
from evenload.gui.told import Told
from evenload.settings.labels import LABELS
from evenload.settings.table import FINISHING

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadFinishingAdvisor"  # of the dock
LEFT, HEIGHT = 285, 380  # pixels
MOST = 50.0  # mm, of lengths
ARROW = 12  # pixels that the sign of the order takes of a heading
BAR = 100  # steps of the progress bar, whose drawing takes as long as some work
LENGTHS = ("Stepover", "CuspHeight", "stock")  # of what is asked, in mm


class StepBox(LengthBox):
    """A field for a stepover, or what stands on the faces."""

    digits, steps = fields.FINE_DECIMALS, (0.05, 0.002 * fields.INCH)


class AdvisorDock(manual.Dock):
    """view: whose methods the widgets call, an AdvisorView."""

    def __init__(self, view):
        window = FreeCADGui.getMainWindow()
        super().__init__(_translate("EvenLoad", "EvenLoad Finishing Advisor"), window)
        self.setObjectName(NAME)
        self.set_page("finishing_advisor")
        self.faces, self.told = Shaded(), Told()
        self.asked = _asked()
        self.model = AdviceModel(self)
        self.table = table_of(self.model)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, BAR)
        self.cancel = button("Cancel", "Stops the comparison; what is known stays", view.cancel)
        self.make = button("Make Operation", "", view.make)
        left = QtGui.QWidget()
        column = QtGui.QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.faces, self.asked, self.told):
            column.addWidget(widget)
        column.addStretch(1)
        content = QtGui.QWidget()
        row = QtGui.QHBoxLayout(content)
        row.addWidget(scrolled(left, LEFT))
        row.addLayout(self._right(), 1)
        self.setWidget(content)
        add_below(window, self, HEIGHT)

    def _right(self):
        column = QtGui.QVBoxLayout()
        column.addWidget(self.table, 1)
        below = QtGui.QHBoxLayout()
        below.addWidget(self.bar, 1)
        below.addWidget(self.cancel)
        below.addStretch(0)
        below.addWidget(self.make)
        column.addLayout(below)
        return column

    def list_controllers(self, controllers):
        """Lists the tool controllers to choose from; tells nobody."""
        box = self.asked.controller
        blocked = box.blockSignals(True)
        for each in controllers:
            box.addItem(each.Label, each.Name)
        fields.make_room_for_choices(box)
        box.blockSignals(blocked)

    def show_lengths(self, **lengths):
        """Shows lengths in mm by their names, and tells nobody."""
        self.asked.show_values(**lengths)

    def lengths(self):
        """{name: mm}"""
        return {name: getattr(self.asked, name).mm() for name in LENGTHS}

    def follow_units(self):
        """Shows all in the units that the user has chosen by now."""
        self.asked.follow_units()
        self.show_rows(self.model.rows)
        self.told.follow_units()

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        for widget in (self.bar, self.cancel):
            widget.setVisible(share is not None)
        self.bar.setValue(round(BAR * (share or 0.0)))

    def show_rows(self, rows):
        """Shows rows of Advice, with the row that was chosen still chosen."""
        chosen = self.chosen()
        if not self.model.rows:  # the table's own ground is what is seen of it
            self.model.set_shade(colours.shade(colours.GOOD, self.table.viewport()))
        self.model.show_rows(rows)
        self.table.setColumnHidden(ON_MACHINE, self.asked.machine.machine() is None)
        for section in range(REMARK):
            self.table.resizeColumnToContents(section)
            self.table.setColumnWidth(section, self.table.columnWidth(section) + ARROW)
        for number, row in enumerate(rows):
            if chosen is not None and row.strategy == chosen.strategy:
                proxy = self.table.model()
                self.table.selectRow(proxy.mapFromSource(self.model.index(number, 0)).row())

    def chosen(self):
        """The Advice of the chosen row, None without one."""
        found = self.table.selectionModel().selectedRows()
        return self.model.rows[self.table.model().mapToSource(found[0]).row()] if found else None

    def tell(self, text, colour=None, named=""):
        """Shows sentences, or hides those before where there are none, as Told has it."""
        self.told.tell(text, colour, named)


def _asked():
    (spacing,) = (row for row in FINISHING if row.name == "Spacing")
    return Rows(
        "What is compared",
        (
            ("controller", "Tool controller", "Its tool must have a ball end", combo(())),
            ("Spacing", spacing.label, spacing.doc, combo((each, each) for each in spacing.value)),
            (
                "Stepover",
                LABELS["Stepover"],
                "Of neighbouring passes, seen from above",
                StepBox(MOST),
            ),
            (
                "CuspHeight",
                LABELS["CuspHeight"],
                "Of a level face; sets the stepover",
                FineLengthBox(MOST),
            ),
            (
                "stock",
                "Stock on the faces",
                "What the cut before has left, across them",
                StepBox(MOST),
            ),
            ("machine", "Machine", "Times are within its limits, too", MachineBox()),
            (
                "material",
                "Material",
                "Its force coefficients",
                combo((name, name) for name in materials.names()),
            ),
        ),
    )
