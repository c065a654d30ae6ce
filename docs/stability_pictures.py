"""The pictures of docs/stability_chart.md; see make_pictures.py."""

from dynamics_pictures import kept
from evenload import materials
from evenload.dynamics import directions, pictures, vibration
from evenload.pictures.figure import new_figure
from evenload.stability import cut as cuts
from evenload.stability import field, picture
from picture_parts import DOCS

TESTS = [{"file": "tap_%s.csv" % axis, "axis": axis + axis, "modes": 2} for axis in "xy"]


def example():
    """(Cut, Vibration) of the page's macro."""
    found = vibration.load({"tap_tests": TESTS}, str(DOCS.parent / "examples"))
    cut = cuts.Cut(
        label="Pocket",
        modes=found.modes,
        teeth=2,
        diameter=6.0,
        helix_angle=30.0,
        flute_length=30.0,
        engagement_deg=60.0,
        cut_mode="climb",
        material=materials.load("Al7075-T6"),
        speed=9000.0,
        depth=6.0,
        feed_per_tooth=0.04,
        directions=directions.ALL,
    )
    return cut, found


def draw_chart(core):
    cut, _ = example()
    *_, found = field.levels(cut, (5000, 16000), (0.02, 8))
    figure = new_figure(9, 5, layout="constrained")
    axes = figure.add_subplot()
    picture.draw(axes, found, cut, is_stable=False)
    axes.set_title(
        "A pocket of 6 mm with an end mill of 6 mm, climb, all feed directions", loc="left"
    )
    kept(figure, "stability_chart.png")


def draw_fit(core):
    _, found = example()
    kept(pictures.fit(found.fits[0], None, title=""), "stability_tap_test.png")


PICTURES = (draw_chart, draw_fit)
