"""What users may choose beside the pocket, for a random share of the cases: cut mode, feed control,
entry, stock to leave, open edges, rest machining, radii, LinkLift, NarrowPassages, no arcs, courses
of Lamé spirals. And how such cases are cleared and judged.

In a case, "choices" holds parameters of `clear_pocket`, "open_edges" the pieces of the outline that
are edges of the stock, by the number of the vertex where each begins, "rest_of" the diameter of an
end mill that cleared the pocket before.
"""

import math

import evenload
import pocket_case
import shapes
from evenload import _core, planar, simulation
from shapely.geometry import Point, Polygon

SPINDLE = {"teeth": 1, "spindle_speed": 6366.0}
FORCE = (796.0, 169.0, 28.0, 31.0)  # N/mm2 twice, N/mm twice: of an aluminium alloy
OTHER_FEEDS = ("constant feed", "constant chip thickness", "constant force")
CHANCE = 0.12  # of each choice
OPEN_SHARE = 0.3  # of the edges that can be open
HOLES = (6.6, 10.0)  # mm
RADII = (0.2, 2.0)  # mm
STOCK_TO_LEAVE = (0.05, 0.6)  # mm
LINK_LIFT = (0.1, 1.0)  # mm
LEAST_LOAD = (0.3, 0.95)
CHORD = 2e-4  # mm: at the radius of the tool 1.3 degrees
LARGER = (7.0, 16.0)  # mm: the tool before
COURSES = ("semi_axis_a_course", "semi_axis_b_course", "exponent_course")
MOST_PIECES = 6  # of a course
RESTING = 0.2  # of its pieces
ON_HULL = 1e-9  # mm
REDUCED_FEED = ("passage_reduced", "passage_reduced_too_narrow")
NO_HOLE = "region_without_hole"
THIN_WALL = 0.005  # mm: walls narrower than twice this do not count
LEAST_PIECE = 1e-6  # mm2: less is rounding


class NothingLeft(Exception):
    """The tool before left nothing."""


def choose(pick, case):
    """Adds choices to a case."""
    chosen = {}

    def now():
        return pick.random() < CHANCE

    if now():
        chosen["cut_mode"] = "conventional"
    if pick.random() < 3 * CHANCE:
        chosen["feed_control"] = pick.choice(OTHER_FEEDS)
        if chosen["feed_control"] == "constant force":
            chosen.update(SPINDLE, force_coefficients=FORCE)
    if now():
        chosen["entry"] = pick.choice(("helix", "ramp"))
    if now() and not case.get("open"):
        chosen["stock_to_leave"] = round(pick.uniform(*STOCK_TO_LEAVE), 2)
    if now():
        chosen["minimum_radius"] = round(pick.uniform(*RADII), 2)
    if now():
        chosen["link_lift"] = round(pick.uniform(*LINK_LIFT), 1)
    if now():
        chosen["narrow_passages"] = pick.choice(("cut at reduced feed", "skip and report"))
    if now():
        # Chords turn the feed by so little that the engagement can be held.
        chosen.update(arcs=False, tolerance=CHORD)
    if now():
        case["roll_radius"] = round(pick.uniform(*RADII), 2)
    before = pick.choice(("hole", "open", "rest")) if pick.random() < 3 * CHANCE else None
    if before == "open" and not case.get("open"):
        edges = [i for i in hull_edges(case) if pick.random() < OPEN_SHARE]
        if edges:
            case["open_edges"] = edges
            chosen.pop("stock_to_leave", None)
    if before == "hole" and not case.get("open"):
        found = hole_in(pick, case, chosen.get("stock_to_leave", 0.0))
        if found:
            case["hole"] = found
            chosen.pop("entry", None)
    if before == "rest" and not case.get("open") and "operation" not in case:
        case["rest_of"] = round(pick.uniform(*LARGER), 1)
    if case.get("operation") == "lame_spiral":
        chosen.update({name: a_course(pick) for name in COURSES if now()})
    if chosen.get("feed_control") != "constant feed" and now():
        chosen["least_load"] = round(pick.uniform(*LEAST_LOAD), 2)
    if chosen:
        case["choices"] = chosen


def a_course(pick):
    """Values from 0 to 1 that never fall."""
    pieces = pick.randint(2, MOST_PIECES)
    steps = [0 if pick.random() < RESTING else pick.random() for _ in range(pieces - 1)] + [1]
    course = [round(sum(steps[:i]) / sum(steps), 3) for i in range(pieces)]
    return [*course, 1]


def outline(case):
    return [(x, y) for x, y, _ in case["outer"]]


