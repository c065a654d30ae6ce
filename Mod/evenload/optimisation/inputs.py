"""What `evenload.optimise` takes, checked and completed: tools, depths, speeds, limits. Needs no
FreeCAD.
"""

import math
import os
from dataclasses import dataclass, field

from evenload import machines, materials, simulation
from evenload.optimisation import chatter

LEVELS, SPEEDS = 4, 5  # that are tried where none are given
LEAST_CHIP = 0.2  # of the largest chip thickness: thinner chips rub more than they cut
FEED_CONTROLS = (  # those that scale with the feed
    "constant feed",
    "constant removal rate",
    "constant chip thickness",
)
SEVERAL_DEPTHS = (
    "The floors of '%s' lie at several depths: make an operation for each depth, and optimise one "
    "by one."
)
SAME = 1e-6  # share by which lengths and speeds may pass their limits: rounding
TOOL_KEYS = {
    "diameter": "mm",
    "teeth": "",
    "cutting_length": "mm",
    "max_chip_thickness": "mm",
    "min_chip_thickness": "mm",
    "surface_speed": "m/min, one or (least, largest)",
    "helix_angle_deg": "degrees",
    "modes": "",
    "name": "",
}
NEEDED = ("diameter", "teeth", "cutting_length", "max_chip_thickness", "surface_speed")


@dataclass
class Tool:
    """One tool to try, with its material's coefficients; mm, m/min, rev/min."""

    name: str
    diameter: float
    teeth: int
    cutting_length: float
    max_chip_thickness: float
    min_chip_thickness: float
    surface_speed: tuple
    helix_angle_deg: float
    material: dict
    modes: list = None  # of vibration at its tip; None: chatter is not looked at
    levels: list = field(default_factory=list)
    speeds: list = field(default_factory=list)
    spindle: tuple = (0.0, math.inf)  # rev/min that tool and machine allow

    @property
    def reference_feed(self):
        """mm/min: a feed of the tool's own size, at which its path is computed."""
        allowed = [s for s in self.speeds if not self.refusal(0.0, s)[0]]
        return self.max_chip_thickness * self.teeth * max(allowed)

    def refusal(self, height, speed):
        """(which limit, sentence) against a depth or a spindle speed; ("", "") for none."""
        if height > self.cutting_length * (1 + SAME):
            return "cutting length", "%.3g mm is deeper than the cutting length of %s, %g mm." % (
                height,
                self.name,
                self.cutting_length,
            )
        least, largest = self.spindle
        if not least * (1 - SAME) <= speed <= largest * (1 + SAME):
            return "spindle speed", "%.5g rev/min is outside of %s, %.5g to %.5g rev/min." % (
                speed,
                "what %s and the machine can do" % self.name,
                least,
                largest,
            )
        return "", ""


@dataclass
class Task:
    """The checked inputs; limits that are not given are infinite."""

    core: object
    regions: list
    tools: list
    depth: float
    engagement_deg: list
    hole: tuple
    max_force: float
    max_torque: float
    max_power: float
    max_left_area: float
    max_feed: float  # mm/min, of cuts
    profile: object  # the core's MachineProfile, or None
    cut_mode: str
    feed_control: str
    maximum_feed: float
    entry_feed: float
    link_feed: float
    rapid_feed: float
    roll_radius: float
    resolution: float
    workers: int
    stability_margin: float
    feed: float  # mm/min, of all candidates; None: the largest within the limits
    notes: list

    def entry(self, diameter):
        """Arguments of the core for the descent: the hole where the tool fits into it."""
        if not self.hole or self.hole[2] < diameter:
            return {}
        return {"entry_point": self.hole[:2], "hole_diameter": self.hole[2]}


