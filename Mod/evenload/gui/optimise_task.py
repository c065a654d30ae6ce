"""What the dock Optimise computes, and what it follows."""

from evenload import waiting
from evenload.gui.observer import Observer
from evenload.gui.simulation_task import goes_on
from evenload.suggestion import search

NOW = 0.15  # of the progress: for the figures of what is set now


class Edited(Observer):
    """Tells of each change, whether it is computed or not."""

    def slotChangedObject(self, obj, prop):
        if prop in self._properties and self._is_one(obj):
            self._changed(False)

    def slotDeletedObject(self, obj):
        super().slotDeletedObject(obj)
        if self._is_stale:
            self._is_stale = False
            self._changed(False)

    def slotRecomputedDocument(self, doc):
        """Changes are told already."""


def computed(cut, asked, done):
    """The task for the thread: yields the Candidate of what is set now, or None, and the
    Optimisation. done: called with the share that is done.
    """

    def going(share):
        done(share)
        return goes_on(share)

    now = search.now(cut, asked, lambda share: going(NOW * share))
    waiting.go_on(NOW)
    yield now
    found = search.suggested(cut, asked, lambda share: going(NOW + (1 - NOW) * share))
    if found.cancelled:
        raise waiting.Stopped()
    yield found
