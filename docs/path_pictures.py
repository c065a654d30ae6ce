"""The pictures of docs/constant_engagement.md and docs/feed_control.md; see make_pictures.py."""

import math

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle
from picture_parts import BLUE, CUT, ENTRY, GREEN, GREY, INK, LINK, ORANGE, RED, VIOLET
from picture_parts import WALL_GAP, Grid, Job, canvas, lines, outline, places, plan, rectangle
from picture_parts import save, star, stock, stretches


def draw_star(core):
    job = Job(core, star(), hole=(0.0, 0.0, 11.0))
    profile = core.engagement_profile([job.region], job.path, job.diameter, hole=job.hole)
    figure, axes = canvas(8.2, 6.4)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8, label="pocket")
    axes.add_patch(Circle((0, 0), 5.5, fill=False, ls="--", color=INK, label="drilled hole"))
    cuts, values, links = [], [], []
    for a, b in zip(profile, profile[1:]):
        if math.dist(a[:2], b[:2]) > 0.35:
            continue  # a retract lies between
        if b[3] == CUT:
            cuts.append((a[:2], b[:2]))
            values.append(b[2])
        elif b[3] == LINK:
            links.append((a[:2], b[:2]))
    coloured = LineCollection(cuts, array=values, cmap="turbo", linewidths=1.5, zorder=3)
    coloured.set_clim(0, 70)
    axes.add_collection(coloured)
    axes.add_collection(LineCollection(links, colors=GREY, linewidths=0.8, label="link"))
    figure.colorbar(coloured, ax=axes, label="engagement angle, degrees (set: 60)", shrink=0.95)
    plan(axes)
    axes.legend(loc="upper right", fontsize=9)
    report = job.path.report
    save(
        figure,
        "star.png",
        "%.0f s, %.2f of the ideal; engagement at most %.1f; %d passes, %d links, %d retracts; "
        "left %.2f mm2"
        % (
            report.cutting_time,
            report.cutting_time / report.ideal_time,
            math.degrees(report.max_engagement),
            report.passes,
            report.links,
            report.retracts,
            report.uncut_area,
        ),
    )


def draw_square(core):
    job = Job(core, rectangle(60, 60))
    figure, axes = canvas(7, 6.6)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    helix = [(m[1], m[2]) for m in job.path.moves if m[0] == ENTRY][-1]
    names = {"spiral": BLUE, "passes": ORANGE, "links": GREY}
    first = True
    for kind, points in job.stretches():
        if kind == ENTRY:
            continue
        name = "links" if kind == LINK else "spiral" if first else "passes"
        first = first and kind == LINK
        axes.plot(
            *zip(*points),
            color=names[name],
            linewidth=1.3 if kind == CUT else 0.8,
            label=name if name in names else None,
        )
    axes.add_patch(Circle((30, 30), helix[0] - 30, fill=False, color=VIOLET, lw=1.6, label="helix"))
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles))
    place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "ncol": 4, "frameon": False}
    axes.legend(once.values(), once.keys(), fontsize=9, **place)
    plan(axes)
    save(figure, "square.png")


