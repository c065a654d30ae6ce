"""What is selected for the dock Inspect, and what planes are called in it."""

import FreeCAD
import FreeCADGui

from evenload.face_inspection.datum import is_plane
from evenload.settings.sentences import shown_name
from evenload.words import name_of

_translate = FreeCAD.Qt.translate


def selected_faces(document):
    """[(object, names of its faces), ...] of what is selected in a document."""
    found = []
    for selected in FreeCADGui.Selection.getSelectionEx(document):
        names = [name for name in selected.SubElementNames if name.startswith("Face")]
        if names and not is_plane(selected.Object):
            found.append((selected.Object, names))
    return found


def selected_plane(document):
    """(object, name of its face) of the plane that is selected in a document; a datum plane has no
    such name. Raises ValueError, in a sentence, where that is not one.
    """
    found = [(obj, name) for obj, names in selected_faces(document) for name in names]
    for selected in FreeCADGui.Selection.getSelectionEx(document):
        if is_plane(selected.Object):
            found.append((selected.Object, ""))
    if len(found) != 1:
        raise ValueError(
            _translate("EvenLoad", "The datum is one plane: select a plane face or a datum plane.")
        )
    return found[0]


def key_of(obj, element):
    """Under which a plane is listed; object_of() finds it again."""
    return "%s.%s" % (obj.Name, element)


def plane_at(document, key):
    """(object, name of its face) of a plane that is listed. Raises ValueError, in a sentence, where
    the object is no longer there.
    """
    name, element = key.split(".", 1)
    obj = document.getObject(name)
    if obj is None:
        raise ValueError(
            _translate("EvenLoad", "The datum is no longer there: choose another one.")
        )
    return obj, element


def told(obj, element):
    """Such as 'Face7 of Model', or 'Plane'."""
    return shown_name(name_of([(obj.Label, element)]))
