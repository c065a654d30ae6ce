"""What takes long lets go of Python's lock, so that the window lives meanwhile."""

import sys
import threading

import numpy
import pytest
from evenload import compiled

pytestmark = pytest.mark.core

SIDES = 500  # of the squares that are built of
TRIES = 50  # builds within which another thread gets its turn


@pytest.fixture
def patient():
    """Python takes its lock from no thread; each goes on until it waits, or lets go of it."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e6)
    yield
    sys.setswitchinterval(before)


def squares():
    """(points, triangles, what is picked) of a level sheet, as arrays that numpy need not convert,
    within which it would let go of the lock.
    """
    x, y = numpy.meshgrid(numpy.arange(SIDES + 1.0), numpy.arange(SIDES + 1.0))
    points = numpy.column_stack([x.ravel(), y.ravel(), numpy.zeros(x.size)])
    first = (numpy.arange(SIDES)[:, None] * (SIDES + 1) + numpy.arange(SIDES)).ravel()
    above = first + SIDES + 1
    halves = [(first, first + 1, above + 1), (first, above + 1, above)]
    triangles = numpy.vstack([numpy.column_stack(half) for half in halves]).astype(numpy.uint32)
    return points, triangles, numpy.ones(len(triangles), bool)


def height_map(points, triangles, _):
    return compiled.core().HeightMap(points, triangles)


def facet_mesh(points, triangles, picked):
    return compiled.core().surface.FacetMesh(points, triangles, picked)


def goes_on_during(work):
    """Whether another thread gets its turn while this one works, and never else."""
    begun, went_on = threading.Event(), []

    def other():
        begun.wait()
        went_on.append(True)

    thread = threading.Thread(target=other)
    thread.start()
    begun.set()
    for _ in range(TRIES):
        work()
        if went_on:
            break
    is_seen = bool(went_on)
    thread.join()
    return is_seen


@pytest.mark.parametrize("build", [height_map, facet_mesh])
def test_other_threads_go_on_while_triangles_are_sorted(patient, build):
    sheet = squares()
    assert goes_on_during(lambda: build(*sheet))


def test_no_other_thread_goes_on_where_the_lock_is_kept(patient):
    assert not goes_on_during(lambda: sum(range(10_000)))
