"""What an operation tells of its cut, for suggestions: read from the document, which is not touched
by that.
"""

import math
from dataclasses import dataclass, field

from evenload import host
from evenload import tool as tools
from evenload.optimisation import inputs
from evenload.stability import operation as stability

CONSTANT = inputs.FEED_CONTROLS[0]
ADAPTIVE = "Adaptive"  # the kind whose paths the optimiser makes


@dataclass
class Cut:
    """mm, degrees, rev/min, mm/min; sentences in `notes`."""

    label: str  # of the operation
    regions: list  # the core's
    depth: float  # of the pocket
    hole: tuple  # (x, y, diameter), or None
    tool: object  # tool.Tool
    chip_load: float  # that the tool bit tells; 0 where it does not
    material: str
    engagement_deg: float
    levels: int
    step_down: float  # of the deepest level
    spindle_speed: float  # 0 where none is set
    feed: float
    options: dict  # of evenload.optimise: what else shapes the path
    modes: object  # dynamics.vibration.Vibration of the tool, or None
    notes: list = field(default_factory=list)

    @property
    def surface_speed(self):
        """m/min of what is set now."""
        return 1e-3 * math.pi * self.tool.diameter * self.spindle_speed

    def state(self):
        """What figures hold for: they are stale once this differs."""
        area = sum(region.area for region in self.regions)
        numbers = (
            *(self.engagement_deg, self.levels, self.step_down, self.spindle_speed, self.feed),
            *(self.depth, self.tool.diameter, area),
            *(value for value in self.options.values() if not isinstance(value, str)),
        )
        words = [value for value in self.options.values() if isinstance(value, str)]
        rounded = ["%.6g" % number for number in numbers]
        return [*rounded, *words, self.hole, self.tool, self.chip_load, self.notes]


def read(operation):
    """The Cut of one of our operations that clears floors, as it is set now: computed or not, its
    panel open or not. Raises ValueError with a sentence for what no path can be computed from.
    """
    task = operation.Proxy.preview(operation)
    set_now, data = task.settings, task.data
    depths = {round(floor.depth, 6) for floor in task.floors}
    if len(depths) > 1:
        raise ValueError(inputs.SEVERAL_DEPTHS % operation.Label)
    top, bottom = set_now.StartDepth.Value, depths.pop() + set_now.StockToLeaveAxial.Value
    levels = [top, *host.cutting_levels(top, set_now.StepDown.Value, bottom)]
    return Cut(
        operation.Label,
        task.regions,
        top - bottom,
        task.hole,
        task.tool,
        tools.chip_load(operation.ToolController),
        set_now.Material,
        set_now.EngagementAngle.Value,
        len(levels) - 1,
        max(above - below for above, below in zip(levels, levels[1:])),
        data.spindle_speed,
        data.feed,
        _options(set_now, task),
        stability.kept(operation.ToolController),
        _notes(operation, task),
    )


def _options(set_now, task):
    """What `evenload.optimise` is told of the path, in its words."""
    feed, diameter = task.data.feed, task.tool.diameter
    control = set_now.FeedControl.lower()
    return {
        "cut_mode": set_now.CutMode.lower(),
        "feed_control": control if control in inputs.FEED_CONTROLS else CONSTANT,
        "maximum_feed": max(1.0, 60 * set_now.MaximumFeed.Value / feed),
        "entry_feed": task.data.plunge_feed / feed,
        "link_feed": 60 * set_now.LinkFeed.Value,
        "roll_radius": set_now.RollRadius.Value / diameter,
    }


def _notes(operation, task):
    notes = []
    if type(operation.Proxy).__name__ != ADAPTIVE:
        notes.append("All figures are those of EvenLoad Adaptive on the same floors.")
    if task.is_rest:
        notes.append("All figures are of whole floors, as if nothing had been cut before.")
    if task.settings.StockToLeave.Value > 0:
        notes.append("All figures are without the stock to leave at the walls.")
    if task.settings.FeedControl.lower() not in inputs.FEED_CONTROLS:
        notes.append("All figures are at a constant feed, for a constant force does not scale.")
    return notes
