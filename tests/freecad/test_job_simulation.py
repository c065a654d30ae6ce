"""What the simulator is given of an operation: moves, tool, stock, part and earlier cuts."""

import math
from types import SimpleNamespace

import Part
import Path
import pytest
from conftest import sweep_of
from evenload import commands, compiled, host, job_simulation, tool
from evenload.simulation import earlier, part, run
from FreeCAD import Vector
from models import (
    BLOCK,
    CORPUS,
    DEPTH,
    MARGIN,
    SQUARE,
    block_with,
    case_model,
    circle,
    corpus_case,
    face_of,
    floors_of,
    rectangle,
    sketch_of,
)

RAPID, CUT = commands.RAPID, commands.CUT


def command(text):
    """A Path.Command from G-code; F in mm/s."""
    made = Path.Command()
    made.setFromGCode(text)
    return made


def moves(*texts, z=10.0, feed=600.0):
    """Moves and their numbers, but for the first, which says where the tool is before."""
    found, numbers = commands.to_moves([command(text) for text in texts], z, feed)
    assert found[0][0] == RAPID and found[0][3] == z and numbers[0] == 0
    return found[1:], numbers[1:]


def ends(found):
    return [(kind, x, y, z) for kind, x, y, z, *_ in found]


# ---- moves ----


def test_lines_and_rapids_keep_the_axes_that_they_do_not_name():
    found, numbers = moves("G0 X1 Y2", "(words)", "G0 Z1", "G1 Z-3 F2", "M8", "G01 X5")
    assert ends(found) == [(RAPID, 1, 2, 1), (CUT, 1, 2, -3), (CUT, 5, 2, -3)]
    assert [move[7] for move in found] == [0, 120, 120]
    assert numbers == [3, 4, 6]


def test_before_the_first_position_the_tool_is_above_it():
    named = [command(text) for text in ("G0 Z15", "G0 X7 Y8", "G0 Z2")]
    found, numbers = commands.to_moves(named, 20, 60)
    assert ends(found) == [(RAPID, 7, 8, 20), (RAPID, 7, 8, 15), (RAPID, 7, 8, 2)]
    assert numbers == [0, 1, 3]


def test_feed_moves_before_the_first_feed_have_the_controllers_and_rapids_set_none():
    found, _ = moves("G0 X1 Y0 F50", "G1 X2", "G1 X3 F1", "G1 X4")
    assert [move[7] for move in found[-3:]] == [600, 60, 60]


@pytest.mark.parametrize(
    "text, sweep, centre",
    [
        ("G3 X0 Y10 I-10 J0", math.pi / 2, (0, 0)),
        ("G2 X0 Y10 I-10 J0", -3 * math.pi / 2, (0, 0)),
        ("G3 X10 Y0 I-4 J3", 2 * math.pi, (6, 3)),
        ("G2 X10 Y0 Z-2 I-4 J0", -2 * math.pi, (6, 0)),
        ("G03 X20 Y0 I5", math.pi, (15, 0)),
    ],
)
def test_arcs_have_centre_and_sweep(text, sweep, centre):
    found, numbers = moves("G0 X10 Y0", "G1 Z0 F1", text)
    kind, x, y, z, turned, cx, cy, feed = found[-1]
    assert kind == CUT and turned == pytest.approx(sweep) and feed == 60
    assert (cx, cy) == pytest.approx(centre)
    assert z == (-2 if "Z-2" in text else 0)
    assert numbers[-1] == 3


def test_a_centre_beside_its_place_is_moved_to_equal_radii():
    found, _ = moves("G0 X10 Y0", "G1 Z0 F1", "G3 X0 Y10 I-10.002 J0.001")
    *_, cx, cy, _ = found[-1]
    assert math.dist((cx, cy), (10, 0)) == pytest.approx(math.dist((cx, cy), (0, 10)), abs=1e-12)
    assert math.dist((cx, cy), (-0.002, 0.001)) < 0.003
    start = 10 - cx, -cy
    turn = found[-1][4]
    assert start[0] * math.cos(turn) - start[1] * math.sin(turn) == pytest.approx(-cx, abs=1e-9)


