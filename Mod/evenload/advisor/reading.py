"""What the advisor needs of the document: an operation that finishes faces, or faces of a job."""

import math
from dataclasses import dataclass
from functools import cached_property
from types import SimpleNamespace

import FreeCAD

from evenload import face_inspection, host, machines, materials
from evenload import tool as tools
from evenload.ball_end.loads import Cutting
from evenload.geometry import facets
from evenload.operations import chip_control, compute, finishing
from evenload.operations.seen import Seen, settings_of
from evenload.settings.setting import CHOICE, LENGTH, SPEED
from evenload.settings.table import FINISHING

STOCK = 0.3  # mm that stand above the surface: the source's allowance [Varga 2023, table 3]
STEPOVER, CUSP_HEIGHT = "Stepover", "CuspHeight"
SAME = 1e-9  # mm
SECONDS_PER_MINUTE = 60.0


@dataclass(frozen=True)
class Question:
    """What is asked, as it was read: no document is needed from here on."""

    models: object  # facets.Models
    faces: object  # face_inspection.FacesPart: the same faces, exact
    settings: object  # by their names, as operations.finishing has them
    tool: object  # tool.Tool
    data: object  # tool.CuttingData
    cutting: object  # loads.Cutting
    machine: object  # a profile as machines.load has it, or None

    @cached_property
    def facets(self):
        """The facets.Facets to the settings' tolerance, made where they are first asked for, in any
        thread. Raises ValueError with a sentence.
        """
        return facets.of_triangles(self.models.triangles(self.settings.Tolerance.Value))


def read(owner, faces=None, controller=None, stock=STOCK, material=None, machine=None, **settings):
    """The Question of an operation EvenLoad Finishing, or of faces of a job's models.

    owner: the operation, or the job, then with faces: [(object, names of its faces), ...].
    controller: the tool controller, None: the operation's own, or the job's first. stock: mm that
    the cut before has left above the surface that is made, across it. material, machine: as
    materials.load and machines.load take them; no material: the first of ours; no machine: no
    machine's times. settings: of the operation, by its properties' names, in mm; those that are
    not given are the operation's own, or its defaults. Raises ValueError with a sentence.
    """
    if not (math.isfinite(stock) and stock > 0):
        raise ValueError("The stock on the faces is %g mm: it must be more than 0." % stock)
    is_operation = faces is None
    job = host.parent_job(owner) if is_operation else owner
    if job is None:
        raise ValueError("'%s' belongs to no job: put it into one." % owner.Label)
    controller = controller or (owner.ToolController if is_operation else _first_controller(job))
    tool, data = tools.read(controller, takes_balls=True)
    _check_ball(tool, stock)
    _check_speed(controller, data)
    if is_operation:
        compute.refuse_turned_work_plane(owner)
        found = settings_of(Seen(owner), FINISHING)
        faces = owner.Base
    else:
        found = _defaults(job, controller)
    _set(found, settings, tool.diameter / 2)
    finishing.check(found, tool)
    chip_control.check(found, tool, data)
    base = finishing.faces_of(finishing.of_models(job, faces))
    models = facets.read(base, job.Model.Group)
    picked = face_inspection.picked(base)
    row = materials.load(materials.names()[0] if material is None else material)
    return Question(
        models,
        face_inspection.FacesPart(picked),
        found,
        tool,
        data,
        Cutting(tool.diameter, tool.teeth, data.spindle_speed, float(stock), row),
        None if machine is None else machines.load(machine),
    )


def _first_controller(job):
    return next(iter(job.Tools.Group), None)


def _check_ball(tool, stock):
    if tool.end_radius < tool.diameter / 2 - SAME:
        raise ValueError(
            "The tool '%s' has no ball end, and the advisor's chips are those of a ball: choose a "
            "ball end mill." % tool.name
        )
    if stock >= tool.diameter / 2:
        raise ValueError(
            "The stock on the faces is %g mm, and the ball's radius %g mm: more than the ball can "
            "take; rough the part first." % (stock, tool.diameter / 2)
        )


def _check_speed(controller, data):
    if not data.spindle_speed > 0:
        raise ValueError(
            "The tool controller '%s' has no spindle speed, and without it there is no feed per "
            "tooth: set it." % controller.Label
        )


def _set(found, settings, radius):
    """Sets what is asked for; stepover and cusp height follow each other as in the operation."""
    rows = {row.name: row for row in FINISHING}
    for name, value in settings.items():
        if name not in rows:
            raise ValueError(
                "The finishing operation has no '%s': it has %s." % (name, ", ".join(rows))
            )
        setattr(found, name, _as_property(rows[name], value))
    if STEPOVER in settings and CUSP_HEIGHT not in settings:
        stepover = min(found.Stepover.Value, 2 * radius)
        found.CuspHeight = _length(finishing.cusp_height_of(stepover, radius))
    elif CUSP_HEIGHT in settings and STEPOVER not in settings:
        height = min(max(found.CuspHeight.Value, 0.0), radius)
        found.Stepover = _length(finishing.stepover_of(height, radius))


def _defaults(job, controller):
    """The settings and heights of a new operation of a job, without one."""
    found = SimpleNamespace(OwnValues=[])
    diameter = tools.diameter(controller)
    for row in FINISHING:
        value = row.value[0] if row.type == CHOICE else row.value
        if row.follows:
            value = row.follows(diameter, controller.HorizFeed.Value, controller.HorizRapid.Value)
        setattr(found, row.name, _length(value or 0.0) if row.type == LENGTH else value)
    found.CuspHeight = _length(finishing.cusp_height_of(found.Stepover.Value, diameter / 2))
    boxes = [model.Shape.BoundBox for model in job.Model.Group if not model.Shape.isNull()]
    if not boxes:
        raise ValueError("The job '%s' has no model with a shape: give it one." % job.Label)
    top = max([job.Stock.Shape.BoundBox.ZMax, *(box.ZMax for box in boxes)])
    sheet = job.SetupSheet
    found.StartDepth, found.FinalDepth = _length(top), _length(min(box.ZMin for box in boxes))
    found.SafeHeight = _length(top + sheet.SafeHeightOffset.Value)
    found.ClearanceHeight = _length(top + sheet.ClearanceHeightOffset.Value)
    return found


def _as_property(row, value):
    """A value in mm or mm/min as FreeCAD has it of an operation."""
    if row.type == LENGTH:
        return _length(value)
    return value / SECONDS_PER_MINUTE if row.type == SPEED else value


def _length(value):
    return FreeCAD.Units.Quantity(value, FreeCAD.Units.Length)
