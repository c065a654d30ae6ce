"""Toolpath -> Path commands, and back. The only place for mm/s and G-codes.

Post-processors write three decimals, or four when told to. Ends are rounded here first, to four,
and the arcs' centres are then chosen for the rounded ends: what is posted with four decimals is
what was computed, and tangent arcs stay so. With three no arc's two radii disagree by more than a
controller accepts.
"""

from math import acos, atan2, ceil, cos, hypot, isfinite, pi, sin, sqrt, tan

import Path

from evenload.planar import CUT, RAPID, sweep_of

# Of a mm. On a grid of 0.001 mm, which posts write unless told otherwise, moves of some hundredths
# of a mm would be turned by degrees, and the engagement with them.
DECIMALS = 4
GRID = 10.0**-DECIMALS
SHORTEST_LINE = 0.0005  # mm: shorter ones are left out, posts would repeat a position
# mm: arcs with a shorter chord become lines. Their ends must not coincide after a post rounds them,
# which would make full circles of them; inch posts round to 0.0001 in, and their roundings at both
# ends add up to 0.0036 mm.
SHORTEST_ARC = 0.005
LARGEST_RADIUS = 1e4  # mm: flatter arcs become lines; at 50 mm of length they bend by 0.03 um
SMALLEST_RADIUS = 0.01  # mm: tighter arcs become lines, which leave them by less than twice this
# mm: a centre on the grid is found for every arc within twice this. Controllers refuse arcs whose
# radii at start and end differ by more than about 0.005 mm; rounding to 0.001 mm adds up to 0.003.
RADIUS_MISMATCH = 0.00005
MOST_TURN_CHANGE = 0.5  # rad: by which rounding may change a sweep; only the tiniest arcs get there
# rad: FreeCAD's simulator and dressups take the wrong side of longer arcs; the margin keeps halves.
LARGEST_SWEEP = pi * (1 + 1e-6)
# FreeCAD's simulator and dressups take an arc whose end points span an area below 0.005 mm^2 with
# its centre for half a circle, and fall down over some. Such arcs become lines, unless they are
# long enough for that to do no harm. The core avoids them: its small_arc.h has these limits.
SMALLEST_CROSS = 0.0052  # mm^2
LARGEST_SMALL_SWEEP = 1.6  # rad: a quarter turn is the middle of such a half circle
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
        if abs(z - self.z) >= SHORTEST_LINE:
            self.commands.append(Path.Command("G0", {"Z": z}))
            self.z = z

    def line(self, x, y, z, feed):
        flat = hypot(x - self.x, y - self.y)
        if flat >= SHORTEST_LINE or abs(z - self.z) >= SHORTEST_LINE:
            self._feed("G1", x, y, z, {"F": feed})

    def _feed(self, name, x, y, z, parameters):
        """Feed moves name all three axes: FreeCAD's dressups look for them."""
        if abs(z - self.z) < SHORTEST_LINE:
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
                i, j = p["I"], p["J"]
                flat = hypot(i, j) * abs(sweep_of(nx - x, ny - y, i, j, command.Name == "G3"))
            total += sqrt(flat**2 + (nz - z) ** 2)
        x, y, z = nx, ny, nz
    return total


# ---- back: what Path commands do ----

ARC_MISMATCH = 0.005, 1e-3  # mm and share of the radius: LinuxCNC and grbl refuse what exceeds both
SAME_PLACE = 1e-6  # mm: ends of an arc that are nearer make a full circle
# mm above the last depth, where a pecking drill slows down: as LinuxCNC has it
PECK_CLEARANCE = 0.254
SHORTEST_PECK = 1e-3  # mm
CYCLES = (73, 81, 82, 83)
RETRACTS = {98: True, 99: False}  # whether cycles end at the height where they began, not at R
# G-codes that move nothing, or say what holds anyway: dwell, plane XY, mm, no tool radius
# compensation, tool length, fixtures, path modes, end of cycles, absolute, units per minute.
QUIET = (4, 17, 21, 40, 43, 49, *range(54, 60), 59.1, 59.2, 59.3, 61, 61.1, 64, 80, 90, 91.1, 94)


def to_moves(commands, z, feed):
    """(moves, numbers): the moves (kind, x, y, z, sweep, cx, cy, feed) that Path commands make, and
    for each the number of its command, counted from 1. The first, of number 0, says where the tool
    is before: at the height z, over the place that the commands name first.

    mm, rad, mm/min. G0 and the quick parts of cycles become RAPID, with a feed of 0, all else CUT.
    feed: in mm/min, of feed moves before the first F. Drilling cycles become their single moves.
    The centres of arcs are moved to where both radii are the same. Raises ValueError, with the
    number, for a command that cannot be followed.
    """
    first = {
        axis: next((c.Parameters[axis] for c in commands if axis in c.Parameters), 0.0)
        for axis in "XY"
    }
    reader = _Reader({**first, "Z": float(z)}, feed)
    for number, command in enumerate(commands, 1):
        try:
            reader.read(command.Name.upper(), command.Parameters)
        except ValueError as error:
            sentence = "Command %d of the path, %s, %s" % (number, command.Name, error)
            raise ValueError(sentence) from None
        reader.numbers += [number] * (len(reader.moves) - len(reader.numbers))
    return reader.moves, reader.numbers


