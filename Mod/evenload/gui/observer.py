"""What a view is told of the objects that it shows."""

from evenload import host
from evenload.simulation import earlier

EVERY_ONES = ("", "Base")  # groups of the properties that all document objects have


class Observer:
    """Tells of changes to objects of one document, after a recompute or undo, and of their end; of
    new labels at once, for FreeCAD recomputes nothing then.
    """

    def __init__(self, objects, properties, changed, used=(), groups=(), renamed=None):
        """properties: names of those that count; changed: called with whether an object is no
        longer there. used: further objects, such as tool bits, whose end is only a change; groups:
        those of which counts what they hold; renamed: called when one of the objects is.
        """
        self._names = {obj.Name for obj in objects}
        self._used = {obj.Name for obj in used}
        self._groups = {obj.Name for obj in groups}
        self._document = objects[0].Document.Name
        self._properties, self._changed, self._renamed = properties, changed, renamed
        self._is_stale = False

    def _is_one(self, obj):
        return obj.Name in self._names | self._used and obj.Document.Name == self._document

    def is_of(self, *objects):
        """Whether it is these objects that it tells of, used ones among them."""
        return {obj.Name for obj in objects if obj is not None} == self._names | self._used

    def slotChangedObject(self, obj, prop):
        if prop in self._properties and self._is_one(obj):
            self._is_stale = True
        elif prop == "Label" and self._renamed and obj.Name in self._names and self._is_one(obj):
            self._renamed()
        elif prop == "Group" and obj.Name in self._groups and obj.Document.Name == self._document:
            self._is_stale = True

    def slotRecomputedDocument(self, doc):
        if self._is_stale and doc.Name == self._document:
            self._is_stale = False
            self._changed(False)

    # Undo brings a path back without a recompute.
    slotUndoDocument = slotRedoDocument = slotRecomputedDocument

    def slotDeletedObject(self, obj):
        if not self._is_one(obj):
            return
        if obj.Name in self._names:
            self._changed(True)
        else:
            self._is_stale = True

    def slotDeletedDocument(self, doc):
        if doc.Name == self._document:
            self._changed(True)


def observer_of_paths(operations, changed, renamed=None):
    """An Observer of the paths of operations, and of what cuts before them in their jobs. Without
    `renamed` a new label is a change like others.
    """
    before = [each for operation in operations for each in earlier.all_before(operation)]
    jobs = filter(None, map(host.parent_job, operations))
    groups = [job.Operations for job in jobs]
    properties = ("Path", "Active", *(() if renamed else ("Label",)))
    return Observer(operations, properties, changed, before, groups, renamed)


def bits_of(controllers):
    """The tool bits of tool controllers, of those that have one."""
    return [each.Tool for each in controllers if each.Tool is not None]


def own_properties(objects):
    """The names of properties that not every document object has, such as a tool bit's lengths."""
    return {
        name
        for obj in objects
        for name in obj.PropertiesList
        if obj.getGroupOfProperty(name) not in EVERY_ONES
    }
