"""One path of a tool at an angle, and what depth, feed and spindle speed make of it: its times and
loads without computing it anew. Needs no FreeCAD.

Seen from above a path depends on the tool's diameter and the engagement angle alone, but for
places where feed control and links weigh seconds. So

- levels repeat: every level of one height is the same moves further down;
- feeds of cuts and entries are proportional to the feed; so are chips, and the part of the forces
  that grows with them;
- what touches the tool in a cut reaches from the floor to the level's top: arcs are as deep as
  the level is high. Entries slope, and are run for each height.

docs/optimisation.md has the reasoning and how far it holds.
"""

import math

import numpy

from evenload.planar import CUT, ENTRY, RAPID

SAFE, CLEARANCE = 3.0, 5.0  # mm above the top: of retracts, of ways from region to region
WINDOW = 0.1  # mm of path, as in src/simulate/load_record.h
KIND, X, Y, Z, SWEEP, CX, CY, FEED = range(8)  # columns of moves


class ScaledPath:
    """The path of `tool` at `engagement_deg` for levels of any of `heights`, with helices stretched
    for the highest.
    """

    def __init__(self, core, regions, tool, engagement_deg, heights, settings, progress):
        self.core, self.settings = core, settings
        self.diameter = tool.diameter
        self.heights = sorted(heights, reverse=True)
        floors = numpy.cumsum(self.heights)
        self.feed = tool.reference_feed
        path = core.clear_pocket(
            regions,
            tool_diameter=tool.diameter,
            engagement_angle=math.radians(engagement_deg),
            cut_mode=settings.cut_mode,
            feed_control=settings.feed_control,
            feed=self.feed,
            plunge_feed=settings.entry_feed * self.feed,
            link_feed=settings.link_feed,
            maximum_feed=settings.maximum_feed * self.feed,
            rapid_feed=settings.rapid_feed,
            roll_radius=settings.roll_radius * tool.diameter,
            minimum_radius=settings.roll_radius * tool.diameter,
            helix_diameter=0.9 * tool.diameter,
            levels=[-float(z) for z in floors],
            safe_height=SAFE,
            clearance_height=CLEARANCE,
            progress=progress,
            **settings.entry(tool.diameter),
        )
        self.report = path.report
        self.cancelled = path.report.termination == "cancelled"
        if self.cancelled:
            return
        self.ideal_time = path.report.ideal_time / len(self.heights)  # s a level, at `feed`
        self._regions = self._taken_apart(numpy.array(path.moves), floors)
        self.feed_share = max(
            (run[:, FEED] / self.feed)[run[:, KIND] == CUT].max(initial=0.0)
            for region in self._regions
            for runs in region
            for run in runs
        )

    # ---- moves ----

    def _taken_apart(self, moves, floors):
        """[region][height] -> runs: moves from a rapid over the descent to before the retract, with
        z from the level's top.
        """
        result, begin = [[[] for _ in floors]], 0
        for end in range(1, len(moves)):
            z = moves[end, Z]
            if moves[end, KIND] != RAPID or z < SAFE or z == moves[end - 1, Z]:
                continue
            if z == CLEARANCE:
                result.append([[] for _ in floors])
            else:
                run = moves[begin:end].copy()
                level = int(numpy.argmin(abs(floors + run[:, Z].min())))
                run[run[:, Z] < SAFE, Z] += floors[level] - self.heights[level]
                result[-1][level].append(run)
            begin = end + 1
        return [region for region in result if region[0]]

    def moves(self, height, levels, feed, part=None):
        """The moves at `levels` levels of one of the heights, as an array of their rows; part: what
        to take of each run instead of all.
        """
        pieces = []
        for region in self._regions:
            runs = region[self.level_of(height)]
            if part:
                runs = [run for run in map(part, runs) if len(run)]
            for k in range(levels):
                for number, run in enumerate(runs):
                    first = k == 0 and number == 0
                    pieces.append(_lowered(run, CLEARANCE if first else SAFE, -k * height))
                    pieces.append(_retracted(run, SAFE))
            if runs:
                pieces.append(_retracted(runs[-1], CLEARANCE))
        if not pieces:
            return numpy.zeros((0, FEED + 1))
        result = numpy.concatenate(pieces)
        scaled = numpy.isin(result[:, KIND], (CUT, ENTRY))
        result[scaled, FEED] *= feed / self.feed
        return result

    def level_of(self, height):
        return int(numpy.argmin([abs(height - known) for known in self.heights]))

    def entries(self, height):
        """The moves of one level without what follows the entries of each run; none without any."""
        return self.moves(height, 1, self.feed, lambda run: run[: _end_of_entry(run)])

    def count(self, levels):
        """{"passes", "links", "retracts"} at so many levels."""
        runs = sum(len(region[0]) for region in self._regions)
        return {
            "passes": self.report.passes // len(self.heights) * levels,
            "links": self.report.links // len(self.heights) * levels,
            "retracts": max(0, runs * levels - 1),
        }

    # ---- times ----

    def times(self, height, levels, feed, profile=None):
        """(s at the programmed feeds, s within a machine's limits; None without its profile)."""
        moves = self.moves(height, levels, feed)
        programmed = _duration(moves, self.settings.rapid_feed)
        if profile is None:
            return programmed, None
        start, duration, *_ = self.core.machine_time(_listed(moves), profile)[-1]
        return programmed, start + duration


