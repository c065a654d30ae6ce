"""What a ball-end tool works: the words for it, and the core's surfaces."""

import math

from evenload import compiled

NATURES = ("CV", "CX")
WORDS = (
    'A surface is ("plane",), ("cylinder", radius), radius > 0 convex and < 0 concave, '
    '("test part", "CX" or "CV"), or ("patch", curvature, curvature, slope, towards).'
)


def core():
    """The compiled part, in mm and rad."""
    return compiled.core().ball_end


def in_core(surface):
    """The core's surface of a tuple as in chip(); raises ValueError for others."""
    try:
        kind, *numbers = surface
    except TypeError:
        raise ValueError(WORDS) from None
    if kind == "plane" and not numbers:
        return core().plane_profile()
    if kind == "cylinder" and len(numbers) == 1:
        radius = _number(numbers[0])
        if not (math.isfinite(radius) and radius != 0):
            raise ValueError("The radius of a cylinder must be above 0 mm, or below it: concave.")
        return core().cylinder_profile(radius)
    if kind == "test part" and len(numbers) == 1 and numbers[0] in NATURES:
        return core().test_part_profile(numbers[0] == "CX")
    if kind == "patch" and 2 <= len(numbers) <= 4:
        first, second, slope, towards = (*map(_number, numbers), 0.0, 0.0)[:4]
        return core().BentPlace(first, second, math.radians(slope), math.radians(towards))
    raise ValueError(WORDS)


def is_patch(surface):
    return surface[0] == "patch"


def _number(given):
    try:
        return float(given)
    except (TypeError, ValueError):
        raise ValueError(WORDS) from None
