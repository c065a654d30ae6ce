"""Trochoid: cuts slots by trochoids at constant engagement."""

from evenload import compiled
from evenload.operations import base, registry
from evenload.settings.results import RESULTS_OF_TROCHOID, RESULT_SETTINGS
from evenload.settings.table import OF_TROCHOID, SETTINGS

NAME = "EvenLoad Trochoid"


class Trochoid(base.Operation):
    """Proxy of the trochoid operation. Documents refer to this class by its module and name: both
    stay.
    """

    name = NAME
    settings = (*SETTINGS, *OF_TROCHOID)
    results = (*RESULT_SETTINGS, *RESULTS_OF_TROCHOID)

    def floors(self, obj, tool):
        def slot(chain, closed, name):
            if not obj.SlotWidth.Value > 0:
                if closed:
                    return None
                raise ValueError(
                    "%s is open, the centreline of a slot: set SlotWidth, or close it." % name
                )
            if obj.SlotWidth.Value < tool.diameter:
                raise ValueError(
                    "SlotWidth (%g mm) is less than the tool's diameter of %g mm: take a smaller "
                    "tool or widen the slot." % (obj.SlotWidth.Value, tool.diameter)
                )
            try:
                middle = [vertex[:3] for vertex in chain]
                return compiled.core().slot_around(middle, width=obj.SlotWidth.Value, closed=closed)
            except ValueError as error:
                raise ValueError("%s: %s" % (name, error)) from None

        found = super().floors(obj, tool, slot)
        for floor in found:
            if floor.is_face and obj.SlotWidth.Value > 0:
                floor.notes.append(
                    "SlotWidth was not used for %s: a face has its own width." % floor.name
                )
        return found

    def generate(self, settings, core, regions, parameters):
        toolpath, figures = core.clear_slot(regions, **parameters)
        return toolpath, {
            "TrochoidalStep": figures.step,
            "Iterations": figures.iterations,
            "RemovalRate": figures.removal_rate,
        }

    def results_of(self, cuts):
        return max(cuts, key=lambda cut: cut.toolpath.report.cut_length / len(cut.levels)).own


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new trochoid operation, as a document object; see registry.create for the arguments."""
    return registry.create(Trochoid, name, obj, parentJob, toolController)


registry.register(Trochoid, Create)
