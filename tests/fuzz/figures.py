"""What a posted path comes to by the simulator, in the figures that are limited and compared."""

import math

import shapes
from path_laws import (
    CUT,
    beyond_rounding,
    entry_share,
    kinks,
    level_entries,
    sharp_corners,
    wrong_side,
)

# Of the simulator: rows at most so far apart, and so many in a cut's width, or what is engaged at
# small angles is lost between them.
RESOLUTION, FINEST, ROWS = 0.05, 0.01, 16  # mm, mm, 1
STEP = 0.05  # mm of path between two looks, or means over 0.1 mm hang on one place
# The same, where a mean is above its limit, and the rows: one look in a sliver of some micrometres
# counts less, and between rows 0.05 mm apart borders that touch seem to cross by a tenth of one.
CLOSE_STEP, MEANS = 0.01, ("over", "link", "rate")
# mm: less than this may stay on walls: the tool keeps kWallGap off them, and follows lines that
# were an arc once within kFineShare of the tolerance.
FILM = 0.003
TIP = 0.6  # mm of cuts: so much may be made in tips, where fronts on both sides meet
# Of shapely's offsets: lines in a quarter of a circle, and a kind of join.
CIRCLE_LINES, MITRE = 90, 2
SHARP = math.radians(15)  # the lines of an arc turn by less


def resolution_for(case):
    """mm between the simulator's rows."""
    return max(FINEST, min(RESOLUTION, shapes.cut_width(case) / ROWS))


def figures_of(case, moves, run):
    """{figure: value} of the moves that are posted, and that ran as `run`: those that are limited,
    and the time over the ideal as "ratio".
    """
    nominal = shapes.cut_width(case) * case["axial_depth"] * case["feed"]
    regions = 1 + sum(1 for move in moves[1:-1] if move[0] == 0 and move[3] >= 5.0) // 2
    return {
        "over": run.max_engagement_deg - case["engagement_deg"],
        "link": run.link_engagement_deg,
        "gouge": run.gouge_mm,
        "rest": rest_share(case, run),
        "rate": run.removal_rate_peak / nominal,
        "rapid": beyond_rounding(run.rapid_in_material_mm),
        "plunge": beyond_rounding(run.plunge_in_material_mm),
        "level": level_entries(moves, 0.0, -case["axial_depth"]),
        "entry": entry_share(run, case) / regions,
        "climb": climb_share(case, run),
        "kinks": kinks(run, moves) - max(sharp_corners(case), corners_of_centres(case)),
        "ratio": run.time_total_s / (60 * run.removed_volume_total / nominal),
    }


def rest_share(case, run):
    """Of the area within reach, without the film that walls may keep."""
    from evenload import planar
    from shapely.geometry import LinearRing

    walls = [LinearRing(planar.flattened(chain)) for chain in [case["outer"], *case["islands"]]]
    film = FILM * sum(wall.length for wall in walls)
    return max(0.0, run.rest_area - film) / max(run.removed_area + run.rest_area, 1e-9)


def climb_share(case, run):
    """Of the length of cuts, on the side asked for."""
    wrong = wrong_side(run, case.get("choices", {}).get("cut_mode") == "conventional")
    length = float(run.length[run.kind == CUT].sum())
    return 1 - max(0.0, wrong - TIP / max(length, TIP))


def corners_of_centres(case):
    """Where the tool's centre, as near to walls as it may come, turns into a corner: also between
    islands, where no wall does.
    """
    import choices
    from evenload import planar
    from shapely.geometry import Polygon
    from shapely.geometry.polygon import orient

    pocket = Polygon(planar.flattened(case["outer"])).buffer(0)
    if case.get("open"):
        pocket = pocket.envelope.buffer(2 * case["tool"], join_style=MITRE)
    for island in case["islands"]:
        pocket = pocket.difference(Polygon(planar.flattened(island)).buffer(0))
    centres = choices.pieces(pocket.buffer(-0.5 * case["tool"], CIRCLE_LINES))
    return sum(
        sharp_left_turns(list(ring.coords)[:-1])
        for piece in map(orient, centres)
        for ring in (piece.exterior, *piece.interiors)
    )


def sharp_left_turns(points):
    """How many: those between the lines of an arc do not count."""
    count = 0
    for i, (x, y) in enumerate(points):
        (x0, y0), (x1, y1) = points[i - 1], points[(i + 1) % len(points)]
        turn = math.atan2(y1 - y, x1 - x) - math.atan2(y - y0, x - x0)
        count += math.remainder(turn, 2 * math.pi) > SHARP
    return count
