# What the simulator says of a path that clears a case of the corpus, in the words of a table.
import math

import evenload
import numpy
import path_laws
import pocket_case

RAPID, LINK, ENTRY, CUT = range(4)
WINDOW = 0.1  # mm: of means
BAND = 3.0  # degrees about the angle
HELD = 0.85  # of the nominal removal rate
LEAST_LOAD = 0.9  # at which the simulator, which sees means of 0.02 mm, finds HELD everywhere
MOST_LINKED, CLOSE_STEP = 1.0, 0.02  # degrees; mm between looks, where links seem to exceed them


def links_at_depth(moves, link_feed):
    """The same moves; rapids that stay below the stock's top become links."""
    result = list(moves[:1])
    for before, move in zip(moves, moves[1:]):
        below = max(before[3], move[3]) < 0
        if move[0] == RAPID and below:
            move = (LINK, *move[1:7], link_feed)
        result.append(move)
    return result


def held_rates(run, nominal, max_feed):
    """Along cuts slower than `max_feed`: the least mean over WINDOW mm of the removal rate, and the
    share of the length on which it is HELD, both over the nominal rate.
    """
    slow = (run.kind == CUT) & (run.feed < 0.999 * max_feed)
    least, held, slow_length = math.inf, 0.0, 0.0
    length, area, window = 0.0, 0.0, []
    for i in range(1, len(run.x)):
        if not (slow[i] and slow[i - 1]):
            length, area, window = 0.0, 0.0, []
            continue
        rate = 0.5 * (run.removal_rate[i] + run.removal_rate[i - 1]) / nominal
        piece = run.length[i], run.length[i] * rate
        slow_length += piece[0]
        held += piece[0] if rate >= HELD else 0.0
        window.append(piece)
        length, area = length + piece[0], area + piece[1]
        while window and length - window[0][0] >= WINDOW:
            first = window.pop(0)
            length, area = length - first[0], area - first[1]
        if length >= WINDOW:
            least = min(least, max(0.0, area / length))
    return least, held / slow_length if slow_length else 1.0


def judged(case, moves, ideal_time=None, infer_kinds=True):
    """{figure: (value, unit)} of moves; ideal_time in s, None for what was cleared in this path."""
    scene = pocket_case.scene(case)
    run = evenload.simulate(moves, **scene, infer_kinds=infer_kinds)
    linked = run.link_engagement_deg
    if linked > MOST_LINKED:  # a first look may see what the cut before it is about to clear
        closer = evenload.simulate(moves, **scene, infer_kinds=infer_kinds, step=CLOSE_STEP)
        linked = closer.link_engagement_deg
    width = 0.5 * case["tool"] * (1 - math.cos(math.radians(case["engagement_deg"])))
    nominal = width * case["axial_depth"] * case["feed"]
    if ideal_time is None:
        ideal_time = 60 * run.removed_volume_total / nominal
    cuts = (run.kind == CUT) & (run.length > 0)
    middle = 0.5 * (run.engagement_deg + numpy.roll(run.engagement_deg, 1))
    near = cuts & (abs(middle - case["engagement_deg"]) <= BAND)
    kinks = path_laws.kinks(run, moves)
    least, held = held_rates(run, nominal, case["max_feed"])
    return {
        "time_ratio": (run.time_total_s / ideal_time, ""),
        "over": (run.max_engagement_deg - case["engagement_deg"], "deg"),
        "link_engagement": (linked, "deg"),
        "band3": (float(run.length[near].sum() / run.length[cuts].sum()), ""),
        "rate_worst": (run.removal_rate_peak / nominal, ""),
        "rate_least": (least, ""),
        "rate_held": (held, ""),
        "gouge": (run.gouge_mm, "mm"),
        "rest_share": (run.rest_area / run.removed_area, ""),
        "kinks": (kinks, ""),
        "kinks_beyond": (kinks - path_laws.sharp_corners(case), ""),
        "climb": (1 - path_laws.wrong_side(run, False), ""),
        "entry": (path_laws.entry_share(run, case), ""),
        "plunge": (path_laws.beyond_rounding(run.plunge_in_material_mm), "mm"),
        "blocks_per_metre": (path_laws.blocks_per_metre(run, moves), "1/m"),
    }
