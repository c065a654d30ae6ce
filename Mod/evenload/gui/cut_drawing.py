"""A small drawing of the cut: the tool seen from above, as deep in the material as it is set."""

import math

from PySide import QtCore, QtGui

from evenload.gui import colours

WIDTH, HEIGHT = 50, 46  # pixels
TOOL = 0.38  # of the height: the tool's radius
ARC = 4  # pixels


class CutDrawing(QtGui.QWidget):
    """The tool moves up; the material that it cuts stands on its right, or left in conventional
    milling.
    """

    def __init__(self):
        super().__init__()
        self.setFixedSize(WIDTH, HEIGHT)
        self._degrees, self._is_climb = 0.0, True

    def show_cut(self, degrees, is_climb):
        """degrees: the engagement angle, 0 to 180."""
        if (degrees, is_climb) != (self._degrees, self._is_climb):
            self._degrees, self._is_climb = degrees, is_climb
            self.update()

    def paintEvent(self, _):
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        middle = QtCore.QPointF(0.5 * WIDTH, 0.56 * HEIGHT)
        painter.translate(middle)
        if not self._is_climb:
            painter.scale(-1, 1)
        radius = TOOL * HEIGHT
        angle = min(max(self._degrees, 0.0), 180.0)
        edge = radius * math.cos(math.radians(angle))  # how far beside the tool's middle it stands
        palette = self.palette()
        ink, ground = palette.windowText().color(), palette.windowText().color()
        ground.setAlphaF(0.22)
        half = 0.5 * WIDTH
        # The material: all ahead of the tool that it will cut, and what stays beside its way.
        material = QtGui.QPainterPath()
        material.addRect(QtCore.QRectF(edge, -HEIGHT, half, 2 * HEIGHT))
        way, disc = QtGui.QPainterPath(), QtGui.QPainterPath()
        way.addRect(QtCore.QRectF(-radius, 0, 2 * radius, HEIGHT))
        disc.addEllipse(QtCore.QPointF(0, 0), radius, radius)
        painter.fillPath(material.subtracted(way.united(disc)), ground)
        painter.setPen(QtGui.QPen(ink, 1))
        painter.drawEllipse(QtCore.QPointF(0, 0), radius, radius)
        pen = QtGui.QPen(QtGui.QColor(colours.drawn(colours.LINK, self)), ARC)
        pen.setCapStyle(QtCore.Qt.FlatCap)
        painter.setPen(pen)
        # Qt counts sixteenths of degrees from the right, counter-clockwise.
        box = QtCore.QRectF(-radius, -radius, 2 * radius, 2 * radius)
        painter.drawArc(box, 0, round(16 * angle))
        painter.setPen(QtGui.QPen(ink, 1))
        painter.drawLine(QtCore.QPointF(0, 0), QtCore.QPointF(0, -0.6 * radius))
        for side in (-1, 1):
            painter.drawLine(
                QtCore.QPointF(0, -0.6 * radius), QtCore.QPointF(side * 3, -0.6 * radius + 4)
            )
        painter.end()