def _end_of_entry(run):
    entries = numpy.flatnonzero(run[:, KIND] == ENTRY)
    return entries[-1] + 1 if len(entries) else 0


def _lowered(run, above, top):
    """A run whose level begins at `top`, from a place at the height `above`."""
    moved = run.copy()
    inside = moved[:, Z] < SAFE
    moved[inside, Z] += top
    moved[~inside, Z] = above
    return moved


def _retracted(run, z):
    """The rapid up from the end of a run."""
    move = run[-1].copy()
    move[[KIND, SWEEP, FEED]] = RAPID, 0.0, 0.0
    move[Z] = z
    return move[None, :]


def _duration(moves, rapid_feed):
    """s of all moves at their programmed feeds, but for the first, which says where the tool is."""
    across = numpy.hypot(*numpy.diff(moves[:, X : Y + 1], axis=0).T)
    radius = numpy.hypot(*(moves[1:, X : Y + 1] - moves[1:, CX : CY + 1]).T)
    turned = moves[1:, SWEEP] != 0
    flat = numpy.where(turned, abs(moves[1:, SWEEP]) * radius, across)
    feed = numpy.where(moves[1:, KIND] == RAPID, rapid_feed, moves[1:, FEED])
    return float((60 * numpy.hypot(flat, numpy.diff(moves[:, Z])) / feed).sum())


def _listed(moves):
    return [(int(move[0]), *move[1:]) for move in moves.tolist()]


class Samples:
    """The samples of one kind of a simulation's record, and means along the path between them."""

    def __init__(self, record, kind, feed):
        kept = record["kind"] == kind
        counts = numpy.diff(record["first_arc"])
        self.arcs = record["arcs"][numpy.repeat(kept, counts)]
        self.first = numpy.concatenate(([0], numpy.cumsum(counts[kept])))
        self.share = record["feed"][kept] / feed  # of the nominal feed
        begins = kept & ~numpy.concatenate(([False], kept[:-1]))
        self._length = record["length"][kept]
        self._along = numpy.cumsum(self._length)
        stretch = numpy.cumsum(begins)[kept] - 1
        self._window = numpy.maximum(self._along - WINDOW, self._along[begins[kept]][stretch])
        across = (self.arcs[:, 0] <= 0) & (self.arcs[:, 1] >= 0)
        cosines = numpy.cos(self.arcs[:, :2])
        thickest = numpy.where(across, 1.0, cosines.max(axis=1, initial=0.0))
        self.widest = numpy.zeros(len(self.share))  # chip per feed per tooth
        numpy.maximum.at(self.widest, self._sample_of_arcs(), thickest)

    def _sample_of_arcs(self):
        return numpy.repeat(numpy.arange(len(self.share)), numpy.diff(self.first))

    def sums(self, of_arcs):
        """What values of arcs add up to at each sample."""
        return numpy.bincount(self._sample_of_arcs(), of_arcs, minlength=len(self.share))

    def mean(self, values):
        """Means over the last WINDOW mm of path, on which values run straight between samples."""
        pieces = 0.5 * self._length * (values + numpy.concatenate(([0.0], values[:-1])))
        area = numpy.cumsum(pieces)
        return (area - numpy.interp(self._window, self._along, area)) / WINDOW


