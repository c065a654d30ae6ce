"""The simulator: what a tool feels along a path, what it gouges, what it leaves. Needs no FreeCAD.

    import evenload
    run = evenload.simulate("pocket.ngc", stock=(0, 0, 60, 60), top=0, bottom=-3, tool_diameter=6,
                            teeth=2, cutting={"material": "Al7075-T6", "spindle_speed": 12000})
    run.max_engagement_deg, run.gouge_mm, run.engagement_deg.max()

docs/simulation.md has the method, its conventions and its limits.
"""

import math
import os
from dataclasses import dataclass, field

import numpy

from evenload import compiled, machines, materials
from evenload.tool import HELIX_ANGLE_DEG

RAPID_FEED = 5000.0  # mm/min, where neither the cutting data nor a machine has one
OUT_OF_STOCK = 0.005  # mm all round by which a part may reach out of its stock: rounding, chords
# mm between dexels where nobody says, and so many across the tool: the engagement of a tool of
# 0.5 mm in a stroke of 0.6 mm is within a degree then; with 0.05 mm it was 8 too large.
COARSEST, FINEST, IN_TOOL = 0.05, 0.005, 50
# mm between the dexels in which rest machining sees what is left, and so many in the width of a
# cut: of films thinner than what lies between dexels only pieces are seen, and fed for.
COARSEST_REST, FINEST_REST, REST_IN_CUT = 0.05, 0.02, 16
CUTTING_KEYS = ("material", "spindle_speed", "helix_angle_deg", "rapid_feed")
FORCES = (
    "force_peak",
    "force_mean",
    "force_x_peak",
    "force_y_peak",
    "torque_peak",
    "torque_mean",
    "power_mean",
)


