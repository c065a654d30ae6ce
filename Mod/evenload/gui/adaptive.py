"""The adaptive operation's panel."""

from evenload.gui import panel
from evenload.operations import adaptive


class OperationPage(panel.OperationPage):
    kind = adaptive.Adaptive
    manual_page = "adaptive_operation"


def create():
    """Creates the operation for what is selected and opens its panel."""
    return panel.create(adaptive)
