"""Toolpath -> Path commands. The only place for mm/s and G-codes.

Post-processors round to three decimals. So ends are rounded here first, and the arcs' centres are
then chosen for the rounded ends: what is posted is what was computed, and no arc's two radii
disagree by more than a controller accepts.
"""

from math import acos, atan2, ceil, cos, hypot, isfinite, pi, sin, sqrt, tan

import Path

RAPID, LINK, ENTRY, CUT = range(4)  # the kinds of moves, as the core counts them

DECIMALS = 3  # of a mm: what FreeCAD's post-processors write unless told otherwise
GRID = 10.0**-DECIMALS
# mm: arcs with a shorter chord become lines. Their ends must not coincide after a post rounds them,
# which would make full circles of them; inch posts round to 0.0001 in, and their roundings at both
# ends add up to 0.0036 mm.
SHORTEST_ARC = 0.005
LARGEST_RADIUS = 1e4  # mm: flatter arcs become lines; at 50 mm of length they bend by 0.03 um
SMALLEST_RADIUS = 0.01  # mm: tighter arcs become lines, which leave them by less than twice this
# Controllers refuse arcs whose radii at start and end differ by more than about 0.005 mm.
RADIUS_MISMATCH = 0.0005  # mm: a centre on the grid is found for every arc within twice this
MOST_TURN_CHANGE = 0.5  # rad: by which rounding may change a sweep; only the tiniest arcs get there
# rad: FreeCAD's simulator and dressups take the wrong side of longer arcs; the margin keeps halves.
LARGEST_SWEEP = pi * (1 + 1e-6)
# FreeCAD's simulator and dressups take an arc whose end points span an area below 0.005 mm^2 with
# its centre for half a circle, and fall down over some. Such arcs become lines, unless they are
# long enough for that to do no harm.
SMALLEST_CROSS = 0.006  # mm^2
LARGEST_SMALL_SWEEP = 1.75  # rad: a hundred degrees
SAGITTA = 0.004  # mm: largest distance of those lines from the arc, on the inner side


def from_moves(moves, start=None):
    """The list of Path.Command for moves (kind, x, y, z, sweep, cx, cy, feed) as the core returns
    them.

    mm, rad, mm/min; feeds become mm/s. start: (x, y, z) where the tool is, None for anywhere above
    everything, so that the first rapid rises before it travels. Raises ValueError for numbers that
    are not finite and feeds that are not positive.
    """
    writer = _Writer(start)
    for number, move in enumerate(moves):
        kind, x, y, z, sweep, cx, cy, feed = move
        if not isfinite(x + y + z + sweep + cx + cy + feed):
            raise ValueError("Move %d of the toolpath is not finite: %r." % (number, move))
        if kind == RAPID:
            writer.rapid(_rounded(x), _rounded(y), round(z, 6))
            continue
        if not feed > 0:
            raise ValueError("Move %d of the toolpath has no feed: %r." % (number, move))
        if sweep:
            writer.arc(x, y, z, sweep, cx, cy, feed / 60.0)
        else:
            writer.line(_rounded(x), _rounded(y), round(z, 6), feed / 60.0)
    return writer.commands


def _rounded(value):
    return round(value, DECIMALS) + 0.0  # no negative zeros