@pytest.mark.parametrize(
    "text, words",
    [
        ("G3 X0 Y10 I-10.1 J0", ["Command 3 of the path, G3,", "10.1 and", "correct its I and J"]),
        ("G2 X0 Y10", ["Command 3", "has no radius"]),
        ("G91", ["Command 3 of the path, G91,", "is not known"]),
        ("G18", ["G18"]),
        ("G20", ["G20"]),
        ("G38.2 Z-10", ["G38.2"]),
        ("G98 G81 X0 Y0 Z-5 R1", ["Command 3", "G98, has a second G word", "line of its own"]),
        ("G1 X3 A20", ["turns the work"]),
        ("G81 X0 Y0 Z5 R1", ["drills from Z1 up to Z5"]),
        ("G83 X0 Y0 Z-5 R1", ["no depth of peck"]),
    ],
)
def test_a_command_that_cannot_be_followed_is_named(text, words):
    with pytest.raises(ValueError) as caught:
        moves("G0 X10 Y0", "G1 Z0 F1", text)
    for word in words:
        assert word in str(caught.value)


def test_a_number_that_is_not_finite_is_refused():
    broken = Path.Command("G1", {"X": float("nan")})
    with pytest.raises(ValueError, match="Command 1 of the path, G1, has a number"):
        commands.to_moves([broken], 10, 60)


def test_a_drilling_cycle_becomes_its_moves():
    found, numbers = moves("G98", "G81 X3 Y4 Z-5 R2 F1", "G82 X6 Y4 Z-5 R2 P1", "G80")
    down_and_up = [(RAPID, 2), (CUT, -5), (RAPID, 10)]
    expected = [(kind, 3, 4, z) for kind, z in down_and_up] + [(RAPID, 6, 4, 10)]
    expected += [(kind, 6, 4, z) for kind, z in down_and_up]
    assert ends(found) == expected
    assert numbers == [2] * 3 + [3] * 4
    assert {move[7] for move in found} == {0, 60}


def test_cycles_that_retract_to_r_stay_there_between_holes():
    found, _ = moves("G99", "G81 X0 Y0 Z-5 R2 F1", "G81 X9 Y0 Z-5 R2")
    assert [z for *_, z in ends(found)] == [2, -5, 2, 2, -5, 2]


@pytest.mark.parametrize("code, clears", [("G83", True), ("G73", False)])
def test_pecks_go_down_by_q_and_end_at_the_bottom(code, clears):
    found, _ = moves("G99", code + " X0 Y0 Z-5 R1 Q2.5 F1")
    assert [z for kind, _, _, z in ends(found) if kind == CUT] == [-1.5, -4, -5]
    assert [z for kind, _, _, z in ends(found) if kind == RAPID].count(1) == (4 if clears else 2)
    before_cut = [a[3] for a, b in zip(found, found[1:]) if b[0] == CUT]
    assert before_cut == [1, -1.246, -3.746]


@pytest.mark.parametrize(
    "code, way_out",
    [("G85", CUT), ("G89", CUT), ("G84", CUT), ("G74", CUT)]
    + [("G76", RAPID), ("G86", RAPID), ("G88", RAPID)],
)
def test_boring_and_tapping_cycles_go_down_and_come_out_as_they_do(code, way_out):
    found, numbers = moves("G99", code + " X3 Y4 Z-5 R2 Q0.1 P1 F1")
    assert ends(found) == [(RAPID, 3, 4, 2), (CUT, 3, 4, -5), (way_out, 3, 4, 2)]
    assert set(numbers) == {2}
    found, _ = moves("G98", code + " X3 Y4 Z-5 R2 Q0.1 P1 F1")
    assert ends(found)[-1] == (RAPID, 3, 4, 10)


def test_back_boring_takes_nothing_that_stands():
    found, _ = moves("G98", "G87 X3 Y4 Z-3 R-8 Q0.5 F1", "G80", "G0 X6")
    assert ends(found) == [(RAPID, 6, 4, 10)]


def test_the_way_home_goes_through_its_place_and_up():
    found, _ = moves("G0 X1 Y2", "G1 Z-3 F1", "G28 Z2", "G1 X4 Z1", "G30", z=10.0)
    assert ends(found) == [
        (CUT, 1, 2, -3),
        (RAPID, 1, 2, 2),
        (RAPID, 1, 2, 10),
        (CUT, 4, 2, 1),
        (RAPID, 4, 2, 10),
    ]


