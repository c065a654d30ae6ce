"""Which strategy to finish faces by: times, chips, cusps and force of each, before one is chosen.

    from evenload import advisor
    for row in advisor.advice(operation, machine="linuxcnc_mill"):
        print(row.strategy.name, row.machine_seconds, row.scatter, row.refusal)

`read` takes all that is needed from the document, `answers` computes in any thread; `advice` does
both. Lengths in mm, times in s, speeds in m/min, the force impulse in N s. docs/finishing.md has
what is told, and its limits.
"""

from evenload.advisor.answering import PLACES, Advice, advice, answers, loads_along
from evenload.advisor.reading import STOCK, Question, read
from evenload.advisor.strategies import STRATEGIES, Strategy

__all__ = [
    "PLACES",
    "STOCK",
    "STRATEGIES",
    "Advice",
    "Question",
    "Strategy",
    "advice",
    "answers",
    "loads_along",
    "read",
]
