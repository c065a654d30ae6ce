"""Models as triangles, for the operations that work on their surfaces from above."""

from dataclasses import dataclass

import numpy
import Part

from evenload import compiled, waiting
from evenload.geometry.items import element_of, placed
from evenload.words import listed

# Of the tolerance, by which triangles may leave the part. Finer ones make fewer lines; where a face
# is round in two directions their number grows with it, and they take their time.
SHARE, ROUND_SHARE = 0.1, 0.25
BENT_ONE_WAY = (Part.Plane, Part.Cylinder, Part.Cone, Part.SurfaceOfExtrusion)
MOST_SHARE = 0.4  # of it, that is put up with where finer triangles come out no nearer
TURN = 0.35  # rad between neighbouring triangles, at the most
UPRIGHT = 1e-6  # z of the normals of triangles that stand upright, at the most
MESH = "'%s' is a mesh without faces: make a solid of it (Part, Create Shape from Mesh) first."


@dataclass
class Triangles:
    points: object  # n x 3, mm
    numbers: object  # m x 3, of each triangle's corners
    picked: object  # m booleans: whether it belongs to the picked faces
    deflection: float  # mm by which they leave the part, measured
    names: list  # of the picked faces, as in 'Face7 of Model'
    lowest: float  # mm, of the picked faces
    highest: float  # mm, of the models


@dataclass
class Facets:
    mesh: object  # the core's FacetMesh
    deflection: float  # mm by which it leaves the part, measured
    names: list  # of the picked faces, as in 'Face7 of Model'
    lowest: float  # mm, of the picked faces
    highest: float  # mm, of the models


@dataclass(frozen=True)
class Model:
    """One model as it was read."""

    label: str
    brep: str  # OpenCASCADE's text of its shape, where it is in the world
    is_round: bool
    is_solid: bool
    names: tuple  # of its picked faces; None: whatever looks up is picked


@dataclass(frozen=True)
class Models:
    """Models and which of their faces are picked, as they were read: no document is needed from
    here on, and any thread may make triangles of them.
    """

    models: tuple

    def triangles(self, tolerance):
        """The Triangles of them, nearer than the tolerance in mm. Raises ValueError with a sentence
        that names what cannot be machined from above.
        """
        points, triangles, flags, deflection, lowest = [], [], [], 0.0, []
        for model in self.models:
            corners, numbers, faces, off = _triangles(model, tolerance)
            deflection = max(deflection, off)
            flags.append(_flags(model, faces, _normals(corners, numbers)))
            heights = corners[numbers[flags[-1]].ravel(), 2]
            lowest += [heights.min()] if len(heights) else []
            triangles.append(numbers + sum(map(len, points)))
            points.append(corners)
        points = numpy.vstack(points)
        return Triangles(
            points,
            numpy.vstack(triangles),
            numpy.hstack(flags),
            deflection,
            [_full_name(model, name) for model in self.models for name in model.names or ()],
            min(lowest, default=0.0),
            points[:, 2].max(),
        )


def read(base, models):
    """The Models of document objects, of which the faces in `base`, [(model, names of faces), ...],
    are picked; base None: whatever looks up is. Raises ValueError with a sentence.
    """
    picked = _picked(base, models) if base is not None else {}
    found = []
    for model in models:
        shape = _shape_of(model)
        names = tuple(picked.get(model, ())) if base is not None else None
        text = shape.exportBrepToString()
        found.append(Model(model.Label, text, is_round(shape), bool(shape.Solids), names))
    return Models(tuple(found))


def of(base, models, tolerance):
    """The Facets of `models`, document objects, of which the faces in `base`, [(model, names of
    faces), ...], are picked; nearer than the tolerance in mm. Raises ValueError with a sentence
    that names what cannot be machined from above.
    """
    return of_triangles(read(base, models).triangles(tolerance))


