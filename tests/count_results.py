"""Adds up test results. count_results.py FOLDER NAME=EXITCODE...

Reads FOLDER/NAME.xml (JUnit) of every suite. A suite that ended badly without a failed test in its
file, or wrote no file, counts as one failure, and so does one that ran no test. Suites that share
what stands before a slash share their tests: one of them may have none. The last line is
'N passed, N failed', with ', N skipped' where there are any; the exit code is 1 when anything
failed.
"""
import sys
import xml.etree.ElementTree
from pathlib import Path


def read(path):
    """(passed, skipped, names of the failed) of one JUnit file."""
    passed, skipped, failed = 0, 0, []
    for case in xml.etree.ElementTree.parse(path).iter("testcase"):
        if case.find("failure") is not None or case.find("error") is not None:
            group, name = case.get("classname"), case.get("name")
            # ctest writes one name twice
            failed.append(name if name == group else "%s.%s" % (group, name))
        elif case.find("skipped") is not None:
            skipped += 1
        else:
            passed += 1
    return passed, skipped, failed


def main(folder, *suites):
    total_passed, total_skipped, total_failed, ran = 0, 0, [], {}
    print("== summary")
    for suite in suites:
        name, code = suite.split("=")
        try:
            passed, skipped, failed = read(Path(folder) / (name + ".xml"))
        except (OSError, xml.etree.ElementTree.ParseError):
            passed, skipped, failed = 0, 0, ["%s: wrote no results, exit code %s" % (name, code)]
        if code != "0" and not failed:
            failed = ["%s: ended with exit code %s" % (name, code)]
        print("%-9s %5d passed, %d failed, %d skipped" % (name, passed, len(failed), skipped))
        total_passed += passed
        total_skipped += skipped
        total_failed += failed
        group = name.split("/")[0]
        ran[group] = ran.get(group, 0) + passed + skipped + len(failed)
    total_failed += ["%s: ran no test" % group for group, count in ran.items() if not count]
    for name in total_failed:
        print("FAILED  ", name)
    skips = ", %d skipped" % total_skipped if total_skipped else ""
    print("%d passed, %d failed%s" % (total_passed, len(total_failed), skips))
    return 1 if total_failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
