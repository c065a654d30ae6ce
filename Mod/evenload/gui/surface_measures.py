"""What the faces are coloured by, and the colours of cells that are not on the scale."""

from dataclasses import dataclass

import numpy

from evenload import units
from evenload.gui import load_colours
from evenload.gui.load_legend import NAMES

BARE = (0.95, 0.79, 0.63)  # of what no pass has cut
SHOWN_SHARE = 99.5  # % of the cells whose values the scale reaches
LEAST_SCALE = 1e-5  # mm, or as a share: of a scale's largest value
LEAST_GOUGE = 1e-3  # mm: less is rounding
MAP, CHIPS, ROUGHNESS = STEPS = "map", "chips", "roughness"  # one is computed after the other
PER_CENT = units.same("%", 0, 0.01)


@dataclass(frozen=True)
class SurfaceMeasure:
    """One thing that faces can be coloured by. of: gives the cells' values of a SurfaceSimulation
    in mm or as shares, not a number where there is none; step: what is computed before these are
    known, one of STEPS.
    """

    key: str
    title: str
    of: object
    step: str = MAP
    is_share: bool = False

    @property
    def quantity(self):
        """The Quantity that its values are."""
        return PER_CENT if self.is_share else units.ROUGHNESS

    @property
    def on_legend(self):
        """The same as a legend has it; no kind of moves is beside its scale."""
        return load_colours.Measure(self.key, self.title, self.quantity, tuple(NAMES))


def _gouge(found):
    return numpy.where(found.gouge_anywhere > LEAST_GOUGE, found.gouge_anywhere, 0.0)


def _rest(found):
    return numpy.where(found.is_covered, found.rest, numpy.nan)


MEASURES = (
    SurfaceMeasure("cusp", "Cusp height", lambda found: found.cusp),
    SurfaceMeasure("rest", "Height over the part", _rest),
    SurfaceMeasure("gouge", "Gouge", _gouge),
    SurfaceMeasure(
        "h_m",
        "Mean chip thickness h_m",
        lambda found: found.chips.on(found, found.chips.mean_thickness),
        step=CHIPS,
    ),
    SurfaceMeasure(
        "tip_share",
        "Share of the tip",
        lambda found: found.chips.on(found, found.chips.tip_share),
        step=CHIPS,
        is_share=True,
    ),
    SurfaceMeasure(
        "rz_along",
        "R_z along the feed",
        lambda found: found.roughness_map.on(found, found.roughness_map.rz_along),
        step=ROUGHNESS,
    ),
    SurfaceMeasure(
        "rz_across",
        "R_z across the feed",
        lambda found: found.roughness_map.on(found, found.roughness_map.rz_across),
        step=ROUGHNESS,
    ),
)


def largest_of(values):
    """The scale's end: single corners may stand higher."""
    known = values[numpy.isfinite(values)]
    largest = float(numpy.percentile(known, SHOWN_SHARE)) if len(known) else 0.0
    if largest <= LEAST_SCALE and len(known):
        largest = float(known.max())  # as of a gouge at few places
    return max(largest, LEAST_SCALE)


def colours_of(values, is_bare, largest, scale):
    """n x 3 of 0 to 1 for n values; is_bare: for each whether no pass has cut there."""
    colours = load_colours.on_scale(values / largest, scale)
    colours[numpy.isnan(values)] = load_colours.KINDS[1]
    colours[is_bare] = BARE
    return colours
