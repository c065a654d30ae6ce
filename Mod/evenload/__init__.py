"""EvenLoad: milling operations for FreeCAD that keep the tool's load even.

Importing this package imports neither the compiled modules nor the Path / CAM workbench, so that it
costs nothing at FreeCAD's start. `compiled` loads the compiled modules; `evenload.simulate`,
`evenload.simulation`, `evenload.optimise` and `evenload.dynamics` load them when they are asked
for.
"""

from importlib import import_module


def __getattr__(name):
    # Imported here, or all that they need would be loaded with FreeCAD.
    if name == "simulate":
        from evenload.simulation import simulate

        return simulate
    if name == "optimise":
        from evenload.optimisation import optimise

        return optimise
    if name in ("simulation", "dynamics"):
        return import_module("evenload." + name)
    raise AttributeError("module 'evenload' has no attribute '%s'" % name)
