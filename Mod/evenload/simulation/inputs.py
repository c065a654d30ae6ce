"""What `simulate` takes, made ready for the core: paths, cutting data, stock, part and fixtures."""

import math
import os

import numpy

from evenload import materials
from evenload.tool import HELIX_ANGLE_DEG

OUT_OF_STOCK = 0.005  # mm all round by which a part may reach out of its stock: rounding, chords
CUTTING_KEYS = ("material", "spindle_speed", "helix_angle_deg", "rapid_feed")


class Source:
    """Moves for the core, and what a G-code file says beside them."""

    def __init__(self, core, source, lines):
        self.is_gcode = isinstance(source, (str, os.PathLike))
        self.notes, self.spindle_speed, self.dwell_s = [], 0.0, 0.0
        if not self.is_gcode:
            self.moves = source if isinstance(source, core.Toolpath) else _listed(source)
            if self.moves is None:
                raise ValueError(
                    "The source is %r: give the path of a G-code file, a Toolpath or a list of"
                    " moves." % (source,)
                )
            self.lines = None if lines is None else numpy.asarray(lines, numpy.int64)
            if self.lines is not None and len(self.lines) != len(self.moves):
                raise ValueError(
                    "There are %d lines for %d moves: give one for each."
                    % (len(self.lines), len(self.moves))
                )
            return
        if lines is not None:
            raise ValueError("A G-code file has lines of its own: give 'lines' with moves only.")
        try:
            with open(source, encoding="utf-8", errors="replace") as file:
                text = file.read()
        except OSError as error:
            raise ValueError(
                "The G-code file '%s' cannot be read: %s." % (source, error.strerror)
            ) from None
        program = core.read_gcode(text)
        self.moves = program.moves
        if len(self.moves) < 2:
            raise ValueError("The G-code file '%s' has no moves." % source)
        self.lines = numpy.asarray(program.lines, numpy.int64)
        self.notes = ["Line %d: %s" % note for note in program.notes]
        speeds = {speed for speed in program.spindle_speeds if speed > 0}
        self.spindle_speed = min(speeds, default=0.0)
        if len(speeds) > 1:
            self.notes.append(
                "The program has several spindle speeds: the lowest, %g rev/min, was taken."
                % self.spindle_speed
            )
        self.dwell_s = program.dwell_s
        if self.dwell_s:
            self.notes.append(
                "Dwells of %g s count in the total times only, not in those of the samples."
                % self.dwell_s
            )
        if len({tool for tool in program.tools if tool}) > 1:
            self.notes.append("The program changes tools: all of it was simulated with one.")


def cutting_data(core, cutting, path):
    """Keyword arguments of the core for the cutting data."""
    if cutting is None:
        cutting = {}
    if not isinstance(cutting, dict):
        raise ValueError("The cutting data are %r: give a dictionary." % (cutting,))
    for key, value in cutting.items():
        if key not in CUTTING_KEYS:
            raise ValueError(
                "The cutting data have the unknown key '%s': they are %s."
                % (key, ", ".join(CUTTING_KEYS))
            )
        if key != "material" and value is not None:
            check_number("'%s' of the cutting data" % key, value)
    data = {}
    speed = cutting.get("spindle_speed") or path.spindle_speed
    if speed:
        data["spindle_speed"] = float(speed)
    if cutting.get("rapid_feed"):
        data["rapid_feed"] = float(cutting["rapid_feed"])
    if cutting.get("material") is not None:
        if not speed:
            raise ValueError(
                "The force of a material needs the spindle speed: give 'spindle_speed' in rev/min "
                "with the cutting data."
            )
        row = materials.load(cutting["material"])
        data["force"] = core.ForceCoefficients(row["ktc"], row["krc"], row["kte"], row["kre"])
        given = cutting.get("helix_angle_deg")
        helix = float(HELIX_ANGLE_DEG if given is None else given)
        data["helix_angle"] = math.radians(helix)
    return data


