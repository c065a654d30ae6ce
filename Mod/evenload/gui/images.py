"""matplotlib's figures as Qt's images, whichever Qt and Python binding there is."""

from PySide import QtGui


def image_of(figure):
    """A QImage of a figure as large as the figure is, in its own dots."""
    figure.canvas.draw()
    width, height = figure.canvas.get_width_height()
    data = bytes(figure.canvas.buffer_rgba())
    image = QtGui.QImage(data, width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
    return image.copy()  # the data is gone when this function ends
