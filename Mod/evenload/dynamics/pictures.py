"""Pictures of milling dynamics: charts, surfaces, fitted responses, branches of orbits.

Each function draws into a file, SVG where its name ends so, else PNG, and returns the figure; where
the file is None, nothing is written. No display is needed.
"""

import numpy

from evenload.pictures.figure import new_figure, save
from evenload.translation import translate

COLOURS = {"Hopf": "#1a73e8", "flip": "#d93025", "fold": "#188038"}
UNSTABLE, TRIVIAL, OTHER, GREY, POINT = "#fce8e6", "#188038", "#e8710a", "#9aa0a6", "#202124"
GRID = 120, 80  # speeds and depths at which the ground is coloured
MAP = 60, 36  # those of surface errors
RESONANCES = 8  # that are named, the fastest first
FIT_PARTS = "real part of %s, \u00b5m/N", "imaginary part of %s, \u00b5m/N"
LEVELS_UM = (-100, -50, -20, -10, 10, 20, 50, 100)


def chart(
    found,
    file,
    point=None,
    feed_per_tooth=None,
    frequency=None,
    title="Stability chart",
):
    """A Chart over its chatter frequencies.

    point: (speed, depth) of an operation, rev/min and mm. feed_per_tooth: mm; contours of the
    surface location error are drawn with it. frequency: Hz of a mode; resonances and the optimal
    depths are drawn with it.
    """
    figure = new_figure(10, 8, layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    _draw_ground(upper, found)
    _draw_curves(upper, found)
    if feed_per_tooth:
        _draw_errors(upper, found, feed_per_tooth)
    if frequency:
        _draw_optimal(upper, found, frequency)
    if point:
        upper.plot(*point, "o", color=POINT, markersize=8, zorder=9, label=sentence(found, *point))
    upper.set_xlim(*found.speeds)
    upper.set_ylim(*found.depths)
    upper.set_ylabel("axial depth, mm")
    upper.set_title(title, loc="left")
    _draw_frequencies(lower, found)
    handles, labels = upper.get_legend_handles_labels()
    lower.legend(
        handles,
        labels,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.35),
        ncols=2,
        frameon=False,
        fontsize=9,
    )
    return _saved(figure, file)


def sentence(found, speed, depth):
    """What a chart says of a cut, in a sentence."""
    milling = found.milling
    if found.is_stable(speed, depth):
        limit = milling.critical_depth(speed, found.depths[1])
        more = "" if numpy.isinf(limit) else ", up to %.2f mm" % limit
        return "stable at %.0f rev/min and %.3g mm%s" % (speed, depth, more)
    limit = milling.critical_depth(speed, depth)
    words = "unstable at %.3g mm: limit %.2f mm at %.0f rev/min" % (depth, limit, speed)
    if not milling.frf:
        words += ", chatter near %.0f Hz" % milling.chatter(speed, depth)[1]
    other = nearest_stable_speed(found, speed, depth)
    return words + ("; stable at %.0f rev/min" % other if other else "")


def nearest_stable_speed(found, speed, depth):
    """rev/min nearest to `speed` at which this depth is stable within the chart; None if none."""
    speeds = numpy.linspace(*found.speeds, GRID[0])
    stable = found.is_stable(speeds, numpy.full(speeds.shape, float(depth)))
    if not stable.any():
        return None
    return float(speeds[stable][numpy.argmin(abs(speeds[stable] - speed))])


def fit(fitted, file, title="Fitted modes"):
    """A ModalFit over what was measured, real and imaginary part of each axis."""
    axes_names = sorted(fitted.lines)
    figure = new_figure(10, 3.2 * len(axes_names) + 1, layout="constrained")
    rows = figure.subplots(len(axes_names), 2, squeeze=False)
    for row, name in zip(rows, axes_names):
        frequencies, measured, drawn = fitted.lines[name]
        for axes, part, words in zip(row, (numpy.real, numpy.imag), FIT_PARTS):
            points = {"color": GREY, "ms": 3, "label": translate("measured")}
            axes.plot(frequencies, 1e6 * part(measured), ".", **points)
            line = {"color": COLOURS["Hopf"], "label": translate("fitted")}
            axes.plot(frequencies, 1e6 * part(drawn), **line)
            axes.set_xlabel(translate("frequency, Hz"))
            axes.set_ylabel(translate(words) % name)
            axes.grid(color="#e8eaed", linewidth=0.6)
        told = translate("%s: error %.1f %%") % (name, 100 * fitted.error[name])
        row[0].set_title(told, loc="left")
    rows[0][1].legend(frameon=False)
    figure.suptitle(title)
    return _saved(figure, file)


