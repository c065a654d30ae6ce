"""Lengths, areas, feeds and rates in the units that the user sees them in: metric ones, or inches.

Documents, scripts and files have mm. In FreeCAD's window what is shown follows FreeCAD's unit
schema: numbers by a Quantity, sentences by in_users_unit().
"""

import math
import re
from dataclasses import dataclass

INCH = 25.4  # mm
FOOT = 0.3048  # m
FIGURES = 3  # that numbers in sentences have at least


def never():
    """Whether inches are shown where there is no window."""
    return False


shows_inches = never  # callable() -> bool; evenload.gui.start() puts FreeCAD's answer here


@dataclass(frozen=True)
class Unit:
    """What values are told in. size: of one, in the unit that the values have; digits: after the
    decimal sign.
    """

    name: str
    size: float
    digits: int

    def figure(self, value):
        """A value in this unit, with a decimal point."""
        return "%.*f" % (self.digits, value / self.size)

    def told(self, value):
        """The same with the unit."""
        return "%s %s" % (self.figure(value), self.name)


@dataclass(frozen=True)
class Quantity:
    """A Unit with metric units, and one with inches."""

    metric: Unit
    imperial: Unit

    @property
    def names(self):
        """The Units' names."""
        return self.metric.name, self.imperial.name

    @property
    def sizes(self):
        """The Units' sizes."""
        return self.metric.size, self.imperial.size

    @property
    def shown(self):
        """The Unit that the user sees by now."""
        return self.imperial if shows_inches() else self.metric


def same(name, digits, size=1.0):
    """The Quantity of what has one unit with metric units and with inches."""
    return Quantity(*2 * (Unit(name, size, digits),))


ANGLE, FORCE = same("°", 1), same("N", 0)
# Values in mm, mm2, mm/min and mm3/min.
LENGTH = Quantity(Unit("mm", 1.0, 3), Unit("in", INCH, 5))
WAY = Quantity(Unit("mm", 1.0, 1), Unit("in", INCH, 2))
CHIP = Quantity(Unit("mm", 1.0, 4), Unit("in", INCH, 5))
ERROR = Quantity(Unit("µm", 1e-3, 0), Unit("in", INCH, 4))
ROUGHNESS = Quantity(Unit("µm", 1e-3, 2), Unit("µin", 1e-6 * INCH, 1))
AREA = Quantity(Unit("mm²", 1.0, 2), Unit("in²", INCH**2, 4))
FEED = Quantity(Unit("mm/min", 1.0, 0), Unit("in/min", INCH, 1))
RATE = Quantity(Unit("mm³/min", 1.0, 0), Unit("in³/min", INCH**3, 4))
LARGE_RATE = Quantity(Unit("cm³/min", 1e3, 4), Unit("in³/min", INCH**3, 4))

# Of sentences, what may stand after a number: the Unit in its place, whose size is in that unit.
_TOLD = {
    "mm/min": Unit("in/min", INCH, 2),
    "mm³/min": Unit("in³/min", INCH**3, 4),
    "cm³/min": Unit("in³/min", 1e-3 * INCH**3, 4),
    "m/min": Unit("ft/min", FOOT, 1),
    "mm²": Unit("in²", INCH**2, 4),
    "mm2": Unit("in²", INCH**2, 4),
    "mm³": Unit("in³", INCH**3, 4),
    "µm": Unit("µin", 1e-3 * INCH, 1),
    "mm": Unit("in", INCH, 4),
    "m": Unit("ft", FOOT, 1),
}
_DIGITS = r"-?\d+(?:[.,]\d+)?(?:e[-+]?\d+)?"
_NUMBER = r"(?<![\w.,])" + _DIGITS
_UNIT = r" (?P<unit>%s)(?![\w/²³])" % "|".join(_TOLD)
_SEVERAL = r"%s(?:(?: (?:to|and|bis|und|és|×|x|–) |–)%s)*" % (_NUMBER, _DIGITS)
# What the user called something stands between quotes, and stays; places are pairs or triples.
_QUOTED = r"(?<!\w)'.*?'(?!\w)|„[^“”]*[“”]"
_PLACE = r"\(%s(?:, %s){1,2}\)" % (_DIGITS, _DIGITS)
_SHOWN = re.compile(
    "(?P<name>%s)|(?P<place>%s)(?: mm\\b)?|(?P<numbers>%s)%s" % (_QUOTED, _PLACE, _SEVERAL, _UNIT)
)
_EACH = re.compile(_NUMBER)


def in_users_unit(text):
    """Sentences that tell values with metric units, and places in mm, as the user sees them. In any
    language; what stands between quotes stays as it is.
    """
    return _SHOWN.sub(_in_inches, text) if shows_inches() else text


def tells_values(text):
    """Whether a text would be another one in inches, in FreeCAD's window or not."""
    return any(not found["name"] for found in _SHOWN.finditer(text))


def _in_inches(found):
    if found["name"]:
        return found["name"]
    unit = _TOLD[found["unit"] or "mm"]
    numbers = found["place"] or found["numbers"]
    told = _EACH.sub(lambda each: _figure(each.group(), unit), numbers)
    has_unit = found["unit"] or found.group() != numbers
    return "%s %s" % (told, unit.name) if has_unit else told


def _figure(number, unit):
    """A number in a unit, with its own decimal sign."""
    value = float(number.replace(",", ".")) / unit.size
    digits = unit.digits
    if value:
        digits = max(digits, FIGURES - 1 - math.floor(math.log10(abs(value))))
    text = "%.*f" % (digits, value)
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return text.replace(".", ",") if "," in number else text
