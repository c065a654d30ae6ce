"""The rows of the settings table: all that is made from them without FreeCAD."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest
from evenload import compiled
from evenload.settings import pages, parameters, ranges
from evenload.settings.labels import LABELS
from evenload.settings.results import (
    HIDDEN_SETTINGS,
    RESULTS_OF_FINISHING,
    RESULTS_OF_LAME_SPIRAL,
    RESULTS_OF_TROCHOID,
    RESULT_SETTINGS,
)
from evenload.settings.setting import CHOICE, POINT, SPEED, Range
from evenload.settings.table import (
    ALL,
    BOXES,
    FINISHING,
    OF_ADAPTIVE,
    OF_FINISHING,
    OF_LAME_SPIRAL,
    OF_TROCHOID,
    SETTINGS,
    boxes_of,
)

DOCS = Path(__file__).resolve().parents[2] / "docs"
ROWS = {row.name: row for row in ALL}
FOLLOWERS = ("SideStep", "CuspHeight")  # of another setting
OWN = {
    "clear_pocket": OF_ADAPTIVE,
    "clear_slot": OF_TROCHOID,
    "clear_with_lame_spiral": OF_LAME_SPIRAL,
}


@pytest.mark.parametrize("name", pages.PAGES)
def test_the_tables_of_the_pages_are_those_of_the_rows(name):
    page = (DOCS / name).read_text(encoding="utf-8")
    assert pages.renewed(name, page) == page, "stale: ./run settings-pages writes it anew"


def test_a_page_whose_table_is_stale_is_renewed():
    page = (DOCS / "trochoid_operation.md").read_text(encoding="utf-8")
    stale = page.replace("| SlotWidth |", "| WidthOfSlot |")
    assert stale != page and pages.renewed("trochoid_operation.md", stale) == page


@pytest.mark.parametrize("row", ALL, ids=lambda row: row.name)
def test_a_row_tells_all_that_is_made_from_it(row):
    assert row.doc and row.label and row.page and row.box in BOXES
    assert (row.value is None) == bool(row.follows or row.fitted or row.name in FOLLOWERS)
    if row.value is None:
        assert row.default or row.fitted
    if row.when:
        choice, wanted = row.when
        assert set(wanted) < set(ROWS[choice].value)


def test_names_and_labels_are_each_of_one_setting():
    own = (*RESULTS_OF_LAME_SPIRAL, *RESULTS_OF_TROCHOID, *RESULTS_OF_FINISHING)
    results = (*RESULT_SETTINGS, *own, *HIDDEN_SETTINGS)
    names = [row.name for row in (*ALL, *results)]
    assert len(set(names)) == len(names)
    assert len(set(LABELS.values())) == len(ALL)


@pytest.mark.parametrize("function, own", OWN.items())
def test_the_core_knows_the_keywords_and_the_choices(function, own):
    told = getattr(compiled.core(), function).__doc__
    given = [row for row in (*SETTINGS, *own) if row.keyword]
    assert len({row.keyword for row in given}) == len(given)
    for row in given:
        assert re.search(r"\b%s\b" % row.keyword, told), row.keyword
        for choice in row.value if row.type == CHOICE else ():
            assert "'%s'" % choice.lower() in told, choice


def test_the_core_knows_the_keywords_and_the_choices_of_finishing():
    told = compiled.core().surface.finish.__doc__
    for row in OF_FINISHING:
        if row.keyword:
            assert re.search(r"\b%s\b" % row.keyword, told), row.keyword
            for choice in row.value if row.type == CHOICE else ():
                assert choice.lower() in told, choice


def test_the_panel_of_finishing_has_every_setting_in_one_box():
    shown = [row.name for _, rows in boxes_of(FINISHING) for row in rows]
    assert sorted(shown) == sorted(row.name for row in FINISHING)


@pytest.mark.parametrize("own", OWN.values(), ids=OWN)
def test_a_panel_has_every_setting_in_one_box(own):
    shown = [row for _, rows in boxes_of((*SETTINGS, *own)) for row in rows]
    assert sorted(row.name for row in shown) == sorted(row.name for row in (*SETTINGS, *own))


@pytest.mark.parametrize(
    "name, value, sentence",
    [
        ("EngagementAngle", 180, "is 180 degrees: it must lie between 0 and 180 degrees."),
        ("HelixAngle", 0, "is 0 degrees: it must lie between 0 and 90 degrees."),
        ("LeastLoad", 0.96, "is 0.96: it must lie between 0 and 0.95, shares of the nominal load."),
        ("LinkFeed", 0, "is 0 mm/min: it must be positive."),
        ("StockToLeave", -1, "is -1 mm: it must not be negative."),
    ],
)
def test_a_value_out_of_its_range_is_refused_by_name_and_unit(name, value, sentence):
    with pytest.raises(ValueError) as error:
        ranges.check(SimpleNamespace(**{name: value}), [ROWS[name]])
    assert str(error.value) == "%s %s" % (name, sentence)


@pytest.mark.parametrize("name, value", [("LeastLoad", 0.95), ("LeastLoad", 0), ("LinkLift", 0)])
def test_limits_that_are_inclusive_are_allowed(name, value):
    ranges.check(SimpleNamespace(**{name: value}), [ROWS[name]])


def test_a_range_without_upper_limit_has_none():
    assert Range(0).refusal(1e99) is None and Range(0, inclusive=True).refusal(1e99) is None


def test_the_core_gets_radians_millimetres_and_small_letters():
    obj = SimpleNamespace(
        EngagementAngle=SimpleNamespace(Value=90.0),
        LinkFeed=SimpleNamespace(Value=25.0),  # FreeCAD's mm/s
        OrderBy="Depth",
        Arcs=False,
        OwnValues=["Centre"],
        Centre=SimpleNamespace(x=1.0, y=2.0, z=3.0),
        ExponentCourse=(0.0, 1.0),
        Tolerance=0.1,
    )
    names = "EngagementAngle LinkFeed OrderBy Arcs Centre Pitch ExponentCourse Tolerance".split()
    assert parameters.of(obj, [ROWS[name] for name in names]) == {
        "engagement_angle": pytest.approx(1.5707963267948966),
        "link_feed": 1500.0,
        "order_by": "depth",
        "arcs": False,
        "centre": (1.0, 2.0),
        "exponent_course": [0.0, 1.0],
    }  # without Pitch, which was not set, and Tolerance, which is no keyword of the core alone


def test_what_was_fitted_comes_back_in_the_properties_units():
    obj = SimpleNamespace(
        OwnValues=["Pitch"], Rotation=0.0, Centre=SimpleNamespace(x=0.0, y=0.0, z=3.0), Pitch=0.8
    )
    figures = SimpleNamespace(rotation=0.5, centre=(1.0, 2.0), pitch=0.7)
    rows = [ROWS[name] for name in ("Rotation", "Centre", "Pitch")]
    found = parameters.fitted(obj, rows, figures)
    assert found == {"Rotation": pytest.approx(28.64788975654116), "Centre": (1.0, 2.0, 3.0)}


def test_what_follows_the_tool_follows_from_diameter_and_feeds():
    values = {row.name: row.follows(6.0, 4.0, 0.0) for row in ALL if row.follows}
    assert values.pop("MaximumFeed") == 8 and values.pop("LinkFeed") == 8
    assert ROWS["LinkFeed"].follows(6.0, 4.0, 80.0) == 80
    assert values == {
        "HelixDiameter": pytest.approx(5.4),
        "RollRadius": pytest.approx(0.9),
        "MinimumRadius": pytest.approx(0.9),
        "Stepover": pytest.approx(0.3),
        "LeadRadius": pytest.approx(0.6),
        "StockOnFaces": pytest.approx(0.18),
    }


def test_no_choice_and_no_point_has_a_range():
    assert not [row.name for row in ALL if row.range and row.type in (CHOICE, POINT)]
    assert all(row.range for row in ALL if row.type == SPEED)
