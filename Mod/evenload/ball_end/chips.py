"""The chip that one tooth of a ball-end tool takes."""

import math
from dataclasses import dataclass

import numpy

from evenload import waiting
from evenload.ball_end.surfaces import core, in_core, is_patch

UNCUT = ("right", "left", "strip", "slot")
STEPS = ("plan", "centre", "surface")
# Of a Chip, but for its edge, which is two.
NUMBERS = "volume", "tool_face", "previous_face", "max_thickness", "tip_share", "tool_diameter"


@dataclass(frozen=True)
class Chip:
    """A chip, as numbers; or many, as arrays of one shape.

    volume: V, mm3. tool_face: mm2, on the ball of the tooth that takes it. previous_face: mm2, left
    by the tooth before. mean_thickness: V/previous_face, mm, the source's h_m; mean_thickness_tool:
    V/tool_face. max_thickness: mm, towards the ball's centre. edge: (from, to), degrees from the
    tool's axis between which the edge works. tip_share: of V, 0 to 1, cut where the local diameter
    is below a fifth of the tool's. tool_diameter: mm. Arrays of edges have a last axis of two.
    """

    volume: float
    tool_face: float
    previous_face: float
    max_thickness: float
    edge: tuple
    tip_share: float
    tool_diameter: float

    @property
    def mean_thickness(self):
        return self.volume / self.previous_face

    @property
    def mean_thickness_tool(self):
        return self.volume / self.tool_face

    @property
    def local_diameters(self):
        """(least, largest) diameter in mm at which the edge works; arrays as `edge`."""
        found = numpy.sin(numpy.radians(self.edge)) * numpy.asarray(self.tool_diameter)[..., None]
        return tuple(found.tolist()) if found.ndim == 1 else found

    def cutting_speeds(self, spindle_speed):
        """(least, largest) cutting speed in m/min of the edge that works, at rev/min."""
        found = math.pi * spindle_speed / 1000 * numpy.asarray(self.local_diameters)
        return tuple(found.tolist()) if found.ndim == 1 else found


def chip(
    surface,
    tool_diameter,
    feed_per_tooth,
    stepover,
    axial_depth,
    feed_direction,
    position=0,
    uncut="right",
    steps="plan",
):
    """The Chip at one place of a path.

    surface: ("plane",); ("cylinder", radius) along x, radius in mm > 0 convex, < 0 concave;
    ("test part", "CX" | "CV"), the source's dome or trough; ("patch", first, second, slope,
    towards): any place of a face, with its principal curvatures in 1/mm, > 0 convex, its slope
    against the tool's axis and the direction in which it leans, degrees from the first principal
    direction, both 0 if left out. tool_diameter, feed_per_tooth, stepover: mm. axial_depth: the
    stock's allowance along the normal, mm, below the ball's radius. feed_direction: degrees from x,
    on a patch from the first principal direction. position: the tool's ordinate y in plan, mm from
    the surface's middle. uncut: where material stands beside the feed, "right" or "left" of an
    earlier pass that lies a stepover away; "strip", between two; "slot", on both sides. steps: what
    feed and stepover are measured on: "plan", the "centre"'s surface or the part's "surface"; a
    patch knows no plan. Raises ValueError, in a sentence, for what cannot be. [Varga 2023, ch. 4].
    """
    found = chips(
        [surface],
        tool_diameter,
        feed_per_tooth,
        stepover,
        axial_depth,
        feed_direction,
        position,
        [uncut],
        steps,
        threads=1,
    )
    if found.volume.shape != (1,):
        raise ValueError("One chip takes one number for each argument: chips() takes arrays.")
    one = {name: getattr(found, name)[0].item() for name in NUMBERS}
    return Chip(edge=tuple(found.edge[0].tolist()), **one)


def chips(
    surface,
    tool_diameter,
    feed_per_tooth,
    stepover,
    axial_depth,
    feed_direction,
    position=0,
    uncut="right",
    steps="plan",
    threads=0,
):
    """A Chip of arrays: chip() for arguments that are numbers, or arrays that broadcast.

    surface: one for all, or a list of them; uncut: likewise; steps: one for all. threads: 0: as
    many as there are cores; the numbers are the same on any. Asks waiting.go_on with the share done
    and raises waiting.Stopped where it shall not go on.
    """
    if steps not in STEPS:
        raise ValueError("steps are measured in plan, centre or surface, not %s." % (steps,))
    surfaces, numbers = _numbered(surface)
    sides = _sides(uncut)
    try:
        columns = numpy.broadcast_arrays(
            numbers,
            numpy.asarray(position, dtype=float),
            0.5 * numpy.asarray(tool_diameter, dtype=float),
            *(
                numpy.asarray(given, dtype=float)
                for given in (feed_per_tooth, stepover, axial_depth)
            ),
            numpy.radians(numpy.asarray(feed_direction, dtype=float)),
            sides,
        )
    except (TypeError, ValueError):
        raise ValueError(
            "The arguments of chips are numbers, or arrays whose shapes broadcast."
        ) from None
    shape = columns[0].shape
    patches = numpy.array([is_patch(each) for each in surfaces], dtype=bool)
    if numpy.any(patches[columns[0].astype(int)] & (columns[1] != 0)):
        raise ValueError("A patch is one place: its position is 0.")
    rows = numpy.stack([column.ravel() for column in columns], axis=-1)
    found = core().chips(
        [in_core(each) for each in surfaces], STEPS.index(steps), rows, threads, waiting.answer
    )
    volume, tool_face, previous_face, thickness, start, end, tip = (
        column.reshape(shape) for column in found.T
    )
    return Chip(
        volume=volume,
        tool_face=tool_face,
        previous_face=previous_face,
        max_thickness=thickness,
        edge=numpy.degrees(numpy.stack([start, end], axis=-1)),
        tip_share=tip,
        tool_diameter=2 * columns[2],
    )


def _numbered(surface):
    """([distinct surfaces], array of their numbers)"""
    if not isinstance(surface, (list, numpy.ndarray)):
        in_core(surface)
        return [surface], numpy.array(0.0)
    distinct, numbers = {}, []
    for each in surface:
        in_core(each)
        numbers.append(distinct.setdefault(tuple(each), len(distinct)))
    return list(distinct), numpy.array(numbers, dtype=float)


def _sides(uncut):
    words = numpy.asarray(uncut)
    if not numpy.isin(words, UNCUT).all():
        other = words[~numpy.isin(words, UNCUT)].flat[0]
        raise ValueError("uncut is right, left, strip or slot, not %s." % other)
    return sum(i * (words == word) for i, word in enumerate(UNCUT)).astype(float)
