"""The status on top of a panel: whether there is a path, what it takes, and what is to be said of
it, with the places and fields that are named as links.
"""

import html

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import colours
from evenload.gui.slots import slot, telling_slot
from evenload.gui.values import told
from evenload import units
from evenload.settings import notes
from evenload.words import clock

_translate = FreeCAD.Qt.translate

VALID, WAITING, FAILED, PREVIEW = "valid", "waiting", "failed", "preview"
MARKS = {VALID: ("\u2714", colours.GOOD), WAITING: ("\u25cf", colours.CAUTION)}
MARKS[FAILED], MARKS[PREVIEW] = ("\u2716", colours.BAD), ("\u25cf", colours.LINK)


def state_of(obj, is_changed):
    """(VALID, WAITING or FAILED, the sentence for it) of an operation; is_changed: whether its
    panel has been edited since the path was computed.
    """
    failure = "" if obj.isValid() else obj.Report.splitlines()[:1]
    if is_changed:
        return WAITING, _translate("EvenLoad", "Changed: Apply computes the path")
    if failure:
        return FAILED, failure[0]
    if not obj.isValid():
        return FAILED, _translate("EvenLoad", "The path could not be computed.")
    if not obj.Active:
        return WAITING, _translate("EvenLoad", "Not active: there is no path")
    if not obj.Report:
        return WAITING, _translate("EvenLoad", "Not computed yet: Apply computes the path")
    if notes.CHECKED in obj.Report.splitlines():
        return VALID, _translate("EvenLoad", "Valid, checked against the model")
    return VALID, _translate("EvenLoad", "Valid")


def values_of(obj):
    """{name: value} of an operation's results; mm, degrees, s."""
    values = {row.name: getattr(obj, row.name) for row in obj.Proxy.results}
    return {name: getattr(value, "Value", value) for name, value in values.items()}


def figures_of(values):
    """[(what is told, explanation), ...] of the results of a path, as values_of() has them."""
    if not values["CuttingTime"] > 0:
        return []
    times = clock(values["CuttingTime"])
    if values["IdealTime"] > 0:
        ratio = values["CuttingTime"] / values["IdealTime"]
        times += _translate("EvenLoad", " (%.2f of the ideal)") % ratio
    return [
        (
            _translate("EvenLoad", "Time %s") % times,
            _translate(
                "EvenLoad",
                "Cuts, links, entries and retracts at the path's own feeds; Cycle Time is the "
                "same. The ideal is the area over side step and feed: all of it cut at the "
                "engagement angle",
            ),
        ),
        (
            _translate("EvenLoad", "Engagement up to %.1f°") % values["MaxEngagement"],
            units.in_users_unit(
                _translate("EvenLoad", "Largest engagement angle, mean over 0.1 mm of the path")
            ),
        ),
        (
            _translate("EvenLoad", "Uncut %s") % told(units.AREA, values["UncutArea"]),
            _translate("EvenLoad", "Area that the tool could reach and did not clear"),
        ),
        (
            _translate("EvenLoad", "Retracts %d") % values["Retracts"],
            _translate("EvenLoad", "How often the tool rises and comes down again"),
        ),
    ]


