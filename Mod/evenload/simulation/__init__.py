"""The simulator: what a tool feels along a path, what it gouges, what it leaves. Needs no FreeCAD.

    import evenload
    run = evenload.simulate("pocket.ngc", stock=(0, 0, 60, 60), top=0, bottom=-3, tool_diameter=6,
                            teeth=2, cutting={"material": "Al7075-T6", "spindle_speed": 12000})
    run.max_engagement_deg, run.gouge_mm, run.engagement_deg.max()

docs/simulation.md has the method, its conventions and its limits.
"""

from evenload.simulation.inputs import HELIX_ANGLE_DEG, prisms_of
from evenload.simulation.result import Simulation
from evenload.simulation.run import RAPID_FEED, default_resolution, rest_resolution, simulate

__all__ = [
    "HELIX_ANGLE_DEG",
    "RAPID_FEED",
    "Simulation",
    "default_resolution",
    "of",
    "prisms_of",
    "rest_resolution",
    "simulate",
]


def of(operation, **options):
    """The Simulation of a FreeCAD Path operation, with all that its Job knows of it; see
    simulation/job.py for the options.
    """
    from evenload.simulation import job  # here, since all else runs without FreeCAD

    return job.of(operation, **options)
