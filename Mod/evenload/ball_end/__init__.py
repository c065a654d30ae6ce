"""Ball-end finishing: the chip that one tooth takes, and regressions of its mean thickness.

Volume, both faces, mean and largest thickness, the part of the edge that works and the tip's share,
for planes, cylinders, the source's test parts and any place of a face. Needs neither FreeCAD nor a
display. Lengths in mm, areas in mm2, volumes in mm3, angles in degrees. docs/chip_model.md has the
method, figures and limits. Source: [Varga 2023].
"""

from evenload.ball_end.chips import Chip, chip, chips
from evenload.ball_end.regressions import Fit, OutsideRange, fit, regression
from evenload.ball_end.source import source_rows

__all__ = ["Chip", "Fit", "OutsideRange", "chip", "chips", "fit", "regression", "source_rows"]
