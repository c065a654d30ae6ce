"""Means of a Simulation's values over a little of its path: single places in corners may meet
anything. Needs no FreeCAD.
"""

import numpy

from evenload.planar import CUT

WINDOW = 0.1  # mm of path, as in src/simulate/load_record.h


def means(simulation, values):
    """For each sample the mean of the values over the last WINDOW of the path."""
    along = numpy.cumsum(simulation.length)
    area = numpy.cumsum(simulation.length * numpy.nan_to_num(values))
    return (area - numpy.interp(along - WINDOW, along, area, left=0.0)) / WINDOW


def worst_in_cuts(simulation, values):
    """The largest of these means in cuts, 0 without any. What comes before a cut, such as an entry
    that meets material all round, does not count, as in the worst values of a Simulation.
    """
    cuts = simulation.kind == CUT
    found = means(simulation, numpy.where(cuts, values, 0.0))[cuts]
    return float(found.max()) if len(found) else 0.0


def worst_force(simulation):
    """N: the largest of these means of the peak force in cuts; None without a material."""
    values = simulation.force_peak
    return None if values is None else worst_in_cuts(simulation, values)
