"""The datum plane of a profile: a plane face, or a datum plane of the document."""

import FreeCAD

from evenload.face_inspection.faces import picked
from evenload.geometry.items import element_of, placed

PLANES = ("App::Plane", "PartDesign::Plane")  # without faces of their own, in the world's z = 0


def datum_of(faces):
    """(point, normal) of the datum plane that PickedFaces are. Raises ValueError for what is no
    single plane.
    """
    if len(faces.faces) != 1 or not faces.faces[0].Surface.isPlanar():
        raise ValueError("The datum is one plane face, not %s." % faces.name)
    face = faces.faces[0]
    return tuple(face.CenterOfMass), tuple(
        face.normalAt(*face.Surface.parameter(face.CenterOfMass))
    )


def datum_at(obj, element):
    """(point, normal) of a face of a document object, by its name, or of a datum plane, whatever
    its element is called. Raises ValueError for what is no plane.
    """
    if not is_plane(obj):
        return datum_of(picked([(obj, [element])]))
    placement = obj.getGlobalPlacement()
    normal = placement.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
    return tuple(placement.Base), tuple(normal)


def is_plane(obj):
    """Whether a document object is a datum plane."""
    return any(obj.isDerivedFrom(kind) for kind in PLANES)


def plane_faces(base):
    """[(object, name), ...] of the plane faces in [(document object, names of faces), ...]."""
    found = []
    for obj, names in base:
        shape = placed(obj)
        found += [(obj, name) for name in names if element_of(shape, name).Surface.isPlanar()]
    return found
