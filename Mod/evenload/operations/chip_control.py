"""The feed control of finishing: cuts whose chips have a constant mean thickness."""

from evenload import tool as tools
from evenload import waiting
from evenload.ball_end import chip_feeds
from evenload.ball_end.loads import Cutting
from evenload.operations.refusal import Cancelled
from evenload.settings.table import CONSTANT_CHIP

PATH_SHARE = 0.6  # of the time that the path takes, about
SAME = 1e-9  # mm


def is_wanted(settings):
    """Whether the feed follows the chips."""
    return settings.FeedControl == CONSTANT_CHIP


def check(settings, tool, data):
    """Raises ValueError where the feed shall follow chips that are not known."""
    if not is_wanted(settings):
        return
    if tool.end_radius < tool.diameter / 2 - SAME:
        raise ValueError(
            "FeedControl is '%s', but the tool '%s' has no ball end, and the chips that are known "
            "are those of a ball: take a ball end mill, or another FeedControl."
            % (CONSTANT_CHIP, tool.name)
        )
    if not data.spindle_speed > 0:
        raise ValueError(
            "FeedControl is '%s', but without a spindle speed there is no feed per tooth: set that "
            "of the tool controller." % CONSTANT_CHIP
        )
    stock = settings.StockOnFaces.Value
    if not 0 < stock < tool.diameter / 2:
        raise ValueError(
            "StockOnFaces is %g mm: it must lie between 0 and the ball's radius of %g mm."
            % (stock, tool.diameter / 2)
        )
    most = maximum_feed(settings)
    if most < data.feed * (1 - SAME):
        raise ValueError(
            "MaximumFeed is %g mm/min: it must not be below the tool controller's horizontal "
            "feed of %g mm/min." % (most, data.feed)
        )


def maximum_feed(settings):
    """mm/min"""
    value = settings.MaximumFeed
    return 60 * getattr(value, "Value", value)


def path_watch(settings, watch):
    """Who is asked while the path is made, with the share of all that there is to do."""
    if watch is None or not is_wanted(settings):
        return watch
    return lambda share: watch(PATH_SHARE * share)


def fed(finish, mesh, settings, tool, data, arguments, watch):
    """(the path of a core's Finish at the feeds of the settings, sentences). Raises ValueError with
    a sentence where they cannot be, Cancelled.
    """
    if not is_wanted(settings):
        return finish.toolpath, []
    ball = Cutting(
        tool.diameter, tool.teeth, data.spindle_speed, settings.StockOnFaces.Value, coefficients={}
    )
    stepover = max(finish.largest_stepover, arguments["stepover"])
    rest = watch and (lambda share: watch(PATH_SHARE + (1 - PATH_SHARE) * share))
    try:
        with waiting.asking(rest):
            found = chip_feeds.fed(
                *(finish.toolpath, mesh, arguments, stepover, ball, maximum_feed(settings))
            )
    except waiting.Stopped:
        raise Cancelled(0.0) from None
    note = "Feeds of the cuts: %.0f to %.0f mm/min, for chips with a mean thickness of %.2f µm."
    told = note % (found.least, found.largest, 1e3 * found.thickness)
    return found.toolpath, [told, *tools.on_teeth(tool)]
