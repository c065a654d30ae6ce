"""What paths and chains are to Python: kinds of moves, sweeps of arcs, chains as points. Needs no
FreeCAD.
"""

import math

import numpy

RAPID, LINK, ENTRY, CUT = range(4)  # the kinds of moves, as the core counts them
DEFLECTION = 0.005  # mm: of polygons that stand for an outline


def sweep_of(dx, dy, i, j, counter_clockwise):
    """The sweep in rad, counter-clockwise positive, of an arc to (dx, dy) about (i, j), both seen
    from its start. Ends that coincide make a full circle.
    """
    turn = math.atan2(dy - j, dx - i) - math.atan2(-j, -i)
    if counter_clockwise:
        return turn % (2 * math.pi) or 2 * math.pi
    return -((-turn) % (2 * math.pi) or 2 * math.pi)


def flattened(chain):
    """Points (x, y) in mm of a closed chain of (x, y, bulge, ...): arcs become chords, which leave
    them by DEFLECTION at the most. The first point is not repeated.
    """
    points = []
    for (x0, y0, bulge, *_), (x1, y1, *_) in zip(chain, chain[1:] + chain[:1]):
        points.append((x0, y0))
        if bulge:
            half = 2 * math.atan(bulge)
            radius = 0.5 * math.hypot(x1 - x0, y1 - y0) / math.sin(half)
            start = math.atan2(y1 - y0, x1 - x0) - half
            cx, cy = x0 - radius * math.sin(start), y0 + radius * math.cos(start)
            steps = max(2, math.ceil(abs(half) / math.acos(max(0.0, 1 - DEFLECTION / abs(radius)))))
            for k in range(1, steps):
                angle = start + 2 * half * k / steps
                points.append((cx + radius * math.sin(angle), cy - radius * math.cos(angle)))
    return numpy.array(points)
