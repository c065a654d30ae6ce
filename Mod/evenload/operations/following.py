"""Settings that follow others: the tool and its controller, and side step and angle each other."""

import math

import FreeCAD

from evenload import host
from evenload import tool as tools

ANGLE, STEP = "EngagementAngle", "SideStep"


class Following(host.operation_base()):
    """What an operation's proxy does to keep settings that follow others up to date."""

    settings = ()  # rows
    is_changing = False  # whether what changes now is no wish of the user's

    def is_wish(self, obj):
        """Whether what changes now is a wish of the user's, or a macro's."""
        return not (
            self.is_changing
            or "Restore" in obj.State
            or getattr(obj.Document, "Transacting", False)
        )

    def own_names(self):
        """The names of settings that follow the tool or the geometry until they are set."""
        return [row.name for row in self.settings if row.follows or row.fitted]

    def follow_tool(self, obj, again=()):
        """Sets what follows the tool and its controller. again: names of settings that shall follow
        once more.
        """
        if not hasattr(obj, "OwnValues"):
            return
        if again:
            obj.OwnValues = [name for name in obj.OwnValues if name not in again]
        controller = obj.ToolController
        diameter = tools.diameter(controller)
        if not diameter > 0:
            return
        feed, rapid = controller.HorizFeed.Value, controller.HorizRapid.Value
        self.is_changing = True
        try:
            for row in self.settings:
                if row.follows and row.name not in obj.OwnValues:
                    assign(obj, row.name, row.follows(diameter, feed, rapid))
        finally:
            self.is_changing = False
        # A side step that cannot be stays, to be refused.
        if not _has_engagement(obj) or not 0 < obj.SideStep.Value < obj.OpToolDiameter.Value:
            return
        if STEP in bound(obj):
            self.set_angle(obj)
        else:
            self.set_side_step(obj)

    def set_side_step(self, obj):
        if not _has_engagement(obj):
            return
        step = step_of(tools.diameter(obj.ToolController), obj.EngagementAngle.Value)
        if step is not None:
            self.quietly(obj, STEP, step)

    def set_angle(self, obj):
        angle = angle_of(tools.diameter(obj.ToolController), obj.SideStep.Value)
        if angle is not None:
            self.quietly(obj, ANGLE, angle)

    def quietly(self, obj, name, value):
        before, self.is_changing = self.is_changing, True
        try:
            assign(obj, name, value)
        finally:
            self.is_changing = before


def bound(obj):
    """The names of the properties that expressions set, in an operation or what is Seen of one."""
    return {path.lstrip(".").split(".")[0] for path, _ in obj.ExpressionEngine}


def step_of(diameter, angle):
    """The side step, mm, at an engagement angle in degrees; None where there is none."""
    if not (diameter > 0 and 0 < angle < 180):
        return None
    return diameter / 2 * (1 - math.cos(math.radians(angle)))


def angle_of(diameter, step):
    """The engagement angle, degrees, at a side step in mm; None where there is none."""
    if not (diameter > 0 and 0 < step < diameter):
        return None
    return math.degrees(math.acos(1 - 2 * step / diameter))


def _has_engagement(obj):
    """Whether an operation has an engagement angle; those on surfaces have none."""
    return hasattr(obj, "SideStep")


def assign(obj, name, value):
    """Assigns only what differs, so that nothing is touched without need."""
    before = getattr(obj, name)
    before = getattr(before, "Value", before)
    if isinstance(before, FreeCAD.Vector):
        value = FreeCAD.Vector(value)
        differs = (before - value).Length > 1e-9 * max(1.0, value.Length)
    else:
        differs = abs(before - value) > 1e-9 * max(1.0, abs(value))
    if differs:
        setattr(obj, name, value)
