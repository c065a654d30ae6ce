"""Trochoid: cuts slots by trochoids at constant engagement."""

from evenload import compiled
from evenload.operations import base
from evenload.settings.properties import GROUP, RESULTS, RESULT_SETTINGS, SETTINGS, Setting

NAME = "EvenLoad Trochoid"


class Trochoid(base.Operation):
    """Proxy of the trochoid operation. Documents refer to this class by its module and name: both
    stay.
    """

    name = NAME
    settings = (
        *SETTINGS,
        Setting(
            "Pattern",
            "App::PropertyEnumeration",
            ["Constant engagement", "Circular", "Cycloid"],
            "The trochoid's shape; the circular and the cycloid one reach the engagement angle "
            "only for a moment of each turn",
            GROUP,
        ),
        Setting(
            "SlotWidth",
            "App::PropertyLength",
            0.0,
            "Width of the slot round a sketch or edges, which are its centreline once this is set; "
            "faces have their own",
            GROUP,
        ),
    )
    results = (
        *RESULT_SETTINGS,
        Setting(
            "TrochoidalStep",
            "App::PropertyLength",
            0.0,
            "How far the trochoid advances in each turn, along the longest slot; 0: no trochoid "
            "was repeated, see Report",
            RESULTS,
        ),
        Setting(
            "Iterations",
            "App::PropertyInteger",
            0,
            "Passes that were steered to find the shape of that trochoid; 0 for circles and "
            "cycloids, and where none was repeated",
            RESULTS,
        ),
        Setting(
            "RemovalRate",
            "App::PropertyFloat",
            0.0,
            "Volume over time along the longest slot at its first depth, links and the passes "
            "along both walls included, entry and ends not, in mm3/min",
            RESULTS,
        ),
    )

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

    def generate(self, obj, core, regions, parameters):
        toolpath, figures = core.clear_slot(regions, pattern=obj.Pattern.lower(), **parameters)
        return toolpath, {
            "TrochoidalStep": figures.step,
            "Iterations": figures.iterations,
            "RemovalRate": figures.removal_rate,
        }


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new trochoid operation, as a document object; see base.create for the arguments."""
    return base.create(Trochoid, name, obj, parentJob, toolController)


base.register(Trochoid, Create)
