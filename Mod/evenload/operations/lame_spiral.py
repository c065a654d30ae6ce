"""Lamé spiral: clears round, square and many-sided pockets, and round islands, by spirals."""

import math

import FreeCAD

from evenload.operations import base
from evenload.settings.properties import GROUP, RESULTS, RESULT_SETTINGS, SETTINGS, Setting

NAME = "EvenLoad Lame Spiral"  # FreeCAD makes names of properties from it
# Fitted to the pocket unless they are set: property and the core's keyword.
FITTED = {
    "Segments": "segments",
    "SemiAxisA": "semi_axis_a",
    "SemiAxisB": "semi_axis_b",
    "ExponentStart": "exponent_start",
    "ExponentEnd": "exponent_end",
    "Rotation": "rotation",
    "Pitch": "pitch",
}
CENTRE = "Centre"
# Courses from the first turn to the last; where one is empty, the core has its own.
COURSES = {
    "SemiAxisACourse": "semi_axis_a_course",
    "SemiAxisBCourse": "semi_axis_b_course",
    "ExponentCourse": "exponent_course",
}


class LameSpiral(base.Operation):
    """Proxy of the Lamé spiral operation. Documents refer to this class by its module and name:
    both stay.
    """

    name = NAME
    partly_open = False
    fitted = (*FITTED, CENTRE)
    settings = (
        *SETTINGS,
        Setting(
            "Segments",
            "App::PropertyInteger",
            None,
            "Sides of the curve: 3 for a triangle, 4 for a square or a rectangle; fitted unless "
            "it is set",
            GROUP,
        ),
        Setting(
            "SemiAxisA",
            "App::PropertyLength",
            None,
            "First semi-axis of the spiral's last turn, of the tool's centre; fitted unless it is "
            "set",
            GROUP,
        ),
        Setting(
            "SemiAxisB",
            "App::PropertyLength",
            None,
            "Second semi-axis of the spiral's last turn, of the tool's centre; fitted unless it "
            "is set",
            GROUP,
        ),
        Setting(
            "ExponentStart",
            "App::PropertyFloat",
            None,
            "Exponent of the first turn: 1 is an ellipse; fitted unless it is set",
            GROUP,
        ),
        Setting(
            "ExponentEnd",
            "App::PropertyFloat",
            None,
            "Exponent of the last turn: towards 0 corners grow sharper; fitted unless it is set",
            GROUP,
        ),
        Setting(
            "Rotation",
            "App::PropertyAngle",
            None,
            "Of the first semi-axis against the X axis; fitted unless it is set",
            GROUP,
        ),
        Setting(
            "Pitch",
            "App::PropertyLength",
            None,
            "The largest step of a turn; fitted to the engagement angle unless it is set, and "
            "smaller where that demands it",
            GROUP,
        ),
        Setting(
            CENTRE,
            "App::PropertyVectorDistance",
            None,
            "Centre of the spiral; fitted unless it is set",
            GROUP,
        ),
        Setting(
            "SemiAxisACourse",
            "App::PropertyFloatList",
            [],
            "How the first semi-axis comes from the first turn to the last: 2 to 20 shares of its "
            "change, from 0 to 1, at even steps, as 0; 0.1; 0.4; 1; evenly where it is empty",
            GROUP,
        ),
        Setting(
            "SemiAxisBCourse",
            "App::PropertyFloatList",
            [],
            "The same of the second semi-axis",
            GROUP,
        ),
        Setting(
            "ExponentCourse",
            "App::PropertyFloatList",
            [],
            "The same of the exponent; evenly or late, as is quicker, where it is empty",
            GROUP,
        ),
        Setting(
            "Rest",
            "App::PropertyEnumeration",
            ["Clear", "Leave"],
            "What the spiral does not reach: cleared at constant engagement, or left",
            GROUP,
        ),
    )
    results = (
        *RESULT_SETTINGS,
        Setting(
            "ClearedShare",
            "App::PropertyFloat",
            0.0,
            "Share of the pocket that the spiral clears, 0 to 1",
            RESULTS,
        ),
    )

    def generate(self, obj, core, regions, parameters):
        wishes = {
            keyword: _number(obj, name) for name, keyword in FITTED.items() if name in obj.OwnValues
        }
        if "rotation" in wishes:
            wishes["rotation"] = math.radians(wishes["rotation"])
        if CENTRE in obj.OwnValues:
            wishes["centre"] = (obj.Centre.x, obj.Centre.y)
        courses = {keyword: list(getattr(obj, name)) for name, keyword in COURSES.items()}
        toolpath = core.clear_with_lame_spiral(
            regions, rest=obj.Rest.lower(), **wishes, **courses, **parameters
        )
        spiral = toolpath.figures
        if spiral is None:  # Report tells why; what was fitted before stays
            return toolpath, {"ClearedShare": 0.0}
        values = {name: getattr(spiral, keyword) for name, keyword in FITTED.items()}
        values["Rotation"] = math.degrees(spiral.rotation)
        values[CENTRE] = FreeCAD.Vector(*spiral.centre, obj.Centre.z)
        own = {name: value for name, value in values.items() if name not in obj.OwnValues}
        return toolpath, {**own, "ClearedShare": toolpath.cleared_share}


def _number(obj, name):
    value = getattr(obj, name)
    return getattr(value, "Value", value)


def Create(name, obj=None, parentJob=None, toolController=None):
    """A new Lamé spiral operation, as a document object; see base.create for the arguments."""
    return base.create(LameSpiral, name, obj, parentJob, toolController)


base.register(LameSpiral, Create)
