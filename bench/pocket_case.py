# A pocket of tests/corpus, or of another folder, as the core and the simulator take it.
import json
import math
from pathlib import Path

from evenload import _core

CORPUS = Path(__file__).resolve().parents[1] / "tests" / "corpus"
GENERATORS = {
    "adaptive": _core.clear_pocket,
    "trochoid": lambda *regions, **parameters: _core.clear_slot(*regions, **parameters)[0],
    "lame_spiral": _core.clear_with_lame_spiral,
}
FEEDS = ("feed", "link_feed", "max_feed")


def load(name, folder=CORPUS):
    return json.loads((Path(folder) / (name + ".json")).read_text())


def chain(points):
    return [tuple(point) for point in points]


def region(case):
    """Its Region, with the pieces of the outline marked that are edges of the stock."""
    edges = case.get("open_edges", [])
    outer = [(*v, bool(case.get("open")) or i in edges) for i, v in enumerate(case["outer"])]
    return _core.Region(outer, [chain(island) for island in case["islands"]])


def path_of(case, generator=None, **parameters):
    """The Toolpath that clears it, at a constant removal rate unless told otherwise; parameters:
    more of the generator's, before those in the case's own "choices". generator: the core's; else
    the one for the case's "operation", which is adaptive where it does not say.
    """
    generate = generator or GENERATORS[case.get("operation", "adaptive")]
    feed, link_feed, maximum_feed = (case[key] for key in FEEDS)
    entry = {}
    if case.get("hole"):
        x, y, diameter = case["hole"]
        entry = {"entry": "predrilled hole", "entry_point": (x, y), "hole_diameter": diameter}
    chosen = {**case.get("choices", {}), **parameters}
    if isinstance(chosen.get("force_coefficients"), (list, tuple)):
        chosen["force_coefficients"] = _core.ForceCoefficients(*chosen["force_coefficients"])
    return generate(
        [region(case)],
        tool_diameter=case["tool"],
        engagement_angle=math.radians(case["engagement_deg"]),
        feed=feed,
        plunge_feed=feed,
        link_feed=link_feed,
        maximum_feed=maximum_feed,
        roll_radius=case["roll_radius"],
        levels=[-case["axial_depth"]],
        safe_height=3.0,
        clearance_height=5.0,
        **{"feed_control": "constant removal rate", **entry, **chosen},
    )


def scene(case):
    """Arguments for `evenload.simulate` but for the path: a block round the pocket, whose walls and
    islands must stay, or, if its outline is the stock's edge, that outline; the hole is drilled.
    """
    outer, islands = chain(case["outer"]), [_core.Region(chain(i)) for i in case["islands"]]
    stock, part, earlier = outer, islands, []
    if not case.get("open"):
        xs, ys = [x for x, _, _ in outer], [y for _, y, _ in outer]
        # Bulges reach out of the corners' box by no more than its size.
        margin = 2 * case["tool"] + max(max(xs) - min(xs), max(ys) - min(ys))
        low, high = (min(xs) - margin, min(ys) - margin), (max(xs) + margin, max(ys) + margin)
        stock = (*low, *high)
        block = [(*low, 0), (high[0], low[1], 0), (*high, 0), (low[0], high[1], 0)]
        part = [_core.Region(block, [outer]), *islands]
    if case.get("hole"):
        x, y, diameter = case["hole"]
        down = [(0, x, y, 5, 0, 0, 0, 0), (2, x, y, -case["axial_depth"], 0, 0, 0, 100)]
        earlier = [(down, diameter)]
    return {
        "stock": stock,
        "top": 0,
        "bottom": -case["axial_depth"],
        "tool_diameter": case["tool"],
        "part": part,
        "earlier": earlier,
    }
