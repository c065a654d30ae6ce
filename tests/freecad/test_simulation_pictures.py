"""Pictures of simulations show what the simulation has, as PNG and as SVG, without a display."""

import re

import numpy
import pytest
from evenload import job_simulation, simulation_pictures
from evenload.pictures import over_time, path_picture
from models import SQUARE, block_with, circle, face_of
from simulated import faulty, simulated

pytestmark = pytest.mark.between

RATE = 1147.5  # mm3/min: side step 1.5 mm, depth 3 mm, feed 255 mm/min


@pytest.fixture
def done(bench):
    """A computed operation in a square with a round island, and what the simulator gets of it."""
    on = bench(block_with(face_of(SQUARE, [circle(15, 15, 4)])))
    op = on.done(on.operation())
    return op, job_simulation.read(op)


def labels(axes):
    return axes.get_legend_handles_labels()[1]


def head_of(figure):
    """The words over all pictures of a sheet."""
    (head,) = [text.get_text() for text in figure.texts]
    return head


def test_pictures_are_png_or_svg_by_their_names(done, tmp_path):
    op, setup = done
    simulation = faulty(op)
    for draw, more in (
        (simulation_pictures.path, ()),
        (simulation_pictures.load, ()),
        (simulation_pictures.force, ()),
        (simulation_pictures.rest, (setup.stock, setup.part)),
        (simulation_pictures.sheet, (setup.stock, setup.part)),
    ):
        draw(simulation, str(tmp_path / "picture.png"), *more)
        assert (tmp_path / "picture.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
        draw(simulation, str(tmp_path / "picture.svg"), *more)
        text = (tmp_path / "picture.svg").read_text()
        assert text.startswith("<?xml") and "</svg>" in text
        assert re.search("time, s|x, mm", re.sub("<[^>]*>", "", text))  # words stay words
        assert sorted(file.name for file in tmp_path.iterdir()) == ["picture.png", "picture.svg"]


def test_the_same_simulation_gives_the_same_svg(done, tmp_path):
    op, setup = done
    for name in ("a.svg", "b.svg"):
        simulation_pictures.rest(faulty(op), str(tmp_path / name), setup.stock, setup.part)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_the_path_is_coloured_by_engagement_up_to_a_little_above_its_target(done):
    op, setup = done
    simulation = simulated(op)
    walls = [region for region, top in setup.part if top == 0]
    figure = simulation_pictures.path(simulation, None, walls, target_deg=60)
    axes, bar = figure.axes
    assert bar.get_ylabel() == "engagement angle, degrees"
    cuts = next(c for c in axes.collections if c.get_array() is not None)
    assert cuts.get_clim() == (0, 69)
    assert 0.9 * sum(simulation.kind == 3) < len(cuts.get_segments()) <= sum(simulation.kind == 3)
    assert max(cuts.get_array()) == pytest.approx(max(simulation.engagement_deg), abs=1)
    assert {"links", "entry", "start", "part"} <= set(labels(axes))
    outlines = [line for line in axes.lines if len(line.get_xdata()) > 3]
    assert len(outlines) == 3  # stock, pocket, island


def test_load_is_drawn_over_time_with_its_limits(done):
    simulation = simulated(done[0])
    upper, lower = simulation_pictures.load(simulation, None, 60, RATE).axes
    assert "target 60\u00b0" in labels(upper) and labels(lower) == ["nominal 1.147 cm\u00b3/min"]
    assert {"cuts", "links", "entries"} <= set(labels(upper))
    for axes, limit in ((upper, 60), (lower, RATE / 1000)):
        line = next(line for line in axes.lines if line.get_linestyle() == "--")
        assert line.get_ydata()[0] == pytest.approx(limit)
        assert axes.get_ylim()[1] > limit
        assert axes.get_xlim() == (0, simulation.time_s[-1])
    drawn = max(max(line.get_ydata()) for line in lower.lines)
    assert drawn == pytest.approx(max(simulation.removal_rate) / 1000)
    upper, lower = simulation_pictures.load(simulation, None).axes
    assert not any("target" in label for label in labels(upper)) and labels(lower) == []


def test_short_simulations_are_drawn_sample_by_sample(done):
    whole = simulated(done[0])
    arrays = ("x", "y", "kind", "time_s", "engagement_deg", "removal_rate", "force_peak")
    short = {name: getattr(whole, name)[:50] for name in (*arrays, "force_mean")}
    simulation = simulated(done[0], **short)
    (axes,) = simulation_pictures.force(simulation, None).axes
    peak, mean = axes.lines
    assert list(peak.get_ydata()) == list(short["force_peak"])
    assert list(mean.get_ydata()) == list(short["force_mean"])


def test_forces_have_peak_mean_and_a_reference(done):
    simulation = simulated(done[0])
    (axes,) = simulation_pictures.force(simulation, None, reference=99).axes
    assert labels(axes) == ["peak", "mean of a revolution", "reference 99 N"]
    drawn = max(max(line.get_ydata()) for line in axes.lines)
    assert drawn == pytest.approx(simulation.force_peak_max)


def test_a_simulation_without_forces_says_so(done):
    op, setup = done
    simulation = simulated(op, force_peak=None, force_mean=None, force_peak_max=None)
    with pytest.raises(ValueError, match="has no forces: name a material"):
        simulation_pictures.force(simulation, None)
    figure = simulation_pictures.sheet(simulation, None, setup.stock, setup.part)
    words = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert "no material, no forces" in words
    assert "force" not in head_of(figure)


def test_the_rest_shows_stock_part_patches_and_incidents_at_their_places(done):
    op, setup = done
    simulation = faulty(op)
    (axes,) = simulation_pictures.rest(simulation, None, setup.stock, setup.part).axes
    assert labels(axes) == [
        "part, top at z = -3",
        "part, top at z = 0",
        "rest",
        "gouge (1)",
        "rapid in material (2)",
        "plunge in material (1)",
    ]
    assert sorted(text.get_text() for text in axes.texts) == ["0.45 mm\u00b2", "1.00 mm\u00b2"]
    assert [text.xy for text in axes.texts] == [(4.0, 26.0), (25.0, 4.0)]
    marked = {
        c.get_label(): numpy.asarray(c.get_offsets()).tolist()
        for c in axes.collections
        if c.get_label().endswith(")")
    }
    assert marked["gouge (1)"] == [[0, 12]]
    assert marked["rapid in material (2)"] == [[9, 9], [11, 9]]
    assert marked["plunge in material (1)"] == [[20, 20]]
    assert len(axes.patches) == len(setup.part) + 2
    (outline,) = axes.lines
    assert (outline.get_xdata().min(), outline.get_ydata().max()) == (-10, 40)


def test_a_part_with_a_hole_in_it_is_drawn_with_the_hole(done):
    op, setup = done
    walls = [(region, top) for region, top in setup.part if top == 0]
    figure = simulation_pictures.rest(simulated(op), None, setup.stock, walls)
    figure.canvas.draw()
    pixels = numpy.asarray(figure.canvas.buffer_rgba())[::-1]

    def colour(x, y):
        column, row = figure.axes[0].transData.transform((x, y)).astype(int)
        return tuple(pixels[row, column, :3])

    assert colour(-5, -5) == colour(15, 15) != (255, 255, 255)  # around the pocket, island
    assert colour(1, 1) == (255, 255, 255)  # in the pocket, where no path is drawn


def test_nothing_wrong_is_said_in_words(done):
    op, setup = done
    (axes,) = simulation_pictures.rest(simulated(op), None, setup.stock, None).axes
    assert labels(axes) == ["no rest, no incidents"]


def test_stock_and_part_may_be_boxes_chains_and_points(done):
    shapes = [(-10, -10, 40, 40), circle(15, 15, 12), [(0, 0), (5, 0), (5, 5)]]
    part = [(item, 0.0) for item in shapes]
    (axes,) = simulation_pictures.rest(simulated(done[0]), None, shapes, part).axes
    assert len(axes.patches) == 3
    assert [len(line.get_xdata()) for line in axes.lines[:3:2]] == [5, 4]
    assert len(axes.lines[1].get_xdata()) > 30


def test_the_sheet_has_all_four_and_the_figures_over_them(done):
    op, setup = done
    bad = faulty(op)
    figure = simulation_pictures.sheet(
        bad, None, setup.stock, setup.part, None, 60, RATE, title="plate"
    )
    assert len(figure.axes) == 6  # path and its colours, rest, engagement, removal rate, force
    times = "plate\n%.0f s, 150 s on the machine" % bad.time_total_s
    assert head_of(figure).startswith(times)
    assert "rest 1.45 mm\u00b2, gouge 0.050 mm" in head_of(figure)
    walls = [line for line in figure.axes[0].lines if len(line.get_xdata()) > 3]
    assert len(walls) == 3


def test_columns_keep_least_mean_and_largest_of_every_span():
    time = numpy.array([0.0, 0.1, 0.2, 5.0, 5.1, 9.9, 10.0])
    values = numpy.array([1.0, 2.0, 6.0, 4.0, 0.0, 7.0, 9.0])
    middle, least, mean, largest = over_time.columns(time, values, 10)
    assert middle.tolist() == [0.5, 5.5, 9.5]
    assert least.tolist() == [1, 0, 7] and largest.tolist() == [6, 4, 9]
    assert mean.tolist() == [3, 2, 8]


def test_long_paths_are_pixels_in_an_svg(done, tmp_path, monkeypatch):
    simulation = simulated(done[0])
    simulation_pictures.path(simulation, str(tmp_path / "vectors.svg"))
    monkeypatch.setattr(path_picture, "MOST_VECTORS", 100)
    simulation_pictures.path(simulation, str(tmp_path / "pixels.svg"))
    vectors, pixels = ((tmp_path / name).read_text() for name in ("vectors.svg", "pixels.svg"))
    assert pixels.count("<path") < 0.1 * vectors.count("<path")
    assert pixels.count("<image") > vectors.count("<image")
