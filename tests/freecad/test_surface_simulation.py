"""What a Finishing operation leaves on its faces, on the source's test parts and simple bodies."""

import math
import re
import tracemalloc

import FreeCAD
import numpy
import Part
import Path
import pytest
from finishing_parts import DOME, part, upper

from evenload import ball_end, compiled, host, surface_simulation, units, waiting
from evenload.operations import finishing
from evenload.settings.table import EVEN_CUSPS
from evenload.surface_simulation import nearest, rough, rough_map

pytestmark = pytest.mark.core  # what is computed, behind docks that each FreeCAD is asked for

PICTURES = [
    "cusp",
    "gouge",
    "rest",
    "roughness",
    "h_m",
    "tip share",
    "rz_along",
    "rz_across",
]
BALL, FEED, SPEED, TEETH = 5.0, 1632.0, 5100.0, 4  # [Varga 2023, ch. 8]


def foreign(on, *texts, name):
    """An operation that is not ours, with a path of these commands."""
    op = on.doc.addObject("Path::FeaturePython", name)
    op.addProperty("App::PropertyLink", "ToolController")
    op.addProperty("App::PropertyBool", "Active")
    op.Active, op.ToolController = True, on.controller
    op.Path = Path.Path([Path.Command(text) for text in texts])
    on.job.Operations.Group = [*on.job.Operations.Group, op]
    return op


def cusp_of(stepover, radius=BALL):
    return radius - math.sqrt(radius**2 - stepover**2 / 4)


@pytest.fixture
def finished(bench):
    """Makes a Finishing operation on the upper side of a solid, with the source's tool."""

    def made(shape, tool="ballend", **properties):
        b = bench(shape, tool=2 * BALL, feed=FEED)
        b.controller.Tool = host.create_tool(tool, {"Diameter": 2 * BALL, "Flutes": TEETH})
        b.controller.SpindleSpeed = SPEED
        op = finishing.Create("Operation", parentJob=b.job, toolController=b.controller)
        op.Base = [(b.model, upper(b.model.Shape))]
        b.set(op, **properties)
        return b, b.done(op)

    return made


@pytest.fixture
def plane(finished):
    return finished(Part.makeBox(24, 16, 10), Stepover=0.5)


def test_on_a_plane_the_cusps_are_those_of_the_closed_form(plane):
    _, op = plane
    found = surface_simulation.simulate(op)
    wanted = cusp_of(op.LargestStepover.Value)
    # At the border links cross the ends of cusps.
    assert found.mean_cusp == pytest.approx(wanted, rel=2e-3)
    assert found.cusp_95 == pytest.approx(wanted, rel=1e-6)
    assert found.max_cusp == pytest.approx(wanted, rel=1e-6)
    assert found.gouge_mm < 1e-9 and found.gouge_at is None
    assert found.uncovered_area == 0
    assert found.covered_area == pytest.approx(24 * 16, rel=0.02)
    assert numpy.nanmax(found.rest) <= wanted + 1e-9
    assert found.wish is None and found.wish_share is None  # an even stepover wishes for none
    assert found.notes == []


def test_a_coarse_resolution_tells_the_same_cusps_and_warns(plane):
    _, op = plane
    found = surface_simulation.simulate(op, resolution=0.3)
    assert found.cusp_95 == pytest.approx(cusp_of(op.LargestStepover.Value), rel=1e-6)
    assert "cusps may be missed" in found.notes[0]


@pytest.mark.core
def test_the_wish_for_even_cusps_is_met_on_the_dome(finished):
    _, op = finished(part(True), Spacing=EVEN_CUSPS, CuspHeight=0.01, PassAngle=0.0)
    found = surface_simulation.simulate(op)
    assert found.wish == pytest.approx(0.01)
    assert found.wish_share > 0.98  # as docs/finishing.md says
    assert found.gouge_mm < 0.1 * op.Tolerance.Value + found.deflection
    assert found.uncovered_area < 1
    assert found.cusp_95 == pytest.approx(0.01, rel=0.1)


@pytest.mark.core
@pytest.mark.parametrize("strategy", ["Contours inwards", "Spiral outwards"])
def test_contours_and_spirals_have_a_wish_as_well(finished, strategy):
    asked = {"Strategy": strategy, "CuspHeight": 0.01}
    b, op = finished(Part.makeCylinder(12, 10), Spacing=EVEN_CUSPS, **asked)
    found = surface_simulation.simulate(op)
    assert found.wish == pytest.approx(0.01)
    assert 0.5 < found.wish_share <= 1
    b.set(op, Spacing="Constant stepover")
    b.done(op)
    assert surface_simulation.simulate(op).wish_share is None