def check_within(stock, part):
    """Raises ValueError for a part that is not within its stock."""
    outlines = [chain for region, _ in part for chain in (region.outer, *region.islands)]
    around = sum(
        math.dist(a[:2], b[:2]) for chain in outlines for a, b in zip(chain, chain[1:] + chain[:1])
    )
    lacking = stock.area_lacking(part) if part else 0.0
    if lacking > OUT_OF_STOCK * around:
        raise ValueError(
            "The stock does not contain the part: %.3g mm2 of it lie outside; enlarge the stock."
            % lacking
        )


def earlier_cuts(core, earlier):
    """[(Source, tool diameter), ...] of what was cut beforehand."""
    cuts = _listed(earlier)
    if cuts is None or any(not isinstance(cut, (list, tuple)) or len(cut) != 2 for cut in cuts):
        raise ValueError("earlier must be a list of (source, tool diameter).")
    for _, diameter in cuts:
        check_number("The tool diameter of an earlier cut", diameter)
    return [(Source(core, source, None), diameter) for source, diameter in cuts]


def _listed(values):
    """A list of what can be gone through, None for what cannot."""
    try:
        iter(values)
    except TypeError:
        return None
    return list(values)


def prisms_of(core, shapes, top, what, may_be_none=False):
    """[(Region, top), ...] from what `simulate` takes as stock, part or fixtures."""
    if may_be_none and (shapes is None or (isinstance(shapes, (list, tuple)) and not shapes)):
        return []
    one = _region(core, shapes, what)
    if one is not None:
        return [(one, float(top))]
    if not isinstance(shapes, (list, tuple)) or not shapes:
        raise ValueError(
            "%s is %r: give a Region, a box (xmin, ymin, xmax, ymax), a chain of (x, y, bulge), or "
            "a list of these." % (what, shapes)
        )
    if len(shapes) == 2 and _is_number(shapes[1]):
        shapes = [shapes]
    prisms = []
    for item in shapes:
        height = top
        region = _region(core, item, what)
        if region is None and isinstance(item, (list, tuple)) and len(item) == 2:
            region, height = _region(core, item[0], what), item[1]
        if region is None or not _is_number(height):
            raise ValueError(
                "%s has the item %r: it must be a Region, a box or a chain, alone or with the "
                "height of its top." % (what, item)
            )
        prisms.append((region, float(height)))
    return prisms


def _region(core, shape, what):
    """A Region from a Region, a box or a chain; None for anything else."""
    if isinstance(shape, core.Region):
        return shape
    if not isinstance(shape, (list, tuple, numpy.ndarray)) or len(shape) < 2:
        return None
    if all(_is_number(value) for value in shape):
        if len(shape) != 4:
            raise ValueError("%s is no box: a box is (xmin, ymin, xmax, ymax)." % what)
        x0, y0, x1, y1 = (float(value) for value in shape)
        if not (x1 > x0 and y1 > y0):
            raise ValueError(
                "%s is an empty box: its xmax must be above its xmin, its ymax above its ymin."
                % what
            )
        return core.Region([(x0, y0, 0.0), (x1, y0, 0.0), (x1, y1, 0.0), (x0, y1, 0.0)])
    if not all(_is_vertex(p) for p in shape):
        return None
    return core.Region([(*p, 0.0) if len(p) == 2 else tuple(p) for p in shape])


def _is_vertex(p):
    """Whether p is (x, y), (x, y, bulge) or (x, y, bulge, open); four numbers are a box."""
    return (
        isinstance(p, (list, tuple, numpy.ndarray))
        and len(p) in (2, 3, 4)
        and all(map(_is_number, p[:3]))
        and (len(p) < 4 or isinstance(p[3], (bool, numpy.bool_)))
    )


def _is_number(value):
    return isinstance(value, (int, float, numpy.number)) and not isinstance(value, bool)


def check_number(name, value):
    if not _is_number(value):
        raise ValueError("%s must be a number, not %r." % (name, value))