class _Reader:
    """Follows commands; its errors are the ends of sentences."""

    def __init__(self, at, feed):
        self.moves, self.numbers = [], [0]
        self.feed = feed
        self._add(RAPID, at, 0.0, 0.0, 0.0)
        self.cycles_began = None  # the height; None outside of cycles
        self.to_begin = True

    def read(self, name, p):
        if not name.startswith("G"):
            if name.startswith(("M", "T", "S", "F", "(", ";", "N", "O")):
                return
            raise ValueError("is not known to the simulator: leave it out.")
        try:
            code = float(name[1:])
        except ValueError:
            raise ValueError("is no G-code: leave it out.") from None
        if code in RETRACTS:
            self.to_begin = RETRACTS[code]
        elif code in (0, 1, 2, 3, *CYCLES):
            self._motion(int(code), p)
        elif code not in QUIET:
            raise ValueError("is not known to the simulator: leave it out.")

    def _motion(self, code, p):
        if not all(isfinite(value) for value in p.values()):
            raise ValueError("has a number that is not finite: compute the operation anew.")
        if any(p.get(axis) for axis in "ABC"):
            raise ValueError("turns the work: only paths with a fixed tool axis can be simulated.")
        if code and p.get("F", 0) > 0:
            self.feed = 60.0 * p["F"]
        end = {axis: float(p.get(axis, self.at[axis])) for axis in "XYZ"}
        if code in CYCLES:
            self._cycle(code, end, p)
            return
        self.cycles_began = None
        if code in (2, 3):
            self._arc(code, end, p)
        elif end != self.at:
            self._line(CUT if code else RAPID, **end)

    def _line(self, kind, **end):
        self._add(kind, {**self.at, **end}, 0.0, 0.0, 0.0)

    def _add(self, kind, end, sweep, cx, cy):
        feed = self.feed if kind != RAPID else 0.0
        self.moves.append((kind, end["X"], end["Y"], end["Z"], sweep, cx, cy, feed))
        self.at = end

    def _arc(self, code, end, p):
        i, j = p.get("I", 0.0), p.get("J", 0.0)
        dx, dy = end["X"] - self.at["X"], end["Y"] - self.at["Y"]
        before, after = hypot(i, j), hypot(dx - i, dy - j)
        if not before > SAME_PLACE:
            raise ValueError("has no radius: give it I and J.")
        if abs(before - after) > max(ARC_MISMATCH[0], ARC_MISMATCH[1] * before):
            raise ValueError(
                "is an arc whose radii at its ends are %g and %g mm: correct its I and J."
                % (round(before, 4), round(after, 4))
            )
        chord = hypot(dx, dy)
        if chord < SAME_PLACE:
            sweep = 2 * pi if code == 3 else -2 * pi
        else:
            off = ((i - 0.5 * dx) * dx + (j - 0.5 * dy) * dy) / chord**2
            i, j = i - off * dx, j - off * dy
            sweep = sweep_of(dx, dy, i, j, code == 3)
        self._add(CUT, end, sweep, self.at["X"] + i, self.at["Y"] + j)

    def _cycle(self, code, end, p):
        bottom, quick, peck = end["Z"], p.get("R", self.at["Z"]), p.get("Q", 0.0)
        if bottom > quick:
            raise ValueError("drills from Z%g up to Z%g: correct its R." % (quick, bottom))
        if code in (73, 83) and not peck >= SHORTEST_PECK:
            raise ValueError("has no depth of peck: give it Q.")
        if self.cycles_began is None:
            self.cycles_began = self.at["Z"]
        self._rapid_to(max(self.at["Z"], quick))
        if (end["X"], end["Y"]) != (self.at["X"], self.at["Y"]):
            self._line(RAPID, X=end["X"], Y=end["Y"])
        self._rapid_to(quick)
        depth = quick
        while code in (73, 83) and depth - peck > bottom + SHORTEST_PECK:
            depth -= peck
            self._line(CUT, Z=depth)
            if code == 83:
                self._rapid_to(quick)
            self._rapid_to(min(depth + PECK_CLEARANCE, quick))
        self._line(CUT, Z=bottom)
        self._rapid_to(max(quick, self.cycles_began) if self.to_begin else quick)

    def _rapid_to(self, z):
        if z != self.at["Z"]:
            self._line(RAPID, Z=z)
