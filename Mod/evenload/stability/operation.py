"""The stability of a FreeCAD operation: what is read from its job, its tool and its path."""

import math

from evenload import host, machines, materials
from evenload import tool as tools
from evenload.dynamics import directions, vibration
from evenload.simulation import earlier
from evenload.simulation import job as job_simulation
from evenload.stability import cut

GROUP = "EvenLoad"
PROPERTY = "VibrationModes"
DOC = (
    "Modes of vibration at the tool's tip, for stability charts: JSON, see docs/stability_chart.md"
)


def of(operation, modes=None, material=None, machine=None, **options):
    """The Verdict on an operation; arguments as of `read`."""
    return cut.judged(read(operation, modes, material, machine, **options))


def read(
    operation,
    modes=None,
    material=None,
    machine=None,
    engagement_deg=None,
    process_damping=0.0,
    folder="",
):
    """The Cut of an operation: EvenLoad's, or any other with an end mill.

    modes: as dynamics.vibration.load takes them; None: those kept with the tool controller, else
    those of the machine. material: as materials.load; None: the operation's own, else our first.
    machine: as machines.load, for its modes and spindle speeds. engagement_deg: degrees; None: the
    operation's, else the largest that the simulator finds. process_damping: N/m. folder: of
    relative paths. Raises ValueError, in a sentence, for what cannot be used.
    """
    found = _modes(host.controller_of(operation), modes, machine, folder)
    result = read_without_modes(operation, material, machine, engagement_deg, process_damping)
    result.modes = found.modes
    result.notes[:0] = found.notes
    return result


def read_without_modes(
    operation, material=None, machine=None, engagement_deg=None, process_damping=0.0
):
    """The same with no modes yet."""
    inner = host.operation_under(operation)
    tool, data = tools.read(host.controller_of(operation))
    moves, _ = earlier.moves_of(operation)
    if len(moves) < 2:
        raise ValueError("'%s' has no path: recompute it first." % operation.Label)
    notes = []
    if tool.assumed:
        notes.append(
            "The tool '%s' does not say its %s: stability is that of %s."
            % (tool.name, " and its ".join(tool.assumed), " and ".join(tool.assumed.values()))
        )
    return cut.Cut(
        operation.Label,
        [],
        tool.teeth,
        tool.diameter,
        tool.helix_angle,
        tool.cutting_length or None,
        _engagement(operation, inner, engagement_deg),
        cut_mode_of(inner),
        materials.load(material or getattr(inner, "Material", None) or materials.names()[0]),
        data.spindle_speed,
        depth_of(inner),
        data.feed / (data.spindle_speed * tool.teeth) if data.spindle_speed > 0 else 0.0,
        directions.of_moves(moves),
        machines.spindle(machine)["speeds"] if machine is not None else (0.0, math.inf),
        process_damping,
        data.spindle == tools.REVERSE,
        notes,
    )


def cut_mode_of(operation):
    """ "climb" or "conventional"; climb where an operation does not say."""
    return str(getattr(operation, "CutMode", "Climb")).lower()


def depth_of(operation):
    """mm: how deep the deepest of an operation's levels is cut."""
    start, final = operation.StartDepth.Value, operation.FinalDepth.Value
    final += getattr(getattr(operation, "StockToLeaveAxial", None), "Value", 0.0)
    step = getattr(getattr(operation, "StepDown", None), "Value", 0.0)
    if not start > final:
        raise ValueError(
            "'%s' cuts nothing: its StartDepth does not lie above its FinalDepth." % operation.Label
        )
    if not 0 < step < start - final:
        return start - final
    levels = [start, *host.cutting_levels(start, step, final)]
    return max(above - below for above, below in zip(levels, levels[1:]))


def kept(controller):
    """The Vibration that is kept with a tool controller; None where there is none."""
    text = getattr(controller, PROPERTY, "")
    return vibration.load(text) if text.strip() else None


def keep(controller, found):
    """Keeps a Vibration with a tool controller, and in its document therefore; None: no longer."""
    if not hasattr(controller, PROPERTY):
        controller.addProperty("App::PropertyString", PROPERTY, GROUP, DOC)
    text = found.text() if found else ""
    if getattr(controller, PROPERTY) != text:
        setattr(controller, PROPERTY, text)


def _modes(controller, modes, machine, folder):
    if modes is not None:
        return vibration.load(modes, folder)
    found = kept(controller) if controller is not None else None
    if found is None and machine is not None:
        given = machines.modes(machine)
        found = vibration.load(given, folder) if given else None
    if found is None:
        raise ValueError(
            "The tool controller '%s' has no modes: give them, or load a tap test in the window"
            " Stability chart." % getattr(controller, "Label", "")
        )
    return found


def _engagement(operation, inner, given):
    if given is None and hasattr(inner, "EngagementAngle"):
        given = inner.EngagementAngle.Value
    if given is None:
        given = min(job_simulation.of(operation, step=0.5).max_engagement_deg, 180.0)
    if not 0 < given <= 180:
        raise ValueError(
            "The engagement angle of '%s' is %g°: it must lie above 0, where nothing is cut, and at"
            " most at 180°." % (operation.Label, given)
        )
    return float(given)
