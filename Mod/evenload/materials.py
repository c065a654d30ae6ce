"""Cutting force coefficients of materials: ours in Resources/materials.json, or the user's own.

ktc, krc: tangential and radial force per area of the chip, N/mm2; kte, kre: per length of the edge,
N/mm. docs/force_and_time.md has the model and the sources. Needs neither FreeCAD nor the core.
"""

import json
import math
import os

ADDON = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FILE = os.path.join(ADDON, "Resources", "materials.json")
CHIP, EDGE = ("ktc", "krc"), ("kte", "kre")
KEYS = CHIP + EDGE + ("name", "source")


def names():
    """The names of our materials, in the file's order."""
    return [row["name"] for row in _rows()]


def load(material):
    """{"name", "ktc", "krc", "kte", "kre", "source"} of a material.

    material: one of names(), in any case; the path of a JSON file that holds one material; or a
    dictionary with ktc and krc, and kte, kre (0 by default), name and source as it likes. Raises
    ValueError with a sentence for what cannot be used.
    """
    if isinstance(material, dict):
        return _checked(material, str(material.get("name") or "the user's material"))
    if not isinstance(material, (str, os.PathLike)):
        raise ValueError(
            "A material is a name, a JSON file or a dictionary of coefficients, not %r."
            % (material,)
        )
    text = os.fspath(material)
    for row in _rows():
        if row["name"].casefold() == text.strip().casefold():
            return _checked(row, row["name"])
    if not text.lower().endswith(".json"):
        raise ValueError(
            "There is no material '%s': choose one of %s, or give a JSON file or a dictionary with"
            " ktc and krc." % (text, ", ".join("'%s'" % name for name in names()))
        )
    row = read_object(text, "material")
    return _checked(row, str(row.get("name") or os.path.splitext(os.path.basename(text))[0]))


def read_object(path, what):
    """The JSON object in a file. Raises ValueError with a sentence that names the file."""
    try:
        with open(path, encoding="utf-8") as file:
            value = json.load(file)
    except OSError as error:
        raise ValueError(
            "The file '%s' of the %s cannot be read: %s." % (path, what, error.strerror)
        ) from None
    except ValueError as error:
        raise ValueError("The file '%s' of the %s is no JSON: %s." % (path, what, error)) from None
    if not isinstance(value, dict):
        raise ValueError("The file '%s' must hold one %s, a JSON object." % (path, what))
    return value


def number(value):
    """Whether a value of a JSON file is a finite number."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _rows():
    with open(FILE, encoding="utf-8") as file:
        return json.load(file)["materials"]


def _checked(row, name):
    unknown = sorted(str(key) for key in row if key not in KEYS)
    if unknown:
        raise ValueError(
            "The material '%s' has the unknown key '%s': its keys are %s."
            % (name, unknown[0], ", ".join(KEYS))
        )
    result = {"name": name}
    for key in CHIP + EDGE:
        if key in CHIP and key not in row:
            raise ValueError("The material '%s' has no %s: give it one in N/mm2." % (name, key))
        value = row.get(key, 0.0)
        if not number(value) or value < 0:
            raise ValueError(
                "%s of the material '%s' must be a number of 0 or more, not %r."
                % (key, name, value)
            )
        result[key] = float(value)
    result["source"] = str(row.get("source") or "")
    return result
