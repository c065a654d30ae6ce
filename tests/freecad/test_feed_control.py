"""Feed control: each choice holds what its name says, as the simulator sees it."""

import math
import re

import evenload
import numpy
import pytest
from evenload import compiled, host, materials
from models import case_model, corpus_case

FEED, SPEED, RADIUS, THETA, DEPTH = 255.0, 6366.0, 3.0, 60.0, 3.0
pytestmark = pytest.mark.core

CUT = 3  # kind of a simulated move
FINE = 0.02  # mm between dexels: at 0.05 short arcs are seen a tenth too long here and there
STAR = "Star test piece"  # a material whose force is all the chip's, none the edges'
CONTROLS = (
    "Constant feed",
    "Constant removal rate",
    "Constant chip thickness",
    "Constant force",
)


@pytest.fixture
def cleared(bench):
    """Clears two rooms with a passage: passes often roll in and out; flutes: of the tool."""

    def clear(flutes=1, **properties):
        b = bench(case_model(corpus_case("two_rooms")), flutes=flutes)
        op = b.operation(MaximumFeed="1000 mm/min", LinkFeed="1500 mm/min", **properties)
        return b, b.done(op)

    return clear


def straight_force(material, conventional=False, teeth=1, depth=DEPTH, helix=30.0, feed=FEED):
    """The largest force in N of a straight cut at the engagement angle and the nominal feed."""
    core = compiled.core()
    row = materials.load(material)
    coefficients = core.ForceCoefficients(*(row[key] for key in ("ktc", "krc", "kte", "kre")))
    model = core.ForceModel(coefficients, RADIUS, teeth, math.radians(helix))
    arc = (-math.pi / 2, math.radians(THETA) - math.pi / 2)
    if conventional:
        arc = (-arc[1], -arc[0])
    return model.force([(*arc, depth)], feed / (teeth * SPEED), SPEED).peak_xy


def largest(run, values):
    """The largest mean over 0.1 mm of path of what cuts have: the output's grid turns moves of a
    hundredth of a millimetre by degrees, and from tooth to tooth the tool goes further than that.
    """
    cuts = run.kind == CUT
    values = numpy.where(cuts, values, 0.0)
    mean = 0.5 * (values + numpy.concatenate(([0.0], values[:-1])))
    area, along = numpy.cumsum(run.length * mean), numpy.cumsum(run.length)
    return ((area - numpy.interp(along - 0.1, along, area)) / 0.1).max()


def feeds_of(op):
    """Feeds in mm/min of all moves but rapids."""
    return {
        round(60 * c.Parameters["F"], 6) for c in op.Path.Commands if c.Name in ("G1", "G2", "G3")
    }


# ---- what is held ----


@pytest.mark.parametrize("mode", ["Climb", "Conventional"])
def test_no_chip_is_thicker_than_in_the_straight_cut(cleared, mode):
    _, op = cleared(FeedControl="Constant chip thickness", CutMode=mode)
    run = evenload.simulation.of(op, resolution=FINE)
    nominal = FEED / SPEED * math.sin(math.radians(THETA))
    assert largest(run, run.h_max) < 1.01 * nominal
    assert max(feeds_of(op) - {1500.0}) > 3 * FEED and "thick" not in op.Report


@pytest.mark.parametrize("mode", ["Climb", "Conventional"])
@pytest.mark.parametrize("material, flutes", [(STAR, 1), ("Al6061-T6", 3)])
def test_no_force_is_above_the_straight_cuts(cleared, mode, material, flutes):
    _, op = cleared(flutes, FeedControl="Constant force", Material=material, CutMode=mode)
    run = evenload.simulation.of(op, resolution=FINE, material=material)
    nominal = straight_force(material, mode == "Conventional", flutes)
    cuts = run.kind == CUT
    assert largest(run, run.force_peak) < 1.02 * nominal
    assert max(feeds_of(op) - {1500.0}) > 1.5 * FEED
    # It is held there, not merely never reached.
    engaged = cuts & (run.engagement_deg > 20) & (run.feed < 999)
    assert numpy.average(run.force_peak[engaged], weights=run.length[engaged]) > 0.85 * nominal


def test_the_force_is_held_at_every_depth_of_cut(cleared):
    _, op = cleared(FeedControl="Constant force", StepDown=1.9)
    run = evenload.simulation.of(op, resolution=FINE, material=STAR)
    for depth in (1.9, 1.1):
        level = (run.kind == CUT) & (abs(run.axial_depth - depth) < 0.01)
        assert level.any()
        peak = largest(run, numpy.where(level, run.force_peak, 0.0))
        assert peak < 1.02 * straight_force(STAR, depth=depth)


def test_more_is_held_in_more_time_than_the_removal_rate_alone(cleared):
    times = {control: cleared(FeedControl=control)[1].CuttingTime for control in CONTROLS}
    for control in CONTROLS[2:]:
        assert times["Constant removal rate"] < times[control] < times["Constant feed"]


