# How long something takes that runs on one core: what other programs do meanwhile does not count.
import time


def best_time(action, repeats=5):
    """The fewest seconds of the processor that a call took."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return min(times)
