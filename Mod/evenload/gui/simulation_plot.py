"""Plots of simulations over time as a widget: drawn by matplotlib, cursors and mouse by Qt."""

import FreeCAD
import numpy
from PySide import QtCore, QtGui

from evenload.gui.images import image_of, paint_message
from evenload.pictures import load_rows
from evenload.pictures.figure import new_figure

_translate = FreeCAD.Qt.translate

INCH = 96.0  # pixels, of the plots' letters
LEAST = 420, 300  # pixels
STEP = 1.25  # of the zoom, for each notch of the wheel
NOTCH = 120.0  # Qt's number for it
SHORTEST = 0.01  # s that are seen at the least
CURSOR, PALE = QtGui.QColor("#b3261e"), QtGui.QColor("#9aa0a6")


class PlotView(QtGui.QWidget):
    """Shows Runs of load_rows and a cursor in each: the number of a sample.

    A click or drag with the left button moves a cursor, the wheel zooms, a drag with another button
    moves the span that is seen, a double click shows all. `placed` is told with the number of a run
    and that of a sample.
    """

    placed = QtCore.Signal(int, int)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setMinimumSize(*LEAST)
        self.runs, self.cursors, self.active = [], [], 0
        self.limits, self.span = {}, None
        self.message = ""
        self._image = self._axes = self._held = None

    def show_runs(self, runs, limits):
        """Shows runs, all of their time if they are others than before."""
        if [run.name for run in runs] != [run.name for run in self.runs]:
            self.span = None
        self.runs, self.limits, self.message = runs, limits, ""
        self.cursors = [0] * len(runs)
        self.active = min(self.active, max(0, len(runs) - 1))
        self._redraw()

    def show_limits(self, limits):
        self.limits = limits
        self._redraw()

    def follow_units(self):
        """Draws in the units that the user has chosen by now."""
        self._redraw()

    def show_message(self, text):
        """In place of plots."""
        self.runs, self.cursors, self.message = [], [], text
        self._redraw()

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
        self._redraw()

    def show_all(self):
        self.span = None
        self._redraw()

    def cursor_time(self, number):
        """s: where the cursor of a run is."""
        return float(self.runs[number].time[self.cursors[number]])

    # ---- places ----

    def pixel_of(self, number, row, time):
        """The place in the widget of a time in s at the foot of a row, a QPointF."""
        axes, ratio = self._drawn()[number][row], self._image.devicePixelRatio()
        x, _ = axes.transData.transform((time, 0.0))
        return QtCore.QPointF(x / ratio, self.height() - axes.bbox.y0 / ratio)

    def place_at(self, place):
        """(number of a run, time in s) at a place in the widget; None beside the plots."""
        if not self.runs:
            return None
        drawn, ratio = self._drawn(), self._image.devicePixelRatio()
        x, y = place.x() * ratio, (self.height() - place.y()) * ratio
        for number, column in enumerate(drawn):
            for axes in column:
                if axes.bbox.contains(x, y):
                    return number, float(axes.transData.inverted().transform((x, y))[0])
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

    def resizeEvent(self, event):
        self._image = self._axes = None
        super().resizeEvent(event)

    def paintEvent(self, _):
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), QtCore.Qt.white)
        if not self.runs:
            paint_message(painter, self.rect(), self.message)
            return
        self._drawn()
        painter.drawImage(0, 0, self._image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
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
        self._drawn()
        width = self._axes[0][0].bbox.width / self._image.devicePixelRatio()
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

    def _redraw(self):
        self._image = self._axes = None
        self.update()

    def _drawn(self):
        """The axes, [[one for each row] for each run], drawn anew where something has changed."""
        if self._axes is None:
            ratio = self.devicePixelRatioF()
            figure = new_figure(self.width() / INCH, self.height() / INCH)
            figure.set_dpi(INCH * ratio)
            self._axes = load_rows.draw(figure, self.runs, self.limits, self.span)
            self._image = image_of(figure)
            self._image.setDevicePixelRatio(ratio)
        return self._axes

    def _draw_cursor(self, painter, number):
        begin, end = self._seen()
        time = self.cursor_time(number)
        if not begin <= time <= end:
            return
        pen = QtGui.QPen(CURSOR if number == self.active else PALE, 1.5)
        painter.setPen(pen)
        for row, axes in enumerate(self._axes[number]):
            foot = self.pixel_of(number, row, time)
            height = axes.bbox.height / self._image.devicePixelRatio()
            painter.drawLine(foot, foot - QtCore.QPointF(0, height))
