# How long something takes, on as many cores as it uses: the best of a few calls, since what other
# programs do meanwhile only adds to it.
import time


def best_time(action, repeats=5):
    """The fewest seconds that a call took."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)
