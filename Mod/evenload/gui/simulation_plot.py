"""Plots of simulations over time as a widget: drawn by matplotlib, cursors and mouse by Qt."""

import numpy
from PySide import QtCore, QtGui

from evenload.gui import colours
from evenload.gui.chart import Chart
from evenload.pictures import load_rows

LEAST = 420, 300  # pixels
STEP = 1.25  # of the zoom, for each notch of the wheel
NOTCH = 120.0  # Qt's number for it
SHORTEST = 0.01  # s that are seen at the least
PALE = QtGui.QColor("#9aa0a6")  # of the cursor in a run that is not the active one


class PlotView(Chart):
    """Shows Runs of load_rows and a cursor in each: the number of a sample.

    A click or drag with the left button moves a cursor, the wheel zooms, a drag with another button
    moves the span that is seen, a double click shows all. `placed` is told with the number of a run
    and that of a sample.
    """

    placed = QtCore.Signal(int, int)

    def __init__(self, parent=None):
        super().__init__(LEAST, parent)
        self.runs, self.cursors, self.active = [], [], 0
        self.limits, self.span = {}, None
        self._held = None

    def show_runs(self, runs, limits):
        """Shows runs, all of their time if they are others than before."""
        if [run.name for run in runs] != [run.name for run in self.runs]:
            self.span = None
        self.runs, self.limits, self.message = runs, limits, ""
        self.cursors, self._held = [0] * len(runs), None
        self.active = min(self.active, max(0, len(runs) - 1))
        self.redraw()

    def show_limits(self, limits):
        self.limits = limits
        self.redraw()

    def show_message(self, text):
        """In place of plots."""
        self.runs, self.cursors, self.message, self._held = [], [], text, None
        self.redraw()

    def show_cursor(self, number, sample):
        """Shows the cursor of a run, which is the active one from now on, at a sample."""
        self.active, self.cursors[number] = number, sample
        self._keep_in_sight(self.cursor_time(number))
        self.update()

    def show_span(self, begin, end):
        """Shows the times from one to another, in s, as far as there are any."""
        low, high = load_rows.whole(self.runs)
        length = min(max(end - begin, SHORTEST), high - low)
        begin = min(max(begin, low), high - length)
        self.span = (begin, begin + length)
        self.redraw()

    def show_all(self):
        self.span = None
        self.redraw()

    def cursor_time(self, number):
        """s: where the cursor of a run is."""
        return float(self.runs[number].time[self.cursors[number]])

    # ---- places ----

    def pixel_of(self, number, row, time):
        """The place in the widget of a time in s at the foot of a row, a QPointF."""
        axes = self.drawn()[number][row]
        x = self.pixel_at(axes, time, 0.0).x()
        return QtCore.QPointF(x, self.height() - axes.bbox.y0 / self.ratio)

    def place_at(self, place):
        """(number of a run, time in s) at a place in the widget; None beside the plots."""
        for number, column in enumerate(self.drawn() or ()):
            for axes in column:
                found = self.values_at(axes, place)
                if found is not None:
                    return number, found[0]
        return None

    def _seen(self):
        return self.span or load_rows.whole(self.runs)

    def _keep_in_sight(self, time):
        """Moves the span that is seen until a time is in it."""
        begin, end = self._seen()
        if not begin <= time <= end:
            half = 0.5 * (end - begin)
            self.show_span(time - half, time + half)

    # ---- Qt's ----

    def paintEvent(self, _):
        painter = QtGui.QPainter(self)
        if self.paint(painter):
            for number in range(len(self.runs)):
                self._draw_cursor(painter, number)

    def mousePressEvent(self, event):
        found = self.place_at(event.pos())
        if found is None:
            return
        if event.button() == QtCore.Qt.LeftButton:
            self._held = ("cursor", found[0])
            self._place(*found)
        else:
            self._held = ("span", event.pos().x(), self._seen())

    def mouseMoveEvent(self, event):
        if self._held is None:
            return
        if self._held[0] == "cursor":
            number = self._held[1]
            found = self.place_at(event.pos())
            if found is not None and found[0] == number:
                self._place(number, found[1])
            return
        _, begin, (low, high) = self._held
        width = self.drawn()[0][0].bbox.width / self.ratio
        moved = (event.pos().x() - begin) / width * (high - low)
        self.show_span(low - moved, high - moved)

    def mouseReleaseEvent(self, _):
        self._held = None

    def mouseDoubleClickEvent(self, _):
        self.show_all()

    def wheelEvent(self, event):
        found = self.place_at(event.position())
        if found is None:
            return
        share = STEP ** (-event.angleDelta().y() / NOTCH)
        begin, end = self._seen()
        time = found[1]
        self.show_span(time - share * (time - begin), time + share * (end - time))
        event.accept()

    def _place(self, number, time):
        run = self.runs[number]
        sample = int(numpy.argmin(numpy.abs(run.time - time)))
        self.show_cursor(number, sample)
        self.placed.emit(number, sample)

    # ---- drawing ----

    def _draw(self, figure):
        """[[axes for each row] for each run]"""
        if not self.runs:
            return None
        return load_rows.draw(figure, self.runs, self.limits, self.span)

    def _draw_cursor(self, painter, number):
        begin, end = self._seen()
        time = self.cursor_time(number)
        if not begin <= time <= end:
            return
        active = QtGui.QColor(colours.drawn(colours.BAD, self))
        painter.setPen(QtGui.QPen(active if number == self.active else PALE, 1.5))
        for row, axes in enumerate(self.drawn()[number]):
            foot = self.pixel_of(number, row, time)
            painter.drawLine(foot, foot - QtCore.QPointF(0, axes.bbox.height / self.ratio))