def draw_step(core):
    """One place of a pass in a slot: the tool, what it touches, the turn that it could make."""
    job = Job(core, rectangle(60, 14))
    grid = Grid(job, 0.02)
    samples = job.samples()
    at = None
    for i, (x, y, heading, kind, _, _) in enumerate(samples):
        if kind == CUT and x > 39 and math.sin(heading) > 0.75 and 6.6 < y < 7.0:
            at = i
            break
        grid.take(x, y, job.radius)
    x, y, heading, *_ = samples[at]
    turn = job.wish
    figure, axes = canvas(7.6, 6.2)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    ahead = [s[:2] for s in samples[at : at + 45]]
    axes.plot(*zip(*[s[:2] for s in samples[at - 40 : at + 1]]), color=BLUE, lw=2)
    axes.plot(*zip(*ahead), color=BLUE, lw=1.4, ls=":")
    axes.add_patch(Circle((x, y), job.radius, fill=False, color=INK, lw=1.2))
    right = math.degrees(heading) - 90
    engaged = math.degrees(job.angle)
    axes.add_patch(
        Arc((x, y), 6, 6, theta1=right, theta2=right + engaged, color=RED, lw=4, zorder=4)
    )
    c = math.radians(right + engaged)
    cx, cy = x + job.radius * math.cos(c), y + job.radius * math.sin(c)
    axes.plot([x, cx], [y, cy], color=RED, lw=1)
    r = math.radians(right)
    axes.plot([x, x + job.radius * math.cos(r)], [y, y + job.radius * math.sin(r)], color=RED, lw=1)
    axes.add_patch(Arc((x, y), 2, 2, theta1=right, theta2=right + engaged, color=RED, lw=1))
    middle = math.radians(right + engaged / 2)
    text = {"ha": "center", "va": "center", "fontsize": 13}
    axes.text(x + 1.4 * math.cos(middle), y + 1.4 * math.sin(middle), "θ", color=RED, **text)
    axes.text(cx + 0.35, cy + 0.35, "C", color=RED, **text)
    axes.text(x + 0.3, y - 0.4, "P", color=INK, **text)
    axes.annotate(
        "",
        (x + 2.2 * math.cos(heading), y + 2.2 * math.sin(heading)),
        (x, y),
        arrowprops={"arrowstyle": "-|>", "color": BLUE, "lw": 2},
        zorder=5,
    )
    qx, qy = x - turn * math.sin(heading), y + turn * math.cos(heading)
    axes.add_patch(Circle((qx, qy), turn, fill=False, color=GREEN, lw=1.4, ls="--"))
    axes.plot(qx, qy, "o", color=GREEN, ms=4)
    axes.text(qx - 0.38, qy, "Q", color=GREEN, **text)
    lines(axes, job.centres(), color=VIOLET, lw=1.3, label="walls of the tool's centre")
    stage = job.stages(1)[0]
    lines(axes, stage[2], color=GREEN, lw=1.3, ls=":", label="border of the place of Q")
    axes.plot([], [], color=BLUE, lw=2, label="pass, and what follows (dotted)")
    axes.plot([], [], color=RED, lw=4, label="engaged arc")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2, fontsize=9, frameon=False)
    plan(axes, (x - 6.5, x + 7), (-0.7, 14.7))
    save(figure, "step.png")


