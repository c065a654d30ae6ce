"""The map of a surface, of what was read; any thread may compute it."""

import math

import numpy

from evenload import waiting
from evenload.surface_simulation import reading
from evenload.surface_simulation.mapping import mapped
from evenload.surface_simulation.result import SurfaceSimulation

MOST = 4e6  # cells: some seconds of two cores, and 320 MB
USUAL = 1e6  # cells where the stepover is not known
PER_STEP = 3.5  # cells that a stepover takes: of three at least every pass has one
LEAST_PER_STEP = 2.5
FINEST = 1e-3  # mm between cells


def simulate(operation, resolution=None, progress=None, **asked):
    """The SurfaceSimulation of a Path operation; see reading.read for the other arguments.

    resolution: mm between cells, None: a 3.5th of the least stepover, coarser where these were too
    many; progress: callable(share) -> whether to go on, waiting.Stopped is raised where not; None:
    waiting.go_on's is asked. Raises ValueError with a sentence.
    """
    with waiting.asking(progress or waiting.asked()):
        return simulated(reading.read(operation, **asked), resolution)


def simulated(question, resolution=None):
    """The same of a Question."""
    low, high = bounds_of(question)
    notes = []
    spacing = _spacing(question, resolution, high - low, notes)
    # Faces narrower than that have one row in their middle.
    cells = numpy.maximum(1, numpy.floor((high - low) / spacing).astype(int))
    first = low + 0.5 * ((high - low) - (cells - 1) * spacing)
    found = mapped(question, first, spacing, cells)
    return SurfaceSimulation(question, first, spacing, found, notes)


def bounds_of(question):
    """(low, high) in plan of what is mapped, each of two numbers."""
    triangles = question.triangles
    corners = triangles.points[triangles.numbers[triangles.picked].ravel(), :2]
    if not len(corners):
        raise ValueError("The models have no surface that looks up: nothing can be simulated.")
    low, high = corners.min(axis=0), corners.max(axis=0)
    if not question.is_whole:
        ways = numpy.array([move[1:3] for move in question.moves if move[0] != 0], float)
        if not len(ways):
            raise ValueError("'%s' cuts nothing: there is nothing to simulate." % question.label)
        radius = question.tool.diameter / 2
        low = numpy.maximum(low, ways.min(axis=0) - radius)
        high = numpy.minimum(high, ways.max(axis=0) + radius)
    if not (high > low).all():
        raise ValueError("The path of '%s' lies beside the models." % question.label)
    return low, high


def _spacing(question, resolution, extent, notes):
    """mm between cells; a sentence goes into `notes` where cusps may be missed."""
    area = float(extent[0] * extent[1])
    if resolution is not None:
        if not resolution >= FINEST:
            raise ValueError(
                "The resolution is %g mm: it must be at least %g mm." % (resolution, FINEST)
            )
        if area > MOST * resolution**2:
            least = math.ceil(1e3 * math.sqrt(area / MOST)) / 1e3
            raise ValueError(
                "The resolution of %g mm makes too many cells: choose at least %g mm."
                % (resolution, least)
            )
        spacing = resolution
    elif question.stepover > 0:
        spacing = max(FINEST, question.stepover / PER_STEP, math.sqrt(area / MOST))
    else:
        spacing = max(FINEST, math.sqrt(area / USUAL))
    if question.stepover > 0 and spacing * LEAST_PER_STEP > question.stepover:
        notes.append(
            "Cells of %.3f mm are coarse beside a stepover of %.3f mm: cusps may be missed."
            % (spacing, question.stepover)
        )
    return float(spacing)
