"""Files of measured points, and whether they fit the faces at all."""

import dataclasses
import os
from dataclasses import dataclass

import numpy

from evenload import inspection
from evenload.inspection.points import MM_PER

DMIS = (".dmi", ".dms", ".dmis", ".dmo")  # CMM software names its files so
FARTHEST = 0.1  # share of the faces' extent, as evenload.inspection.profile has it of the points'
ON_EDGE = 1e-9  # of that extent: what is as near to one face as to another belongs to both


@dataclass(frozen=True)
class MeasuredPoints:
    """names: of the points; points: n x 3, of contact."""

    names: list
    points: numpy.ndarray


def read_points(path, probe_radius=0.0):
    """The MeasuredPoints of a file, CSV or DMIS, in mm.

    probe_radius: mm; of a file that holds centres of the probe's ball, which is taken off along the
    file's own normals; 0 for points of contact. Raises ValueError, in a sentence, for a file that
    cannot be read; evenload.inspection.tables has what else is refused.
    """
    extension = os.path.splitext(path)[1].lower()
    try:
        if extension == ".csv":
            points, normals = inspection.read_csv(path)
            names = ["%d" % (number + 1) for number in range(len(points))]
        elif extension in DMIS:
            found = inspection.read_dmis(path)
            names = list(found)
            points = numpy.array([point for point, _ in found.values()])
            normals = numpy.array([normal for _, normal in found.values()])
        else:
            raise ValueError(
                "The name of a file of points ends in .csv or %s, not as %s."
                % (", ".join(DMIS), os.path.basename(path))
            )
    except OSError as error:
        raise ValueError("%s cannot be read: %s." % (path, error.strerror or error)) from None
    except UnicodeDecodeError:
        raise ValueError("%s is no text: export the points as CSV or DMIS." % path) from None
    if not len(points):
        raise ValueError("%s has no points: measure some." % path)
    return MeasuredPoints(names, inspection.compensated(points, normals, probe_radius))


def of_faces(faces, part, measured):
    """(MeasuredPoints, how many are left out): those that no other face of the objects is nearer
    to than the picked ones. part: of these, a FacesPart. Raises ValueError, in a sentence, where
    none is.
    """
    others = [
        face for face in faces.whole.Faces if not any(face.isSame(mine) for mine in faces.faces)
    ]
    if not others:
        return measured, 0
    of_others = type(part)(dataclasses.replace(faces, faces=others))
    slack = ON_EDGE * faces.size()
    is_mine = part.distances(measured.points) <= of_others.distances(measured.points) + slack
    if not is_mine.any():
        raise ValueError("All points are nearer to other faces: pick those that were measured.")
    names = [name for name, mine in zip(measured.names, is_mine) if mine]
    return MeasuredPoints(names, measured.points[is_mine]), int((~is_mine).sum())


def check_nearness(faces, part, measured):
    """Raises ValueError, in a sentence, for points too far from the faces to be of them."""
    limit = FARTHEST * faces.size()
    distances = part.distances(measured.points)
    worst = int(numpy.argmax(distances))
    if distances[worst] <= limit:
        return
    if (distances > limit).mean() > 0.5:
        for factor, words in ((MM_PER["inch"], "inch"), (1 / MM_PER["inch"], "mm")):
            if type(part)(faces).distances(factor * measured.points).max() <= limit:
                raise ValueError(
                    "The points fit the faces only if their numbers are %s: correct the unit that "
                    "the file states." % words
                )
    raise ValueError(
        "Point %s lies %.3g mm from the faces: pick the faces that were measured, align the points "
        "with the model, or leave it out." % (measured.names[worst], distances[worst])
    )
