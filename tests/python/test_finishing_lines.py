"""Finishing paths have hardly more moves than their tolerance demands, counted right."""

import math

import finishing_cases as cases
import lines_demanded
import numpy
import pytest
from evenload import compiled
from evenload.planar import CUT, LINK, RAPID

pytestmark = pytest.mark.core

TOLERANCE, DEFLECTION = 0.0045, 0.0005
MOST = 1.2  # posted moves for each that is demanded
# How many pieces are counted: of passes over the whole part few.
WAYS = {
    "zig-zag at 90 degrees": (3, dict(angle=math.pi / 2)),
    "zig-zag at 45 degrees": (3, dict(angle=math.pi / 4)),
    "contours inwards": (24, dict(pattern="contours inwards")),
    "spiral outwards": (24, dict(pattern="spiral outwards")),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("is_convex", [True, False], ids=["CX", "CV"])
def test_a_path_has_hardly_more_moves_than_its_tolerance_demands(is_convex, way):
    count, options = WAYS[way]
    core = compiled.core()
    mesh = core.surface.FacetMesh(*cases.triangles(is_convex, DEFLECTION))
    arguments = cases.options(tolerance=TOLERANCE, deflection=DEFLECTION, **options)
    path = core.surface.finish(mesh, **arguments).toolpath
    posted, demanded = lines_demanded.counted(
        mesh, path.moves, TOLERANCE, arguments["floor"], count
    )
    assert demanded > 100
    assert demanded <= posted <= MOST * demanded


def test_an_arc_takes_as_many_lines_as_its_closed_form():
    # A line in a band of a width w reaches as far as 2 sqrt(2 w r) along an arc of r.
    radius, width, length = 50.0, 0.011, 30.0
    run = numpy.linspace(-length / 2, length / 2, 1501)
    curve = numpy.sqrt(radius**2 - run**2)
    stretch = numpy.sqrt(1 + (run / curve) ** 2)
    levels = curve[:, None] + width * stretch[:, None] * numpy.linspace(0, 1, 13)
    exact = 2 * radius * math.asin(length / 2 / radius) / (2 * math.sqrt(2 * width * radius))
    assert lines_demanded._fewest(run, levels) in (math.ceil(exact), math.ceil(exact) + 1)
    assert lines_demanded._fewest(run, levels - curve[:, None] + 0.3 * run[:, None]) == 1


def test_cuts_along_one_line_or_circle_are_one_piece():
    turn = math.pi / 4
    moves = [
        (RAPID, 0, 0, 9, 0, 0, 0, 0),
        (LINK, 0, 0, 1, 0, 0, 0, 100),
        *((CUT, x, 0, z, 0, 0, 0, 100) for x, z in ((2, 1), (5, 2), (9, 1))),
        (CUT, 9, 4, 1, 0, 0, 0, 100),
        *((CUT, 9, 4, 1 + k, turn, 7, 4, 100) for k in (1, 2)),
        (LINK, 9, 5, 1, 0, 0, 0, 100),
        (CUT, 9, 8, 1, 0, 0, 0, 100),
    ]
    found = lines_demanded.pieces_of(moves)
    assert [len(rows) for rows, _ in found] == [3, 1, 2, 1]
    assert [tuple(start) for _, start in found] == [(0, 0, 1), (9, 0, 1), (9, 4, 1), (9, 5, 1)]


def test_samples_lie_where_the_tool_touches_and_bumps_between_them_are_low():
    core = compiled.core()
    mesh = core.surface.FacetMesh(*cases.triangles(True, DEFLECTION))
    found = core.surface.samples(mesh, 10, 5, (3, -45), (3, 45), -100.0, TOLERANCE)
    run, heights = found.T
    assert run[0] == 0 and run[-1] == 90 and (numpy.diff(run) > 0).all()

    def dropped(run):
        places = numpy.column_stack([numpy.full(len(run), 3.0), run - 45])
        return core.surface.contacts(mesh, 10, 5, places, -100.0)[:, 0]

    assert numpy.abs(dropped(run) - heights).max() < 1e-12
    # Where the tool is at work chords leave the heights by less than the lines upon them may.
    within = run[(run > 6) & (run < 84)]
    between = (within[1:] + within[:-1]) / 2
    off = dropped(between) - numpy.interp(between, run, heights)
    assert numpy.abs(off).max() < 0.05 * TOLERANCE / math.cos(cases.LEAN)  # upright
    with pytest.raises(ValueError, match="has a length"):
        core.surface.samples(mesh, 10, 5, (3, 0), (3, 0), -100.0, TOLERANCE)
