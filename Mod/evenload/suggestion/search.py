"""What is set now and what is suggested, by the same figures. Needs no FreeCAD."""

import math
from dataclasses import dataclass

from evenload import machines
from evenload.optimisation import inputs, optimise

ANGLES = (30.0, 45.0, 60.0, 75.0, 90.0)  # degrees to try at first, as `evenload.optimise` has them


@dataclass
class Asked:
    """What a suggestion has to keep; mm, m/min, N, N m, W, None: without limit."""

    max_chip_thickness: float
    least_speed: float
    most_speed: float
    cutting_length: float
    teeth: int
    material: object  # as materials.load takes it
    machine: object  # as machines.load, or None
    max_force: float = None
    max_torque: float = None
    max_power: float = None
    angles: tuple = ANGLES
    levels: int = inputs.LEVELS  # how many numbers of levels are tried, from the fewest possible
    keeps_angle: bool = False
    keeps_depth: bool = False


def now(cut, asked, progress=None):
    """The Candidate of what is set now, whether it keeps the limits or not; None without a spindle
    speed, and where it was cancelled.
    """
    if not cut.spindle_speed > 0:
        return None
    tool = _tool(cut, asked)
    tool["surface_speed"] = cut.surface_speed
    tool["cutting_length"] = max(tool["cutting_length"], cut.step_down)
    tool["max_chip_thickness"] = cut.feed / (cut.spindle_speed * asked.teeth)
    found = optimise(
        cut.regions,
        [tool],
        asked.material,
        _without_spindle(asked.machine),
        depth=_of_deepest(cut),
        engagement_deg=cut.engagement_deg,
        axial_depths=cut.step_down,
        spindle_speeds=cut.spindle_speed,
        feed=cut.feed,
        hole=cut.hole,
        progress=progress,
        **cut.options,
    )
    for candidate in found.candidates:
        candidate.bound_by = ""  # no limit has made its feed
    return next(iter(found.candidates), None)


def suggested(cut, asked, progress=None):
    """The Optimisation of a Cut. Raises ValueError with a sentence for what cannot be used."""
    return optimise(
        cut.regions,
        [_tool(cut, asked)],
        asked.material,
        asked.machine,
        depth=_of_deepest(cut) if asked.keeps_depth else cut.depth,
        engagement_deg=cut.engagement_deg if asked.keeps_angle else asked.angles,
        axial_depths=cut.step_down if asked.keeps_depth else _depths(cut, asked),
        spindle_speeds=_speeds(cut, asked),
        max_force=asked.max_force,
        max_torque=asked.max_torque,
        max_power=asked.max_power,
        hole=cut.hole,
        modes=cut.modes,
        progress=progress,
        **cut.options,
    )


def feed_of(candidate):
    """mm/min of a Candidate as it is set: whole ones, rounded down, where that is within 1 %."""
    feed = candidate.feed
    return float(math.floor(feed * (1 + inputs.SAME))) if feed >= 100 else feed


def _tool(cut, asked):
    return {
        "name": cut.tool.name,
        "diameter": cut.tool.diameter,
        "teeth": asked.teeth,
        "helix_angle_deg": cut.tool.helix_angle,
        "cutting_length": asked.cutting_length,
        "max_chip_thickness": asked.max_chip_thickness,
        "surface_speed": (asked.least_speed, asked.most_speed),
    }


def _of_deepest(cut):
    """mm: the depth where all levels of a Cut were as deep as its deepest, whose load counts."""
    return cut.levels * cut.step_down


def _depths(cut, asked):
    """mm of the levels to try, the deepest first."""
    fewest = max(1, math.ceil(cut.depth / asked.cutting_length - inputs.SAME))
    return [cut.depth / number for number in range(fewest, fewest + asked.levels)]


def _speeds(cut, asked):
    """Whole rev/min over what tool and machine can do; None where these have nothing in common,
    which the optimiser tells.
    """
    per_surface = 1e3 / (math.pi * cut.tool.diameter)
    low, high = asked.least_speed * per_surface, asked.most_speed * per_surface
    if asked.machine is not None:
        least, most = machines.spindle(asked.machine)["speeds"]
        low, high = max(low, least), min(high, most)
    low, high = math.ceil(low * (1 - inputs.SAME)), math.floor(high * (1 + inputs.SAME))
    if low > high:
        return None
    count = inputs.SPEEDS - 1
    return sorted({round(low + (high - low) * k / count) for k in range(count + 1)})


def _without_spindle(machine):
    """A machine's profile without what its spindle can do: what is set now is judged anyhow."""
    if machine is None:
        return None
    profile = machines.profile(machine)
    return {key: value for key, value in profile.items() if not key.startswith("spindle_")}
