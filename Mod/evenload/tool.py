"""What an operation needs to know of its tool controller."""

import math
import os
from dataclasses import dataclass, field

ASSUMED_RAPID = (
    5000.0  # mm/min: for estimated times only, where the tool controller names no rapid feed
)

# How a tool controller's spindle turns, as FreeCAD calls it: M3, M4, not at all.
FORWARD, REVERSE, STANDING = "Forward", "Reverse", "None"

HELIX_ANGLE_DEG = 30.0  # of end mills, where nobody says
ONE_TOOTH = "The tool '%s' does not tell its number of teeth: 1 tooth is assumed."

# Tools that do not leave a flat floor and a straight wall: the tool bit's shape, and its name in a
# sentence.
OTHER_SHAPES = {
    "ballend": "a ball end mill",
    "chamfer": "a chamfering tool",
    "dovetail": "a dovetail cutter",
    "drill": "a drill",
    "probe": "a probe",
    "radius": "a corner-rounding tool",
    "reamer": "a reamer",
    "slittingsaw": "a slitting saw",
    "svgtest": "no end mill",
    "tap": "a tap",
    "taperedballnose": "a tapered ball end mill",
    "threadmill": "a thread mill",
    "vbit": "a V bit",
}
END_MILLS = ("endmill", "bullnose")
BALL_END = "ballend"  # what only operations on surfaces take
POINT_STEPS = 4  # discs that stand for the cone at the end of a drill
BALL_STEPS = 4  # discs that stand for a ball; more would take as much longer
DRILL_POINT_DEG = 118.0  # of drills, where nobody says
# A tool bit of a shape that FreeCAD does not bring along is no end mill when it has one of these.
ANGLES = ("CuttingEdgeAngle", "TipAngle", "cuttingAngle", "CuttingAngle", "TipDiameter")


@dataclass(frozen=True)
class Tool:
    """A flat or bull-nosed end mill, or one with a ball end; lengths in mm."""

    name: str
    diameter: float  # > 0
    cutting_length: float  # 0 where the tool bit does not say
    centre_cutting: bool
    teeth: int = 1  # 1 where the tool bit does not say
    bull_nosed: bool = False  # whether the corner between floor and side is rounded
    helix_angle: float = HELIX_ANGLE_DEG  # degrees, of the flutes
    assumed: dict = field(default_factory=dict)  # {what the tool bit does not say: what is taken}
    end_radius: float = 0.0  # of its ball or rounded corner


@dataclass(frozen=True)
class CuttingData:
    """Feeds in mm/min, spindle speed in rev/min."""

    feed: float  # > 0, at the engagement angle
    plunge_feed: float  # > 0
    rapid_feed: float  # 0 where the tool controller does not say
    spindle_speed: float
    spindle: str = FORWARD  # how it turns: FORWARD, REVERSE or STANDING


def read(controller, takes_balls=False):
    """(Tool, CuttingData) of a tool controller. takes_balls: whether a ball end will do. Raises
    ValueError with a sentence for what cannot be used.
    """
    if controller is None:
        raise ValueError("The operation has no tool: choose a tool controller for it.")
    bit = controller.Tool
    if bit is None:
        raise ValueError(
            "The tool controller '%s' has no tool: choose one for it." % controller.Label
        )
    name = getattr(bit, "Label", None) or getattr(bit, "Name", "") or controller.Label
    other = _other_shape(bit)
    if other and not (takes_balls and other == OTHER_SHAPES[BALL_END]):
        wanted = "a ball end, bull-nosed or flat" if takes_balls else "a flat or bull-nosed"
        raise ValueError("The tool '%s' is %s: choose %s end mill." % (name, other, wanted))
    diameter = _number(bit, "Diameter")
    if not diameter > 0:
        raise ValueError("The diameter of the tool '%s' is %g mm: set it." % (name, diameter))
    teeth, helix_angle, assumed = _edges(bit)
    tool = Tool(
        name,
        diameter,
        _number(bit, "CuttingEdgeHeight"),
        _cuts_at_its_centre(bit),
        teeth,
        "bullnose" in _shapes(bit),
        helix_angle,
        assumed,
        end_radius(controller),
    )
    data = CuttingData(
        60 * controller.HorizFeed.Value,
        60 * controller.VertFeed.Value,
        60 * controller.HorizRapid.Value,
        float(controller.SpindleSpeed),
        str(getattr(controller, "SpindleDir", FORWARD)),
    )
    for value, meaning, name in (
        (data.feed, "horizontal", "HorizFeed"),
        (data.plunge_feed, "vertical", "VertFeed"),
    ):
        if not value > 0:
            raise ValueError(
                "The %s feed of the tool controller '%s' is 0: set its %s."
                % (meaning, controller.Label, name)
            )
    return tool, data


def diameter(controller):
    """The diameter in mm of a tool controller's tool, 0 where there is none."""
    bit = controller.Tool if controller else None
    return max(_number(bit, "Diameter"), 0.0) if bit else 0.0


