"""What a row of the settings table is: a property of an operation, and all that follows from it."""

from dataclasses import dataclass

GROUP = "EvenLoad"
RESULTS = "EvenLoad results"

# FreeCAD's types of properties.
ANGLE = "App::PropertyAngle"  # degrees
AREA = "App::PropertyArea"
BOOL = "App::PropertyBool"
CHOICE = "App::PropertyEnumeration"
INTEGER = "App::PropertyInteger"
LENGTH = "App::PropertyLength"  # mm
LINKS = "App::PropertyLinkList"
NUMBER = "App::PropertyFloat"
NUMBERS = "App::PropertyFloatList"
POINT = "App::PropertyVectorDistance"  # mm
SPEED = "App::PropertySpeed"  # mm/s in Python, mm/min for people and for the core
TEXT = "App::PropertyString"
TEXTS = "App::PropertyStringList"
VOLUME = "App::PropertyVolume"

UNITS = {ANGLE: "degrees", LENGTH: "mm", SPEED: "mm/min"}  # that people read in sentences
IN_SETUP_SHEET = (ANGLE, LENGTH, BOOL, CHOICE)  # types for which FreeCAD can keep defaults


@dataclass(frozen=True)
class Range:
    """Which values of a setting can be used: those within limits, which are allowed themselves or
    not. unit: what follows the limits in a sentence.
    """

    low: float
    high: float = None
    inclusive: bool = False
    unit: str = ""

    def refusal(self, value):
        """What a value must be, as the end of a sentence; None for one that can be used."""
        if self.inclusive:
            fits = self.low <= value and (self.high is None or value <= self.high)
        else:
            fits = self.low < value and (self.high is None or value < self.high)
        if fits:
            return None
        if self.high is not None:
            return "must lie between %g and %g%s" % (self.low, self.high, self.unit)
        return "must not be negative" if self.inclusive else "must be positive"


POSITIVE = Range(0)
NOT_NEGATIVE = Range(0, inclusive=True)


@dataclass(frozen=True)
class Setting:
    """One property of an operation."""

    name: str
    type: str
    # The default; of a CHOICE the list of choices, whose first is the default. None: it follows the
    # tool and its controller, or the geometry.
    value: object
    doc: str  # FreeCAD's and the panel's tooltip
    group: str = GROUP
    label: str = None  # what the panel and sentences call it
    box: str = None  # the group of the table and, where it is not shown at first, of the panel
    is_first: bool = False  # among the few that a panel shows before anything is unfolded
    keyword: str = None  # the core's; None: the core has none, or it needs more than the value
    range: Range = None
    # callable(tool diameter in mm, feed, rapid feed, both as FreeCAD has them): the value until it
    # is set.
    follows: object = None
    fitted: bool = False  # shows what was chosen for the geometry, until it is set
    when: tuple = None  # (name of a CHOICE, those of its choices with which it matters)
    needs: str = None  # the setting without which, at 0, it has no effect
    unset: str = None  # what the panel shows for 0 or an empty list, where that is no value
    is_fine: bool = False  # a length that FreeCAD's two decimals would round away
    default: str = None  # in the table of the documentation, where that is not the value itself
    page: str = None  # Markdown: what the documentation says of it

    def in_setup_sheet(self):
        """Whether FreeCAD's SetupSheet can keep a default for it."""
        return self.type in IN_SETUP_SHEET and self.value is not None and self.group == GROUP

    def of(self, obj):
        """Its value of an operation as people have it: a number in UNITS, a text, ..."""
        value = getattr(obj, self.name)
        value = getattr(value, "Value", value)
        return 60 * value if self.type == SPEED else value

    def matters_to(self, obj):
        """Whether an operation's other settings leave it an effect."""
        if self.when and getattr(obj, self.when[0]) not in self.when[1]:
            return False
        needed = getattr(obj, self.needs) if self.needs else True
        return bool(getattr(needed, "Value", needed))

    def told(self, obj):
        """The same with its unit."""
        unit = UNITS.get(self.type)
        return "%g" % self.of(obj) + (" " + unit if unit else "")


@dataclass(frozen=True)
class Result(Setting):
    """One property that an operation sets, and its user only reads."""

    group: str = RESULTS
