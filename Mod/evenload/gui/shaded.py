"""Labels in colours that can be read where they stand."""

from PySide import QtCore, QtGui

from evenload.gui import colours
from evenload.gui.slots import slot


class Shaded(QtGui.QLabel):
    """A label for sentences in a colour of `colours`. The ground that it stands on is not known
    before it is seen, for style sheets count from then on: the shade is chosen again then.
    """

    def __init__(self, text="", form=QtCore.Qt.AutoText):
        super().__init__(text)
        self.setTextFormat(form)
        self.setWordWrap(True)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self._colour = None
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(0)
        self._timer.timeout.connect(slot(self._shade))

    def tell(self, text, colour=None):
        """Shows sentences in a colour, or in that of the theme."""
        self.setText(text)
        self.colour(colour)

    def colour(self, colour):
        """Has its text be in a colour, or in that of the theme."""
        self._colour = colour
        self._shade()

    def showEvent(self, event):
        super().showEvent(event)
        self._timer.start()

    def _shade(self):
        self.setStyleSheet("")  # where neither shade can be read, it is the theme's own that counts
        if self._colour:
            self.setStyleSheet("color: %s" % colours.shade(self._colour, self))