def draw_slot(core):
    job = Job(core, rectangle(100, 9))
    grid = Grid(job, 0.02)
    samples, passes = job.samples(), 0
    begin = next(i for i, s in enumerate(samples) if s[3] == CUT and s[0] > 61.5)
    while samples[begin][3] != LINK:
        begin += 1
    end, last = begin, None
    while passes < 4:
        if samples[end][3] == LINK and last == CUT:
            passes += 1
        last = samples[end][3]
        end += 1
    while samples[end - 1][3] == LINK:
        end -= 1
    for x, y, *_ in samples[:begin]:
        grid.take(x, y, job.radius)
    figure, axes = canvas(8.0, 6.2)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, lw=1.8)
    lines(axes, job.centres(), color=VIOLET, lw=1.2, label="walls of the tool's centre")
    part = samples[begin:end]
    for kind, name, style in (
        (CUT, "pass", {"colors": BLUE, "linewidths": 2}),
        (LINK, "link", {"colors": ORANGE, "linewidths": 1.3, "linestyles": "--"}),
    ):
        pieces = [points for k, points in stretches(part) if k == kind]
        axes.add_collection(LineCollection(pieces, label=name, zorder=3, **style))
    starts = [a[:2] for a, b in zip(part, part[1:]) if a[3] == LINK and b[3] == CUT]
    axes.plot(*zip(*starts), "o", color=GREEN, ms=6, zorder=5, label="start")
    x, y = starts[0]
    axes.add_patch(Circle((x, y), job.radius, fill=False, color=INK, lw=1, ls=":", label="tool"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=5, fontsize=9, frameon=False)
    plan(axes, (x - 4.5, x + 6), (-0.4, 9.4))
    save(figure, "slot.png")


def draw_corner(core):
    job = Job(core, rectangle(60, 60))
    figure = Figure(figsize=(9.4, 5.2), dpi=110)
    FigureCanvasAgg(figure)
    parts = job.stretches(0.005)
    shades = ("#0b3d91", "#1a73e8", "#5fa8ff", "#b3d4ff")
    for axes, low in zip(figure.subplots(1, 2), (54.4, 56.4)):
        for (turn, opened, _), shade in zip(job.stages(4), shades):
            label = "stage, turn radius %.2f mm" % turn
            lines(axes, opened, color=shade, lw=4.5, label=label)
        lines(axes, job.centres(), color=RED, lw=2.4, label="last stage: exact border")
        first = job.stages(1)[0][2]
        lines(axes, first, color=GREEN, lw=1.3, ls=":", label="border of Q's place, first stage")
        for kind, colour, name in ((CUT, INK, "passes"), (LINK, ORANGE, "links")):
            pieces = [points for k, points in parts if k == kind]
            axes.add_collection(
                LineCollection(pieces, colors=colour, linewidths=0.8, label=name, zorder=3)
            )
        plan(axes, (low, 57.06), (low, 57.06))
    figure.axes[1].set_ylabel("")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=4, fontsize=8.5, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    save(figure, "corner.png", fit=False)


def draw_walls(core):
    """Passes into a corner: along the wall, off it, free, and onto the next one."""
    job = Job(core, rectangle(60, 60))
    low, high = 3 + WALL_GAP, 57 - WALL_GAP
    inner = 38  # mm: the corner that is shown, from here on
    grid, names = Grid(job, 0.03), ("along the wall", "at the engagement angle", "roll-out")
    pieces, offs, first = {name: [] for name in names}, [], None
    passes, last = 0, None
    for before, move in zip(job.path.moves, job.path.moves[1:]):
        kind, on_level = move[0], move[3] < -job.depth + 1e-6
        points = places(before, move) if on_level else []
        here = on_level and min(p for place in points for p in place) > inner
        passes += here and kind == CUT and last == LINK
        last = kind if on_level else last
        if passes > 3:
            break
        if not (here and passes):
            for place in points:
                grid.take(*place, job.radius)
            continue
        if kind == LINK:
            continue
        off = max(min(abs(v - b) for v in p for b in (low, high)) for p in points)
        turn = math.dist(points[0], move[5:7]) if move[4] > 0 else math.inf
        name = names[0] if off < 1e-3 else names[2] if turn < 1.01 * job.wish else names[1]
        if name == names[1] and pieces[names[0]] and pieces[names[0]][-1][-1] == points[0]:
            offs.append(points[0])
        pieces[name].append(points)
        first = first or points[0]
    figure, axes = canvas(7.0, 6.6)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    lines(axes, job.centres(), color=VIOLET, lw=1.0)
    for name, colour in zip(names, (GREEN, BLUE, RED)):
        axes.add_collection(
            LineCollection(pieces[name], colors=colour, linewidths=2.4, label=name, zorder=4)
        )
    axes.plot(*zip(*offs), "o", color=ORANGE, ms=7, zorder=5, label="roll-in")
    axes.add_patch(Circle(first, job.radius, fill=False, color=INK, lw=1, ls=":"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, fontsize=9, frameon=False)
    plan(axes, (inner, 60.6), (inner, 60.6))
    save(figure, "walls.png")


def draw_starts(core):
    """A square after its spiral: what is cleared of the wall, and where passes can start."""
    job = Job(core, rectangle(60, 60))
    grid, helix = Grid(job, 0.05), None
    for x, y, _, kind, *_ in job.samples():
        if kind == LINK:
            break
        helix = helix or math.dist((x, y), (30, 30))
        grid.take(x, y, job.radius)
    grid.take(30, 30, helix + job.radius)
    low, high = 3 + WALL_GAP, 57 - WALL_GAP
    corners = [(low, low), (high, low), (high, high), (low, high)]  # the wall to the right
    walls = []
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        for k in range(200):
            p = (ax + (bx - ax) * k / 200, ay + (by - ay) * k / 200)
            walls.append((p, grid.holds(*p, job.radius - 0.1)))
    pairs = list(zip(walls, walls[1:] + walls[:1]))
    figure, axes = canvas(7, 6.6)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    for met, colour, name in ((False, GREEN, "cleared"), (True, RED, "not cleared")):
        rows = [(a, b) for (a, m), (b, _) in pairs if m == met]
        axes.add_collection(LineCollection(rows, colors=colour, lw=3, capstyle="round", label=name))
    starts = [(a, b) for (a, m), (b, n) in pairs if n and not m]
    axes.plot(*zip(*[a for a, _ in starts]), "o", color=BLUE, ms=8, zorder=5, label="start")
    for (x, y), (u, v) in starts:
        way = math.dist((x, y), (u, v)) / 7
        arrow = {"arrowstyle": "-|>", "color": BLUE, "lw": 2}
        axes.annotate("", (x + (u - x) / way, y + (v - y) / way), (x, y), arrowprops=arrow)
        axes.add_patch(Circle((x, y), job.radius, fill=False, color=INK, lw=1, ls=":"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, fontsize=9, frameon=False)
    plan(axes)
    save(figure, "starts.png")


def draw_links(core):
    """Of the star's ways from point to point the longest link, which passes a corner at depth."""
    job = Job(core, star(), hole=(0.0, 0.0, 11.0))
    grid, parts = Grid(job, 0.03), job.stretches(0.05)
    ways = [sum(map(math.dist, points, points[1:])) for _, points in parts]
    longest = max((i for i, part in enumerate(parts) if part[0] == LINK), key=ways.__getitem__)
    for _, points in parts[:longest]:
        for place in points:
            grid.take(*place, job.radius)
    figure, axes = canvas(7.4, 6.4)
    stock(axes, grid)
    axes.plot(*zip(*outline(job.chain)), color=INK, linewidth=1.8)
    lines(axes, job.centres(), color=VIOLET, lw=1.0, label="wall of the tool's centre")
    for i, colour, name in (
        (longest - 1, BLUE, "last pass"),
        (longest, ORANGE, "link"),
        (longest + 1, GREEN, "next pass"),
    ):
        axes.plot(*zip(*parts[i][1]), color=colour, lw=2.2, label=name)
    axes.add_patch(Circle(parts[longest][1][-1], job.radius, fill=False, color=INK, lw=1, ls=":"))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, fontsize=9, frameon=False)
    plan(axes)
    save(figure, "links.png", "%.1f mm" % ways[longest])


def draw_feed(core):
    window = 0.5  # mm, over which rates are means
    figure, axes = canvas(8.6, 4.4)
    notes = []
    for control, colour in (("constant feed", GREY), ("constant removal rate", BLUE)):
        job = Job(core, star(), hole=(0.0, 0.0, 11.0), control=control)
        grid, way, removed, area, minutes = Grid(job, 0.01), 0.0, 0.0, 0.0, 0.0
        nominal, along, rates = job.nominal_width * job.feed * job.depth, [], []
        length_before = 0.0
        for x, y, _, kind, feed, length in job.samples(0.05):
            took = grid.take(x, y, job.radius)
            if kind != CUT:
                continue
            way, area, minutes = way + length, area + took, minutes + length / feed
            if way - length_before >= window:
                along.append((way + length_before) / 2)
                rates.append((area * job.depth / minutes, area))
                removed += area
                length_before, area, minutes = way, 0.0, 0.0
        axes.plot(along, [r for r, _ in rates], color=colour, lw=1.4, label=control)
        near = sum(a for r, a in rates if r >= 0.9 * nominal) / removed
        notes.append(
            "%s: %.0f s, %.0f %% of the area at 0.9 of the rate or more, mean over %g mm at most "
            "%.3f of it"
            % (
                control,
                job.path.report.cutting_time,
                100 * near,
                window,
                max(r for r, _ in rates) / nominal,
            )
        )
    axes.axhline(nominal, color=RED, lw=1, ls="--", label="nominal: %.1f mm³/min" % nominal)
    axes.set_xlim(200, 330)
    axes.set_ylim(0, 1.15 * nominal)
    axes.set_xlabel("way along the cuts of the star, mm (the spiral ends at about 230)")
    axes.set_ylabel("removal rate, mm³/min")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, fontsize=9, frameon=False)
    save(figure, "feed.png", "; ".join(notes))


PICTURES = (
    draw_star,
    draw_step,
    draw_walls,
    draw_corner,
    draw_starts,
    draw_square,
    draw_slot,
    draw_links,
    draw_feed,
)
