"""What the ball feels at places of a path: its chips, what they leave, and the force.

Needs no FreeCAD.
"""

import math
from dataclasses import dataclass, fields

import numpy

from evenload import compiled
from evenload.ball_end.chips import Chip, chips

HALF_TURN = math.pi  # rad: the force model has teeth in the front half of the tool alone
LEVEL = 1e-12  # of a normal's part in plan: a level place leans to nowhere


@dataclass(frozen=True)
class Bends:
    """How the worked surface lies at n places: normals, n x 3, out of it; first, second: principal
    curvatures, 1/mm, > 0 convex; directions: n x 3, of the first.
    """

    normals: numpy.ndarray
    first: numpy.ndarray
    second: numpy.ndarray
    directions: numpy.ndarray

    def only(self, chosen):
        """Those that an array of n booleans chooses."""
        arrays = (self.normals, self.first, self.second, self.directions)
        return Bends(*(each[chosen] for each in arrays))

    def towards(self, vectors):
        """rad, of each vector's part in the surface from the first principal direction."""
        across = numpy.cross(self.normals, self.directions)
        return numpy.arctan2(_dot(vectors, across), _dot(vectors, self.directions))

    def across(self, ways):
        """The curvature across the feed, by Euler's formula."""
        angle = self.towards(ways)
        return self.first * numpy.sin(angle) ** 2 + self.second * numpy.cos(angle) ** 2


@dataclass(frozen=True)
class Cutting:
    """The tool's ball in its cut: diameter, mm; teeth; speed, rev/min; stock: what stands above the
    surface, across it, mm; coefficients: of a material, as materials.load has them.
    """

    diameter: float
    teeth: int
    speed: float
    stock: float
    coefficients: dict


@dataclass(frozen=True)
class Loads:
    """At n places: mean_thickness, the source's h_m, and max_thickness, mm [Varga 2023, 4.1];
    tip_share, 0 to 1; least_speed, m/min; cusp, mm, not a number where no pass is beside; force, N;
    feeds, mm/min; rows: which of the places that were asked for they are. refusals: sentences on
    places that have no chip and are left out.
    """

    mean_thickness: numpy.ndarray
    max_thickness: numpy.ndarray
    tip_share: numpy.ndarray
    least_speed: numpy.ndarray
    cusp: numpy.ndarray
    force: numpy.ndarray
    feeds: numpy.ndarray
    rows: numpy.ndarray
    refusals: tuple


def loads_at(places, bends, cutting):
    """The Loads at Places on a surface that bends so.

    The feed per tooth is laid off along the way of the ball's centre, as a machine moves, and so
    is the distance of the passes; a place's chip is that of a patch with both its curvatures.
    """
    steps = steps_across(places, bends)
    surfaces = _patches(bends)
    feeds = places.feeds / (cutting.speed * cutting.teeth)
    uncut = places.uncut
    directions = numpy.degrees(bends.towards(places.ways))
    # A slot has no pass beside it: any stepover will do.
    stepovers = numpy.where(numpy.isfinite(steps), steps, cutting.stock)
    refusals = []

    def chips_of(rows):
        return chips(
            [surfaces[row] for row in rows],
            *(cutting.diameter, feeds[rows], stepovers[rows], cutting.stock),
            *(directions[rows], 0, [uncut[row] for row in rows], "centre"),
        )

    parts = list(possible(chips_of, numpy.arange(len(surfaces)), refusals))
    if not parts:
        raise ValueError(refusals[0])
    rows = numpy.concatenate([part for part, _ in parts])
    found = _joined([chip for _, chip in parts])
    cusps = cusp_heights(steps, bends.across(places.ways), cutting.diameter / 2)
    return Loads(
        found.mean_thickness,
        found.max_thickness,
        found.tip_share,
        found.cutting_speeds(cutting.speed)[:, 0],
        cusps[rows],
        forces(found, cutting),
        places.feeds[rows],
        rows,
        tuple(dict.fromkeys(refusals)),
    )