class Loads:
    """What a tool feels along a scaled path. Figures are means over WINDOW mm, as the simulator's
    engagement is: where the tool turns in a sharp corner, a load that lasts less than a chip's
    thickness of path does not count in full.
    """

    def __init__(self, path, regions, model, tool, coefficients, hole, resolution):
        self._path, self._model, self._tool = path, model, tool
        self._edge = coefficients
        self._regions, self._hole, self._resolution = regions, hole, resolution
        self._entries, self._peaks = {}, {}  # what was asked for before
        self._reference = path.heights[0]
        record, standing = self._run(path.moves(self._reference, 1, path.feed), self._reference)
        self._cuts = Samples(record, CUT, path.feed)
        self._entries[path.level_of(self._reference)] = Samples(record, ENTRY, path.feed)
        self.left_area = standing / self._reference  # mm2 that the tool leaves, or cannot reach

    def _run(self, moves, height):
        """The record of moves through a level of the pocket, and mm3 that then still stand."""
        stock = self._path.core.DexelStock(
            [(region, 0.0) for region in self._regions], -height, self._resolution
        )
        if self._hole:
            stock.drill(*self._hole)
        record, _, _ = self._path.core.simulate(
            _listed(moves), stock, tool_diameter=self._path.diameter, find_rest=False
        )
        return record, stock.volume

    def at(self, height):
        """[(samples, what to multiply the depths of their arcs by)] of cuts and of entries."""
        level = self._path.level_of(height)
        if level not in self._entries:
            moves = self._path.entries(height)
            record = self._run(moves, height)[0] if len(moves) else None
            self._entries[level] = record and Samples(record, ENTRY, self._path.feed)
        kinds = [(self._cuts, height / self._reference), (self._entries[level], 1.0)]
        return [(samples, deeper) for samples, deeper in kinds if samples and len(samples.share)]

    def chip(self, height):
        """Largest chip thickness per feed per tooth; 0 where nothing is cut."""
        return max(
            (samples.mean(samples.widest * samples.share).max() for samples, _ in self.at(height)),
            default=0.0,
        )

    def mean_torque(self, height):
        """(per mm of feed per tooth, at none): N m over a revolution, along the path."""
        tool, edge = self._tool, self._edge
        lever = 1e-3 * 0.5 * tool.diameter * tool.teeth / (2 * math.pi)
        rising, constant = [], []
        for samples, deeper in self.at(height):
            low, high, depth = samples.arcs.T
            chip = samples.sums(depth * (numpy.sin(high) - numpy.sin(low))) * samples.share
            rising.append(samples.mean(deeper * lever * edge.ktc * chip))
            constant.append(
                samples.mean(deeper * lever * edge.kte * samples.sums(depth * (high - low)))
            )
        return numpy.concatenate(rising), numpy.concatenate(constant)

    def peaks(self, height, feed_per_tooth):
        """(N, N m): the largest within a revolution, along the path."""
        known = self._path.level_of(height), feed_per_tooth
        if known not in self._peaks:
            self._peaks[known] = self._peaks_at(height, feed_per_tooth)
        return self._peaks[known]

    def _peaks_at(self, height, feed_per_tooth):
        forces, torques = [], []
        for samples, deeper in self.at(height):
            arcs = samples.arcs * (1.0, 1.0, deeper)
            force, torque = self._model.peaks(arcs, samples.first, samples.share * feed_per_tooth)
            forces.append(samples.mean(force))
            torques.append(samples.mean(torque))
        return numpy.concatenate(forces), numpy.concatenate(torques)

    def largest_feed(self, height, least, largest, limits):
        """(feed per tooth, index of the limit that binds): the largest within [least, largest]
        whose peaks (N, N m) keep both limits; (None, index) where even `least` exceeds one.

        Peaks are convex in the feed: a chord lies above them, so that a feed at which the chords
        keep the limits keeps them, too. The chords are drawn anew from there until they gain less
        than a thousandth.
        """
        high = self.peaks(height, largest)
        if all(values.max() <= limit for values, limit in zip(high, limits)):
            return largest, None
        low = self.peaks(height, least)
        for index, (values, limit) in enumerate(zip(low, limits)):
            if values.max() > limit:
                return None, index
        feed, binding = least, None
        while True:
            gain = math.inf
            for index, limit in enumerate(limits):
                rise = high[index] - low[index]
                steep = rise > 0
                room = (limit - low[index][steep]) / rise[steep]
                if len(room) and room.min() < gain:
                    gain, binding = float(room.min()), index
            gain = min(gain, 1.0) * (largest - feed)
            feed += gain
            if gain <= 1e-3 * feed:
                return feed, binding
            low = self.peaks(height, feed)
