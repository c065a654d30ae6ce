"""Labels of docks for what is to be said of what they show."""

from PySide import QtCore, QtGui

from evenload.gui import colours
from evenload.settings.sentences import shown


class Told(QtGui.QLabel):
    """Shows sentences in the user's language and units, and hides where there are none."""

    def __init__(self):
        super().__init__()
        self._said = ("",)
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.PlainText)
        self.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def tell(self, text, colour=None, named=""):
        """Shows sentences in place of those before. named: another text below them, which names
        what is the user's, and is shown as it is.
        """
        self._said = text, colour, named
        self.setText("\n".join(filter(None, (shown(text), named))))
        self.setStyleSheet("color: %s" % colours.shade(colour, self) if colour else "")
        self.setVisible(bool(self.text()))

    def follow_units(self):
        """Tells the same in the units that the user has chosen by now."""
        self.tell(*self._said)