def checked(
    core, *, region, tools, materials, machine, depth, axial_depths, spindle_speeds, **rest
):
    """The Task for the arguments of `optimise`. Raises ValueError with a sentence."""
    rest.pop("progress")
    limits = {k: _limit(rest.pop(k), k) for k in tuple(rest) if k.startswith("max_")}
    regions, known_depth, known_hole = _regions(core, region)
    listed = _tools(tools, materials, rest.pop("modes"))
    chatter.check_margin(rest["stability_margin"])
    notes = []
    if depth is None:
        depth = known_depth
    if depth is None:
        depth = min(tool.cutting_length for tool in listed)
        notes.append("The pocket was taken as %g mm deep, the shortest cutting length." % depth)
    _positive(depth, "depth")
    angles = _numbers(rest.pop("engagement_deg"), "engagement_deg")
    if max(angles) >= 180:
        raise ValueError("engagement_deg must be below 180, not %g." % max(angles))
    hole = _hole(rest.pop("hole") or known_hole)
    if rest["feed"] is not None:
        _positive(rest["feed"], "feed")
    for name in ("maximum_feed", "entry_feed", "roll_radius", "resolution"):
        _positive(rest[name], name)
    if rest["maximum_feed"] < 1:
        raise ValueError(
            "maximum_feed is a share of the feed: 1 or more, not %g." % rest["maximum_feed"]
        )
    if rest["feed_control"] not in FEED_CONTROLS:
        raise ValueError(
            "feed_control must be one of %s, whose feeds scale, not %r."
            % (", ".join("'%s'" % name for name in FEED_CONTROLS), rest["feed_control"])
        )
    max_feed, rapid_feed, profile = math.inf, simulation.RAPID_FEED, None
    spindle = {"speeds": (0.0, math.inf), "power": math.inf, "torque": math.inf}
    if machine is not None:
        loaded = machines.load(machine)
        spindle = machines.spindle(machine)
        max_feed, rapid_feed = min(loaded["max_feed"][:2]), loaded["rapid_feed"]
        profile = core.MachineProfile(**loaded)
    limits["max_power"] = min(limits["max_power"], spindle["power"])
    limits["max_torque"] = min(limits["max_torque"], spindle["torque"])
    link_feed = rest.pop("link_feed")
    link_feed = rapid_feed if link_feed is None else link_feed
    _positive(link_feed, "link_feed")
    for tool in listed:
        _complete(tool, depth, axial_depths, spindle_speeds, spindle["speeds"])
    workers = rest.pop("workers")
    if workers is None:
        workers = (
            len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
        )
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise ValueError("workers must be a whole number of 1 or more, not %r." % (workers,))
    return Task(
        core,
        regions,
        listed,
        float(depth),
        angles,
        hole,
        max_feed=max_feed,
        profile=profile,
        link_feed=float(link_feed),
        rapid_feed=rapid_feed,
        workers=workers,
        notes=notes,
        **limits,
        **rest,
    )


def _complete(tool, depth, axial_depths, spindle_speeds, of_machine):
    """Sets the tool's levels, its speeds and the range that both it and the machine allow."""
    if axial_depths is None:
        fewest = max(1, math.ceil(depth / tool.cutting_length - SAME))
        tool.levels = list(range(fewest, fewest + LEVELS))
    else:
        deepest = _numbers(axial_depths, "axial_depths")
        tool.levels = list(dict.fromkeys(max(1, math.ceil(depth / a - SAME)) for a in deepest))
    per_surface = 1e3 / (math.pi * tool.diameter)
    least, largest = (v * per_surface for v in tool.surface_speed)
    tool.spindle = max(least, of_machine[0]), min(largest, of_machine[1])
    if spindle_speeds is not None:
        tool.speeds = _numbers(spindle_speeds, "spindle_speeds")
        return
    low, high = tool.spindle
    if low > high:  # each speed will be refused, with the range
        low, high = least, largest
    if high - low <= SAME * high:
        tool.speeds = [high]
    else:
        tool.speeds = [low + (high - low) * k / (SPEEDS - 1) for k in range(SPEEDS)]


def _regions(core, region):
    """(regions, depth or None, hole or None)."""
    if hasattr(region, "Proxy"):
        last = getattr(region.Proxy, "last", None)
        if last is None:
            raise ValueError(
                "The operation '%s' has not been computed: recompute the document first."
                % getattr(region, "Label", region)
            )
        if len(last.cuts) > 1:
            raise ValueError(SEVERAL_DEPTHS % getattr(region, "Label", region))
        depth = region.StartDepth.Value - region.FinalDepth.Value
        depth -= getattr(getattr(region, "StockToLeaveAxial", None), "Value", 0.0)
        return list(last.regions), depth, last.hole
    prisms = simulation.prisms_of(core, region, 0.0, "The region")
    if any(top for _, top in prisms):
        raise ValueError("The region has a height: give it without, and its depth as 'depth'.")
    return [shape for shape, _ in prisms], None, None


