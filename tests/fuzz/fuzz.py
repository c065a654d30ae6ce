"""Clears random pockets and judges every path by the simulator.

    PYTHONPATH=MOD python3 tests/fuzz/fuzz.py --minutes N --seed S [--operation NAME]
                                              [--failures FOLDER]

MOD is the addon's Mod folder, with the built core; `./run fuzz` makes one. Works for N minutes. A
case that breaks one of LIMITS, raises, crashes or takes too long is written to FOLDER as a case of
tests/corpus, with what was wrong in its note, and gets a line on the screen. Ends with a summary,
and with code 1 where anything was found. The same seed gives the same cases.
"""

import argparse
import json
import math
import multiprocessing
import queue
import random
import resource
import statistics
import sys
import time
from pathlib import Path

import kinds
import shapes

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
sys.dont_write_bytecode = True
from path_laws import (  # noqa: E402
    CUT,
    beyond_rounding,
    entry_share,
    kinks,
    level_entries,
    sharp_corners,
    wrong_side,
)

# Figure -> the most that is allowed.
LIMITS = {
    "over": 2.0,  # degrees of engagement above the angle, mean over 0.1 mm
    "link": 1.0,  # degrees of engagement of links
    "gouge": 0.005,  # mm
    "rest": 5e-4,  # of the area within reach
    "rate": 1.05,  # removal rate over the nominal
    "rapid": 0.0,  # mm of rapids in material
    "plunge": 0.0,  # mm of plunges in material
    "level": 0,  # moves of helices and ramps that do not descend
    "entry": 2.0,  # area of all entries over pi D^2, in pockets of one region; see limits_for
    "kinks": 0,  # turns over a degree between cuts in material, beyond one for each sharp corner
}
# The same for the operations that clear certain shapes only.
STRICTER = {"over": 1.0}
LEAST_CLIMB = 0.995  # share of the cutting length on the side asked for
SECONDS = 60  # for one path
PATIENCE = 360  # s of the clock: to judge 150 m of path at a small angle takes minutes
MEMORY = 4 << 30  # bytes, of the process that clears and judges
AGAIN = 10  # each tenth case is cleared twice: the moves must be the same
# Of the simulator: rows at most so far apart, and so many in a cut's width, or what is engaged at
# small angles is lost between them.
RESOLUTION, FINEST, ROWS = 0.05, 0.01, 16  # mm, mm, 1
REFUSALS = ("tool too large", "no lame curve")  # codes of errors that a random shape may deserve
OUTSIDE = "entry outside"  # the code where nothing can begin in a hole
IN_PASSAGE = "lies in a narrow passage that is skipped"
CHOSEN = ("choices", "open_edges", "hole", "rest_of", "open")
# mm: less than this may stay on walls: the tool keeps kWallGap off them, and follows lines that
# were an arc once within kFineShare of the tolerance.
FILM = 0.003
TIP = 0.6  # mm of cuts: so much may be made in tips, where fronts on both sides meet
# Of shapely's offsets: lines in a quarter of a circle, and a kind of join.
CIRCLE_LINES, MITRE = 90, 2
SHARP = math.radians(15)  # the lines of an arc turn by less
STEP = 0.05  # mm of path between two looks, or means over 0.1 mm hang on one place
# The same, where a mean is above its limit, and the rows: one look in a sliver of some micrometres
# counts less, and between rows 0.05 mm apart borders that touch seem to cross by a tenth of one.
CLOSE_STEP, MEANS = 0.01, ("over", "link", "rate")


def figures_of(case, path, scene, step=STEP):
    """{figure: value} of the program that is posted; those of LIMITS, and the time over the ideal
    as "ratio".
    """
    import evenload
    from posted import posted

    moves = posted(path.moves)
    run = evenload.simulate(moves, **scene, step=step)
    nominal = shapes.cut_width(case) * case["axial_depth"] * case["feed"]
    regions = 1 + sum(1 for move in moves[1:-1] if move[0] == 0 and move[3] >= 5.0) // 2
    return {
        "over": run.max_engagement_deg - case["engagement_deg"],
        "link": run.link_engagement_deg,
        "gouge": run.gouge_mm,
        "rest": rest_share(case, run),
        "rate": run.removal_rate_peak / nominal,
        "rapid": beyond_rounding(run.rapid_in_material_mm),
        "plunge": beyond_rounding(run.plunge_in_material_mm),
        "level": level_entries(moves, 0.0, -case["axial_depth"]),
        "entry": entry_share(run, case) / regions,
        "climb": climb_share(case, run),
        "kinks": kinks(run, moves) - max(sharp_corners(case), corners_of_centres(case)),
        "ratio": run.time_total_s / (60 * run.removed_volume_total / nominal),
    }


