"""What the core's generators say of keyword arguments that they cannot use."""

import pytest
from evenload import compiled

core = compiled.core()
SQUARE = core.Region([(0, 0, 0), (20, 0, 0), (20, 20, 0), (0, 20, 0)])
ENOUGH = {
    "tool_diameter": 6,
    "engagement_angle": 1.0,
    "feed": 255,
    "plunge_feed": 255,
    "link_feed": 1500,
    "maximum_feed": 1000,
    "levels": [-3],
    "safe_height": 3,
    "clearance_height": 5,
}


def clear(**changes):
    return core.clear_pocket([SQUARE], **{**ENOUGH, **changes})


def test_the_required_arguments_are_enough():
    assert len(clear()) > 0


@pytest.mark.parametrize("name", ENOUGH)
def test_a_missing_argument_is_named(name):
    given = {key: value for key, value in ENOUGH.items() if key != name}
    with pytest.raises(TypeError, match="clear_pocket.* misses the argument '%s'" % name):
        core.clear_pocket([SQUARE], **given)


def test_an_unknown_argument_is_named():
    with pytest.raises(TypeError, match="knows no argument 'fead'"):
        clear(fead=3)


@pytest.mark.parametrize(
    "name, value", [("feed", "fast"), ("levels", -3), ("entry_point", (1, 2, 3)), ("arcs", "no")]
)
def test_an_argument_of_the_wrong_type_is_named(name, value):
    with pytest.raises(TypeError, match="'%s' has the wrong type" % name):
        clear(**{name: value})


@pytest.mark.parametrize("name", ["cut_mode", "feed_control", "entry", "order_by"])
@pytest.mark.parametrize("value", ["sideways", ""])
def test_a_choice_that_is_none_is_refused_with_those_that_are(name, value):
    with pytest.raises(ValueError, match="%s must be one of '.*', not '%s'" % (name, value)):
        clear(**{name: value})


def test_none_is_no_hole_and_nobody_who_watches():
    assert len(clear(entry_point=None, progress=None)) > 0


def test_who_watches_can_cancel():
    assert clear(progress=lambda share: False).report.termination == "cancelled"
