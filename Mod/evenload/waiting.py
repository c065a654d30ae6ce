"""Whoever waits for a computation is asked, while it lasts, whether it shall go on.

What takes long calls `go_on` every some hundredths of a second, and need not know who waits.
"""

import contextlib
import contextvars

_asked = contextvars.ContextVar("asked", default=None)


class Stopped(Exception):
    """Whoever was asked whether to go on does not want to."""


@contextlib.contextmanager
def asking(watch):
    """While this lasts `go_on` asks watch(share done, 0 to 1); None: nobody is asked."""
    before = _asked.set(watch)
    try:
        yield
    finally:
        _asked.reset(before)


def asked():
    """Who is asked now, watch(share) -> whether to go on, for what asks by itself; None: nobody."""
    return _asked.get()


def go_on(share=0.0):
    """Raises Stopped where the computation shall not go on. share: what is done, where known."""
    watch = _asked.get()
    if watch is not None and not watch(share):
        raise Stopped()


def answer(share):
    """The same for the core, which wants an answer: True, or Stopped on its way through it."""
    go_on(share)
    return True
