"""What the window Stability chart has computed off its thread."""

from evenload.stability import cut as cuts
from evenload.stability import field


def chart_of(cut, box):
    """The task that generates what the window shows of a Cut, as (what, result), the quickest
    first.

    box: (low, high) of speeds and of depths.
    """
    levels = field.levels(cut, *box)
    yield "field", next(levels)
    radius, _ = cuts.worst_of(cut)
    yield "stable", radius < 1
    for finer in levels:
        yield "field", finer
    yield "verdict", cuts.judged(cut)
