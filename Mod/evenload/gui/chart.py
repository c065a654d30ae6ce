"""What charts in windows share: matplotlib draws them into an image, Qt paints what moves on it."""

from PySide import QtCore, QtGui

from evenload.gui import colours
from evenload.gui.images import image_of
from evenload.pictures.figure import DARK, LIGHT, new_figure, put_on
from evenload.settings.sentences import shown

INCH = 96.0  # pixels, of the charts' letters
MARGIN = 20  # pixels around what is told in place of a chart


class Chart(QtGui.QWidget):
    """A widget for axes that are drawn anew when its size, the theme or units change.

    A class has `_draw(figure)`, which draws into an empty figure and returns its axes in any form,
    None where there is nothing to draw; `message` is told then.
    """

    def __init__(self, least, parent=None):
        """least: (width, height) in pixels that it has at the least."""
        super().__init__(parent)
        self.setMinimumSize(*least)
        self.message = ""
        self._image = self._axes = None
        self.ratio = 1.0  # dots of the image per pixel

    def redraw(self):
        """Draws anew, once it is seen."""
        self._image = self._axes = None
        self.update()

    def follow_units(self):
        """Draws in the units that the user has chosen by now."""
        self.redraw()

    def drawn(self):
        """The axes as `_draw` returned them, drawn by now."""
        if self._image is None or self.ratio != self.devicePixelRatioF():
            self.ratio = self.devicePixelRatioF()  # another one on another screen
            figure = new_figure(self.width() / INCH, self.height() / INCH)
            figure.set_dpi(INCH * self.ratio)
            self._axes = self._draw(figure)
            if self.ground is not LIGHT:
                put_on(figure, self.ground)
            self._image = image_of(figure)
            self._image.setDevicePixelRatio(self.ratio)
        return self._axes

    @property
    def ground(self):
        """The Ground that goes with the theme."""
        return colours.drawn((LIGHT, DARK), self)

    def paint(self, painter):
        """Paints the ground and the image on it, or the message; tells whether it is the image."""
        painter.fillRect(self.rect(), QtGui.QColor(self.ground.paper))
        if self.drawn() is None:
            painter.setPen(QtGui.QColor(colours.drawn(colours.QUIET, self)))
            where = self.rect().adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)
            flags = QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap
            painter.drawText(where, flags, shown(self.message))
            return False
        painter.drawImage(0, 0, self._image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        return True

    # ---- places ----

    def pixel_at(self, axes, x, y):
        """The place in the widget of values in matplotlib's axes, a QPointF."""
        x, y = axes.transData.transform((x, y))
        return QtCore.QPointF(x / self.ratio, self.height() - y / self.ratio)

    def values_at(self, axes, place):
        """(x, y) in axes at a place in the widget; None beside the axes."""
        x, y = place.x() * self.ratio, (self.height() - place.y()) * self.ratio
        if not axes.bbox.contains(x, y):
            return None
        x, y = axes.transData.inverted().transform((x, y))
        return float(x), float(y)

    # ---- Qt's ----

    def resizeEvent(self, event):
        self._image = self._axes = None
        super().resizeEvent(event)

    def changeEvent(self, event):
        if event.type() in (QtCore.QEvent.PaletteChange, QtCore.QEvent.StyleChange):
            self.redraw()
        super().changeEvent(event)