def fixtures(objects, models, tolerance):
    """(the core's FacetMesh, mm by which it leaves them, mm of their top) of document objects that
    a tool keeps off; nearer than the tolerance in mm. Raises ValueError with a sentence.
    """
    found = []
    for obj in objects:
        if obj in models:
            raise ValueError(
                "'%s' is a model of the job, which the tool keeps off anyway: take it out of "
                "Fixtures." % obj.Label
            )
        shape = placed(obj)
        if shape is None or not shape.Faces:
            raise ValueError(
                "'%s' has no faces that the tool could keep off: take it out of Fixtures."
                % obj.Label
            )
        text = shape.exportBrepToString()
        found.append(Model(obj.Label, text, is_round(shape), bool(shape.Solids), ()))
    read = Models(tuple(found)).triangles(tolerance)
    return of_triangles(read).mesh, read.deflection, read.highest


def of_triangles(found):
    """The Facets of Triangles."""
    mesh = compiled.core().surface.FacetMesh(found.points, found.numbers, found.picked)
    return Facets(mesh, found.deflection, found.names, found.lowest, found.highest)


def is_round(shape):
    """Whether a face of a shape bends in two directions, so that fine triangles are many."""
    return any(not isinstance(face.Surface, BENT_ONE_WAY) for face in shape.Faces)


def _flags(model, faces, normals):
    """Whether each triangle is picked; those of no solid may be turned either way."""
    if model.names is None:
        return (normals if model.is_solid else numpy.abs(normals)) > UPRIGHT
    wanted = [int(name[len("Face") :]) - 1 for name in model.names]
    for name, number in zip(model.names, wanted):
        _refuse_unseen(normals[faces == number], model.is_solid, _full_name(model, name))
    return numpy.isin(faces, wanted)


def _full_name(model, name):
    return "%s of %s" % (name, model.label)


def _picked(base, models):
    """{model: names of its faces}, each once."""
    result = {}
    for obj, names in base:
        for name in names or ("",):
            if not name.startswith("Face"):
                what = "%s of %s" % (name, obj.Label) if name else "'%s'" % obj.Label
                raise ValueError("%s is no face: pick the faces that are to be finished." % what)
            if obj not in models:
                raise ValueError(
                    "%s of %s is of no model of the job: pick faces of %s."
                    % (
                        name,
                        obj.Label,
                        listed(["'%s'" % m.Label for m in models], " or ", "others"),
                    )
                )
            if element_of(_shape_of(obj), name) is None:
                raise ValueError(
                    "There is no %s on %s: pick the geometry anew." % (name, obj.Label)
                )
            if name not in result.setdefault(obj, []):
                result[obj].append(name)
    if not result:
        raise ValueError("The operation has no base geometry: pick the faces to be finished.")
    return result


def _shape_of(model):
    shape = placed(model)
    if shape is None or not shape.Faces:
        raise ValueError(MESH % model.Label)
    return shape


def _triangles(model, tolerance):
    waiting.go_on()
    occt = compiled.occt()
    wished = (ROUND_SHARE if model.is_round else SHARE) * tolerance
    try:
        found = occt.triangles_from_brep(model.brep, wished, TURN, waiting.asked())
    except occt.ShapeError as error:
        raise ValueError("'%s': %s" % (model.label, error)) from None
    if found is None:
        raise waiting.Stopped()
    if found[3] > MOST_SHARE * tolerance:
        raise ValueError(
            "The triangles of '%s' leave it by %.4f mm, too much for the Tolerance of %g mm: "
            "raise it." % (model.label, found[3], tolerance)
        )
    return found


def _normals(points, triangles):
    """z of the triangles' outward normals of length 1; 0 for those without an area."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = numpy.cross(b - a, c - a)
    sizes = numpy.linalg.norm(normals, axis=1)
    return numpy.divide(normals[:, 2], sizes, out=numpy.zeros(len(sizes)), where=sizes > 0)


def _refuse_unseen(normals, is_solid, name):
    if numpy.abs(normals).max(initial=0.0) < UPRIGHT:
        raise ValueError(
            "%s stands upright: finishing comes from above; EvenLoad Adaptive cuts walls." % name
        )
    if is_solid and normals.max() < UPRIGHT:
        raise ValueError("%s looks down: pick faces that look up, or turn the model." % name)
