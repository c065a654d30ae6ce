"""What vibrates at a tool's tip, as it is kept: in a JSON file, or as its text with a tool."""

import json
import os
from dataclasses import dataclass, field

from evenload import materials
from evenload.dynamics.frf import Frf
from evenload.dynamics.modes import Mode

KEYS = ("name", "note", "modes", "tap_tests")
# (key of a mode, what it is, whether it is needed)
FREQUENCY, DAMPING, DIRECTION = "frequency_hz", "damping_ratio", "direction_deg"
STIFFNESS, MASS = "stiffness_n_per_um", "mass_kg"
MODE_KEYS = (STIFFNESS, MASS, FREQUENCY, DAMPING, DIRECTION)
TEXT, COUNT = str, int
TAP_KEYS = {  # of a tap test, by what Frf.read and fit call them
    "file": TEXT,
    "unit": TEXT,
    "axis": TEXT,
    "frequency_unit": TEXT,
    "form": TEXT,
    "modes": COUNT,
    "lowest_hz": float,
    "highest_hz": float,
}


@dataclass
class Vibration:
    """Modes at a tool's tip, in machine axes.

    modes: of Mode, at least one. fits: ModalFits of the tap tests that they come from. notes:
    sentences on what is doubtful about these.
    """

    name: str
    modes: list
    note: str = ""
    fits: list = field(default_factory=list)
    notes: list = field(default_factory=list)

    def text(self):
        """JSON that `load` reads, as of a file; modes by their stiffness."""
        rows = [
            {
                STIFFNESS: float("%.9g" % mode.stiffness),
                FREQUENCY: float("%.9g" % mode.frequency),
                DAMPING: float("%.9g" % mode.damping_ratio),
                DIRECTION: float("%.9g" % mode.direction),
            }
            for mode in self.modes
        ]
        content = {"name": self.name, "modes": rows}
        if self.note:
            content["note"] = self.note
        return json.dumps(content, indent=1)

    def save(self, path):
        """Writes the JSON file of it."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text() + "\n")


def load(what, folder=""):
    """The Vibration of a JSON file, of its text, of an object such as it holds, of a list of modes,
    objects or Modes; or what it is given, where that is a Vibration.

    folder: that of relative paths. Raises ValueError, in a sentence, for what cannot be used.
    """
    if isinstance(what, Vibration):
        return what
    if isinstance(what, (list, tuple)):
        what = {"modes": list(what)}
    if isinstance(what, str) and what.lstrip().startswith("{"):
        try:
            what = json.loads(what)
        except ValueError as error:
            raise ValueError("The text of the modes is no JSON: %s." % error) from None
    if isinstance(what, (str, os.PathLike)):
        path = os.path.join(folder, os.fspath(what))
        name = os.path.splitext(os.path.basename(path))[0]
        return _checked(materials.read_object(path, "modes"), name, os.path.dirname(path))
    if not isinstance(what, dict):
        raise ValueError("Modes are a JSON file, an object or a list of modes, not %r." % (what,))
    return _checked(what, "the user's modes", folder)


def _checked(content, name, folder):
    name = str(content.get("name") or name)
    _refuse_unknown(content, KEYS, "The modes of '%s'" % name)
    result = Vibration(name, [], str(content.get("note") or ""))
    for key in ("modes", "tap_tests"):
        if not isinstance(content.get(key, []), list):
            raise ValueError("%s of '%s' must be a list." % (key, name))
    for number, row in enumerate(content.get("modes", []), 1):
        result.modes.append(_mode(row, "Mode %d of '%s'" % (number, name)))
    for number, row in enumerate(content.get("tap_tests", []), 1):
        _take_tap_test(result, row, "Tap test %d of '%s'" % (number, name), folder)
    if not result.modes:
        raise ValueError("'%s' has no mode: give it modes, or tap_tests to fit them to." % name)
    return result


def _mode(row, where):
    if isinstance(row, Mode):
        return row
    if not isinstance(row, dict):
        raise ValueError("%s is %r: give an object." % (where, row))
    _refuse_unknown(row, MODE_KEYS, where)
    for key in (FREQUENCY, DAMPING):
        if key not in row:
            raise ValueError("%s has no %s: give it one." % (where, key))
    if (STIFFNESS in row) == (MASS in row):
        raise ValueError("%s must have either %s or %s." % (where, STIFFNESS, MASS))
    for key, value in row.items():
        if not materials.number(value):
            raise ValueError("%s: %s must be a number, not %r." % (where, key, value))
    rest = row[FREQUENCY], row[DAMPING], row.get(DIRECTION, 0.0)
    try:
        if MASS in row:
            return Mode(row[MASS], *rest)
        return Mode.from_stiffness(row[STIFFNESS], *rest)
    except ValueError as error:
        raise ValueError("%s: %s" % (where, error)) from None


def _take_tap_test(result, row, where, folder):
    if not isinstance(row, dict):
        raise ValueError("%s is %r: give an object." % (where, row))
    _refuse_unknown(row, TAP_KEYS, where)
    if "file" not in row:
        raise ValueError("%s has no file: give it one." % where)
    for key, kind in TAP_KEYS.items():
        value = row.get(key, kind())
        is_good = isinstance(value, kind) or (kind is float and materials.number(value))
        if not is_good or isinstance(value, bool):
            raise ValueError("%s: %s cannot be %r." % (where, key, value))
    path = os.path.join(folder, row["file"])
    if not os.path.isfile(path):
        raise ValueError("%s: there is no file '%s'." % (where, path))
    words = {key: row[key] for key in ("unit", "axis", "frequency_unit", "form") if key in row}
    try:
        frf = Frf.read(path, **words)
        fitted = frf.fit(row.get("modes", 1), row.get("lowest_hz"), row.get("highest_hz"))
    except ValueError as error:
        raise ValueError("%s: %s" % (where, error)) from None
    result.fits.append(fitted)
    result.modes += fitted
    result.notes += frf.notes


def _refuse_unknown(content, known, where):
    unknown = [str(key) for key in content if key not in known]
    if unknown:
        raise ValueError(
            "%s: unknown key '%s'; known keys are %s." % (where, unknown[0], ", ".join(known))
        )
