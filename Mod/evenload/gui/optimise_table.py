"""Candidates as numbers: the ranked list of them, and two of them side by side."""

import html
import math
from dataclasses import dataclass

import FreeCAD
from PySide import QtCore

from evenload.gui import fields
from evenload.suggestion import search
from evenload.words import clock

_translate = FreeCAD.Qt.translate

HEAD = (
    '<tr><td></td><th align="right">%s</th>'
    '<th align="right" style="padding-left: 18px">%s</th></tr>'
)
ROW = (
    '<tr><td style="padding-right: 14px">%s</td><td align="right">%s</td>'
    '<td align="right" style="padding-left: 18px"><b>%s</b></td></tr>'
)


@dataclass(frozen=True)
class Column:
    """One figure of candidates."""

    title: str
    number: object  # candidate -> what it is sorted by
    text: object  # candidate -> what is shown; the same function where that is no number


def columns(with_machine):
    """The Columns in the units that the user has chosen by now."""
    inches = fields.shows_inches()
    unit, per = ("in", fields.INCH) if inches else ("mm", 1.0)
    long, fine = (4, 5) if inches else (3, 4)

    def figure(title, name, form):
        return Column(title, lambda c: getattr(c, name), lambda c: form % getattr(c, name))

    def scaled(title, number, digits):
        return Column(title, number, lambda c: "%.*f" % (digits, number(c)))

    found = [
        figure(_translate("EvenLoad", "Angle, °"), "engagement_deg", "%.4g"),
        scaled(_translate("EvenLoad", "Side step, %s") % unit, lambda c: side_step(c) / per, long),
        figure(_translate("EvenLoad", "Levels"), "levels", "%d"),
        scaled(_translate("EvenLoad", "Step down, %s") % unit, lambda c: c.axial_depth / per, long),
        figure(_translate("EvenLoad", "rev/min"), "spindle_speed", "%.0f"),
        scaled(
            _translate("EvenLoad", "Feed, %s/min") % unit,
            lambda c: search.feed_of(c) / per,
            1 if inches else 0,
        ),
        Column(_translate("EvenLoad", "Time"), lambda c: c.time_s, lambda c: clock(c.time_s)),
        Column(_translate("EvenLoad", "Limited by"), bound_of, bound_of),
        figure(_translate("EvenLoad", "Force, N"), "force_peak_n", "%.0f"),
        figure(_translate("EvenLoad", "Torque, N m"), "torque_peak_nm", "%.2f"),
        figure(_translate("EvenLoad", "Power, W"), "power_w", "%.0f"),
        scaled(_translate("EvenLoad", "Chip, %s") % unit, lambda c: c.h_max_mm / per, fine),
    ]
    if with_machine:
        on_machine = Column(
            _translate("EvenLoad", "On the machine"),
            lambda c: c.machine_time_s,
            lambda c: clock(c.machine_time_s),
        )
        found.insert(7, on_machine)
    return found


def side_step(candidate):
    """mm of a straight cut."""
    radius = 0.5 * candidate.diameter
    return radius * (1 - math.cos(math.radians(candidate.engagement_deg)))


def bound_of(candidate):
    """What keeps a candidate's feed from being larger, in a word."""
    words = {
        "chip thickness": _translate("EvenLoad", "chip thickness"),
        "force": _translate("EvenLoad", "force"),
        "torque": _translate("EvenLoad", "torque"),
        "power": _translate("EvenLoad", "power"),
        "machine feed": _translate("EvenLoad", "the machine's feed"),
    }
    return words.get(candidate.bound_by, "")


def beside(shown, now, chosen):
    """Rich text of what is set now, None where it is not known, and a candidate, by Columns."""
    lines = [HEAD % (_translate("EvenLoad", "Now"), _translate("EvenLoad", "Suggested"))]
    for column in shown:
        before = column.text(now) if now is not None else "–"
        texts = column.title, before, column.text(chosen)
        lines.append(ROW % tuple(html.escape(text) for text in texts))
    return "<table>%s</table>" % "".join(lines)


class CandidateModel(QtCore.QAbstractTableModel):
    """Candidates by Columns, sorted by their numbers. Without items: PySide keeps wrappers of them
    that outlive them.
    """

    def __init__(self, parent):
        super().__init__(parent)
        self.rows, self.shown = [], []

    def show_candidates(self, rows, shown):
        """rows: candidates in their order; shown: Columns."""
        self.beginResetModel()
        self.rows, self.shown = list(rows), list(shown)
        self.endResetModel()

    # ---- what Qt calls ----

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.shown)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        if not index.isValid():
            return None
        column = self.shown[index.column()]
        if role == QtCore.Qt.DisplayRole:
            return column.text(self.rows[index.row()])
        if role == QtCore.Qt.TextAlignmentRole and column.number is not column.text:
            return int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        return None

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        if role != QtCore.Qt.DisplayRole:
            return None
        is_title = orientation == QtCore.Qt.Horizontal
        return self.shown[section].title if is_title else section + 1

    def sort(self, section, order=QtCore.Qt.AscendingOrder):
        if not 0 <= section < len(self.shown):
            return
        self.layoutAboutToBeChanged.emit()
        down = order == QtCore.Qt.DescendingOrder
        before = list(self.rows)
        self.rows.sort(key=self.shown[section].number, reverse=down)
        for index in self.persistentIndexList():  # what is selected stays so
            row = self.rows.index(before[index.row()])
            self.changePersistentIndex(index, self.index(row, index.column()))
        self.layoutChanged.emit()
