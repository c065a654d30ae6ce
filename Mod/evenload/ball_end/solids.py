"""The chip of a ball-end tool as a solid of OpenCASCADE's: the source's own way, as a judge of
ball_end.chip.

Needs FreeCAD's Part. The chip is the tool's ball, less the ball of the tooth before, less what the
ball swept along earlier passes, cut with the stock. All is modelled at 1000 : 1, since the kernel's
tolerances do not shrink with the chip [Varga 2023, 4.1].
"""

import functools
import math
from dataclasses import dataclass

import numpy
import Part
from FreeCAD import Vector

from evenload.ball_end.chips import UNCUT
from evenload.ball_end.solid_models import SAME, SCALE, Place
from evenload.ball_end.solid_processes import answers
from evenload.ball_end.solid_surfaces import Ball

MESH = 0.032  # of the mean thickness: how far the mesh that judges the volume may be off
# By which both volumes may differ: less than the 0.3 % to which the model is judged, and more than
# what MESH leaves of the mesh's own error.
VOLUMES = 1.5e-3


@dataclass(frozen=True)
class SolidChip:
    """volume: mm3; tool_face, previous_face: mm2; max_thickness: mm, towards the ball's centre, as
    those of a Chip; flagged: why they are not to be trusted, a sentence, or "" where they are. All
    figures are not numbers where it is flagged.
    """

    volume: float = math.nan
    tool_face: float = math.nan
    previous_face: float = math.nan
    max_thickness: float = math.nan
    flagged: str = ""

    @property
    def mean_thickness(self):
        return self.volume / self.previous_face

    @property
    def mean_thickness_tool(self):
        return self.volume / self.tool_face


class Flagged(Exception):
    """What OpenCASCADE made is no chip; says why."""


def chip(
    surface,
    tool_diameter,
    feed_per_tooth,
    stepover,
    axial_depth,
    feed_direction,
    position=0,
    uncut="right",
):
    """The SolidChip of ball_end.chip's arguments: steps are measured in plan, and there are no
    patches. Raises ValueError, in a sentence, for what cannot be.
    """
    if uncut not in UNCUT:
        raise ValueError("uncut is right, left, strip or slot, not %s." % (uncut,))
    if not (feed_per_tooth > 0 and stepover > 0 and 0 < axial_depth < tool_diameter / 2):
        raise ValueError("Feed, stepover and depth are above 0, the depth below the ball's radius.")
    place = Place(surface, tool_diameter / 2, axial_depth, feed_direction, position)
    sides = {"right": [1], "left": [-1], "strip": [1, -1], "slot": []}[uncut]
    lefts = [SCALE * stepover * side for side in sides]
    before = place.centre(-SCALE * feed_per_tooth, 0)
    surfaces = place.surfaces(before, lefts)
    whys = []
    for make in _recipes(place, before, [place.way(left) for left in lefts]):
        try:
            return _measured(make(), surfaces)
        except (Flagged, Part.OCCError, RuntimeError) as why:
            whys.append(str(why))
    return SolidChip(flagged=whys[0])


def chips(cases, progress=None, processes=0):
    """[SolidChip, ...] of cases, dicts with chip()'s arguments, in their order: made by as many
    FreeCADs without a window as there are cores, or `processes`.

    progress(share done, 0 to 1) -> whether to go on; left out: as waiting.go_on. Raises
    waiting.Stopped where it shall not, and ValueError as chip().
    """
    return [SolidChip(**answer) for answer in answers(cases, progress, processes)]