@pytest.mark.core
def test_an_even_stepover_over_the_dome_leaves_what_its_curvature_says(finished):
    _, op = finished(part(True), Stepover=0.5, PassAngle=0.0)
    found = surface_simulation.simulate(op, tolerance=0.001)
    at_crest = found.cusp[numpy.abs(found.y).argmin()]
    step = op.LargestStepover.Value
    half = step / 2
    crest = math.sqrt((DOME + BALL) ** 2 - half**2) - math.sqrt(BALL**2 - half**2) - DOME
    assert numpy.nanmean(at_crest) == pytest.approx(crest, rel=0.1)
    steep = numpy.nanmean(found.cusp[numpy.abs(found.y - 22).argmin()])
    assert steep > 1.15 * numpy.nanmean(at_crest)  # passes lie further apart along the slope
    assert found.notes == []
    coarse = surface_simulation.simulate(op, tolerance=0.02, resolution=0.2)
    assert "The triangles leave the part by up to 0.00" in coarse.notes[-1]


def test_a_lowered_path_gouges_and_says_where(plane):
    b, op = plane
    low = [
        "G0 X5 Y8 Z20",
        "G1 X5 Y8 Z9.95 F10",
        "G1 X15 Y8 Z9.95 F10",
        "G0 X15 Y8 Z20",
    ]
    found = surface_simulation.simulate(foreign(b, *low, name="Low"), resolution=0.05)
    assert found.gouge_mm == pytest.approx(0.05, abs=2e-4)
    x, y, z = found.gouge_at
    assert 4.9 <= x <= 15.1 and y == pytest.approx(8, abs=0.05) and z == pytest.approx(10)
    # All that looks up below the path is looked at; what the ball does not touch is not cut.
    assert found.uncovered_area > 0
    reach = math.sqrt(0.35 * (2 * BALL - 0.35))  # where it leaves the stock
    half_ends = math.pi * reach**2
    assert found.covered_area == pytest.approx(2 * reach * 10 + half_ends, rel=0.02)
    with pytest.raises(ValueError, match="along an EvenLoad Finishing only"):
        found.picture("none.png", "h_m")


def test_what_the_ball_cannot_reach_is_not_covered(finished):
    step = Part.makeBox(24, 16, 10).cut(Part.makeBox(12, 16, 5, FreeCAD.Vector(0, 0, 5)))
    _, op = finished(step, Stepover=0.5)
    found = surface_simulation.simulate(op)
    # At the foot of the wall of 5 mm the ball stays off a strip, less where it leaves no stock.
    strip = BALL - math.sqrt(surface_simulation.STOCK * (2 * BALL - surface_simulation.STOCK))
    assert found.uncovered_area == pytest.approx(strip * 16, rel=0.06)
    assert found.gouge_mm < 2e-3
    assert found.max_cusp == pytest.approx(cusp_of(op.LargestStepover.Value), rel=0.1)


def test_an_allowance_stands_on_the_faces(finished):
    _, op = finished(Part.makeBox(24, 16, 10), Stepover=0.5, Allowance=0.1)
    found = surface_simulation.simulate(op)
    # Half a cell beside the lowest places, at the most.
    assert 0 <= numpy.nanmin(found.above) - 0.1 < (found.resolution / 2) ** 2 / (2 * BALL)
    assert found.cusp_95 == pytest.approx(cusp_of(op.LargestStepover.Value), rel=1e-6)
    assert found.stock == pytest.approx(0.1 + surface_simulation.STOCK)


def test_roughness_is_that_of_teeth_along_the_feed_and_of_passes_across_it(plane):
    _, op = plane
    found = surface_simulation.simulate(op)
    patch = found.roughness(at=(12.0, 8.0))
    assert abs(patch.way[0]) == pytest.approx(1)
    assert patch.feed_per_tooth == pytest.approx(FEED / SPEED / TEETH)
    assert patch.rt_along == pytest.approx(cusp_of(patch.feed_per_tooth), rel=0.15)
    assert patch.rt_across == pytest.approx(cusp_of(op.LargestStepover.Value), rel=0.05)
    assert patch.rz_across <= patch.rt_across * 1.0001
    with pytest.raises(ValueError, match="No pass cuts the faces at x = 90"):
        found.roughness(at=(90.0, 8.0))


def test_without_a_spindle_speed_nothing_marks_the_surface_along_the_feed(plane):
    b, op = plane
    b.controller.SpindleSpeed = 0
    patch = surface_simulation.simulate(op).roughness()
    assert patch.feed_per_tooth is None and patch.rt_along < 1e-9