def chip_load(controller):
    """mm per tooth that a tool controller's tool bit tells; 0 where it does not."""
    return max(_number(controller.Tool, "Chipload"), 0.0)


def corner_radius(controller):
    """The radius in mm between a bull-nosed tool's floor and side, by its controller; else 0."""
    bit = controller.Tool
    if "bullnose" not in _shapes(bit):
        return 0.0
    half = 0.5 * diameter(controller)
    # FreeCAD's FlatRadius is the radius of the flat in the middle of the tool's bottom.
    radius = half - _number(bit, "FlatRadius")
    if hasattr(bit, "CornerRadius"):
        radius = _number(bit, "CornerRadius")
    return min(max(radius, 0.0), half)


def end_radius(controller):
    """The radius in mm of a tool's ball or rounded corner, by its controller; 0 for a flat end."""
    if controller.Tool and is_ball(controller):
        return 0.5 * diameter(controller)
    return corner_radius(controller) if controller.Tool else 0.0


def is_ball(controller):
    """Whether a tool controller's tool is a ball end mill."""
    return other_shape(controller) == OTHER_SHAPES[BALL_END]


def is_drill(controller):
    """Whether a tool controller's tool is a drill."""
    return other_shape(controller) == OTHER_SHAPES["drill"]


def point_length(controller):
    """The length in mm of the cone at the end of a tool controller's drill."""
    angle = _number(controller.Tool, "TipAngle")
    if not 0 < angle < 180:
        angle = DRILL_POINT_DEG
    return 0.5 * diameter(controller) / math.tan(0.5 * math.radians(angle))


def discs(controller):
    """[(mm above the tip, diameter), ...] of flat tools within a tool, the widest first: together
    they clear no more than the tool does, whose end is a cone, a ball or has a rounded corner.
    """
    whole = diameter(controller)
    if is_ball(controller):
        # Closest where it is low: what a finishing pass takes is less than a tenth of its radius.
        shares = [(k / BALL_STEPS) ** 3 for k in range(BALL_STEPS, 0, -1)]
        return [(share * whole / 2, whole * math.sqrt(share * (2 - share))) for share in shares]
    if is_drill(controller):
        point = point_length(controller)
        shares = [1 - k / POINT_STEPS for k in range(POINT_STEPS)]
        return [(share * point, share * whole) for share in shares]
    corner = corner_radius(controller)
    found = [(corner, whole), (0.0, whole - 2 * corner)] if corner > 0 else [(0.0, whole)]
    return [(above, width) for above, width in found if width > 0]


def other_shape(controller):
    """What a tool controller's tool is, in words, when it is no flat or bull-nosed end mill, else
    None.
    """
    return _other_shape(controller.Tool)


def _number(bit, prop):
    value = getattr(bit, prop, 0.0)
    return float(getattr(value, "Value", value))


def _edges(bit):
    """(teeth, helix angle in degrees, what of them was assumed). FreeCAD's own tool bits have
    Flutes; a HelixAngle is there when the user has added it.
    """
    teeth, helix_angle, assumed = int(_number(bit, "Flutes")), HELIX_ANGLE_DEG, {}
    if teeth < 1:
        teeth, assumed["number of teeth"] = 1, "1 tooth"
    if hasattr(bit, "HelixAngle"):
        helix_angle = _number(bit, "HelixAngle")
    else:
        assumed["helix angle"] = "a helix of %g degrees" % helix_angle
    return teeth, helix_angle, assumed


def on_teeth(tool):
    """[a sentence] where a tool's number of teeth is not known."""
    return [ONE_TOOTH % tool.name] if "number of teeth" in tool.assumed else []


def _cuts_at_its_centre(bit):
    """Tool bits say so, if at all, by a yes / no property of their own."""
    for prop in ("CentreCutting", "CenterCutting"):
        if hasattr(bit, prop):
            return bool(getattr(bit, prop))
    return True


def _shapes(bit):
    """What a tool bit calls its shape, small letters and digits only: by a file and a name, since
    FreeCAD 1.1 by an asset and a type.
    """
    file = os.path.splitext(os.path.basename(getattr(bit, "BitShape", "") or ""))[0]
    words = file, *(getattr(bit, name, "") for name in ("ShapeName", "ShapeID", "ShapeType"))
    return ["".join(c for c in str(word or "").lower() if c.isalnum()) for word in words]


def _other_shape(bit):
    """What the tool is, in words, when it is no flat or bull-nosed end mill, else None."""
    if hasattr(bit, "ToolType"):  # FreeCAD 0.20's tools of old jobs
        kind = str(bit.ToolType)
        return None if kind in ("EndMill", "Undefined") else "of the type " + kind
    for shape in _shapes(bit):
        if shape in END_MILLS:
            return None
        if shape in OTHER_SHAPES:
            return OTHER_SHAPES[shape]
        if shape.startswith("ball"):
            return OTHER_SHAPES["ballend"]
    if any(hasattr(bit, prop) for prop in ANGLES):
        return "no straight cylinder"
    return None
