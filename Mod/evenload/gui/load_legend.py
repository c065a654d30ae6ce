"""The legend of the load view: the scale with its ends, and the colours of what is not on it."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload.gui import load_colours, preferences
from evenload.gui.values import told
from evenload.planar import CUT, ENTRY, LINK, RAPID

BAR = 14  # pixels
STEPS = 64  # of the scale's colours
SWATCH_LINES = 2  # for which there is room always, so that what is below stays where it is mostly
APART, BELOW = 12, 2  # pixels between swatches, between lines
NAMES = {
    CUT: "cut",
    load_colours.WALL: "cut along a wall",
    ENTRY: "entry",
    LINK: "link",
    RAPID: "rapid",
}

_translate = FreeCAD.Qt.translate


class Legend(QtGui.QWidget):
    def __init__(self):
        super().__init__()
        self._measure, self._least, self._largest, self._limit = None, 0.0, 1.0, None
        self.setMinimumWidth(180)
        self._fit()

    def show_scale(self, measure, least, largest, limit):
        self._measure, self._least, self._largest, self._limit = measure, least, largest, limit
        self._fit()
        self.update()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event):
        super().changeEvent(event)
        if event.type() == QtCore.QEvent.FontChange:
            self._fit()

    def _fit(self):
        """Takes the height that all swatches need at this width."""
        line = self._line()
        least = BAR + (1 + SWATCH_LINES) * (line + BELOW) + 6
        lines = 1 + max([number for _, number, _, _ in self._places()], default=0)
        needed = self._swatches_top() + lines * (line + BELOW)
        self.setFixedHeight(max(least, needed))

    def _line(self):
        return QtGui.QFontMetrics(self.font()).height()

    def _swatches_top(self):
        has_scale = self._measure is not load_colours.KIND
        return 2 + (BAR + self._line() + 4 if has_scale else 0)

    def paintEvent(self, _):
        if self._measure is None:
            return
        painter = QtGui.QPainter(self)
        if self._measure is not load_colours.KIND:
            self._paint_scale(painter, self._line())
        self._paint_swatches(painter, self._swatches_top())
        painter.end()

    def _paint_scale(self, painter, line):
        width = self.width() / STEPS
        share = [(k + 0.5) / STEPS for k in range(STEPS)]
        values = [self._least + each * (self._largest - self._least) for each in share]
        colours = load_colours.on_scale(share, preferences.scale())
        for k, (colour, value) in enumerate(zip(colours, values)):
            if self._limit is not None and value > self._limit:
                colour = load_colours.BEYOND
            painter.fillRect(QtCore.QRectF(k * width, 0, width + 1, BAR), _qt(colour))
        texts = [(QtCore.Qt.AlignLeft, self._least), (QtCore.Qt.AlignRight, self._largest)]
        painter.setPen(self.palette().windowText().color())
        box = QtCore.QRectF(0, BAR + 1, self.width(), line)
        for side, value in texts:
            painter.drawText(box, side | QtCore.Qt.AlignTop, told(self._measure.quantity, value))

    def swatches(self):
        """[(colour, text), ...] of what is not on the scale."""
        of_all = self._measure is load_colours.KIND
        off_the_scale = {*NAMES} - {load_colours.WALL, *self._measure.kinds}
        kinds = [
            (load_colours.KINDS[kind], _translate("EvenLoad", name))
            for kind, name in NAMES.items()
            if of_all or kind in off_the_scale
        ]
        if self._limit is None:
            return kinds
        above = _translate("EvenLoad", "cut above %s") % told(self._measure.quantity, self._limit)
        return [(load_colours.BEYOND, above), *kinds]

    def _places(self):
        """[(x, number of the line, colour, text), ...] of the swatches at this width."""
        found, x, line = [], 0, 0
        metrics = QtGui.QFontMetrics(self.font())
        for colour, text in self.swatches() if self._measure is not None else ():
            width = BAR + 4 + metrics.boundingRect(text).width()
            if x > 0 and x + width > self.width():
                x, line = 0, line + 1
            found.append((x, line, colour, text))
            x += width + APART
        return found

    def _paint_swatches(self, painter, top):
        metrics = QtGui.QFontMetrics(self.font())
        painter.setPen(self.palette().windowText().color())
        for x, line, colour, text in self._places():
            y = top + line * (metrics.height() + BELOW)
            painter.fillRect(x, y + 2, BAR, BAR - 4, _qt(colour))
            painter.drawText(x + BAR + 4, y + metrics.ascent() - 1, text)


def _qt(colour):
    return QtGui.QColor.fromRgbF(*map(float, colour))
