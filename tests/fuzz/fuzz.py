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
import statistics
import sys
import time
from pathlib import Path

import worker

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
sys.dont_write_bytecode = True
import figures  # noqa: E402
import random_cases  # noqa: E402

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
    "kinks": 10,  # turns over a degree between cuts in material, beyond one for each sharp corner
}
# The same for the operations that clear certain shapes only.
STRICTER = {"over": 1.0}
LEAST_CLIMB = 0.995  # share of the cutting length on the side asked for
SECONDS = 60  # for one path
PATIENCE = 360  # s of the clock: to judge 150 m of path at a small angle takes minutes
AGAIN = 10  # each tenth case is cleared twice: the moves must be the same
REFUSALS = ("tool too large", "no lame curve")  # codes of errors that a random shape may deserve
OUTSIDE = "entry outside"  # the code where nothing can begin in a hole
IN_PASSAGE = "hole_in_skipped_passage"  # the kind of that error in a passage that is to be skipped
CHOSEN = ("choices", "open_edges", "hole", "rest_of", "open")


def figures_of(case, path, scene, step=figures.STEP):
    """{figure: value} of the program that is posted."""
    import evenload
    from posted import posted

    moves = posted(path.moves)
    return figures.figures_of(case, moves, evenload.simulate(moves, **scene, step=step))


def judge(case, twice):
    """{"figures" or "wrong": ..., "compute": seconds of the processor}."""
    import choices
    from evenload import _core

    resolution = figures.resolution_for(case)
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
    answer = {"compute": compute, "findings": [code for code, _, _ in path.report.findings]}
    answer["figures"] = figures_of(case, path, scene)
    above = [fault.split()[0] for fault in faults(case, answer)]
    if set(above) & set(figures.MEANS):
        if "rest_of" in case:  # the stock as well
            _, scene = choices.path_and_scene(case, figures.FINEST)
        scene = {**scene, "resolution": figures.FINEST}
        answer["figures"] = figures_of(case, path, scene, figures.CLOSE_STEP)
    return answer


def is_bad_place(case, error):
    """Whether a random hole lies where nothing can begin: off a spiral's middle, or in a passage
    that is to be skipped.
    """
    if error.code != OUTSIDE or not case.get("hole"):
        return False
    return case.get("operation") == "lame_spiral" or error.kind == IN_PASSAGE


def _wrong(error):
    return {"wrong": "%s: %s" % (type(error).__name__, error)}


def judged(process, case, twice):
    """What `judge` returns in another process, or what became of that."""
    try:
        return process.call(PATIENCE, judge, case, twice)
    except worker.Failed as error:
        return {"wrong": str(error)}


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
        for name, limit in choices.limits_for(case, answer["findings"], limits).items()
        if not answer["figures"][name] <= limit
    ]
    slotted = choices.is_slotted(answer["findings"])
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


def fuzz(minutes, seed, first, most, folder, operation="adaptive"):
    summary, process = Summary(), worker.Worker()
    end = time.monotonic() + 60 * minutes
    for number, case in random_cases.cases(seed, first, operation):
        if time.monotonic() > end or (most and summary.cases >= most):
            break
        answer = judged(process, case, number % AGAIN == 0)
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
    process.stop()
    return summary


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument(
        "--cases", type=int, default=0, help="at the most; 0: as many as there is time for"
    )
    parser.add_argument("--operation", choices=random_cases.OPERATIONS, default="adaptive")
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