@dataclass
class Simulation:
    """The load sample by sample (arrays of one length), and what it comes to.

    Samples lie at the start of each move, seen along it, and then at steps up to its end. Places
    are (x, y, z) in mm. Worst values are means over 0.1 mm of path. Forces are None without a
    material, the machine's times without a machine.
    """

    x: numpy.ndarray  # mm
    y: numpy.ndarray
    z: numpy.ndarray
    move: numpy.ndarray  # index among the moves; 0 is where the tool starts
    line: numpy.ndarray  # of the G-code, 0 where there is none
    kind: numpy.ndarray  # 0 rapid, 1 link, 2 entry, 3 cut
    length: numpy.ndarray  # mm of path since the sample before; 0 at a move's start
    feed: numpy.ndarray  # mm/min
    time_s: numpy.ndarray  # at the programmed feeds
    machine_time_s: object  # within the machine's limits
    engagement_deg: numpy.ndarray  # of the leading half circle; all round in plunges
    axial_depth: numpy.ndarray  # mm, of the deepest engaged arc
    removal_rate: numpy.ndarray  # mm3/min
    removed_volume: numpy.ndarray  # mm3 up to here
    h_max: numpy.ndarray  # mm, largest chip thickness; nan without a spindle speed
    h_mean: numpy.ndarray  # mm
    feed_per_tooth: numpy.ndarray  # mm; nan without a spindle speed
    gouge: numpy.ndarray  # mm into the part
    # Over a revolution of the spindle: N, N m, W; x and y are the machine's axes.
    force_peak: object
    force_mean: object
    force_x_peak: object
    force_y_peak: object
    torque_peak: object
    torque_mean: object
    power_mean: object
    # Sample i touches material along arcs[first_arc[i]:first_arc[i + 1]], rows of (exit, entry) in
    # degrees from the feed, left positive, and depth in mm. The spindle turns clockwise.
    arcs: numpy.ndarray
    first_arc: numpy.ndarray

    max_engagement_deg: float  # of cuts
    max_engagement_at: tuple
    link_engagement_deg: float  # of links
    link_engagement_at: tuple
    entry_engagement_deg: float  # of entries
    entry_engagement_at: tuple
    removal_rate_peak: float  # mm3/min, of cuts
    removal_rate_peak_at: tuple
    force_peak_max: object  # N, of cuts and entries
    force_peak_max_at: object
    gouge_mm: float
    gouge_at: tuple  # None where there is none, as all places
    fixture_mm: object  # into fixtures; None without any
    fixture_at: tuple
    rapid_in_material_mm: float  # of path
    rapid_in_material_at: tuple
    plunge_in_material_mm: float
    plunge_in_material_at: tuple
    incidents: list  # of (what, x, y, z, move, line, amount in mm), a move's worst
    rest_area: float  # mm2 that the tool could reach and that still stands; nan when cancelled
    rest_depth: float  # mm
    rest_at: tuple  # (x, y) of the largest patch
    rests: list  # of (area in mm2, x, y, depth in mm), the largest first
    rest_outlines: list  # polygons [(x, y), ...] that tile it
    unreachable_area: float  # mm2 in corners that the tool cannot reach
    cut_mm: float  # of path, with the air among it
    air_mm: float  # of cuts that meet no material
    link_mm: float
    entry_mm: float
    rapid_mm: float
    time_total_s: float
    machine_time_total_s: object
    removed_volume_total: float  # mm3
    removed_area: float  # mm2 on which nothing is left above the bottom
    cancelled: bool
    stock: object  # what is left, for another simulation
    stock_regions: list  # of the core's Region; empty where the stock was a simulation's
    part: list  # of (Region, top)
    tool_diameter: float  # mm
    top: float
    bottom: float
    notes: list = field(default_factory=list)  # sentences on what could not be taken as it is

    def arcs_at(self, i):
        """The engaged arcs of sample i, from right to left: rows of (exit, entry, depth)."""
        return self.arcs[self.first_arc[i] : self.first_arc[i + 1]]

    def figures(self):
        """What it comes to, as a dictionary for reports; units are in the keys."""
        return {
            "max_engagement_deg": self.max_engagement_deg,
            "link_engagement_deg": self.link_engagement_deg,
            "entry_engagement_deg": self.entry_engagement_deg,
            "removal_rate_peak_mm3_min": self.removal_rate_peak,
            "h_max_mm": _largest(self.h_max),
            "force_peak_max_n": self.force_peak_max,
            "torque_peak_nm": _largest(self.torque_peak),
            "power_mean_max_w": _largest(self.power_mean),
            "gouge_mm": self.gouge_mm,
            "fixture_mm": self.fixture_mm,
            "rest_area_mm2": None if self.cancelled else self.rest_area,
            "rest_depth_mm": None if self.cancelled else self.rest_depth,
            "rapid_in_material_mm": self.rapid_in_material_mm,
            "plunge_in_material_mm": self.plunge_in_material_mm,
            "cut_mm": self.cut_mm,
            "air_mm": self.air_mm,
            "link_mm": self.link_mm,
            "entry_mm": self.entry_mm,
            "rapid_mm": self.rapid_mm,
            "time_s": self.time_total_s,
            "machine_time_s": self.machine_time_total_s,
            "removed_volume_mm3": self.removed_volume_total,
            "cancelled": self.cancelled,
        }


