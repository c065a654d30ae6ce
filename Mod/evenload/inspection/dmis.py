"""Points with normals to and from DMIS, ISO 22093: what the programs of CMMs have in common.

A statement is a line; one that ends in $ goes on in the next. What begins with $$ is a comment.
F(name)=FEAT/POINT is nominal and FA(name)=FEAT/POINT is measured; the PTMEAS between MEAS and
ENDMES are places that a program sends the probe to. The file states its unit; none is guessed.
"""

import re

import numpy

from evenload.inspection.points import given, mm_per, normals_of

UNIT_WORDS = {"mm": "MM", "inch": "INCH"}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
FEATURE = re.compile(r"(FA?)\s*\(\s*([^()]+?)\s*\)\s*=\s*FEAT\s*/\s*POINT\s*,(.*)", re.IGNORECASE)
UNITS = re.compile(r"UNITS\s*/\s*(\w+)", re.IGNORECASE)
TARGET = re.compile(r"PTMEAS\s*/", re.IGNORECASE)
NO_POINTS = "The file has no measured points, FA(name)=FEAT/POINT,CART."
PROGRAM = (
    "The file has points to measure, but no measured ones, FA(name)=FEAT/POINT,CART: open the "
    "file of results that the program writes."
)


def write_dmis(path, points, normals, unit, program="EVENLOAD"):
    """Writes nominal points as a DMIS program that measures each of them once.

    points: n x 3 in `unit`, "mm" or "inch", of contact; normals: n x 3, out of the part. Features
    are named P1, P2 ... No probe, speed or path between points is set: the CMM's program has these.
    """
    points, normals, _ = given(points, normals, unit)
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

    A measured point without a normal, or with one of length 0, takes that of its nominal point,
    F(name). Other features and statements are passed over. Raises ValueError, in a sentence, for a
    file that states no unit before its points, or several units, for points that are told twice or
    in polar coordinates, and where there are none.
    """
    # Texts and comments of CMM programs come in many encodings; statements are ASCII.
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        statements = _statements(file)
    scale, nominal, found, is_program = None, {}, {}, False
    for statement in statements:
        unit = UNITS.match(statement)
        if unit:
            scale = _checked_unit(unit[1].upper(), scale)
            continue
        feature = FEATURE.fullmatch(statement)
        if not feature:
            is_program = is_program or bool(TARGET.match(statement))
        elif feature[1].upper() == "F":
            nominal[feature[2]] = feature[3]
        elif feature[2] in found:
            raise ValueError("The point %s is told twice: leave one out." % feature[2])
        elif scale is None:
            raise ValueError(
                "The file states no unit before its points: add UNITS/MM or UNITS/INCH."
            )
        else:
            found[feature[2]] = _point(feature[2], feature[3], nominal, scale)
    if not found:
        raise ValueError(PROGRAM if is_program or nominal else NO_POINTS)
    return found


def _statements(lines):
    """The statements of a file, without comments; what goes on in the next line is joined."""
    result, begun = [], ""
    for line in map(str.strip, lines):
        if line.startswith("$$"):
            continue
        begun += line
        if begun.endswith("$"):
            begun = begun[:-1].rstrip()
        elif begun:
            result.append(begun)
            begun = ""
    return [*result, begun] if begun else result


def _checked_unit(word, before):
    """mm of a unit, which must be that before, if there was one."""
    scale = mm_per({"MM": "mm", "INCH": "inch"}.get(word, word.lower()))
    if before not in (None, scale):
        raise ValueError("The file mixes mm and inch: write it anew in one unit.")
    return scale


def _point(name, told, nominal, scale):
    """(point in mm, normal) of what a measured point tells."""
    numbers = _numbers(name, told)
    normal = numbers[3:]
    if not any(normal) and name in nominal:
        normal = _numbers(name, nominal[name])[3:]
    if not any(normal):
        raise ValueError("The point %s does not have six numbers, a normal among them." % name)
    return scale * numpy.array(numbers[:3]), normals_of([normal], 1)[0]


def _numbers(name, told):
    """The three or six numbers of a point, after CART."""
    words = [word.strip() for word in told.split(",")]
    if words[0].upper() == "POL":
        raise ValueError(
            "The point %s is told in polar coordinates: have the program write CART." % name
        )
    is_read = len(words) in (4, 7) and all(re.fullmatch(NUMBER, word) for word in words[1:])
    if words[0].upper() != "CART" or not is_read:
        raise ValueError("The point %s does not have six numbers after CART." % name)
    return [float(word) for word in words[1:]]
