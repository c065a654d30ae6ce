"""Marks on fields that want the user's attention."""

from evenload.gui import colours


class Marks:
    """The label of one field at a time."""

    def __init__(self):
        self._marked = None

    def set(self, label):
        """Marks a field by its label, and no other."""
        self.clear()
        self._marked = label
        label.setStyleSheet(
            "font-weight: bold; text-decoration: underline; color: %s"
            % colours.shade(colours.BAD, label)
        )

    def clear(self):
        if self._marked is not None:
            self._marked.setStyleSheet("")
        self._marked = None
