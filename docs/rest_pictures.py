"""The picture of docs/rest_machining.md; see make_pictures.py."""

import math

from matplotlib.patches import Polygon
from picture_parts import BLUE, CUT, ENTRY, GREY, INK, LINK, ORANGE, STOCK
from picture_parts import canvas, lines, outline, plan, rectangle, save

DEPTH, LARGE, SMALL = 3.0, 12.0, 6.0  # mm
BLOCK = [(-8, -8, 0), (48, -8, 0), (48, 38, 0), (-8, 38, 0)]
POCKET = rectangle(40, 30)
BOSS = [(15, 8, 0), (15, 17, 0), (22, 17, 0), (22, 8, 0)]


def clear(core, region, diameter, **more):
    return core.clear_pocket(
        [region],
        tool_diameter=diameter,
        engagement_angle=math.radians(60),
        feed=255.0,
        plunge_feed=255.0,
        link_feed=1500.0,
        maximum_feed=510.0,
        roll_radius=0.15 * diameter,
        minimum_radius=0.15 * diameter,
        helix_diameter=0.9 * diameter,
        levels=[-DEPTH],
        safe_height=5.0,
        clearance_height=10.0,
        **more,
    )


def stretches(moves):
    """[(kind, chain of the moves that follow each other at depth)]."""
    result = []
    for before, after in zip(moves, moves[1:]):
        kind, x, y, z, sweep, *_ = after
        if z > -DEPTH + 1e-6 or before[3] > -DEPTH + 1e-6 or kind not in (LINK, ENTRY, CUT):
            continue
        start = (before[1], before[2], math.tan(sweep / 4))
        result.append((kind, outline([start, (x, y, 0)])[: -2 if sweep == 0 else -1] + [(x, y)]))
    return result


def draw_rest(core):
    region = core.Region(POCKET, [BOSS])
    stock = core.DexelStock([(core.Region(BLOCK), 0.0)], -DEPTH, 0.05)
    core.simulate(clear(core, region, LARGE).moves, stock, tool_diameter=LARGE, find_rest=False)
    left = stock.standing(-DEPTH, core.reachable_ground([region], SMALL))
    path = clear(core, region, SMALL, stock=[left])
    figure, axes = canvas(8.2, 5.6)
    for label, piece in zip(["left by the tool of 12 mm"] + [None] * len(left), left):
        axes.add_patch(Polygon(outline(piece.outer), color=STOCK, label=label, zorder=0))
    lines(axes, [region], color=INK, linewidth=1.8)
    names = {CUT: ("cut, tool of 6 mm", BLUE, 1.2), LINK: ("link", GREY, 0.7)}
    for kind, points in stretches(path.moves):
        name, colour, width = names[kind]
        axes.plot(*zip(*points), color=colour, linewidth=width, label=name)
        names[kind] = (None, colour, width)
    downs = [b for a, b in zip(path.moves, path.moves[1:]) if b[3] < 0 <= a[3]]
    axes.plot(*zip(*[d[1:3] for d in downs]), "o", color=ORANGE, ms=4, label="comes down here")
    plan(axes, (-1, 41), (-1, 31))
    figure.legend(loc="upper center", ncol=4, fontsize=9, frameon=False)
    report = path.report
    note = "%d passes, %d links, %d retracts; %.1f mm2 left before, %.2f after"
    area = sum(piece.area for piece in left)
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    save(
        figure,
        "rest.png",
        note % (report.passes, report.links, report.retracts, area, report.uncut_area),
        fit=False,
    )


PICTURES = (draw_rest,)
