"""Whether this tree clears the same cases by the same bytes as another revision of it.

    PYTHONPATH=MOD python3 tests/same/same.py --revision NAME --former FOLDER --present FOLDER
                [--figures] [--only corpus | random] [--operation NAME] [--jobs N] [--seconds N]

MOD is the addon's Mod folder, with the built core; the folders hold the module _core of the
revision and of this tree: `./run same REV` makes them. Tells the cases that differ, figures of both
for these, or with --figures for all, and last how many are equal and how many differ; ends with
code 1 where any differs, but with --figures with 0.
"""

import argparse
import os
import queue
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/same", "tests/fuzz", "bench")]
sys.dont_write_bytecode = True
# None of these loads a core, or the processes that are spawned would have this tree's.
import clearing  # noqa: E402
import comparison  # noqa: E402
import judging  # noqa: E402
import same_cases  # noqa: E402
import table  # noqa: E402
import worker  # noqa: E402

SECONDS = 180  # of the clock, to clear a case
PATIENCE = 400  # of the clock, to judge one by both, or more to clear one
EVERY = 50  # cases after which it is told how many are done


@dataclass
class Answer:
    """What became of a task. refused: why it does not apply; row: of the table, or None."""

    task: same_cases.Task
    verdict: str = comparison.UNKNOWN
    how: str = None
    refused: str = None
    row: table.Row = None
    seconds: tuple = (0.0, 0.0)  # of the processor: former, present


class Pair:
    """A process with the core of the revision, and one with this tree's. They take turns. former,
    present: the folders of the cores.
    """

    def __init__(self, former, present, seconds=SECONDS):
        folders = (former, present)
        self._seconds = seconds
        self._processes = [
            worker.Worker("spawn", partial(clearing.take_core, folder)) for folder in folders
        ]

    def core_files(self):
        """Those which the two have loaded. Raises worker.Failed where one cannot."""
        return [each.call(self._seconds, clearing.core_file) for each in self._processes]

    def answer(self, task, figures=False):
        """The Answer; figures: of equal ones as well."""
        prepared = self._standing(task.case)
        if "refused" in prepared:
            return Answer(task, refused=prepared["refused"])
        results = self._both(task.case, prepared["standing"])
        found = Answer(task, *comparison.verdict(*results))
        found.seconds = tuple(result.get("seconds", 0.0) for result in results)
        if figures or found.verdict == comparison.DIFFERENT:
            found.row = self._row(task, results, found.verdict == comparison.EQUAL)
        return found

    def _standing(self, case):
        try:
            return self._processes[1].call(self._seconds, judging.standing_of, case)
        except worker.Failed as error:
            return {"refused": "what a larger tool leaves: " + str(error)}

    def _both(self, case, standing):
        """What both make of a case; one alone that took too long may only have had bad luck."""
        results = [self._cleared(i, case, standing, self._seconds) for i in (0, 1)]
        late = [i for i in (0, 1) if "late" in results[i]]
        if len(late) == 1:
            results[late[0]] = self._cleared(late[0], case, standing, PATIENCE + self._seconds)
        return results

    def _cleared(self, i, case, standing, seconds):
        try:
            return self._processes[i].call(seconds, clearing.cleared, case, standing)
        except worker.TookTooLong as error:
            return {"late": str(error)}
        except worker.Crashed as error:
            return {"crash": str(error)}

    def _row(self, task, results, equal):
        judged = results[:1] if equal else results  # one verdict will do for both
        found = self._judged(task, judged, False) or [{}] * len(judged)
        if judging.is_unsure(found):
            found = self._judged(task, judged, True) or found
        found = [dict(each) for each in (found * 2 if equal else found)]
        for each, result in zip(found, results):
            if "seconds" in result:
                each["seconds"] = result["seconds"]
        return table.Row(task.name, task.operation, *found)

    def _judged(self, task, results, closely):
        """The figures; None, which is told, where that crashed or took too long."""
        try:
            return self._processes[1].call(PATIENCE, judging.judged, task.case, results, closely)
        except worker.Failed as error:
            how = "more closely" if closely else "at all"
            print("not judged %s: %s: %s" % (how, task.name, error), flush=True)
            return None

    def stop(self):
        for process in self._processes:
            process.stop()


def answers(tasks, pairs, figures):
    """Those of all tasks in their order, by pairs of processes that each take the next."""
    free = queue.Queue()
    for pair in pairs:
        free.put(pair)

    def answer(task):
        pair = free.get()
        try:
            return pair.answer(task, figures)
        finally:
            free.put(pair)

    with ThreadPoolExecutor(len(pairs)) as pool:
        yield from pool.map(answer, tasks)
    for pair in pairs:
        pair.stop()


def told(found):
    """What is said of an answer at once; None where there is nothing to say."""
    if found.refused is None and found.verdict != comparison.EQUAL:
        return "%s: %s: %s" % (found.verdict, found.task.name, found.how)
    return None


def summary(found, revision):
    """The lines at the end."""
    rows = [each.row for each in found if each.row]
    if rows:
        all_of_them = len(rows) == sum(each.refused is None for each in found)
        yield ""
        yield "figures of %s:" % ("all cases" if all_of_them else "the %d that differ" % len(rows))
        yield from table.lines(rows, revision, same_cases.OPERATIONS)
        yield ""
        yield "changed most, %s -> this tree:" % revision
        yield from table.changed_most(rows)
        yield ""
    verdicts = [each.verdict for each in found if each.refused is None]
    failed = sum(each.verdict == comparison.EQUAL and bool(each.how) for each in found)
    unknown = verdicts.count(comparison.UNKNOWN)
    yield "%d do not apply; %d end with the same error in both" % (
        len(found) - len(verdicts),
        failed,
    )
    yield "seconds of the processor: %s %.1f, this tree %.1f" % (
        revision,
        *(sum(each.seconds[i] for each in found) for i in (0, 1)),
    )
    if unknown:
        yield "%d crash or take too long in both and are not compared" % unknown
    equal, different = (verdicts.count(v) for v in (comparison.EQUAL, comparison.DIFFERENT))
    yield "%d equal, %d differ" % (equal, different)


def arguments():
    parser = argparse.ArgumentParser(prog="./run same REV", description=__doc__.splitlines()[0])
    parser.add_argument("--revision", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--former", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--present", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--figures", action="store_true", help="of equal cases as well")
    parser.add_argument("--only", choices=("corpus", "random"))
    parser.add_argument("--operation", choices=same_cases.OPERATIONS)
    parser.add_argument(
        "--jobs", type=int, default=len(os.sched_getaffinity(0)), help="cases at once"
    )
    parser.add_argument("--seconds", type=int, default=SECONDS, help="for one path, of the clock")
    return parser.parse_args()


def main():
    given = arguments()
    tasks = same_cases.tasks(given.only, given.operation)
    pairs = [Pair(given.former, given.present, given.seconds) for _ in range(max(1, given.jobs))]
    try:
        pairs[0].core_files()
    except worker.Failed as error:
        print("A module _core cannot be loaded: its process %s." % error, file=sys.stderr)
        return 2
    found = []
    for each in answers(tasks, pairs, given.figures):
        found.append(each)
        if told(each):
            print(told(each), flush=True)
        if len(found) % EVERY == 0:
            print("%d of %d" % (len(found), len(tasks)), file=sys.stderr, flush=True)
    for line in summary(found, given.revision):
        print(line)
    differ = any(each.refused is None and each.verdict == comparison.DIFFERENT for each in found)
    return int(differ and not given.figures)


if __name__ == "__main__":
    sys.exit(main())
