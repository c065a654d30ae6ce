"""The settings and results of operations, as FreeCAD properties."""

from dataclasses import dataclass

import FreeCAD

from evenload import materials

FORMAT = 1  # of the properties in a document: to be raised when their meaning changes
GROUP = "EvenLoad"
RESULTS = "EvenLoad results"
HOLE_ENTRIES = ("Automatic", "Predrilled hole")  # choices of Entry that use a set hole
CONSTANT_FORCE = "Constant force"  # the one feed control that asks for more than feeds


@dataclass(frozen=True)
class Setting:
    """One property of an operation. `value` is its default; for an enumeration the list of choices,
    the first is the default; None where it follows the tool and its controller.
    """

    name: str
    type: str
    value: object
    doc: str
    group: str = GROUP

    def in_setup_sheet(self):
        """Whether FreeCAD's SetupSheet can keep a default for it."""
        return self.type in SETUP_SHEET_TYPES and self.value is not None and self.group == GROUP

    def in_prototype(self):
        """The default as FreeCAD's editor of the SetupSheet wants it: with its unit."""
        unit = UNITS.get(self.type)
        return self.value if unit is None else FreeCAD.Units.Quantity(self.value, unit)


UNITS = {
    "App::PropertyAngle": FreeCAD.Units.Angle,
    "App::PropertyLength": FreeCAD.Units.Length,
}
SETUP_SHEET_TYPES = (*UNITS, "App::PropertyBool", "App::PropertyEnumeration")

# What all operations have.
SETTINGS = (
    Setting(
        "EngagementAngle",
        "App::PropertyAngle",
        60.0,
        "Target and limit of the tool's engagement angle, between 0 and 180 degrees",
    ),
    Setting(
        "SideStep",
        "App::PropertyLength",
        None,
        "The engagement angle as the side step of a straight cut, r (1 - cos angle): "
        "setting one sets the other",
    ),
    Setting(
        "CutMode",
        "App::PropertyEnumeration",
        ["Climb", "Conventional"],
        "Which way the cutting edges meet the material, whichever way the spindle turns",
    ),
    Setting(
        "FeedControl",
        "App::PropertyEnumeration",
        [
            "Constant feed",
            "Constant removal rate",
            "Constant chip thickness",
            CONSTANT_FORCE,
        ],
        "What stays the same where the engagement is below its target",
    ),
    Setting(
        "MaximumFeed",
        "App::PropertySpeed",
        None,
        "Cap of the feed control; at first twice the tool controller's horizontal feed",
    ),
    Setting(
        "LeastLoad",
        "App::PropertyFloat",
        0.0,
        "Wherever the feed is below MaximumFeed, what the feed control holds is at least this "
        "share of its nominal value, as far as moves can be divided: less time, more blocks; 0 to "
        "0.95",
    ),
    Setting(
        "Material",
        "App::PropertyEnumeration",
        materials.names(),
        "What is cut; only Constant force asks for it",
    ),
    Setting(
        "LinkFeed",
        "App::PropertySpeed",
        None,
        "Feed of links at depth over cleared ground; at first the tool controller's horizontal "
        "rapid feed",
    ),
    Setting(
        "LinkLift",
        "App::PropertyLength",
        0.0,
        "How far links rise above the floor; never above the top",
    ),
    Setting(
        "Entry",
        "App::PropertyEnumeration",
        ["Automatic", "Helix", "Ramp", "Predrilled hole"],
        "How the tool reaches its depth; Automatic: an open side, else a set hole, else a helix, "
        "else a ramp",
    ),
    Setting("HelixAngle", "App::PropertyAngle", 3.0, "Descent of helix and ramp against the level"),
    Setting(
        "HelixDiameter",
        "App::PropertyLength",
        None,
        "Diameter of the tool centre's helix; at first 0.9 of the tool's, and less where that "
        "does not fit",
    ),
    Setting(
        "EntryPoint",
        "App::PropertyVectorDistance",
        FreeCAD.Vector(),
        "Centre of the pre-drilled hole",
    ),
    Setting(
        "HoleDiameter",
        "App::PropertyLength",
        0.0,
        "Diameter of the pre-drilled hole; there is no hole until it is set",
    ),
    Setting(
        "RollRadius",
        "App::PropertyLength",
        None,
        "Wished radius of roll-in and roll-out; at first 0.15 of the tool's diameter",
    ),
    Setting(
        "MinimumRadius",
        "App::PropertyLength",
        None,
        "Wished smallest radius of the path; at first 0.15 of the tool's diameter",
    ),
    Setting(
        "NarrowPassages",
        "App::PropertyEnumeration",
        ["Trochoid with smaller radius", "Cut at reduced feed", "Skip and report"],
        "What is done where the width left for the tool's centre is under twice MinimumRadius",
    ),
    Setting("StockToLeave", "App::PropertyLength", 0.0, "What stays at the walls"),
    Setting("StockToLeaveAxial", "App::PropertyLength", 0.0, "What stays above FinalDepth"),
    Setting(
        "WallPass", "App::PropertyBool", True, "A last pass along the walls takes what is left"
    ),
    Setting(
        "Tolerance",
        "App::PropertyLength",
        0.005,
        "Largest distance of the output from the exact path; never into a wall",
    ),
    Setting(
        "Check",
        "App::PropertyBool",
        True,
        "Checks each computed path against the job's models and stock, and refuses one that cuts "
        "into a model, or comes down into material by a rapid or a plunge",
    ),
    Setting("Arcs", "App::PropertyBool", True, "Arcs in the output (G2, G3); without, lines only"),
    Setting(
        "OrderBy",
        "App::PropertyEnumeration",
        ["Region", "Depth"],
        "Of several regions: each down to its last level, or all level by level",
    ),
)

