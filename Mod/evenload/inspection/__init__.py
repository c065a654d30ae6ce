"""Inspection of measured points: features, form errors, profiles, sampling and probing.

Least squares and minimum zones with their proofs, the profile of any part, patterns of points,
tables and probing moves. Needs neither FreeCAD nor a display. Lengths in mm unless a unit is
stated, angles in degrees. docs/inspection.md has methods, figures and limits. Sources: ISO 1101 and
[Varga 2023].
"""

from evenload.inspection.dmis import read_dmis, write_dmis
from evenload.inspection.fits import Fit, fit
from evenload.inspection.parts import AtPoints, BentPart, test_part
from evenload.inspection.predictions import Cut, OutsideRange, Prediction, predict, prediction
from evenload.inspection.probing import compensated, probing_moves
from evenload.inspection.profiles import Profile, profile
from evenload.inspection.sampling import halton_zaremba, matrix
from evenload.inspection.tables import read_csv, write_csv

__all__ = [
    "AtPoints",
    "BentPart",
    "Cut",
    "Fit",
    "OutsideRange",
    "Prediction",
    "Profile",
    "compensated",
    "fit",
    "halton_zaremba",
    "matrix",
    "predict",
    "prediction",
    "probing_moves",
    "profile",
    "read_csv",
    "read_dmis",
    "test_part",
    "write_csv",
    "write_dmis",
]