def test_moves_there_and_back_are_the_same(square):
    op = square.done(square.operation())
    computed = op.Proxy.last.toolpath.moves
    found, numbers = commands.to_moves(op.Path.Commands, 50, 1)
    length = commands.length(op.Path.Commands)
    assert _length(found) == pytest.approx(length, rel=1e-5)
    assert {round(m[7], 3) for m in found[1:]} == {round(m[7], 3) for m in computed}
    assert numbers == sorted(numbers)
    named = [op.Path.Commands[n - 1].Name for n in numbers[1:]]
    assert [name == "G0" for name in named] == [move[0] == RAPID for move in found[1:]]


def test_a_path_is_followed_once_and_anew_when_it_or_what_it_follows_is_another(square):
    op = square.done(square.operation())
    found, _ = earlier.moves_of(op)
    assert earlier.moves_of(op)[0] is found
    op.ClearanceHeight = op.ClearanceHeight.Value + 7
    higher, _ = earlier.moves_of(op)
    assert higher[0][3] == op.ClearanceHeight.Value and higher[-1] == found[-1]
    written = op.Path.Commands
    op.Path = Path.Path(written[:-9])
    assert len(earlier.moves_of(op)[0]) < len(found)
    op.Path = Path.Path(written)
    assert earlier.moves_of(op)[0] is higher


def test_followed_paths_are_kept_up_to_a_number_of_moves(square, monkeypatch):
    ops = [square.done(square.operation(EngagementAngle=angle)) for angle in (50, 60)]
    first, second = (earlier.moves_of(op)[0] for op in ops)
    assert [earlier.moves_of(op)[0] is each for op, each in zip(ops, (first, second))] == [1, 1]
    monkeypatch.setattr(earlier, "MOST_KEPT", len(second))
    assert earlier.moves_of(ops[1])[0] is second
    again, _ = earlier.moves_of(ops[0])
    assert again == first and again is not first


def _length(found):
    total, at = 0.0, None
    for kind, x, y, z, sweep, cx, cy, _ in found:
        if kind != RAPID:
            flat = math.dist((x, y), at[:2])
            if sweep:
                flat = abs(sweep) * math.dist((x, y), (cx, cy))
            total += math.hypot(flat, z - at[2])
        at = x, y, z
    return total


def test_the_sweep_is_that_of_an_independent_count():
    for name in ("G2", "G3"):
        for end in ((0, 5), (5, 0), (3, 4), (-3, -4), (10, 0)):
            centre = (5 * math.cos(0.3), 5 * math.sin(0.3))
            expected = sweep_of(name, (0, 0), end, centre)
            assert commands.sweep_of(*end, *centre, name == "G3") == pytest.approx(expected)


# ---- tool and cutting data ----


def test_tool_and_cutting_data_are_the_controllers(bench):
    on = bench(block_with(face_of(SQUARE)), tool=6, feed=255, flutes=3)
    host.set_rapid_feed(on.controller, 4000)
    found = job_simulation.read(on.done(on.operation()))
    assert found.tool.diameter == 6 and found.tool.teeth == 3
    assert found.cutting == pytest.approx({"spindle_speed": 6366, "rapid_feed": 4000})
    assert {round(m[7]) for m in found.moves if m[0] == CUT} >= {255}
    assert found.notes == []


def test_a_spindle_that_stands_still_leaves_a_note(square):
    square.controller.SpindleSpeed = 0
    found = job_simulation.read(square.done(square.operation()))
    assert set(found.cutting) == {"rapid_feed"}
    assert "no spindle speed" in found.notes[0]


def test_a_bull_nosed_tool_is_taken_for_a_flat_one_with_a_note(square):
    square.controller.Tool = host.create_tool("bullnose", {"Diameter": 6.0})
    found = job_simulation.read(square.done(square.operation()))
    assert found.tool.bull_nosed and "sharp corners" in found.notes[0]


def test_a_tool_that_is_no_end_mill_is_refused(square):
    op = square.done(square.operation())
    square.controller.Tool = host.create_tool("ballend", {"Diameter": 6.0})
    with pytest.raises(ValueError, match="whose loads are not simulated: EvenLoad Show Surface"):
        job_simulation.read(op)
    square.controller.Tool = host.create_tool("v-bit", {"Diameter": 6.0})
    with pytest.raises(ValueError, match="a V bit: choose a flat"):
        job_simulation.read(op)


def test_what_cannot_be_simulated_says_why(square):
    op = square.operation()
    op.Active = False
    square.doc.recompute()
    with pytest.raises(ValueError, match="'Operation' is not active: activate it first"):
        job_simulation.read(op)
    op.Active = True
    op.Path = Path.Path()
    with pytest.raises(ValueError, match="has no path to simulate: recompute it first"):
        job_simulation.read(op)
    loose = square.doc.addObject("Path::Feature", "Loose")
    with pytest.raises(ValueError, match="'Loose' belongs to no job"):
        job_simulation.read(loose)


