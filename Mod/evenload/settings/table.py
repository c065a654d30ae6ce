"""The settings of all operations, a row each: a new setting is a new row, in `shared` or `own`, and
its use in the core.

From the rows come the properties (`properties`), what the core is given (`parameters`), what is
refused (`ranges`), the rows of the panels, the names in job files, the labels in sentences
(`labels`) and the tables of the documentation (`pages`; `./run settings-pages` writes them).
"""

from dataclasses import replace

from evenload.settings.own import (
    BETWEEN_GUIDES,
    EVEN_CUSPS,
    OF_ADAPTIVE,
    OF_FINISHING,
    OF_LAME_SPIRAL,
    OF_TROCHOID,
    PARALLEL,
    SPIRALS,
    REST_MACHINING,
)
from evenload.settings.shared import (
    CONSTANT_CHIP,
    CONSTANT_FEED,
    CONSTANT_FORCE,
    HOLE_ENTRIES,
    SETTINGS,
)

__all__ = [
    "ALL",
    "BETWEEN_GUIDES",
    "BOXES",
    "CONSTANT_CHIP",
    "CONSTANT_FORCE",
    "EVEN_CUSPS",
    "FINISHING",
    "HOLE_ENTRIES",
    "OF_ADAPTIVE",
    "OF_FINISHING",
    "OF_LAME_SPIRAL",
    "OF_TROCHOID",
    "PARALLEL",
    "REST_MACHINING",
    "SETTINGS",
    "SPIRALS",
    "TOLERANCE",
    "boxes_of",
    "sections_of",
    "without_open_sides",
]

ALL = (*SETTINGS, *OF_ADAPTIVE, *OF_TROCHOID, *OF_LAME_SPIRAL, *OF_FINISHING)
(TOLERANCE,) = (row for row in SETTINGS if row.name == "Tolerance")
BOXES = ("Slot", "Spiral", "Passes", "Cut", "Feeds", "Entry", "Path")  # of the panels, from the top

_NAMED = {row.name: row for row in (*SETTINGS, *OF_FINISHING)}
_STOCK = _NAMED["StockOnFaces"]  # stands below the feed control, which asks for it
# All settings of the operation that finishes surfaces.
FINISHING = (
    *(row for row in OF_FINISHING if row is not _STOCK),
    _NAMED["CutMode"],
    # The core's path knows one feed: what follows chips is found for it afterwards.
    replace(
        _NAMED["FeedControl"],
        value=[CONSTANT_FEED, CONSTANT_CHIP],
        doc="What stays the same along the cuts: the feed, or the mean thickness of a ball's chips",
        keyword=None,
        is_first=False,
        page="or Constant chip thickness: each cut at the feed at which a ball's chip has the mean "
        "thickness that it has on a plane, [as far as MaximumFeed allows]"
        "(finishing.md#7-feeds-by-chip-thickness)",
    ),
    _NAMED["MaximumFeed"],
    _STOCK,
    replace(
        TOLERANCE,
        doc="Largest distance of the path from the exact one, the surface's triangles included; "
        "into the part usually a third of it, at the most half",
        page="largest distance of the path from the exact one, the triangles that stand for the "
        "surface included; into the part it usually goes by a third of it, at the most by half",
    ),
    replace(_NAMED["Arcs"], page="no: lines only, also along contours and spirals"),
)


def boxes_of(settings):
    """[(title, [Setting, ...]), ...] of a panel for these settings."""
    found = [(title, [row for row in settings if row.box == title]) for title in BOXES]
    return [(title, rows) for title, rows in found if rows]


def sections_of(settings):
    """([Setting, ...] that a panel shows at first, [(title, [Setting, ...]), ...] of its folded
    rest) for these settings, from the top.
    """
    boxes = boxes_of(settings)
    folded = [(title, [row for row in rows if not row.is_first]) for title, rows in boxes]
    first = [row for _, rows in boxes for row in rows if row.is_first]
    return first, [(title, rows) for title, rows in folded if rows]


def without_open_sides(settings):
    """The same settings for an operation that comes in over no open side."""
    return tuple(row for row in settings if row.name not in ("ChooseOpenSide", "OpenSideAt"))