def test_a_patch_too_large_for_the_marks_of_teeth_says_so(plane):
    _, op = plane
    found = surface_simulation.simulate(op)
    assert found.roughness(at=(12.0, 8.0)).notes == ()
    (note,) = found.roughness(at=(12.0, 8.0), size=12).notes
    assert "coarse beside marks of %.3f mm" % (FEED / SPEED / TEETH) in note


@pytest.fixture
def few_patches(monkeypatch):
    monkeypatch.setattr(rough_map, "PLACES", 9)


def test_roughness_all_over_is_that_of_the_patches_at_its_places(plane):
    _, op = plane
    found = surface_simulation.simulate(op, resolution=0.2)
    over = found.roughness_map
    assert rough_map.PLACES / 2 < len(over.places) <= rough_map.PLACES and over.notes == ()
    for number in (0, 17, len(over.places) - 1):
        patch = found.roughness(tuple(over.places[number]))
        assert over.rz_along[number] == patch.rz_along
        assert over.rz_across[number] == patch.rz_across
    assert numpy.median(over.rz_across) == pytest.approx(
        cusp_of(op.LargestStepover.Value), rel=0.05
    )
    on = over.on(found, over.rz_across)
    assert numpy.array_equal(numpy.isfinite(on), found.is_covered)
    for row, column in ((3, 4), (60, 71), (40, 20)):
        apart = numpy.hypot(*(over.places - (found.x[column], found.y[row])).T)
        assert on[row, column] == over.rz_across[apart.argmin()]


def test_what_no_pass_has_cut_is_not_rough(plane, few_patches):
    b, _ = plane
    ways = ["G0 X0 Y4 Z20", "G1 X0 Y4 Z10 F27.2", "G1 X24 Y4 Z10 F27.2", "G0 X24 Y4 Z20"]
    found = surface_simulation.simulate(foreign(b, *ways, name="Single"), resolution=0.1)
    assert found.uncovered_area > found.covered_area
    over = found.roughness_map
    # Beside the pass the stock stands for the part: not as high as a cusp between passes.
    assert 0 < over.rz_across.max() < surface_simulation.STOCK
    assert numpy.isfinite(found.roughness((12.0, 4.0)).rt_across)


def test_faces_narrower_than_a_patch_have_no_roughness(plane, few_patches):
    b, _ = plane
    b.model.Shape = Part.makeBox(24, 0.01, 10)
    ways = ["G0 X-5 Y0 Z20", "G1 X-5 Y0 Z10 F10", "G1 X30 Y0 Z10 F10", "G0 X30 Y0 Z20"]
    found = surface_simulation.simulate(foreign(b, *ways, name="Thin"), resolution=0.1)
    with pytest.raises(ValueError, match="'Thin' cuts is narrower than a patch of 0.8 mm"):
        found.roughness_map


def test_roughness_all_over_tells_its_share_and_is_stopped(plane):
    _, op = plane
    found, shares = surface_simulation.simulate(op, resolution=0.2), []

    def watch(share):
        shares.append(share)
        return share < 0.05

    with waiting.asking(watch), pytest.raises(waiting.Stopped):
        found.roughness_map
    assert shares == sorted(shares) and shares[0] == 0 and 0.05 <= shares[-1] < 0.1


def test_ten_points_are_the_source_s():
    profile = numpy.array([0, 5, 0, 4, 1, 6, 0.5, 3, 0, 7, -1, 2, 0.0])
    highest, deepest = (7 + 6 + 5 + 4 + 3) / 5, (-1 + 0 + 0 + 0.5 + 1) / 5
    assert rough.ten_points(profile) == pytest.approx(highest - deepest)
    assert rough.ten_points(numpy.array([0.0, 1.0, 2.0])) == 2  # no extremes: from end to end


def test_triangles_are_made_once_and_not_while_the_document_is_read(plane, monkeypatch):
    _, op = plane
    occt, made = compiled.occt(), []

    class Counting:
        ShapeError = occt.ShapeError

        @staticmethod
        def triangles_from_brep(*asked):
            made.append(asked)
            return occt.triangles_from_brep(*asked)

    monkeypatch.setattr(compiled, "occt", lambda: Counting)
    question = surface_simulation.read(op)
    assert made == []
    found = surface_simulation.simulated(question, 0.2)
    assert len(found.chips.mean_thickness) > 100
    assert len(made) == 1


def test_chips_are_those_of_the_advisor(plane):
    _, op = plane
    found = surface_simulation.simulate(op)
    on_path = found.chips
    step = op.LargestStepover.Value
    chip = ball_end.chip(("plane",), 2 * BALL, FEED / SPEED / TEETH, step, 0.3, 0)
    assert numpy.median(on_path.mean_thickness) == pytest.approx(chip.mean_thickness, rel=0.01)
    on = on_path.on(found, on_path.tip_share)
    assert numpy.isfinite(on).sum() == found.is_covered.sum()
    # Each cell has the value of the place that is nearest to it.
    for row, column in ((3, 4), (60, 71), (100, 20)):
        apart = numpy.hypot(on_path.tips[:, 0] - found.x[column], on_path.tips[:, 1] - found.y[row])
        assert on[row, column] == on_path.tip_share[apart.argmin()]