# ---- stock ----


def with_stock(square, body):
    before = square.job.Stock
    stock = square.doc.addObject("Part::Feature", "Stock")
    stock.Shape = body
    square.job.Stock = stock
    square.doc.removeObject(before.Name)
    return job_simulation.read(square.done(square.operation()))


def test_a_box_of_stock_has_its_outline_top_and_bottom(square):
    host.set_stock_margin(square.job, 2.0)
    found = job_simulation.read(square.done(square.operation(StartDepth=2.0)))
    (stock,) = found.stock
    assert stock.area == pytest.approx((30 + 2 * MARGIN + 4) ** 2) and len(stock.outer) == 4
    assert (found.top, found.bottom) == pytest.approx((2, -BLOCK - 2))


def test_a_round_stock_has_a_round_outline(square):
    body = Part.makeCylinder(40, BLOCK, Vector(15, 15, -BLOCK))
    found = with_stock(square, body)
    (stock,) = found.stock
    assert stock.area == pytest.approx(math.pi * 40**2)
    assert all(piece[2] for piece in stock.outer) and found.notes == []
    assert (found.top, found.bottom) == pytest.approx((0, -BLOCK))


def test_a_tube_of_stock_has_its_hole(square):
    body = Part.makeCylinder(40, BLOCK, Vector(15, 15, -BLOCK))
    body = body.cut(Part.makeCylinder(4, BLOCK, Vector(15, 15, -BLOCK)))
    (stock,) = with_stock(square, body).stock
    assert stock.area == pytest.approx(math.pi * (40**2 - 4**2)) and len(stock.islands) == 1


def test_a_stock_that_leans_is_as_high_as_it_is_everywhere(square):
    body = Part.makeCone(50, 40, BLOCK, Vector(15, 15, -BLOCK))
    found = with_stock(square, body)
    assert found.stock[0].area == pytest.approx(math.pi * 50**2, rel=1e-3) and found.notes == []
    for x, z in ((54.9, -1e-2), (55.5, -0.6), (60, -6), (64, -10.8)):
        assert found.blocks.top_at(x, 15) == pytest.approx(z, abs=0.02)
    assert found.blocks.top_at(66, 15) == -math.inf


def test_a_stock_with_a_recess_is_low_where_the_recess_is(square):
    block = Part.makeBox(50, 50, BLOCK, Vector(-10, -10, -BLOCK))
    found = with_stock(square, block.cut(Part.makeBox(10, 10, 2, Vector(5, 5, -2))))
    tops = {round(top, 6): region.area for region, top in found.blocks}
    assert tops == pytest.approx({0: 2500 - 100, -2: 100})


def test_under_an_overhang_stock_counts_as_filled(square):
    block = Part.makeBox(50, 50, BLOCK, Vector(-10, -10, -BLOCK))
    found = with_stock(square, block.cut(Part.makeBox(50, 10, 4, Vector(-10, 10, -8))))
    assert compiled.core().DexelStock(found.blocks, found.bottom, 0.5).volume == pytest.approx(
        2500 * BLOCK, rel=1e-6
    )


# ---- what must stay: EvenLoad's operations ----


def area_at(part, z):
    """mm^2 of what must stay at a height. The regions of a part here do not overlap above z."""
    return sum(region.area for region, top in part if top > z)


def _lowest(part):
    return min(top for _, top in part)


STOCK_AREA = (30 + 2 * MARGIN) ** 2


def test_a_pocket_leaves_the_stock_around_it_and_the_floor_below(square):
    part = job_simulation.read(square.done(square.operation())).part
    assert area_at(part, -1) == pytest.approx(STOCK_AREA - 900)
    assert area_at(part, -4) == pytest.approx(STOCK_AREA)
    assert sorted({round(top, 6) for _, top in part}) == [-DEPTH, 0]


def test_the_part_of_a_sketch_on_an_uncut_block_is_the_sketch(bench):
    on = bench(Part.makeBox(50, 50, BLOCK, Vector(-10, -10, -BLOCK)))
    sketch = sketch_of(on.doc, circle(15, 15, 12), z=0)
    part = job_simulation.read(on.done(on.operation(base=[(sketch, "")]))).part
    assert area_at(part, -1) == pytest.approx(STOCK_AREA - math.pi * 144)
    assert area_at(part, -3.1) == pytest.approx(STOCK_AREA)