class _Writer:
    """Collects commands; remembers where the rounded path is, so that no command repeats a
    position.
    """

    def __init__(self, start):
        self.commands = []
        self.x, self.y, self.z = start or (None, None, None)

    def rapid(self, x, y, z):
        """Up before across before down: a rapid never cuts a corner."""
        if self.z is None:
            self.commands.append(Path.Command("G0", {"Z": z}))
            self.z = z
        if z > self.z:
            self._rapid_z(z)
        if x != self.x or y != self.y:
            self.commands.append(Path.Command("G0", {"X": x, "Y": y}))
            self.x, self.y = x, y
        if z < self.z:
            self._rapid_z(z)

    def _rapid_z(self, z):
        if abs(z - self.z) >= GRID / 2:
            self.commands.append(Path.Command("G0", {"Z": z}))
            self.z = z

    def line(self, x, y, z, feed):
        if x != self.x or y != self.y or abs(z - self.z) >= GRID / 2:
            self._feed("G1", x, y, z, {"F": feed})

    def _feed(self, name, x, y, z, parameters):
        """Feed moves name all three axes: FreeCAD's dressups look for them."""
        if abs(z - self.z) < GRID / 2:
            z = self.z
        parameters.update(X=x, Y=y, Z=z)
        self.commands.append(Path.Command(name, parameters))
        self.x, self.y, self.z = x, y, z

    def arc(self, x, y, z, sweep, cx, cy, feed):
        """An arc, or a helix when z changes. It may go round more than once."""
        turns = abs(sweep) / (2 * pi)
        pieces = max(1, ceil(abs(sweep) / LARGEST_SWEEP), 2 * round(turns))  # full turns as halves
        circle = cx, cy, hypot(x - cx, y - cy), atan2(y - cy, x - cx) - sweep, self.z, z, sweep
        for i in range(1, pieces):
            self._piece(*_on(circle, i / pieces), sweep / pieces, circle, (i - 1) / pieces, feed)
        self._piece(x, y, z, sweep / pieces, circle, (pieces - 1) / pieces, feed)

    def _piece(self, x, y, z, sweep, circle, share, feed):
        """An arc of less than half a turn to (x, y, z), which starts at a share of a circle."""
        radius = circle[2]
        if radius < SMALLEST_RADIUS or radius > LARGEST_RADIUS:
            self.line(_rounded(x), _rounded(y), round(z, 6), feed)
            return
        if radius**2 * abs(sin(sweep)) < SMALLEST_CROSS and abs(sweep) < LARGEST_SMALL_SWEEP:
            lines = max(1, ceil(abs(sweep) / (2 * acos(1 - min(1.0, SAGITTA / radius)))))
            for k in range(1, lines):
                at = share + k / lines * sweep / circle[6]
                u, v, w = _on(circle, at)
                self.line(_rounded(u), _rounded(v), round(w, 6), feed)
            self.line(_rounded(x), _rounded(y), round(z, 6), feed)
            return
        x, y, z = _rounded(x), _rounded(y), round(z, 6)
        dx, dy = x - self.x, y - self.y
        chord = hypot(dx, dy)
        centre = _centre(dx, dy, chord, sweep) if chord >= SHORTEST_ARC else None
        if centre is None:
            self.line(x, y, z, feed)
            return
        parameters = {"I": centre[0], "J": centre[1], "F": feed}
        self._feed("G3" if sweep > 0 else "G2", x, y, z, parameters)


def _on(circle, share):
    """The point at a share of a move along a circle or helix."""
    cx, cy, radius, start, z0, z1, sweep = circle
    angle = start + share * sweep
    return cx + radius * cos(angle), cy + radius * sin(angle), z0 + share * (z1 - z0)


def _centre(dx, dy, chord, sweep):
    """(I, J) on the grid for an arc over the chord (dx, dy); None where none turns that way."""
    height = 0.5 / tan(0.5 * sweep)  # of the centre to the left of the chord, in chords
    i, j = 0.5 * dx - height * dy, 0.5 * dy + height * dx
    radius = hypot(i, j)
    if radius > LARGEST_RADIUS:
        return None
    gi, gj = _rounded(i), _rounded(j)
    if abs(hypot(gi, gj) - hypot(dx - gi, dy - gj)) > RADIUS_MISMATCH:
        # Moving the centre along the chord makes the radii differ, moving it across bends the arc:
        # both count.
        bend = 1.0 - cos(min(0.5 * abs(sweep), pi))
        best = None
        for a in (-GRID, 0.0, GRID):
            for b in (-GRID, 0.0, GRID):
                u, v = gi + a, gj + b
                mismatch = abs(hypot(u, v) - hypot(dx - u, dy - v))
                across = abs((u - i) * -dy + (v - j) * dx) / chord
                cost = mismatch + 0.5 * bend * across
                if best is None or cost < best[0]:
                    best = cost, u, v
        gi, gj = _rounded(best[1]), _rounded(best[2])
    # On the grid the arc must still turn the same way by about the same angle.
    turned = atan2(-gi * (dy - gj) + gj * (dx - gi), -gi * (dx - gi) - gj * (dy - gj))
    turned = turned % (2 * pi) if sweep > 0 else -(-turned % (2 * pi))
    return (gi, gj) if abs(turned - sweep) < MOST_TURN_CHANGE else None


def length(commands):
    """mm of feed moves in a list of commands, arcs and helices by their true length; for tests and
    reports.
    """
    total, x, y, z = 0.0, None, None, None
    for command in commands:
        p = command.Parameters
        nx, ny, nz = p.get("X", x), p.get("Y", y), p.get("Z", z)
        if command.Name in ("G1", "G2", "G3") and None not in (x, y, z):
            flat = hypot(nx - x, ny - y)
            if command.Name != "G1":
                radius = hypot(p["I"], p["J"])
                turn = atan2(ny - y - p["J"], nx - x - p["I"]) - atan2(-p["J"], -p["I"])
                sense = 1 if command.Name == "G3" else -1
                flat = radius * ((sense * turn) % (2 * pi) or 2 * pi)
            total += sqrt(flat**2 + (nz - z) ** 2)
        x, y, z = nx, ny, nz
    return total
