"""The trochoid operation's panel."""

from evenload.gui import panel
from evenload.operations import trochoid


class OperationPage(panel.OperationPage):
    kind = trochoid.Trochoid
    manual_page = "trochoid_operation"


def create():
    """Creates the operation for what is selected and opens its panel."""
    return panel.create(trochoid)