@pytest.mark.parametrize("control", CONTROLS[1:])
def test_every_control_is_capped_by_the_maximum_feed(cleared, control):
    _, op = cleared(FeedControl=control)
    assert max(feeds_of(op) - {1500.0}) <= 1000 + 1e-6
    op.MaximumFeed = "%g mm/min" % FEED
    op.Document.recompute()
    assert max(feeds_of(op) - {1500.0}) <= FEED + 1e-6


def test_a_least_load_is_held_below_the_maximum_feed_at_the_cost_of_blocks(cleared):
    """But for the last tenth of a millimetre of tight turns, which cannot be divided."""
    shares, blocks, times = [], [], []
    for least in (0.0, 0.9):
        _, op = cleared(FeedControl="Constant removal rate", LeastLoad=least)
        run = evenload.simulation.of(op, resolution=FINE)
        nominal = FEED * RADIUS * (1 - math.cos(math.radians(THETA))) * DEPTH
        slow = (run.kind == CUT) & (run.feed < 999) & (run.length > 0)
        slow &= numpy.roll(slow, 1)
        rate = 0.5 * (run.removal_rate + numpy.roll(run.removal_rate, 1)) / nominal
        shares.append(run.length[slow & (rate >= 0.85)].sum() / run.length[slow].sum())
        blocks.append(len(op.Path.Commands))
        times.append(op.CuttingTime)
    assert shares[0] < 0.97 < 0.99 < shares[1]
    assert blocks[0] < blocks[1] and times[1] < times[0]


# ---- what the report says ----


def test_the_report_says_how_thick_chips_get_at_a_constant_removal_rate(cleared):
    _, op = cleared(FeedControl="Constant removal rate")
    said = re.search(
        r"Chips get up to ([\d.]+) times .* near \((-?[\d.]+), (-?[\d.]+)\)", op.Report
    )
    run = evenload.simulation.of(op, resolution=FINE)
    cuts = run.kind == CUT
    nominal = FEED / SPEED * math.sin(math.radians(THETA))
    assert float(said.group(1)) == pytest.approx(numpy.nanmax(run.h_max[cuts]) / nominal, rel=0.02)
    place = numpy.array([float(said.group(2)), float(said.group(3))])
    near = cuts & (numpy.hypot(run.x - place[0], run.y - place[1]) < 0.2)
    assert run.h_max[near].max() > 0.95 * float(said.group(1)) * nominal
    op.FeedControl = "Constant feed"
    op.Document.recompute()
    assert "Chips" not in op.Report


def test_a_force_that_no_feed_holds_is_reported_and_cut_slowly(cleared):
    # At a small angle the edges alone exceed the nominal force where more is met.
    _, op = cleared(2, FeedControl="Constant force", Material="Al6061-T6", EngagementAngle=20)
    assert "No feed down to a tenth of the nominal keeps the force" in op.Report
    assert min(feeds_of(op)) > 0.099 * FEED


# ---- the tool ----


def test_what_the_tool_bit_does_not_say_is_assumed_and_reported(cleared):
    b, op = cleared(2, FeedControl="Constant force")
    name = b.controller.Tool.Label
    sentence = "The tool '%s' does not say its helix angle: the force is that of a helix of 30"
    assert sentence % name in op.Report
    b.controller.Tool.Flutes = 0
    b.done(op)
    sentence = "'%s' does not say its number of teeth and its helix angle: the force is that of 1 "
    assert sentence % name in op.Report
    op.FeedControl = "Constant chip thickness"
    assert "does not say" not in b.done(op).Report


def test_the_helix_of_the_tool_bit_is_taken_by_operation_and_simulation(cleared):
    b, op = cleared(2, FeedControl="Constant force", Material=STAR)
    time = op.CuttingTime
    tool = b.controller.Tool
    tool.addProperty("App::PropertyAngle", "HelixAngle")
    tool.HelixAngle = 55
    b.done(op)
    assert "does not say" not in op.Report and op.CuttingTime != pytest.approx(time, rel=1e-4)
    run = evenload.simulation.of(op, resolution=FINE, material=STAR)
    assert largest(run, run.force_peak) < 1.02 * straight_force(STAR, teeth=2, helix=55)
    tool.HelixAngle = 95
    assert "helix angle" in b.refused(op)


def test_a_bull_nosed_tool_has_teeth_as_well(cleared):
    b, op = cleared(FeedControl="Constant force")
    b.controller.Tool = host.create_tool("bullnose", {"Diameter": 6.0, "Flutes": 2})
    assert "number of teeth" not in b.done(op).Report


def test_a_constant_force_needs_the_spindles_speed(cleared):
    b, op = cleared(FeedControl="Constant force")
    b.controller.SpindleSpeed = 0
    assert "needs the spindle's speed" in b.refused(op)
    op.FeedControl = "Constant chip thickness"
    b.done(op)


def test_the_material_counts_for_a_constant_force_only(cleared):
    b, op = cleared(FeedControl="Constant chip thickness")
    program = [c.toGCode() for c in op.Path.Commands]
    op.Material = "Al6061-T6"
    assert [c.toGCode() for c in b.done(op).Path.Commands] == program
    op.FeedControl = "Constant force"
    soft = b.done(op).CuttingTime
    op.Material = STAR
    assert b.done(op).CuttingTime != pytest.approx(soft, rel=2e-4)
