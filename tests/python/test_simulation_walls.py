"""Which samples of a simulation go along walls."""

import numpy
import pytest
from evenload.planar import CUT
from evenload.simulation.walls import along_walls
from simulated_paths import FEED, RADIUS, line_at, simulated

POCKET = 7.0  # mm: half a square of the tool's centre
CORNERS = [(-POCKET, -POCKET), (POCKET, -POCKET), (POCKET, POCKET), (-POCKET, POCKET)]


def pocket(levels):
    """Moves that clear a square to and fro, and then go round it, at each level."""
    moves = [(0, -POCKET, -POCKET, 5, 0, 0, 0, 0)]
    for z in levels:
        moves.append((2, -POCKET, -POCKET, z, 0, 0, 0, 100))
        for number, y in enumerate(numpy.linspace(-4.5, 4.5, 5)):
            there = 4.5 if number % 2 else -4.5
            moves += [(CUT, there, y, z, 0, 0, 0, FEED), (CUT, -there, y, z, 0, 0, 0, FEED)]
        moves += [(CUT, *CORNERS[k % 4], z, 0, 0, 0, FEED) for k in range(5)]
        moves.append((1, -POCKET, -POCKET, z + 0.5, 0, 0, 0, 600))
    return moves


@pytest.mark.parametrize("levels", [(-3.0,), (-1.5, -3.0)])
def test_the_way_round_a_pocket_is_along_its_walls_at_each_level(levels):
    run = simulated(pocket(levels))
    found = along_walls(run)
    length = run.length[found].sum()
    assert length == pytest.approx(len(levels) * 8 * POCKET, rel=0.03)
    assert (run.kind[found] == CUT).all()
    assert (abs(abs(numpy.stack([run.x, run.y]))[:, found].max(axis=0) - POCKET) < 0.01).all()


def test_the_sides_of_a_single_cut_are_walls():
    run = simulated(line_at(0))
    inside = (abs(run.x) < 30 - RADIUS) & (run.kind == CUT)
    assert along_walls(run)[inside].all()


def test_a_path_that_was_stopped_has_none_yet():
    run = simulated(pocket((-3.0,)))
    run.cancelled = True
    assert not along_walls(run).any()
