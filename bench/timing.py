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


def best_times(action, repeats=5):
    """(the same, the fewest seconds that all cores worked on it, which other programs hardly
    lengthen).
    """
    works = []

    def worked():
        start = time.process_time()
        action()
        works.append(time.process_time() - start)

    return best_time(worked, repeats), min(works)
