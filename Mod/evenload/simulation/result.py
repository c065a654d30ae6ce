"""What a simulation tells: the load sample by sample, and what it comes to."""

import math
from dataclasses import dataclass, field

import numpy

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
    walls: object = None  # for each sample whether it is of a cut along a wall, once that was asked
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


def simulation_of(record, figures, lines, teeth_per_minute):
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