# For operations that can work on what others left.
REST_MACHINING = Setting(
    "UseRestMachining",
    "App::PropertyBool",
    False,
    "Clears only what the job's earlier operations leave",
)

RESULT_SETTINGS = (
    Setting(
        "MaxEngagement",
        "App::PropertyAngle",
        0.0,
        "Largest engagement angle, mean over 0.1 mm",
        RESULTS,
    ),
    Setting(
        "CuttingTime",
        "App::PropertyFloat",
        0.0,
        "Time for cuts, links, entries and retracts, in s",
        RESULTS,
    ),
    Setting(
        "IdealTime",
        "App::PropertyFloat",
        0.0,
        "Area over side step and feed, in s: the time if all were cut at the angle and the feed",
        RESULTS,
    ),
    Setting("RemovedVolume", "App::PropertyVolume", 0.0, "Volume that the path removes", RESULTS),
    Setting(
        "UncutArea",
        "App::PropertyArea",
        0.0,
        "Area that the tool could reach and did not clear",
        RESULTS,
    ),
    Setting("Passes", "App::PropertyInteger", 0, "Cuts without a break, at all levels", RESULTS),
    Setting("Links", "App::PropertyInteger", 0, "Ways at depth from cut to cut", RESULTS),
    Setting(
        "Retracts",
        "App::PropertyInteger",
        0,
        "How often the tool rises and comes down again",
        RESULTS,
    ),
    Setting(
        "Report",
        "App::PropertyString",
        "",
        "What was not done, where and why; the error of a failed operation",
        RESULTS,
    ),
)

HIDDEN_SETTINGS = (
    Setting(
        "OwnValues",
        "App::PropertyStringList",
        [],
        "Names of the settings that no longer follow the tool or the geometry",
        RESULTS,
    ),
    Setting(
        "EarlierOperations",
        "App::PropertyLinkList",
        [],
        "What rest machining depends on: the job's operations before this one",
        RESULTS,
    ),
    Setting(
        "FormatVersion",
        "App::PropertyInteger",
        FORMAT,
        "Format of this operation's properties",
        RESULTS,
    ),
)

FOLLOWERS = ("MaximumFeed", "LinkFeed", "HelixDiameter", "RollRadius", "MinimumRadius")
POSITIVE = ("MaximumFeed", "LinkFeed", "HelixDiameter", "RollRadius", "MinimumRadius", "Tolerance")


def is_ours(obj):
    """Whether a document object is one of our operations: all of them have this property."""
    return hasattr(obj, "FormatVersion") and hasattr(obj.Proxy, "floors")
