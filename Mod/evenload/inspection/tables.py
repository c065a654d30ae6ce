"""Points with normals to and from CSV and DMIS. Each file states its unit; none is guessed."""

import csv
import re

import numpy

from evenload.inspection.points import mm_per, normals_of, points_of

COLUMNS = ("x", "y", "z", "i", "j", "k")
NUMBER = r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*"
UNIT_WORDS = {"mm": "MM", "inch": "INCH"}
FEATURE = re.compile(
    r"^(FA|F)\(\s*([^)\s]+)\s*\)\s*=\s*FEAT/POINT\s*,\s*CART\s*,(.*)$", re.IGNORECASE
)
UNITS = re.compile(r"^UNITS/\s*(\w+)", re.IGNORECASE)


def write_csv(path, points, normals, unit):
    """Writes n x 3 points and normals, both in `unit`, "mm" or "inch", with the unit as heading."""
    points, normals, _ = _given(points, normals, unit)
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


def write_dmis(path, points, normals, unit, program="EVENLOAD"):
    """Writes nominal points as a DMIS program that measures each of them once.

    points: n x 3 in `unit`, "mm" or "inch", of contact; normals: n x 3, out of the part. Features
    are named P1, P2 ... No probe, speed or path between points is set: the CMM's program has these.
    """
    points, normals, _ = _given(points, normals, unit)
    lines = ["DMISMN/'%s',05.2" % program, "UNITS/%s,ANGDEC" % UNIT_WORDS[unit]]
    for i, row in enumerate(numpy.hstack([points, normals]), 1):
        place = ",".join("%.9g" % each for each in row)
        lines += [
            "F(P%d)=FEAT/POINT,CART,%s" % (i, place),
            "MEAS/POINT,F(P%d),1" % i,
            "PTMEAS/CART,%s" % place,
            "ENDMES",
            "OUTPUT/FA(P%d)" % i,
        ]
    with open(path, "w") as file:
        file.write("\n".join([*lines, "ENDFIL"]) + "\n")


def read_dmis(path):
    """{name: (point in mm, normal)} of the measured points, FA(name)=FEAT/POINT,CART, of a file.

    Lines that end in $ go on in the next. Nominal features, F(name), and all other statements are
    passed over. Raises ValueError, in a sentence, for a file that states no unit or several before
    its points, for points that are told twice, and where there are none.
    """
    with open(path) as file:
        text = re.sub(r"\$[ \t]*\n\s*", "", file.read())
    scale, found = None, {}
    for line in map(str.strip, text.splitlines()):
        unit = UNITS.match(line)
        if unit:
            word = unit[1].upper()
            now = mm_per({"MM": "mm", "INCH": "inch"}.get(word, word.lower()))
            if scale not in (None, now):
                raise ValueError("The file mixes mm and inch: write it anew in one unit.")
            scale = now
            continue
        feature = FEATURE.match(line)
        if not feature or feature[1].upper() == "F":
            continue
        name = feature[2]
        if scale is None:
            raise ValueError(
                "The file states no unit before its points: add UNITS/MM or UNITS/INCH."
            )
        if name in found:
            raise ValueError("The point %s is told twice: leave one out." % name)
        numbers = re.fullmatch(",".join([NUMBER] * 6), feature[3])
        if not numbers:
            raise ValueError("The point %s does not have six numbers." % name)
        row = numpy.array([float(each) for each in numbers.groups()])
        found[name] = scale * row[:3], normals_of([row[3:]], 1)[0]
    if not found:
        raise ValueError("The file has no measured points, FA(name)=FEAT/POINT,CART.")
    return found


def _given(points, normals, unit):
    points = points_of(points)
    return points, normals_of(normals, len(points)), mm_per(unit)
