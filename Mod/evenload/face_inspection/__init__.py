"""Inspection on the faces of a model: where to measure, and what measured points say of the faces.

`evenload.inspection` has all that needs no faces. Beside what stands here there are `picture` and
`html_report`, which need matplotlib, and `probing_program`. Lengths in mm, angles in degrees.
docs/inspection.md has methods and limits.
"""

from evenload.face_inspection.datum import datum_at, datum_of, plane_faces
from evenload.face_inspection.evaluation import Evaluation, evaluate
from evenload.face_inspection.faces import PickedFaces, picked
from evenload.face_inspection.measured import MeasuredPoints, read_points
from evenload.face_inspection.nearest import FacesPart
from evenload.face_inspection.patterns import Samples, sample
from evenload.face_inspection.round_face import RoundFace, round_face

__all__ = [
    "Evaluation",
    "FacesPart",
    "MeasuredPoints",
    "PickedFaces",
    "RoundFace",
    "Samples",
    "datum_at",
    "datum_of",
    "evaluate",
    "picked",
    "plane_faces",
    "read_points",
    "round_face",
    "sample",
]