def test_an_island_stays(bench):
    on = bench(block_with(face_of(SQUARE, [circle(15, 15, 4)])))
    part = job_simulation.read(on.done(on.operation())).part
    assert area_at(part, -1) == pytest.approx(STOCK_AREA - 900 + math.pi * 16)
    assert len([top for _, top in part if top == 0]) == 2


def test_stock_to_leave_must_stay_along_the_walls(square):
    found = job_simulation.read(square.done(square.operation(StockToLeave=0.5)))
    part, (stock,) = found.part, found.stock
    (wall,) = [region for region, top in part if top == 0]
    pocket = math.fsum(_area(island) for island in wall.islands)
    assert abs(pocket) == pytest.approx(29 * 29, rel=1e-6)
    assert abs(_area(wall.outer)) == pytest.approx(stock.area)  # and not more than there is


def test_axial_stock_to_leave_must_stay_on_the_floor(square):
    found = job_simulation.read(square.done(square.operation(StockToLeaveAxial=0.5)))
    assert min(top for _, top in found.part) == pytest.approx(-2.5)
    simulation = found.simulate(resolution=0.2)
    assert simulation.gouge_mm < 0.01 and simulation.rest_area < 0.5


def _area(chain):
    pairs = zip(chain, [*chain[1:], chain[0]])
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2


def test_above_the_final_depth_nothing_is_left_that_the_operation_does_not_mean_to_cut(square):
    higher = job_simulation.read(square.done(square.operation(FinalDepth=-2.0)))
    assert min(top for _, top in higher.part) == pytest.approx(-2)
    deeper = job_simulation.read(square.done(square.operation(FinalDepth=-4.0)))
    assert min(top for _, top in deeper.part) == pytest.approx(-DEPTH)


def open_block():
    """A block with a slot of 20 mm that is open at both ends, and with one rounded end."""
    slot = Part.makeBox(70, 20, DEPTH, Vector(-10, 5, -DEPTH))
    block = Part.makeBox(40, 30, BLOCK, Vector(0, 0, -BLOCK))
    end = Part.makeCylinder(15, BLOCK, Vector(40, 15, -BLOCK))
    return block.fuse(end).removeSplitter().cut(slot)


def test_nothing_must_stay_beyond_open_sides(bench):
    on = bench(open_block())
    stock = on.doc.addObject("Part::Feature", "Blank")
    stock.Shape = Part.makeBox(40, 30, BLOCK, Vector(0, 0, -BLOCK)).fuse(
        Part.makeCylinder(15, BLOCK, Vector(40, 15, -BLOCK))
    )
    on.job.Stock = stock
    op = on.done(on.operation())
    (floor,) = op.Proxy.last.floors
    assert sum(piece[3] for piece in floor.outer) >= 2
    found = job_simulation.read(op)
    walls = [region for region, top in found.part if top == 0]
    assert len(walls) == 2
    slot = floor.region().area
    whole = found.stock[0].area
    assert sum(wall.area for wall in walls) == pytest.approx(whole - slot, abs=0.01 * 2 * 0.1)
    assert all(wall.area > 50 for wall in walls)  # no slivers
    floors = [region for region, top in found.part if top != 0]
    everything = sum(region.area for region in walls + floors)
    assert everything == pytest.approx(whole, abs=1e-4)


@pytest.mark.parametrize("outer", [rectangle(0, 0, 40, 30), circle(0, 0, 20)])
def test_a_floor_that_is_open_all_round_leaves_its_bosses_only(bench, outer):
    x, y = (20, 15) if len(outer) == 4 else (0, 0)
    plate = face_of(outer).extrude(Vector(0, 0, DEPTH - BLOCK)).translated(Vector(0, 0, -DEPTH))
    boss = face_of(circle(x, y, 5)).extrude(Vector(0, 0, DEPTH)).translated(Vector(0, 0, -DEPTH))
    on = bench(plate.fuse(boss).removeSplitter())
    op = on.done(on.operation())
    part = job_simulation.read(op).part
    walls = [region for region, top in part if top == 0]
    assert [wall.area for wall in walls] == pytest.approx([math.pi * 25], rel=1e-6)


