"""The strategies that are compared."""

from dataclasses import dataclass

from evenload.settings.table import PARALLEL, SPIRALS


@dataclass(frozen=True)
class Strategy:
    """Of the finishing operation: its settings Strategy and, for parallel passes, PassAngle, in
    degrees from the X axis.
    """

    pattern: str
    angle: float = 0.0

    @property
    def settings(self):
        """{name: value} of the operation's properties that it sets."""
        if self.pattern not in PARALLEL:
            return {"Strategy": self.pattern}
        return {"Strategy": self.pattern, "PassAngle": self.angle}

    @property
    def name(self):
        """Such as 'Zig-zag 22.5°'."""
        return "%s %g°" % (self.pattern, self.angle) if self.pattern in PARALLEL else self.pattern


ZIG_ZAG, ONE_WAY = PARALLEL
# The source's directions of zig-zag passes, its contours and its spirals [Varga 2023, ch. 6: 1 to
# 6, 8 and 9], and two more; docs/finishing.md says what is not there of the source's ten.
STRATEGIES = (
    *(Strategy(ZIG_ZAG, angle) for angle in (0.0, 22.5, 45.0, 67.5, 90.0)),
    Strategy("Contours inwards"),
    Strategy("Contours outwards"),
    *(Strategy(each) for each in SPIRALS),
    Strategy(ONE_WAY),
)
