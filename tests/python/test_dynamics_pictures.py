"""Pictures of milling dynamics: they are drawn, and say what the figures say."""

import pytest
from dynamics_cases import case, modes
from evenload.dynamics import Frf, pictures


@pytest.fixture(scope="module")
def chart():
    return case("islands").chart((16000, 20000, 16), (0.3, 5, 12), tolerance=1 / 48)


def test_a_chart_is_drawn_as_png_and_svg(chart, tmp_path):
    for name, beginning in (("chart.png", b"\x89PNG"), ("chart.svg", b"<?xml")):
        path = tmp_path / name
        figure = pictures.chart(chart, path, point=(18000, 2), feed_per_tooth=0.1, frequency=922)
        assert path.read_bytes().startswith(beginning)
    assert len(figure.axes) == 2
    again = tmp_path / "again.svg"
    pictures.chart(chart, again, point=(18000, 2), feed_per_tooth=0.1, frequency=922)
    assert again.read_bytes() == (tmp_path / "chart.svg").read_bytes()


def test_the_operation_s_point_has_a_sentence(chart):
    words = pictures.sentence(chart, 18000, 2.0)
    assert words.startswith("unstable at 2 mm: limit 1.72 mm at 18000 rev/min, chatter near 900 Hz")
    assert "; stable at" in words
    assert pictures.sentence(chart, 16500, 1.0).startswith("stable at 16500 rev/min and 1 mm")


def test_walls_fits_and_orbits_are_drawn(tmp_path):
    milling = case("iso_down")
    surface = milling.surface(9000, 1.0, 0.1)
    pictures.wall(surface, tmp_path / "wall.png", 1.0, 0.1)
    pictures.fit(Frf.of_modes(modes("iso_down")).fit(1), tmp_path / "fit.png")
    orbits = case("half_up", immersion=0.35).forced_orbits(9000, [0.1, 0.2], 0.05)
    pictures.orbits(orbits, tmp_path / "orbits.png")
    assert {path.name for path in tmp_path.iterdir()} == {"wall.png", "fit.png", "orbits.png"}
