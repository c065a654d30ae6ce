"""A patch of the surface so fine that single teeth leave their marks, and its roughness.

R_z as the source has it: the mean of the five highest less that of the five deepest places of a
profile in a sampling length, which is the cut-off of 0.8 mm [Varga 2023, pp. 31-33, 45]; R_t: the
highest less the deepest. Both are means over all profiles of the patch that run one way. The source
gives no formula of what teeth and passes leave; here it is what the ball has not swept.
"""

import math
from dataclasses import dataclass

import numpy

from evenload import tool as tools
from evenload.surface_simulation.mapping import mapped

CUT_OFF = 0.8  # mm [Varga 2023, p. 45]
PER_MARK = 16  # cells that the finer of feed per tooth and stepover takes
LEAST_PER_MARK = 4  # of which marks are not lost
MOST = 250_000  # cells
EXTREMES = 5
COARSEST = 1 / 40  # of the patch's sides: its cells where neither is known


@dataclass(frozen=True)
class Patch:
    """Heights over the part, mm, on rows along the feed, each further to its left; across the
    surface, not a number beside the part and where no pass has cut. at: (x, y) of its middle; way:
    the feed's direction there in plan, of length 1; resolution: mm between places; feed_per_tooth:
    mm, None where the spindle speed is not known and nothing marks the surface along the feed.
    rt_along, rz_along, rt_across, rz_across: mm. notes: sentences where marks are lost between
    places, and on what is assumed.
    """

    at: tuple
    way: tuple
    resolution: float
    heights: numpy.ndarray
    feed_per_tooth: float
    rt_along: float
    rz_along: float
    rt_across: float
    rz_across: float
    notes: tuple = ()


def patch(simulation, at, size):
    """The Patch of a SurfaceSimulation around (x, y)."""
    if not (math.isfinite(size) and size > 0):
        raise ValueError("The patch is %g mm wide: it must be more than 0." % size)
    question = simulation.question
    row, column = _cell(simulation, at)
    middle = numpy.array([simulation.x[column], simulation.y[row]] if at is None else at, float)
    move = int(simulation._found["move"][row, column])
    way, feed = _way_and_feed(question.moves, move, middle)
    per_minute = question.spindle_speed * question.tool.teeth
    feed_per_tooth = feed / per_minute if per_minute > 0 and feed > 0 else None
    marks = [each for each in (feed_per_tooth, question.stepover) if each]
    spacing = min(marks) / PER_MARK if marks else size * COARSEST
    half = size / 2 * math.sqrt(2) + spacing  # its corners, whichever way it is turned
    spacing = max(spacing, 2 * half / math.sqrt(MOST))
    count = 2 * math.ceil(half / spacing) + 1
    first = middle - spacing * (count - 1) / 2
    found = mapped(question, first, spacing, (count, count), per_minute if feed_per_tooth else 0.0)
    is_cut = numpy.isfinite(found["part"]) & (found["move"] >= 0)
    fine = numpy.where(is_cut, found["above"], numpy.nan)
    heights = _turned(fine, way, size, spacing)
    along, across = _figures(heights), _figures(heights.T)
    notes = _notes(spacing, marks)
    if feed_per_tooth:
        notes += tuple(tools.on_teeth(question.tool))
    return Patch(tuple(middle), way, spacing, heights, feed_per_tooth, *along, *across, notes)


def _notes(spacing, marks):
    if not marks or spacing <= min(marks) / LEAST_PER_MARK:
        return ()
    return (
        "Places of the patch are %.3f mm apart, coarse beside marks of %.3f mm, which may be lost: "
        "a smaller patch would tell them." % (spacing, min(marks)),
    )


def ten_points(profile):
    """R_z in the source's sense of heights along a line: of as many extremes as there are, where
    these are less than ten.
    """
    inner = profile[1:-1]
    peaks = inner[(inner >= profile[:-2]) & (inner > profile[2:])]
    valleys = inner[(inner <= profile[:-2]) & (inner < profile[2:])]
    if not (len(peaks) and len(valleys)):
        return float(numpy.ptp(profile))
    highest, deepest = numpy.sort(peaks)[-EXTREMES:], numpy.sort(valleys)[:EXTREMES]
    return float(highest.mean() - deepest.mean())


def cut_cells(simulation):
    """(rows, columns) of the cells that were cut. Raises ValueError with a sentence without any."""
    rows, columns = numpy.nonzero(simulation.is_covered)
    if not len(rows):
        raise ValueError("'%s' cuts the faces nowhere." % simulation.label)
    return rows, columns


def _cell(simulation, at):
    """(row, column) of the cut cell nearest to a place, or to the middle of all of them."""
    if at is not None:
        under = _under(simulation, at)
        if under is not None and simulation.is_covered[under]:
            return under
    rows, columns = cut_cells(simulation)
    x, y = simulation.x[columns], simulation.y[rows]
    wanted = (x.mean(), y.mean()) if at is None else at
    apart = numpy.hypot(x - wanted[0], y - wanted[1])
    nearest = int(apart.argmin())
    if at is not None and apart[nearest] > 2 * simulation.resolution:
        raise ValueError("No pass cuts the faces at x = %g, y = %g." % tuple(wanted))
    return rows[nearest], columns[nearest]


def _under(simulation, at):
    """(row, column) of the cell at a place, None beside all of them."""
    x, y = simulation.x, simulation.y
    steps = [(place - along[0]) / simulation.resolution for place, along in zip(at, (x, y))]
    if not all(-0.5 <= step < len(along) - 0.5 for step, along in zip(steps, (x, y))):
        return None
    column, row = map(round, steps)
    return row, column


def _way_and_feed(moves, number, at):
    """((x, y) of length 1, mm/min) of a move at a place; along x where it stands upright."""
    before, move = moves[number - 1], moves[number]
    x, y, sweep = move[1] - before[1], move[2] - before[2], move[4]
    if sweep:  # across the radius
        x, y = math.copysign(1, sweep) * (move[6] - at[1]), math.copysign(1, sweep) * (
            at[0] - move[5]
        )
    length = math.hypot(x, y)
    return ((x / length, y / length) if length > 0 else (1.0, 0.0)), move[7]


def _turned(fine, way, size, spacing):
    """Values of a square, between its cells, on rows along `way` within `size`."""
    count = max(2, int(size / spacing))
    steps = (numpy.arange(count) - (count - 1) / 2) * spacing
    along, left = numpy.meshgrid(steps, steps)
    middle = (len(fine) - 1) / 2
    column = (along * way[0] - left * way[1]) / spacing + middle
    row = (along * way[1] + left * way[0]) / spacing + middle
    i, j = numpy.floor(row).astype(int), numpy.floor(column).astype(int)
    s, t = row - i, column - j
    low = (1 - t) * fine[i, j] + t * fine[i, j + 1]
    high = (1 - t) * fine[i + 1, j] + t * fine[i + 1, j + 1]
    return (1 - s) * low + s * high


def _figures(rows):
    """(R_t, R_z), means over the rows that are cut all along."""
    whole = rows[numpy.isfinite(rows).all(axis=1)]
    if not len(whole):
        return math.nan, math.nan
    return float(numpy.ptp(whole, axis=1).mean()), float(numpy.mean([ten_points(r) for r in whole]))