def simulate(
    source,
    stock,
    top,
    bottom,
    tool_diameter,
    teeth=1,
    part=None,
    cutting=None,
    machine=None,
    resolution=None,
    step=0.1,
    *,
    fixtures=None,
    earlier=(),
    infer_kinds=None,
    lines=None,
    progress=None,
):
    """Runs a path through stock; returns a Simulation.

    source: the path of a G-code file, a Toolpath of the core, or a list of moves (kind, x, y, z,
        sweep, cx, cy, feed), the first of which says where the tool is; mm, rad, mm/min.
    stock: a Region, a box (xmin, ymin, xmax, ymax), a closed chain [(x, y, bulge), ...], or a list
        of these, from `bottom` to `top` or, as (what, height), to another height; or the upper side
        of a body as the core's HeightMap; or a Simulation, whose remaining stock is taken with its
        top, bottom and resolution.
    part: what must stay, in the same words; None or an empty list: nothing must stay. fixtures:
        what must not be touched, likewise.
    cutting: {"material": see materials.load, "spindle_speed": rev/min, "helix_angle_deg",
        "rapid_feed": mm/min}, each as far as known. A G-code file's own spindle speed is taken
        where there is none here.
    machine: see machines.load.
    resolution: mm between dexels, None: by the tool, see default_resolution.
    step: mm of path between samples at the most.
    earlier: [(source, tool diameter), ...]: cut beforehand.
    infer_kinds: whether links and entries are told from cuts by what the moves do; None: in G-code.
    lines: for each of the moves a line to be reported with it.
    progress: callable(share) -> bool, False cancels.

    Raises ValueError with a sentence, which names the move or the line, for what cannot be used.
    """
    core = compiled.core()
    sizes = {"tool_diameter": tool_diameter, "top": top, "bottom": bottom}
    if resolution is not None:
        sizes["resolution"] = resolution
    for name, value in {**sizes, "step": step}.items():
        _check_number(name, value)
    if resolution is None:
        resolution = default_resolution(tool_diameter)
    if isinstance(teeth, bool) or not isinstance(teeth, (int, numpy.integer)):
        raise ValueError("teeth must be a whole number, not %r." % (teeth,))
    path = _Path(core, source, lines)
    data = _cutting(core, cutting, path)
    profile = None
    if machine is not None:
        limits = machines.load(machine)
        data.setdefault("rapid_feed", limits["rapid_feed"])
        limits["rapid_feed"] = min(limits["rapid_feed"], data["rapid_feed"])
        profile = core.MachineProfile(**limits)
    data.setdefault("rapid_feed", RAPID_FEED)

    stock_regions = []
    if isinstance(stock, Simulation):
        dexels = stock.stock.copy()
        top, bottom = dexels.top, dexels.bottom
        prisms = prisms_of(core, part, top, "The part", may_be_none=True)
    else:
        prisms = prisms_of(core, part, top, "The part", may_be_none=True)
        if isinstance(stock, core.HeightMap):
            blocks = stock
        else:
            blocks = prisms_of(core, stock, top, "The stock")
            stock_regions = [region for region, _ in blocks]
        dexels = core.DexelStock(blocks, bottom, resolution)
        _check_within(dexels, prisms)
    before = _earlier(core, earlier)
    for cut, diameter in before:
        core.simulate(
            cut.moves, dexels, tool_diameter=diameter, step=_coarse(diameter), find_rest=False
        )

    record, figures, cancelled = core.simulate(
        path.moves,
        dexels,
        tool_diameter=tool_diameter,
        teeth=teeth,
        step=step,
        infer_kinds=path.is_gcode if infer_kinds is None else infer_kinds,
        part=prisms,
        fixtures=prisms_of(core, fixtures, top, "The fixture", may_be_none=True),
        machine=profile,
        progress=progress,
        **data,
    )
    speed = data.get("spindle_speed", 0.0)
    result = _simulation(record, figures, path.lines, speed * teeth)
    if fixtures is None:
        result.fixture_mm = None
    if cancelled:  # the rest was not looked for
        result.cancelled = True
        result.rest_area = result.rest_depth = result.unreachable_area = math.nan
    if path.dwell_s:
        result.time_total_s += path.dwell_s
        if result.machine_time_total_s is not None:
            result.machine_time_total_s += path.dwell_s
    result.stock, result.stock_regions, result.part = dexels, stock_regions, prisms
    result.tool_diameter, result.top, result.bottom = float(tool_diameter), dexels.top, bottom
    result.notes = [
        *path.notes,
        *("Earlier cut: " + note for cut, _ in before for note in cut.notes),
    ]
    return result


def of(operation, **options):
    """The Simulation of a FreeCAD Path operation, with all that its Job knows of it; see
    job_simulation.of for the options.
    """
    from evenload import job_simulation

    return job_simulation.of(operation, **options)


class _Path:
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


def _cutting(core, cutting, path):
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
            _check_number("'%s' of the cutting data" % key, value)
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


def default_resolution(tool_diameter):
    """mm between the dexels of a stock that a tool is simulated in."""
    return max(FINEST, min(COARSEST, tool_diameter / IN_TOOL))


def rest_resolution(cut_width):
    """mm between the dexels of a stock that is to be cleared by cuts `cut_width` mm wide, > 0."""
    return max(FINEST_REST, min(COARSEST_REST, cut_width / REST_IN_CUT))


def _check_within(stock, part):
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