@pytest.mark.parametrize("extent", [0.2, 30.0])  # of the places, on cells of 30 mm
def test_the_nearest_places_are_found_in_little_memory(extent):
    sides = numpy.linspace(0, 30, 300)
    cells = numpy.stack(numpy.meshgrid(sides, sides), axis=-1).reshape(-1, 2)
    places = extent * numpy.random.default_rng(3).random((1000, 2))
    tracemalloc.start()
    found = nearest._nearest(cells, places)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 16e6  # all distances at once would take 720e6
    apart = [numpy.hypot(*(places - cell).T) for cell in cells[::97]]
    assert numpy.array_equal(found[::97], [each.argmin() for each in apart])


def test_faces_narrower_than_a_cell_have_one_row_of_them(plane):
    b, _ = plane
    b.model.Shape = Part.makeBox(24, 0.01, 10)
    way = ["G0 X-5 Y0 Z20", "G1 X-5 Y0 Z10 F10", "G1 X30 Y0 Z10 F10", "G0 X30 Y0 Z20"]
    found = surface_simulation.simulate(foreign(b, *way, name="Narrow"), resolution=0.1)
    assert found.part.shape == (1, 240) and found.resolution == 0.1
    assert found.y[0] == pytest.approx(0.005)
    assert found.is_covered.all() and found.uncovered_area == 0


@pytest.mark.parametrize("what", PICTURES)
def test_each_picture_is_written(plane, few_patches, tmp_path, what, monkeypatch):
    _, op = plane
    found = surface_simulation.simulate(op, resolution=0.2)
    found.picture(tmp_path / "map.png", what)
    assert (tmp_path / "map.png").read_bytes()[:4] == b"\x89PNG"
    found.picture(tmp_path / "map.svg", what)
    text = (tmp_path / "map.svg").read_text()
    assert op.Label in text and ("µm" in text or "%" in text)
    monkeypatch.setattr(units, "shows_inches", lambda: True)
    found.picture(tmp_path / "map.svg", what)
    text = "".join(re.findall("<text[^>]*>([^<]*)</text>", (tmp_path / "map.svg").read_text()))
    assert op.Label in text and "in" in text and not re.search(r"\bmm\b|mm²|µm", text)


def test_what_cannot_be_is_refused_in_a_sentence(plane):
    b, op = plane
    refused = lambda match, **asked: pytest.raises(ValueError, match=match)  # noqa: E731
    with refused("The resolution is 0 mm"):
        surface_simulation.simulate(op, resolution=0.0)
    with refused("makes too many cells: choose at least 0.0"):
        surface_simulation.simulate(op, resolution=0.002)
    with refused("The stock on the faces is -1 mm"):
        surface_simulation.simulate(op, stock=-1.0)
    with refused("The tolerance is 0 mm"):
        surface_simulation.simulate(op, tolerance=0.0)
    with pytest.raises(ValueError, match="no picture of 'dust': choose one of 'cusp'"):
        surface_simulation.simulate(op, resolution=0.5).picture("x.png", "dust")
    b.controller.Tool = host.create_tool("v-bit", {"Diameter": 6.0})
    with pytest.raises(ValueError, match="a V bit: choose a ball end"):
        surface_simulation.simulate(op)


def test_it_stops_when_asked(plane):
    _, op = plane
    with pytest.raises(waiting.Stopped):
        surface_simulation.simulate(op, progress=lambda share: False)


def test_a_bull_nose_leaves_no_cusps_on_a_plane(finished):
    _, op = finished(Part.makeBox(24, 16, 10), tool="bullnose", Stepover=2.0)
    found = surface_simulation.simulate(op)
    # Off the corners, into which the round tool does not come.
    inner = (numpy.abs(found.y - 8) < 5)[:, None] & (numpy.abs(found.x - 12) < 8)
    assert found.rest[inner].max() < 1e-6
    assert found.cusp_95 is None or found.cusp_95 < 1e-6
    with pytest.raises(ValueError, match="has no ball end"):
        found.chips


def test_the_same_on_each_run(plane):
    _, op = plane
    one, two = (surface_simulation.simulate(op, resolution=0.2) for _ in range(2))
    assert numpy.array_equal(one.above, two.above, equal_nan=True)
    assert one.figures() == two.figures()