def rest_share(case, run):
    """Of the area within reach, without the film that walls may keep."""
    from evenload import planar
    from shapely.geometry import LinearRing

    walls = [LinearRing(planar.flattened(chain)) for chain in [case["outer"], *case["islands"]]]
    film = FILM * sum(wall.length for wall in walls)
    return max(0.0, run.rest_area - film) / max(run.removed_area + run.rest_area, 1e-9)


def climb_share(case, run):
    """Of the length of cuts, on the side asked for."""
    wrong = wrong_side(run, case.get("choices", {}).get("cut_mode") == "conventional")
    length = float(run.length[run.kind == CUT].sum())
    return 1 - max(0.0, wrong - TIP / max(length, TIP))


def corners_of_centres(case):
    """Where the tool's centre, as near to walls as it may come, turns into a corner: also between
    islands, where no wall does.
    """
    import choices
    from evenload import planar
    from shapely.geometry import Polygon
    from shapely.geometry.polygon import orient

    pocket = Polygon(planar.flattened(case["outer"])).buffer(0)
    if case.get("open"):
        pocket = pocket.envelope.buffer(2 * case["tool"], join_style=MITRE)
    for island in case["islands"]:
        pocket = pocket.difference(Polygon(planar.flattened(island)).buffer(0))
    centres = choices.pieces(pocket.buffer(-0.5 * case["tool"], CIRCLE_LINES))
    return sum(
        sharp_left_turns(list(ring.coords)[:-1])
        for piece in map(orient, centres)
        for ring in (piece.exterior, *piece.interiors)
    )


def sharp_left_turns(points):
    """How many: those between the lines of an arc do not count."""
    count = 0
    for i, (x, y) in enumerate(points):
        (x0, y0), (x1, y1) = points[i - 1], points[(i + 1) % len(points)]
        turn = math.atan2(y1 - y, x1 - x) - math.atan2(y - y0, x - x0)
        count += math.remainder(turn, 2 * math.pi) > SHARP
    return count


def judge(case, twice):
    """{"figures" or "wrong": ..., "compute": seconds of the processor}."""
    import choices
    from evenload import _core

    resolution = max(FINEST, min(RESOLUTION, shapes.cut_width(case) / ROWS))
    start = time.process_time()
    try:
        path, scene = choices.path_and_scene(case, resolution)
    except _core.GeometryError as error:
        deserved = error.code in REFUSALS or is_bad_place(case, error)
        return {"refused": str(error)} if deserved else _wrong(error)
    except choices.NothingLeft:
        return {"refused": "the tool before left nothing"}
    except (RuntimeError, ValueError) as error:
        return _wrong(error)
    compute = time.process_time() - start
    if twice and choices.path_and_scene(case, resolution)[0].moves != path.moves:
        return {"wrong": "cleared twice, the moves differ"}
    if not path.moves:
        skipped = case.get("choices", {}).get("narrow_passages") == "skip and report"
        return {"refused": "all of it is narrow"} if skipped else {"wrong": "no path"}
    answer = {"compute": compute, "notes": list(path.report.notes)}
    answer["figures"] = figures_of(case, path, scene)
    above = [fault.split()[0] for fault in faults(case, answer)]
    if set(above) & set(MEANS):
        if "rest_of" in case:  # the stock as well
            _, scene = choices.path_and_scene(case, FINEST)
        scene = {**scene, "resolution": FINEST}
        answer["figures"] = figures_of(case, path, scene, CLOSE_STEP)
    return answer


def is_bad_place(case, error):
    """Whether a random hole lies where nothing can begin: off a spiral's middle, or in a passage
    that is to be skipped.
    """
    if error.code != OUTSIDE or not case.get("hole"):
        return False
    return case.get("operation") == "lame_spiral" or IN_PASSAGE in str(error)


def _wrong(error):
    return {"wrong": "%s: %s" % (type(error).__name__, error)}


def work(tasks, answers):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for case, twice in iter(tasks.get, None):
        answers.put(judge(case, twice))