class Status:
    """Its two widgets: `top`, which always shows, and `notes`, which may be scrolled.

    followed: a bound method that is called with the Piece that a click was on; it is not kept
    alive.
    """

    def __init__(self, followed):
        self._followed = telling_slot(followed)
        self._pieces = []  # of links, which have their numbers
        self._shown = ()  # the arguments of show()
        self.top, self.notes = _Seen(self._show_again), QtGui.QWidget()
        above, below = _column(self.top), _column(self.notes)
        self._state, self._warnings, self._remarks = (self._label() for _ in range(3))
        self._figures = [self._label() for _ in range(4)]
        self._fold = QtGui.QToolButton()
        self._fold.setAutoRaise(True)
        self._fold.setCheckable(True)
        self._fold.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self._fold.toggled.connect(slot(self._show_fold))
        grid = QtGui.QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(0)
        grid.addWidget(self._figures[0], 0, 0, 1, 2)
        grid.addWidget(self._figures[1], 1, 0, 1, 2)
        grid.addWidget(self._figures[2], 2, 0)
        grid.addWidget(self._figures[3], 2, 1)
        above.addWidget(self._state)
        above.addLayout(grid)
        for widget in (self._warnings, self._fold, self._remarks):
            below.addWidget(widget)

    def show(self, state, sentence, figures=(), said=()):
        """Shows a state and the sentence for it. figures: at most four, as figures_of() tells them;
        the first two stand in lines of their own; said: sentences on the path.
        """
        self._pieces, self._shown = [], (state, sentence, figures, said)
        self._ground = colours.ground_of(self._state)
        mark, colour = MARKS[state]
        shade = self._shade(colour)
        self._state.setText(
            '<span style="color:%s"><b>%s</b></span> %s' % (shade, mark, self._linked(sentence))
        )
        # What was computed before a change still stands: its path is the one that is seen.
        lines = figures if state != FAILED else []
        lines = [*lines, *[("", "")] * (len(self._figures) - len(lines))]
        for label, (text, tip) in zip(self._figures, lines):
            label.setText(text)
            label.setToolTip(tip)
            label.setEnabled(state in (VALID, PREVIEW))
            label.setVisible(bool(text))
        warnings = [s for s in said if notes.kind_of(s) == notes.WARNING]
        remarks = [s for s in said if s not in (*warnings, notes.CHECKED)]
        self._warnings.setText(self._listed(warnings, colours.CAUTION, "\u26a0"))
        self._warnings.setVisible(bool(warnings))
        self._remarks.setText(self._listed(remarks, None, "\u2022"))
        self._fold.setText(_translate("EvenLoad", "Remarks (%d)") % len(remarks))
        self._fold.setVisible(bool(remarks))
        self._show_fold()
        self.top.keep_height()

    def _show_again(self):
        """In colours for the ground, which is not known before the panel is seen."""
        if self._shown:
            self.show(*self._shown)

    def _shade(self, colour):
        return colours.shade(colour, self._state, self._ground)

    def text(self):
        """All that it tells, as plain lines, the folded ones too."""
        labels = [self._state, *self._figures, self._warnings, self._remarks]
        document = QtGui.QTextDocument()
        lines = []
        for label in labels:
            document.setHtml(label.text())
            lines += [line for line in document.toPlainText().splitlines() if line.strip()]
        return "\n".join(lines)

    def _show_fold(self):
        is_open = self._fold.isChecked()
        self._fold.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)
        self._remarks.setVisible(is_open and not self._fold.isHidden())

    def _listed(self, sentences, colour, mark):
        if colour is not None:
            mark = '<span style="color:%s">%s</span>' % (self._shade(colour), mark)
        return "<br>".join("%s %s" % (mark, self._linked(each)) for each in sentences)

    def _linked(self, sentence):
        """A sentence as rich text in the user's language, with its places and fields as links."""
        shade, result = self._shade(colours.LINK), []
        for piece in notes.shown_pieces(sentence):
            text = html.escape(piece.text)
            if piece.place or piece.field:
                self._pieces.append(piece)
                text = '<a href="%d" style="color:%s">%s</a>' % (len(self._pieces) - 1, shade, text)
            result.append(text)
        return "".join(result)

    def _follow(self, number):
        self._followed(self._pieces[int(number)])

    def _label(self):
        label = QtGui.QLabel()
        label.setWordWrap(True)
        label.setTextFormat(QtCore.Qt.RichText)
        label.setTextInteractionFlags(
            QtCore.Qt.TextSelectableByMouse
            | QtCore.Qt.LinksAccessibleByMouse
            | QtCore.Qt.LinksAccessibleByKeyboard
        )
        label.linkActivated.connect(telling_slot(self._follow))
        return label


class _Seen(QtGui.QWidget):
    """A widget that has a bound method called as it is seen, when its window has its colours, and
    as it comes to its place: a dock of FreeCAD 1.1 may be seen before. All of its text is seen.
    """

    def __init__(self, seen):
        super().__init__()
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(0)
        self._timer.timeout.connect(slot(seen))

    def showEvent(self, event):
        super().showEvent(event)
        self._timer.start()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self.keep_height()
        self._timer.start()

    def keep_height(self):
        """Asks for the height that its texts need at its width: in a low panel they would get less,
        for labels that wrap are said to do with little.
        """
        self.setMinimumHeight(self.layout().totalHeightForWidth(self.width()))


def _column(widget):
    layout = QtGui.QVBoxLayout(widget)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(2)
    return layout
