"""The cases that are cleared: the corpus by each operation, and random pockets of fixed seeds."""

import json
import random
from dataclasses import dataclass
from pathlib import Path

CORPUS = Path(__file__).resolve().parents[1] / "corpus"
CHOICES = {  # operation -> what is chosen for it
    "adaptive": {},
    "conventional": {"cut_mode": "conventional"},
    "reduced_feed": {"narrow_passages": "cut at reduced feed"},
}
OF_SHAPES = ("trochoid", "lame_spiral")  # operations that are there for certain shapes
OPERATIONS = (*CHOICES, "open_sides", "rest", *OF_SHAPES)
LARGER = 5 / 3  # of the tool: the one that was there before, where the rest is cleared
SEED, COUNT = 37, 200  # of random cases
ANGLES = (15.0, 120.0)  # degrees


@dataclass(frozen=True)
class Task:
    operation: str
    case: dict

    @property
    def name(self):
        return "%s, %s" % (self.case["name"], self.operation)


def tasks(only=None, operation=None):
    """All of them; only: "corpus" or "random"; operation: one of OPERATIONS."""
    found = [] if only == "random" else list(of_corpus())
    found += [] if only == "corpus" else list(of_seed(SEED, COUNT))
    return [task for task in found if operation in (None, task.operation)]


def of_corpus():
    """Each pocket by all operations; those that are slow, or that have choices of their own, as
    their files say only.
    """
    for case in read(CORPUS):
        yield from by_all_operations(case)
    for folder in ("chosen", "slow"):
        for case in read(CORPUS / folder):
            yield Task(case.get("operation", "adaptive"), case)


def read(folder):
    return [json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))]


def by_all_operations(case):
    """A task for each operation that applies. Whether a shape is one for OF_SHAPES is not known
    before: the core says so.
    """
    import choices

    for operation, chosen in CHOICES.items():
        yield Task(operation, {**case, "choices": {**case.get("choices", {}), **chosen}})
    if not case.get("open"):
        edges = choices.hull_edges(case)[::2]
        if edges:
            yield Task("open_sides", {**case, "open_edges": edges})
        yield Task("rest", {**case, "rest_of": round(LARGER * case["tool"], 2)})
    for operation in OF_SHAPES:
        yield Task(operation, {**case, "operation": operation})


def of_seed(seed, count):
    """Random pockets for adaptive, trochoid and Lamé spiral in turn, each second one of them with
    choices, at angles of their own.
    """
    import random_cases

    sources = [random_cases.cases(seed, 0, name) for name in random_cases.OPERATIONS]
    for i in range(count):
        _, case = next(sources[i % len(sources)])
        angle = round(random.Random("%d/%d/angle" % (seed, i)).uniform(*ANGLES), 1)
        yield Task(case.get("operation", "adaptive"), {**case, "engagement_deg": angle})
