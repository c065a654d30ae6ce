"""The source's chips: its values and places, and the reading that yields its regressions."""

import numpy

from evenload.ball_end.chips import chips
from evenload.ball_end.regressions import RADIUS, Rows

DIAMETER, ALLOWANCE = 10.0, 0.3
# (feed per tooth, stepover), mm [Varga 2023, table 6].
PAIRS = ((0.08, 0.35), (0.08, 0.25), (0.08, 0.15), (0.12, 0.15), (0.16, 0.15), (0.16, 0.35))
DIRECTIONS = (0.0, 22.5, 45.0, 67.5, 90.0)
PITCH = 3.5  # mm in plan between the tool's places, from -10 to 10
REGRESSION = 6  # places on each side of the middle that lie on R45 in both parts


def source_rows(places=REGRESSION, threads=0):
    """Rows for fit(): 780 chips, or 1260 with places=10; mean thickness of both uncut sides.

    Steps are measured in plan, and the normal is that of the part at the tool's ordinate.
    """
    y, pair, direction, nature = (
        grid.ravel()
        for grid in numpy.meshgrid(
            PITCH * numpy.arange(-places, places + 1),
            numpy.arange(len(PAIRS)),
            DIRECTIONS,
            (-1, 1),
            indexing="ij",
        )
    )
    feed, stepover = numpy.array(PAIRS)[pair].T
    parts = [("test part", "CX" if each > 0 else "CV") for each in nature]
    thickness = sum(
        chips(
            parts, DIAMETER, feed, stepover, ALLOWANCE, direction, y, side, threads=threads
        ).mean_thickness
        / 2
        for side in ("right", "left")
    )
    normal = numpy.degrees(numpy.arcsin(numpy.clip(y / RADIUS, -1, 1)))
    return Rows(nature, direction, feed, stepover, normal, thickness)
