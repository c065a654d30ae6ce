"""FreeCAD's dressups of our operations: none keeps a path that leaves for the horizon.

FreeCAD's dogbones lengthen without bound where a path turns back on itself, as a ramp does:
docs/dressups.md has the dressups that work.
"""

import FreeCAD
import Path

from evenload import host, units

FARTHEST = 10_000.0  # mm beyond the stock: no machine for which these paths are made goes there


def empty_far_ones(doc, is_ours):
    """Empties the path of each dressup in a document that goes more than FARTHEST beyond the job's
    stock, and says so in the report view. is_ours: callable(operation) -> whether it is to be
    watched.
    """
    for obj in doc.Objects:
        operation = host.operation_under(obj)
        if operation is obj or not is_ours(operation):
            continue
        job = host.parent_job(operation)
        if job is None or job.Stock is None or job.Stock.Shape.isNull():
            continue
        beyond = _beyond(obj.Path.Commands, job.Stock.Shape.BoundBox)
        if beyond > FARTHEST:
            obj.Path = Path.Path()
            obj.touch()  # it is out of date also where the document is saved now and opened again
            FreeCAD.Console.PrintError(_sentence(obj, operation) + "\n")


def _beyond(commands, box):
    """mm by which the farthest end of a move lies beyond a box."""
    sides = {
        "X": (box.XMin, box.XMax),
        "Y": (box.YMin, box.YMax),
        "Z": (box.ZMin, box.ZMax),
    }
    return max(
        (
            max(sides[axis][0] - value, value - sides[axis][1])
            for command in commands
            for axis, value in command.Parameters.items()
            if axis in sides
        ),
        default=0.0,
    )


def _sentence(dressup, operation):
    told = FreeCAD.Qt.translate(
        "EvenLoad",
        "'%s' would send the tool more than 10 m beyond the stock, and its path was emptied: it "
        "does not suit '%s'.",
    )
    return units.in_users_unit(told % (dressup.Label, operation.Label))
