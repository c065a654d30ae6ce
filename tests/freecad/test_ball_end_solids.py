"""Chips of ball-end tools as solids of OpenCASCADE's: the chip model judged by them, and how they
are made in several processes.
"""

import math
import os
import threading

import numpy
import Part
import pytest
from evenload import ball_end, waiting
from evenload.ball_end import solid_models, solid_processes, solid_surfaces, solids
from FreeCAD import Vector

pytestmark = pytest.mark.between

WITHIN = {
    "volume": 3e-3,
    "tool_face": 5e-3,
    "previous_face": 5e-3,
    "mean_thickness": 5e-3,
    "max_thickness": 5e-3,
}
WORDS = "surface tool_diameter feed_per_tooth stepover axial_depth feed_direction position uncut"
CX, CV = ("test part", "CX"), ("test part", "CV")
# Each kind of surface, of pass (line, circle, ellipse, over a joint of two arcs) and of side.
CASES = [
    dict(zip(WORDS.split(), row))
    for row in [
        (("plane",), 10, 0.12, 0.15, 0.3, 30, 0, "right"),
        (("plane",), 6, 0.05, 0.3, 0.2, 0, 0, "strip"),
        (("plane",), 10, 0.08, 1, 0.3, 45, 0, "slot"),
        (("cylinder", 45), 10, 0.12, 0.15, 0.3, 0, 21, "left"),
        (("cylinder", -45), 10, 0.16, 0.35, 0.3, 90, 21, "right"),
        (("cylinder", -10), 10, 0.12, 0.15, 0.3, 45, 1.5, "right"),
        (CX, 10, 0.16, 0.15, 0.3, 0, 10.5, "left"),
        (CX, 10, 0.08, 0.25, 0.3, 67.5, -14, "right"),
        (CX, 10, 0.12, 0.15, 0.3, 22.5, 31.5, "left"),
        (CV, 10, 0.12, 0.15, 0.3, 90, 0, "left"),
        (CV, 10, 0.16, 0.35, 0.3, 45, -24.5, "right"),
        (CV, 10, 0.08, 0.35, 0.3, 22.5, 17.5, "strip"),
    ]
]


@pytest.fixture(scope="module")
def found():
    """SolidChips of CASES, made in two processes."""
    return solids.chips(CASES, processes=2)


@pytest.mark.parametrize("number", range(len(CASES)))
def test_the_chip_model_is_as_the_solids(found, number):
    solid, chip = found[number], ball_end.chip(**CASES[number])
    assert not solid.flagged
    for name, within in WITHIN.items():
        assert getattr(solid, name) == pytest.approx(getattr(chip, name), rel=within), name
    assert solid.mean_thickness_tool == pytest.approx(chip.mean_thickness_tool, rel=8e-3)


def test_processes_make_what_is_made_here(found):
    assert solids.chip(**CASES[3]) == found[3]


def made(surface=CX, position=7.0, feed=0.1, direction=0.0):
    """(Place, the centre of the tooth before, what leaves the faces) of a chip."""
    place = solid_models.Place(surface, 5, 0.3, direction, position)
    before = place.centre(-1000 * feed, 0)
    return place, before, place.surfaces(before, [150])


def test_what_is_no_chip_is_flagged_with_the_reason():
    place, before, surfaces = made()
    ball, tooth = (place.ball(centre, Vector(1, 0, 0), True) for centre in (Vector(), before))
    uncut = ball.common(place.stock(is_spline=True)).cut(tooth)
    for solid, sentence in (
        (Part.Compound([]), "makes 0 solids"),
        (uncut, "no face of the pass"),
        (ball, "no face of the previous"),
        (tooth.translated(Vector(7, 0, 0)), "neither tooth's"),
        (Part.makeBox(9, 9, 9), "neither of the stock nor of a pass"),
    ):
        with pytest.raises(solids.Flagged, match=sentence):
            solids._measured(solid, surfaces)


def test_an_open_shell_is_flagged():
    surfaces = made()[2]
    shell = Part.Shell(Part.makeSphere(5000).common(Part.makeBox(9e3, 9e3, 9e3)).Faces[1:])
    with pytest.raises(solids.Flagged, match="calls the solid invalid"):
        solids._measured(Part.Solid(shell), surfaces)


def test_a_mesh_has_the_volume_of_its_solid():
    ball = solid_surfaces.Ball("tool", (30.0, -20.0, 11.0), 7.0)
    solid = Part.makeSphere(7, Vector(*ball.centre))
    points, triangles = solid.tessellate(0.05)
    corners = numpy.array(points)[numpy.array(triangles)]
    alone = numpy.linalg.det(corners - corners[0, 0]).sum() / 6
    assert solids._mesh_volume(solid, [ball], 0.05) == pytest.approx(solid.Volume, rel=2e-4)
    assert alone == pytest.approx(solid.Volume, rel=2e-2)
    assert alone != pytest.approx(solid.Volume, rel=1e-3)  # what lies over triangles counts