class Judge:
    """A process that judges one case after the other, and is replaced when it crashes or hangs."""

    def __init__(self):
        self._process = None

    def judged(self, case, twice):
        if self._process is None:
            self._start()
        self._tasks.put((case, twice))
        deadline = time.monotonic() + PATIENCE
        while True:
            try:
                return self._answers.get(timeout=1)
            except queue.Empty:
                if not self._process.is_alive():
                    code = self._process.exitcode
                    self._process = None
                    return {"wrong": "crashed with code %s" % code}
                if time.monotonic() > deadline:
                    self._process.kill()
                    self._process.join()
                    self._process = None
                    return {"wrong": "took more than %d s" % PATIENCE}

    def _start(self):
        self._tasks, self._answers = multiprocessing.Queue(), multiprocessing.Queue()
        self._process = multiprocessing.Process(
            target=work, args=(self._tasks, self._answers), daemon=True
        )
        self._process.start()

    def stop(self):
        if self._process is not None:
            self._tasks.put(None)
            self._process.join()


def faults(case, answer):
    """What is wrong with a judged case, a phrase each."""
    import choices

    if "wrong" in answer:
        return [answer["wrong"]]
    if "refused" in answer:
        return []
    limits = LIMITS if case.get("operation", "adaptive") == "adaptive" else {**LIMITS, **STRICTER}
    found = [
        "%s %.4g above %g" % (name, answer["figures"][name], limit)
        for name, limit in choices.limits_for(case, answer["notes"], limits).items()
        if not answer["figures"][name] <= limit
    ]
    slotted = choices.is_slotted(answer["notes"])
    if answer["figures"]["climb"] < LEAST_CLIMB and not slotted:
        found.append("climb %.4g below %g" % (answer["figures"]["climb"], LEAST_CLIMB))
    if answer["compute"] > SECONDS:
        found.append("took %.0f s" % answer["compute"])
    return found


class Summary:
    def __init__(self):
        self.cases = self.failed = self.refused = 0
        self.values = {}

    def add(self, case, answer, found):
        self.cases += 1
        self.failed += bool(found)
        self.refused += "refused" in answer
        for name, value in answer.get("figures", {}).items():
            self.values.setdefault(name, []).append((value, case["name"]))

    def lines(self):
        yield "%d cases, %d failed, %d too narrow" % (self.cases, self.failed, self.refused)
        for name, values in self.values.items():
            worst = min(values) if name == "climb" else max(values)
            median = statistics.median(value for value, _ in values)
            yield "%-7s median %8.4f, worst %8.4f in %s" % (name, median, *worst)


def random_case(operation, pick, number):
    """A case of a shape that the operation clears; None where the shape came out unusable."""
    if operation == "adaptive":
        return shapes.case(pick, number)
    of_kinds = kinds.KINDS[operation]
    kind = of_kinds[number % len(of_kinds)]
    outer, islands, is_open = kind(pick)
    name = "fuzz_%s_%s_%05d" % (operation.split("_")[0], kind.__name__, number)
    case = {**shapes.case_of(name, outer, islands, pick), "operation": operation}
    return {**case, "open": True} if is_open else case


def cases(seed, first, operation="adaptive"):
    """(number, case) without end; a case depends on the seed and its number alone. Each second one
    has choices beside the pocket.
    """
    import choices

    number = first
    while True:
        case = random_case(operation, random.Random("%d/%d" % (seed, number)), number)
        if case is not None:
            case["name"] += "_s%d" % seed
            if number % 2:
                choices.choose(random.Random("%d/%d/choices" % (seed, number)), case)
            yield number, case
        number += 1


def fuzz(minutes, seed, first, most, folder, operation="adaptive"):
    summary, judge_process = Summary(), Judge()
    end = time.monotonic() + 60 * minutes
    for number, case in cases(seed, first, operation):
        if time.monotonic() > end or (most and summary.cases >= most):
            break
        answer = judge_process.judged(case, number % AGAIN == 0)
        found = faults(case, answer)
        summary.add(case, answer, found)
        if found:
            case["note"] = "Found by fuzzing: %s." % "; ".join(found)
            folder.mkdir(parents=True, exist_ok=True)
            target = folder / (case["name"] + ".json")
            target.write_text(json.dumps(case, indent=1) + "\n")
            angle = case["engagement_deg"]
            chosen = {key: case[key] for key in CHOSEN if key in case}
            what = case["name"], angle, chosen or "", "; ".join(found)
            print("%s at %g deg%s: %s" % what, flush=True)
    judge_process.stop()
    return summary


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument(
        "--cases", type=int, default=0, help="at the most; 0: as many as there is time for"
    )
    parser.add_argument("--operation", choices=("adaptive", *kinds.KINDS), default="adaptive")
    parser.add_argument("--failures", type=Path, default=Path("fuzz_failures"))
    given = parser.parse_args()
    summary = fuzz(
        given.minutes, given.seed, given.first, given.cases, given.failures, given.operation
    )
    for line in summary.lines():
        print(line)
    return 1 if summary.failed else 0


if __name__ == "__main__":
    sys.exit(main())
