"""The source's test parts as triangles, and how far a ball is from them: written anew from lines
and arcs, so that nothing is shared with what is judged.
"""

import math

import numpy

HALF, DOME, FILLET, FLAT = 40.0, 45.0, 10.0, 10.0  # mm [Varga 2023, 3.1]
LEAN = math.asin((HALF - FLAT) / (DOME + FILLET))
JOINT = DOME * math.sin(LEAN)  # the ordinate where the arcs meet
CENTRE = (DOME + FILLET) * math.cos(LEAN)  # the height of the fillets' axes over the dome's
LEVEL = CENTRE - FILLET  # of the flats
UNDERSIDE = 10.0, -70.0  # its z of CX and CV
TOLERANCE = 0.005


def height(y, is_convex):
    """z of the part over the ordinates y; the dome's axis is at z = 0."""
    y = numpy.abs(y)
    dome = numpy.sqrt(numpy.maximum(DOME**2 - y**2, 0))
    fillet = CENTRE - numpy.sqrt(numpy.maximum(FILLET**2 - (y - (HALF - FLAT)) ** 2, 0))
    z = numpy.where(y <= JOINT, dome, numpy.where(y <= HALF - FLAT, fillet, LEVEL))
    return z if is_convex else -z


def distance(points, is_convex):
    """Signed distances of points (x, y, z) from the part's upper side, positive above it, for those
    whose nearest place lies on it.
    """
    y, z = numpy.abs(points[:, 1]), points[:, 2] * (1 if is_convex else -1)
    from_dome = numpy.hypot(y, z) - DOME
    from_fillet = FILLET - numpy.hypot(y - (HALF - FLAT), z - CENTRE)
    # The rays from both axes through the joint part the plane.
    in_dome = y * math.cos(LEAN) <= z * math.sin(LEAN)
    found = numpy.where(in_dome, from_dome, numpy.where(y <= HALF - FLAT, from_fillet, z - LEVEL))
    return found if is_convex else -found


def bends_under(y, ball, is_convex):
    """(normals, n x 3, curvature along y, 1/mm, > 0 convex, mm in plan to the next joint) of the
    part where a ball of a radius over the ordinates y touches it.
    """
    sense = 1 if is_convex else -1
    dome, fillet = DOME + sense * ball, FILLET - sense * ball  # of the ball's centres
    joint, ends, aside = dome * math.sin(LEAN), HALF - FLAT, numpy.abs(y)
    parts = [aside < joint, aside < ends]
    curvature = numpy.select(parts, [sense / DOME, -sense / FILLET], 0.0)
    sine = numpy.select(parts, [aside / dome, (ends - aside) / fillet], 0.0)
    normals = numpy.column_stack(
        [numpy.zeros(len(y)), sense * numpy.sign(y) * sine, numpy.sqrt(1 - sine**2)]
    )
    return normals, curvature, numpy.minimum(numpy.abs(aside - joint), numpy.abs(aside - ends))


def section(deflection):
    """Ordinates of the section's points, chords between which leave it by `deflection` mm."""

    def steps(radius):
        return math.ceil(LEAN / (2 * math.acos(1 - deflection / radius)))

    dome = [DOME * math.sin(a) for a in numpy.linspace(0, LEAN, steps(DOME) + 1)]
    fillet = [
        HALF - FLAT - FILLET * math.sin(a) for a in numpy.linspace(LEAN, 0, steps(FILLET) + 1)
    ]
    half = [*dome, *fillet[1:], HALF]
    return numpy.array([-y for y in half[:0:-1]] + half)


def triangles(is_convex, deflection=TOLERANCE / 4):
    """(points, triangles, picked) of the part, whose whole upper side is picked."""
    y = section(deflection)
    z = height(y, is_convex)
    bottom = UNDERSIDE[0 if is_convex else 1]
    rows = len(y)
    points = [(x, *yz) for x in (-HALF, HALF) for yz in zip(y, z)]
    points += [(x, each, bottom) for x in (-HALF, HALF) for each in y]
    found, sides = [], []
    for k in range(rows - 1):
        found += [(k, rows + k, rows + k + 1), (k, rows + k + 1, k + 1)]
        for wall in (k, rows + k):  # at both ends of the section
            sides += [
                (wall, wall + 1, wall + 2 * rows + 1),
                (wall, wall + 2 * rows + 1, wall + 2 * rows),
            ]
    for wall in (0, rows - 1):
        sides += [(wall, wall + rows, wall + 3 * rows), (wall, wall + 3 * rows, wall + 2 * rows)]
    return (
        numpy.array(points),
        numpy.array(found + sides, dtype=numpy.uint32),
        numpy.arange(len(found) + len(sides)) < len(found),
    )


def options(**others):
    """Arguments of finish() for the source's tool and conditions, in mm and mm/min."""
    return {
        **dict(tool_diameter=10, corner_radius=5, stepover=1.0),
        **dict(tolerance=0.75 * TOLERANCE, deflection=TOLERANCE / 4, floor=-100.0, top=50.0),
        **dict(safe_height=53.0, clearance_height=55.0),
        **dict(feed=1650.0, plunge_feed=800.0, rapid_feed=5000.0),
        **others,
    }


def places_along(moves, kinds, spacing=0.05):
    """Points on moves of some kinds, at both ends of each and between; on arcs and helices, too."""
    points, before = [], None
    for kind, x, y, z, sweep, cx, cy, _ in moves:
        end = numpy.array((x, y, z))
        if kind in kinds and before is not None:
            length = abs(sweep) * math.hypot(x - cx, y - cy) if sweep else math.dist(end, before)
            count = max(1, math.ceil(length / spacing))
            shares = numpy.arange(count + 1)[:, None] / count
            points.append(before + shares * (end - before))
            if sweep:
                turns = sweep * shares[1:-1, 0]
                arm = before[:2] - (cx, cy)
                aside = numpy.array((-arm[1], arm[0]))
                turned = numpy.outer(numpy.cos(turns), arm) + numpy.outer(numpy.sin(turns), aside)
                points[-1][1:-1, :2] = turned + (cx, cy)
        before = end
    return numpy.vstack(points)


def as_lines(moves, spacing=0.05):
    """The same moves, short lines in place of arcs and helices, corners of which lie on them."""
    found = []
    for before, move in zip([None, *moves], moves):
        kind, feed = move[0], move[7]
        ends = [move[1:4]]
        if move[4]:
            ends = places_along([before, move], (kind,), spacing)[1:]
        found += [(kind, *end, 0.0, 0.0, 0.0, feed) for end in ends]
    return found
