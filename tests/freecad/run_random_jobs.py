"""FreeCADCmd's entrance to the random jobs: $EVENLOAD_JOBS of them from seed $EVENLOAD_SEED on,
each path judged by OpenCASCADE's booleans. Prints a line for each job, then how many passed.
"""

import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import random_jobs  # noqa: E402
from judged_jobs import judged  # noqa: E402


def run(first, count):
    failed = 0
    for seed in range(first, first + count):
        doc = FreeCAD.newDocument("Job")
        start = time.time()
        made = random_jobs.make(doc, seed)
        doc.recompute()
        verdicts = judged(made)
        wrong = any(not verdict.is_right for verdict in verdicts)
        failed += wrong
        words = "; ".join(verdict.words for verdict in verdicts)
        seconds = time.time() - start
        print(
            "%s %d, %s, %.1f s: %s"
            % ("WRONG" if wrong else "right", seed, made.kind, seconds, words)
        )
        sys.stdout.flush()
        FreeCAD.closeDocument(doc.Name)
    print("%d passed, %d failed" % (count - failed, failed))
    return failed


code = 2  # of a job that could not be judged, whose traceback FreeCAD prints
try:
    code = int(run(int(os.environ.get("EVENLOAD_SEED", 0)), int(os.environ["EVENLOAD_JOBS"])) > 0)
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    if code < 2:
        os._exit(code)