def wall(surface, file, height, feed, title="Wall"):
    """The height map of a Surface: `height` mm along the axis, three feeds per tooth along x."""
    z, x = numpy.linspace(0, height, 80), numpy.linspace(0, 3 * feed, 60)
    offsets = 1e3 * surface.profile(z, x)
    figure = new_figure(9, 4.5, layout="constrained")
    axes = figure.add_subplot()
    shown = axes.pcolormesh(1e3 * x, z, offsets, cmap="viridis", shading="gouraud")
    figure.colorbar(shown, ax=axes, label="offset outwards, \u00b5m (> 0: overcut)")
    axes.set_xlabel("along the feed, \u00b5m")
    axes.set_ylabel("height above the tip, mm")
    axes.set_title(
        "%s: location error %.1f, waviness %.1f, roughness %.2f \u00b5m"
        % (
            title,
            1e3 * surface.surface_location_error,
            1e3 * surface.waviness,
            1e3 * surface.roughness,
        ),
        loc="left",
        fontsize=10,
    )
    return _saved(figure, file)


def orbits(branch, file, title="Periodic motions"):
    """Orbits: amplitude over depth, unstable ones dashed, folds marked."""
    figure = new_figure(8, 5, layout="constrained")
    axes = figure.add_subplot()
    depth, amplitude, stable = branch.depth, branch.amplitude, branch.is_stable
    axes.plot(depth, amplitude, "--", color=GREY, label="unstable")
    runs = numpy.ma.masked_where(~stable, amplitude)
    axes.plot(depth, runs, color=COLOURS["Hopf"], linewidth=2, label="stable")
    if branch.folds:
        places = [(fold.depth, fold.amplitude) for fold in branch.folds]
        axes.plot(*zip(*places), "o", color=COLOURS["fold"], label="fold")
    axes.set_xlabel("axial depth, mm")
    axes.set_ylabel("amplitude, mm")
    axes.set_title(title, loc="left")
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.legend(frameon=False)
    return _saved(figure, file)


def _draw_ground(axes, found):
    if found.method != "semi-discretisation":
        return
    n = numpy.linspace(*found.speeds, GRID[0])
    a = numpy.linspace(*found.depths, GRID[1])
    radii = found.milling.spectral_radius(*numpy.meshgrid(n, a), accuracy=1e-2)
    axes.contourf(n, a, radii, levels=(1, max(1.1, radii.max())), colors=[UNSTABLE], zorder=0)


def _draw_curves(axes, found):
    """Stretches of one kind in one colour."""
    named = set()
    for curve, kinds in zip(found.curves, found.kind):
        start = 0
        for i in range(1, len(kinds) + 1):
            if i < len(kinds) and kinds[i] == kinds[start]:
                continue
            kind = kinds[start]
            axes.plot(
                *curve[start : i + 1].T,
                color=COLOURS[kind],
                linewidth=1.5,
                zorder=4,
                label=None if kind in named else kind,
            )
            named.add(kind)
            start = i
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.set_axisbelow(True)


def _draw_frequencies(axes, found):
    for curve, kinds, frequencies in zip(found.curves, found.kind, found.chatter_frequency):
        colours = [COLOURS[kind] for kind in kinds]
        axes.scatter(curve[:, 0], frequencies, c=colours, s=3, linewidths=0, rasterized=True)
    axes.set_xlabel("spindle speed, rev/min")
    axes.set_ylabel("chatter, Hz")
    axes.grid(color="#e8eaed", linewidth=0.6)


def _draw_errors(axes, found, feed):
    from matplotlib.lines import Line2D

    n = numpy.linspace(*found.speeds, MAP[0])
    a = numpy.linspace(max(found.depths[0], 1e-3), found.depths[1], MAP[1])
    errors = 1e3 * found.milling.surface_map(n, a, feed)
    if found.method == "semi-discretisation":
        radii = found.milling.spectral_radius(*numpy.meshgrid(n, a), accuracy=1e-2)
        errors = numpy.ma.masked_where(radii >= 1, errors)
    levels = [level for level in LEVELS_UM if errors.min() < level < errors.max()]
    if not levels:
        return
    lines = axes.contour(n, a, errors, levels=levels, colors=[GREY], linewidths=0.7, zorder=2)
    axes.clabel(lines, fmt="%d", fontsize=7)
    handle = Line2D([], [], color=GREY, lw=0.7, label="surface location error, \u00b5m")
    axes.add_line(handle)


def _draw_optimal(axes, found, frequency):
    milling = found.milling
    fastest = 60 * frequency / milling.teeth
    for k in range(1, RESONANCES + 1):
        if found.speeds[0] < fastest / k < found.speeds[1]:
            axes.axvline(fastest / k, color=GREY, linestyle=":", lw=0.8, zorder=1)
    if milling.helix_pitch is None:
        return
    speeds = numpy.array(found.speeds, dtype=float)
    named = set()
    for colour, words, depth in (
        (TRIVIAL, "trivial depths", lambda n: 0 * n + milling.helix_pitch / milling.teeth),
        (OTHER, "optimal depths", lambda n: milling.helix_pitch * n / (60 * frequency)),
    ):
        for j in range(1, RESONANCES + 1):
            line = j * depth(speeds)
            if line.min() > found.depths[1]:
                break
            label = None if words in named else words
            axes.plot(speeds, line, "-.", color=colour, linewidth=1, zorder=3, label=label)
            named.add(words)


def _saved(figure, file):
    if file is not None:
        save(figure, file)
    return figure
