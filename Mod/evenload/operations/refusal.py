"""What an operation raises when it makes no path, in words that the user can act upon."""

import sys


class Refusal(ValueError):
    """Out of an operation's `execute` it appears in FreeCAD's report view as its one sentence.

    FreeCAD prints every error's traceback, which helps whoever mends a program and hides the
    sentence from whoever mends a job. It takes the text, then the traceback, then lets go of the
    error: from its making until then Python is asked to print no tracebacks. Several, which may go
    in any order, are counted.
    """

    __module__ = "EvenLoad"  # FreeCAD prints it before the sentence
    _alive = 0
    _before = None  # Python's limit before the first of those that are alive

    def __init__(self, sentence):
        super().__init__(sentence)
        if not Refusal._alive:
            Refusal._before = getattr(sys, "tracebacklimit", None)
        Refusal._alive += 1
        sys.tracebacklimit = 0

    def __del__(self):
        Refusal._alive -= 1
        if Refusal._alive:
            return
        if Refusal._before is not None:
            sys.tracebacklimit = Refusal._before
        elif hasattr(sys, "tracebacklimit"):
            del sys.tracebacklimit


class Cancelled(ValueError):
    """The user has stopped the computation."""

    def __init__(self, uncut_area):
        super().__init__(
            "Cancelled before everything was cut: there is no path until it is computed again."
        )
        self.uncut_area = uncut_area  # mm2
