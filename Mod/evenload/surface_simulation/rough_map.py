"""Roughness all over the faces: that of patches at places among the cells that were cut."""

from dataclasses import dataclass

import numpy

from evenload import waiting
from evenload.surface_simulation.nearest import on_cells
from evenload.surface_simulation.rough import CUT_OFF, cut_cells

PLACES = 100  # at the most; a patch takes some hundredths of a second, more along long paths
COARSER = 1.1  # by which blocks of cells grow until they are no more than that


@dataclass(frozen=True)
class RoughnessMap:
    """At n places, n x 2 in mm: rz_along, rz_across, mm: R_z of the patch there, as wide as the
    cut-off, along the feed and across it. notes: what patches tell, each sentence once.
    """

    places: numpy.ndarray
    rz_along: numpy.ndarray
    rz_across: numpy.ndarray
    notes: tuple

    def on(self, simulation, values):
        """For each cell that was cut the value at the nearest place, not a number elsewhere."""
        return on_cells(simulation, self.places, values)


def all_over(simulation):
    """The RoughnessMap of a SurfaceSimulation. Places whose patch no profile crosses, beside the
    border of faces narrower than it, are left out. Raises ValueError with a sentence.
    """
    places, patches = _places(simulation), []
    for number, place in enumerate(places):
        share = number / len(places)
        waiting.go_on(share)
        with waiting.asking(_of_all(share)):
            patches.append(simulation.roughness(place))
    figures = numpy.array([(each.rz_along, each.rz_across) for each in patches]).reshape(-1, 2)
    is_known = numpy.isfinite(figures).all(axis=1)
    if not is_known.any():
        raise ValueError(
            "What '%s' cuts is narrower than a patch of %g mm, whose roughness is told: pick wider "
            "faces." % (simulation.label, CUT_OFF)
        )
    notes = tuple(dict.fromkeys(note for each in patches for note in each.notes))
    return RoughnessMap(places[is_known], *figures[is_known].T, notes)


def _of_all(share):
    """Who is asked now, told what is done of all, not of one patch."""
    asked = waiting.asked()
    return asked and (lambda own: asked(share))


def _places(simulation):
    """n x 2, mm: of each block of cells the cut one that is nearest to the middle of those cut."""
    rows, columns = cut_cells(simulation)
    side = max(1.0, numpy.sqrt(len(rows) / PLACES))
    while True:
        blocks = numpy.stack([rows // side, columns // side], axis=1)
        kinds, block = numpy.unique(blocks, axis=0, return_inverse=True)
        if len(kinds) <= PLACES:
            break
        side *= COARSER
    cells = numpy.column_stack([simulation.x[columns], simulation.y[rows]])
    block = block.ravel()
    counts = numpy.bincount(block)
    middles = [numpy.bincount(block, cells[:, k]) / counts for k in (0, 1)]
    apart = numpy.hypot(*(cells[:, k] - middles[k][block] for k in (0, 1)))
    order = numpy.lexsort((apart, block))
    return cells[order[numpy.searchsorted(block[order], numpy.arange(len(kinds)))]]
