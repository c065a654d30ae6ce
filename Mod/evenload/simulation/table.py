"""The samples of simulations as a table. Needs no FreeCAD."""

import csv

from evenload.planar import CUT, ENTRY, LINK, RAPID

KINDS = {RAPID: "rapid", LINK: "link", ENTRY: "entry", CUT: "cut"}
# (heading, the Simulation's attribute): a column stays empty where a simulation has no such values.
COLUMNS = (
    ("Line", "line"),
    ("x, mm", "x"),
    ("y, mm", "y"),
    ("z, mm", "z"),
    ("Time at programmed feeds, s", "time_s"),
    ("Time on the machine, s", "machine_time_s"),
    ("Feed, mm/min", "feed"),
    ("Engagement angle, degrees", "engagement_deg"),
    ("Axial depth, mm", "axial_depth"),
    ("Removal rate, mm3/min", "removal_rate"),
    ("Chip thickness, mm", "h_max"),
    ("Peak force, N", "force_peak"),
    ("Mean force, N", "force_mean"),
    ("Gouge, mm", "gouge"),
)


def write_csv(path, runs):
    """Writes a row for each sample. runs: of (name of an operation, Simulation). Raises OSError."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(["Operation", "Move", *(heading for heading, _ in COLUMNS)])
        for name, simulation in runs:
            columns = [_column(getattr(simulation, key)) for _, key in COLUMNS]
            for number, kind in enumerate(simulation.kind.tolist()):
                cells = [column[number] if column else "" for column in columns]
                table.writerow([name, KINDS[kind], *cells])


def _column(values):
    """Values as they are written; None where there are none. What is not a number stays empty."""
    if values is None:
        return None
    if values.dtype.kind in "iu":
        return values.tolist()
    return ["%.6g" % each if each == each else "" for each in values.tolist()]
