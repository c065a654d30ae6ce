"""Floors at several depths: cut one depth after the other, the highest first, as one toolpath.

The core cuts all the regions that it is given to one depth. A floor within the ground of a higher
one, such as the pocket in the floor of another, begins where that one ends, if all of that was
cleared. Any other is cut as if nothing had been cut before; where something has been, that is air.
"""

from dataclasses import dataclass, field, replace

from evenload import findings
from evenload.geometry.floor import LEAST_OVERLAP, SAME_HEIGHT, face_of
from evenload.operations import checks
from evenload.words import listed

COMPLETE, CANCELLED = "complete", "cancelled"  # terminations, as the core has them
SUMS = (
    "cutting_time",
    "ideal_time",
    "removed_volume",
    "uncut_area",
    "cut_length",
    "link_length",
    "passes",
    "links",
    "retracts",
)


@dataclass
class Cut:
    """What one call of the core has cut."""

    floors: list  # of Floor, at one depth
    regions: list  # the core's
    levels: list  # mm, descending
    toolpath: object  # the core's
    own: dict  # {name: value} of results and fitted settings of its kind of operation
    material: list  # the core's Regions where material stood at the lowest level

    @property
    def area(self):
        """mm2 of its regions."""
        return sum(region.area for region in self.regions)


@dataclass
class JoinedReport:
    """The reports of several toolpaths as one, as the core has one."""

    termination: str
    max_engagement: float  # rad
    cutting_time: float = 0.0  # s
    ideal_time: float = 0.0
    removed_volume: float = 0.0  # mm3
    uncut_area: float = 0.0  # mm2
    cut_length: float = 0.0  # mm
    link_length: float = 0.0
    passes: int = 0
    links: int = 0
    retracts: int = 0


@dataclass
class JoinedToolpath:
    """Several toolpaths as one: each begins and ends at the clearance height."""

    moves: list
    report: JoinedReport = field(repr=False)

    def __len__(self):
        return len(self.moves)

    def __iter__(self):
        return iter(self.moves)


def clear(proxy, settings, core, tool, floors, arguments, standing):
    """The Cuts of an operation, in their order; where it was stopped the last one is cancelled.

    settings: the operation's, by their names; arguments: for the core, but for heights and stock;
    standing: rest.Standing of what others left, or None where material stands all over the floors.
    Raises ValueError for a floor with nothing to
    cut.
    """
    cuts, watch = [], arguments["progress"]
    depths = _distinct(floor.depth for floor in floors)
    for number, depth in enumerate(depths):
        here = [floor for floor in floors if abs(floor.depth - depth) <= SAME_HEIGHT]
        progress = _share_of(watch, number, len(depths))
        for top, group in _by_top(settings, here, cuts if standing is None else []):
            regions = [floor.region() for floor in group]
            levels = checks.levels(settings, top, depth, [floor.name for floor in group])
            given = {**arguments, "top": top, "levels": levels, "progress": progress}
            material = regions
            if standing is not None:
                given["stock"] = standing.at(settings, core, tool, regions, levels, group)
                material = next(filter(None, reversed(given["stock"])), [])
            toolpath, own = proxy.generate(settings, core, regions, given)
            cuts.append(Cut(group, regions, levels, toolpath, own, material))
            if toolpath.report.termination == CANCELLED:
                return cuts
            if standing is not None and number + 1 < len(depths):
                standing.cut(core, tool, toolpath)
    return cuts


def joined(cuts):
    """The toolpath of all cuts, the core's own where there is but one."""
    if len(cuts) == 1:
        return cuts[0].toolpath
    paths = [cut.toolpath for cut in cuts]
    reports = [path.report for path in paths]
    incomplete = (r.termination for r in reports if r.termination != COMPLETE)
    report = JoinedReport(
        next(incomplete, COMPLETE),
        max(r.max_engagement for r in reports),
        **{name: sum(getattr(r, name) for r in reports) for name in SUMS},
    )
    report.retracts += max(0, sum(1 for path in paths if len(path)) - 1)
    return JoinedToolpath([move for path in paths for move in path.moves], report)


def notes(cuts):
    """What Report says of floors that are cut to different depths, and of what the core found."""
    found = [note for cut in cuts for note in _found(cut, len(cuts) > 1)]
    return _depths_of_floors(cuts), list(dict.fromkeys(found))


def _depths_of_floors(cuts):
    depths = _distinct(cut.levels[-1] for cut in cuts)
    if len(depths) < 2:
        return []
    return [
        "%s: cut down to %g mm."
        % (
            _names([f for c in cuts for f in c.floors if abs(c.levels[-1] - z) <= SAME_HEIGHT]),
            round(z, 4),
        )
        for z in depths
    ]


def _found(cut, is_one_of_several):
    """Sentences on a toolpath; where nothing is cut of one of several they say of which."""
    said = findings.sentences(cut.toolpath.report.findings)
    if len(cut.toolpath) or not is_one_of_several:
        return said
    return ["%s: %s" % (_names(cut.floors), sentence) for sentence in said]


def _names(floors):
    return listed([floor.name for floor in floors], " and ", "others")


def _distinct(heights):
    """Heights, the highest first, those that are the same but for rounding once."""
    result = []
    for z in sorted(heights, reverse=True):
        if not result or result[-1] - z > SAME_HEIGHT:
            result.append(z)
    return result


def _share_of(watch, number, count):
    """What one of several parts tells of its progress."""
    if watch is None:
        return None
    return lambda share: watch((number + share) / count)


def _by_top(settings, floors, cuts):
    """[(z in mm where material begins, those of the floors over which it does), ...]"""
    result = {}
    for floor in floors:
        result.setdefault(_top_over(floor, cuts, settings.StartDepth.Value), []).append(floor)
    return sorted(result.items(), key=lambda found: -found[0])


def _top_over(floor, cuts, start):
    cleared = [
        cut.levels[-1]
        for cut in cuts
        if cut.toolpath.report.termination == COMPLETE
        and any(_is_within(floor, other) for other in cut.floors)
    ]
    return min([start, *cleared])


def _is_within(floor, other):
    """Whether a floor is part of another's ground, seen from above."""
    inner, outer = face_of(replace(floor, z=other.z)), face_of(other)
    if not outer.BoundBox.isInside(inner.BoundBox.Center):
        return False
    # Of curves both have but what lies within the slack, which the tool keeps away from walls.
    least = LEAST_OVERLAP + (floor.slack + other.slack) * inner.Length
    return inner.cut(outer).Area < least