def test_ground_beside_a_tight_hollow_is_covered_whole():
    chain = [(0, 0, -1.0, True), (0.1, 0, 0.0, False), (5, 5, 0.0, False)]
    floor = SimpleNamespace(outer=chain)
    (hollow,) = part._beyond(floor)
    assert hollow.Area == pytest.approx(math.pi * 0.05**2 / 2)
    (band,) = part._beyond(SimpleNamespace(outer=[(0, 0, 1.0, True), (10, 0, 0, False)]))
    assert band.Area == pytest.approx(math.pi / 2 * (5.1**2 - 5**2), rel=1e-6)
    (band,) = part._beyond(SimpleNamespace(outer=[(0, 0, 0.0, True), (10, 0, 0, False)]))
    assert band.Area == pytest.approx(1.0) and band.BoundBox.YMin == pytest.approx(-0.1)


def test_a_document_that_was_opened_again_gives_the_same_part(square):
    op = square.done(square.operation())
    before = job_simulation.read(op)
    op.Proxy.last = None
    after = job_simulation.read(op)
    assert [top for _, top in after.part] == [top for _, top in before.part]
    assert [r.outer for r, _ in after.part] == [r.outer for r, _ in before.part]


# ---- what must stay: any operation ----


def foreign(on, *texts, base=(), name="Foreign", controller=None):
    """An operation that is not ours, with a path of these commands."""
    op = on.doc.addObject("Path::FeaturePython", name)
    op.addProperty("App::PropertyLink", "ToolController")
    op.addProperty("App::PropertyLinkSubListGlobal", "Base")
    op.addProperty("App::PropertyBool", "Active")
    op.Active = True
    op.Base = list(base)
    op.ToolController = controller or on.controller
    op.Path = Path.Path([command(text) for text in texts])
    on.job.Operations.Group = [*on.job.Operations.Group, op]
    return op


CUTS = "G0 Z15", "G0 X5 Y5", "G1 Z-1 F1", "G1 X25 F2", "G0 Z15"


def test_the_part_of_any_operation_is_the_model(bench):
    upper = face_of(SQUARE).extrude(Vector(0, 0, -3))
    lower = face_of(circle(15, 15, 8)).extrude(Vector(0, 0, -8))
    block = Part.makeBox(50, 50, BLOCK, Vector(-10, -10, -BLOCK)).cut(upper).cut(lower)
    on = bench(block)
    host.set_stock_margin(on.job, 1.0)
    found = job_simulation.read(foreign(on, *CUTS))
    by_top = {round(top, 6): region.area for region, top in found.part}
    assert by_top == pytest.approx({-8: math.pi * 64, -3: 900 - math.pi * 64, 0: 2500 - 900})
    assert found.notes == [] and (found.top, found.bottom) == pytest.approx((1, -BLOCK - 1))


SLOPED = "G0 Z15", "G0 X30 Y0", "G1 Z6 F1", "G1 X25 F2", "G1 Z3 F1", "G1 X22 F2", "G0 Z15"


def test_a_model_that_leans_is_what_stands_above_each_level_of_the_path(bench):
    found = job_simulation.read(foreign(bench(Part.makeCone(20, 10, 10)), *SLOPED))
    areas = {round(top, 6): region.area for region, top in found.part}
    assert areas == pytest.approx(
        {3: math.pi * 20**2, 6: math.pi * 17**2, 10: math.pi * 14**2}, rel=2e-3
    )
    assert found.notes == []


def test_a_path_of_many_levels_on_a_model_that_leans_has_no_part_and_says_so(bench, monkeypatch):
    monkeypatch.setattr(part, "MOST_LEVELS", 1)
    found = job_simulation.read(foreign(bench(Part.makeCone(20, 10, 10)), *SLOPED))
    assert found.part is None and "more than 1 levels" in found.notes[0]


def test_what_must_stay_is_unknown_for_an_operation_on_a_sketch_of_its_own(square):
    sketch = sketch_of(square.doc, SQUARE)
    op = foreign(square, *CUTS, base=[(sketch, ("Edge1",))])
    found = job_simulation.read(op)
    assert found.part is None
    assert "'Sketch', which is not of the model" in found.notes[0]
    floors = tuple(floors_of(square.model.Shape))
    on_model = foreign(square, *CUTS, base=[(square.model, floors)], name="OnModel")
    assert job_simulation.read(on_model).part