def hull_edges(case):
    """Straight pieces of the outline beyond which there is nothing of it."""
    if any(bulge for _, _, bulge in case["outer"]):
        return []
    points = outline(case)
    border = Polygon(points).convex_hull.exterior
    edges = []
    for i, (a, b) in enumerate(zip(points, points[1:] + points[:1])):
        middle = Point(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
        if border.distance(middle) < ON_HULL and math.dist(a, b) > case["tool"]:
            edges.append(i)
    return edges


def hole_in(pick, case, stay):
    """[x, y, diameter] of a hole inside the pocket; None where none was found."""
    islands = [Polygon(planar.flattened(chain)) for chain in case["islands"]]
    room = Polygon(planar.flattened(case["outer"])).buffer(0)
    diameter = round(pick.uniform(*HOLES), 1)
    for island in islands:
        room = room.difference(island)
    room = room.buffer(-0.5 * diameter - stay - 0.05)
    if room.is_empty:
        return None
    x0, y0, x1, y1 = room.bounds
    for _ in range(20):
        x, y = pick.uniform(x0, x1), pick.uniform(y0, y1)
        if room.contains(Point(x, y)):
            return [round(x, 3), round(y, 3), diameter]
    return None


# ---- to clear and to judge ----


def path_and_scene(case, resolution):
    """The Toolpath that clears a case, and arguments of `evenload.simulate` for it."""
    given, scene_there = given_and_scene(case, resolution)
    return pocket_case.path_of(case, **given), scene_there


def given_and_scene(case, resolution):
    """What the case does not say itself: arguments of `pocket_case.path_of`, {"stock": ...} where a
    larger tool was there before, and of `evenload.simulate`.
    """
    given = {**scene(case), "resolution": resolution}
    if "rest_of" not in case:
        return {}, given
    with_larger = {key: case[key] for key in case if key not in ("choices", "hole")}
    with_larger["tool"] = given["tool_diameter"] = case["rest_of"]
    before = pocket_case.path_of(with_larger, minimum_radius=0.15 * case["rest_of"])
    seen = given["resolution"] = simulation.rest_resolution(shapes.cut_width(case))
    run = evenload.simulate(before, **given)
    stay = case.get("choices", {}).get("stock_to_leave", 0.0)
    reach = _core.reachable_ground([pocket_case.region(case)], case["tool"], stay)
    standing = run.stock.standing(-case["axial_depth"], reach)
    if not standing:
        raise NothingLeft
    if resolution < seen:  # what is cleared is judged more closely than it was seen
        given["resolution"] = resolution
        run = evenload.simulate(before, **given)
    given.update(stock=run, tool_diameter=case["tool"], earlier=[])
    return {"stock": [standing]}, given


def scene(case):
    result = pocket_case.scene(case)
    stay = case.get("choices", {}).get("stock_to_leave", 0.0)
    if case.get("open_edges"):
        block = cut_block(case)
        walls = block.difference(Polygon(outline(case)))
        walls = pieces(walls.buffer(-THIN_WALL, join_style=2).buffer(THIN_WALL, join_style=2))
        result["stock"] = [shapes.chain(piece.exterior.coords[:-1]) for piece in pieces(block)]
        walls = [_core.Region(shapes.chain(piece.exterior.coords[:-1])) for piece in walls]
        result["part"] = walls + result["part"][1:]
    elif stay:  # all that the tool is not to reach must stay
        x0, y0, x1, y1 = result["stock"]
        block = [(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)]
        ground = _core.reachable_ground([pocket_case.region(case)], case["tool"], stay)
        result["part"] = [_core.Region(block, [piece.outer for piece in ground])]
        result["part"] += [_core.Region(island) for piece in ground for island in piece.islands]
    return result


def cut_block(case):
    """The stock about a pocket, cut off along its open edges."""
    points = outline(case)
    block = Polygon(points).envelope.buffer(2 * case["tool"], join_style=2)
    x0, y0, x1, y1 = block.bounds
    far = 3 * max(x1 - x0, y1 - y0)
    for i in case["open_edges"]:
        (ax, ay), (bx, by) = points[i], points[(i + 1) % len(points)]
        u, v = (far * d / math.dist(points[i], (bx, by)) for d in (bx - ax, by - ay))
        corners = [(ax - u, ay - v), (ax + u, ay + v), (ax + u + v, ay + v - u)]
        block = block.difference(Polygon([*corners, (ax - u + v, ay - v - u)]))
    return block


def pieces(shape):
    return [piece for piece in getattr(shape, "geoms", [shape]) if piece.area > LEAST_PIECE]


def slotted_passages(findings):
    """How many passages were cut as wide as the tool; findings: the codes of a report."""
    return sum(code in REDUCED_FEED for code in findings)


def is_slotted(findings):
    """True where passages were cut as wide as the tool, which is neither climb nor conventional."""
    return slotted_passages(findings) > 0


def limits_for(case, findings, limits):
    """Those of the limits that apply to what was chosen; findings: the codes of a report."""
    chosen = case.get("choices", {})
    without = set()
    if "feed_control" in chosen:
        without.add("rate")
    if chosen.get("narrow_passages") == "skip and report":
        without.add("rest")
    if is_slotted(findings):
        without.add("over")
    if not chosen.get("arcs", True):
        without.add("kinks")
    if NO_HOLE in findings:
        without.add("rest")
    kept = {name: limit for name, limit in limits.items() if name not in without}
    if "entry" in kept:  # the room behind each such passage has an entry of its own
        kept["entry"] *= 1 + slotted_passages(findings)
    return kept
