"""EvenLoad: milling operations for FreeCAD that keep the tool's load even.

Importing this package imports neither the compiled modules nor the Path / CAM workbench, so that it
costs nothing at FreeCAD's start. `compiled` loads the compiled modules.
"""