def _recipes(place, before, ways):
    """Functions that make the chip: where OpenCASCADE's booleans fail in one way another may do.

    They are quick and seldom fail with splines in place of cylinders, whose intersections with
    balls that nearly touch them are told by formulas, and without joints in the stock. The quickest
    begins with the two balls, whose own intersection is a circle by a formula.
    """
    across = place.normal.cross(before)
    passes = [place.swept(way) for way in ways]
    exact = [place.stock(is_spline=False), *passes]
    splines = [place.stock(is_spline=True), *(each.toNurbs() for each in passes)]

    def balls(pole, is_whole):
        return [place.ball(centre, pole, is_whole) for centre in (Vector(), before)]

    def balls_first(models, pole, is_whole):
        ball, tooth = balls(pole, is_whole)
        return _less(ball.cut(tooth).common(models[0]), models[1:])

    def ball_first(models, pole, is_whole):
        ball, tooth = balls(pole, is_whole)
        return _less(ball.common(models[0]), [tooth, *models[1:]])

    def stock_first(models, pole, is_whole):
        ball, tooth = balls(pole, is_whole)
        return _less(models[0], [*models[1:], tooth]).common(ball)

    return [
        functools.partial(balls_first, splines, before, True),
        functools.partial(ball_first, splines, before, True),
        functools.partial(stock_first, splines, before, True),
        functools.partial(stock_first, exact, before, True),
        functools.partial(stock_first, exact, across, False),
        functools.partial(stock_first, exact, before + across, True),
    ]


def _less(solid, others):
    for other in others:
        solid = solid.cut(other)
    return solid


def _measured(solid, surfaces):
    if len(solid.Solids) != 1:
        raise Flagged("OpenCASCADE makes %d solids of it." % len(solid.Solids))
    if not solid.isValid():
        raise Flagged("OpenCASCADE's own check calls the solid invalid.")
    lefts = [_left_by(face, surfaces) for face in solid.Faces]
    areas = {each.kind: 0.0 for each in surfaces}
    for face, left in zip(solid.Faces, lefts):
        areas[left.kind] += face.Area
    for kind, area in areas.items():
        # Between two passes the stock's surface may be gone.
        may_be_gone = kind == "stock" and sum(each.kind == "pass" for each in surfaces) > 1
        if area == 0 and not may_be_gone:
            raise Flagged("It has no face of the %s." % kind)
    volume = solid.Volume
    by_mesh = _mesh_volume(solid, lefts, MESH * volume / areas["previous"])
    if abs(by_mesh / volume - 1) > VOLUMES:
        raise Flagged("Its mesh has %+.2f %% of volume." % (100 * (by_mesh / volume - 1)))
    nearest = solid.distToShape(Part.Vertex(0, 0, 0))[0]
    return SolidChip(
        volume / SCALE**3,
        areas["tool"] / SCALE**2,
        areas["previous"] / SCALE**2,
        (surfaces[0].radius - nearest) / SCALE,
    )


def _left_by(face, surfaces):
    """Which of `surfaces` left a face."""
    if isinstance(face.Surface, Part.Sphere):
        centre = face.Surface.Center
        for ball in (each for each in surfaces if isinstance(each, Ball)):
            if (centre - Vector(*ball.centre)).Length < SAME:
                return ball
        raise Flagged("A face of a ball is neither tooth's.")
    begin_u, end_u, begin_v, end_v = face.ParameterRange
    point = face.valueAt((begin_u + end_u) / 2, (begin_v + end_v) / 2)
    for each in surfaces:
        if not isinstance(each, Ball) and abs(each.above(numpy.array([point]))[0]) < SAME:
            return each
    raise Flagged("A face is neither of the stock nor of a pass.")


def _mesh_volume(solid, lefts, deflection):
    """mm3 of a solid whose faces are left by surfaces, from triangles between points of it.

    What lies between a triangle and its surface is a third of the triangle's area times how high
    the surface stands over the middles of its sides: exact to the surface's second derivatives,
    where the triangles alone are to the first.
    """
    solid.tessellate(deflection)  # all faces at once, so that they share points along edges
    volume, origin = 0.0, None
    for face, left in zip(solid.Faces, lefts):
        points, triangles = face.tessellate(deflection)
        corners = numpy.array(points)[numpy.array(triangles)]
        origin = corners[0, 0] if origin is None else origin
        volume += numpy.linalg.det(corners - origin).sum() / 6
        sides = numpy.roll(corners, -1, axis=1) - corners
        areas = numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
        middles = left.above((corners + sides / 2).reshape(-1, 3)).reshape(-1, 3)
        volume -= areas @ middles.mean(axis=1)
    return volume
