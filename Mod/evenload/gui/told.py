"""Labels of docks for what is to be said of what they show."""

from PySide import QtCore

from evenload.gui.shaded import Shaded
from evenload.settings.sentences import shown


class Told(Shaded):
    """Shows sentences in the user's language and units, and hides where there are none."""

    def __init__(self):
        super().__init__(form=QtCore.Qt.PlainText)
        self._said = ("",)
        self.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)

    def tell(self, text, colour=None, named=""):
        """Shows sentences in place of those before. named: another text below them, which names
        what is the user's, and is shown as it is.
        """
        self._said = text, colour, named
        super().tell("\n".join(filter(None, (shown(text), named))), colour)
        self.setVisible(bool(self.text()))

    def follow_units(self):
        """Tells the same in the units that the user has chosen by now."""
        self.tell(*self._said)
