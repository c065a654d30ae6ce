"""What paths and chains are to Python: kinds of moves, sweeps of arcs, chains as points. Needs no
FreeCAD.
"""

import math

import numpy

RAPID, LINK, ENTRY, CUT = range(4)  # the kinds of moves, as the core counts them
DEFLECTION = 0.005  # mm: of polygons that stand for an outline
# Arcs of a path that is drawn: mm by which chords leave them, and rad that a chord turns by at the
# most.
DRAWN_DEFLECTION, DRAWN_TURN = 0.02, 0.3
LINES_DEFLECTION = 0.002  # mm: of lines that stand for the arcs of a path


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


def drawn(moves):
    """(points, kinds): places (x, y, z) in mm along moves as the core returns them, n x 3, arcs as
    chords, and for each the kind of the move that leads there.
    """
    points, which, rows = _chords(moves, DRAWN_DEFLECTION)
    return points, rows[which, 0].astype(int)


def as_lines(moves):
    """Moves as the core returns them, n x 8, chords in place of their arcs, which leave these by
    LINES_DEFLECTION at the most.
    """
    return numbered_lines(moves)[0]


def numbered_lines(moves):
    """(the same, for each the number of the move that it is part of)."""
    points, which, rows = _chords(moves, LINES_DEFLECTION)
    lines = numpy.zeros((len(points), rows.shape[1]))
    lines[:, 0], lines[:, 1:4], lines[:, 7] = rows[which, 0], points, rows[which, 7]
    return lines, which


def _chords(moves, deflection):
    """(points, which, rows): places along moves, the number of the move that leads to each, and the
    moves, n x 8.
    """
    rows = numpy.array(moves, float).reshape(-1, 8)
    ends, sweeps, centres = rows[:, 1:4], rows[:, 4], rows[:, 5:7]
    starts = numpy.vstack([ends[:1], ends[:-1]])
    sweeps = numpy.where(numpy.arange(len(rows)) > 0, sweeps, 0.0)  # where it begins is a place
    radii = numpy.linalg.norm(starts[:, :2] - centres, axis=1)
    turns = 2 * numpy.arccos(1 - numpy.minimum(deflection / numpy.maximum(radii, 1e-9), 1))
    counts = numpy.ceil(numpy.abs(sweeps) / numpy.minimum(turns, DRAWN_TURN)).astype(int)
    counts = numpy.maximum(counts, 1)
    which = numpy.repeat(numpy.arange(len(rows)), counts)
    number = numpy.arange(len(which)) - numpy.repeat(numpy.cumsum(counts) - counts, counts) + 1
    share = number / counts[which]
    points = starts[which] + share[:, None] * (ends - starts)[which]
    on_arc = (number < counts[which]) & (sweeps[which] != 0)
    of = which[on_arc]
    angles = share[on_arc] * sweeps[of]
    arms = starts[of, :2] - centres[of]
    points[on_arc, 0] = (
        centres[of, 0] + arms[:, 0] * numpy.cos(angles) - arms[:, 1] * numpy.sin(angles)
    )
    points[on_arc, 1] = (
        centres[of, 1] + arms[:, 0] * numpy.sin(angles) + arms[:, 1] * numpy.cos(angles)
    )
    return points, which, rows
