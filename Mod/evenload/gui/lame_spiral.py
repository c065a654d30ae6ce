"""The Lamé spiral operation's panel."""

from evenload.gui import panel
from evenload.operations import lame_spiral


class OperationPage(panel.OperationPage):
    kind = lame_spiral.LameSpiral
    manual_page = "lame_spiral_operation"


def create():
    """Creates the operation for what is selected and opens its panel."""
    return panel.create(lame_spiral)
