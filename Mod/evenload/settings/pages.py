"""The tables of settings in the documentation, from the rows."""

import re

from evenload.settings.setting import ANGLE, BOOL, CHOICE, LENGTH, NUMBERS
from evenload.settings.table import (
    FINISHING,
    OF_ADAPTIVE,
    OF_LAME_SPIRAL,
    OF_TROCHOID,
    SETTINGS,
    boxes_of,
)

PAGES = {
    "adaptive_operation.md": (*SETTINGS, *OF_ADAPTIVE),
    "trochoid_operation.md": OF_TROCHOID,
    "lame_spiral_operation.md": OF_LAME_SPIRAL,
    "finishing_operation.md": FINISHING,
}
HEAD = "| property | default | meaning |\n|---|---|---|\n"
SEEN = re.compile("^" + re.escape(HEAD) + r"(?:\|.*\n)*", re.MULTILINE)


def renewed(name, page):
    """The text of one of PAGES with its table as the rows have it now."""
    table = HEAD + "".join(
        "| %s | %s | %s |\n" % (row.name, default(row), row.page)
        for _, rows in boxes_of(PAGES[name])
        for row in rows
    )
    assert len(SEEN.findall(page)) == 1, "%s has no table of settings, or several" % name
    return SEEN.sub(lambda _: table, page)


def default(row):
    """The default of a setting, as a cell of the table."""
    if row.default or row.fitted:
        return row.default or "fitted"
    if row.type == BOOL:
        return "yes" if row.value else "no"
    if row.type == CHOICE:
        return row.value[0]
    if row.type == NUMBERS:
        return "empty"
    unit = {ANGLE: "°", LENGTH: " mm"}.get(row.type, "") if row.value else ""
    return "%g%s" % (row.value, unit)
