"""The chips of a finishing path, at places along it, on the map of its surface."""

from dataclasses import dataclass

import numpy

from evenload import tool as tools
from evenload.advisor import loads_along
from evenload.geometry import facets
from evenload.operations import finishing
from evenload.surface_simulation.nearest import on_cells

PLACES = 1000  # along the path


@dataclass(frozen=True)
class Chips:
    """At n places: tips, n x 3, of the tool's tip; mean_thickness, the source's h_m, mm [Varga
    2023, 4.1]; tip_share: the share of the chip that the tip cuts, 0 to 1. notes: sentences on
    places that have no chip, and on what is assumed.
    """

    tips: numpy.ndarray
    mean_thickness: numpy.ndarray
    tip_share: numpy.ndarray
    notes: tuple

    def on(self, simulation, values):
        """For each cell that was cut the value at the nearest place, not a number elsewhere."""
        return on_cells(simulation, self.tips[:, :2], values)


def along(question):
    """The Chips of a reading.Question. Raises ValueError with a sentence where there are none."""
    asked = question.loads
    if isinstance(asked, str):
        raise ValueError(asked)
    faces = facets.of_triangles(question.triangles)  # the advisor's own would take as long again
    arguments = finishing.arguments_of(asked.settings, asked.tool, asked.data, faces)
    stepover = max(question.largest_stepover, arguments["stepover"])
    found, felt = loads_along(asked, faces.mesh, arguments, question.moves, stepover, PLACES)
    notes = [*felt.refusals, *tools.on_teeth(asked.tool)]
    return Chips(found.tips, felt.mean_thickness, felt.tip_share, tuple(notes))
