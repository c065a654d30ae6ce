"""The search: every tool at every angle, depth and speed. Needs no FreeCAD."""

import itertools
import math
import queue
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from evenload import compiled
from evenload.optimisation import chatter, inputs
from evenload.optimisation.result import LIMITS, Candidate, Optimisation
from evenload.optimisation.scaled_path import Loads, ScaledPath
from evenload.waiting import Stopped

ROUNDING = 1e-9  # a share of a feed


def optimise(
    region,
    tools,
    materials,
    machine=None,
    *,
    depth=None,
    engagement_deg=(30, 45, 60, 75, 90),
    axial_depths=None,
    spindle_speeds=None,
    feed=None,
    max_force=None,
    max_torque=None,
    max_power=None,
    max_left_area=None,
    hole=None,
    cut_mode="climb",
    feed_control="constant feed",
    maximum_feed=2.0,
    entry_feed=0.5,
    link_feed=None,
    roll_radius=0.15,
    modes=None,
    stability_margin=0.05,
    resolution=0.1,
    workers=None,
    progress=None,
):
    """Tries every tool at every angle, depth and spindle speed; returns an Optimisation.

    region: a Region, a box (xmin, ymin, xmax, ymax), a chain [(x, y, bulge), ...], a list of these,
        or one of EvenLoad's operations, computed.
    tools: dictionaries, see docs/optimisation.md for their keys.
    materials: a material as materials.load takes it, or a list of one for each tool.
    machine: see machines.load and machines.spindle; None: no limits but those given here.
    depth: mm, of the pocket. None: the operation's, else the shortest cutting length.
    axial_depths: mm, at the most; the pocket is cut in equal levels no deeper. None: the four
        fewest levels that a tool can do.
    spindle_speeds: rev/min. None: five, over the range of the tool's surface speed.
    feed: mm/min at the angle that all are judged at; None: each at the largest within the limits.
    max_force, max_torque, max_power: N, N m, W; max_left_area: mm2 that may be left or out of
        reach. None: no limit.
    hole: (x, y, diameter), drilled before.
    maximum_feed, entry_feed: of the feed at the angle, as MaximumFeed and the descents' feed.
    link_feed: mm/min; None: the rapid feed. roll_radius: as a share of the tool's diameter.
    modes: what vibrates at the tip of tools that do not say so themselves, as vibration.load takes
        it; None: chatter is not looked at. stability_margin: a cut's largest multiplier stays below
        1 less this, in all feed directions of its path.
    workers: threads; None: one for each core.
    progress: callable(share) -> bool, False cancels; called by the calling thread.

    Raises ValueError with a sentence for what cannot be used and for tools none of which fits.
    """
    task = inputs.checked(compiled.core(), **locals())
    count = len(task.tools) * len(task.engagement_deg)
    shares, events, stop = [0.0] * count, queue.Queue(), threading.Event()

    def run(number, tool, angle):
        def watch(share):
            events.put((number, 0.6 * share))
            return not stop.is_set()

        try:
            return _candidates(task, tool, angle, watch)
        except BaseException:  # which the others need not wait for
            stop.set()
            raise
        finally:
            events.put((number, 1.0))

    with ThreadPoolExecutor(task.workers) as pool:
        pairs = itertools.product(task.tools, task.engagement_deg)
        futures = [pool.submit(run, n, *pair) for n, pair in enumerate(pairs)]
        try:
            while min(shares) < 1.0:
                number, share = events.get()
                shares[number] = max(shares[number], share)
                if progress and not stop.is_set() and not progress(sum(shares) / count):
                    stop.set()
        except BaseException:
            stop.set()
            raise
    return _result(task, [future.result() for future in futures])


def _result(task, found):
    result = Optimisation([], notes=list(task.notes))
    result.cancelled = any(rows is None for rows in found)
    result.candidates = [row for rows in found for row in rows or ()]
    allowed = [c for c in result.candidates if not c.refused]
    if allowed:
        result.best = min(allowed, key=lambda c: c.seconds)
    elif result.candidates:
        causes = Counter(c.refused_by for c in result.candidates)
        cause, count = causes.most_common(1)[0]
        if causes["tool size"] == len(result.candidates) and not result.cancelled:
            raise ValueError(result.candidates[-1].refused)
        result.why = "No candidate is within the limits: %s refuses most, %d of %d, as in: %s" % (
            *(LIMITS[cause], count, len(result.candidates)),
            next(c.refused for c in result.candidates if c.refused_by == cause),
        )
    return result


