"""The pictures of docs/lame_spiral.md; see make_pictures.py."""

import json
import math

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from picture_parts import BLUE, CUT, DOCS, ENTRY, GREEN, GREY, INK, LINK, ORANGE, STOCK, VIOLET
from picture_parts import outline, plan, save, stretches

CORPUS = DOCS.parent / "tests" / "corpus"
CASES = (
    ("lame_square35", "square, 35 mm"),
    ("lame_hex50", "hexagon in a circle of 50 mm"),
    ("lame_square_island", "square island in stock of 50 mm"),
    ("lame_hex_island", "hexagonal island"),
)
FAMILIES = ((3, (0.05, 0.4, 0.7, 1)), (4, (0.05, 0.4, 1, 2)), (6, (0.05, 0.4, 0.71, 1)))
COLOURS = (BLUE, GREEN, ORANGE, VIOLET)
STEP = 0.1  # mm along a path between two looks
COURSES = (
    ("no course", {}),
    ("exponent 0, 0.8, 1", {"exponent_course": [0, 0.8, 1]}),
    ("exponent 0, 0, 1", {"exponent_course": [0, 0, 1]}),
    ("semi-axis A 0, 0.2, 0.5, 1", {"semi_axis_a_course": [0, 0.2, 0.5, 1]}),
)


def sheet(columns, width, height):
    figure = Figure(figsize=(width, height), dpi=110)
    FigureCanvasAgg(figure)
    return figure, figure.subplots(*columns).ravel()


# ---- the family of curves ----


def lame_point(angle, exponent, segments):
    psi, power = segments * angle / 4, 2 / exponent
    total = abs(math.cos(psi)) ** power + abs(math.sin(psi)) ** power
    radius = total ** (-1 / power)
    return radius * math.cos(angle), radius * math.sin(angle)


def draw_family(core):
    del core
    figure, all_axes = sheet((1, 3), 10.5, 3.9)
    for axes, (segments, exponents) in zip(all_axes, FAMILIES):
        for exponent, colour in zip(exponents, COLOURS):
            points = [lame_point(k * math.pi / 720, exponent, segments) for k in range(1441)]
            axes.plot(*zip(*points), color=colour, linewidth=1.4, label="n = %g" % exponent)
        axes.set_aspect("equal")
        axes.set_axis_off()
        axes.set_title("m = %d" % segments)
        axes.legend(loc="center", fontsize=8, frameon=False)
    save(figure, "lame_family.png")


# ---- the four spirals ----


def load(name):
    return json.loads((CORPUS / (name + ".json")).read_text())


def region_of(core, case):
    is_open = bool(case.get("open"))
    outer = [(*vertex, is_open) for vertex in case["outer"]]
    return core.Region(outer, [[tuple(v) for v in island] for island in case["islands"]])


def cleared(core, case, **more):
    return core.clear_with_lame_spiral(
        [region_of(core, case)],
        tool_diameter=case["tool"],
        engagement_angle=math.radians(case["engagement_deg"]),
        feed_control="constant removal rate",
        feed=case["feed"],
        plunge_feed=case["feed"],
        link_feed=case["link_feed"],
        maximum_feed=case["max_feed"],
        roll_radius=case["roll_radius"],
        levels=[-case["axial_depth"]],
        safe_height=3.0,
        clearance_height=5.0,
        **more,
    )


def samples(path, depth):
    """[(x, y, heading, kind, feed, length)] every STEP mm at the level."""
    result = []
    for before, after in zip(path.moves, path.moves[1:]):
        kind, x, y, z, sweep, cx, cy, feed = after
        if max(z, before[3]) > -depth + 1e-6:
            continue
        points = [before[1:3], (x, y)]
        if sweep:
            start = (before[1], before[2], math.tan(sweep / 4))
            points = outline([start, (x, y, 0)])[:-2] + [(x, y)]
        for (ax, ay), (bx, by) in zip(points, points[1:]):
            length = math.dist((ax, ay), (bx, by))
            n = max(1, math.ceil(length / STEP))
            for k in range(1, n + 1):
                place = (ax + (bx - ax) * k / n, ay + (by - ay) * k / n)
                result.append((*place, 0.0, kind, feed, length / n))
    return result


def draw_path(axes, case, path):
    styles = {CUT: (BLUE, 0.8), LINK: (GREY, 0.8), ENTRY: (ORANGE, 0.8)}
    if case.get("open"):
        axes.add_patch(Polygon(outline(case["outer"]), color=STOCK, zorder=0))
    for chain in [case["outer"]] + case["islands"]:
        axes.plot(*zip(*outline([tuple(v) for v in chain])), color=INK, linewidth=1.6)
    for kind, points in stretches(samples(path, case["axial_depth"]), STEP):
        colour, width = styles[kind]
        axes.plot(*zip(*points), color=colour, linewidth=width)
    plan(axes)


def draw_spirals(core):
    figure, all_axes = sheet((2, 2), 10, 10)
    for axes, (name, title) in zip(all_axes, CASES):
        case = load(name)
        path = cleared(core, case)
        draw_path(axes, case, path)
        # The simulator finds the same, to 0.001 (docs/lame_spiral.md).
        ratio = path.report.cutting_time / path.report.ideal_time
        axes.set_title("%s: %.2f of the ideal time" % (title, ratio), fontsize=10)
    save(figure, "lame_spirals.png")


def draw_courses(core):
    figure, all_axes = sheet((1, 4), 14, 4)
    case = load(CASES[0][0])
    for axes, (title, course) in zip(all_axes, COURSES):
        path = cleared(core, case, rest="leave", **course)
        draw_path(axes, case, path)
        axes.set_title("%s\nspiral: %.0f s" % (title, path.report.cutting_time), fontsize=10)
    save(figure, "lame_courses.png")


def draw_engagement(core):
    figure, all_axes = sheet((4, 1), 10, 9)
    for axes, (name, title) in zip(all_axes, CASES):
        case = load(name)
        region = region_of(core, case)
        looks = core.engagement_profile([region], cleared(core, case), case["tool"])
        length, along, angles, before = 0.0, [], [], None
        for x, y, engagement, kind in looks:
            if before and kind == CUT:
                length += min(1.0, math.dist(before, (x, y)))  # not where the tool went up
                along.append(length / 1000)
                angles.append(engagement)
            before = (x, y)
        axes.plot(along, angles, color=BLUE, linewidth=0.4)
        axes.axhline(case["engagement_deg"], color=ORANGE, linewidth=1)
        axes.set_ylim(0, 75)
        axes.set_xlim(0, along[-1])
        axes.set_ylabel("engagement, °")
        axes.set_title(title, fontsize=10)
    all_axes[-1].set_xlabel("cut, m")
    save(figure, "lame_engagement.png")


PICTURES = (draw_family, draw_spirals, draw_courses, draw_engagement)
