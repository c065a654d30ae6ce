"""Figures of two cores side by side, and the cases which changed most."""

import statistics
from dataclasses import dataclass

MOST = 4  # cases of each figure that are named
# Figures by which cases are said to have changed, their titles, and the least that is named.
CHANGES = (
    ("ratio", "time/ideal", 0.001),
    ("over", "over, degrees", 0.05),
    ("rest", "left uncut", 1e-5),
    ("link", "links, degrees", 0.05),
    ("gouge", "gouge, mm", 0.001),
    ("kinks", "kinks", 1),
    ("retracts", "retracts", 1),
    ("blocks", "blocks/m", 5),
    ("seconds", "seconds", 0.5),
)
TITLES = ("", "", "cases", "time", "worst", "over", "left %", "link", "gouge", "kinks", "retr.")
WIDTHS = "%-14s%-10s%6s%8s%8s%8s%8s%7s%8s%7s%7s%8s%9s  %s"


@dataclass(frozen=True)
class Row:
    """Figures of a case by both; a figure, or all of them, may be missing."""

    name: str
    operation: str
    former: dict
    present: dict


def lines(rows, former, operations):
    """The table: two lines per operation and for all, the first for the revision `former`."""
    yield WIDTHS % (*TITLES, "blk/m", "seconds", "most over the angle in")
    there = {row.operation for row in rows}
    for operation in [*(each for each in operations if each in there), "all"]:
        group = [row for row in rows if operation in ("all", row.operation)]
        yield line(operation, former, [(row.name, row.former) for row in group])
        yield line("", "this tree", [(row.name, row.present) for row in group])
    yield "time: over the ideal, median and worst; over: degrees above the angle, left %: of the"
    yield "area, link: degrees, gouge: mm, the worst of each; kinks beyond sharp corners, retracts"
    yield "and seconds of the processor: sums; blk/m: blocks per metre, median."


def line(operation, tree, cases):
    """cases: (name, figures)."""

    def all_of(figure):
        return [each[figure] for _, each in cases if figure in each]

    def told(form, reduce, figure, scale=1):
        values = all_of(figure)
        return form % (scale * reduce(values)) if values else "-"

    over = [(each["over"], name) for name, each in cases if "over" in each]
    return WIDTHS % (
        operation,
        tree,
        len(all_of("ratio")),
        told("%.3f", statistics.median, "ratio"),
        told("%.3f", max, "ratio"),
        told("%.2f", max, "over"),
        told("%.3f", max, "rest", 100),
        told("%.2f", max, "link"),
        told("%.4f", max, "gouge"),
        told("%d", lambda values: sum(max(0, value) for value in values), "kinks"),
        told("%d", sum, "retracts"),
        told("%.0f", statistics.median, "blocks"),
        told("%.1f", sum, "seconds"),
        max(over)[1] if over else "",
    )


def changed_most(rows):
    """A line for each of the cases in which a figure changed most, figure by figure."""
    for figure, title, least in CHANGES:
        both = [row for row in rows if figure in row.former and figure in row.present]
        changes = [(row.present[figure] - row.former[figure], row) for row in both]
        changes = [pair for pair in changes if abs(pair[0]) >= least]
        for change, row in sorted(changes, key=lambda pair: -abs(pair[0]))[:MOST]:
            values = row.former[figure], row.present[figure], change
            yield "%-16s%10.4g -> %-10.4g%+10.4g  %s" % (title, *values, row.name)
