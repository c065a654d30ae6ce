"""Which tool, engagement angle, depth and spindle speed clear a pocket soonest, within limits of
chip thickness, force, torque and power. Needs no FreeCAD.

    import evenload
    tool = {"diameter": 6, "teeth": 2, "cutting_length": 18, "max_chip_thickness": 0.04,
            "surface_speed": (120, 200)}
    found = evenload.optimise((0, 0, 60, 40), [tool], "Al7075-T6", "linuxcnc_mill", depth=10)
    print(found.table())

docs/optimisation.md has the method, its inputs and its limits.
"""

from evenload.optimisation.result import LIMITS, Candidate, Optimisation
from evenload.optimisation.search import optimise

__all__ = ["LIMITS", "Candidate", "Optimisation", "optimise"]
