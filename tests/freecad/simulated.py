"""A Simulation made by hand from an operation's own profile, for pictures and reports."""

import math
from types import SimpleNamespace

import numpy
from evenload import commands, compiled

FEED, RAPID_FEED, TEETH, SPEED = 255.0, 5000.0, 1, 6366.0


def _means(values, length, window=0.1):
    """Means over the last `window` mm: in a sharp corner a single place may meet any angle."""
    area, along = numpy.cumsum(length * values), numpy.cumsum(length)
    return (area - numpy.interp(along - window, along, area)) / window


def simulated(op, **changes):
    """A Simulation of an operation that has been computed: its path and engagement are the core's,
    loads follow from them, and there is no rest and no incident unless `changes` say so.
    """
    last = op.Proxy.last
    profile = compiled.core().engagement_profile(
        last.cuts[0].material, last.toolpath, last.tool.diameter, hole=last.hole
    )
    x, y, degrees, kind = (numpy.array(column) for column in zip(*profile))
    length = numpy.hypot(numpy.diff(x, prepend=x[0]), numpy.diff(y, prepend=y[0]))
    degrees = _means(degrees, length)
    feed = numpy.where(kind == commands.CUT, FEED, RAPID_FEED)
    time = numpy.cumsum(60 * length / feed)
    radius, depth = last.tool.diameter / 2, op.StartDepth.Value - op.FinalDepth.Value
    share = 1 - numpy.cos(numpy.radians(degrees))
    per_tooth = FEED / SPEED / TEETH
    thickest = per_tooth * numpy.where(degrees < 90, numpy.sin(numpy.radians(degrees)), 1.0)
    rate = numpy.where(kind == commands.CUT, radius * share * depth * feed, 0.0)
    force = depth * (2000 * thickest + 25) * (degrees > 0)
    cuts = kind == commands.CUT
    worst = int(numpy.argmax(numpy.where(cuts, degrees, 0)))
    result = dict(x=x, y=y, kind=kind, length=length, time_s=time, engagement_deg=degrees)
    result.update(z=numpy.full(len(x), op.FinalDepth.Value), removal_rate=rate, notes=[])
    result.update(force_peak=force, force_mean=force * degrees / 360)
    result.update(
        max_engagement_deg=float(degrees[worst]),
        max_engagement_at=(float(x[worst]), float(y[worst])),
        entry_engagement_deg=0.0,
        top=op.StartDepth.Value,
        fixture_mm=None,
        removal_rate_peak=float(rate.max()),
        force_peak_max=float(force.max()),
        removed_volume_total=900.0 * depth,
        time_total_s=float(time[-1]),
        machine_time_total_s=None,
        air_mm=1.5,
    )
    for number, name in enumerate(("rapid_mm", "link_mm", "entry_mm", "cut_mm")):
        result[name] = float(length[kind == number].sum())
    for name in ("gouge", "rapid_in_material", "plunge_in_material"):
        result.update({name + "_mm": 0.0, name + "_at": None})
    result.update(rest_area=0.0, rest_depth=0.0, rest_at=None, rests=[], rest_outlines=[])
    result["incidents"] = []
    result.update(changes)
    return SimpleNamespace(**result)


def faulty(op, **changes):
    """The same with two patches left, a gouge, two rapids and a plunge in material, forces and a
    machine's time.
    """
    faults = dict(
        gouge_mm=0.05,
        gouge_at=(0.0, 12.0),
        rest_area=1.45,
        rest_depth=3.0,
        rest_at=(4.0, 26.0),
        rests=[(1.0, 4.0, 26.0, 3.0), (0.45, 25.0, 4.0, 0.5)],
        rest_outlines=[
            [(3.5, 25.5), (4.5, 25.5), (4.5, 26.5), (3.5, 26.5)],
            [(25 + 0.38 * math.cos(a), 4 + 0.38 * math.sin(a)) for a in range(6)],
        ],
        rapid_in_material_mm=2.5,
        rapid_in_material_at=(9.0, 9.0),
        plunge_in_material_mm=3.0,
        plunge_in_material_at=(20.0, 20.0),
        incidents=[
            ("gouge", 0.0, 12.0, -3.0, 17, 0, 0.05),
            ("rapid in material", 9.0, 9.0, -1.0, 40, 0, 1.5),
            ("rapid in material", 11.0, 9.0, -1.0, 41, 0, 1.0),
            ("plunge in material", 20.0, 20.0, -3.0, 80, 0, 3.0),
        ],
        machine_time_total_s=150.0,
    )
    return simulated(op, **{**faults, **changes})
