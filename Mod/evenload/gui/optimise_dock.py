"""The widgets of the dock Optimise."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from evenload.gui import manual
from evenload.gui import optimise_inputs as asking
from evenload.gui.docks import add_below
from evenload.gui.optimise_table import CandidateModel, beside, columns
from evenload.gui.shaded import Shaded
from evenload.gui.slots import telling_slot
from evenload.gui.stability_layout import button, scrolled
from evenload.gui.told import Told

_translate = FreeCAD.Qt.translate

NAME = "EvenLoadOptimise"  # of the dock
LEFT, TABLE, HEIGHT, SPACING = 300, 110, 470, 16  # pixels; table and dock are so high at least
BAR = 100  # steps of the progress bar, whose drawing takes as long as some work


class OptimiseDock(manual.Dock):
    """view: whose methods the widgets call, an OptimiseView. `chosen` is told with the candidate
    that is to be compared.
    """

    chosen = QtCore.Signal(object)

    def __init__(self, view):
        window = FreeCADGui.getMainWindow()
        title = _translate("EvenLoad", "EvenLoad Optimise: %s") % view.operation.Label
        super().__init__(title, window)
        self.setObjectName(NAME)
        self.set_page("optimisation")
        self.limits, self.tool = asking.limits_box(), asking.tool_box()
        self.to_try = asking.TryBox()
        self.compared, self.told = Shaded(form=QtCore.Qt.RichText), Told()
        self.compared.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        self.compared.setWordWrap(False)
        self.suggest = button(
            _translate("EvenLoad", "Suggest"),
            _translate("EvenLoad", "Finds the quickest cut that keeps these limits"),
            view.suggest,
        )
        self.cancel = button(
            _translate("EvenLoad", "Cancel"), _translate("EvenLoad", "Stops it"), view.cancel
        )
        self.take = button(
            _translate("EvenLoad", "Take"),
            _translate(
                "EvenLoad", "Sets engagement angle, step down, spindle speed and feeds as suggested"
            ),
            view.take,
        )
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, BAR)
        self.table, self.model = QtGui.QTableView(), CandidateModel(self)
        self._set_up_table()
        content = QtGui.QWidget()
        row = QtGui.QHBoxLayout(content)
        row.addWidget(self._left())
        row.addLayout(self._right(), 1)
        self.setWidget(content)
        add_below(window, self, HEIGHT)
        self.show_nothing()
        self.show_progress(None)

    def _set_up_table(self):
        table = self.table
        table.setModel(self.model)
        table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        table.setMinimumHeight(TABLE)
        table.verticalHeader().setDefaultSectionSize(table.fontMetrics().lineSpacing() + 6)
        table.horizontalHeader().setHighlightSections(False)  # bold titles would need more room
        table.horizontalHeader().setStretchLastSection(True)
        table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        table.setSortingEnabled(True)
        table.selectionModel().currentRowChanged.connect(telling_slot(self._row_chosen))

    def _left(self):
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.limits, self.tool):
            column.addWidget(widget)
        column.addStretch(1)
        area = QtGui.QVBoxLayout()
        area.setContentsMargins(0, 0, 0, 0)
        area.addWidget(scrolled(content, LEFT), 1)
        area.addWidget(self.suggest)
        whole = QtGui.QWidget()
        whole.setLayout(area)
        return whole

    def _right(self):
        side = QtGui.QVBoxLayout()
        side.addWidget(self.told)
        side.addStretch(1)
        side.addWidget(self.bar)
        side.addWidget(self.cancel)
        side.addWidget(self.take)
        above = QtGui.QHBoxLayout()
        above.setSpacing(SPACING)
        above.addWidget(self.compared, 0, QtCore.Qt.AlignTop)
        above.addLayout(side, 1)
        above.addWidget(self.to_try, 0, QtCore.Qt.AlignTop)
        column = QtGui.QVBoxLayout()
        column.addLayout(above)
        column.addWidget(self.table, 1)
        return column

    # ---- what is shown ----

    def show_candidates(self, rows, with_machine):
        """Lists candidates, the quickest first, none of which is chosen yet."""
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.model.show_candidates(rows, columns(with_machine))
        self.table.resizeColumnsToContents()

    def compare(self, now, chosen):
        """Shows a candidate beside what is set now."""
        self.compared.setText(beside(self.model.shown, now, chosen))
        self.take.setEnabled(True)
        if chosen in self.model.rows:
            self.table.selectRow(self.model.rows.index(chosen))

    def show_nothing(self):
        """As long as nothing is suggested."""
        self.model.show_candidates([], [])
        self.compared.clear()
        self.take.setEnabled(False)

    def show_progress(self, share):
        """Shows what is done, 0 to 1; None: nothing is under way."""
        for widget in (self.bar, self.cancel):
            widget.setVisible(share is not None)
        self.suggest.setEnabled(share is None)
        self.bar.setValue(round(BAR * (share or 0.0)))

    def tell(self, text, colour=None, named=""):
        """Shows sentences in place of those before, as Told has it."""
        self.told.tell(text, colour, named)

    def _row_chosen(self, current, _):
        if current.isValid():
            self.chosen.emit(self.model.rows[current.row()])
