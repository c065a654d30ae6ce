"""Which cuts of a simulation go along walls: what is beside them stands in the end."""

import numpy

from evenload.planar import CUT


def along_walls(found):
    """For each sample of a Simulation whether it is of a cut along a wall: material stands beside
    the tool, within two spacings of the stock's dexels, when all of the path is done. A path that
    was stopped leaves no walls yet.
    """
    if found.walls is None:
        found.walls = _along_walls(found)
    return found.walls


def _along_walls(found):
    result = numpy.zeros(len(found.x), bool)
    if found.stock is None or found.cancelled:
        return result
    cuts = found.kind == CUT
    places = numpy.stack([found.x, found.y, found.z, _feed_angles(found)], axis=1)
    result[cuts] = found.stock.stands_beside(places[cuts], 0.5 * found.tool_diameter)
    return result


def _feed_angles(found):
    """rad: the direction from each sample's predecessor, or to the next one at a move's start."""
    size = len(found.x)
    if size < 2:
        return numpy.zeros(size)
    angles = numpy.arctan2(numpy.diff(found.y), numpy.diff(found.x))
    begins = numpy.append(numpy.diff(found.move) != 0, True)  # the next sample is another move's
    behind = numpy.append(angles[0], angles)
    ahead = numpy.append(angles, angles[-1])
    starts = numpy.append(True, begins[:-1])
    return numpy.where(starts & ~begins, ahead, behind)