def steps_across(places, bends):
    """mm along the surface of the ball's centres from each place to the pass beside it, infinite
    without one: a stepover s in plan is s cos(slope of the feed) / cos(slope of the surface).
    """
    level = numpy.hypot(*places.ways[:, :2].T)
    return places.stepovers * level / bends.normals[:, 2]


def cusp_heights(steps, curvatures, radius):
    """mm between two passes, across the surface; not a number where there is no pass beside.

    steps: mm along the surface of the ball's centres; curvatures: 1/mm, of the surface across the
    feed. r - sqrt(r^2 - w^2/4) - e as in docs/finishing.md, 2: exact across planes and cylinders;
    on a plane nearly a_e^2/8r.
    """
    of_centres = curvatures / (1 + curvatures * radius)
    steps = numpy.where(numpy.isfinite(steps), steps, numpy.nan)
    half = of_centres * steps / 2
    width = steps * numpy.sinc(half / math.pi)
    above = of_centres * steps**2 / 8 * numpy.sinc(half / (2 * math.pi)) ** 2
    below = numpy.sqrt(numpy.maximum(radius**2 - width**2 / 4, 0))
    return width**2 / 4 / (radius + below) - above


def forces(found, cutting):
    """N: the mean over a revolution of the force's size, by the simulator's force model.

    It knows straight edges: each chip is taken for that of an edge as long as the working one, R
    times its angle, in cut over as large a turn of the tool: for the chip's terms as if the working
    edge cut over the same turn all along, for the edge's, which weigh more near the tip, as if the
    face were a rectangle from there outwards. docs/finishing.md says how far this is off.
    """
    core = compiled.core()
    row = cutting.coefficients
    coefficients = core.ForceCoefficients(row["ktc"], row["krc"], row["kte"], row["kre"])
    radius = cutting.diameter / 2
    model = core.ForceModel(coefficients, radius, cutting.teeth, 0.0)
    low, high = numpy.radians(found.edge).T
    width = found.tool_face / radius**2 / (high - low)  # rad, of the rectangle
    turn = (_over_distance(width, high) - _over_distance(width, low)) / (high - low)
    even = found.tool_face / (radius**2 * (numpy.cos(low) - numpy.cos(high)))
    edge = radius * (high - low) * numpy.maximum(turn / HALF_TURN, 1)
    half = numpy.minimum(turn, HALF_TURN) / 2
    feeds = found.mean_thickness_tool * even / (2 * numpy.sin(half))
    feeds *= radius * (high - low) / edge
    return numpy.array(
        [
            model.force([(-h, h, depth)], feed, cutting.speed).mean_xy
            for h, depth, feed in zip(half, edge, feeds)
        ]
    )


def _over_distance(width, height):
    """The integral of 1/distance from a corner over a rectangle."""
    height = numpy.maximum(height, LEVEL)
    return width * numpy.arcsinh(height / width) + height * numpy.arcsinh(width / height)


def _patches(bends):
    """A place's surface in the words of ball_end.chip."""
    normals = bends.normals
    level = normals[:, :2] / numpy.maximum(numpy.hypot(*normals[:, :2].T), LEVEL)[:, None]
    slopes = numpy.arccos(numpy.clip(normals[:, 2], -1, 1))
    downhill = numpy.column_stack([level * normals[:, 2:], -numpy.sin(slopes)])
    columns = (
        bends.first,
        bends.second,
        numpy.degrees(slopes),
        numpy.degrees(bends.towards(downhill)),
    )
    return [("patch", *row) for row in numpy.column_stack(columns).tolist()]


def possible(chips_of, rows, refusals):
    """(rows, their Chip) of places that have chips; sentences of the others go into refusals."""
    try:
        found = chips_of(rows)
    except ValueError as error:
        if len(rows) == 1:
            refusals.append(str(error))
            return
        for half in numpy.array_split(rows, 2):
            yield from possible(chips_of, half, refusals)
    else:
        yield rows, found


def _joined(parts):
    names = [field.name for field in fields(Chip)]
    return Chip(
        **{name: numpy.concatenate([getattr(each, name) for each in parts]) for name in names}
    )


def _dot(a, b):
    return (a * b).sum(axis=1)
