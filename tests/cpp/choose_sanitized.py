"""Chooses the C++ tests that run under the sanitizers, by lines reached per second.

    choose_sanitized.py TREE

TREE is a build tree of the preset coverage. Quick tests all run under the sanitizers. Of the others
those do that reach lines of the core which no test before them reached, the one with the most new
lines per second first, until a line costs more than two seconds. The rest is written to
not_sanitized.txt beside this file, by ctest's names: a test that is newer than the list runs.
"""

import concurrent.futures
import gzip
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCES = str(HERE.parents[1] / "src") + os.sep
LIST = HERE / "not_sanitized.txt"
QUICK = 1.0  # s
LEAST = 0.5  # new lines per second: a line that costs more is left to ./run test --slow


class Runner:
    """Runs tests, with a folder of one's choice for the counts of the lines that they reach."""

    def __init__(self, tree, scratch):
        self.tree, self.scratch = tree, scratch

    def tests(self):
        """[(name, command)]"""
        listed = subprocess.run(
            ["ctest", "--test-dir", self.tree, "--show-only=json-v1", "--label-exclude", "slow"],
            check=True,
            capture_output=True,
        )
        found = json.loads(listed.stdout)["tests"]
        named = {test["name"].split()[0]: test["command"] for test in found}
        if len(named) < len(found):
            raise SystemExit("Some tests have the same name: give their parameters names.")
        return list(named.items())

    def run(self, command, folder):
        """Seconds. What several tests reach adds up in one folder."""
        start = time.monotonic()
        subprocess.run(
            command,
            check=True,
            cwd=self.tree,
            env={**os.environ, "GCOV_PREFIX": str(self.scratch / folder)},
            stdout=subprocess.DEVNULL,
        )
        return time.monotonic() - start

    def lines(self, folder):
        """{(file, line)} of the core that were reached; the folder is gone afterwards."""
        folder, reached = self.scratch / folder, set()
        counts = sorted(file for file in folder.rglob("*.gcda") if "evenload_core" in str(file))
        for count in counts:  # gcov wants notes and counts side by side
            notes = Path("/", count.relative_to(folder)).with_suffix(".gcno")
            count.with_suffix(".gcno").symlink_to(notes)
        subprocess.run(
            ["gcov", "--json-format", "--hash-filenames", *map(str, counts)],
            check=True,
            cwd=folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for report in folder.glob("*.gcov.json.gz"):
            with gzip.open(report) as file:
                for source in json.load(file)["files"]:
                    if source["file"].startswith(SOURCES):
                        reached |= {
                            (source["file"], line["line_number"])
                            for line in source["lines"]
                            if line["count"]
                        }
        shutil.rmtree(folder)
        return reached


def choose(quick_lines, slow):
    """The names of the slow tests that are needed, in the order in which they were chosen.

    slow: {name: (seconds, lines)}
    """
    reached, chosen, left = set(quick_lines), [], dict(slow)
    while left:
        gain = {name: len(lines - reached) / seconds for name, (seconds, lines) in left.items()}
        best = max(gain, key=gain.get)
        if gain[best] < LEAST:
            break
        seconds, lines = left.pop(best)
        print("%6.1f s, %4d new lines: %s" % (seconds, len(lines - reached), best))
        reached |= lines
        chosen.append(best)
    return chosen


def main(tree):
    with tempfile.TemporaryDirectory() as scratch:
        runner = Runner(tree, Path(scratch))
        tests = runner.tests()

        def measured(number):
            name, command = tests[number]
            seconds = runner.run(command, str(number))
            if seconds >= QUICK:
                return name, seconds, runner.lines(str(number))
            runner.run(command, "quick")
            return name, seconds, set()

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(measured, range(len(tests))))
        quick = runner.lines("quick")
    slow = {name: (seconds, lines) for name, seconds, lines in results if seconds >= QUICK}
    chosen = choose(quick, slow)
    left_out = sorted(set(slow) - set(chosen))
    LIST.write_text("".join(name + "\n" for name in left_out))
    print(
        "%d tests run under the sanitizers, %.0f s of %.0f s here; %d are left out"
        % (
            len(results) - len(left_out),
            sum(seconds for name, seconds, _ in results if name not in left_out),
            sum(seconds for _, seconds, _ in results),
            len(left_out),
        )
    )


if __name__ == "__main__":
    main(sys.argv[1])
