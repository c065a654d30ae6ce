"""What a view is told of the objects that it shows."""


class Observer:
    """Tells of changes to objects of one document, after the recompute, and of their end."""

    def __init__(self, objects, properties, changed):
        """properties: names of those that count; changed: called with whether an object is no
        longer there.
        """
        self._names = {obj.Name for obj in objects}
        self._document = objects[0].Document.Name
        self._properties, self._changed = properties, changed
        self._is_stale = False

    def _is_one(self, obj):
        return obj.Name in self._names and obj.Document.Name == self._document

    def slotChangedObject(self, obj, prop):
        if prop in self._properties and self._is_one(obj):
            self._is_stale = True

    def slotRecomputedDocument(self, doc):
        if self._is_stale and doc.Name == self._document:
            self._is_stale = False
            self._changed(False)

    def slotDeletedObject(self, obj):
        if self._is_one(obj):
            self._changed(True)

    def slotDeletedDocument(self, doc):
        if doc.Name == self._document:
            self._changed(True)
