"""What a ball end or a bull-nosed tool leaves on the faces: cusps, gouges, rest, roughness.

    from evenload import surface_simulation
    found = surface_simulation.simulate(operation)
    print(found.mean_cusp, found.cusp_95, found.gouge_mm, found.uncovered_area)
    found.picture("cusps.png", "cusp")

`read` takes all that is needed from the document, `simulated` computes in any thread; `simulate`
does both. Lengths in mm, areas in mm². docs/surface_simulation.md has the method, what the figures
mean, and their limits.
"""

from evenload.surface_simulation.reading import STOCK, Question, read
from evenload.surface_simulation.result import CUT_OFF, SurfaceSimulation
from evenload.surface_simulation.run import simulate, simulated

__all__ = [
    "CUT_OFF",
    "STOCK",
    "Question",
    "SurfaceSimulation",
    "read",
    "simulate",
    "simulated",
]
