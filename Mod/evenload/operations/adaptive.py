"""Adaptive: clears any pocket at constant engagement."""

from evenload.operations import base, registry
from evenload.settings.table import OF_ADAPTIVE, SETTINGS

NAME = "EvenLoad Adaptive"


class Adaptive(base.Operation):
    """Proxy of the adaptive operation. Documents refer to this class by its module and name: both
    stay.
    """

    name = NAME
    settings = (*SETTINGS, *OF_ADAPTIVE)

    def generate(self, settings, core, regions, parameters):
        return core.clear_pocket(regions, **parameters), {}


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new adaptive operation, as a document object; see registry.create for the arguments."""
    return registry.create(Adaptive, name, obj, parentJob, toolController)


registry.register(Adaptive, Create)
