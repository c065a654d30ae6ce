"""What can be picked for an operation in FreeCAD's window."""

import FreeCADGui
import Part

LEVEL = 1e-6  # z of a direction that lies in the plane


class Gate:
    """What can be selected while a panel is open: level faces, edges, sketches."""

    def allow(self, doc, obj, sub):
        shape = getattr(obj, "Shape", None)
        if shape is None or shape.isNull():
            return False
        if is_outline(obj) or sub.startswith("Edge"):
            return True
        if not sub.startswith("Face"):
            return False
        box = shape.getElement(sub).BoundBox
        return box.ZLength < 1e-6


class SurfaceGate:
    """What can be selected while a panel for surfaces is open: faces that do not stand upright,
    edges and sketches as guides, and whole objects with faces as fixtures.
    """

    def allow(self, doc, obj, sub):
        shape = getattr(obj, "Shape", None)
        if shape is None or shape.isNull():
            return False
        if is_outline(obj) or sub.startswith("Edge"):
            return True
        if not sub:
            return bool(shape.Faces)
        return sub.startswith("Face") and not _is_wall(shape.getElement(sub))


def _is_wall(face):
    return isinstance(face.Surface, Part.Plane) and abs(face.Surface.Axis.z) < LEVEL


def is_outline(obj):
    """Whether an object is base geometry as a whole: a sketch, or wires without a solid."""
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        return False
    return obj.isDerivedFrom("Sketcher::SketchObject") or not (shape.Solids or shape.Shells)


def select():
    """FreeCAD calls this when a panel opens; it removes the gate itself."""
    FreeCADGui.Selection.addSelectionGate(Gate())


def select_surfaces():
    """The same for a panel of an operation on surfaces."""
    FreeCADGui.Selection.addSelectionGate(SurfaceGate())
