"""The table of the dock Finishing Advisor: a row for each strategy; numbers sort as numbers."""

from dataclasses import dataclass

import FreeCAD
from PySide import QtCore, QtGui

from evenload.settings.sentences import shown
from evenload.words import clock

_translate = FreeCAD.Qt.translate

ROOM = 6  # pixels above and below a row's text
UNKNOWN = "\u2013"
SAME = 1e-9  # as a share: values that differ by less are equally good
LENGTH, SPEED, TIME, SHARE, IMPULSE = "Length", "Velocity", "time", "share", "impulse"
MM_PER_S = 1000 / 60  # of a m/min


@dataclass(frozen=True)
class Column:
    """title, kind; name: of the Advice's value; best: which value is, min or max, or None."""

    title: str
    name: str
    kind: str
    best: object
    tip: str


COLUMNS = (
    Column("Time", "seconds", TIME, min, "Of the path at its own feeds"),
    Column("On the machine", "machine_seconds", TIME, min, "Within the limits of the machine"),
    Column(
        "Mean thickness", "mean_thickness", LENGTH, None, "Of the chips: mean of h_m on the way"
    ),
    Column("Scatter", "scatter", LENGTH, min, "Standard deviation of h_m: the less, the evener"),
    Column("Thickest", "max_thickness", LENGTH, min, "The largest thickness of all chips"),
    Column("Mean cusp", "mean_cusp", LENGTH, min, "Height of what stands between two passes"),
    Column(
        "Highest cusp", "max_cusp", LENGTH, min, "The highest of what stands between two passes"
    ),
    Column(
        "Tip share",
        "tip_share",
        SHARE,
        min,
        "The largest share of a chip that is cut at less than a fifth of the tool's diameter",
    ),
    Column("Least speed", "least_speed", SPEED, max, "The least cutting speed of the working edge"),
    Column("Impulse", "impulse", IMPULSE, min, "Of the cutting force over the time of the cuts"),
)
STRATEGY, ON_MACHINE, REMARK = 0, 2, len(COLUMNS) + 1  # numbers of columns


class AdviceModel(QtCore.QAbstractTableModel):
    """Rows of Advice; each column's lengths and speeds in the unit that FreeCAD prefers for its
    largest.
    """

    def __init__(self, parent):
        super().__init__(parent)
        self.rows, self._remarks, self._units = [], [], {}
        self._bold = QtGui.QFont(parent.font())
        self._bold.setBold(True)
        self._good = None

    def set_shade(self, name):
        """Takes the name of the colour that the best values have."""
        self._good = QtGui.QBrush(QtGui.QColor(name))

    def show_rows(self, rows):
        self.beginResetModel()
        self.rows = list(rows)
        self._remarks = [_remark(row) for row in rows]  # once: translating takes its time
        self._units = {column: _unit_of(column, self._known(column)) for column in COLUMNS}
        self.endResetModel()

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(COLUMNS) + 2

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        if orientation != QtCore.Qt.Horizontal:
            return None
        column = COLUMNS[section - 1] if STRATEGY < section < REMARK else None
        if role == QtCore.Qt.ToolTipRole and column:
            return _translate("EvenLoad", column.tip)
        if role != QtCore.Qt.DisplayRole:
            return None
        if column is None:
            return _translate("EvenLoad", "Strategy" if section == STRATEGY else "Remark")
        _, unit = self._units.get(column, (1.0, ""))
        # Narrow, for there are many.
        title = _translate("EvenLoad", column.title).replace(" ", "\n")
        return title + "\n" + unit if unit else title

    def data(self, index, role=QtCore.Qt.DisplayRole):
        row, section = self.rows[index.row()], index.column()
        remark = self._remarks[index.row()]
        if role == QtCore.Qt.ToolTipRole:
            return remark or None
        if section in (STRATEGY, REMARK):
            text = name_of(row.strategy) if section == STRATEGY else remark
            return text if role in (QtCore.Qt.DisplayRole, QtCore.Qt.UserRole) else None
        column = COLUMNS[section - 1]
        value = getattr(row, column.name)
        if role == QtCore.Qt.UserRole:
            return value
        if role == QtCore.Qt.DisplayRole:
            return UNKNOWN if value is None else self._told(column, value)
        if role == QtCore.Qt.TextAlignmentRole:
            return int(QtCore.Qt.AlignRight) | int(QtCore.Qt.AlignVCenter)
        if role in (QtCore.Qt.FontRole, QtCore.Qt.ForegroundRole) and self.is_best(row, column):
            return self._bold if role == QtCore.Qt.FontRole else self._good
        return None

    def is_best(self, row, column):
        """Whether no other row is better in a column, and some are worse."""
        known, value = self._known(column), getattr(row, column.name)
        if column.best is None or value is None or max(known) - min(known) <= SAME * max(known):
            return False
        return abs(value - column.best(known)) <= SAME * max(known)

    def _known(self, column):
        values = [getattr(row, column.name) for row in self.rows]
        return [value for value in values if value is not None]

    def _told(self, column, value):
        if column.kind == TIME:
            return clock(value)
        return _rounded(value / self._units[column][0])


class BySize(QtCore.QSortFilterProxyModel):
    """Qt's sorting, by numbers; what is unknown comes last, whichever way it is sorted."""

    def __init__(self, model, parent):
        super().__init__(parent)
        self.setSourceModel(model)
        self._model = model

    def lessThan(self, left, right):
        one, other = (self._model.data(each, QtCore.Qt.UserRole) for each in (left, right))
        if one is None or other is None:
            is_rising = self.sortOrder() == QtCore.Qt.AscendingOrder
            return (one is not None and other is None) == is_rising and one is not other
        return one < other


def table_of(model):
    """The view of an AdviceModel, sortable by each column."""
    table = QtGui.QTableView()
    table.setModel(BySize(model, table))
    table.setSortingEnabled(True)
    table.sortByColumn(1, QtCore.Qt.AscendingOrder)
    table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
    table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
    table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    table.setAlternatingRowColors(True)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + ROOM)
    table.horizontalHeader().setStretchLastSection(True)
    return table


def name_of(strategy):
    """A Strategy's name in the user's language."""
    return strategy.name.replace(strategy.pattern, _translate("EvenLoad", strategy.pattern), 1)


def _rounded(value):
    """A number of three digits, or more before the point."""
    return "%.0f" % value if value == 0 or value >= 100 else "%#.3g" % value


def _remark(row):
    sentences = (row.refusal, *row.notes) if row.refusal else row.notes
    return " ".join(map(shown, sentences))


def _unit_of(column, values):
    """(what the unit is in the Advice's, its name) that a column's values are shown in."""
    if column.kind == SHARE:
        return 0.01, "%"
    if column.kind == IMPULSE:
        return 1.0, "N\u00b7s"
    if column.kind == TIME or not values:
        return 1.0, ""
    own = MM_PER_S if column.kind == SPEED else 1.0
    dimension = getattr(FreeCAD.Units, column.kind)
    largest = FreeCAD.Units.Quantity(own * max(values), dimension)
    _, factor, unit = largest.getUserPreferred()
    return factor / own, unit
