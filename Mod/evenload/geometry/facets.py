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
class Facets:
    mesh: object  # the core's FacetMesh
    deflection: float  # mm by which it leaves the part, measured
    names: list  # of the picked faces, as in 'Face7 of Model'
    lowest: float  # mm, of the picked faces
    highest: float  # mm, of the models


def of(base, models, tolerance):
    """The Facets of `models`, document objects, of which the faces in `base`, [(model, names of
    faces), ...], are picked; nearer than the tolerance in mm. Raises ValueError with a sentence
    that names what cannot be machined from above.
    """
    picked = _picked(base, models)
    points, triangles, flags, deflection, lowest = [], [], [], 0.0, []
    for model in models:
        shape = _shape_of(model)
        corners, numbers, faces, off = _triangles(model, shape, tolerance)
        deflection = max(deflection, off)
        normals = _normals(corners, numbers)
        for name in picked.get(model, ()):
            own = faces == int(name[len("Face") :]) - 1
            _refuse_unseen(normals[own], bool(shape.Solids), "%s of %s" % (name, model.Label))
            lowest.append(corners[numbers[own].ravel(), 2].min())
        wanted = [int(name[len("Face") :]) - 1 for name in picked.get(model, ())]
        flags.append(numpy.isin(faces, wanted))
        triangles.append(numbers + sum(map(len, points)))
        points.append(corners)
    points = numpy.vstack(points)
    mesh = compiled.core().surface.FacetMesh(points, numpy.vstack(triangles), numpy.hstack(flags))
    names = ["%s of %s" % (name, model.Label) for model in picked for name in picked[model]]
    return Facets(mesh, deflection, names, min(lowest), points[:, 2].max())


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


def _triangles(model, shape, tolerance):
    waiting.go_on()
    occt = compiled.occt()
    is_round = any(not isinstance(face.Surface, BENT_ONE_WAY) for face in shape.Faces)
    wished = (ROUND_SHARE if is_round else SHARE) * tolerance
    try:
        found = occt.triangles_from_brep(shape.exportBrepToString(), wished, TURN)
    except occt.ShapeError as error:
        raise ValueError("'%s': %s" % (model.Label, error)) from None
    waiting.go_on()
    if found[3] > MOST_SHARE * tolerance:
        raise ValueError(
            "The triangles of '%s' leave it by %.4f mm, too much for the Tolerance of %g mm: "
            "raise it." % (model.Label, found[3], tolerance)
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
