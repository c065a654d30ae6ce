"""matplotlib's figures as Qt's images, whichever Qt and Python binding there is."""

from PySide import QtCore, QtGui

from evenload.settings.sentences import shown

INK = QtGui.QColor("#5f6368")
MARGIN = 20  # pixels


def image_of(figure):
    """A QImage of a figure as large as the figure is, in its own dots."""
    figure.canvas.draw()
    width, height = figure.canvas.get_width_height()
    data = bytes(figure.canvas.buffer_rgba())
    image = QtGui.QImage(data, width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
    return image.copy()  # the data is gone when this function ends


def paint_message(painter, box, text):
    """Words in the middle of a box, in place of a picture."""
    painter.setPen(INK)
    where = box.adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)
    painter.drawText(where, QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap, shown(text))