@pytest.mark.parametrize("kind", ["Adaptive", "PocketShape", "Profile"])
def test_freecads_own_operations_can_be_read(square, kind):
    op = host.freecads(kind, "Theirs", square.job, square.controller)
    op.Base = [(square.model, tuple(floors_of(square.model.Shape)))]
    square.set(op, StartDepth=0.0, FinalDepth=-DEPTH, StepDown=DEPTH)
    square.doc.recompute()
    found = job_simulation.read(op)
    assert len(found.moves) > 3 and found.notes == []
    assert min(z for *_, z in ends(found.moves)) == pytest.approx(-DEPTH)
    assert area_at(found.part, -1) == pytest.approx(STOCK_AREA - 900)
    at_depth = [(x, y) for kind, x, y, z in ends(found.moves) if kind == CUT and z < -2.9]
    box = [f(point[k] for point in at_depth) for k in (0, 1) for f in (min, max)]
    assert min(box[0], box[2]) >= 2.9 and max(box[1], box[3]) <= 27.1


NAMES = sorted(path.stem for path in CORPUS.glob("*.json"))


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.core if k % 8 else ()) for k, name in enumerate(NAMES)],
)
def test_floors_and_model_agree_on_what_must_stay(bench, name):
    case = corpus_case(name)
    z = -case["axial_depth"]
    on = bench(case_model(case), tool=case["tool"])
    op = on.operation([(on.model, tuple(floors_of(on.model.Shape, z)))], FinalDepth=z, StepDown=-z)
    op.Path = Path.Path([command(text) for text in CUTS])  # without computing it
    by_floors = job_simulation.read(op)
    by_model = job_simulation.read(foreign(on, *CUTS))
    walls, floors = zip(
        *((area_at(p.part, 0.5 * z), _lowest(p.part)) for p in (by_floors, by_model))
    )
    assert walls[0] == pytest.approx(walls[1], abs=1e-3)
    assert floors == pytest.approx((z, z))
    assert by_floors.notes == by_model.notes == []


# ---- what was cut before ----


def test_earlier_active_operations_have_cut_before_each_with_its_own_tool(square):
    wide = _controller(square, 12.0)
    first = foreign(square, *CUTS, name="First", controller=wide)
    asleep = foreign(square, *CUTS, name="Asleep")
    asleep.Active = False
    op = square.done(square.operation())
    later = foreign(square, *CUTS, name="Later")
    found = job_simulation.read(op)
    assert [diameter for _, diameter in found.earlier] == [12]
    assert ends(found.earlier[0][0]) == ends(job_simulation.read(first).moves)
    assert job_simulation.read(op, after_earlier=False).earlier == []
    assert len(job_simulation.read(later).earlier) == 2


def _controller(square, diameter, shape="endmill"):
    controller = host.cam().controller.Create("TC " + shape)
    square.job.Proxy.addToolController(controller)
    controller.Tool = host.create_tool(shape, {"Diameter": diameter})
    controller.HorizFeed = controller.VertFeed = "100 mm/min"
    return controller


def test_an_earlier_drill_has_cut_and_an_earlier_v_bit_is_left_out_with_a_note(square):
    drilled = "G0 Z15", "G81 X15 Y15 Z-3 R1 F1"
    drill = _controller(square, 9.0, "drill")
    drill.Tool.TipAngle = 90
    foreign(square, *drilled, name="Drilled", controller=drill)
    foreign(square, *CUTS, name="Engraved", controller=_controller(square, 9.0, "v-bit"))
    found = job_simulation.read(square.done(square.operation()))
    # Its point is a cone of 90 degrees, as long as the drill's radius.
    assert [diameter for _, diameter in found.earlier] == [9, 6.75, 4.5, 2.25]
    for path, diameter in found.earlier:
        assert [z - 0.5 * diameter for *_, z in ends(path)] == pytest.approx([15, 1, -3, 15])
    assert [note[:23] for note in found.notes] == ["'Engraved' is left out:"]


def test_a_drill_that_does_not_tell_its_point_has_one_of_118_degrees(square):
    drill = _controller(square, 10.0, "drill")
    drill.Tool.TipAngle = 0
    assert tool.point_length(drill) == pytest.approx(5 / math.tan(math.radians(59)))


