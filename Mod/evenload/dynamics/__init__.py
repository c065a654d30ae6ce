"""Milling dynamics: which spindle speed, which depth, climb or conventional.

From the machine's vibration, modes or a tap test, to the cuts that are stable and leave a straight
wall. Needs neither FreeCAD nor a display. Frame: x along the tool's feed, y to its left; spindle
clockwise seen from above. Depths in mm, speeds in rev/min, cutting coefficients in N/mm2, masses in
kg, frequencies in Hz, angles in degrees. docs/dynamics.md has the methods, figures and limits.
"""

from evenload.dynamics.beams import MATERIALS, couple
from evenload.dynamics.bisection import Bisection, mdbm
from evenload.dynamics.charts import Chart
from evenload.dynamics.choice import Best, best
from evenload.dynamics.frf import Frf, ModalFit
from evenload.dynamics.milling import Milling
from evenload.dynamics.modes import Mode
from evenload.dynamics.turning import interrupted_turning_speeds, turning_limit

__all__ = [
    "MATERIALS",
    "Best",
    "Bisection",
    "Chart",
    "Frf",
    "Milling",
    "Mode",
    "ModalFit",
    "best",
    "couple",
    "interrupted_turning_speeds",
    "mdbm",
    "turning_limit",
]
