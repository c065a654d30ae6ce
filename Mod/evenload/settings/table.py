"""The settings of all operations, a row each: a new setting is a new row, in `shared` or `own`, and
its use in the core.

From the rows come the properties (`properties`), what the core is given (`parameters`), what is
refused (`ranges`), the rows of the panels, the names in job files, the labels in sentences
(`labels`) and the tables of the documentation (`pages`; `./run settings-pages` writes them).
"""

from evenload.settings.own import OF_ADAPTIVE, OF_LAME_SPIRAL, OF_TROCHOID, REST_MACHINING
from evenload.settings.shared import CONSTANT_FORCE, HOLE_ENTRIES, SETTINGS

__all__ = [
    "ALL",
    "BOXES",
    "CONSTANT_FORCE",
    "HOLE_ENTRIES",
    "OF_ADAPTIVE",
    "OF_LAME_SPIRAL",
    "OF_TROCHOID",
    "REST_MACHINING",
    "SETTINGS",
    "TOLERANCE",
    "boxes_of",
]

ALL = (*SETTINGS, *OF_ADAPTIVE, *OF_TROCHOID, *OF_LAME_SPIRAL)
(TOLERANCE,) = (row for row in SETTINGS if row.name == "Tolerance")
BOXES = ("Slot", "Spiral", "Cut", "Feeds", "Entry", "Path")  # of the panels, from the top


def boxes_of(settings):
    """[(title, [Setting, ...]), ...] of a panel for these settings."""
    found = [(title, [row for row in settings if row.box == title]) for title in BOXES]
    return [(title, rows) for title, rows in found if rows]
