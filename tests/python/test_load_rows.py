"""The plots over time: their labels can be read, and what they are drawn by is their own."""

import io
import itertools
import threading

import matplotlib
import pytest
from evenload import translation, units
from evenload.pictures import load_rows, over_time
from evenload.pictures.figure import SVG, new_figure, save
from evenload.pictures.load_rows import Run
from languages import translator
from matplotlib.text import Text
from simulated_paths import BELOW, STAR, climb, simulated

# Pixels of 1/96 inch: the least that a plot in the window has, and what one in a laptop's has.
SIZES = {"least": (420, 300), "laptop": (640, 330)}
LIMITS = {"engagement_deg": 70.0, "removal_rate": 3000.0, "force_peak": 400.0}


@pytest.fixture(scope="module")
def runs():
    """Named as the operations are by themselves."""
    found = simulated(climb(60), BELOW, cutting=STAR, machine="linuxcnc_mill")
    return [Run("EvenLoadAdaptive", found), Run("EvenLoadTrochoid", found)]


@pytest.fixture(params=["en", "de", "hu"])
def language(request, monkeypatch):
    if request.param != "en":
        monkeypatch.setattr(translation, "translator", translator(request.param))
    return request.param


@pytest.fixture(params=["mm", "in"])
def unit(request, monkeypatch):
    monkeypatch.setattr(units, "shows_inches", lambda: request.param == "in")
    return request.param


def drawn(runs, size):
    width, height = (pixels / 96 for pixels in size)
    figure = new_figure(width, height)
    columns = load_rows.draw(figure, runs, LIMITS)
    figure.canvas.draw()
    return figure, columns


def boxes_of(figure):
    """[(text, its box in pixels), ...] of what is seen of words and numbers."""
    found = [each for each in figure.findobj(Text) if each.get_visible() and each.get_text()]
    shown = [(each.get_text(), each.get_window_extent()) for each in found]
    # Matplotlib keeps numbers of ticks that are beyond their axes, and does not draw them.
    ticks = {id(t) for axes in figure.axes for t in _hidden_ticks(axes)}
    return [pair for each, pair in zip(found, shown) if id(each) not in ticks]


def _hidden_ticks(axes):
    for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
            if not low <= tick.get_loc() <= high:
                yield from (tick.label1, tick.label2)


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize("size", SIZES)
def test_labels_do_not_lie_over_each_other(runs, size, count, language, unit):
    figure, columns = drawn(runs[:count], SIZES[size])
    boxes, whole = boxes_of(figure), figure.bbox
    words = {axes.get_ylabel() for axes in columns[0]}
    assert len(words) == len(load_rows.ROWS) and words <= {text for text, _ in boxes}
    over = [(a, b) for (a, p), (b, q) in itertools.combinations(boxes, 2) if p.overlaps(q)]
    assert over == []
    beyond = [t for t, b in boxes if b.x0 < 0 or b.y0 < 0 or b.x1 > whole.x1 or b.y1 > whole.y1]
    assert beyond == []


def test_no_label_lies_over_the_plots(runs, language):
    figure, columns = drawn(runs, SIZES["least"])
    for axes in itertools.chain(*columns):
        assert not any(axes.bbox.overlaps(box) for _, box in boxes_of(figure))


def test_long_names_keep_to_their_columns(runs):
    name = "Roughing of the large pocket, second setup, %d"
    long = [Run(name % number, run.simulation) for number, run in enumerate(runs)]
    for size in SIZES:
        figure, columns = drawn(long, SIZES[size])
        titles = [axes.get_title(loc="left") for axes, *_ in columns]
        assert all("\u2026" in each and each.startswith("Rough") for each in titles)
        assert [each[-3:] for each in titles] == [", 0", ", 1"]
        boxes = boxes_of(figure)
        assert not any(p.overlaps(q) for (_, p), (_, q) in itertools.combinations(boxes, 2))
    figure, ((axes, *_), _) = drawn(runs, SIZES["laptop"])
    assert axes.get_title(loc="left") == runs[0].name  # there is room for it


# ---- matplotlib's settings ----


@pytest.fixture
def seen(monkeypatch):
    """Matplotlib's settings each time that something is drawn."""
    found, draw = [], over_time.dress

    def dress(*given):
        found.append(dict(matplotlib.rcParams))
        draw(*given)

    monkeypatch.setattr(over_time, "dress", dress)
    return found


def test_who_draws_leaves_matplotlibs_settings_alone(runs, seen):
    before = dict(matplotlib.rcParams)
    figure = load_rows.picture(runs, LIMITS)
    assert len(seen) == 6 and all(each == before for each in seen)
    written = io.BytesIO()
    figure.savefig = lambda *_, **__: seen.append(dict(matplotlib.rcParams))
    save(figure, written)
    assert seen.pop() == before
    save(figure, "plots.svg")
    assert seen.pop() == {**before, **SVG}
    assert dict(matplotlib.rcParams) == before


def test_sizes_are_not_those_of_matplotlibs_settings(runs):
    sizes = {t.get_fontsize() for t in _texts(runs)}
    before = matplotlib.rcParams["font.size"]
    matplotlib.rcParams["font.size"] = 30
    try:
        assert {t.get_fontsize() for t in _texts(runs)} == sizes
    finally:
        matplotlib.rcParams["font.size"] = before
    assert sizes == {load_rows.LETTERS, load_rows.LETTERS + 1}


def _texts(runs):
    figure, _ = drawn(runs, SIZES["laptop"])
    return [each for each in figure.findobj(Text) if each.get_visible() and each.get_text()]


def test_two_that_write_svg_at_once_leave_the_settings_as_they_were():
    before = dict(matplotlib.rcParams)
    begun, first_done = threading.Event(), threading.Event()

    class Figure:
        def __init__(self, during):
            self.savefig = lambda *_, **__: during()

    def second_comes():
        other.start()
        begun.wait(0.2)  # in vain where one waits for the other

    def first_goes():
        begun.set()
        first_done.wait(0.2)

    other = threading.Thread(target=save, args=(Figure(first_goes), "b.svg"))
    save(Figure(second_comes), "a.svg")
    first_done.set()
    other.join()
    assert begun.is_set() and dict(matplotlib.rcParams) == before
