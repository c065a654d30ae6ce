"""The stability chart as a widget: drawn by matplotlib, points and mouse by Qt."""

import FreeCAD
from PySide import QtCore, QtGui

from evenload import units
from evenload.gui import colours
from evenload.gui.chart import Chart
from evenload.stability import picture

_translate = FreeCAD.Qt.translate

STABLE, UNSTABLE, UNKNOWN = (
    QtGui.QColor(c) for c in (picture.STABLE_POINT, picture.UNSTABLE_POINT, picture.GREY)
)
RADIUS = 6  # pixels, of the point that is chosen; the operation's own is a ring around it
MARGINS = 62, 16, 12, 48  # pixels around the axes: left, right, top, bottom
LEAST = 420, 320  # pixels


class ChartView(Chart):
    """Shows a Field, the operation's point and the chosen one.

    `chosen` is told when the user clicks a point, which is `point` then: (rev/min, mm). `taken` is
    told for a double click.
    """

    chosen = QtCore.Signal()
    taken = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(LEAST, parent)
        self.setMouseTracking(True)
        self.field = None
        self.operation = self.point = self.is_stable = None
        self._under_mouse = None

    def show_field(self, field):
        self.field, self.message = field, ""
        self.redraw()

    def show_message(self, text):
        """In place of a chart."""
        self.field, self.message = None, text
        self.redraw()

    def show_points(self, operation, point, is_stable):
        """(rev/min, mm) each; is_stable: None where it is not known yet."""
        self.operation, self.point, self.is_stable = operation, point, is_stable
        self.update()

    # ---- places ----

    def pixel_of(self, point):
        """The place of (rev/min, mm) in the widget, a QPointF; None without a chart."""
        axes = self.drawn()
        return axes and self.pixel_at(axes, *point)

    def point_at(self, place):
        """(rev/min, mm) at a place of the widget; None beside the chart."""
        found = self.drawn() and self.values_at(self.drawn(), place)
        return found if found and found[1] > 0 else None

    # ---- Qt's ----

    def paintEvent(self, _):
        painter = QtGui.QPainter(self)
        if not self.paint(painter):
            return
        self._draw_points(painter)
        painter.setPen(QtGui.QColor(colours.drawn(colours.QUIET, self)))
        legend = _translate("EvenLoad", "○ as it is   ● as chosen")
        painter.drawText(self._margins(), QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop, legend)
        if self._under_mouse is not None:
            text = self._told_under_mouse()
            painter.drawText(self._margins(), QtCore.Qt.AlignRight | QtCore.Qt.AlignTop, text)

    def _told_under_mouse(self):
        (speed, depth), unit = self._under_mouse, units.LENGTH.shown
        told = _translate("EvenLoad", "%.0f rev/min, %.3g %s")
        return told % (speed, depth / unit.size, unit.name)

    def mouseMoveEvent(self, event):
        self._under_mouse = self.point_at(event.pos())
        self.setCursor(QtCore.Qt.CrossCursor if self._under_mouse else QtCore.Qt.ArrowCursor)
        self.update()

    def leaveEvent(self, _):
        self._under_mouse = None
        self.update()

    def mousePressEvent(self, event):
        point = self.point_at(event.pos())
        if event.button() == QtCore.Qt.LeftButton and point is not None:
            self.point, self.is_stable = point, None
            self.update()
            self.chosen.emit()

    def mouseDoubleClickEvent(self, event):
        if event.button() == QtCore.Qt.LeftButton and self.point_at(event.pos()) is not None:
            self.taken.emit()

    # ---- drawing ----

    def _draw(self, figure):
        if self.field is None:
            return None
        width, height = self.width(), self.height()
        # Not left to matplotlib, which takes longer for it than for the rest.
        left, right, top, bottom = MARGINS
        axes = figure.add_axes(
            (
                *(left / width, bottom / height),
                *(1 - (left + right) / width, 1 - (top + bottom) / height),
            )
        )
        picture.draw(axes, self.field)
        return axes

    def _margins(self):
        """Where words stand within the axes."""
        box, ratio = self.drawn().bbox, self.ratio
        left, right = round(box.x0 / ratio), round(box.x1 / ratio)
        top = self.height() - round(box.y1 / ratio)
        return QtCore.QRect(left, top, right - left, self.height()).adjusted(8, 8, -8, 0)

    def _draw_points(self, painter):
        colour = {None: UNKNOWN, True: STABLE, False: UNSTABLE}[self.is_stable]
        painter.setClipRect(self.rect())
        if self.operation is not None:
            painter.setPen(QtGui.QPen(QtGui.QColor(self.ground.ink), 2))
            painter.drawEllipse(self.pixel_of(self.operation), RADIUS + 3, RADIUS + 3)
        if self.point is not None:
            painter.setPen(QtGui.QPen(QtCore.Qt.white, 1.5))
            painter.setBrush(colour)
            painter.drawEllipse(self.pixel_of(self.point), RADIUS, RADIUS)
