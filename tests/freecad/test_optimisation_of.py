"""evenload.optimise on an operation of a job: region, depth and hole are the operation's."""

import evenload
import pytest
from models import DEPTH

pytestmark = pytest.mark.core

TOOL = {
    "diameter": 6,
    "teeth": 1,
    "cutting_length": 12,
    "max_chip_thickness": 0.05,
    "surface_speed": (60, 150),
}


def test_at_the_operation_s_own_feeds_its_time_comes_out(square):
    op = square.done(square.operation(LinkFeed="1500 mm/min"))
    feed = 60 * op.ToolController.HorizFeed.getValueAs("mm/s").Value
    machine = {"max_feed_mm_min": feed, "acceleration_mm_s2": 500, "rapid_feed_mm_min": 5000}
    own = {"engagement_deg": 60, "axial_depths": DEPTH, "link_feed": 1500, "entry_feed": 1.0}
    found = evenload.optimise(op, [TOOL], "Star test piece", machine, **own)
    assert all(c.levels == 1 and c.axial_depth == DEPTH for c in found.candidates)
    assert found.best.bound_by == "machine feed" and found.best.feed == pytest.approx(feed)
    assert found.best.time_s == pytest.approx(op.CuttingTime, rel=0.02)


def test_an_operation_that_was_not_computed_is_refused(square):
    op = square.done(square.operation())
    op.Proxy.last = None
    with pytest.raises(ValueError, match="has not been computed: recompute the document first"):
        evenload.optimise(op, [TOOL], "Star test piece")
