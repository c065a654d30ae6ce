"""Compares `evenload.simulate` with an independent judge, on posted G-code of pockets.

    python3 bench/judge_agreement.py JUDGE CASES PATHS

CASES is a folder of pockets as in tests/corpus; those are compared for which PATHS has both
NAME.ngc, the posted G-code, and NAME.mv, the same path in the judge's words. JUDGE is a command
("judge -step 0.02") that reads the latter from its input and prints a JSON object with

    eng_max, eng_mean   degrees: the worst mean over 0.1 mm of cutting moves, and their mean
    link_eng_max        degrees: the same of links
    cut_mm              length of the cutting moves, over which eng_mean is taken
    gouge, left_area    mm, mm2

NAME.mv is text, in mm and mm/min, a line for each thing:

    tool R | nominal FEED                          the tool's radius, the feed
    pocket N x y ... | island N x y ...            polygons that the tool must not cross
    hole x y radius | openoutside N x y ...        ground without material: a disc, or all outside
    F x y feed | R x y feed                        to cut there, to link there, from the last place
    H x y feed | N x y feed                        a sloping move that ends on the floor, or above
    V x y | J x y | K angle                        a plunge, a jump above the stock, a kink ahead

Cutting are the moves on the floor that are no faster than the case's `max_feed`. The judge's steps
must be short beside them, or it misses their worst. PYTHONPATH must hold the addon's Mod folder.
Ends with the largest differences, and with code 1 where nothing was compared.
"""

import json
import shlex
import subprocess
import sys
from pathlib import Path

import evenload
import numpy
import pocket_case

LINK, CUT = 1, 3
FLOOR = 1e-3  # mm above the floor that are still on it: G-code is rounded
# Column, key of the judge, width and digits
COLUMNS = (
    ("worst", "eng_max", 8, 2),
    ("mean", "eng_mean", 8, 3),
    ("link", "link_eng_max", 7, 2),
    ("gouge", "gouge", 8, 4),
    ("rest", "left_area", 9, 3),
)


def judged(judge, moves):
    """What the judge says of a path in its own words."""
    with open(moves, encoding="utf-8") as file:
        output = subprocess.run(judge, stdin=file, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(output.stdout)


def felt(case, path, cut_length):
    """The same by the simulator."""
    run = evenload.simulate(path, **pocket_case.scene(case))
    cutting = numpy.isin(run.kind, (LINK, CUT)) & (run.length > 0)
    cutting &= (run.z <= FLOOR - case["axial_depth"]) & (run.feed <= 1.001 * case["max_feed"])
    i = numpy.flatnonzero(cutting)
    sums = (run.engagement_deg[i - 1] + run.engagement_deg[i]) / 2 * run.length[i]
    return {
        "eng_max": run.max_engagement_deg,
        "eng_mean": float(sums.sum()) / cut_length if cut_length > 0 else 0.0,
        "link_eng_max": run.link_engagement_deg,
        "gouge": run.gouge_mm,
        "left_area": run.rest_area,
    }


def compare(judge, cases, paths):
    """{column: (difference, name of the case)} of the largest; prints a row for each case."""
    print("%-16s" % "case" + "".join("| %-*s" % (3 * w + 2, t) for t, _, w, _ in COLUMNS))
    each = ("felt", "judge", "differ")
    print(" " * 16 + "".join("|" + "".join(" %*s" % (w, e) for e in each) for *_, w, _ in COLUMNS))
    largest = {}
    for file in sorted(Path(cases).glob("*.json")):
        name = file.stem
        program, moves = (Path(paths) / (name + suffix) for suffix in (".ngc", ".mv"))
        if not (program.exists() and moves.exists()):
            print("%-16s| no path" % name)
            continue
        theirs = judged(judge, moves)
        try:
            ours = felt(pocket_case.load(name, cases), program, theirs["cut_mm"])
        except ValueError as error:
            print("%-16s| %s" % (name, error))
            continue
        row = ""
        for title, key, width, digits in COLUMNS:
            difference = ours[key] - theirs[key]
            values = (ours[key], theirs[key], difference)
            row += "|" + "".join(" %*.*f" % (width, digits, value) for value in values)
            if title not in largest or abs(difference) > abs(largest[title][0]):
                largest[title] = difference, name
        print("%-16s%s" % (name, row), flush=True)
    return largest


def main(arguments):
    if len(arguments) != 3:
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    judge, cases, paths = arguments
    largest = compare(shlex.split(judge), cases, paths)
    if not largest:
        print("Nothing was compared: '%s' has no .ngc with its .mv for '%s'." % (paths, cases))
        return 1
    print("\nlargest differences")
    for title, (difference, name) in largest.items():
        print("%-8s %+.4f in %s" % (title, difference, name))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