def _candidates(task, tool, angle, watch):
    """The candidates of a tool at an angle; None when cancelled."""
    if not watch(0.0):
        return None
    rows = []
    for levels, speed in itertools.product(tool.levels, tool.speeds):
        surface = 1e-3 * math.pi * tool.diameter * speed
        height = task.depth / levels
        row = Candidate(
            *(tool.name, tool.diameter, tool.teeth, angle, levels, height, speed, surface)
        )
        _refuse(row, *tool.refusal(height, speed))
        rows.append(row)
    possible = [row for row in rows if not row.refused]
    if not possible:
        return rows
    core = task.core
    edge = core.ForceCoefficients(*(tool.material[key] for key in ("ktc", "krc", "kte", "kre")))
    helix = math.radians(tool.helix_angle_deg)
    model = core.ForceModel(edge, 0.5 * tool.diameter, tool.teeth, helix)
    groups = [
        (height, list(group))
        for height, group in itertools.groupby(possible, lambda row: row.axial_depth)
    ]
    for k, (height, group) in enumerate(groups):
        # How far a helix is stretched depends on the height: each has a path of its own.
        try:
            path = ScaledPath(
                *(core, task.regions, tool, angle, {height}, task),
                lambda share: watch((k + share) / len(groups)),
            )
        except core.GeometryError as error:
            if error.code != "tool too large":
                raise
            for row in possible:
                _refuse(row, "tool size", str(error))
            return rows
        if path.cancelled:
            return None
        if tool.modes:
            try:
                share = (k + 0.5) / len(groups)
                for row, why in chatter.judge(group, tool, path, height, task, _at(watch, share)):
                    _refuse(row, "chatter", why)
            except Stopped:
                return None
            group = [row for row in group if not row.refused]
            if not group:
                continue
        loads = Loads(path, task.regions, model, tool, edge, task.hole, task.resolution)
        if not watch((k + 1) / len(groups)):
            return None
        _LevelOf(task, tool, path, loads, height).fill(group)
    return rows


def _at(watch, share):
    """Asks `watch` with the same share all along."""
    return lambda _: watch(share)


def _refuse(row, cause, sentence):
    if cause and not row.refused:
        row.refused_by, row.refused = cause, sentence


class _LevelOf:
    """What the spindle speeds of one tool, angle and height have in common."""

    def __init__(self, task, tool, path, loads, height):
        self.task, self.tool, self.path = task, tool, path
        self.loads, self.height = loads, height
        chip = loads.chip(height)
        if not chip:
            raise ValueError(
                "The path of the tool of %g mm touches no material: check the region and the hole."
                % tool.diameter
            )
        self.chip = chip
        self.least = tool.min_chip_thickness / chip
        self.most = tool.max_chip_thickness / chip
        limits = task.max_force, task.max_torque
        feed, index = loads.largest_feed(height, self.least, self.most, limits)
        self.by_peaks = feed, ("force", "torque")[index] if index is not None else "chip thickness"
        self.per_feed, self.at_none = loads.mean_torque(height)

    def fill(self, rows):
        for row in rows:
            self._set_feed(row)
            self._set_figures(row)

    def _set_feed(self, row):
        """The largest feed per tooth within the limits, the least where that is above one; or the
        feed that is asked for.
        """
        per_minute = row.spindle_speed * row.teeth
        turning = row.spindle_speed * 2 * math.pi / 60
        mean_torque = self.task.max_power / turning
        room = mean_torque - self.at_none
        rising = self.per_feed > 0
        bounds = [
            self.by_peaks,
            (float((room[rising] / self.per_feed[rising]).min()), "power"),
            (self.task.max_feed / (per_minute * self.path.feed_share), "machine feed"),
        ]
        feed, row.bound_by = min(
            ((-math.inf if feed is None else feed, name) for feed, name in bounds),
            key=lambda bound: bound[0],
        )
        if self.task.feed is None:
            wanted, at = self.least, "At the least chip of %g mm" % self.tool.min_chip_thickness
            row.feed_per_tooth = max(feed, wanted)
        else:
            wanted, at = self.task.feed / per_minute, "At %.5g mm/min" % self.task.feed
            row.feed_per_tooth = wanted
        # The largest feed itself, per minute and back, may come out larger by rounding.
        if feed < wanted * (1 - ROUNDING):
            _refuse(row, row.bound_by, "%s %s" % (at, self._too_much(row)))
        elif self.task.feed is not None:
            row.bound_by = ""
        row.feed = row.feed_per_tooth * per_minute

    def _too_much(self, row):
        over = {
            "chip thickness": "%g mm" % self.tool.max_chip_thickness,
            "force": "%g N" % self.task.max_force,
            "torque": "%g N m" % self.task.max_torque,
            "power": "%g W" % self.task.max_power,
            "machine feed": "%g mm/min" % self.task.max_feed,
        }
        return "%s of the tool of %g mm at %g°, %.3g mm deep, is above %s." % (
            *(LIMITS[row.bound_by], row.diameter, row.engagement_deg, row.axial_depth),
            over[row.bound_by],
        )

    def _set_figures(self, row):
        force, torque = self.loads.peaks(self.height, row.feed_per_tooth)
        mean_torque = self.at_none + row.feed_per_tooth * self.per_feed
        row.force_peak_n, row.torque_peak_nm = float(force.max()), float(torque.max())
        row.power_w = float(mean_torque.max()) * row.spindle_speed * 2 * math.pi / 60
        row.h_max_mm = self.chip * row.feed_per_tooth
        row.time_s, row.machine_time_s = self.path.times(
            self.height, row.levels, row.feed, self.task.profile
        )
        ideal = self.path.ideal_time * row.levels * self.path.feed / row.feed
        row.ratio = row.time_s / ideal
        row.left_area_mm2 = self.loads.left_area
        for name, value in self.path.count(row.levels).items():
            setattr(row, name, value)
        if row.left_area_mm2 > self.task.max_left_area:
            _refuse(
                row,
                "left area",
                "The tool of %g mm leaves %.3g mm2, above the %g mm2 allowed."
                % (row.diameter, row.left_area_mm2, self.task.max_left_area),
            )