@pytest.mark.parametrize("deflection", [1.0, 0.25])  # of a mean thickness of 5.7
def test_the_volume_by_a_mesh_hardly_depends_on_how_fine_it_is(deflection):
    place, before, surfaces = made(direction=30.0)
    make = solids._recipes(place, before, [place.way(150)])[0]
    solid = make()
    lefts = [solids._left_by(face, surfaces) for face in solid.Faces]
    found = solids._mesh_volume(solid, lefts, deflection)
    chip = ball_end.chip(CX, 10, 0.1, 0.15, 0.3, 30, position=7.0, uncut="right")
    assert found / 1e9 == pytest.approx(chip.volume, rel=2e-6)


@pytest.mark.parametrize("surface, position", [(CX, 27.0), (CV, 20.0), (CV, -31.0)])
@pytest.mark.parametrize("direction", [0.0, 22.5, 67.5, 90.0])
def test_distances_from_a_pass_are_opencascades(surface, position, direction):
    place, _, surfaces = made(surface, position, direction=direction)
    way, swept = place.way(150), surfaces[2]
    middle = place.centre(0, 150) - 5000 * place.normal
    points = [
        middle + Vector(*each) for each in numpy.random.default_rng(1).uniform(-300, 300, (20, 3))
    ]
    found = swept.above(numpy.array(points))
    for point, above in zip(points, found):
        away = way.distToShape(Part.Vertex(point))[0]
        assert 5000 - above == pytest.approx(away, abs=1e-5)


def test_when_no_way_makes_a_chip_it_is_flagged(monkeypatch):
    monkeypatch.setattr(solids, "VOLUMES", -1.0)
    flagged = solids.chip(**CASES[0])
    assert "Its mesh has" in flagged.flagged and math.isnan(flagged.mean_thickness)


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({"uncut": "behind"}, "uncut is right, left, strip or slot, not behind"),
        ({"axial_depth": 5}, "the depth below the ball's radius"),
        ({"feed_per_tooth": 0}, "are above 0"),
        ({"surface": ("patch", 0.1, 0.1)}, "bent two ways"),
        ({"surface": ("cylinder", -5)}, "does not fit"),
        ({"surface": ("cylinder", 45), "position": 60}, "beyond the surface's end"),
        ({"surface": ("cone", 45)}, "A surface is"),
    ],
)
def test_what_cannot_be_is_refused_here_and_in_processes(change, sentence):
    case = {**CASES[0], **change}
    with pytest.raises(ValueError, match=sentence):
        solids.chip(**case)
    with pytest.raises(ValueError, match=sentence):
        solids.chips([case])


def processes_of_ours():
    """Numbers of the processes that this one has started and that have not ended."""
    mine, found = str(os.getpid()), set()
    for number in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/stat" % number) as file:
                state, parent = file.read().rpartition(")")[2].split()[:2]
        except FileNotFoundError:
            continue
        if parent == mine and state != "Z":
            found.add(number)
    return found


def test_progress_is_told_and_stops_it_within_a_moment():
    before, threads, shares = processes_of_ours(), set(threading.enumerate()), []

    def progress(share):
        shares.append(share)
        return share < 2 / 12

    with pytest.raises(waiting.Stopped):
        solids.chips(CASES, progress, processes=2)
    assert shares == sorted(shares) and shares[0] == 0 and 2 / 12 <= shares[-1] < 0.5
    assert processes_of_ours() == before
    assert set(threading.enumerate()) <= threads


def test_whoever_waits_may_stop_it_too():
    with waiting.asking(lambda share: False), pytest.raises(waiting.Stopped):
        solids.chips(CASES[:2])


def test_a_process_that_ends_costs_its_chip_alone(monkeypatch):
    # It ends over the second line that it gets.
    calls = []
    original = solid_processes._Worker._line_after

    def faulty(worker, text):
        calls.append(text)
        if len(calls) == 2:
            worker._process.kill()
            worker._process.wait()  # so that nobody is there to take the line
        return original(worker, text)

    monkeypatch.setattr(solid_processes._Worker, "_line_after", faulty)
    found = solids.chips([CASES[0], CASES[3], CASES[0]], processes=1)
    assert [bool(each.flagged) for each in found] == [False, True, False]
    assert "FreeCAD ended over it" in found[1].flagged and found[0] == found[2]


def test_a_freecad_that_does_not_start_is_told(monkeypatch):
    monkeypatch.setattr(solid_processes.host, "without_window", lambda: "/bin/true")
    with pytest.raises(RuntimeError, match="/bin/true, does not start"):
        solids.chips(CASES[:3])


def test_no_chips_are_no_work():
    assert solids.chips([]) == []
