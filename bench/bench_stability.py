# The stability chart of an operation in all feed directions: how soon it shows, how exact it is,
# and how soon it stops.
import threading
import time

from evenload import materials, waiting
from evenload.dynamics import Mode, directions
from evenload.stability import choice, cut, field, picture

MODES = [Mode.from_stiffness(8, 900, 0.02), Mode.from_stiffness(11, 1150, 0.018, 90)]
REPEATS = 3
STOPS = 10
LATER = 0.05  # s, from one stop to the next


def a_cut():
    return cut.Cut(
        label="two modes and a helix",
        modes=MODES,
        teeth=2,
        diameter=10.0,
        helix_angle=30.0,
        flute_length=30.0,
        engagement_deg=60.0,
        cut_mode="climb",
        material=materials.load("Al7075-T6"),
        speed=9000.0,
        depth=4.0,
        feed_per_tooth=0.05,
        directions=directions.ALL,
    )


def times_of_levels(one):
    began, times = time.perf_counter(), []
    for found in field.levels(one, *picture.box_of(one)):
        times.append(time.perf_counter() - began)
    return times, found


def figures():
    one = a_cut()
    runs = [times_of_levels(one) for _ in range(REPEATS)]
    yield "stability.chart.first_picture", min(times[0] for times, _ in runs), "s"
    yield "stability.chart.whole", min(times[-1] for times, _ in runs), "s"
    yield "stability.chart.error_of_limits", 100 * error_of_limits(one, runs[0][1]), "%"
    began = time.perf_counter()
    cut.judged(one)
    yield "stability.verdict", time.perf_counter() - began, "s"
    began = time.perf_counter()
    choice.best_of(one, *(picture.box_of(one)[0], 10.0))
    yield "stability.best", time.perf_counter() - began, "s"
    yield "stability.chart.cancel", 1e3 * max(cancelled(one, LATER * k) for k in range(STOPS)), "ms"


def error_of_limits(one, found):
    """The largest share by which limits differ from those of 180 directions."""
    errors = []
    for speed, limit in list(zip(found.speeds, found.limits()))[4::12]:
        exact = directions.limit_depth(one.milling(), speed, found.depths[-1])
        if max(exact, limit) < found.depths[-1]:
            errors.append(abs(limit / exact - 1))
    return max(errors)


def cancelled(one, after):
    """Seconds from a stop, so long after the start, until the thread has ended."""
    stop = threading.Event()

    def work():
        with waiting.asking(lambda _: not stop.is_set()):
            try:
                times_of_levels(one)
            except waiting.Stopped:
                return

    thread = threading.Thread(target=work)
    thread.start()
    thread.join(after)
    began = time.perf_counter()
    stop.set()
    thread.join()
    return time.perf_counter() - began