def _earlier(core, earlier):
    """[(_Path, tool diameter), ...] of what was cut beforehand."""
    cuts = _listed(earlier)
    if cuts is None or any(not isinstance(cut, (list, tuple)) or len(cut) != 2 for cut in cuts):
        raise ValueError("earlier must be a list of (source, tool diameter).")
    for _, diameter in cuts:
        _check_number("The tool diameter of an earlier cut", diameter)
    return [(_Path(core, source, None), diameter) for source, diameter in cuts]


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


def _check_number(name, value):
    if not _is_number(value):
        raise ValueError("%s must be a number, not %r." % (name, value))


def _coarse(diameter):
    """mm: the step where the load does not matter; the swept ground is exact at any."""
    return max(0.1, 0.25 * diameter)


def _simulation(record, figures, lines, teeth_per_minute):
    """The Simulation of what the core returned; what `simulate` knows itself is still missing."""
    size = len(record["x"])
    arcs = record["arcs"]
    arcs[:, :2] = numpy.degrees(arcs[:, :2])
    nothing = numpy.full(size, math.nan)
    known = teeth_per_minute > 0
    with_force = len(record["force_peak"]) == size and size > 0
    with_machine = len(record["machine_time"]) == size and size > 0
    line = numpy.zeros(size, numpy.int64) if lines is None else lines[record["move"]]

    def degrees(name):
        return math.degrees(figures[name][0])

    def place(name):
        value, at = figures[name]
        return at if value > 0 else None

    same = ("x", "y", "z", "move", "kind", "length", "feed", "axial_depth", "removal_rate")
    return Simulation(
        **{name: record[name] for name in (*same, "removed_volume", "gouge", "first_arc")},
        **{name: record[name] if with_force else None for name in FORCES},
        line=line,
        time_s=record["time"],
        machine_time_s=record["machine_time"] if with_machine else None,
        engagement_deg=numpy.degrees(record["engagement"]),
        h_max=record["h_max"] if known else nothing,
        h_mean=record["h_mean"] if known else nothing,
        feed_per_tooth=record["feed"] / teeth_per_minute if known else nothing,
        arcs=arcs,
        max_engagement_deg=degrees("engagement"),
        max_engagement_at=place("engagement"),
        link_engagement_deg=degrees("link_engagement"),
        link_engagement_at=place("link_engagement"),
        entry_engagement_deg=degrees("entry_engagement"),
        entry_engagement_at=place("entry_engagement"),
        removal_rate_peak=figures["removal_rate"][0],
        removal_rate_peak_at=place("removal_rate"),
        force_peak_max=figures["force"][0] if with_force else None,
        force_peak_max_at=place("force") if with_force else None,
        gouge_mm=figures["gouge"][0],
        gouge_at=place("gouge"),
        fixture_mm=figures["fixture"][0],
        fixture_at=place("fixture"),
        rapid_in_material_mm=figures["rapid_in_material"][0],
        rapid_in_material_at=place("rapid_in_material"),
        plunge_in_material_mm=figures["plunge_in_material"][0],
        plunge_in_material_at=place("plunge_in_material"),
        incidents=[
            (what, *at, move, int(lines[move]) if lines is not None else 0, amount)
            for what, at, move, amount in figures["incidents"]
        ],
        rest_area=figures["rest_area"],
        rest_depth=figures["rest_depth"],
        rest_at=figures["rests"][0][1:3] if figures["rests"] else None,
        rests=figures["rests"],
        rest_outlines=figures["rest_outlines"],
        unreachable_area=figures["unreachable_area"],
        cut_mm=figures["cut_length"],
        air_mm=figures["air_length"],
        link_mm=figures["link_length"],
        entry_mm=figures["entry_length"],
        rapid_mm=figures["rapid_length"],
        time_total_s=figures["time"],
        machine_time_total_s=figures["machine_time"] if with_machine else None,
        removed_volume_total=figures["removed_volume"],
        removed_area=figures["removed_area"],
        cancelled=False,
        stock=None,
        stock_regions=[],
        part=[],
        tool_diameter=math.nan,
        top=math.nan,
        bottom=math.nan,
    )


def _largest(values):
    """The largest of an array of numbers; None without one."""
    if values is None or len(values) == 0 or numpy.isnan(values).all():
        return None
    return float(numpy.nanmax(values))
