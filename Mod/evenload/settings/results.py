"""What operations tell of a computed path, and what they keep for themselves: a row each, as in
`table`.
"""

from evenload.settings.setting import (
    ANGLE,
    AREA,
    INTEGER,
    LENGTH,
    LINKS,
    NUMBER,
    TEXT,
    TEXTS,
    VOLUME,
    Result,
)

FORMAT = 1  # of the properties in a document: to be raised when their meaning changes

RESULT_SETTINGS = (
    Result("MaxEngagement", ANGLE, 0.0, "Largest engagement angle, mean over 0.1 mm"),
    Result("CuttingTime", NUMBER, 0.0, "Time for cuts, links, entries and retracts, in s"),
    Result(
        "IdealTime",
        NUMBER,
        0.0,
        "Area over side step and feed, in s: the time if all were cut at the angle and the feed",
    ),
    Result("RemovedVolume", VOLUME, 0.0, "Volume that the path removes"),
    Result("UncutArea", AREA, 0.0, "Area that the tool could reach and did not clear"),
    Result("Passes", INTEGER, 0, "Cuts without a break, at all levels"),
    Result("Links", INTEGER, 0, "Ways at depth from cut to cut"),
    Result("Retracts", INTEGER, 0, "How often the tool rises and comes down again"),
    Result("Report", TEXT, "", "What was not done, where and why; the error of a failed operation"),
)

RESULTS_OF_TROCHOID = (
    Result(
        "TrochoidalStep",
        LENGTH,
        0.0,
        "How far the trochoid advances in each turn, along the longest slot; 0: no trochoid "
        "was repeated, see Report",
    ),
    Result(
        "Iterations",
        INTEGER,
        0,
        "Passes that were steered to find the shape of that trochoid; 0 for circles and "
        "cycloids, and where none was repeated",
    ),
    Result(
        "RemovalRate",
        NUMBER,
        0.0,
        "Volume over time along the longest slot at its first depth, links and the passes "
        "along both walls included, entry and ends not, in mm3/min",
    ),
)

RESULTS_OF_LAME_SPIRAL = (
    Result("ClearedShare", NUMBER, 0.0, "Share of the pocket that the spiral clears, 0 to 1"),
)

_OF_ALL = {row.name: row for row in RESULT_SETTINGS}
RESULTS_OF_FINISHING = (
    Result("PathLength", LENGTH, 0.0, "Length of cuts and of ways along the surface"),
    Result("LargestStepover", LENGTH, 0.0, "Of neighbouring passes, seen from above"),
    Result("LeastStepover", LENGTH, 0.0, "Of neighbouring passes, seen from above"),
)
# All results of the operation that finishes surfaces.
FINISHING_RESULTS = (
    *(_OF_ALL[name] for name in ("CuttingTime", "Passes", "Links", "Retracts", "Report")),
    *RESULTS_OF_FINISHING,
)

HIDDEN_SETTINGS = (
    Result(
        "OwnValues",
        TEXTS,
        [],
        "Names of the settings that no longer follow the tool or the geometry",
    ),
    Result(
        "EarlierOperations",
        LINKS,
        [],
        "What rest machining depends on: the job's operations before this one",
    ),
    Result("FormatVersion", INTEGER, FORMAT, "Format of this operation's properties"),
)
