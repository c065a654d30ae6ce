# The table of bench_adaptive: its figures case by case, and what is required and wished of them.
PUBLIC = (
    "boss_open",
    "circle12",
    "comb",
    "inch_slot",
    "lame_hex50",
    "lame_square35",
    "lshape",
    "ring",
    "slot875",
    "slot9",
    "square60",
    "square_island",
    "star",
    "too_small",
    "two_rooms",
    "two_rooms_closed",
)
TOO_SMALL = ("too_small",)  # no path: both only have to find that out
CLEARABLE = len(PUBLIC) - len(TOO_SMALL)

COLUMNS = (
    ("time_ratio", "time", "%7.3f"),
    ("over", "over", "%7.2f"),
    ("link_engagement", "linkE", "%7.2f"),
    ("band3", "band3", "%7.2f"),
    ("rate_worst", "rate+", "%7.3f"),
    ("rate_least", "rate-", "%7.3f"),
    ("rate_held", "held", "%7.2f"),
    ("gouge", "gouge", "%7.3f"),
    ("kinks", "kinks", "%7.0f"),
    ("climb", "climb", "%7.3f"),
    ("entry", "entry", "%7.2f"),
    ("plunge", "plunge", "%7.2f"),
    ("blocks_per_metre", "blk/m", "%7.0f"),
    ("compute", "comp s", "%7.3f"),
)


SUMMARIES = ("median", "worst", "sum")  # rows below those of the cases
# (what, its key; FreeCAD's after "freecad_", whether it is to be at least or at most what follows:
# required, wished; what was published, where something was) of the second table
GOALS = (
    ("star: time / ideal", "star.%stime_ratio", "<=", 1.18, 1.10, "1.22, 1.55"),
    ("time / ideal, median", "median.%stime_ratio", "<=", 1.15, 1.08),
    ("over the angle, degrees", "worst.%sover", "<=", 2, 0.5),
    ("star: cut within 3 degrees", "star.%sband3", ">=", 0.70, 0.85),
    ("removal rate, largest", "worst.%srate_worst", "<=", 1.05, 1.02, "1.015"),
    ("removal rate where F < max", "worst.%srate_least", ">=", 0.85, 0.98),
    ("share of the length with 0.85", "worst.%srate_held", ">=", 1, 1),
    ("engagement of links, degrees", "worst.%slink_engagement", "<=", 1, 1),
    ("gouge, mm", "worst.%sgouge", "<=", 0.005, 0.005),
    ("area left / cleared", "worst.%srest_share", "<=", 0.0005, 0.0005),
    ("kinks beyond sharp corners", "worst.%skinks_beyond", "<=", 5, 0),
    ("share of the cut in climb", "worst.%sclimb", ">=", 0.995, 0.995),
    ("area of entries / pi D^2", "worst.%sentry", "<=", 2, 2),
    ("plunges in material, mm", "worst.%splunge", "<=", 0, 0),
    ("cases with a path", "sum.%spaths", ">=", CLEARABLE, CLEARABLE),
    ("star: blocks per metre", "star.%sblocks_per_metre", "<=", 1100, 700),
    ("compute / FreeCAD's", "sum.%scompute_ratio", "<=", 0.5, 0.1),
)
PUBLISHED = (
    "Published best: the star in 1.22 times the ideal time by Jacso's hybrid with feed control, in "
    "1.55 by VoluMill; the removal rate within 1.5 % [Jacso 2021]."
)


def table(values):
    """The figures side by side, a line for each case and operation, then those of all cases, and
    what is required and wished beside them; values: {name: value}.

    evenly: with LeastLoad, for an even removal rate instead of few blocks.
    time: over the ideal; linkE: engagement of links in degrees; rate+, rate-: the largest removal
    rate and, where F < MaximumFeed, the least, over the nominal; held: the share of the length with
    such a feed on which it is 0.85 or more; kinks: turns above a degree in material; climb: its
    share of the length in material; entry: the area that entries clear, over pi D^2; plunge: mm.
    """
    yield "%-17s %-8s" % ("case", "path") + "".join("%8s" % title for _, title, _ in COLUMNS)
    for name in (*PUBLIC, *SUMMARIES):
        for which, maker in (("", "EvenLoad"), ("even_", "evenly"), ("freecad_", "FreeCAD")):
            line = "%-17s %-8s" % (name, maker)
            for figure, _, form in COLUMNS:
                value = values.get("adaptive.%s.%s%s" % (name, which, figure))
                line += " " + ("%7s" % "-" if value is None else form % value)
            yield line
    yield ""
    yield "%-30s%10s%10s%10s%12s%10s%16s  %s" % (
        "of all cases",
        "FreeCAD",
        "EvenLoad",
        "evenly",
        "required",
        "wished",
        "published best",
        "EvenLoad is",
    )
    for title, key, *goal in GOALS:
        yield goal_line(values, title, "adaptive." + key, *goal)
    yield PUBLISHED


def goal_line(values, title, key, sign, required, wished, published="-"):
    """One line: FreeCAD's figure, ours, ours with LeastLoad, how far ours is as it should be."""
    theirs, value, even = (values.get(key % which) for which in ("freecad_", "", "even_"))
    line = "%-30s" % title
    for number in (theirs, value, even):
        line += "%10s" % ("-" if number is None else "%.4g" % number)
    line += "%12s%10s" % ("%s %g" % (sign, required), "%s %g" % (sign, wished))
    line += "%16s" % published
    if value is None:
        return line + "  not measured"
    kept = [value <= goal if sign == "<=" else value >= goal for goal in (required, wished)]
    return line + "  " + ("as wished" if kept[1] else "as required" if kept[0] else "MISSED")
