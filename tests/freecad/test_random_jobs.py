"""Random jobs of all kinds, judged by OpenCASCADE's booleans; `./run jobs 300` makes more."""

import FreeCAD
import pytest
import random_jobs
from judged_jobs import judged

pytestmark = pytest.mark.between

# Two of each kind that are quick to judge, those among them that once failed: 45 began below the
# top of the stock, 49 cuts into a face whose edge leads down into another pocket.
# Four are enough where another FreeCAD has another OpenCASCADE.
SEEDS = (2, 10, 13, 45)
OTHERS = (16, 18, 23, 24, 26, 39, 49, 53)


@pytest.mark.parametrize(
    "seed", [*SEEDS, *(pytest.param(seed, marks=pytest.mark.core) for seed in OTHERS)]
)
def test_a_job_has_paths_without_fault_or_sentences(seed):
    doc = FreeCAD.newDocument("Job")
    try:
        made = random_jobs.make(doc, seed)
        doc.recompute()
        for verdict in judged(made):
            assert verdict.is_right, verdict.words
    finally:
        FreeCAD.closeDocument(doc.Name)
