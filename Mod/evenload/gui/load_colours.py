"""What the load view colours a path by, and the colours: numpy only.

Values are coloured by lightness that rises evenly, so that they can be told apart in greyscale; so
are the kinds of moves.
"""

from dataclasses import dataclass

import numpy

from evenload import units
from evenload.planar import CUT, ENTRY, LINK, RAPID
from evenload.simulation.means import means
from evenload.simulation.walls import along_walls

WALL = CUT + 1  # a cut along a wall, which the simulator counts among the cuts

# By their names, from the least value to the largest: red, green, blue of 0 to 1, ever lighter.
# None holds a red like BEYOND, nor greys, which are a kind of moves.
SCALES = {
    "Violet to yellow": (
        (0.19, 0.07, 0.37),
        (0.23, 0.32, 0.66),
        (0.10, 0.57, 0.60),
        (0.40, 0.77, 0.35),
        (0.98, 0.91, 0.30),
    ),
    "Blue to white": (
        (0.03, 0.12, 0.38),
        (0.08, 0.33, 0.67),
        (0.25, 0.57, 0.85),
        (0.58, 0.80, 0.95),
        (0.93, 0.98, 1.00),
    ),
}
BEYOND = (0.90, 0.10, 0.10)  # of what is above the limit
KINDS = {  # their lightness, 0 to 100, is 17 apart and more
    RAPID: (0.97, 0.80, 0.80),
    LINK: (0.62, 0.62, 0.62),
    ENTRY: (0.80, 0.10, 0.55),
    WALL: (0.00, 0.31, 0.22),
    CUT: (0.03, 0.06, 0.40),
}


@dataclass(frozen=True)
class Measure:
    """One thing that a path can be coloured by."""

    key: str  # the Simulation's attribute
    title: str
    quantity: units.Quantity
    kinds: tuple = (CUT, ENTRY)  # the moves that are on its scale; others have their kind's colour
    loaded: tuple = ()  # moves that are on its scale where they meet material


KIND = Measure("kind", "Kind of move", units.same("", 0), ())
MEASURES = (
    # Entries meet all of it.
    Measure("engagement_deg", "Engagement angle", units.ANGLE, (CUT,), loaded=(LINK,)),
    Measure("removal_rate", "Removal rate", units.RATE),
    Measure("feed", "Feed", units.FEED, (CUT, ENTRY, LINK)),
    Measure("h_max", "Chip thickness", units.CHIP),
    Measure("force_peak", "Force", units.FORCE),
    KIND,
)


def values_of(measure, simulation):
    """The values of a Simulation's samples, None where it has none: without a material there is no
    force, without a spindle speed no chip thickness.
    """
    values = getattr(simulation, measure.key)
    if values is None or not numpy.isfinite(values).any():
        return None
    return numpy.asarray(values, float)


def kinds_of(simulation):
    """The kinds of moves of a Simulation's samples, among them WALL."""
    return numpy.where(along_walls(simulation), WALL, simulation.kind)


def has_it(measure, simulation):
    """For each sample whether it is on the measure's scale."""
    is_loaded = numpy.isin(simulation.kind, measure.loaded) & (values_of(measure, simulation) > 0)
    return numpy.isin(simulation.kind, measure.kinds) | is_loaded


def means_of(measure, simulation):
    """For each sample the mean of the values over a little of the path, as the worst values of a
    Simulation are; None where there are no values.
    """
    values = values_of(measure, simulation)
    return None if values is None else means(simulation, values)


def range_of(measure, simulation):
    """(least, largest) of the scale: up to the worst mean of cuts; (0, 1) where there are none."""
    number = worst_of(measure, simulation)
    largest = float(means_of(measure, simulation)[number]) if number is not None else 0.0
    return 0.0, largest if largest > 0 else 1.0


def worst_of(measure, simulation):
    """The number of the sample of a cut where the mean is the largest, None without any cut."""
    means, cuts = means_of(measure, simulation), simulation.kind == CUT
    if means is None or measure is KIND or not cuts.any():
        return None
    return int(numpy.argmax(numpy.where(cuts, means, -numpy.inf)))


def names():
    """The names of the scales; the first is the one that is shown where nobody prefers another."""
    return list(SCALES)


def on_scale(share, scale=None):
    """Colours, n x 3 of 0 to 1, for shares of a scale, each 0 to 1. scale: one of names(), None for
    the first.
    """
    colours = numpy.array(SCALES[scale or names()[0]])
    at = numpy.linspace(0, 1, len(colours))
    share = numpy.clip(numpy.nan_to_num(numpy.asarray(share, float)), 0, 1)
    return numpy.stack([numpy.interp(share, at, colours[:, k]) for k in range(3)], axis=-1)


def colours_of(measure, simulation, least, largest, limit=None, scale=None):
    """The colours of all samples, n x 3 of 0 to 1. limit: cuts whose mean is above it stand out;
    None for no limit. scale: as for on_scale.
    """
    kinds = kinds_of(simulation) if measure is KIND else simulation.kind
    colours = numpy.empty((len(simulation.x), 3))
    for kind, colour in KINDS.items():
        colours[kinds == kind] = colour
    values = values_of(measure, simulation)
    if measure is KIND or values is None:
        return colours
    counted = has_it(measure, simulation)
    colours[counted] = on_scale((values[counted] - least) / (largest - least), scale)
    if limit is not None:
        means = means_of(measure, simulation)
        colours[(simulation.kind == CUT) & (means > limit)] = BEYOND
    return colours
