"""A column of widgets beside others, as wide as what it shows needs."""

from PySide import QtGui

EDGE = 4  # pixels beside the scroll bar


class FittedColumn(QtGui.QScrollArea):
    """Can be scrolled up and down; sideways where its content needs more than the widest."""

    def __init__(self, content, least, widest):
        """content: a widget with a layout; least, widest: pixels."""
        super().__init__()
        self._least, self._widest = least, widest
        self.setWidgetResizable(True)
        self.setFrameShape(QtGui.QFrame.NoFrame)
        self.setWidget(content)
        self.fit()

    def fit(self):
        """Takes the width that the content needs by now."""
        bar = self.verticalScrollBar().sizeHint().width()
        needed = self.widget().minimumSizeHint().width() + bar + EDGE
        self.setFixedWidth(min(max(self._least, needed), self._widest))