def _tools(tools, given, modes):
    if not isinstance(tools, (list, tuple)) or not tools:
        raise ValueError("tools must be a list of at least one tool, not %r." % (tools,))
    rows = list(given) if isinstance(given, (list, tuple)) else [given] * len(tools)
    if len(rows) != len(tools):
        raise ValueError(
            "There are %d materials for %d tools: give one for all, or one for each."
            % (len(rows), len(tools))
        )
    return [
        _tool(tool, n, materials.load(row), modes)
        for n, (tool, row) in enumerate(zip(tools, rows), 1)
    ]


def _tool(tool, number, material, modes):
    if not isinstance(tool, dict):
        raise ValueError("Tool %d is %r: give a dictionary." % (number, tool))
    unknown = [key for key in tool if key not in TOOL_KEYS]
    if unknown:
        raise ValueError(
            "Tool %d has the unknown key '%s': its keys are %s."
            % (number, unknown[0], ", ".join(TOOL_KEYS))
        )
    for key in NEEDED:
        if key not in tool:
            unit = TOOL_KEYS[key] and ", in " + TOOL_KEYS[key]
            raise ValueError("Tool %d has no %s: give it one%s." % (number, key, unit))
    name = "%s of tool %d"
    for key in ("diameter", "cutting_length", "max_chip_thickness"):
        _positive(tool[key], name % (key, number))
    teeth = tool["teeth"]
    if isinstance(teeth, bool) or not isinstance(teeth, int) or teeth < 1:
        raise ValueError(
            "teeth of tool %d must be a whole number above 0, not %r." % (number, teeth)
        )
    surface = tool["surface_speed"]
    surface = (surface, surface) if materials.number(surface) else surface
    if (
        not isinstance(surface, (list, tuple))
        or len(surface) != 2
        or not all(materials.number(v) for v in surface)
        or not 0 < surface[0] <= surface[1]
    ):
        raise ValueError(
            "surface_speed of tool %d must be m/min above 0, one or (least, largest), not %r."
            % (number, tool["surface_speed"])
        )
    least = tool.get("min_chip_thickness", LEAST_CHIP * tool["max_chip_thickness"])
    _positive(least, name % ("min_chip_thickness", number))
    if least > tool["max_chip_thickness"]:
        raise ValueError("min_chip_thickness of tool %d is above its max_chip_thickness." % number)
    helix = tool.get("helix_angle_deg", simulation.HELIX_ANGLE_DEG)
    if not materials.number(helix) or not 0 <= helix < 90:
        raise ValueError(
            "helix_angle_deg of tool %d must be 0 or more and below 90, not %r." % (number, helix)
        )
    return Tool(
        name=str(tool.get("name") or "%g mm, z %d" % (tool["diameter"], teeth)),
        diameter=float(tool["diameter"]),
        teeth=teeth,
        cutting_length=float(tool["cutting_length"]),
        max_chip_thickness=float(tool["max_chip_thickness"]),
        min_chip_thickness=float(least),
        surface_speed=tuple(float(v) for v in surface),
        helix_angle_deg=float(helix),
        material=material,
        modes=chatter.modes_of(tool.get("modes", modes), "tool %d" % number),
    )


def _hole(hole):
    if hole is None:
        return None
    if (
        not isinstance(hole, (list, tuple))
        or len(hole) != 3
        or not all(materials.number(v) for v in hole)
        or not hole[2] > 0
    ):
        raise ValueError("hole must be (x, y, diameter) in mm, not %r." % (hole,))
    return tuple(float(v) for v in hole)


def _numbers(values, name):
    values = [values] if materials.number(values) else values
    try:
        values = list(values)
    except TypeError:
        raise ValueError("%s must be a list of numbers, not %r." % (name, values)) from None
    if not values:
        raise ValueError("%s is empty: give at least one number." % name)
    for value in values:
        _positive(value, name)
    return [float(value) for value in values]


def _positive(value, name):
    if not materials.number(value) or not value > 0:
        raise ValueError("%s must be a number above 0, not %r." % (name, value))


def _limit(value, name):
    if value is None:
        return math.inf
    _positive(value, name)
    return float(value)
