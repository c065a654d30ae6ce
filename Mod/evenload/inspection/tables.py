"""Points with normals to and from CSV. Each file states its unit; none is guessed."""

import csv
import re

import numpy

from evenload.inspection.points import given, mm_per, normals_of, points_of

COLUMNS = ("x", "y", "z", "i", "j", "k")


def write_csv(path, points, normals, unit):
    """Writes n x 3 points and normals, both in `unit`, "mm" or "inch", with the unit as heading."""
    points, normals, _ = given(points, normals, unit)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["%s [%s]" % (name, unit) for name in "xyz"] + ["i", "j", "k"])
        writer.writerows(
            [repr(float(each)) for each in row] for row in numpy.hstack([points, normals])
        )


def read_csv(path):
    """(points in mm, normals), n x 3 each, of a file as write_csv() makes them.

    Raises ValueError, in a sentence, for headings that state no unit, or several, and for rows that
    are no six numbers.
    """
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if row]
    if not rows:
        raise ValueError(
            "The file is empty: it needs the headings x [mm], y [mm], z [mm], i, j, k."
        )
    headings = [re.fullmatch(r"\s*(\w)\s*(?:\[\s*(\w+)\s*\])?\s*", each) for each in rows[0]]
    if len(headings) != 6 or any(
        not found or found[1].lower() != name for found, name in zip(headings, COLUMNS)
    ):
        raise ValueError("The headings are x [mm], y [mm], z [mm], i, j, k, with mm or inch.")
    units = {found[2] for found in headings[:3]}
    if len(units) != 1:
        raise ValueError("The headings of x, y and z state different units: state one.")
    scale = mm_per(units.pop())
    try:
        numbers = numpy.array([[float(each) for each in row] for row in rows[1:]])
        numbers = points_of(numbers.reshape(len(rows) - 1, 6), (6,))
    except ValueError:
        raise ValueError("Each row below the headings holds six numbers.") from None
    return scale * numbers[:, :3], normals_of(numbers[:, 3:], len(numbers))