def test_a_ball_before_has_cut_as_discs_within_it(square):
    ball = _controller(square, 10.0, "ballend")
    foreign(square, *CUTS, name="Round", controller=ball)
    found = job_simulation.read(square.done(square.operation()))
    assert found.notes == []
    assert [diameter for _, diameter in found.earlier][0] == 10
    tips = ends(job_simulation.earlier.moves_of(square.doc.getObject("Round"))[0])
    for path, diameter in found.earlier:
        # At that height the ball is as wide as the disc.
        above = 5 - math.sqrt(25 - diameter**2 / 4)
        assert [z - above for *_, z in ends(path)] == pytest.approx([z for *_, z in tips])
    assert min(diameter for _, diameter in found.earlier) < 2.5


def test_a_bull_nosed_tool_before_leaves_its_corner(square):
    nosed = _controller(square, 10.0, "bullnose")
    if hasattr(nosed.Tool, "CornerRadius"):  # since FreeCAD 1.1
        nosed.Tool.CornerRadius = 1.0
    else:
        nosed.Tool.FlatRadius = 4.0
    assert tool.corner_radius(nosed) == pytest.approx(1.0)
    foreign(square, *CUTS, name="First", controller=nosed)
    found = job_simulation.read(square.done(square.operation()))
    assert [diameter for _, diameter in found.earlier] == [10, 8]
    lowest = [min(z for *_, z in ends(path)) for path, _ in found.earlier]
    assert lowest == pytest.approx([0, -1])


def test_a_pre_drilled_hole_is_ground_without_material(square):
    op = square.operation(EntryPoint=Vector(15, 14, 0), HoleDiameter=9.0)
    found = job_simulation.read(square.done(op), after_earlier=False)
    ((drilling, diameter),) = found.earlier
    assert diameter == 9
    assert ends(drilling) == [(RAPID, 15, 14, 1), (CUT, 15, 14, -DEPTH)]
    assert drilling[0][7] == 0 and drilling[1][7] == pytest.approx(255)
    op.Entry = "Helix"
    assert job_simulation.read(square.done(op)).earlier == []


def test_a_dressed_operation_is_read_through_its_dressup(square):
    first = square.done(square.operation())
    dressed = host.dressup("Boundary").Create(first)
    square.doc.recompute()
    found = job_simulation.read(dressed)
    assert found.tool.diameter == 6 and found.earlier == []
    assert area_at(found.part, -1) == pytest.approx(STOCK_AREA - 900)
    assert len(found.moves) == len(commands.to_moves(dressed.Path.Commands, 50, 1)[0])
    later = foreign(square, *CUTS, name="Later")
    assert len(job_simulation.read(later).earlier) == 1


# ---- handing over ----


def test_the_simulator_gets_all_of_it_and_its_result_carries_the_notes(square, monkeypatch):
    calls = []

    def simulate(source, stock, top, bottom, tool_diameter, **options):
        calls.append((source, stock, top, bottom, tool_diameter, options))
        return SimpleNamespace(notes=["of the simulator"])

    monkeypatch.setattr(run, "simulate", simulate)
    square.controller.SpindleSpeed = 0
    op = square.done(square.operation())
    watched = []
    result = job_simulation.of(
        op, 0.1, 0.2, material="steel", machine={"name": "m"}, progress=watched.append
    )
    ((source, stock, top, bottom, diameter, options),) = calls
    setup = job_simulation.read(op)
    assert source == setup.moves and options["lines"] == setup.lines
    ((region, height),) = stock
    assert region.area == pytest.approx(STOCK_AREA) and height == 0
    assert (top, bottom, diameter) == (0, -BLOCK, 6)
    assert (options["resolution"], options["step"], options["teeth"]) == (0.1, 0.2, 1)
    assert options["cutting"] == {"rapid_feed": 5000, "material": "steel", "helix_angle_deg": 30}
    assert options["infer_kinds"] is True  # they are 0 and 3 only
    assert options["machine"] == {"name": "m"} and options["progress"] == watched.append
    assert len(options["part"]) == 2 and options["earlier"] == []
    assert result.notes == [*setup.notes, "of the simulator"]


def test_a_tool_knows_its_teeth_and_what_it_does_not_know(square):
    square.controller.Tool = bit = host.create_tool("endmill", {"Diameter": 6.0, "Flutes": 4})
    found = tool.read(square.controller)[0]
    assert (found.teeth, found.helix_angle, list(found.assumed)) == (4, 30, ["helix angle"])
    bit.addProperty("App::PropertyAngle", "HelixAngle")
    bit.HelixAngle, bit.Flutes = 45, 0
    found = tool.read(square.controller)[0]
    assert (found.teeth, found.helix_angle, list(found.assumed)) == (1, 45, ["number of teeth"])
