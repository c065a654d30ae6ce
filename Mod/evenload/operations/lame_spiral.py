"""Lamé spiral: clears round, square and many-sided pockets, and round islands, by spirals."""

from evenload.operations import base, registry
from evenload.settings import parameters as words
from evenload.settings.results import RESULTS_OF_LAME_SPIRAL, RESULT_SETTINGS
from evenload.settings.table import OF_LAME_SPIRAL, SETTINGS, without_open_sides

NAME = "EvenLoad Lame Spiral"  # FreeCAD makes names of properties from it


class LameSpiral(base.Operation):
    """Proxy of the Lamé spiral operation. Documents refer to this class by its module and name:
    both stay.
    """

    name = NAME
    partly_open = False
    settings = (*without_open_sides(SETTINGS), *OF_LAME_SPIRAL)
    results = (*RESULT_SETTINGS, *RESULTS_OF_LAME_SPIRAL)

    def generate(self, settings, core, regions, parameters):
        toolpath = core.clear_with_lame_spiral(regions, **parameters)
        if toolpath.figures is None:  # Report tells why; what was fitted before stays
            return toolpath, {"ClearedShare": 0.0}
        fitted = words.fitted(settings, self.settings, toolpath.figures)
        return toolpath, {**fitted, "ClearedShare": toolpath.cleared_share}

    def results_of(self, cuts):
        most = max(cuts, key=lambda cut: cut.own["ClearedShare"] * cut.area)
        cleared = sum(cut.own["ClearedShare"] * cut.area for cut in cuts)
        return {**most.own, "ClearedShare": cleared / sum(cut.area for cut in cuts)}


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new Lamé spiral operation, as a document object; see registry.create for the arguments."""
    return registry.create(LameSpiral, name, obj, parentJob, toolController)


registry.register(LameSpiral, Create)
