"""The parameters of a job's operation: properties, as JSON has their values."""

import math

import FreeCAD

from evenload import host
from evenload.job_files.keys import NUMBER
from evenload.settings.setting import BOOL, CHOICE, LINKS, POINT, SPEED

# FreeCAD's own properties of an operation that a job file may set.
HOST_PARAMETERS = (
    "StartDepth",
    "FinalDepth",
    "StepDown",
    "SafeHeight",
    "ClearanceHeight",
    "CoolantMode",
    "Comment",
)


def set_all(op, parameters, number):
    """Numbers are mm, degrees and mm/min, texts are quantities with a unit, lists are points,
    courses or names of objects.
    """
    known = [s.name for s in op.Proxy.settings] + list(HOST_PARAMETERS)
    for name, value in parameters.items():
        if name not in known:
            raise ValueError(
                "Job %d, parameters: unknown key '%s'; known keys are %s."
                % (number, name, ", ".join(known))
            )
    for name, value in parameters.items():
        kind = op.getTypeIdOfProperty(name)
        if kind == SPEED and isinstance(value, NUMBER):
            value = "%.12g mm/min" % value
        if any(path == name for path, _ in op.ExpressionEngine):
            op.setExpression(name, None)
        try:
            _set_one(op, name, kind, value)
        except Exception as error:
            choices = op.getEnumerationsOfProperty(name) or []
            remedy = "; it can be %s" % ", ".join(choices) if choices else ""
            raise ValueError(
                "Job %d, parameters: %s cannot be %r: %s%s."
                % (number, name, parameters[name], host.text_of(error), remedy)
            ) from None


def _named(doc, name):
    """The object of a name or a label."""
    found = [each for each in doc.Objects if name in (each.Name, each.Label)]
    if not found:
        raise ValueError("there is no object '%s'" % name)
    return found[0]


def _set_one(op, name, kind, value):
    """Sets a property; raises where FreeCAD refuses the value, or would take another for it."""
    if kind == BOOL and not isinstance(value, bool):
        raise ValueError("it must be true or false")
    if kind != BOOL and isinstance(value, bool):
        raise ValueError("it is no yes or no")
    if kind == CHOICE and not isinstance(value, str):
        raise ValueError("it must be a choice")
    if kind == POINT and isinstance(value, list):
        value = FreeCAD.Vector(*value)
    if kind == LINKS:
        value = [_named(op.Document, each) for each in value]
    setattr(op, name, value)
    taken = getattr(op, name)
    if isinstance(value, str) and hasattr(taken, "Value"):
        value = FreeCAD.Units.Quantity(value).Value
    if isinstance(value, NUMBER):
        taken = getattr(taken, "Value", taken)
        if not math.isclose(taken, value, rel_tol=1e-6, abs_tol=1e-9):  # such as lengths below 0
            raise ValueError("FreeCAD would take %g for it" % taken)
