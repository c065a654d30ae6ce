"""An operation as it is seen while its panel is open, without a recompute."""

from types import SimpleNamespace

import FreeCAD

from evenload import tool as tools
from evenload.operations.checks import DEPTHS
from evenload.operations.following import ANGLE, STEP, angle_of, step_of


class Seen:
    """What an operation's properties will be once FreeCAD has evaluated their expressions, which it
    does in a recompute: by default depths follow the base geometry so. Of engagement angle and side
    step the one follows the other's expression. Nothing is touched.
    """

    def __init__(self, op):
        """Raises ValueError with a sentence for an expression that cannot be evaluated."""
        self.operation = op
        self._evaluated = {
            path: _evaluated(op, path, expression)
            for path, expression in op.ExpressionEngine
            if hasattr(op, path)
        }
        self._follow(ANGLE, STEP, angle_of)
        self._follow(STEP, ANGLE, step_of)

    def _follow(self, name, leader, value_of):
        """Has an engagement angle or side step follow its leader, where that has an expression."""
        if leader not in self._evaluated or name in self._evaluated:
            return
        value = value_of(tools.diameter(self.ToolController), self._evaluated[leader].Value)
        if value is not None:
            unit = getattr(self.operation, name).Unit
            self._evaluated[name] = FreeCAD.Units.Quantity(value, unit)

    def __getattr__(self, name):
        if name in self._evaluated:
            return self._evaluated[name]
        return getattr(self.operation, name)


def settings_of(op, rows):
    """The values of an operation's settings and depths by their names, which stay what they are
    whatever becomes of the operation.
    """
    names = [*(row.name for row in rows), *DEPTHS, "OwnValues"]
    return SimpleNamespace(**{name: getattr(op, name) for name in names if hasattr(op, name)})


def _evaluated(op, path, expression):
    """The value of an expression, of the kind that its property has."""
    before = getattr(op, path)
    try:
        value = op.evalExpression(expression)
    except RuntimeError as error:
        raise ValueError(
            "The expression of %s, '%s', cannot be evaluated: mend it." % (path, expression)
        ) from error
    if not hasattr(before, "Value"):
        return value
    return FreeCAD.Units.Quantity(getattr(value, "Value", value), before.Unit)
