"""Toolpath -> Path commands, and back. The only place for mm/s and G-codes; the core chooses the
commands, so that they survive a post-processor's rounding.
"""

from functools import lru_cache
from math import hypot, inf, isfinite, pi, sqrt

import Path

from evenload import compiled
from evenload.planar import CUT, RAPID, sweep_of


def from_moves(moves, start=None, left_out_from=inf):
    """The list of Path.Command for a toolpath of the core, or for moves (kind, x, y, z, sweep, cx,
    cy, feed) as it has them.

    mm, rad, mm/min; feeds become mm/s. start: (x, y, z) where the tool is, None for anywhere above
    everything, so that the first rapid rises before it travels. Rapids at the end that are at
    left_out_from or above it are left out. Raises ValueError for numbers that are not finite and
    feeds that are not positive.
    """
    made = compiled.core().path_commands(moves, start, left_out_from)
    for _, words in made:
        if "F" in words:
            words["F"] /= 60.0
    return [Path.Command(name, words) for name, words in made]


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
PECKING = (73, 83)
# Cycles that feed out of the hole as they fed into it: tapping, reaming, boring; others come out by
# a rapid, boring ones (76, 86, 88) with the spindle stopped.
FED_OUT = (74, 84, 85, 89)
# The cutter of back boring comes through a hole that is there and cuts a recess from below: of what
# stands, seen from above, it takes nothing.
BACK_BORING = 87
CYCLES = (*PECKING, 76, 81, 82, 86, *FED_OUT, BACK_BORING, 88)
MOTIONS = frozenset((0, 1, 2, 3, *CYCLES))
TURNS = frozenset("ABC")
HOMES = (28, 30)
RETRACTS = {98: True, 99: False}  # whether cycles end at the height where they began, not at R
# G-codes that move nothing, or say what holds anyway: dwell, plane XY, mm, no tool radius
# compensation, tool length, fixtures, path modes, end of cycles, absolute, units per minute.
QUIET = (4, 17, 21, 40, 43, 49, *range(54, 60), 59.1, 59.2, 59.3, 61, 61.1, 64, 80, 90, 91.1, 94)


def to_moves(commands, z, feed):
    """(moves, numbers): the moves (kind, x, y, z, sweep, cx, cy, feed) that Path commands make, and
    for each the number of its command, counted from 1. The first, of number 0, says where the tool
    is before: at the height z, over the place that the commands name first.

    mm, rad, mm/min. G0 and the quick parts of cycles become RAPID, with a feed of 0, all else CUT.
    feed: in mm/min, of feed moves before the first F. Drilling, tapping and boring cycles become
    their single moves; of back boring only the way to its place. G28 and G30 end at the height z.
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
            reader.read(_code_of(command.Name), command.Parameters)
        except ValueError as error:
            sentence = "Command %d of the path, %s, %s" % (number, command.Name, error)
            raise ValueError(sentence) from None
        reader.numbers += [number] * (len(reader.moves) - len(reader.numbers))
    return reader.moves, reader.numbers


@lru_cache(maxsize=1000)  # comments are names, too
def _code_of(name):
    """The number of a G-code, None for what moves nothing. Errors are the ends of sentences."""
    letter, number = name[:1].upper(), name[1:]
    if letter in ("M", "T", "S", "F", "(", ";", "N", "O"):
        return None
    if letter != "G":
        raise ValueError("is not known to the simulator: leave it out.")
    try:
        return float(number)
    except ValueError:
        raise ValueError("is no G-code: leave it out.") from None


class _Reader:
    """Follows commands; its errors are the ends of sentences."""

    def __init__(self, at, feed):
        self.moves, self.numbers = [], [0]
        self.feed, self.top = feed, at["Z"]
        self._add(RAPID, at, 0.0, 0.0, 0.0)
        self.cycles_began = None  # the height; None outside of cycles
        self.to_begin = True

    def read(self, code, p):
        if code is None:
            return
        if "G" in p:
            raise ValueError("has a second G word, which is lost: give that a line of its own.")
        if code in MOTIONS:
            self._motion(int(code), p)
        elif code in RETRACTS:
            self.to_begin = RETRACTS[code]
        elif code in HOMES:
            self._home(p)
        elif code not in QUIET:
            raise ValueError("is not known to the simulator: leave it out.")

    def _motion(self, code, p):
        if not isfinite(sum(p.values())):
            raise ValueError("has a number that is not finite: compute the operation anew.")
        if not TURNS.isdisjoint(p) and any(p.get(axis) for axis in TURNS):
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

    def _home(self, p):
        """Through the place that is named, and up from there: where the machine's own place lies
        nobody knows, but no material is there.
        """
        end = {axis: float(p.get(axis, self.at[axis])) for axis in "XYZ"}
        self.cycles_began = None
        if end != self.at:
            self._line(RAPID, **end)
        self._rapid_to(max(self.top, self.at["Z"]))

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
        if code == BACK_BORING:
            self._rapid_across(end)
            return
        if bottom > quick:
            raise ValueError("drills from Z%g up to Z%g: correct its R." % (quick, bottom))
        if code in PECKING and not peck >= SHORTEST_PECK:
            raise ValueError("has no depth of peck: give it Q.")
        if self.cycles_began is None:
            self.cycles_began = self.at["Z"]
        self._rapid_to(max(self.at["Z"], quick))
        self._rapid_across(end)
        self._rapid_to(quick)
        depth = quick
        while code in PECKING and depth - peck > bottom + SHORTEST_PECK:
            depth -= peck
            self._line(CUT, Z=depth)
            if code == 83:
                self._rapid_to(quick)
            self._rapid_to(min(depth + PECK_CLEARANCE, quick))
        self._line(CUT, Z=bottom)
        if code in FED_OUT:
            self._line(CUT, Z=quick)
        self._rapid_to(max(quick, self.cycles_began) if self.to_begin else quick)

    def _rapid_across(self, end):
        if (end["X"], end["Y"]) != (self.at["X"], self.at["Y"]):
            self._line(RAPID, X=end["X"], Y=end["Y"])

    def _rapid_to(self, z):
        if z != self.at["Z"]:
            self._line(RAPID, Z=z)
